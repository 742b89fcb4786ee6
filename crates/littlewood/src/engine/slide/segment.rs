//! A segment of a slide, on which u = θ′² is a polynomial: where contact, or the slip, ends on it.

use crate::engine::fallback::Fallback;
use crate::engine::quadrature::{SHORT_NODE, SHORT_NODES, SHORT_WEIGHT};
use crate::math::bracket::{Bracket, RootStep, last_digit};
use crate::math::trig::Angle;
use crate::mechanics::{SlidingLaw, contact};
use crate::model::Heavy;

/// A slower end of slip is left to the Taylor series: η′ comes from the first integral to ε (1 +
/// |θ′|), so that below this part of 1 + |θ′| in η″ the time of η′ = 0 is not known to 2e-13.
const MIN_SLIP_ACCELERATION: f64 = 2e-3;

/// Rounding of η′ by light hoops, which amplify it by (Î/m)^(−1/2) at each passage of the bottom,
/// as a part of that.
const AMPLIFICATION_PART: f64 = 0.1;

/// Newton's method for the point at a time ends with a shorter step: its error is of the second
/// order.
const MAX_LAST_STEP: f64 = 1e-8;

/// The same for the point at which η′ vanishes.
const MAX_LAST_STEP_TO_REST: f64 = 1e-7;

/// The same for the point at which the normal force vanishes.
const MAX_LAST_STEP_TO_LIFT_OFF: f64 = 1e-9;

/// Newton's method for a guess ends with a shorter step, as a part of the way: a cubic differs by as
/// much from η′.
const MAX_LAST_STEP_OF_GUESS: f64 = 1e-2;

/// A step, as a part of the way between two points, whose time the shortest Gauss sum tells to
/// rounding. On the ellipses about segments ([`RegularSegment`], [`TurningSegment`]) u has no zero,
/// so that 1/√u has no singularity within 0.3 of the way around it: four nodes leave out r⁻⁸ of the
/// step, r > 60.
///
/// [`RegularSegment`]: super::regular::RegularSegment
/// [`TurningSegment`]: super::turning::TurningSegment
const MAX_SHORT_STEP: f64 = 0.02;

/// Where dτ/dz changes in a step, the time of the step must be so short beside the inverse of that
/// part: Newton's method takes it for fixed.
const MAX_TIME_ERROR: f64 = 1e-14;

/// The point of a minimum of η′ is known to this: the value to the second order.
const MINIMUM_TOLERANCE: f64 = 1e-7;

/// A number within this part of its terms of zero may have either sign in the simulation: rounding,
/// as much as passages of the bottom of a light hoop and a small P amplify it. It is part of the
/// assumption that the documentation of [`crate::Engine`] states.
pub(in crate::engine) const SIGN_TOLERANCE: f64 = 1e-9;

/// Where η″ vanishes at an end of a segment its sign is evaluated so far inside, as a part of the
/// segment.
const ENDPOINT_OFFSET: f64 = 1e-6;

/// A part of a slide on which u is known as a function of a coordinate z, which grows with time.
pub(super) trait SlideSegment {
    fn u(&self, z: f64) -> f64;
    /// The same at several coordinates, side by side.
    fn u_at<const N: usize>(&self, z: [f64; N]) -> [f64; N];
    /// θ′ at z, from u there.
    fn theta_rate(&self, z: f64, u: f64) -> f64;
    fn angle(&self, z: f64) -> Angle;
    /// dϑ/dz.
    fn theta_slope(&self, z: f64) -> f64;
    /// dτ/dz at z, from u there.
    fn time_slope(&self, z: f64, u: f64) -> f64;
    /// Time from one coordinate to another.
    fn time(&self, from: f64, to: f64) -> f64;
    #[inline]
    fn coefficients(&self, law: &SlidingLaw, z: f64) -> LocalCoefficients {
        LocalCoefficients::new(law, self.angle(z))
    }

    /// The longest step from z, at most `max_step`, that may be the last of Newton's method, of
    /// which the error of the time is of the second order.
    #[inline]
    fn last_step(&self, z: f64, u: f64, step: f64, max_step: f64) -> f64 {
        if step.abs() >= max_step {
            return last_digit(z);
        }
        let (start, end) = (
            self.time_slope(z, u),
            self.time_slope(z + step, self.u(z + step)),
        );
        let is_last =
            (0.5 * step * (start + end) * (end - start)).abs() < MAX_TIME_ERROR * start.abs();
        if is_last { max_step } else { last_digit(z) }
    }

