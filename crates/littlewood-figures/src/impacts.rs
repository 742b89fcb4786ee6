//! The impacts of a motion.

use littlewood::impact::{Impact, ImpactCase};
use littlewood::{Cause, Trajectory, Transition};

/// All impacts, those of the bounces by which a hoop settles as one.
pub(crate) fn all(motion: &Trajectory) -> impl Iterator<Item = (&Transition, Impact)> {
    let transitions = motion.transitions().iter();
    transitions.filter_map(|transition| Some((transition, transition.impact?)))
}

/// The impacts one by one: those of which each has a course.
pub(crate) fn single(motion: &Trajectory) -> impl Iterator<Item = (&Transition, Impact)> {
    all(motion).filter(|(transition, impact)| {
        transition.cause != Cause::Settle && impact.case != ImpactCase::None
    })
}
