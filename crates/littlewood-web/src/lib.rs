//! The core of `littlewood` for the browser.
//!
//! A thin boundary: numbers cross it as `Float64Array`s, so that not a bit is lost on the way, and
//! texts as the command line writes them. [`Problem`] is a hoop and a start in either system of
//! units. A value that has no physical meaning is a [`Refusal`], which names the quantity.
//!
//! It is built twice, as two modules. The feature `first` has what the first picture of a page
//! needs: [`Motion`], a simulated motion, [`Routh`], the diagram of an impact, and [`Plane`], the
//! phase plane with its curves. The feature `later` has the other classes: [`OutcomeMap`], the
//! outcome of every start of that plane, [`Moves`], the derivatives of an event, and [`Prediction`],
//! a landing predicted from another motion.
//!
//! Names, labels, units, codes and colours do not cross it: the page has them in files that are
//! generated from the tables of the core and of `littlewood-style` (`tests/generated`), and
//! [`boundary`] lets it check that both are of one version.

mod hops;
mod panic;
mod problem;
mod refusal;

#[cfg(feature = "first")]
mod boundary;
#[cfg(feature = "first")]
mod cases;
#[cfg(feature = "first")]
mod class;
#[cfg(feature = "first")]
mod link;
#[cfg(feature = "first")]
mod motion;
#[cfg(feature = "first")]
mod plane;
#[cfg(feature = "first")]
mod routh;
#[cfg(feature = "first")]
mod ticks;

#[cfg(feature = "later")]
mod digest;
#[cfg(feature = "later")]
mod map;
#[cfg(feature = "later")]
mod moves;
#[cfg(feature = "later")]
mod partials;
#[cfg(feature = "later")]
mod prediction;

pub use panic::begin;
pub use problem::{Problem, dimensionless_quantities, si_quantities};
pub use refusal::Refusal;

#[cfg(feature = "first")]
pub use {
    boundary::boundary,
    cases::cases,
    class::class_of,
    hops::{HOP_CLASSES, hop_classes},
    link::{read_link, read_number, write_link},
    motion::Motion,
    panic::provoke_panic,
    plane::Plane,
    routh::Routh,
    ticks::Ticks,
};

#[cfg(feature = "later")]
pub use {
    digest::digest_line,
    map::{MapSubject, OutcomeMap},
    moves::Moves,
    prediction::{Ghost, Prediction},
};
