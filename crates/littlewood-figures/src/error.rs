//! What can go wrong with a figure.

use littlewood::{OutcomeKind, ParameterError};
use littlewood_draw::DrawError;
use littlewood_sweep::{AxisError, ThreadsError};

/// A figure that cannot be made.
#[derive(Debug, thiserror::Error)]
#[expect(missing_docs, reason = "the message of each says what its fields are")]
pub enum FigureError {
    /// A hoop or a start out of bounds.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// A case that is not there.
    #[error("there is no case named '{name}'")]
    UnknownCase { name: String },
    /// A figure of §2 asked for a hoop without inertia.
    #[error("{figure} shows a hoop with inertia; this one has mass ratio 0 and inertia 0")]
    NeedsInertia { figure: &'static str },
    /// A figure of §3 asked for a hoop with inertia.
    #[error(
        "{figure} shows the massless hoop; this one has mass ratio {mass_ratio} and inertia {inertia}"
    )]
    NeedsMassless {
        figure: &'static str,
        mass_ratio: f64,
        inertia: f64,
    },
    /// A figure of §3 asked for a particle inside the rim.
    #[error("{figure} shows the particle on the rim, offset 1; this one has offset {offset}")]
    NeedsRim { figure: &'static str, offset: f64 },
    /// A figure of angles asked for a body whose mass centre is the geometric centre.
    #[error(
        "{figure} shows a loaded hoop; this one has offset 0, and nothing depends on the angle"
    )]
    NeedsOffset { figure: &'static str },
    /// A figure of the region of rolling asked for a massless hoop without static friction, which
    /// has none.
    #[error(
        "{figure} shows where static friction holds the massless hoop; with mu_s 0 that is nowhere"
    )]
    NeedsStaticFriction { figure: &'static str },
    /// A figure of contact asked for a motion that never is in contact.
    #[error("{figure} shows a motion in contact, but from this start the hoop leaves the plane at once: {}", outcome.label())]
    NoContact {
        figure: &'static str,
        outcome: OutcomeKind,
    },
    /// A figure of a motion that does not begin: no motion, or more than one, is consistent at the
    /// start.
    #[error("{figure} shows a motion, but from this start there is none: {}", outcome.label())]
    NoMotion {
        figure: &'static str,
        outcome: OutcomeKind,
    },
    /// A figure of a motion that lasts no time.
    #[error("{figure} shows a motion, but this one ends where it begins, at τ = {time}: {}", outcome.label())]
    NoDuration {
        figure: &'static str,
        time: f64,
        outcome: OutcomeKind,
    },
    /// A figure of impacts asked for a hoop whose motion ends at the landing.
    #[error(
        "{figure} shows what follows a landing; without a coefficient of restitution the motion ends there"
    )]
    NeedsRestitution { figure: &'static str },
    /// A figure of impacts asked for a motion without one.
    #[error("{figure} shows impacts, but the motion has none: {}", outcome.label())]
    NoImpact {
        figure: &'static str,
        outcome: OutcomeKind,
    },
    /// An impact that the motion does not have.
    #[error("impact {number} is asked for, but the impacts of the motion are 1 to {impacts}")]
    ImpactNumber { number: usize, impacts: usize },
    /// A figure of §3 asked for a slope, on which its lines are others.
    #[error("{figure} shows a level plane, as the paper; this one has the slope {slope} rad")]
    NeedsLevel { figure: &'static str, slope: f64 },
    /// A figure of energies of rolling asked for rolling resistance, which takes energy.
    #[error(
        "{figure} shows rolling by its energy, which rolling resistance takes; this hoop has the coefficient {resistance}"
    )]
    NeedsNoResistance {
        figure: &'static str,
        resistance: f64,
    },
    /// A width or a scale out of bounds.
    #[error(transparent)]
    Draw(#[from] DrawError),
    /// The system has no threads to give.
    #[error(transparent)]
    Threads(#[from] ThreadsError),
    /// Axes of a plane that cannot be.
    #[error(transparent)]
    Axis(#[from] AxisError),
}
