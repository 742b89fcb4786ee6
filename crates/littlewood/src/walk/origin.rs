//! The origin of a motion: τ, x and the whole turns of its start.
//!
//! The equations depend neither on τ nor on x, and on θ only through its sine and cosine. So each motion is simulated from τ = 0, x = 0 and
//! |θ| ≤ π, and the origin is added to the results. Each result is the rounded sum of two numbers; nothing else depends on the origin.

use crate::math::trig::without_turns;
use crate::model::{Limits, State};
use crate::modes::{Position, Recurrence, Sample};
use crate::walk::Outcome;

/// The τ, x and whole turns of a start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Origin {
    time: f64,
    x: f64,
    /// Whole turns as an unevaluated sum, which restores θ of the start exactly.
    turns: [f64; 2],
    /// The time limit relative to the start, and as given.
    until: Option<[f64; 2]>,
}

impl Origin {
    /// The origin of a motion, and its start and limits relative to it.
    pub(crate) fn of(start: State, limits: Limits) -> (Self, State, Limits) {
        let theta = without_turns(start.theta);
        let turns = start.theta - theta;
        let rest = (start.theta - turns) - theta;
        // Adding a negative zero leaves every number unchanged.
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

    /// The time after `elapsed`.
    pub(crate) const fn time(&self, elapsed: f64) -> f64 {
        match self.until {
            // The difference may have lost digits of a limit near zero.
            Some([most, until]) if elapsed == most => until,
            Some(_) | None => self.time + elapsed,
        }
    }

    pub(crate) const fn elapsed(&self, time: f64) -> f64 {
        time - self.time
    }

    pub(crate) const fn theta(&self, theta: f64) -> f64 {
        let [turns, rest] = self.turns;
        turns + (rest + theta)
    }

    /// The absolute state from one relative to the origin.
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
