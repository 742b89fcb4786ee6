//! Sliding of one body, followed in the angle.
//!
//! u = θ′² obeys the linear equation du/dϑ = a(ϑ) (1 − h cos ϑ u), a = 2 m q/P, whatever the motion. About any angle a slide is therefore a
//! power series ([`series`]); about a fixed angle all slides are u = p + u_c h, with two series that belong to the body and one number u_c
//! that belongs to the slide ([`cell`]). The time is a Gauss sum of dϑ/√u, and η′ follows from it by the first integral of sliding.

mod cell;
mod follow;
mod piece;
mod series;
mod step;
mod turn;

use core::f64::consts::TAU;

pub(super) use cell::Cells;
pub(super) use follow::{Frame, follow};
pub(super) use piece::Waypoint;

/// Turning points on the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turns {
    /// Smallest and largest angle of them.
    low: f64,
    high: f64,
    /// How many they are.
    count: f64,
}

/// The event that ends a slide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlideEvent {
    pub(super) elapsed: f64,
    pub(super) theta: f64,
    pub(super) theta_rate: f64,
    pub(super) slip: f64,
    /// sin ϑ and cos ϑ.
    pub(super) direction: (f64, f64),
    pub(super) lifts_off: bool,
    pub(super) turns: Option<Turns>,
}

/// Where a slide ends, or is cut by a limit of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum SlideEnd {
    Event(SlideEvent),
    /// Not an event: where it is then.
    Cut(SlideEvent),
    /// Never: a whole period in which η′ does not fall has passed without an event.
    Never,
}

impl Turns {
    /// Those so far, and another one.
    fn another(turns: Option<Self>, angle: f64) -> Self {
        turns.map_or(Self { low: angle, high: angle, count: 1.0 }, |Self { low, high, count }| Self {
            low: low.min(angle),
            high: high.max(angle),
            count: count + 1.0,
        })
    }

    /// The same after so many periods of a libration more.
    fn after(self, periods: f64) -> Self {
        Self { count: self.count + 2.0 * periods, ..self }
    }

    /// The same in the frame that is mirrored for −1.
    fn mirrored(self, sign: f64) -> Self {
        if sign < 0.0 { Self { low: -self.high, high: -self.low, ..self } } else { self }
    }
}

impl SlideEvent {
    /// Smallest and largest angle of the slide, with the angle at its start.
    pub(super) fn range_from(&self, start: f64) -> (f64, f64) {
        let (low, high) = self.turns.map_or((start, start), |turns| (turns.low, turns.high));
        (low.min(start).min(self.theta), high.max(start).max(self.theta))
    }

    /// Whether a whole period has passed since the start: the way from the first turning point to the third, or, if energy is conserved, a
    /// turn.
    pub(super) fn is_behind_a_period(&self, start: f64, is_conservative: bool) -> bool {
        let has_turned = is_conservative && (self.theta - start).abs() >= TAU;
        has_turned || self.turns.is_some_and(|turns| turns.count >= 3.0)
    }

    /// The same in the frame that is mirrored for −1.
    #[inline]
    fn mirrored(self, sign: f64) -> Self {
        let (sin, cos) = self.direction;
        Self {
            turns: self.turns.map(|turns| turns.mirrored(sign)),
            theta: sign * self.theta,
            theta_rate: sign * self.theta_rate,
            // Adding zero makes −0 a 0.
            slip: sign * self.slip + 0.0,
            direction: (sign * sin, cos),
            ..self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_range_of_a_slide_has_its_ends_and_its_turning_points() {
        let direction = (0.0, 1.0);
        let event = SlideEvent {
            elapsed: 1.0,
            theta: 2.0,
            theta_rate: 1.0,
            slip: 0.0,
            direction,
            lifts_off: false,
            turns: None,
        };
        assert_eq!(event.range_from(-0.5), (-0.5, 2.0));
        assert_eq!(event.range_from(3.5), (2.0, 3.5));
        let turns =
            [0.5, 2.5, -1.0].into_iter().fold(None, |turns, angle| Some(Turns::another(turns, angle)));
        let event = SlideEvent { turns, ..event };
        assert_eq!(event.range_from(0.5), (-1.0, 2.5));
        assert_eq!(event.mirrored(-1.0).range_from(0.5), (-2.5, 1.0));
        assert_eq!(event.range_from(4.0), (-1.0, 4.0));
    }
}
