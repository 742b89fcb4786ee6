//! By how much the state of a motion may differ from that of the simulation, which rounds at other
//! places.
//!
//! A decision by a number that is nearer to zero than that may be another one in the simulation.
//! Such a motion is simulated up to there, where its state is that of the simulation.

use core::num::NonZeroU32;

use crate::math::trig::{Angle, sincos};
use crate::model::{Heavy, State};
use crate::modes::Flight;
use crate::walk::StateDifference;

use super::slide::SIGN_TOLERANCE;

/// Rounding of the evidence at a state, as a part of its terms: a few products and sums of numbers
/// that are known to the last digit.
const SIGN_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Rounding of a phase, as a part of the numbers at its end.
const PHASE_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Light hoops amplify rounding by (Î/m)^(−1/2) at each passage of the bottom; this part of it is
/// in PHASE_ROUNDING.
const AMPLIFICATION_PART: f64 = 0.1;

/// A state that is known to no more than this is lost: impacts and slides decide by numbers that
/// are not compared with the error. That these are larger is an assumption, which the documentation
/// of [`crate::Engine`] states.
const MAX_ERROR: f64 = 1e-4;

/// Beyond this angle phases are those of the simulation: θ is rounded to ε/2 of itself, and here by
/// a quarter of the distance at which a slide is left to it.
const MAX_ANGLE: f64 = 0.5 * SIGN_TOLERANCE / f64::EPSILON;

/// Whether phases from an angle are solved by the simulation.
pub(super) const fn is_out_of_range(theta: f64) -> bool {
    theta.abs() > MAX_ANGLE
}

/// How the errors of a hoop grow.
#[derive(Clone, Copy, Debug)]
pub(super) struct ErrorModel {
    h: f64,
    phase: f64,
    /// Where 1 − h cos θ θ′² is a smaller part of its terms, the rounding of N, times the
    /// coefficient of friction, is as large as F: rolling and slipping cannot be told apart.
    contact: f64,
    /// By how much of the closing rate an impact changes the rates of slip and rotation, at most.
    impact: f64,
    /// |tan α|: by how much slip changes in flight, over time.
    pull: f64,
}

/// Bounds on the difference of a state from that of the simulation.
#[derive(Clone, Copy, Debug)]
pub(super) struct StateError {
    theta: f64,
    /// Of θ′ and η′, as a part of 1 + |θ′|.
    rate: f64,
    gap_rate: f64,
}

/// What is known of a motion's difference from the simulation.
#[derive(Clone, Copy, Debug)]
pub(super) enum ErrorBound {
    /// The state is equal to the last bit.
    Exact,
    Within(StateError),
    /// The next phases, so many, are those of the simulation.
    Simulated(NonZeroU32),
    /// A decision may have been another one, or the error is too large.
    Lost,
}

/// What the rounding of θ′² moves a turning point by.
#[derive(Clone, Copy, Debug)]
pub(super) struct TurningPointError {
    /// The size of θ′² on the way.
    pub(super) u: f64,
    /// dθ′²/dθ at the turning point.
    pub(super) u_slope: f64,
}

/// A number by whose sign a motion is decided.
#[derive(Clone, Copy, Debug)]
pub(super) struct DecisiveNumber {
    pub(super) value: f64,
    /// The size of its terms.
    pub(super) scale: f64,
}

impl StateError {
    const NONE: Self = Self {
        theta: 0.0,
        rate: 0.0,
        gap_rate: 0.0,
    };
}

impl ErrorBound {
    /// That of a motion of which so many phases are those of the simulation.
    pub(super) fn behind_simulated(phases: u32) -> Self {
        NonZeroU32::new(phases).map_or(Self::Exact, Self::Simulated)
    }

    pub(super) const fn is_exact(&self) -> bool {
        matches!(self, Self::Exact)
    }

    pub(super) const fn is_simulated(&self) -> bool {
        matches!(self, Self::Simulated(_))
    }

    pub(super) const fn is_lost(&self) -> bool {
        matches!(self, Self::Lost)
    }

    /// By how much the state may differ from that of the simulation; none where it does not, or
    /// what it decides is discarded.
    pub(super) fn difference(&self) -> Option<StateDifference> {
        match self {
            Self::Exact | Self::Simulated(_) | Self::Lost => None,
            Self::Within(error) => Some(StateDifference {
                theta: 2.0 * error.theta,
                rate: 2.0 * error.rate,
            }),
        }
    }

    fn max(&self) -> f64 {
        match self {
            // A lost motion is discarded, whatever it decides.
            Self::Exact | Self::Simulated(_) | Self::Lost => 0.0,
            Self::Within(error) => error.theta.max(error.rate),
        }
    }

    /// Whether the sign of a number is certain.
    #[inline(always)]
    pub(super) fn sign_is_certain(&self, number: DecisiveNumber) -> bool {
        self.exceeds(number, SIGN_ROUNDING * number.scale)
    }

    /// The same with a bound on the rounding of the number.
    #[inline(always)]
    fn exceeds(&self, number: DecisiveNumber, rounding: f64) -> bool {
        match self {
            Self::Exact => number.value.abs() > rounding,
            Self::Within(error) => {
                let difference = 2.0 * error.theta.max(error.rate) * number.scale;
                number.value.abs() > rounding + difference
            }
            // It decides itself; and a lost motion is discarded, whatever it decides.
            Self::Simulated(_) | Self::Lost => false,
        }
    }

    /// Whether 1 − h cos θ θ′² is far enough from zero to compare forces.
    #[inline(always)]
    pub(super) fn resolves_forces(
        &self,
        model: &ErrorModel,
        contact_margin: DecisiveNumber,
    ) -> bool {
        self.exceeds(contact_margin, model.contact * contact_margin.scale)
    }

