//! The core of `littlewood` for the browser.
//!
//! A thin boundary: numbers cross it as `Float64Array`s, so that not a bit is lost on the way, and
//! texts as the command line writes them. [`Motion`] is a simulated motion, [`Routh`] the diagram
//! of an impact, [`Moves`] what moves an event, [`Prediction`] a landing predicted from another
//! motion, [`Plane`] the (θ, θ′) plane with its curves, [`OutcomeMap`] what becomes of every start
//! of that plane, [`Problem`] a hoop and a start in either system of units. A value that has no
//! physical meaning is a [`Refusal`], which names the quantity.
//!
//! Names, labels, units, codes and colours do not cross it: the page has them in files that are
//! generated from the tables of the core and of `littlewood-style` (`tests/generated`), and
//! [`boundary`] lets it check that both are of one version.

mod boundary;
mod cases;
mod digest;
pub mod hops;
mod link;
mod map;
mod motion;
mod moves;
mod panic;
mod partials;
mod plane;
mod prediction;
mod problem;
mod refusal;
mod routh;
mod ticks;

pub use boundary::boundary;
pub use cases::cases;
pub use digest::digest_line;
pub use link::{read_link, read_number, write_link};
pub use map::{MapSubject, OutcomeMap, class_of};
pub use motion::Motion;
pub use moves::Moves;
pub use panic::{begin, provoke_panic};
pub use plane::Plane;
pub use prediction::{Ghost, Prediction};
pub use problem::{Problem, dimensionless_quantities, si_quantities};
pub use refusal::Refusal;
pub use routh::Routh;
pub use ticks::Ticks;