    /// The coordinate at a time between those of two others.
    fn at_time(
        &self,
        start: TimedCoordinate,
        end: TimedCoordinate,
        elapsed: f64,
    ) -> TimedCoordinate {
        let (low, high) = (start.z, end.z);
        let guess = low + (elapsed - start.elapsed) / (end.elapsed - start.elapsed) * (high - low);
        let z = Bracket { low, high }.iterate(guess, |z| {
            let u = self.u(z);
            let value = elapsed - (start.elapsed + self.time(start.z, z));
            let step = value / self.time_slope(z, u);
            RootStep {
                value,
                step,
                last: self.last_step(z, u, step, MAX_LAST_STEP),
            }
        });
        TimedCoordinate { z, elapsed }
    }
}

/// A coordinate of a segment, and the time there.
#[derive(Clone, Copy, Debug)]
pub(super) struct TimedCoordinate {
    pub(super) z: f64,
    pub(super) elapsed: f64,
}

/// The equations of a slide at an angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct LocalCoefficients {
    pub(super) angle: Angle,
    /// 1 + h cos ϑ + μk σ h sin ϑ, the coefficient of θ′ in the first integral.
    pub(super) slip_coefficient: f64,
    /// η″ = α + β u.
    pub(super) alpha: f64,
    pub(super) beta: f64,
}

