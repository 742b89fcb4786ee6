//! How long the motions of a hoop are, from a few of them.

use super::Engine;
use crate::mechanics::curves::Window;
use crate::model::{Limits, Start};
use crate::motion::summary::Summary;

/// Starts to either side of the plane.
const GRID_SIDE: u32 = 8;

impl Engine {
    /// The summaries of those starts of an even lattice of 8 × 8 in a window of (θ, θ′) whose
    /// motions take so many transitions; what else a start has is that of `base`. It costs 64
    /// motions, which are followed no farther.
    pub fn long_motions(
        &self,
        window: Window,
        base: Start,
        limits: Limits,
        transitions: usize,
    ) -> impl Iterator<Item = Summary> {
        let limits = limits.with_transitions(limits.transitions.min(transitions));
        let at = |[from, to]: [f64; 2], i: u32| {
            from + (to - from) * (f64::from(i) + 0.5) / f64::from(GRID_SIDE)
        };
        let starts = (0..GRID_SIDE).flat_map(|i| (0..GRID_SIDE).map(move |j| [i, j]));
        let starts = starts.map(move |[i, j]| Start {
            theta: at(window.x, i),
            theta_rate: at(window.y, j),
            ..base
        });
        let summaries = self.summaries(starts, limits).filter_map(Result::ok);
        summaries.filter(move |summary| summary.transitions as usize >= transitions)
    }
}
