//! Trigonometric polynomials as forms in the half angle, and their sign changes on a turn.
//!
//! With X = cos(θ/2), Y = sin(θ/2) a trigonometric polynomial of degree n is a homogeneous
//! polynomial of degree 2n: 1 = X² + Y², cos θ = X² − Y², sin θ = 2XY. On an arc between two
//! directions of (X, Y) it is a polynomial in Bernstein form, whose sign changes
//! [`crate::math::bernstein`] isolates without sampling.

use crate::math::bernstein::Bernstein;

/// A direction (X, Y) = (cos ϑ/2, sin ϑ/2), up to a positive factor.
pub(crate) type HalfAngle = [f64; 2];

/// A homogeneous polynomial Σ g_k X^{n−k} Y^k of fixed degree N − 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Form<const N: usize>(pub(crate) [f64; N]);

impl<const N: usize> Form<N> {
    /// The form on the arc from `from` to `to` (less than half a turn of the half angle).
    pub(crate) fn on_arc(&self, from: HalfAngle, to: HalfAngle) -> Bernstein {
        self.restricted(from, to).bernstein()
    }

    /// The form in the barycentric coordinates of the arc.
    #[inline]
    pub(crate) fn restricted(&self, from: HalfAngle, to: HalfAngle) -> Self {
        let (mut sum, mut power) = ([0.0; N], [0.0; N]);
        restrict(&self.0, from, to, &mut sum, &mut power);
        Self(sum)
    }

    /// The Bernstein form of a form in barycentric coordinates.
    pub(crate) fn bernstein(&self) -> Bernstein {
        Bernstein::from_form(&self.0)
    }

    #[inline]
    pub(crate) fn value(&self, direction: HalfAngle) -> f64 {
        value(&self.0, direction)
    }

    /// The sum of the sizes of its terms in a direction.
    pub(crate) fn size(&self, direction: HalfAngle) -> f64 {
        value(&self.0.map(f64::abs), direction.map(f64::abs))
    }

    /// The value in a direction, and its derivative along another.
    #[inline]
    pub(crate) fn value_and_slope(&self, [x, y]: HalfAngle, [dx, dy]: [f64; 2]) -> (f64, f64) {
        let (mut power, mut power_slope) = (1.0, 0.0);
        let (mut sum, mut slope) = (0.0, 0.0);
        for c in &self.0 {
            (sum, slope) = (sum * x + c * power, slope * x + sum * dx + c * power_slope);
            (power, power_slope) = (power * y, power_slope * y + power * dy);
        }
        (sum, slope)
    }
}

#[inline(always)]
fn value(form: &[f64], [x, y]: HalfAngle) -> f64 {
    let mut power = 1.0;
    let mut sum = 0.0;
    for c in form {
        sum = sum * x + c * power;
        power *= y;
    }
    sum
}

/// The unit vector at the barycentric coordinate `at` of an arc, the variable of [`Form::on_arc`].
#[inline]
pub(crate) fn on_arc(from: HalfAngle, to: HalfAngle, at: f64) -> HalfAngle {
    let x = (1.0 - at) * from[0] + at * to[0];
    let y = (1.0 - at) * from[1] + at * to[1];
    let length = (x * x + y * y).sqrt();
    [x / length, y / length]
}

/// Substitutes the barycentric coordinates of an arc, by Horner's scheme. `sum` and `power` must be
/// zero and have the length of the form.
#[inline(always)]
fn restrict(form: &[f64], from: HalfAngle, to: HalfAngle, sum: &mut [f64], power: &mut [f64]) {
    sum[0] = form[0];
    power[0] = 1.0;
    for coefficient in &form[1..] {
        multiply_linear(sum, [from[0], to[0]]);
        multiply_linear(power, [from[1], to[1]]);
        for (sum, power) in sum.iter_mut().zip(&*power) {
            *sum += coefficient * power;
        }
    }
}

/// Multiplies a form, whose last coefficient must be zero, by l_0 a + l_1 b.
#[inline(always)]
fn multiply_linear(form: &mut [f64], linear: [f64; 2]) {
    let mut lower = 0.0;
    for c in form {
        (lower, *c) = (*c, *c * linear[0] + lower * linear[1]);
    }
}

#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Trigonometric(Vec<f64>);

impl Trigonometric {
    /// a + b sin θ + c cos θ.
    pub(crate) fn linear(constant: f64, sin: f64, cos: f64) -> Self {
        Self(vec![constant + cos, 2.0 * sin, constant - cos])
    }

    pub(crate) fn sin() -> Self {
        Self::linear(0.0, 1.0, 0.0)
    }

    /// From the coefficients of an even form.
    pub(crate) fn from_form<const N: usize>(form: &Form<N>) -> Self {
        Self(form.0.to_vec())
    }

    pub(crate) fn value(&self, angle: f64) -> f64 {
        let (y, x) = libm::sincos(0.5 * angle);
        value(&self.0, [x, y])
    }

