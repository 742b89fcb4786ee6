//! The four modes of motion, each with its solution and its events.

pub(crate) mod flight;
pub(crate) mod gliding;
pub(crate) mod rolling;
pub(crate) mod sample;
pub(crate) mod sliding;

use self::flight::Flight;
use self::gliding::Gliding;
use self::rolling::Rolling;
use self::sliding::Sliding;

/// The exact solution during a phase, with τ and x since the start of the motion, and θ without its whole turns there.
#[derive(Clone, Debug)]
pub enum PhaseSolution {
    /// Rolling along an orbit.
    Rolling(Rolling),
    /// Sliding in one direction.
    Sliding(Box<Sliding>),
    /// Gliding of a massless hoop.
    Gliding(Gliding),
    /// Flight.
    Flight(Flight),
}
