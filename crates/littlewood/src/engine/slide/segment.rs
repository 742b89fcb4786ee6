//! A piece of a slide, on which u = θ′² is a polynomial: where contact, or the slip, ends on it.

use crate::engine::fallback::Fallback;
use crate::math::bracket::{Bracket, Step, last_digit};
use crate::mechanics::{SlidingLaw, contact};
use crate::model::Heavy;

/// A slower end of slip is left to the Taylor series: η′ comes from the first integral to ε (1 +
/// |θ′|), so that below this part of 1 + |θ′| in η″ the time of η′ = 0 is not known to 2e-13.
const MIN_SLIP_ACCELERATION: f64 = 2e-3;

/// Rounding of η′ by light hoops, which amplify it by (Î/m)^(−1/2) at each passage of the bottom,
/// as a part of that.
const AMPLIFICATION_PART: f64 = 0.1;

/// Newton's method for a place at a time ends with a shorter step: its error is of the second
/// order.
const MAX_LAST_STEP: f64 = 1e-8;

/// The same for the place at which η′ vanishes.
const MAX_LAST_STEP_TO_REST: f64 = 1e-7;

/// The same for the place at which the normal force vanishes.
const MAX_LAST_STEP_TO_LIFT_OFF: f64 = 1e-9;

/// A step by which Simpson's rule for the time is exact to rounding, if dτ/dz changes by no more
/// than this part of itself: the error is the fourth power of that over 2880.
const MAX_SIMPSON_STEP: f64 = 1e-3;

/// Where dτ/dz changes in a step, the time of the step must be so short beside the inverse of that
/// part: Newton's method takes it for fixed.
const MAX_TIME_ERROR: f64 = 1e-14;

/// The place of a minimum of η′ is known to this: the value to the second order.
const MINIMUM_TOLERANCE: f64 = 1e-7;

/// A number within this part of its terms of zero may have either sign in the simulation: rounding,
/// as much as passages of the bottom of a light hoop and a small P amplify it. Chosen: with 1e-12 a
/// fast motion of the tests that lifts off, with m̂1 = Î = 0.007 and μs = 25, ends elsewhere by
/// 7e-8 of its angle.
pub(super) const SIGN_TOLERANCE: f64 = 1e-9;

/// Where η″ vanishes at an end of a way its sign is told so far inside, as a part of the way.
const ENDPOINT_OFFSET: f64 = 1e-6;