impl LocalCoefficients {
    #[inline]
    pub(super) fn new(law: &SlidingLaw, angle: Angle) -> Self {
        let (alpha, beta) = law.slip_acceleration(angle.sin, angle.cos);
        Self {
            angle,
            slip_coefficient: law.slip_coefficient(angle.sin, angle.cos),
            alpha,
            beta,
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(in crate::engine) struct SlidePoint {
    /// The coordinate on its segment.
    pub(in crate::engine) z: f64,
    pub(in crate::engine) u: f64,
    pub(in crate::engine) elapsed: f64,
    /// σ η′ and σ η″.
    pub(in crate::engine) slip: f64,
    pub(in crate::engine) slip_acceleration: f64,
    pub(in crate::engine) angle: Angle,
}

/// The size of the terms of η′ where u is this, in the first integral with this constant.
pub(in crate::engine) fn slip_scale(u: f64, integral: f64) -> f64 {
    1.0 + u.sqrt() + integral.abs()
}

/// A segment, and the slide that passes it.
#[derive(Clone, Copy, Debug)]
pub(super) struct SegmentContext<'a, S> {
    pub(super) law: &'a SlidingLaw,
    pub(super) segment: &'a S,
    /// Sign of η′.
    pub(super) sigma: f64,
    /// The constant of the first integral, η′ − θ′ (1 + h cos ϑ + μk σ h sin ϑ) + (μk σ + tan α) τ.
    pub(super) integral: f64,
}

/// A coordinate and a value there.
#[derive(Clone, Copy, Debug)]
pub(super) struct ValueAt {
    pub(super) z: f64,
    pub(super) value: f64,
}

/// The zero of a function that falls from one value to another, by secants; a step that is not longer
/// than `last` ends there.
pub(super) fn falling_zero(
    low: ValueAt,
    high: ValueAt,
    last: f64,
    function: impl Fn(f64) -> f64,
) -> f64 {
    let secant = (low.z * high.value - high.z * low.value) / (high.value - low.value);
    let bracket = Bracket {
        low: low.z,
        high: high.z,
    };
    let mut before = high;
    bracket.iterate(secant, |z| {
        let value = function(z);
        let step = value * (before.z - z) / (value - before.value);
        before = ValueAt { z, value };
        RootStep { value, step, last }
    })
}

impl<S: SlideSegment> SegmentContext<'_, S> {
    /// The size of the terms of η′ at a point, in the first integral.
    pub(super) fn slip_scale(&self, point: &SlidePoint) -> f64 {
        slip_scale(point.u, self.integral)
    }

    /// w = 1 − h cos ϑ u.
    pub(super) fn contact_margin(&self, angle: Angle, u: f64) -> f64 {
        contact(1.0, self.law.body.h, angle.cos * u)
    }

    /// The point at z, behind `start`.
    #[inline]
    pub(super) fn point(&self, start: &SlidePoint, z: f64) -> SlidePoint {
        let elapsed = start.elapsed + self.segment.time(start.z, z);
        self.point_at(z, self.segment.u(z), elapsed)
    }

    /// The same a short step from another point.
    fn point_beside(&self, other: &SlidePoint, z: f64) -> SlidePoint {
        let (middle, half) = (0.5 * (other.z + z), 0.5 * (z - other.z));
        let [a, b, c, d] = SHORT_NODE.map(|node| middle + half * node);
        let at = [a, b, c, d, z];
        let u = self.segment.u_at(at);
        let mut sum = 0.0;
        for j in 0..SHORT_NODES {
            sum += SHORT_WEIGHT[j] * self.segment.time_slope(at[j], u[j]);
        }
        self.point_at(z, u[SHORT_NODES], other.elapsed + half * sum)
    }

    /// The same where z differs so little that the trapezoidal rule tells the time.
    fn point_next_to(&self, other: &SlidePoint, z: f64) -> SlidePoint {
        let u = self.segment.u(z);
        let slopes = self.segment.time_slope(other.z, other.u) + self.segment.time_slope(z, u);
        self.point_at(z, u, other.elapsed + 0.5 * (z - other.z) * slopes)
    }

    /// The point at z, where u and the time are known.
    #[inline]
    pub(super) fn point_at(&self, z: f64, u: f64, elapsed: f64) -> SlidePoint {
        let local = self.segment.coefficients(self.law, z);
        let rate = self.segment.theta_rate(z, u);
        SlidePoint {
            z,
            u,
            elapsed,
            slip: self.sigma
                * (self.integral + rate * local.slip_coefficient
                    - self.law.mean_slip_loss() * elapsed),
            slip_acceleration: self.sigma * (local.alpha + local.beta * u),
            angle: local.angle,
        }
    }

    /// σ η″.
    fn slip_acceleration(&self, z: f64) -> f64 {
        let local = self.segment.coefficients(self.law, z);
        self.sigma * (local.alpha + local.beta * self.segment.u(z))
    }

    /// Where w falls through zero between `start` and `end`, where it is `w_end`.
    pub(super) fn lift_off(&self, start: &SlidePoint, end: f64, w_end: f64) -> SlidePoint {
        let h = self.law.body.h;
        let w_start = self.contact_margin(start.angle, start.u);
        let guess = start.z + (end - start.z) * w_start / (w_start - w_end);
        let z = Bracket {
            low: start.z,
            high: end,
        }
        .iterate(guess, |z| {
            let Angle { sin, cos } = self.segment.angle(z);
            let u = self.segment.u(z);
            let value = contact(1.0, h, cos * u);
            // dw/dϑ = h sin ϑ u − h cos ϑ du/dϑ with du/dϑ = a w.
            let slope = self.segment.theta_slope(z)
                * (h * sin * u - h * cos * self.law.u_growth(sin, cos) * value);
            RootStep {
                value,
                step: -value / slope,
                last: MAX_LAST_STEP_TO_LIFT_OFF,
            }
        });
        self.point(start, z)
    }

    /// Where η′ is least between two points, between which η″ changes its sign at most once; none
    /// where it is so at one of them.
    pub(super) fn min_slip(&self, start: &SlidePoint, end: &SlidePoint) -> Option<SlidePoint> {
        // Falls where η″ rises, as a bracket has it.
        let falling = |z: f64| -self.slip_acceleration(z);
        // At a zero of η″ rounding would decide whether the minimum is this end.
        let inside = |point: &SlidePoint, other: &SlidePoint| {
            if point.slip_acceleration.abs() > SIGN_TOLERANCE * (1.0 + point.u) {
                return ValueAt {
                    z: point.z,
                    value: -point.slip_acceleration,
                };
            }
            let z = point.z + ENDPOINT_OFFSET * (other.z - point.z);
            ValueAt {
                z,
                value: falling(z),
            }
        };
        let (low, high) = (inside(start, end), inside(end, start));
        if low.value < 0.0 || high.value > 0.0 {
            return None;
        }
        let z = falling_zero(low, high, MINIMUM_TOLERANCE, falling);
        Some(self.point(start, z))
    }

    /// Where the slide is at a time between those of two points.
    pub(super) fn at_time(&self, start: &SlidePoint, end: &SlidePoint, elapsed: f64) -> SlidePoint {
        let [start, end] = [start, end].map(|point| TimedCoordinate {
            z: point.z,
            elapsed: point.elapsed,
        });
        let z = self.segment.at_time(start, end, elapsed).z;
        self.point_at(z, self.segment.u(z), elapsed)
    }

    /// Where η′ falls through zero between two points: a cubic for a guess, then Newton's method
    /// with the exact time.
    pub(super) fn rest(
        &self,
        start: &SlidePoint,
        end: &SlidePoint,
    ) -> Result<SlidePoint, Fallback> {
        let width = end.z - start.z;
        let slope = |point: &SlidePoint| {
            point.slip_acceleration * self.segment.time_slope(point.z, point.u)
        };
        let part = Cubic {
            start: start.slip,
            start_slope: slope(start) * width,
            end: end.slip,
            end_slope: slope(end) * width,
        }
        .root();
        // A long Gauss sum gives the time from the start, a short one that from a point close by.
        let mut near = *start;
        let z = Bracket {
            low: start.z,
            high: end.z,
        }
        .iterate(start.z + part * width, |z| {
            near = if (z - near.z).abs() <= MAX_SHORT_STEP * width {
                self.point_beside(&near, z)
            } else {
                self.point(start, z)
            };
            let step = -near.slip / slope(&near);
            RootStep {
                value: near.slip,
                step,
                last: self
                    .segment
                    .last_step(z, near.u, step, MAX_LAST_STEP_TO_REST),
            }
        });
        let point = self.point_next_to(&near, z);
        let Heavy { mass, inertia, .. } = self.law.body;
        let amplified = (AMPLIFICATION_PART * (mass / inertia).sqrt()).max(1.0);
        if point.slip_acceleration.abs()
            < MIN_SLIP_ACCELERATION * amplified * (1.0 + point.u.sqrt())
        {
            return Err(Fallback::SlowStop);
        }
        Ok(SlidePoint { slip: 0.0, ..point })
    }
}

/// The cubic on [0, 1] with these values and slopes at its ends.
struct Cubic {
    start: f64,
    start_slope: f64,
    end: f64,
    end_slope: f64,
}

impl Cubic {
    /// Its root in (0, 1], to the digits that it shares with the function, where the value at 1 is not
    /// positive.
    fn root(&self) -> f64 {
        let Self {
            start,
            start_slope,
            end,
            end_slope,
        } = *self;
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
            if (next - s).abs() < MAX_LAST_STEP_OF_GUESS {
                return next;
            }
            s = next;
        }
        s
    }
}

