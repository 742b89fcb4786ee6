//! Littlewood's hoop: exact simulation of a hoop with a particle fixed to it, on a rough plane.
//!
//! The model is that of A. Bronars and O. M. O'Reilly, *Gliding motions of a rigid body: the
//! curious dynamics of Littlewood's rolling hoop* (Proc. R. Soc. A 475, 2019); the documentation
//! cites its equation numbers. A disc or hoop of mass m1, radius R and moment of inertia `I_zz`
//! carries a particle of mass m2 at the distance ℓ from its centre. θ is the counterclockwise angle
//! of the particle from the upward vertical. With η = x + θ, η′ is the slip velocity of the contact
//! point. All quantities are dimensionless, m2 = R = g = 1 (2.9); [`si`] converts.
//!
//! # A tour
//!
//! A [`Hoop`] and a [`Start`] determine a [`Trajectory`]:
//!
//! ```
//! use littlewood::{Cause, Hoop, HoopParameters, Limits, Mode, Outcome, Start};
//!
//! let hoop = Hoop::new(HoopParameters::thin(1.0).with_friction(0.5, 0.4))?;
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
//! Endless rolling is proved, without a time limit:
//!
//! ```
//! use littlewood::cases::find_case;
//! use littlewood::modes::Recurrence;
//! use littlewood::Outcome;
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
//! With a coefficient of restitution a motion continues after a landing, with frictional impacts,
//! settling and the jam of Painlevé's paradox.
//!
//! ```
//! use littlewood::{Cause, Hoop, Limits, Mode, Restitution, RestitutionLaw, Start};
//!
//! let hoop = Hoop::equal_masses(0.5, 0.4)?.with_restitution(Restitution::new(0.5, RestitutionLaw::Energetic)?)?;
//! let motion = hoop.simulate(Start::at(std::f64::consts::FRAC_PI_2, 2.0), Limits::default())?;
//! let settled = motion.transitions().iter().find(|transition| transition.cause == Cause::Settle).expect("settles");
//! assert_eq!(settled.to, Some(Mode::Rolling));
//! assert!((settled.time() - 6.924_682_083_018_514).abs() < 1e-12);
//! # Ok::<(), littlewood::ParameterError>(())
//! ```
//!
//! # Modules
//!
//! | module | contents |
//! |---|---|
//! | root | a hoop, its start, its motion, and an [`Engine`] for many motions |
//! | [`cases`] | the motions of the paper, and some beyond it, by name |
//! | [`modes`] | the solution of each phase: rolling, sliding, gliding, flight |
//! | [`theory`] | the paper: phase plane, equations, closed forms, regions of starts, the automaton |
//! | [`many`] | engines for many starts |
//! | [`impact`] | impacts with friction, bounces that settle or never end |
//! | [`si`] | kilograms, metres, seconds |
//! | [`tables`] | tables for front ends: quantities, columns, classes, codes |
//!
//! # Accuracy
//!
//! Closed forms and elliptic integrals give rolling, gliding and flight; Taylor series that
//! converge to rounding give sliding. Events are isolated, not sampled: see `DESIGN.md`. Tolerances
//! are at the level of rounding; the user sets none.

#[cfg(feature = "ablation")]
pub mod ablation;
#[cfg(not(feature = "ablation"))]
#[expect(
    dead_code,
    unreachable_pub,
    reason = "only the benchmark lists the parts"
)]
mod ablation;
pub mod cases;
mod engine;
mod math;
mod mechanics;
mod model;
pub mod modes;
mod motion;
mod walk;

pub use engine::Engine;
pub use model::error::ParameterError;
pub use model::hoop::{Hoop, HoopParameters};
pub use model::limits::{Limits, Proof};
pub use model::mode::{Mode, RotationDirection, SlipDirection};
pub use model::restitution::{Restitution, RestitutionLaw};
pub use model::state::{Start, State};
pub use modes::sample::Sample;
pub use motion::digits::Digits;
pub use motion::summary::Summary;
pub use motion::trajectory::{Phase, Trajectory};
pub use walk::automaton::{Cause, Transition};
pub use walk::outcome::{Outcome, OutcomeKind};

