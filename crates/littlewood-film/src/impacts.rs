//! The impacts of a motion that a film shows.

use littlewood::impact::{Impact, ImpactCase};
use littlewood::modes::Position;
use littlewood::{Cause, Sample, Trajectory};

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
        let mut found: Vec<Self> = Vec::new();
        if let (Some(first), Some(phase)) = (
            trajectory.transitions().first(),
            trajectory.phases().first(),
        ) && first.from.is_none()
        {
            found.extend(first.impact.map(|impact| Self::new(impact, &phase.first())));
        }
        for phase in trajectory
            .phases()
            .iter()
            .take_while(|phase| phase.start().time <= end)
        {
            let Some(transition) = trajectory.end_of(phase).filter(|it| it.time() <= end) else {
                continue;
            };
            let Some((impact, before)) = transition.impact.zip(phase.last()) else {
                continue;
            };
            if transition.cause != Cause::Settle && impact.case != ImpactCase::None {
                found.push(Self::new(impact, &before));
            }
        }
        found
    }

    /// Of the last instant before it, or where it is the start the first.
    const fn new(impact: Impact, before: &Sample) -> Self {
        Self {
            time: before.state.time,
            place: Position {
                x: before.centre.x,
                y: 0.0,
            },
            impact,
        }
    }
}