#[cfg(test)]
mod tests {
    use core::cell::Cell;

    use super::*;
    use crate::engine::slide::regular::RegularSegment;
    use crate::engine::slide::series::{Expansion, SignPattern};
    use crate::model::{Body, Hoop, SlipDirection};

    /// A segment that counts the angles it is asked for: one for each evaluation of η′.
    struct Counted {
        segment: RegularSegment,
        angles: Cell<u32>,
    }

    impl SlideSegment for Counted {
        fn u(&self, z: f64) -> f64 {
            self.segment.u(z)
        }
        fn u_at<const N: usize>(&self, z: [f64; N]) -> [f64; N] {
            self.segment.u_at(z)
        }
        fn theta_rate(&self, z: f64, u: f64) -> f64 {
            self.segment.theta_rate(z, u)
        }
        fn angle(&self, z: f64) -> Angle {
            self.angles.set(self.angles.get() + 1);
            self.segment.angle(z)
        }
        fn theta_slope(&self, z: f64) -> f64 {
            self.segment.theta_slope(z)
        }
        fn time_slope(&self, z: f64, u: f64) -> f64 {
            self.segment.time_slope(z, u)
        }
        fn time(&self, from: f64, to: f64) -> f64 {
            self.segment.time(from, to)
        }
    }

