//! Taylor series of a sliding motion about an instant.
//!
//! Automatic differentiation by recurrence: every product is a convolution of coefficients. The series carry
//! θ, θ′, η′ and the two quantities whose signs limit sliding, w and P. The equations are those of [`SlidingLaw`], coefficient
//! by coefficient; a test holds the two against each other.

use crate::equations::{SlidingLaw, contact};
use crate::hoop::Heavy;

/// Degree of the series. The step-size rule of Jorba and Zou asks for 20 at double precision; two more cost
/// little and allow longer steps.
pub(super) const DEGREE: usize = 22;

/// Coefficients 0 to `DEGREE` of a power series in the time since its centre.
pub(super) type Series = [f64; DEGREE + 1];

/// Truncation error that a step may make in a coefficient's sum, relative to the size of θ′ and θ″.
const TOLERANCE: f64 = f64::EPSILON / 4.0;

/// Longest step: the series of a body at rest has no scale of its own.
const LONGEST: f64 = 16.0;

#[derive(Clone, Copy, Debug)]
pub(super) struct SlideSeries {
    pub(super) theta: Series,
    pub(super) theta_rate: Series,
    pub(super) slip: Series,
    /// w = 1 − h cos θ θ′², proportional to the normal force: N = Î m w/P.
    pub(super) contact: Series,
    /// P = Î + m h s q: sliding has a unique solution while P > 0 (Painlevé).
    pub(super) solvability: Series,
}

/// Terms a_j b_{n−j} of coefficient `order` of a product.
#[inline(always)]
fn terms<'a>(a: &'a Series, b: &'a Series, order: usize) -> impl Iterator<Item = f64> + 'a {
    a[..=order].iter().zip(b[..=order].iter().rev()).map(|(a, b)| a * b)
}

/// Coefficient `order` of a product.
#[inline(always)]
fn convolve(a: &Series, b: &Series, order: usize) -> f64 {
    terms(a, b, order).fold(0.0, |sum, term| sum + term)
}

impl SlideSeries {
    /// Series about (θ, θ′, η′).
    pub(super) fn new(law: &SlidingLaw, theta: f64, theta_rate: f64, slip: f64) -> Self {
        let Heavy { mass: m, h, inertia, .. } = law.body;
        let friction = law.friction;
        let zero = [0.0; DEGREE + 1];
        let mut s = Self { theta: zero, theta_rate: zero, slip: zero, contact: zero, solvability: zero };
        let (mut sin, mut cos, mut u, mut q) = (zero, zero, zero, zero);
        let (mut lever, mut acceleration) = (zero, zero);
        // n θ_n, the coefficients of the derivative.
        let mut turning = zero;

        s.theta[0] = theta;
        s.theta_rate[0] = theta_rate;
        (sin[0], cos[0]) = libm::sincos(theta);
        u[0] = theta_rate * theta_rate;
        let mut order = 0.0;
        for n in 0..=DEGREE {
            if n > 0 {
                s.theta_rate[n] = acceleration[n - 1] / order;
                s.theta[n] = s.theta_rate[n - 1] / order;
                turning[n] = order * s.theta[n];
                // Sums that do not wait for each other, each in the order of its terms.
                let (mut for_sin, mut for_cos, mut square) = (0.0, 0.0, 0.0);
                let products = terms(&turning, &cos, n).zip(terms(&turning, &sin, n));
                for ((a, b), c) in products.zip(terms(&s.theta_rate, &s.theta_rate, n)) {
                    (for_sin, for_cos, square) = (for_sin + a, for_cos + b, square + c);
                }
                (sin[n], cos[n], u[n]) = (for_sin / order, -(for_cos / order), square);
            }
            let constant = if n == 0 { 1.0 } else { 0.0 };
            q[n] = law.q(constant, sin[n], cos[n]);
            let (mut cos_u, mut sin_q) = (0.0, 0.0);
            for (a, b) in terms(&cos, &u, n).zip(terms(&sin, &q, n)) {
                (cos_u, sin_q) = (cos_u + a, sin_q + b);
            }
            s.contact[n] = contact(constant, h, cos_u);
            s.solvability[n] = inertia * constant + m * h * sin_q;
            let mut remainder = m * convolve(&q, &s.contact, n);
            for (p, a) in s.solvability[1..=n].iter().zip(acceleration[..n].iter().rev()) {
                remainder -= p * a;
            }
            acceleration[n] = remainder / s.solvability[0];
            lever[n] = constant + h * cos[n] + friction * h * sin[n];
            order += 1.0;
        }
        for (j, rate) in s.theta_rate.iter().enumerate() {
            for (slip, lever) in s.slip[j..].iter_mut().zip(&lever) {
                *slip += rate * lever;
            }
        }
        // First integral of sliding: η′ = const − μk σ τ + θ′ (1 + h cos θ + μk σ h sin θ).
        s.slip[0] = slip;
        s.slip[1] -= friction;
        s
    }

