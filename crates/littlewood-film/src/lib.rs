//! Films of Littlewood's hoop.

mod body;
mod camera;
mod canvas;
mod encoder;
mod error;
mod film;
mod gif;
mod ground;
mod letters;
mod palette;
mod panel;
mod quantise;
mod scene;
mod schedule;
mod size;
mod trail;

pub use camera::Framing;
pub use encoder::Encoder;
pub use error::FilmError;
pub use film::Film;
pub use gif::GifFilm;
pub use scene::{Arrow, Scene};
pub use schedule::{Pace, Schedule, Shown};
pub use size::Size;
