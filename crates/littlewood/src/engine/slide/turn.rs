//! A slide about a turning point, at which θ′ changes its sign.
//!
//! Friction does not depend on the sign of θ′, so that u is the same function of the angle before and behind the turning point.
//! With z the tangent of half the angle from a centre and z0 its value at the turning point, u = (z0 − z) v(z), and with
//! z = z0 − width · y², y going from negative to positive through the turning point, dτ/dy = 4 √width/((1 + z²) √v) has no singularity.
//! The centre is that of a cell, or the turning point.

use crate::engine::quadrature::{LONG_NODE, LONG_WEIGHT, PAIRS};

use super::piece::Piece;
use super::series::{DEGREE, Expansion, Series, Signs, scaled, smooth, value};
use super::step::rotated;

/// Up to this multiple of the width v has no zero: the terms of its series are at most the part `SMOOTH` of the first. The Gauss sum
/// of 1/√v in y is then exact to rounding: r = 2.9 and r⁻³² = 1e-15 at least.
const CLEAR: f64 = 2.8;
const SMOOTH: f64 = 0.9;

/// A turning point is looked for nearer than this part of the width on which u has converged.
pub(super) const NEAR: f64 = 0.7;

/// A turn, with the coordinate y from −1 to 1, in the frame of motion before the turning point.
#[derive(Clone, Debug)]
pub(super) struct Turn {
    /// z0 − z at y = ± 1.
    pub(super) width: f64,
    /// u/width in powers of y², without its factor y².
    v: Series,
    /// Signs of σ η″ by the distance from the turning point.
    pub(super) signs: Signs,
    /// Largest |η″| where its sign is not known, about a change of sign.
    pub(super) doubt: f64,
    /// sin ϑ and cos ϑ at the centre.
    centre: (f64, f64),
    /// z at the turning point.
    z0: f64,
}

impl Turn {
    /// From the expansion about the turning point in the frame of motion behind it, the sine and cosine of whose angle these are.
    pub(super) fn new(expansion: &Expansion, (sin, cos): (f64, f64)) -> Option<Self> {
        let reach = expansion.reach(1);
        Self::about(&expansion.u, (reach, 1.0), ((-sin, cos), 0.0), |u, width| {
            expansion.signs(u, width, false)
        })
    }

    /// From u in powers of (z0 − z)/scale, known up to a reach, with the centre of z, and what tells the signs up to a width.
    pub(super) fn about(
        u: &Series,
        (reach, scale): (f64, f64),
        (centre, z0): ((f64, f64), f64),
        signs: impl FnOnce(&Series, f64) -> Option<(Signs, f64)>,
    ) -> Option<Self> {
        if u[1] <= 0.0 {
            return None;
        }
        let part = smooth(u, (1, 2), (reach, CLEAR), SMOOTH)?;
        let (u, width) = (scaled(*u, part), scale * part);
        let (signs, doubt) = signs(&u, part)?;
        let mut v = [0.0; DEGREE + 1];
        v[..DEGREE].copy_from_slice(&u[1..]);
        Some(Self { width, v: v.map(|c| c / width), signs, doubt, centre, z0 })
    }

    fn z(&self, y: f64) -> f64 {
        self.z0 - self.width * y * y
    }

    /// Angle from the turning point at y, back in the frame of motion before it.
    pub(super) fn turned_by(&self, y: f64) -> f64 {
        -2.0 * libm::atan(self.width * y * y / (1.0 + self.z0 * self.z(y)))
    }

    /// dτ/dy from v.
    fn slowness_of(&self, y: f64, v: f64) -> f64 {
        let z = self.z(y);
        // u = width y² v.
        4.0 / ((1.0 + z * z) * (v / self.width).sqrt())
    }
}

impl Piece for Turn {
    fn u(&self, y: f64) -> f64 {
        let square = y * y;
        self.width * square * value(&self.v, square)
    }

    fn rate(&self, y: f64, u: f64) -> f64 {
        if y > 0.0 { -u.sqrt() } else { u.sqrt() }
    }

    fn direction(&self, y: f64) -> (f64, f64) {
        rotated(self.centre, self.z(y))
    }

    fn turning(&self, y: f64) -> f64 {
        let z = self.z(y);
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::slide::piece::check::{finds_places, is_a_slide};
    use crate::mechanics::equations::SlidingLaw;
    use crate::model::hoop::{Body, Hoop};
    use crate::model::mode::Direction;

    #[test]
    fn a_turn_is_a_slide_that_comes_back() {
        let Body::Heavy(body) = Hoop::figure_2(0.5, 0.4).unwrap().body() else { unreachable!("it has mass") };
        let before = SlidingLaw::of_body(body, 0.4, Direction::Positive);
        // Seen the other way, the slip goes the other way.
        let behind = SlidingLaw::of_body(body, 0.4, Direction::Negative);
        for theta in [3.7, 4.2, 5.0] {
            let (sin, cos) = libm::sincos(theta);
            let there = (-sin, cos);
            let turn = Turn::new(&Expansion::new(&behind, -1.0, there, 0.0), there).unwrap();
            is_a_slide(&turn, &before, (-1.0, -0.05));
            is_a_slide(&turn, &before, (0.1, 0.9));
            finds_places(&turn, &before, (0.1, 0.9));
            assert_eq!((turn.turned_by(0.0), turn.u(0.0)), (0.0, 0.0));
            let (back_sin, back_cos) = turn.direction(0.8);
            let turned = libm::atan2(back_sin * cos - back_cos * sin, back_cos * cos + back_sin * sin);
            assert!((turn.turned_by(0.8) - turned).abs() < 1e-14, "{theta}");
        }
    }
}
