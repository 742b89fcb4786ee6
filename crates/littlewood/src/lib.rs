//! Littlewood's hoop: exact simulation of a hoop with a particle fixed to it, on a rough plane.
//!
//! The body is that of A. Bronars and O. M. O'Reilly, *Gliding motions of a rigid body: the curious dynamics of
//! Littlewood's rolling hoop* (Proc. R. Soc. A 475, 2019), whose equation numbers the documentation cites. A disc or
//! hoop of mass m1, radius R and moment of inertia `I_zz` carries a particle of mass m2 at the distance ℓ from its
//! centre. θ is the angle of the particle from the upward vertical, counterclockwise; η = x + θ, so that η′ is the slip
//! velocity of the contact point. Everything is dimensionless, m2 = R = g = 1 (2.9); [`SiParameters`] converts.
//!
//! # A tour
//!
//! A [`Hoop`] and a [`Start`] make a [`Trajectory`]:
//!
//! ```
//! use littlewood::{Cause, Hoop, HoopParameters, Limits, Mode, Outcome, Start};
//!
//! let hoop = Hoop::new(HoopParameters::new(1.0, 1.0, 1.0).with_friction(0.5, 0.4))?;
//! let motion = hoop.simulate(Start::at(std::f64::consts::FRAC_PI_2, 2.0), Limits::default())?;
//!
//! let causes: Vec<Cause> = motion.transitions().iter().map(|transition| transition.cause).collect();
//! assert_eq!(causes, [Cause::Stick, Cause::Slip, Cause::LiftOff, Cause::Landing]);
//! assert!(matches!(motion.outcome(), Outcome::Landing { .. }));
//!
//! let sample = motion.at(0.7).expect("the body is rolling");
//! assert_eq!(sample.mode, Mode::Rolling);
//! assert!(sample.friction.abs() <= 0.5 * sample.normal);
//! # Ok::<(), littlewood::ParameterError>(())
//! ```
//!
//! Rolling that never ends is proved, not timed out:
//!
//! ```
//! use littlewood::{Outcome, Recurrence, find_case};
//!
//! let motion = find_case("figure-2-libration").expect("a named case").simulate()?;
//! let Outcome::RollsForever { recurrence: Recurrence::Libration { period, .. }, .. } = motion.outcome() else {
//!     panic!("rolls for ever");
//! };
//! let (then, later) = (motion.at(1.0).expect("rolls"), motion.at(1.0 + 1e6 * period).expect("still rolls"));
//! assert!((then.state.theta - later.state.theta).abs() < 1e-8);
//! # Ok::<(), littlewood::ParameterError>(())
//! ```
//!
//! With a coefficient of restitution a motion goes on after its landing: impacts with friction, bounces to their end, and the
//! jam of Painlevé's paradox.
//!
//! ```
//! use littlewood::{Cause, Hoop, Limits, Mode, Restitution, RestitutionLaw, Start};
//!
//! let hoop = Hoop::figure_2(0.5, 0.4)?.with_restitution(Restitution::new(0.5, RestitutionLaw::Energetic)?)?;
//! let motion = hoop.simulate(Start::at(std::f64::consts::FRAC_PI_2, 2.0), Limits::default())?;
//! let settled = motion.transitions().iter().find(|transition| transition.cause == Cause::Settle).expect("settles");
//! assert_eq!(settled.to, Some(Mode::Rolling));
//! assert!((settled.time() - 6.924_682_083_018_514).abs() < 1e-12);
//! # Ok::<(), littlewood::ParameterError>(())
//! ```
//!
//! The plane of the paper's figures is [`PhasePlane`], its closed forms are in [`closed_form`], the edges of the
//! automaton are [`EDGES`], and [`Hoop::classify`] says where a start lies. [`CASES`] are the motions that the paper
//! shows or speaks of. [`Engine`] makes a [`Summary`] of each of many starts.
//!
//! # How exact
//!
//! Rolling, gliding and flight are evaluated from closed forms and elliptic integrals, sliding from Taylor series that
//! have converged to rounding. Events are isolated, not sampled: see `DESIGN.md`. Constants that decide are
//! at the level of rounding; the user chooses none.

#[cfg(feature = "ablation")]
pub mod ablation;
#[cfg(not(feature = "ablation"))]
mod ablation;
mod automaton;
mod bernstein;
mod bouncing;
mod bracket;
mod candidates;
mod carlson;
mod cases;
mod class;
mod classify;
pub mod closed_form;
mod columns;
mod detail;
mod digits;
mod dimension;
mod engine;
mod equations;
mod error;
mod event;
mod exact;
mod flight;
mod form;
mod frictionless;
mod gliding;
mod hoop;
mod impact;
mod law;
mod lift_off;
mod limits;
mod links;
mod mode;
mod named;
mod origin;
mod outcome;
mod proof;
mod proofs;
mod quantity;
mod region;
mod restitution;
mod rolling;
mod same;
mod sample;
mod sequence;
mod settling;
mod setup;
mod si;
mod simulate;
mod sliding;
mod slip;
mod solvability;
mod state;
mod summary;
mod trajectory;
mod transition;
mod trig;
mod units;
mod walk;

pub use automaton::{BodyClass, Cause, EDGES, Edge, find_edge};
pub use bouncing::BouncingOrbit;
pub use candidates::Candidates;
pub use cases::{CASES, NamedCase, find_case};
pub use class::Class;
pub use classify::{Classification, StartRegion};
pub use closed_form::RollingType;
pub use columns::{ColumnType, SampleColumn, SampleValue, SummaryColumn, SummaryValue};
pub use detail::Detail;
pub use digits::Digits;
pub use dimension::{Dimension, System};
pub use engine::Engine;
pub use equations::{Accelerations, ContactForces, RollingLaw, SlidingLaw};
pub use error::ParameterError;
pub use flight::Flight;
pub use gliding::{Gliding, GlidingIntegrals, gliding_accelerations};
pub use hoop::{Body, Heavy, Hoop, HoopParameters, Massless};
pub use impact::{Compliance, ContactVelocities, Impact, ImpactCase, ImpactError, Impulse};
pub use law::RestitutionLaw;
pub use limits::Limits;
pub use mode::{Direction, Mode};
pub use named::{UnknownCode, UnknownName};
pub use outcome::{Outcome, OutcomeKind, SlideLimit};
pub use proof::Proof;
pub use quantity::{Bound, Group, Number, Presence, Quantity, QuantityRow, STANDARD_GRAVITY};
pub use region::{Equilibrium, PhasePlane, Stability};
pub use restitution::Restitution;
pub use rolling::{
    GrazingOrbit, Recurrence, RecurrenceKind, Rolling, RollingEnd, RollingLimit, RollingOrbit,
};
pub use sample::{Position, Sample};
pub use sequence::{PhaseCode, PhaseSequence};
pub use settling::{NoSettling, Settling};
pub use setup::Setup;
pub use si::{SiParameters, SiSetup, SiState};
pub use sliding::Sliding;
pub use state::{Start, State};
pub use summary::Summary;
pub use trajectory::{Phase, PhaseSolution, Trajectory};
pub use transition::Transition;
pub use units::Units;

/// The example of the package's page.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
