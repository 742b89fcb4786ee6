//! Films of Littlewood's hoop.

mod apng;
mod body;
mod camera;
mod canvas;
mod encoder;
mod error;
mod film;
mod gif;
mod ground;
mod letters;
mod mp4;
mod palette;
mod panel;
mod quantise;
mod scene;
mod schedule;
mod size;
mod trail;

pub use apng::ApngFilm;
pub use camera::Framing;
pub use encoder::Encoder;
pub use error::FilmError;
pub use film::Film;
pub use gif::GifFilm;
pub use mp4::Mp4Film;
pub use scene::{Arrow, Scale, Scene};
pub use schedule::{Pace, Schedule, Shown};
pub use size::Size;
