//! Phases of a hoop without tables: what tables would hold is computed where the motion goes.
//!
//! A slide is followed in the angle, where u = θ′² obeys a linear equation ([`step`]), and not in time.

mod expansion;
mod roll;
mod slide;
mod step;
mod turn;

use crate::equations::{RollingLaw, SlidingLaw};
use crate::hoop::{Heavy, Hoop};
use crate::mode::Direction;

use super::piece::Waypoint;
use super::roll::RollEnd;
use super::slide::SlideEnd;
use super::slip::Ahead;
use super::solver::{Phases, Place};
use slide::Frame;

/// The equations of one hoop.
#[derive(Clone, Debug)]
pub(super) struct Direct {
    hoop: Hoop,
    body: Heavy,
    /// The laws of sliding for σ = −1 and σ = +1.
    sliding: [SlidingLaw; 2],
    rolling: RollingLaw,
}

impl Direct {
    pub(super) fn new(hoop: &Hoop, body: Heavy) -> Self {
        Self {
            hoop: *hoop,
            body,
            sliding: Direction::ALL.map(|direction| SlidingLaw::of_body(body, hoop.mu_k(), direction)),
            rolling: RollingLaw::new(hoop),
        }
    }
}

impl Phases for Direct {
    const SOLVABLE: bool = false;

    fn body(&self) -> &Heavy {
        &self.body
    }

    fn sliding(&self, direction: Direction) -> &SlidingLaw {
        match direction {
            Direction::Negative => &self.sliding[0],
            Direction::Positive => &self.sliding[1],
        }
    }

    fn rolling(&self) -> &RollingLaw {
        &self.rolling
    }

    fn denominator(&self, direction: (f64, f64)) -> f64 {
        self.rolling.denominator_of(direction)
    }

    fn roll(&self, place: &Place) -> Option<RollEnd> {
        let (state, travel) = (place.state, place.travel());
        if state.theta_rate == 0.0 {
            // Gravity decides where it goes.
            return None;
        }
        roll::follow(&self.hoop, &self.rolling, travel * state.theta, travel * state.theta_rate)
    }

    fn slide(
        &self,
        place: &Place,
        direction: Direction,
        slip_acceleration: Option<f64>,
        allowed: f64,
    ) -> Option<(SlideEnd, Ahead)> {
        // On the static limit with equal coefficients.
        let from_limit = slip_acceleration == Some(0.0);
        let (state, sign) = (place.state, place.travel());
        let (sin, cos) = place.direction;
        let law = self.sliding(direction);
        let u = state.theta_rate * state.theta_rate;
        let (alpha, beta) = law.slip_acceleration(sin, cos);
        let sigma = direction.sign();
        let frame = Frame {
            laws: &self.sliding,
            sign,
            theta: sign * state.theta,
            sigma: sign * sigma,
            integral: sign * (state.slip - state.theta_rate * law.lever(sin, cos)),
        };
        let here = Waypoint {
            z: 0.0,
            u,
            elapsed: 0.0,
            slip: sigma * state.slip,
            slip_acceleration: if from_limit { 0.0 } else { sigma * (alpha + beta * u) },
            direction: (sign * sin, cos),
        };
        Some((slide::follow(frame, here, from_limit, allowed)?, Ahead::Open))
    }
}
