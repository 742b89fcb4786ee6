//! Where a motion starts in time, along the plane and in whole turns.
//!
//! The laws know no instant and no place, and of the angle its sine and cosine alone. So a motion is followed from τ = 0, x = 0 and |θ| ≤ π, and
//! what its start has beyond that is added to what leaves the core: such a number is the rounded sum of two, and nothing else depends on the origin.

use crate::model::{Limits, State};
use crate::modes::{Position, Recurrence, Sample};
use crate::walk::Outcome;

/// 2π in parts, of which the first two have 25 bits: their products with a number of turns up to 2²⁸ are exact.
const TURN: [f64; 3] = [6.283_185_243_606_567, 6.357_301_884_918_343e-8, 2.449_293_598_294_706_4e-16];

/// Angles in radians up to 1e9 without the whole turns.
fn without_turns(theta: f64) -> f64 {
    let turns = (theta / core::f64::consts::TAU).round_ties_even();
    // No turn must not make a positive zero of a negative one.
    if turns == 0.0 { theta } else { TURN.iter().fold(theta, |rest, part| rest - turns * part) }
}

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

#[cfg(test)]
mod tests {
    use super::*;

    /// θ − 2πk from 60 digits of π (mpmath).
    #[test]
    fn whole_turns_are_taken_off_exactly() {
        for (theta, expected) in [
            (1000000000.0, 0.5773954235013852),
            (999999999.4, -0.02260460034047274),
            (3.15, -3.1331853071795868),
            (core::f64::consts::TAU, -2.4492935982947064e-16),
            (31568288.730131123, 1.2337193930378547),
            (12.566370614359172, -4.898587196589413e-16),
            (679789.1632611979, -1.2214931759634842),
            (6776582.185939262, -2.8138572161744166),
            (19038202.888674572, 0.6114730527750171),
            (328535560.1235775, 2.3570234414263056),
            (6533532.079460616, -0.4630982336969978),
            (222602466.42574126, -0.7784590662441263),
        ] {
            assert_eq!(without_turns(theta), expected, "{theta}");
            assert_eq!(without_turns(-theta), -expected, "{theta}");
        }
    }
}