/// A part of a slide on which u is known as a function of a coordinate z, which grows with time.
pub(super) trait SlideSegment {
    fn u(&self, z: f64) -> f64;
    /// θ′ at z, from u there.
    fn rate(&self, z: f64, u: f64) -> f64;
    /// sin ϑ and cos ϑ at z.
    fn direction(&self, z: f64) -> (f64, f64);
    /// dϑ/dz.
    fn turning(&self, z: f64) -> f64;
    /// dτ/dz at z, from u there.
    fn slowness(&self, z: f64, u: f64) -> f64;
    /// Time from one place to another.
    fn time(&self, from: f64, to: f64) -> f64;
    #[inline]
    fn law_at(&self, law: &SlidingLaw, z: f64) -> LawAt {
        LawAt::new(law, self.direction(z))
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) struct LawAt {
    /// sin ϑ and cos ϑ.
    pub(super) direction: (f64, f64),
    /// 1 + h cos ϑ + μk σ h sin ϑ.
    pub(super) lever: f64,
    /// η″ = α + β u.
    pub(super) alpha: f64,
    pub(super) beta: f64,
}

impl LawAt {
    #[inline]
    pub(super) fn new(law: &SlidingLaw, (sin, cos): (f64, f64)) -> Self {
        let (alpha, beta) = law.slip_acceleration(sin, cos);
        Self {
            direction: (sin, cos),
            lever: law.lever(sin, cos),
            alpha,
            beta,
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(in crate::engine) struct SlidePoint {
    pub(in crate::engine) z: f64,
    pub(in crate::engine) u: f64,
    pub(in crate::engine) elapsed: f64,
    /// σ η′ and σ η″.
    pub(in crate::engine) slip: f64,
    pub(in crate::engine) slip_acceleration: f64,
    /// sin ϑ and cos ϑ.
    pub(in crate::engine) direction: (f64, f64),
}

/// The size of the terms of η′ where u is this, in the first integral with this constant.
pub(super) fn slip_scale(u: f64, integral: f64) -> f64 {
    1.0 + u.sqrt() + integral.abs()
}

#[derive(Clone, Copy, Debug)]
pub(super) struct SegmentContext<'a, P> {
    pub(super) law: &'a SlidingLaw,
    pub(super) piece: &'a P,
    /// Sign of η′.
    pub(super) sigma: f64,
    /// The constant of the first integral, η′ − θ′ (1 + h cos ϑ + μk σ h sin ϑ) + (μk σ + tan α) τ.
    pub(super) integral: f64,
}

impl<P: SlideSegment> SegmentContext<'_, P> {
    /// The size of the terms of η′ at a waypoint, in the first integral.
    pub(super) fn slip_scale(&self, at: &SlidePoint) -> f64 {
        slip_scale(at.u, self.integral)
    }

    /// Everything at z, from the way since `here`.
    #[inline]
    pub(super) fn at(&self, here: &SlidePoint, z: f64) -> SlidePoint {
        self.waypoint(
            z,
            self.piece.u(z),
            here.elapsed + self.piece.time(here.z, z),
        )
    }

    /// The same a short step away; none if it is longer.
    fn beside(&self, here: &SlidePoint, z: f64) -> Option<SlidePoint> {
        let (middle, u) = (0.5 * (here.z + z), self.piece.u(z));
        let (first, last) = (
            self.piece.slowness(here.z, here.u),
            self.piece.slowness(z, u),
        );
        if !((z - here.z).abs() <= MAX_SIMPSON_STEP
            && (last - first).abs() <= MAX_SIMPSON_STEP * first.abs())
        {
            return None;
        }
        let sum = first + 4.0 * self.piece.slowness(middle, self.piece.u(middle)) + last;
        Some(self.waypoint(z, u, here.elapsed + (z - here.z) / 6.0 * sum))
    }

    /// Everything at z, where u and the time are known.
    #[inline]
    pub(super) fn waypoint(&self, z: f64, u: f64, elapsed: f64) -> SlidePoint {
        let (there, rate) = (self.piece.law_at(self.law, z), self.piece.rate(z, u));
        SlidePoint {
            z,
            u,
            elapsed,
            slip: self.sigma * (self.integral + rate * there.lever - self.law.drag() * elapsed),
            slip_acceleration: self.sigma * (there.alpha + there.beta * u),
            direction: there.direction,
        }
    }

    /// σ η″.
    fn slip_acceleration(&self, z: f64) -> f64 {
        let there = self.piece.law_at(self.law, z);
        self.sigma * (there.alpha + there.beta * self.piece.u(z))
    }

    /// Where w = 1 − h cos ϑ u falls through zero between `here` and `end`, where it is given.
    pub(super) fn lift_off(&self, here: &SlidePoint, (end, w_end): (f64, f64)) -> SlidePoint {
        let h = self.law.body.h;
        let w_here = contact(1.0, h, here.direction.1 * here.u);
        let guess = here.z + (end - here.z) * w_here / (w_here - w_end);
        let z = Bracket {
            low: here.z,
            high: end,
        }
        .iterate(guess, |z| {
            let (sin, cos) = self.piece.direction(z);
            let u = self.piece.u(z);
            let value = contact(1.0, h, cos * u);
            let slope =
                self.piece.turning(z) * (h * sin * u - h * cos * self.law.drive(sin, cos) * value);
            Step {
                value,
                step: -value / slope,
                last: MAX_LAST_STEP_TO_LIFT_OFF,
            }
        });
        self.at(here, z)
    }

    /// Where η′ is least between two waypoints, between which η″ changes its sign at most once;
    /// none where it is so at one of them.
    pub(super) fn least(&self, here: &SlidePoint, there: &SlidePoint) -> Option<SlidePoint> {
        // Falls where η″ rises, as a bracket has it.
        let falling = |z: f64| -self.slip_acceleration(z);
        let inside = |at: &SlidePoint, other: &SlidePoint| {
            if at.slip_acceleration.abs() > SIGN_TOLERANCE * (1.0 + at.u) {
                return (at.z, -at.slip_acceleration);
            }
            let z = at.z + ENDPOINT_OFFSET * (other.z - at.z);
            (z, falling(z))
        };
        let ((low, at_low), (high, at_high)) = (inside(here, there), inside(there, here));
        if at_low < 0.0 || at_high > 0.0 {
            return None;
        }
        let mut before = (high, at_high);
        let secant = (low * at_high - high * at_low) / (at_high - at_low);
        let z = Bracket { low, high }.iterate(secant, |z| {
            let value = falling(z);
            let step = value * (before.0 - z) / (value - before.1);
            before = (z, value);
            Step {
                value,
                step,
                last: MINIMUM_TOLERANCE,
            }
        });
        Some(self.at(here, z))
    }

    /// The longest step from z that may be the last of Newton's method, of which the error of the
    /// time is of the second order.
    fn last_step(&self, z: f64, u: f64, step: f64, longest: f64) -> f64 {
        if step.abs() >= longest {
            return last_digit(z);
        }
        let (here, there) = (
            self.piece.slowness(z, u),
            self.piece.slowness(z + step, self.piece.u(z + step)),
        );
        let is_last =
            (0.5 * step * (here + there) * (there - here)).abs() < MAX_TIME_ERROR * here.abs();
        if is_last { longest } else { last_digit(z) }
    }

    /// Where the slide is at a time between those of two waypoints.
    pub(super) fn at_time(
        &self,
        here: &SlidePoint,
        there: &SlidePoint,
        elapsed: f64,
    ) -> SlidePoint {
        let (low, high) = (here.z, there.z);
        let guess = low + (elapsed - here.elapsed) / (there.elapsed - here.elapsed) * (high - low);
        let z = Bracket { low, high }.iterate(guess, |z| {
            let u = self.piece.u(z);
            let value = elapsed - (here.elapsed + self.piece.time(here.z, z));
            let step = value / self.piece.slowness(z, u);
            Step {
                value,
                step,
                last: self.last_step(z, u, step, MAX_LAST_STEP),
            }
        });
        self.waypoint(z, self.piece.u(z), elapsed)
    }

    /// Where η′ falls through zero between two waypoints: a cubic for a guess, then Newton's method
    /// with the exact time.
    pub(super) fn rest(
        &self,
        here: &SlidePoint,
        there: &SlidePoint,
    ) -> Result<SlidePoint, Fallback> {
        let span = there.z - here.z;
        let slope = |at: &SlidePoint| at.slip_acceleration * self.piece.slowness(at.z, at.u);
        let part = cubic_root(
            here.slip,
            slope(here) * span,
            there.slip,
            slope(there) * span,
        );
        let mut near = *here;
        let mut evaluate = |z: f64| {
            self.beside(&near, z).unwrap_or_else(|| {
                near = self.at(here, z);
                near
            })
        };
        let z = Bracket {
            low: here.z,
            high: there.z,
        }
        .iterate(here.z + part * span, |z| {
            let at = evaluate(z);
            let step = -at.slip / slope(&at);
            Step {
                value: at.slip,
                step,
                last: self.last_step(z, at.u, step, MAX_LAST_STEP_TO_REST),
            }
        });
        let at = evaluate(z);
        let Heavy { mass, inertia, .. } = self.law.body;
        let amplified = (AMPLIFICATION_PART * (mass / inertia).sqrt()).max(1.0);
        if at.slip_acceleration.abs() < MIN_SLIP_ACCELERATION * amplified * (1.0 + at.u.sqrt()) {
            return Err(Fallback::SlowStop);
        }
        Ok(SlidePoint { slip: 0.0, ..at })
    }
}

/// Root in (0, 1] of the cubic with these values and slopes at 0 and 1, the value at 1 not
/// positive.
fn cubic_root(start: f64, start_slope: f64, end: f64, end_slope: f64) -> f64 {
    let c2 = 3.0 * (end - start) - 2.0 * start_slope - end_slope;
    let c3 = 2.0 * (start - end) + start_slope + end_slope;
    let mut s = 1.0;
    for _ in 0..8 {
        let value = start + s * (start_slope + s * (c2 + s * c3));
        let slope = start_slope + s * (2.0 * c2 + 3.0 * s * c3);
        if slope >= 0.0 {
            break;
        }
        let next: f64 = s - value / slope;
        if !(next > 0.0 && next <= 1.0) {
            break;
        }
        if (next - s).abs() < 1e-6 {
            return next;
        }
        s = next;
    }
    s
}
