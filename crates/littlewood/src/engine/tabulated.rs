//! Phases looked up in the tables of a hoop, and computed directly where these do not resolve them.

use crate::ablation::{Part, is_on};
use crate::mechanics::equations::{RollingLaw, SlidingLaw};
use crate::model::hoop::Heavy;
use crate::model::mode::Direction;

use super::Tables;
use super::direct::Memory;
use super::roll::RollEnd;
use super::slide::{SlideEnd, SlideEvent, SlideStart, Unknown};
use super::slip::Ahead;
use super::solver::{MIN_RATE, Phases, Place};

impl Tables {
    #[inline(always)]
    fn known_roll(&self, place: &Place, on_limit: bool) -> Option<RollEnd> {
        let (state, travel) = (place.state, place.travel());
        if state.theta_rate.abs() < MIN_RATE || !is_on(Part::RollTables) {
            return None;
        }
        let ahead = match &place.ahead {
            Ahead::Roll(ahead) => Some(ahead),
            Ahead::Open => None,
        };
        let (theta, theta_rate) = (travel * state.theta, travel * state.theta_rate);
        self.roll.follow((theta, theta_rate), place.direction.1, on_limit, ahead)
    }

    #[inline(always)]
    fn known_slide(
        &self,
        place: &Place,
        direction: Direction,
        slip_acceleration: Option<f64>,
        allowed: f64,
    ) -> Result<(SlideEnd, Ahead), Unknown> {
        let (state, travel, sigma) = (place.state, place.travel(), direction.sign());
        let (sin, cos) = place.direction;
        let known = place.slip.filter(|_| is_on(Part::Families)).and_then(|point| {
            self.slip.follow(point, travel * state.theta, travel * state.theta_rate, (travel * sin, cos))
        });
        let known =
            known.filter(|end| end.event.theta_rate.abs() >= MIN_RATE && end.event.elapsed <= allowed);
        let ahead = known.map_or(Ahead::Open, |end| end.ahead);
        let end = match (known, slip_acceleration) {
            (Some(end), _) => SlideEnd::Event(end.event),
            // η″ = 0 at the start, too: on the static limit with equal coefficients. The tables go on from where the slip has its sign.
            (None, Some(0.0)) => {
                let left = self.direct.leave_limit(place, direction);
                let (start, elapsed) =
                    left.filter(|(_, elapsed)| *elapsed <= allowed).ok_or(Unknown::Doubt)?;
                let end = self.slide.follow(start, allowed - elapsed)?;
                end.map(|event| SlideEvent { elapsed: elapsed + event.elapsed, ..event })
            }
            (None, Some(_) | None) if !is_on(Part::SlideTables) => return Err(Unknown::Doubt),
            (None, Some(_) | None) => {
                let start = SlideStart {
                    theta: sigma * state.theta,
                    theta_rate: sigma * state.theta_rate,
                    slip: sigma * state.slip,
                    direction: (sigma * sin, cos),
                };
                self.slide.follow(start, allowed)?
            }
        };
        Ok((end.map(|event| event.mirrored(sigma)), ahead))
    }
}

impl Phases for Tables {
    fn is_solvable(&self) -> bool {
        self.is_solvable
    }

    fn body(&self) -> &Heavy {
        self.direct.body()
    }

    fn sliding(&self, direction: Direction) -> &SlidingLaw {
        self.direct.sliding(direction)
    }

    fn rolling(&self) -> &RollingLaw {
        self.roll.law()
    }

    fn denominator(&self, (_, cos): (f64, f64)) -> f64 {
        self.roll.law().denominator_at(cos)
    }

    #[inline(always)]
    fn roll(&self, place: &Place, on_limit: bool, memory: &Memory) -> Option<RollEnd> {
        self.known_roll(place, on_limit).or_else(|| self.direct.roll(place, on_limit, memory))
    }

    #[inline(always)]
    fn slide(
        &self,
        place: &Place,
        direction: Direction,
        slip_acceleration: Option<f64>,
        allowed: f64,
        memory: &Memory,
    ) -> Option<(SlideEnd, Ahead)> {
        match self.known_slide(place, direction, slip_acceleration, allowed) {
            Ok(known) => Some(known),
            // Computed directly a slide would take as many turns.
            Err(Unknown::Long) => None,
            Err(Unknown::Doubt) => self.direct.slide(place, direction, slip_acceleration, allowed, memory),
        }
    }
}
