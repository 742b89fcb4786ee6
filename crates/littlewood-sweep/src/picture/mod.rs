//! A map as a picture: two axes, a colour for every point, a legend.

mod cells;
mod curves;
mod drawing;
mod error;
mod frame;
mod layout;
mod letters;
mod map;
mod names;
mod pen;
mod refine;
mod render;
mod scale;
mod shade;

pub use drawing::{Area, Drawing, Entry, Image};
pub use error::PictureError;
pub use frame::PictureSize;
pub use map::Picture;
pub use shade::Shade;
