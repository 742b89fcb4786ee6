//! Sliding of one body, followed in the angle.
//!
//! u = θ′² obeys the linear equation du/dϑ = a(ϑ) (1 − h cos ϑ u), a = 2 m q/P, whatever the
//! motion. About any angle a slide is therefore a power series ([`series`]); about a fixed angle
//! all slides are u = p + u_c h, with two series that belong to the body and one number u_c that
//! belongs to the slide ([`cell`]). The time is a Gauss sum of dϑ/√u, and η′ follows from it by the
//! first integral of sliding.

mod regular;
mod segment;
mod series;
mod solve;
mod table;
mod turning;

use core::f64::consts::TAU;

pub(super) use segment::SlidePoint;
pub(super) use solve::{MotionFrame, follow};
pub(super) use table::SlideTables;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlideEvent {
    pub(super) elapsed: f64,
    pub(super) theta: f64,
    pub(super) theta_rate: f64,
    pub(super) slip: f64,
    /// sin ϑ and cos ϑ.
    pub(super) direction: (f64, f64),
    pub(super) lifts_off: bool,
    /// How many turning points are on the way.
    pub(super) turns: f64,
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

impl SlideEvent {
    /// Whether a whole period has passed since the start: the way from the first turning point to
    /// the third, or, if energy is conserved, a turn.
    pub(super) fn is_behind_a_period(&self, start: f64, is_conservative: bool) -> bool {
        let has_turned = is_conservative && (self.theta - start).abs() >= TAU;
        has_turned || self.turns >= 3.0
    }

    /// The same in the frame that is mirrored for −1.
    #[inline]
    fn mirrored(self, sign: f64) -> Self {
        let (sin, cos) = self.direction;
        Self {
            theta: sign * self.theta,
            theta_rate: sign * self.theta_rate,
            // Adding zero makes −0 a 0.
            slip: sign * self.slip + 0.0,
            direction: (sign * sin, cos),
            ..self
        }
    }
}
