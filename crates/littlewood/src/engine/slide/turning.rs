//! A segment of a slide about a turning point, at which θ′ changes its sign.
//!
//! Friction does not depend on the sign of θ′, so that u is the same function of the angle before
//! and behind the turning point. There u = z v(z), z ≥ 0 being the tangent of half the angle from
//! the turning point, and with z = width · y², y going from negative to positive through the
//! turning point, dτ/dy = 4 √width/((1 + z²) √v) has no singularity.

use crate::engine::quadrature::{LONG_NODE, LONG_WEIGHT, PAIRS};
use crate::math::trig::Angle;

use super::segment::SlideSegment;
use super::series::{
    DEGREE, Expansion, Family, Series, Signs, SlipSigns, TermBound, scaled, value,
};

/// Up to this multiple of the width v has no zero: the terms of its series are at most the part
/// `MAX_TERM_RATIO` of the first. The Gauss sum of 1/√v in y is then exact to rounding: r = 2.9 and
/// r⁻³² = 1e-15 at least.
const ELLIPSE_FACTOR: f64 = 2.8;
const MAX_TERM_RATIO: f64 = 0.9;

/// A turning point nearer than this part of the width on which u has converged is the centre of the
/// next segment.
const MAX_TURN_DISTANCE: f64 = 0.7;

/// A turning point behind is the centre of the next segment if it is nearer than this part of the
/// segment.
const MAX_PART_BEHIND_TURN: f64 = 0.5;

/// A segment with the coordinate y from −1 to 1, in the frame of motion before the turning point.
#[derive(Clone, Debug)]
pub(super) struct TurningSegment<S = SlipSigns> {
    /// z at y = ± 1.
    pub(super) width: f64,
    /// u/width in powers of y², without its factor y².
    v: Series,
    /// By the distance from the turning point.
    pub(super) signs: S,
    /// At the turning point.
    angle: Angle,
}

impl<S: Signs> TurningSegment<S> {
    /// From the expansion about the turning point, with its angle, both in the frame of motion
    /// behind it.
    pub(super) fn new(expansion: &Expansion<impl Family<Signs = S>>, angle: Angle) -> Option<Self> {
        if expansion.u[1] <= 0.0 {
            return None;
        }
        let width = expansion.smooth(TermBound {
            lead: 1,
            first: 2,
            max_width: expansion.convergence_radius(1),
            stretch: ELLIPSE_FACTOR,
            max_ratio: MAX_TERM_RATIO,
        })?;
        let u = scaled(expansion.u, width);
        let signs = expansion.family.signs(&u, width, false)?;
        let mut v = [0.0; DEGREE + 1];
        v[..DEGREE].copy_from_slice(&u[1..]);
        Some(Self {
            width,
            v: v.map(|c| c / width),
            signs,
            angle: angle.mirrored(),
        })
    }

    /// Angle from the turning point at y, back in the frame of motion before it.
    pub(super) fn delta_theta(&self, y: f64) -> f64 {
        -2.0 * libm::atan(self.width * y * y)
    }

    /// dτ/dy from v.
    fn time_slope_of(&self, y: f64, v: f64) -> f64 {
        let z = self.width * y * y;
        // u = width y² v.
        4.0 / ((1.0 + z * z) * (v / self.width).sqrt())
    }
}

impl<S: Signs> SlideSegment for TurningSegment<S> {
    fn u(&self, y: f64) -> f64 {
        let square = y * y;
        self.width * square * value(&self.v, square)
    }

    fn u_at<const N: usize>(&self, y: [f64; N]) -> [f64; N] {
        y.map(|y| self.u(y))
    }

    fn theta_rate(&self, y: f64, u: f64) -> f64 {
        if y > 0.0 { -u.sqrt() } else { u.sqrt() }
    }

    fn angle(&self, y: f64) -> Angle {
        self.angle.plus(Angle::of_half_tangent(-self.width * y * y))
    }

    fn theta_slope(&self, y: f64) -> f64 {
        let z = self.width * y * y;
        -4.0 * self.width * y / (1.0 + z * z)
    }

