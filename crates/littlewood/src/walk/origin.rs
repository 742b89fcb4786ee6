//! Where a motion starts in time, along the plane and in whole turns.
//!
//! The laws know no instant and no place, and of the angle its sine and cosine alone. So a motion is followed from τ = 0, x = 0 and |θ| ≤ π, and
//! what its start has beyond that is added to what leaves the core: such a number is the rounded sum of two, and nothing else depends on the origin.

use crate::math::trig::without_turns;
use crate::model::{Limits, State};
use crate::modes::{Position, Recurrence, Sample};
use crate::walk::Outcome;

/// The τ, x and whole turns of a start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Origin {
    time: f64,
    x: f64,
    /// Sum of two, so that the angle of the start is found again.
    turns: [f64; 2],
    /// The time limit since the start, and as it was given.
    until: Option<[f64; 2]>,
}

impl Origin {
    /// The origin of a motion, and its start and limits as seen from there.
    pub(crate) fn of(start: State, limits: Limits) -> (Self, State, Limits) {
        let theta = without_turns(start.theta);
        let turns = start.theta - theta;
        let rest = (start.theta - turns) - theta;
        // A negative zero changes no number that it is added to.
        let [time, x, turns, rest] =
            [start.time, start.x, turns, rest].map(|from| if from == 0.0 { -0.0 } else { from });
        let until = limits.until.map(|until| [until - start.time, until]);
        let seen = State { time: 0.0, theta, x: 0.0, ..start };
        (
            Self { time, x, turns: [turns, rest], until },
            seen,
            limits.with_until(until.map(|[elapsed, _]| elapsed)),
        )
    }

    /// The time at which so much has passed since the start.
    pub(crate) const fn time(&self, elapsed: f64) -> f64 {
        match self.until {
            // The difference may have lost digits of a limit that is close to zero.
            Some([most, until]) if elapsed == most => until,
            Some(_) | None => self.time + elapsed,
        }
    }

    /// What has passed since the start.
    pub(crate) const fn elapsed(&self, time: f64) -> f64 {
        time - self.time
    }

    pub(crate) const fn theta(&self, theta: f64) -> f64 {
        let [turns, rest] = self.turns;
        turns + (rest + theta)
    }

    /// A state that is seen from the origin.
    pub(crate) const fn state(&self, state: State) -> State {
        let State { time, theta, theta_rate, slip, x } = state;
        State { time: self.time(time), theta: self.theta(theta), theta_rate, slip, x: self.x + x }
    }

    pub(crate) fn sample(&self, sample: Sample) -> Sample {
        let moved = |position: Position| Position { x: self.x + position.x, ..position };
        Sample {
            state: self.state(sample.state),
            centre: moved(sample.centre),
            mass_centre: moved(sample.mass_centre),
            particle: moved(sample.particle),
            ..sample
        }
    }

    pub(crate) const fn outcome(&self, mut outcome: Outcome) -> Outcome {
        let (state, recurrence, _) = outcome.parts_mut();
        *state = self.state(*state);
        if let Some(recurrence) = recurrence {
            *recurrence = self.recurrence(*recurrence);
        }
        outcome
    }

    pub(crate) const fn recurrence(&self, recurrence: Recurrence) -> Recurrence {
        match recurrence {
            Recurrence::Libration { period, theta_min, theta_max } => {
                let (theta_min, theta_max) = (self.theta(theta_min), self.theta(theta_max));
                Recurrence::Libration { period, theta_min, theta_max }
            }
            Recurrence::Asymptotic { theta } => Recurrence::Asymptotic { theta: self.theta(theta) },
            Recurrence::Rest | Recurrence::Rotation { .. } => recurrence,
        }
    }
}
