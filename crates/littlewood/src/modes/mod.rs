//! The modes of motion: the solution of each in time, and the events that end it.
//!
//! [`Phase::solution`](crate::Phase::solution) returns the solution of a phase, which gives the state at any time. A rolling solution
//! also gives its orbit in the (θ, θ′) plane, with the end of the orbit ([`RollingEnd`]) or its
//! recurrence ([`Recurrence`]).
//!
//! ```
//! use littlewood::cases::find_case;
//! use littlewood::modes::{PhaseSolution, RollingLimit};
//! use littlewood::SlipDirection;
//!
//! let motion = find_case("figure-3").expect("a named case").simulate()?;
//! let PhaseSolution::Rolling(rolling) = motion.phases()[1].solution() else { panic!("rolls") };
//! let end = rolling.orbit().end().expect("slips");
//! assert_eq!(end.limit, RollingLimit::Friction(SlipDirection::Positive));
//! # Ok::<(), littlewood::ParameterError>(())
//! ```

use crate::model::{Hoop, Mode, SlipDirection, State};

pub(crate) mod flight;
pub(crate) mod gliding;
pub(crate) mod resisted;
pub(crate) mod rolling;
pub(crate) mod sample;
pub(crate) mod sliding;
mod turn_times;

pub(crate) use self::flight::{FlightExtent, TakeOff};
pub(crate) use self::gliding::{GlideEntry, GlidingEnd};
pub(crate) use self::resisted::{ResistedBudget, ResistedEnd, RollingSeries};
pub(crate) use self::rolling::{Levels, MasslessLimit, Stiction, static_friction_holds};
pub(crate) use self::sample::{Instant, Sample, couple_of_turning};
pub(crate) use self::sliding::{
    Entry, ForceRounding, Onset, PhasePoint, SlideBudget, SlideSeries, SlidingEnd, StaticLimit,
    TRUNCATION_TOLERANCE,
};

pub use self::flight::Flight;
pub use self::gliding::Gliding;
pub use self::resisted::{ResistedRolling, Rest, Skidding};
pub use self::rolling::{
    GrazingOrbit, Recurrence, RecurrenceKind, Rolling, RollingEnd, RollingLimit, RollingOrbit,
};
pub use self::sample::Position;
pub use self::sliding::{SlideLimit, Sliding};
pub use crate::model::undecided::{Margin, Undecided};

/// The exact solution of a phase. τ and x are relative to the start of the motion, and θ excludes
/// the whole turns of the start. On a slope its units are those in which gravity normal to the
/// plane is 1: times are multiplied by √cos α, velocities divided by it.
#[derive(Clone, Debug)]
pub enum PhaseSolution {
    /// Rolling along an orbit.
    Rolling(Box<Rolling>),
    /// Rolling in one direction with rolling resistance.
    ResistedRolling(Box<ResistedRolling>),
    /// Sliding in one direction.
    Sliding(Box<Sliding>),
    /// Gliding of a massless hoop.
    Gliding(Gliding),
    /// Flight.
    Flight(Flight),
    /// Skidding, which rolling resistance keeps from turning.
    Skidding(Skidding),
    /// Rest, in which rolling resistance holds the hoop.
    Rest(Rest),
}

impl PhaseSolution {
    /// Mode of motion.
    pub(crate) const fn mode(&self) -> Mode {
        match self {
            Self::Rolling(_) | Self::ResistedRolling(_) => Mode::Rolling,
            Self::Sliding(_) => Mode::Sliding,
            Self::Gliding(_) => Mode::Gliding,
            Self::Flight(_) => Mode::Flight,
            Self::Skidding(_) => Mode::Skidding,
            Self::Rest(_) => Mode::Rest,
        }
    }

    /// Direction of slip; none for rolling, rest and flight.
    pub(crate) fn direction(&self) -> Option<SlipDirection> {
        match self {
            Self::Sliding(slide) => Some(slide.direction()),
            Self::Gliding(glide) => glide.direction(),
            Self::Skidding(skid) => Some(skid.direction()),
            Self::Rolling(_) | Self::ResistedRolling(_) | Self::Flight(_) | Self::Rest(_) => None,
        }
    }

    /// The flight, if it is one.
    pub(crate) const fn flight(&self) -> Option<&Flight> {
        match self {
            Self::Flight(flight) => Some(flight),
            Self::Rolling(_)
            | Self::ResistedRolling(_)
            | Self::Sliding(_)
            | Self::Gliding(_)
            | Self::Skidding(_)
            | Self::Rest(_) => None,
        }
    }

    /// State after the time `elapsed`.
    pub(crate) fn state(&self, elapsed: f64) -> State {
        match self {
            Self::Rolling(rolling) => rolling.state(elapsed),
            Self::Sliding(slide) => slide.state(elapsed),
            Self::Gliding(glide) => glide.state(elapsed),
            Self::Flight(flight) => flight.state(elapsed),
            Self::ResistedRolling(rolling) => rolling.state(elapsed),
            Self::Skidding(skid) => skid.state(elapsed),
            Self::Rest(rest) => rest.state(elapsed),
        }
    }

    /// Sample of a state after the time `elapsed`.
    pub(crate) fn sample(&self, hoop: &Hoop, state: State, elapsed: f64) -> Sample {
        match self {
            Self::Rolling(rolling) => rolling.sample(hoop, state),
            Self::Sliding(slide) => slide.sample(hoop, state),
            Self::Gliding(glide) => glide.sample(hoop, state),
            Self::Flight(flight) => flight.sample(hoop, state, elapsed),
            Self::ResistedRolling(rolling) => rolling.sample(hoop, state),
            Self::Skidding(skid) => skid.sample(hoop, state),
            Self::Rest(rest) => rest.sample(hoop, state),
        }
    }
}
