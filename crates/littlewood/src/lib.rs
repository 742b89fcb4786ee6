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
mod cases;
mod engine;
mod math;
mod mechanics;
mod model;
mod modes;
mod motion;
mod walk;

pub use cases::{CASES, NamedCase, find_case};
pub use engine::{Doubt, Engine};
pub use mechanics::bouncing::BouncingOrbit;
pub use mechanics::closed_form;
pub use mechanics::closed_form::RollingType;
pub use mechanics::equations::{Accelerations, ContactForces, RollingLaw, SlidingLaw};
pub use mechanics::impact::{Compliance, ContactVelocities, Impact, ImpactCase, ImpactError, Impulse};
pub use mechanics::region::{Equilibrium, PhasePlane, Stability};
pub use mechanics::settling::{NoSettling, Settling};
pub use model::dimension::Detail;
pub use model::dimension::{Dimension, System};
pub use model::error::ParameterError;
pub use model::hoop::{Body, Heavy, Hoop, HoopParameters, Massless};
pub use model::limits::Limits;
pub use model::limits::Proof;
pub use model::mode::{Direction, Mode};
pub use model::named::{UnknownCode, UnknownName};
pub use model::quantity::{Bound, Group, Number, Presence, Quantity, QuantityRow, STANDARD_GRAVITY};
pub use model::restitution::Restitution;
pub use model::restitution::RestitutionLaw;
pub use model::setup::Setup;
pub use model::si::{SiParameters, SiSetup, SiState};
pub use model::state::{Start, State};
pub use model::units::Units;
pub use modes::PhaseSolution;
pub use modes::flight::Flight;
pub use modes::gliding::{Gliding, GlidingIntegrals, gliding_accelerations};
pub use modes::rolling::{
    GrazingOrbit, Recurrence, RecurrenceKind, Rolling, RollingEnd, RollingLimit, RollingOrbit,
};
pub use modes::sample::{Position, Sample};
pub use modes::sliding::Sliding;
pub use motion::class::Class;
pub use motion::classify::{Classification, StartRegion};
pub use motion::columns::{ColumnType, SampleColumn, SampleValue, SummaryColumn, SummaryValue};
pub use motion::digits::Digits;
pub use motion::summary::Summary;
pub use motion::trajectory::{Phase, Trajectory};
pub use walk::automaton::Transition;
pub use walk::automaton::{BodyClass, Cause, EDGES, Edge, find_edge};
pub use walk::candidates::Candidates;
pub use walk::outcome::{Outcome, OutcomeKind, SlideLimit};
pub use walk::sequence::{PhaseCode, PhaseSequence};

/// The example of the package's page.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
