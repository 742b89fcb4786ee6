//! Sliding of one body, followed in the angle; and rolling with resistance ([`rolling`]), which has
//! the same kind of equation.
//!
//! u = θ′² obeys the linear equation du/dϑ = a(ϑ) (1 − h cos ϑ u), a = 2 m q/P, whatever the
//! motion. About any angle a slide is therefore a power series ([`series`]); about a fixed angle
//! all slides are u = p + u_c h, with two series that belong to the body and one number u_c that
//! belongs to the slide ([`table`]). The time is a Gauss sum of dϑ/√u, and η′ follows from it by
//! the first integral of sliding.

mod order;
mod regular;
mod rolling;
mod segment;
mod series;
mod solve;
mod table;
mod turning;

use core::f64::consts::TAU;

use crate::math::trig::Angle;

use super::fallback::Fallback;

pub(super) use order::{SingleFall, SlideStrip, StripSide};
pub(super) use rolling::{ResistedRollEnd, RollStart, RollStop, RollTables};
pub(super) use segment::{SIGN_TOLERANCE, SlidePoint, slip_scale};
pub(super) use solve::{MotionFrame, SlideLaws, SlideProblem, solve_slide};
pub(super) use table::SlideTables;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlideEvent {
    pub(super) elapsed: f64,
    pub(super) theta: f64,
    pub(super) theta_rate: f64,
    pub(super) slip: f64,
    pub(super) angle: Angle,
    pub(super) lifts_off: bool,
    /// How many turning points are on the way.
    pub(super) turning_points: f64,
}

/// Where a slide ends, or is cut by a time limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum SlideEnd {
    Event(SlideEvent),
    /// At θ′ = 0, with rolling resistance.
    Turn(SlideEvent),
    /// Not an event: where it is then.
    Cut(SlideEvent),
    /// Never: a whole period in which η′ does not fall has passed without an event.
    Never,
}

/// Why a motion is followed no further: it ends, or is left to the simulation.
enum Stop<E> {
    End(E),
    Left(Fallback),
}

impl<E> From<Fallback> for Stop<E> {
    fn from(reason: Fallback) -> Self {
        Self::Left(reason)
    }
}

impl<E> Stop<E> {
    fn into_result(self) -> Result<E, Fallback> {
        match self {
            Self::End(end) => Ok(end),
            Self::Left(reason) => Err(reason),
        }
    }
}

impl SlideEvent {
    /// Whether a whole period has passed since the start: the way from the first turning point to
    /// the third, or, if energy is conserved, a turn.
    pub(super) fn is_behind_a_period(&self, start: f64, is_conservative: bool) -> bool {
        let is_behind_a_turn = is_conservative && (self.theta - start).abs() >= TAU;
        is_behind_a_turn || self.turning_points >= 3.0
    }

    /// The same in the frame that is mirrored for −1.
    #[inline]
    pub(super) fn mirrored_by(self, mirror: f64) -> Self {
        Self {
            theta: mirror * self.theta,
            theta_rate: mirror * self.theta_rate,
            // Adding zero makes −0 a 0.
            slip: mirror * self.slip + 0.0,
            angle: self.angle.mirrored_by(mirror),
            ..self
        }
    }
}