    /// Length of the step of a balanced hoop, ℓ = 0, whose accelerations are constant: the series end with them, and the slide
    /// is one step, beyond the time at which η′ = 0, or the time of a turn where there is no friction.
    pub(super) fn straight_reach(&self) -> f64 {
        let time = |speed: f64, over: f64| if speed == 0.0 { 0.0 } else { over / speed.abs() };
        let rest = time(self.slip[1], self.slip[0].abs());
        let turn = if self.slip[1] == 0.0 { time(self.theta_rate[0], core::f64::consts::TAU) } else { 0.0 };
        LONGEST.max(1.5 * rest.max(turn))
    }

    /// Length of the step on which the series has converged to the last digit, from its last two coefficients
    /// (À. Jorba and M. Zou, Experimental Mathematics 14, 2005).
    pub(super) fn reach(&self) -> f64 {
        let scale = self.theta_rate[0].abs().max(self.theta_rate[1].abs());
        let mut reach = LONGEST;
        if !self.theta_rate[DEGREE].is_finite() || !self.slip[DEGREE].is_finite() {
            // Coefficients grow like reach^−n: overflow means a reach below 1e-13.
            return 0.0;
        }
        for order in [DEGREE - 1, DEGREE] {
            let size = [&self.theta_rate, &self.slip, &self.contact, &self.solvability]
                .iter()
                .fold(0.0_f64, |size, series| size.max(series[order].abs()));
            if size > 0.0 && scale > 0.0 {
                reach = reach.min(libm::exp(libm::log(TOLERANCE * scale / size) / order as f64));
            }
        }
        reach
    }
}

/// Value of a series, by Horner's scheme.
#[inline]
pub(super) fn value(series: &Series, at: f64) -> f64 {
    series.iter().rev().fold(0.0, |sum, c| sum * at + c)
}

/// Value and derivative of a series.
#[inline]
pub(super) fn value_and_slope(series: &Series, at: f64) -> (f64, f64) {
    series.iter().rev().fold((0.0, 0.0), |(sum, slope), c| (sum * at + c, slope * at + sum))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::hoop::{Hoop, HoopParameters};
    use crate::mode::Direction;

    proptest! {
        #[test]
        fn the_series_begin_with_the_equations_of_sliding(
            m1 in 0.1..3.0_f64, offset in 0.1..1.0_f64, inertia in 0.5..3.0_f64, mu in 0.0..0.5_f64,
            theta in -7.0..7.0_f64, rate in -3.0..3.0_f64, positive in any::<bool>(),
        ) {
            let hoop = Hoop::new(HoopParameters::new(m1, offset, inertia).with_friction(mu, mu)).unwrap();
            let direction = if positive { Direction::Positive } else { Direction::Negative };
            let law = SlidingLaw::new(&hoop, direction).unwrap();
            let series = SlideSeries::new(&law, theta, rate, 0.25);
            let expected = law.accelerations(theta, rate);
            let size = 1.0 + rate * rate;
            prop_assert!((series.contact[0] - law.contact(theta, rate)).abs() < 1e-15 * size);
            prop_assert!((series.solvability[0] - law.solvability(theta)).abs() < 1e-14);
            prop_assert!((series.theta_rate[1] - expected.theta).abs() < 1e-14 * size);
            prop_assert!((series.slip[1] - expected.slip).abs() < 1e-13 * size);
            // The first integral holds along the series, term by term.
            let at = 0.5 * series.reach();
            let (theta_then, rate_then) = (value(&series.theta, at), value(&series.theta_rate, at));
            let drift = law.momentum_integral(at, theta_then, rate_then, value(&series.slip, at))
                - law.momentum_integral(0.0, theta, rate, 0.25);
            prop_assert!(drift.abs() < 1e-13 * size, "{drift}");
        }
    }
}
