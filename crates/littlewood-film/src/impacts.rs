//! The impacts of a motion that a film shows.

use littlewood::impact::{Compliance, Impact, ImpactCase, Impulse};
use littlewood::modes::Position;
use littlewood::{Cause, Sample, Trajectory};

/// Smallest impulse that is replayed slowly, in parts of the largest of the motion. There is no end
/// to smaller ones where bounces settle.
const NOTICEABLE: f64 = 0.1;

/// An impact that is shown.
#[derive(Clone, Debug)]
pub(crate) struct ShownImpact {
    /// Time τ.
    pub(crate) time: f64,
    /// Point of contact.
    pub(crate) place: Position,
    pub(crate) impact: Impact,
    /// Whether it is large enough for a slow replay.
    pub(crate) is_noticeable: bool,
    /// The last instant before it, or where it is the start the first.
    pub(crate) before: Sample,
    course: Vec<Impulse>,
    compliance: Option<Compliance>,
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
            found.extend(
                first
                    .impact
                    .map(|impact| Self::new(trajectory, impact, phase.first())),
            );
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
                found.push(Self::new(trajectory, impact, before));
            }
        }
        let largest = found
            .iter()
            .map(|shown| shown.impact.impulse.normal)
            .fold(0.0, f64::max);
        for shown in &mut found {
            shown.is_noticeable = shown.impact.impulse.normal >= NOTICEABLE * largest;
        }
        found
    }

    fn new(trajectory: &Trajectory, impact: Impact, before: Sample) -> Self {
        let theta = before.state.theta;
        Self {
            time: before.state.time,
            place: Position {
                x: before.centre.x,
                y: 0.0,
            },
            impact,
            is_noticeable: true,
            before,
            course: trajectory.hoop().impact_course(theta, &impact),
            compliance: trajectory.hoop().compliance(theta),
        }
    }

    /// The impulse when a share of the normal impulse has passed, 0 to 1.
    pub(crate) fn impulse_at(&self, share: f64) -> Impulse {
        if share >= 1.0 {
            return self.impact.impulse;
        }
        let normal = share * self.impact.impulse.normal;
        let part = self.course.windows(2).find(|ends| normal <= ends[1].normal);
        let friction = part.map_or(self.impact.impulse.friction, |ends| {
            let way = (normal - ends[0].normal) / (ends[1].normal - ends[0].normal);
            ends[0].friction + way * (ends[1].friction - ends[0].friction)
        });
        Impulse { normal, friction }
    }

    /// The slip velocity then.
    pub(crate) fn slip_at(&self, share: f64) -> f64 {
        if share >= 1.0 {
            return self.impact.after.slip;
        }
        let Impulse { normal, friction } = self.impulse_at(share);
        let change = self
            .compliance
            .map_or(0.0, |by| by.a * friction + by.b * normal);
        self.impact.before.slip + change
    }
}
