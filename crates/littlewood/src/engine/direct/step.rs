//! A step of a slide on which θ′ keeps its sign.

use super::super::piece::Piece;
use super::super::polynomial::value;
use super::super::quadrature::{MIDDLE_NODE as NODE, MIDDLE_NODES as NODES, MIDDLE_WEIGHT as WEIGHT};
use super::expansion::{DEGREE, Expansion, Series, Signs, scaled, sum_of_sizes};

/// Up to this multiple of a step u has no zero: the terms of its series are at most the part `SMOOTH` of the first, but for a linear
/// term that makes it grow by at most `GROWTH` on the step. The Gauss sum of 1/√u is then exact to rounding: its singularities lie
/// outside the ellipse about the step with the half axes 1.3 and 1.2, r = 5 and r⁻²⁴ = 2e-17.
const CLEAR: f64 = 1.8;
const SMOOTH: f64 = 0.9;
const GROWTH: f64 = 0.9;

/// Powers of the Gauss nodes on [0, 1], by power.
const POWERS: [[f64; NODES]; DEGREE + 1] = {
    let mut table = [[1.0; NODES]; DEGREE + 1];
    let mut k = 1;
    while k <= DEGREE {
        let mut j = 0;
        while j < NODES {
            table[k][j] = table[k - 1][j] * (0.5 + 0.5 * NODE[j]);
            j += 1;
        }
        k += 1;
    }
    table
};

/// A step, with the coordinate t = z/width up to 1, in the frame of motion.
#[derive(Clone, Debug)]
pub(super) struct Step {
    /// z at the end.
    pub(super) width: f64,
    /// With coefficients that tell up to the degree, which is even.
    pub(super) u: Series,
    pub(super) degree: usize,
    /// Signs of σ η″ on the step, behind its beginning.
    pub(super) signs: Signs,
    /// Largest |η″| where its sign is not known, about a change of sign.
    pub(super) doubt: f64,
    /// sin ϑ and cos ϑ at t = 0.
    pub(super) direction: (f64, f64),
}

impl Step {
    /// The step from an angle with this sine and cosine, where η″ = 0 if it is `from_zero`. `reach` is the width on which the series has
    /// converged.
    pub(super) fn new(
        expansion: &Expansion,
        direction: (f64, f64),
        reach: f64,
        from_zero: bool,
    ) -> Option<Self> {
        let [u0, slope, ..] = expansion.u;
        let width = if slope > 0.0 {
            expansion.smooth((0, 2), (reach.min(GROWTH * u0 / slope), CLEAR), SMOOTH)?
        } else {
            expansion.smooth((0, 1), (reach, CLEAR), SMOOTH)?
        };
        let u = scaled(expansion.u, width);
        let (signs, doubt) = expansion.signs(&u, width, from_zero)?;
        Some(Self { width, u, degree: DEGREE, signs, doubt, direction })
    }

    /// Whether the series of u tells that it has no zero near the step from t = `from`, which is −1 or more, to 1: outside the same
    /// ellipse about the step all terms but the first are at most the part `SMOOTH` of it.
    pub(super) fn is_clear(u: &Series, from: f64) -> bool {
        let far = Self::far(from);
        far * sum_of_sizes(&u[1..], far) <= SMOOTH * u[0]
    }

    /// Whether its first two coefficients allow that.
    pub(super) fn is_nearly_even(u0: f64, slope: f64, from: f64) -> bool {
        Self::far(from) * slope.abs() <= SMOOTH * u0
    }

    /// Largest |t| on the ellipse about the step from t = `from` to 1.
    fn far(from: f64) -> f64 {
        CLEAR - (CLEAR - 1.0) * from
    }

    /// Time of the whole step.
    fn whole_time(&self) -> f64 {
        let mut u = [0.0; NODES];
        for (c, powers) in self.u.iter().zip(&POWERS) {
            for j in 0..NODES {
                u[j] += c * powers[j];
            }
        }
        let square = self.width * self.width;
        let mut sum = 0.0;
        for j in 0..NODES {
            sum += WEIGHT[j] / ((1.0 + square * POWERS[2][j]) * u[j].sqrt());
        }
        self.width * sum
    }

    /// Angle turned since t = 0.
    pub(super) fn turned_by(&self, t: f64) -> f64 {
        2.0 * libm::atan(self.width * t)
    }
}

/// sin and cos of an angle from those of another, and the tangent of half the difference.
#[inline]
pub(super) fn rotated((sin, cos): (f64, f64), z: f64) -> (f64, f64) {
    let square = z * z;
    let inverse = 1.0 / (1.0 + square);
    let (turn_sin, turn_cos) = (2.0 * z * inverse, (1.0 - square) * inverse);
    (sin * turn_cos + cos * turn_sin, cos * turn_cos - sin * turn_sin)
}

impl Piece for Step {
    fn u(&self, t: f64) -> f64 {
        value(&self.u[..=self.degree], t)
    }

    fn rate(&self, _: f64, u: f64) -> f64 {
        u.sqrt()
    }

    fn direction(&self, t: f64) -> (f64, f64) {
        rotated(self.direction, self.width * t)
    }

    fn turned(&self, _: (f64, f64), t: f64, step: f64) -> (f64, f64) {
        self.direction(t + step)
    }

    fn turning(&self, t: f64) -> f64 {
        let z = self.width * t;
        2.0 * self.width / (1.0 + z * z)
    }

    fn by_coordinate(&self, t: f64, u: f64, by_time: f64) -> f64 {
        by_time / u.sqrt() * self.turning(t)
    }

    fn time(&self, (from, _): (f64, f64), (to, _): (f64, f64)) -> Option<f64> {
        if from == 0.0 && to == 1.0 {
            return Some(self.whole_time());
        }
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let t = NODE.map(|node| middle + half * node);
        let mut u = [self.u[self.degree]; NODES];
        for c in self.u[..self.degree].iter().rev() {
            for j in 0..NODES {
                u[j] = u[j] * t[j] + c;
            }
        }
        let mut sum = 0.0;
        for j in 0..NODES {
            let z = self.width * t[j];
            sum += WEIGHT[j] / ((1.0 + z * z) * u[j].sqrt());
        }
        Some(2.0 * self.width * half * sum)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::piece::check::is_a_slide;
    use crate::mechanics::equations::SlidingLaw;
    use crate::model::hoop::{Body, Hoop};
    use crate::model::mode::Direction;

    #[test]
    fn a_step_is_a_slide() {
        let Body::Heavy(body) = Hoop::figure_2(0.5, 0.4).unwrap().body() else { unreachable!("it has mass") };
        for (direction, sigma) in [(Direction::Positive, 1.0), (Direction::Negative, -1.0)] {
            let law = SlidingLaw::of_body(body, 0.4, direction);
            for (theta, u) in [(0.4, 1.2), (2.0, 3.0), (3.0, 0.7), (5.5, 2.0)] {
                let seen = libm::sincos(theta);
                let expansion = Expansion::new(&law, sigma, seen, u);
                let step = Step::new(&expansion, seen, expansion.reach(0), false).unwrap();
                is_a_slide(&step, &law, (0.0, 1.0));
                is_a_slide(&step, &law, (0.1, 0.7));
                let (sin, cos) = step.direction(1.0);
                let turned = libm::atan2(sin * seen.1 - cos * seen.0, cos * seen.1 + sin * seen.0);
                assert!((step.turned_by(1.0) - turned).abs() < 1e-14, "{theta}");
            }
        }
    }
}
