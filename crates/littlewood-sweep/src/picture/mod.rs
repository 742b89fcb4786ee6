//! A map as a picture: two axes, a colour for every point, a legend.

mod cells;
mod error;
mod frame;
mod map;
mod names;
mod pen;
mod render;
mod scale;

pub use error::PictureError;
pub use frame::PictureSize;
pub use map::{Picture, Shade};