    fn time_slope(&self, y: f64, _: f64) -> f64 {
        self.time_slope_of(y, value(&self.v, y * y))
    }

    fn time(&self, from: f64, to: f64) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let mut sum = 0.0;
        for j in 0..PAIRS {
            for y in [middle - half * LONG_NODE[j], middle + half * LONG_NODE[j]] {
                sum += LONG_WEIGHT[j] * self.time_slope_of(y, value(&self.v, y * y));
            }
        }
        half * sum
    }
}

/// A segment about a turning point, and the point in it at which the motion is.
pub(super) struct TurningPlace<S> {
    pub(super) segment: TurningSegment<S>,
    pub(super) y: f64,
    /// z of the distance from the turning point.
    pub(super) distance: f64,
    /// Whether the motion comes to the turning point. The coordinate does not tell: it is 0 where
    /// θ′² underflows.
    pub(super) is_ahead: bool,
}

/// The segment about the turning point next to the centre of an expansion, ahead or behind, if that
/// is near. `about` gives the expansion about the turning point, with its angle in the frame of
/// motion behind it, if it is ahead or not.
pub(super) fn turning_near<F: Family>(
    angle: Angle,
    expansion: &Expansion<F>,
    about: impl FnOnce(bool, Angle) -> Expansion<F>,
) -> Option<TurningPlace<F::Signs>> {
    let [u, slope, ..] = expansion.u;
    let convergence_radius = expansion.convergence_radius(0);
    if u > MAX_TURN_DISTANCE * convergence_radius * slope.abs() {
        return None;
    }
    let distance = expansion.zero(convergence_radius)?.abs();
    let is_ahead = slope < 0.0;
    // Behind a turning point, the frame before it is mirrored.
    let angle = if is_ahead { angle } else { angle.mirrored() };
    let turning_angle = angle.plus(Angle::of_half_tangent(distance)).mirrored();
    let segment = TurningSegment::new(&about(is_ahead, turning_angle), turning_angle)?;
    let part = distance / segment.width;
    // Behind the turning point a regular segment leads farther than the rest of this one.
    let (y, max_part) = if is_ahead {
        (-part.sqrt(), 1.0)
    } else {
        (part.sqrt(), MAX_PART_BEHIND_TURN)
    };
    (part < max_part).then_some(TurningPlace {
        segment,
        y,
        distance,
        is_ahead,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::SlidingLaw;
    use crate::model::{Body, Hoop, SlipDirection};

    /// The width is as large as the sum of the time allows: the sum over the whole segment is that
    /// over many parts of it, and a width larger by a quarter would break the bound.
    #[test]
    fn segments_about_turning_points_are_as_wide_as_the_time_is_exact() {
        let Body::Heavy(body) = Hoop::equal_masses(0.5, 0.4).unwrap().body() else {
            unreachable!("it has mass")
        };
        let law = SlidingLaw::of_body(body, 0.4, SlipDirection::Positive);
        let (mut bounded, mut worst) = (0, 0.0_f64);
        for k in 1..200 {
            let angle = Angle::of(0.031 * f64::from(k));
            let expansion = Expansion::new(&law, 1.0, angle, 0.0);
            let Some(segment) = TurningSegment::new(&expansion, angle) else {
                continue;
            };
            let parts = 64;
            let at = |part: i32| f64::from(part) / f64::from(parts);
            let sum: f64 = (-parts..parts)
                .map(|part| segment.time(at(part), at(part + 1)))
                .sum();
            worst = worst.max((segment.time(-1.0, 1.0) / sum - 1.0).abs());
            if segment.width < 0.999 * expansion.convergence_radius(1) {
                bounded += 1;
                let far = 2.8 * 1.25 * segment.width;
                let terms: f64 = (2..=DEGREE)
                    .map(|k| expansion.u[k].abs() * libm::pow(far, (k - 1) as f64))
                    .sum();
                assert!(terms > 0.9 * expansion.u[1], "{k}: {terms}");
            }
        }
        assert!(worst < 4e-15, "{worst:e}");
        assert!(bounded > 20, "{bounded}");
    }
}
