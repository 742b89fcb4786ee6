//! Phases looked up in the tables of a hoop.

use crate::equations::{RollingLaw, SlidingLaw};
use crate::hoop::Heavy;
use crate::mode::Direction;

use super::Tables;
use super::roll::RollEnd;
use super::slide::{SlideEvent, SlideStart};
use super::slip::Ahead;
use super::solver::{Phases, Place};

impl Phases for Tables {
    const SOLVABLE: bool = true;

    const SLOW_SLIDES: bool = false;

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
        self.roll.law()
    }

    fn denominator(&self, (_, cos): (f64, f64)) -> f64 {
        self.roll.law().denominator_at(cos)
    }

    #[inline(always)]
    fn roll(&self, place: &Place) -> Option<RollEnd> {
        let (state, travel) = (place.state, place.travel());
        let ahead = match &place.ahead {
            Ahead::Roll(ahead) => Some(ahead),
            Ahead::Open => None,
        };
        self.roll.follow(travel * state.theta, travel * state.theta_rate, place.direction.1, ahead)
    }

    #[inline(always)]
    fn slide(
        &self,
        place: &Place,
        direction: Direction,
        slip_acceleration: Option<f64>,
        _: f64,
    ) -> Option<(SlideEvent, Ahead)> {
        let (state, travel, sigma) = (place.state, place.travel(), direction.sign());
        let (sin, cos) = place.direction;
        let known = place.slip.and_then(|point| {
            self.slip.follow(point, travel * state.theta, travel * state.theta_rate, (travel * sin, cos))
        });
        let ahead = known.map_or(Ahead::Open, |end| end.ahead);
        let event = match (known, slip_acceleration) {
            (Some(end), _) => end.event,
            // η″ = 0 at the start, too: on the static limit with equal coefficients.
            (None, Some(0.0)) => return None,
            (None, Some(_) | None) => self.slide.follow(SlideStart {
                theta: sigma * state.theta,
                theta_rate: sigma * state.theta_rate,
                slip: sigma * state.slip,
                direction: (sigma * sin, cos),
            })?,
        };
        Some((event.mirrored(sigma), ahead))
    }
}