    /// Segments of slides of the Figure 2 hoop, with their laws and the signs of η′.
    fn segments() -> impl Iterator<Item = (SlidingLaw, f64, Counted)> {
        let Body::Heavy(body) = Hoop::equal_masses(0.5, 0.4).unwrap().body() else {
            unreachable!("it has mass")
        };
        SlipDirection::ALL.into_iter().flat_map(move |direction| {
            let (law, sigma) = (SlidingLaw::of_body(body, 0.4, direction), direction.sign());
            (0..500).filter_map(move |k| {
                let angle = Angle::of(0.4 * f64::from(k));
                let u = 0.3 + 0.05 * f64::from(k % 97);
                let expansion = Expansion::new(&law, sigma, angle, u);
                let segment = RegularSegment::new(&expansion, angle, false).ok()?;
                let angles = Cell::new(0);
                Some((law, sigma, Counted { segment, angles }))
            })
        })
    }

    /// The point at z = 0 of a slide.
    fn first(context: &SegmentContext<'_, Counted>) -> SlidePoint {
        context.point_at(0.0, context.segment.u(0.0), 0.0)
    }

    /// The constant of the first integral puts the end of slip where it is to be found.
    #[test]
    fn the_end_of_slip_is_found_in_few_evaluations() {
        let (mut ends, mut evaluations) = (0, 0);
        for (law, sigma, segment) in segments() {
            for part in [0.2, 0.5, 0.8, 0.95] {
                let mut context = SegmentContext {
                    law: &law,
                    segment: &segment,
                    sigma,
                    integral: 0.0,
                };
                let expected = context.point(&first(&context), part);
                context.integral = -sigma * expected.slip;
                let (start, end) = (first(&context), context.point(&first(&context), 1.0));
                let is_monotone = segment.segment.signs.pattern == SignPattern::Negative;
                if !is_monotone || expected.slip_acceleration > -0.05 {
                    continue;
                }
                segment.angles.set(0);
                let found = context.rest(&start, &end).unwrap();
                // η′ is known to ε of its terms, and the time of its zero to that over η″.
                let known = (1.0 + start.slip) / expected.slip_acceleration.abs();
                let tolerance = 2e-15 * (1.0 + known);
                let error = (found.elapsed - expected.elapsed).abs();
                assert!(error < tolerance, "{sigma} {part}: {error:e} {tolerance:e}");
                ends += 1;
                evaluations += segment.angles.get();
            }
        }
        assert!(ends > 100, "{ends}");
        let mean = f64::from(evaluations) / f64::from(ends);
        // It is 3.23. A last step that is not known for the last would cost one more.
        assert!(mean < 3.3, "{mean} evaluations for each of {ends}");
    }

    /// Compared with many values between the ends. Where it is at an end there is none, also where
    /// η″ vanishes there.
    #[test]
    fn the_least_slip_is_below_all_values_between() {
        let mut found = 0;
        for (law, sigma, segment) in segments() {
            if segment.segment.signs.pattern != SignPattern::Rising {
                continue;
            }
            let context = SegmentContext {
                law: &law,
                segment: &segment,
                sigma,
                integral: 0.0,
            };
            let start = first(&context);
            let end = context.point(&start, 1.0);
            let values = (0..=400).map(|k| context.point(&start, f64::from(k) / 400.0));
            let lowest = values.min_by(|a, b| a.slip.total_cmp(&b.slip)).unwrap();
            let Some(min) = context.min_slip(&start, &end) else {
                assert!(lowest.z == 0.0 || lowest.z == 1.0, "{}", lowest.z);
                continue;
            };
            let size = context.slip_scale(&min);
            assert!(
                (min.z - lowest.z).abs() <= 1.0 / 400.0 && min.slip <= lowest.slip + 1e-14 * size
            );
            assert!(
                min.slip_acceleration.abs() < 1e-6,
                "{}",
                min.slip_acceleration
            );
            let before = context.point(&start, 0.5 * min.z);
            let behind = context.point(&start, 0.5 * (min.z + 1.0));
            for (from, to) in [
                (&start, &before),
                (&behind, &end),
                (&start, &min),
                (&min, &end),
            ] {
                let there = context.min_slip(from, to);
                assert!(there.is_none(), "{} {}: {there:?}", from.z, to.z);
            }
            found += 1;
        }
        assert!(found > 10, "{found}");
    }
}