pub mod theory {
    //! The paper: its phase plane, its equations, its closed forms, and the automaton of its
    //! motions.
    //!
    //! [`PhasePlane`] gives the regions and curves of the figures, [`RollingLaw`] and [`SlidingLaw`] the equations of motion
    //! in contact, and [`closed_form`] the results of §3 for Littlewood's hoop.
    //! [`Hoop::classify`](crate::Hoop::classify) returns the [`StartRegion`] of a start. [`EDGES`]
    //! lists all transitions of simulated motions.
    //!
    //! ```
    //! use littlewood::theory::closed_form;
    //! use littlewood::{Hoop, Limits, Start};
    //!
    //! // From the top, Littlewood's hoop begins to slip at the time of (3.6).
    //! let motion = Hoop::littlewood(0.5, 0.4)?.simulate(Start::at(0.0, 0.1), Limits::default())?;
    //! let slips = motion.transitions()[0].time();
    //! assert!((slips - closed_form::slip_time_from_top(0.1, 0.5)).abs() < 1e-14);
    //! # Ok::<(), littlewood::ParameterError>(())
    //! ```

    pub use crate::mechanics::closed_form::{self, RollingType};
    pub use crate::mechanics::curves::Window;
    pub use crate::mechanics::equations::{Accelerations, ContactForces, RollingLaw, SlidingLaw};
    pub use crate::mechanics::region::{Equilibrium, PhasePlane, Stability};
    pub use crate::model::hoop::{Body, Heavy, Massless};
    pub use crate::modes::gliding::{GlidingIntegrals, gliding_accelerations};
    pub use crate::motion::classify::{Classification, StartRegion};
    pub use crate::walk::automaton::{BodyClass, EDGES, Edge};
    pub use crate::walk::candidates::Candidates;
}

pub mod impact {
    //! Impacts of the rim on the plane: a rigid body, Coulomb friction, and one of three laws of
    //! restitution.
    //!
    //! [`Hoop::impact`](crate::Hoop::impact) computes one [`Impact`] in closed form,
    //! [`Hoop::settling`](crate::Hoop::settling) the sum of infinitely many bounces, and [`BouncingOrbit`] a motion that
    //! bounces for ever. The transitions of a simulated hoop with a
    //! [`Restitution`](crate::Restitution) contain the impacts.

    pub use crate::mechanics::bouncing::BouncingOrbit;
    pub use crate::mechanics::impact::{
        Compliance, ContactVelocities, Impact, ImpactCase, ImpactError, ImpactVertex, Impulse,
    };
    pub use crate::mechanics::settling::{NoSettling, Settling};
}

pub mod many {
    //! Many starts: an [`Engine`](crate::Engine) computes a summary in about a microsecond.
    //!
    //! [`Engine::new`](crate::Engine::new) is for many starts of a hoop: it keeps series of slides.
    //! [`Engine::builder`](crate::Engine::builder) is for as many as are expected: with few, only long motions keep series, and with [`interpolate_slips`](EngineBuilder::interpolate_slips) chains of slips are interpolated, with a weaker promise. An engine leaves a phase that it does not resolve to rounding to the solvers of the simulation;
    //! [`Engine::fallbacks`](crate::Engine::fallbacks) counts the reasons.
    //!
    //! ```
    //! use littlewood::{Engine, Hoop, Limits, OutcomeKind, Start};
    //!
    //! let engine = Engine::builder(&Hoop::equal_masses(0.5, 0.4)?).expected_starts(100).build();
    //! let starts = (0..100).map(|i| Start::at(1.0, 0.04 * f64::from(i)));
    //! let mut rolls = 0;
    //! for summary in engine.summaries(starts, Limits::default()) {
    //!     rolls += u32::from(summary?.outcome == OutcomeKind::RollsForever);
    //! }
    //! assert!(rolls > 0);
    //! # Ok::<(), Box<dyn std::error::Error>>(())
    //! ```

    pub use crate::engine::{EngineBuilder, Fallback, StartError};
}

