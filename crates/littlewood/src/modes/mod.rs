//! The four modes of motion, each with its solution in time and what may end it.
//!
//! A phase of a motion has its solution ([`Phase::solution`](crate::Phase::solution)), which can be asked for any instant and for
//! more than states: of rolling its orbit in the plane (θ, θ′), where the orbit ends ([`RollingEnd`]), or how it comes back for ever
//! ([`Recurrence`]).
//!
//! ```
//! use littlewood::cases::find_case;
//! use littlewood::modes::{PhaseSolution, RollingLimit};
//! use littlewood::Direction;
//!
//! let motion = find_case("figure-3").expect("a named case").simulate()?;
//! let PhaseSolution::Rolling(rolling) = motion.phases()[1].solution() else { panic!("rolls") };
//! let end = rolling.orbit().end().expect("slips");
//! assert_eq!(end.limit, RollingLimit::Friction(Direction::Positive));
//! # Ok::<(), littlewood::ParameterError>(())
//! ```

pub(crate) mod flight;
pub(crate) mod gliding;
pub(crate) mod rolling;
pub(crate) mod sample;
pub(crate) mod sliding;

pub(crate) use self::flight::TakeOff;
pub(crate) use self::gliding::{GlideEntry, GlidingEnd};
pub(crate) use self::rolling::{Hold, Levels};
pub(crate) use self::sample::{Instant, Sample};
pub(crate) use self::sliding::{Entry, SlidingEnd};

pub use self::flight::Flight;
pub use self::gliding::Gliding;
pub use self::rolling::{
    GrazingOrbit, Recurrence, RecurrenceKind, Rolling, RollingEnd, RollingLimit, RollingOrbit,
};
pub use self::sample::Position;
pub use self::sliding::{SlideLimit, Sliding};

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