    pub(crate) fn times(&self, other: &Self) -> Self {
        let mut product = vec![0.0; self.0.len() + other.0.len() - 1];
        for (i, a) in self.0.iter().enumerate() {
            for (j, b) in other.0.iter().enumerate() {
                product[i + j] += a * b;
            }
        }
        Self(product)
    }

    pub(crate) fn scaled(&self, factor: f64) -> Self {
        Self(self.0.iter().map(|c| factor * c).collect())
    }

    /// The sum; the summand of lower degree is multiplied by X² + Y² = 1.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        let one = Self::linear(1.0, 0.0, 0.0);
        let (mut a, mut b) = (self.clone(), other.clone());
        while a.0.len() < b.0.len() {
            a = a.times(&one);
        }
        while b.0.len() < a.0.len() {
            b = b.times(&one);
        }
        Self(a.0.iter().zip(&b.0).map(|(a, b)| a + b).collect())
    }

    pub(crate) fn minus(&self, other: &Self) -> Self {
        self.plus(&other.scaled(-1.0))
    }

    /// The derivative in θ: X′ = −Y/2, Y′ = X/2.
    pub(crate) fn derivative(&self) -> Self {
        let degree = self.0.len() - 1;
        let mut slope = vec![0.0; self.0.len()];
        for (k, c) in self.0.iter().enumerate() {
            if k < degree {
                slope[k + 1] -= 0.5 * (degree - k) as f64 * c;
            }
            if k > 0 {
                slope[k - 1] += 0.5 * k as f64 * c;
            }
        }
        Self(slope)
    }

    /// Angles in (0, 2π) at which the sign changes, in order. Where rounding decides the sign of a
    /// coefficient, the list may contain a spurious sign change.
    pub(crate) fn sign_changes(&self) -> Vec<f64> {
        const ARCS_PER_TURN: u32 = 8;
        let direction = |arc: u32| {
            let (sin, cos) =
                libm::sincos(core::f64::consts::PI * f64::from(arc) / f64::from(ARCS_PER_TURN));
            [cos, sin]
        };
        let mut changes = Vec::new();
        let mut sign = 0.0;
        for arc in 0..ARCS_PER_TURN {
            let (from, to) = (direction(arc), direction(arc + 1));
            let (mut sum, mut power) = (vec![0.0; self.0.len()], vec![0.0; self.0.len()]);
            restrict(&self.0, from, to, &mut sum, &mut power);
            let polynomial = Bernstein::from_form(&sum);
            if sign * polynomial.initial_sign() < 0.0 {
                // A zero at the boundary of two arcs is in the interior of neither.
                changes.push(2.0 * libm::atan2(from[1], from[0]));
            }
            sign = polynomial.final_sign();
            changes.extend(polynomial.sign_changes().into_iter().map(|at| {
                let x = (1.0 - at) * from[0] + at * to[0];
                let y = (1.0 - at) * from[1] + at * to[1];
                2.0 * libm::atan2(y, x)
            }));
        }
        changes
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use proptest::prelude::*;

    use super::*;

    proptest! {
        #[test]
        fn products_sums_and_derivatives_are_those_of_the_functions(
            a in -2.0..2.0_f64, b in -2.0..2.0_f64, c in -2.0..2.0_f64, angle in 0.0..6.0_f64,
        ) {
            let f = Trigonometric::linear(a, b, c);
            let g = f.times(&Trigonometric::sin()).minus(&Trigonometric::linear(0.0, 0.0, 1.0));
            let (s, k) = libm::sincos(angle);
            let exact = (a + b * s + c * k) * s - k;
            prop_assert!((g.value(angle) - exact).abs() < 1e-14);
            let slope = (b * k - c * s) * s + (a + b * s + c * k) * k + s;
            prop_assert!((g.derivative().value(angle) - slope).abs() < 1e-13);
        }

        #[test]
        fn planted_zeros_are_found_however_close(
            first in 0.1..6.0_f64, gap in 1e-7..0.1_f64, third in 0.1..6.0_f64,
        ) {
            // sin((θ − a)/2) sin((θ − b)/2) is a trigonometric polynomial of degree one.
            let pair = |a: f64, b: f64| {
                let (half_sum, half_difference) = (0.5 * (a + b), 0.5 * (a - b));
                Trigonometric::linear(
                    0.5 * libm::cos(half_difference), -0.5 * libm::sin(half_sum), -0.5 * libm::cos(half_sum),
                )
            };
            prop_assume!((third - first).abs() > 0.2 && (third - first - gap).abs() > 0.2);
            let polynomial = pair(first, first + gap).times(&pair(third, 2.0 * PI));
            let found = polynomial.sign_changes();
            for zero in [first, first + gap, third] {
                let nearest = found.iter().map(|at| (at - zero).abs()).fold(f64::INFINITY, f64::min);
                // Rounding of coefficients of size one, over the slope at the zero.
                let slope = 0.25 * [first, first + gap, third, 2.0 * PI]
                    .iter()
                    .filter(|other| **other != zero)
                    .fold(0.5, |product, other| product * libm::sin(0.5 * (zero - other)).abs());
                prop_assert!(nearest < 64.0 * f64::EPSILON / slope, "{zero}: {found:?}");
            }
        }
    }
}
