//! Drawing: the panels by the plotting library, the letters and the files by us.

mod canvas;
mod chart;
mod eps;
mod face;
mod item;
mod letters;
mod library;
mod marks;
mod markup;
mod pdf;
mod pencil;
mod raster;
mod ruler;
mod svg;

pub(crate) use chart::ROOM;
#[cfg(test)]
pub(crate) use letters::missing;
pub(crate) use letters::width;
pub(crate) use markup::{Script, runs};
pub use markup::{markdown, plain};
pub use raster::{LEAST_SCALE, MOST_SCALE};
pub use svg::Letters;
