//! Which instants of a motion to report.

use core::ops::RangeInclusive;

use littlewood::Trajectory;

/// Length of the samples of a motion that has neither an end nor a period.
const APERIODIC: f64 = 10.0;

/// Which instants to sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Number of evenly spaced instants.
    pub count: usize,
    /// The last instant, τ.
    pub until: f64,
}

impl Sampling {
    /// Numbers of instants that can be asked for: with more a table outgrows memory.
    pub const COUNTS: RangeInclusive<u64> = 2..=10_000_000;

    /// `count` instants of a motion, to its end. A motion without an end is sampled for two periods
    /// of the last phase, or for ten units of time where that has none; one that rests for a
    /// tenth longer than it moved.
    #[must_use]
    pub fn of(trajectory: &Trajectory, count: usize) -> Self {
        Self {
            count,
            until: horizon(trajectory),
        }
    }
}

fn horizon(trajectory: &Trajectory) -> f64 {
    let end = trajectory.end_time();
    if end.is_finite() {
        return end;
    }
    if let Some(until) = trajectory.rest_shown_until() {
        return until;
    }
    let outcome = trajectory.outcome();
    let period = outcome
        .recurrence()
        .and_then(|recurrence| recurrence.period());
    let last = period
        .filter(|period| period.is_finite())
        .map_or(APERIODIC, |period| 2.0 * period);
    outcome.state().time + last
}