    /// That behind a decision by a number whose sign is not certain: unless the state is that of
    /// the simulation, the motion is lost.
    pub(super) const fn behind_doubt(self) -> Self {
        match self {
            Self::Exact | Self::Simulated(_) => self,
            Self::Within(_) | Self::Lost => Self::Lost,
        }
    }

    /// Adds the error of one phase in contact, or several, that lead to an angle. Friction makes
    /// motions in contact forget, and amplifies nothing.
    #[inline(always)]
    pub(super) fn add_phase(&mut self, model: &ErrorModel, theta: f64) {
        if self.is_lost() {
            return;
        }
        let error = self.max().max(model.phase + f64::EPSILON * theta.abs());
        *self = Self::Within(StateError {
            theta: error,
            rate: error,
            gap_rate: 0.0,
        });
    }

    /// Adds the error of a turning point at the end of a phase, whose own is added.
    pub(super) fn add_turning_point(&mut self, turn: TurningPointError) {
        if let Self::Within(error) = *self {
            let theta = error.theta * (1.0 + turn.u / turn.u_slope.abs());
            *self = if theta < MAX_ERROR {
                Self::Within(StateError { theta, ..error })
            } else {
                Self::Lost
            };
        }
    }

    /// Adds the error of a flight and of the impact behind it: how its end moves with the angle and
    /// the rates of its start.
    pub(super) fn add_flight(
        &mut self,
        model: &ErrorModel,
        flight: &Flight,
        start: &State,
        angle: Angle,
        restitution: f64,
    ) {
        let error = match self {
            Self::Lost => return,
            Self::Exact | Self::Simulated(_) => StateError::NONE,
            Self::Within(error) => *error,
        };
        let ErrorModel { h, .. } = *model;
        let Angle { sin, cos } = angle;
        let (time, turns) = (flight.duration(), start.theta_rate);
        let (end_sin, end_cos) = sincos(flight.state(time).theta);
        let closes = flight.landing_rate();
        let scale = 1.0 + turns.abs();
        let (risen, falls) = (h * (end_sin - sin), h * end_cos * (turns * turns) - 1.0);
        // What the gap, its rate, and the angle at a time change by, with the angle, the rate, and
        // the rate of the gap at the start.
        let changes = [
            Change {
                error: error.theta,
                gap: risen - h * cos * turns * time,
                gap_rate: h * turns * (end_cos - cos),
                angle: 1.0,
            },
            Change {
                error: error.rate * scale,
                gap: risen * time,
                gap_rate: risen + h * end_cos * turns * time,
                angle: time,
            },
            Change {
                error: error.gap_rate,
                gap: time,
                gap_rate: 1.0,
                angle: 0.0,
            },
        ];
        // The gap closes later by −gap/closing rate; angle and rate change until then.
        let (mut turned, mut closing, mut late) = (0.0, 0.0, 0.0);
        for change in changes {
            let later = -change.gap / closes;
            turned += change.error * (change.angle + turns * later).abs();
            closing += change.error * (change.gap_rate + falls * later).abs();
            late += change.error * later.abs();
        }
        let rounding = model.phase + f64::EPSILON * flight.state(time).theta.abs();
        let error = StateError {
            theta: turned + rounding,
            // Impulses are as large as the closing rate, or as the slip that they stop, and change
            // with the angle by as much.
            rate: error.rate
                + (model.impact * (closing + (closes.abs() + start.slip.abs()) * turned)
                    + model.pull * late)
                    / scale
                + rounding,
            gap_rate: restitution * closing + closes.abs() * turned + rounding * scale,
        };
        // NaN is lost, too.
        let is_within = error.theta < MAX_ERROR && error.rate < MAX_ERROR;
        *self = if is_within {
            Self::Within(error)
        } else {
            Self::Lost
        };
    }
}

/// What the end of a flight changes by with a number of its start that has this error.
struct Change {
    error: f64,
    gap: f64,
    gap_rate: f64,
    angle: f64,
}

impl ErrorModel {
    pub(super) fn new(body: &Heavy, mu_s: f64, chi: f64) -> Self {
        let amplification = (body.mass / body.inertia).sqrt();
        let phase = PHASE_ROUNDING * (AMPLIFICATION_PART * amplification).max(1.0);
        Self {
            h: body.h,
            phase,
            contact: phase * (1.0 + mu_s),
            impact: (1.0 + amplification) * (1.0 + chi),
            pull: body.tilt.abs(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::number::Number as _;
    use crate::model::{Hoop, Start};
    use crate::modes::TakeOff;

    /// The state at the end of a phase is rounded, also where the one at its start is exact.
    #[test]
    fn a_flight_from_an_exact_state_has_the_rounding_of_a_phase() {
        let hoop = Hoop::equal_masses(0.5, 0.4).expect("a hoop");
        let body = hoop.rigid_body();
        let model = ErrorModel::new(&body, hoop.mu_s(), 0.0);
        for (theta, theta_rate) in [(0.5, 1.0), (-2.0, -0.3), (1.0, 0.0)] {
            let start = Start::at(theta, theta_rate).state();
            let flight = Flight::new(&body, start, TakeOff::Rising { gap_rate: 0.5 });
            let mut bound = ErrorBound::Exact;
            bound.add_flight(&model, &flight, &start, theta.angle(), 0.5);
            let ErrorBound::Within(error) = bound else {
                panic!("{bound:?}");
            };
            assert!(error.theta >= model.phase, "{error:?}");
            assert!(error.rate >= model.phase, "{error:?}");
            assert!(error.gap_rate >= model.phase, "{error:?}");
        }
    }
}
