//! Drawing: the panels by the plotting library, the letters and the file by our backend of it.

mod canvas;
mod chart;
mod face;
mod library;
mod marks;
mod markup;
mod raster;
mod ruler;

pub(crate) use chart::ROOM;
#[cfg(test)]
pub(crate) use face::missing;
pub use markup::{markdown, plain};
pub use raster::{LEAST_SCALE, MOST_SCALE};
