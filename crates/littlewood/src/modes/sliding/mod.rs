//! Sliding (§2b): η′ ≠ 0, kinetic friction F = −μk N σ with σ = sign(η′) (2.15). Two first
//! integrals of the equations of
//! [`crate::theory::SlidingLaw`] reduce it to the single function θ(τ) (docs/theory/sliding.md).

mod arc;
mod leap;
mod onset;
mod return_map;
mod series;
mod singular;

pub use arc::Sliding;
pub(crate) use arc::{Entry, SlideBudget, SlidingEnd};
pub(super) use arc::{MIN_RELATIVE_STEP, max_step};
pub(crate) use onset::{ForceRounding, Onset, StaticLimit};
pub(crate) use series::{PhasePoint, SlideSeries, TRUNCATION_TOLERANCE};
pub(super) use series::{convergence_radius, finite_degree};

/// The limit that stopped a motion with long slides.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum SlideLimit {
    /// The slides of the motion exceeded the total length [`crate::Limits::slides`].
    All {
        /// The limit.
        slides: usize,
    },
    /// The slides of more than 2,000 steps exceeded 100,000 steps in total. Or, with very small
    /// friction or a fast hoop, this slide passed more turns than double precision resolves, or its
    /// duration is not representable.
    One {
        /// Steps of this slide.
        steps: usize,
        /// Time until η′ = 0, extrapolated from the mean loss of slip so far; infinite if the slip
        /// has not decreased, or if the time is not representable.
        time_left: f64,
    },
}