pub mod derivatives {
    //! Derivatives of a motion with respect to the quantities of its hoop, plane and start.
    //!
    //! [`Trajectory::derivatives`](crate::Trajectory::derivatives) differentiates the time of each transition, the states before and after
    //! it, and the outcome; [`Trajectory::derivatives_at`](crate::Trajectory::derivatives_at) the
    //! state and the gap at a time. A derivative that does not exist is a [`NoDerivative`] with its reason.

    pub use crate::motion::derivatives::{
        Derivative, Derivatives, EventDerivative, InstantDerivative, NoDerivative,
        NotDifferentiable, OutcomeDerivative, differentiable,
    };
}

pub mod energy {
    //! Where the energy of a motion goes: what is kinetic and potential at an instant, and what has
    //! been lost to friction and in impacts.
    //!
    //! ```
    //! use littlewood::cases::find_case;
    //! use littlewood::energy::EnergyLedger;
    //!
    //! let motion = find_case("figure-3").expect("a named case").simulate()?;
    //! let ledger = EnergyLedger::new(&motion).expect("a phase");
    //! let end = motion.at(motion.end_time()).expect("an instant of the motion");
    //! let parts = ledger.parts(&end).expect("an instant of the motion");
    //! // Two slides lose energy, and the motion ends before the impact.
    //! let total = parts.kinetic + parts.potential + parts.friction;
    //! assert!(parts.friction > 0.0 && (total - parts.start).abs() < 1e-12);
    //! # Ok::<(), littlewood::ParameterError>(())
    //! ```

    pub use crate::motion::energy::{EnergyLedger, EnergyParts};
}

pub mod thresholds {
    //! The value of a quantity at which the outcome of a motion changes, to the last digit.

    pub use crate::motion::threshold::{ClassAt, SearchRange, Searched, Threshold};
}

pub mod si {
    //! SI units: a hoop and its start in kilograms, metres and seconds, and the units that convert
    //! its motion.
    //!
    //! The rest of this library is dimensionless, m2 = R = g = 1 (2.9).

    pub use crate::model::quantity::STANDARD_GRAVITY;
    pub use crate::model::si::{SiParameters, SiSetup, SiState};
    pub use crate::model::units::Units;
}

pub mod tables {
    //! Tables for front ends: quantities of a hoop and a start, columns of samples and summaries,
    //! classes of outcomes, codes of phases.
    //!
    //! Each item has a name, which `FromStr` parses, and a code. A [`Setup`] is a hoop and a start
    //! with access by quantity.
    //!
    //! ```
    //! use littlewood::tables::{Quantity, Setup, SummaryColumn};
    //! use littlewood::{Hoop, HoopParameters, Limits, Start};
    //!
    //! let mut setup = Setup::new(HoopParameters::thin(1.0), Start::at(1.0, 0.0));
    //! for (name, value) in [("mu_s", 0.5), ("mu_k", 0.4), ("theta_rate", 2.0)] {
    //!     let quantity: Quantity = name.parse()?;
    //!     setup.set(quantity, quantity.check(value)?);
    //! }
    //! let motion = Hoop::new(setup.hoop)?.simulate(setup.start, Limits::default())?;
    //! for (column, value) in SummaryColumn::ALL.into_iter().zip(motion.summary().values()) {
    //!     println!("{column}: {value:?} ({})", column.long_name());
    //! }
    //! # Ok::<(), Box<dyn std::error::Error>>(())
    //! ```

    pub use crate::model::dimension::{Detail, Dimension, System};
    pub use crate::model::named::{UnknownCode, UnknownName};
    pub use crate::model::quantity::{Bound, Group, Number, Presence, Quantity, QuantityRow};
    pub use crate::model::setup::Setup;
    pub use crate::motion::class::Class;
    pub use crate::motion::columns::{
        ColumnType, DerivativeColumn, SampleColumn, SampleValue, SummaryColumn, SummaryValue,
        UnknownDerivative,
    };
    pub use crate::walk::sequence::{PhaseCode, PhaseSequence};
}

/// Tests the examples of `README.md`.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
