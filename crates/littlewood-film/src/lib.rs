//! Films of Littlewood's hoop, from the exact motion.
//!
//! A [`Film`] shows a [`Trajectory`](littlewood::Trajectory): the hoop with its particle, the
//! contact point and the gap, normal force, friction and slip velocity, the trails of the mass
//! centre and of the centre C, the mode and the clock. Frames are drawn one by one and handed to an
//! [`Encoder`]: [`GifFilm`] needs no other program and writes to any [`std::io::Write`],
//! [`FfmpegFilm`] needs ffmpeg.
//!
//! ```
//! use littlewood::cases::find_case;
//! use littlewood_film::{Film, FrameSize, Framing, GifFilm, Pace};
//!
//! let motion = find_case("figure-3").expect("a named case").simulate()?;
//! let pace = Pace { fps: 5, slow: 1.0, units: None, hold_s: None };
//! let film = Film::new(&motion, &pace, FrameSize::new(320, 180)?, Framing::Auto)?;
//! let mut gif = GifFilm::new(Vec::new(), &film)?;
//! film.play(&mut gif, |_frames_done| true)?;
//! assert!(gif.finish()?.starts_with(b"GIF89a"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is drawn
//!
//! One scale for both directions; where the hoop would be small the camera goes with it, and the
//! whole path is shown in small. Arrows are proportional to what they show, with one scale for N
//! and F and one for η′, chosen for the motion ([`ArrowScale`]); an arrow that would be longer than
//! 1.7 R is cut and has two heads. The slip velocity is drawn below the plane, where F does not
//! cover it. In flight the lowest point is joined to the plane, and there are no forces. Where the
//! particle of a massless hoop reaches θ = ±π, θ′ (and, with the particle inside the rim, η′) is
//! infinite: the body is drawn at its place, which is finite, and the value is given as ∞ without
//! an arrow's end. The last frame is the end of the motion itself, to the last bit.
//!
//! # The same bytes everywhere
//!
//! The motion is the same on every platform, sines come from `libm`, the fonts and the colours of a
//! GIF are fixed, and shapes are opaque, straight, circular or quadratic: of the rasteriser only
//! operations are used whose results do not depend on the processor, with its vector code or
//! without.

mod body;
mod camera;
mod canvas;
mod colour;
mod encoder;
mod error;
mod ffmpeg;
mod film;
mod gif;
mod ground;
mod impacts;
mod inset;
mod letters;
mod pane;
mod panel;
mod quantise;
mod scene;
mod schedule;
mod size;
mod trail;

pub use camera::Framing;
pub use encoder::Encoder;
pub use error::FilmError;
pub use ffmpeg::{FfmpegFilm, Video};
pub use film::Film;
pub use gif::GifFilm;
pub use pane::With;
pub use scene::{ArrowScale, Direction, DrawnArrow, DrawnImpulse, Scene};
pub use schedule::{Pace, Part, Schedule, Shown};
pub use size::{FrameSize, SizeError};
