//! Sliding (§2b): η′ ≠ 0, kinetic friction F = −μk N σ with σ = sign(η′) (2.15).
//!
//! The equations are those of [`crate::SlidingLaw`]. Two first integrals reduce a slide to the single function θ(τ). The horizontal and vertical balances of momentum,
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
