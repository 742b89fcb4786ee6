//! A map as a picture: two axes, a colour for every point, a legend.

mod cells;
mod curves;
mod error;
mod figure;
mod follow;
mod image;
mod legend;
mod map;
mod names;
mod scale;
mod shade;

pub use error::PictureError;
pub use map::{Picture, PictureSize};
pub use shade::Shade;
