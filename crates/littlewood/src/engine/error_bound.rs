//! By how much the state of a motion may differ from that of the simulation, which rounds at other
//! places.
//!
//! A decision by a number that is nearer to zero than that may be another one in the simulation.
//! Such a motion is simulated.

use core::cell::Cell;

use crate::math::trig::sincos;
use crate::model::{Heavy, State};
use crate::modes::Flight;

/// Rounding of the evidence at a state, as a part of its terms: a few products and sums of numbers
/// that are known to the last digit.
const SIGN_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Rounding of a phase, as a part of the numbers at its end.
const PHASE_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Light hoops amplify rounding by (Î/m)^(−1/2) at each passage of the bottom; this part of it is
/// in PHASE_ROUNDING.
const AMPLIFICATION_PART: f64 = 0.1;

/// A state that is known to no more than this is lost: impacts and slides decide by numbers that
/// are not looked at. Chosen: there is no bound on how near to zero these are.
const MAX_DRIFT: f64 = 1e-4;

/// Beyond this angle phases are those of the simulation: whole turns of it are not taken off to the
/// last digits.
const MAX_ANGLE: f64 = 1e5;

/// How far a motion has drifted from the simulation.
#[derive(Clone, Debug)]
pub(super) struct Drift {
    h: f64,
    phase: f64,
    /// Where 1 − h cos θ θ′² is a smaller part of its terms, the rounding of N, times the
    /// coefficient of friction, is as large as F: rolling and slipping cannot be told apart.
    contact: f64,
    /// By how much of the closing rate an impact changes the rates of slip and rotation, at most.
    impact: f64,
    /// |tan α|: by how much slip changes in flight, over time.
    pull: f64,
    lost: Cell<Lost>,
    is_told: Cell<bool>,
}

/// Bounds on the differences of a state from that of the simulation: zero where it is the same to
/// the last bit.
#[derive(Clone, Copy, Debug, Default)]
struct Lost {
    theta: f64,
    /// Of θ′ and η′, as a part of 1 + |θ′|.
    rate: f64,
    gap_rate: f64,
}

impl Drift {
    pub(super) fn new(body: &Heavy, mu_s: f64) -> Self {
        let amplification = (body.mass / body.inertia).sqrt();
        let phase = PHASE_ROUNDING * (AMPLIFICATION_PART * amplification).max(1.0);
        Self {
            h: body.h,
            phase,
            contact: phase * (1.0 + mu_s),
            impact: 1.0 + amplification,
            pull: body.tilt.abs(),
            lost: Cell::default(),
            is_told: Cell::new(false),
        }
    }

    /// Whether a decision may be another one.
    pub(super) const fn is_told(&self) -> bool {
        self.is_told.get()
    }

    fn largest(&self) -> f64 {
        let Lost { theta, rate, .. } = self.lost.get();
        theta.max(rate)
    }

    /// Whether the state is that of the simulation to the last bit.
    pub(super) fn is_none(&self) -> bool {
        self.largest() == 0.0
    }

    /// Whether the phase from an angle is solved as in the simulation.
    pub(super) const fn is_far(&self, theta: f64) -> bool {
        theta.abs() > MAX_ANGLE
    }

    /// Whether 1 − h cos θ θ′², with terms of this size, is far enough from zero to compare forces.
    #[inline(always)]
    pub(super) fn is_known(&self, number: f64, size: f64) -> bool {
        self.exceeds(number, self.contact * size, size)
    }

    /// Whether the sign of a number with terms of this size is known.
    #[inline(always)]
    pub(super) fn is_clear(&self, number: f64, size: f64) -> bool {
        self.exceeds(number, SIGN_ROUNDING * size, size)
    }

    /// Whether a number with terms of this size is larger than a bound and what is lost.
    #[inline(always)]
    fn exceeds(&self, number: f64, bound: f64, size: f64) -> bool {
        let lost = self.largest();
        let is_clear = number.abs() > bound + 2.0 * lost * size;
        if !is_clear && lost > 0.0 {
            self.is_told.set(true);
        }
        is_clear
    }

    /// Takes note of a phase in contact, or several, that lead to an angle. Friction makes motions
    /// in contact forget, and amplifies nothing.
    #[inline(always)]
    pub(super) fn add_phase(&self, theta: f64) {
        let lost = self.largest().max(self.phase + f64::EPSILON * theta.abs());
        self.lost.set(Lost {
            theta: lost,
            rate: lost,
            gap_rate: 0.0,
        });
    }

    /// Takes note of a flight and of the impact behind it: how its end moves with the angle and the
    /// rates of its start.
    pub(super) fn add_flight(
        &self,
        flight: &Flight,
        start: &State,
        (sin, cos): (f64, f64),
        coefficient: f64,
    ) {
        let Lost {
            theta,
            rate,
            gap_rate,
        } = self.lost.get();
        let (h, time, turns) = (self.h, flight.duration(), start.theta_rate);
        let (end_sin, end_cos) = sincos(flight.state(time).theta);
        let closes = flight.landing_rate();
        let scale = 1.0 + turns.abs();
        let (risen, falls) = (h * (end_sin - sin), h * end_cos * (turns * turns) - 1.0);
        // What the gap, its rate, and the angle at a time change by, with the angle, the rate, and
        // the rate of the gap at the start.
        let changes = [
            (
                theta,
                [
                    risen - h * cos * turns * time,
                    h * turns * (end_cos - cos),
                    1.0,
                ],
            ),
            (
                rate * scale,
                [risen * time, risen + h * end_cos * turns * time, time],
            ),
            (gap_rate, [time, 1.0, 0.0]),
        ];
        let (mut turned, mut closing, mut late) = (0.0, 0.0, 0.0);
        for (lost, [gap, rate, angle]) in changes {
            let later = -gap / closes;
            turned += lost * (angle + turns * later).abs();
            closing += lost * (rate + falls * later).abs();
            late += lost * later.abs();
        }
        let rounding = self.phase + f64::EPSILON * flight.state(time).theta.abs();
        let lost = Lost {
            theta: turned + rounding,
            // Impulses are as large as the closing rate, or as the slip that they stop, and change
            // with the angle by as much.
            rate: rate
                + (self.impact * (closing + (closes.abs() + start.slip.abs()) * turned)
                    + self.pull * late)
                    / scale
                + rounding,
            gap_rate: coefficient * closing + closes.abs() * turned + rounding * scale,
        };
        self.lost.set(lost);
        // No number is not known either.
        let is_known = lost.theta < MAX_DRIFT && lost.rate < MAX_DRIFT;
        if !is_known {
            self.is_told.set(true);
        }
    }
}
