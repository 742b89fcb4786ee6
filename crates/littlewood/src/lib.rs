//! Littlewood's hoop: exact simulation of a hoop with a particle fixed to it, on a rough plane.

mod automaton;
mod bernstein;
mod carlson;
mod cases;
mod classify;
pub mod closed_form;
mod contact;
mod error;
mod flight;
mod gliding;
mod hoop;
mod region;
mod rolling;
mod si;
mod simulate;
mod sliding;
mod state;
mod trajectory;

pub use automaton::{BodyClass, Cause, EDGES, Edge, find_edge};
pub use cases::{CASES, NamedCase, find_case};
pub use classify::{Classification, StartRegion};
pub use closed_form::RollingType;
pub use contact::Findings;
pub use error::{Bound, ParameterError, Quantity};
pub use flight::Flight;
pub use gliding::{Gliding, GlidingIntegrals, gliding_accelerations};
pub use hoop::{Body, Heavy, Hoop, HoopParameters, Massless};
pub use region::{Equilibrium, PhasePlane, Stability};
pub use rolling::{ContactForces, Limit, Recurrence, Rolling, RollingEnd, RollingLaw, RollingOrbit};
pub use si::{SiParameters, SiState, Units};
pub use simulate::Limits;
pub use sliding::{Accelerations, Sliding, SlidingLaw};
pub use state::{Direction, Mode, Point, Sample, Start, State};
pub use trajectory::{Motion, Outcome, Phase, Trajectory, Transition};
