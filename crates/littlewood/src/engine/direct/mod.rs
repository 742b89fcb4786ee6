//! Phases of a hoop without tables: what tables would hold is computed where the motion goes.
//!
//! A slide is followed in the angle, where u = θ′² obeys a linear equation ([`step`]), and not in time.

mod cell;
mod expansion;
mod memory;
mod roll;
mod slide;
mod step;
mod turn;

use crate::mechanics::equations::{RollingLaw, SlidingLaw};
use crate::model::hoop::{Body, Heavy, Hoop};
use crate::model::mode::Direction;
use crate::modes::rolling::margin_forms;

use super::orbit::Orbit;
use super::piece::Waypoint;
use super::roll::RollEnd;
use super::slide::{SlideEnd, SlideStart};
use super::slip::Ahead;
use super::solver::{Phases, Place};
pub(super) use memory::Memory;
use roll::Margins;
use slide::Frame;

/// The equations of one hoop.
#[derive(Clone, Debug)]
pub(super) struct Direct {
    body: Heavy,
    /// The laws of sliding for σ = −1 and σ = +1.
    sliding: [SlidingLaw; 2],
    rolling: RollingLaw,
    /// Of rolling.
    margins: Margins,
}

impl Direct {
    /// None for a massless hoop.
    pub(super) fn new(hoop: &Hoop) -> Option<Self> {
        let Body::Heavy(body) = hoop.body() else { return None };
        Some(Self {
            body,
            sliding: Direction::ALL.map(|direction| SlidingLaw::of_body(body, hoop.mu_k(), direction)),
            rolling: RollingLaw::new(hoop),
            margins: margin_forms(hoop)?,
        })
    }
}

impl Direct {
    /// A slide from a place in the frame of motion.
    fn seen(&self, place: &Place, direction: Direction, from_limit: bool) -> (Frame<'_>, Waypoint) {
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
        (frame, here)
    }

    /// The slide out of η′ = η″ = 0 at a place, behind its first step, with the time since: in the frame with σ = +1. None where an event
    /// ends it before.
    pub(super) fn leave_limit(&self, place: &Place, direction: Direction) -> Option<(SlideStart, f64)> {
        let (frame, here) = self.seen(place, direction, true);
        let (behind, at, rate) = slide::leave_limit(frame, &here)?;
        let (sin, cos) = at.direction;
        let start = SlideStart {
            theta: behind.sigma * behind.theta,
            theta_rate: behind.sigma * rate,
            slip: at.slip,
            direction: (behind.sigma * sin, cos),
        };
        Some((start, at.elapsed))
    }
}

impl Phases for Direct {
    fn is_solvable(&self) -> bool {
        false
    }

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

    fn roll(&self, place: &Place, on_limit: bool, memory: &Memory) -> Option<RollEnd> {
        let (state, travel) = (place.state, place.travel());
        if state.theta_rate == 0.0 {
            // Gravity decides where it goes.
            return None;
        }
        let orbit = Orbit::enter(&self.rolling, travel * state.theta, travel * state.theta_rate)?;
        roll::follow(&orbit, &self.margins, on_limit, memory)
    }

    fn slide(
        &self,
        place: &Place,
        direction: Direction,
        slip_acceleration: Option<f64>,
        allowed: f64,
        memory: &Memory,
    ) -> Option<(SlideEnd, Ahead)> {
        // On the static limit with equal coefficients.
        let from_limit = slip_acceleration == Some(0.0);
        let (frame, here) = self.seen(place, direction, from_limit);
        let end = slide::follow(frame, here, from_limit, allowed, memory)?;
        // Without kinetic friction a slide that is cut may be known to last for ever, which the exact solver tells.
        let is_known = self.sliding(direction).friction > 0.0 || !matches!(end, SlideEnd::Cut(_));
        is_known.then_some((end, Ahead::Open))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::trig::sincos;
    use crate::model::limits::Limits;
    use crate::model::mode::Mode;
    use crate::model::proof::Proof;
    use crate::model::state::Start;
    use crate::walk::automaton::Cause;
    use crate::walk::transition::Transition;

    /// With equal coefficients, where η″ = 0 at the start, too.
    #[test]
    fn the_limit_is_left_along_the_slide() {
        let hoop = Hoop::figure_2(0.5, 0.5).unwrap();
        let direct = Direct::new(&hoop).unwrap();
        let (mut slips, mut near) = (0, 0);
        let grid =
            (-6..6).flat_map(|i| (-5..5).map(move |j| (0.5 * f64::from(i) + 0.2, 0.4 * f64::from(j) + 0.1)));
        for (theta, theta_rate) in grid {
            let limits = Limits::default().with_transitions(6).with_proof(Proof::None);
            let motion = hoop.simulate(Start::at(theta, theta_rate), limits).unwrap();
            let leaves = |slip: &&Transition| {
                slip.cause == Cause::Slip
                    && slip.to == Some(Mode::Sliding)
                    && slip.before.theta_rate.abs() > 0.1
            };
            for slip in motion.transitions().iter().filter(leaves) {
                let (state, direction) = (slip.after, slip.direction.unwrap());
                let place = Place { state, direction: sincos(state.theta), slip: None, ahead: Ahead::Open };
                let Some((start, elapsed)) = direct.leave_limit(&place, direction) else {
                    near += 1;
                    continue;
                };
                // The last transition is behind the limit of them, and no slide follows.
                let Some(sample) = motion.at(state.time + elapsed) else { continue };
                let (there, sigma) = (sample.state, direction.sign());
                let (sin, cos) = sincos(there.theta);
                assert_eq!(sample.mode, Mode::Sliding);
                for (found, expected) in [
                    (start.slip, sigma * there.slip),
                    (start.theta_rate, sigma * there.theta_rate),
                    (start.direction.0, sigma * sin),
                    (start.direction.1, cos),
                ] {
                    assert!((found - expected).abs() < 1e-12, "{state:?}: {found} {expected}");
                }
                slips += 1;
            }
        }
        // A slide that ends within the first step is followed otherwise.
        assert!(slips > 20 && near < slips, "{slips} {near}");
    }
}
