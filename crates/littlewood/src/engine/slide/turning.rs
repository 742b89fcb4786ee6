//! A slide about a turning point, at which θ′ changes its sign.
//!
//! Friction does not depend on the sign of θ′, so that u is the same function of the angle before
//! and behind the turning point. There u = z v(z), z ≥ 0 being the tangent of half the angle from
//! the turning point, and with z = width · y², y going from negative to positive through the
//! turning point, dτ/dy = 4 √width/((1 + z²) √v) has no singularity.

use crate::engine::quadrature::{LONG_NODE, LONG_WEIGHT, PAIRS};

use super::regular::rotated;
use super::segment::SlideSegment;
use super::series::{DEGREE, Expansion, Series, SignPattern, scaled, value};

/// Up to this multiple of the width v has no zero: the terms of its series are at most the part
/// `MAX_TERM_RATIO` of the first. The Gauss sum of 1/√v in y is then exact to rounding: r = 2.9 and
/// r⁻³² = 1e-15 at least.
const ELLIPSE_FACTOR: f64 = 2.8;
const MAX_TERM_RATIO: f64 = 0.9;

/// A turn, with the coordinate y from −1 to 1, in the frame of motion before the turning point.
#[derive(Clone, Debug)]
pub(super) struct TurningSegment {
    /// z at y = ± 1.
    pub(super) width: f64,
    /// u/width in powers of y², without its factor y².
    v: Series,
    /// SignPattern of σ η″ by the distance from the turning point.
    pub(super) signs: SignPattern,
    /// Largest |η″| where its sign is not known, about a change of sign.
    pub(super) doubt: f64,
    /// sin ϑ and cos ϑ at the turning point.
    direction: (f64, f64),
}

impl TurningSegment {
    /// From the expansion about the turning point in the frame of motion behind it, the sine and
    /// cosine of whose angle these are.
    pub(super) fn new(expansion: &Expansion, (sin, cos): (f64, f64)) -> Option<Self> {
        if expansion.u[1] <= 0.0 {
            return None;
        }
        let width =
            expansion.smooth((1, 2), (expansion.reach(1), ELLIPSE_FACTOR), MAX_TERM_RATIO)?;
        let u = scaled(expansion.u, width);
        let (signs, doubt) = expansion.signs(&u, width, false)?;
        let mut v = [0.0; DEGREE + 1];
        v[..DEGREE].copy_from_slice(&u[1..]);
        Some(Self {
            width,
            v: v.map(|c| c / width),
            signs,
            doubt,
            direction: (-sin, cos),
        })
    }

    /// Angle from the turning point at y, back in the frame of motion before it.
    pub(super) fn turned_by(&self, y: f64) -> f64 {
        -2.0 * libm::atan(self.width * y * y)
    }

    /// dτ/dy from v.
    fn slowness_of(&self, y: f64, v: f64) -> f64 {
        let z = self.width * y * y;
        // u = width y² v.
        4.0 / ((1.0 + z * z) * (v / self.width).sqrt())
    }
}

impl SlideSegment for TurningSegment {
    fn u(&self, y: f64) -> f64 {
        let square = y * y;
        self.width * square * value(&self.v, square)
    }

    fn rate(&self, y: f64, u: f64) -> f64 {
        if y > 0.0 { -u.sqrt() } else { u.sqrt() }
    }

    fn direction(&self, y: f64) -> (f64, f64) {
        rotated(self.direction, -self.width * y * y)
    }

    fn turning(&self, y: f64) -> f64 {
        let z = self.width * y * y;
        -4.0 * self.width * y / (1.0 + z * z)
    }

    fn slowness(&self, y: f64, _: f64) -> f64 {
        self.slowness_of(y, value(&self.v, y * y))
    }

    fn time(&self, from: f64, to: f64) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let mut sum = 0.0;
        for j in 0..PAIRS {
            for y in [middle - half * LONG_NODE[j], middle + half * LONG_NODE[j]] {
                sum += LONG_WEIGHT[j] * self.slowness_of(y, value(&self.v, y * y));
            }
        }
        half * sum
    }
}
