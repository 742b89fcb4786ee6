//! The impacts of a motion that a film shows.

use littlewood::impact::{Impact, ImpactCase};
use littlewood::modes::Position;
use littlewood::{Cause, Trajectory};

/// An impact that is shown.
#[derive(Clone, Debug)]
pub(crate) struct ShownImpact {
    /// Time τ.
    pub(crate) time: f64,
    /// Point of contact.
    pub(crate) place: Position,
    pub(crate) impact: Impact,
}

impl ShownImpact {
    /// The impacts up to a time, one by one: those by which a hoop settles are too small to be
    /// seen.
    pub(crate) fn all(trajectory: &Trajectory, end: f64) -> Vec<Self> {
        let transitions = trajectory.transitions().iter();
        transitions
            .take_while(|transition| transition.time() <= end)
            .filter(|transition| transition.cause != Cause::Settle)
            .filter_map(|transition| {
                let impact = transition
                    .impact
                    .filter(|impact| impact.case != ImpactCase::None)?;
                Some(Self {
                    time: transition.time(),
                    place: Position {
                        x: transition.before.x,
                        y: 0.0,
                    },
                    impact,
                })
            })
            .collect()
    }
}
