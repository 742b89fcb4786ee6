//! Sliding (§2b): η′ ≠ 0, kinetic friction F = −μk N σ with σ = sign(η′) (2.15).
//!
//! The equations are those of [`crate::theory::SlidingLaw`]. Two first integrals reduce a slide to the single function θ(τ). The horizontal and vertical balances of momentum,
//! m x̄″ = −μk σ N and m ȳ″ = N − m, have the combination x̄″ + μk σ (ȳ″ + 1) = 0, hence
//!
//! ```text
//! η′ − θ′ (1 + h cos θ + μk σ h sin θ) + μk σ τ = const,
//! x̄ + μk σ (ȳ + τ²/2) = linear in τ.
//! ```

mod arc;
mod leap;
mod panel;
mod series;
mod singular;
mod turn;

pub use arc::Sliding;
pub(crate) use arc::{Entry, SlidingEnd};

/// A limit of slides.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub enum SlideLimit {
    /// The largest length of all slides together ([`crate::Limits::slides`]) was reached at the end of one.
    All {
        /// The limit.
        slides: usize,
    },
    /// Slides of more than 2,000 steps have together taken more than 100,000, this one the last of them; or, on a plane of next to no friction, or of a fast hoop, it has turned more often
    /// than angles resolve, or ends at a time beyond all numbers.
    One {
        /// Its steps.
        steps: usize,
        /// Time until η′ = 0 at the pace so far; infinite if the slip has not lost any, or if the time is beyond all numbers.
        time_left: f64,
    },
}
