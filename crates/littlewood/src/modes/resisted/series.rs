//! Taylor series of rolling with rolling resistance about an instant.

use crate::math::number::Number;
use crate::math::series::{DEGREE, Series, convolve, value};
use crate::mechanics::ResistedRollingLaw;
use crate::modes::PhasePoint;

/// Series of θ, θ′ and of what limits rolling, as those of a slide.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RollingSeries<T = f64> {
    pub(crate) theta: Series<T>,
    pub(crate) theta_rate: Series<T>,
    pub(crate) normal: Series<T>,
    /// Two numbers in the ratio of N to F: the forces, or the arms d and ς χ − a of a massless hoop,
    /// whose forces vanish together.
    pub(crate) demand: [Series<T>; 2],
    /// Dχ.
    pub(crate) denominator: Series<T>,
}

impl<T: Number> RollingSeries<T> {
    /// About (θ, θ′), up to an order.
    pub(crate) fn new(
        law: &ResistedRollingLaw<T>,
        PhasePoint { theta, rate }: PhasePoint<T>,
        order: usize,
    ) -> Self {
        let rolling = &law.rolling;
        let (mass, offset) = (rolling.mass, rolling.offset);
        let zero = [T::constant(0.0); DEGREE + 1];
        let mut s = Self {
            theta: zero,
            theta_rate: zero,
            normal: zero,
            demand: [zero; 2],
            denominator: zero,
        };
        let (mut sin, mut cos, mut u, mut acceleration) = (zero, zero, zero, zero);
        // sin θ (1 + u), and m + ℓ̂ cos θ.
        let (mut weighted_sin, mut lever) = (zero, zero);
        // j θ_j, as in a slide.
        let mut increment = zero;
        let angle = theta.angle();
        (s.theta[0], s.theta_rate[0]) = (theta, rate);
        (sin[0], cos[0]) = (angle.sin, angle.cos);
        for n in 0..=order {
            let count = n as f64;
            if n > 0 {
                s.theta_rate[n] = acceleration[n - 1] / count;
                s.theta[n] = s.theta_rate[n - 1] / count;
                increment[n] = s.theta_rate[n - 1];
            }
            let [square, forth, back] = convolve(
                [
                    (&s.theta_rate, &s.theta_rate),
                    (&increment, &cos),
                    (&increment, &sin),
                ],
                n,
            );
            u[n] = square;
            if n > 0 {
                (sin[n], cos[n]) = (forth / count, -(back / count));
            }
            let one = if n == 0 { 1.0 } else { 0.0 };
            let [sin_u, cos_u] = convolve([(&sin, &u), (&cos, &u)], n);
            weighted_sin[n] = sin[n] + sin_u;
            lever[n] = mass * one + offset * cos[n];
            s.denominator[n] = if n == 0 {
                law.denominator_of(angle)
            } else {
                offset * (cos[n] * 2.0 - law.resistance * sin[n])
            };
            let mut remainder = law.driving_moment(one, cos[n], weighted_sin[n], cos_u);
            for j in 1..=n {
                remainder = remainder - s.denominator[j] * acceleration[n - j];
            }
            acceleration[n] = remainder / s.denominator[0];
            let [sin_turn, lever_turn] =
                convolve([(&sin, &acceleration), (&lever, &acceleration)], n);
            s.normal[n] = mass * one - offset * (sin_turn + cos_u);
            s.demand[1][n] = if law.is_massless() {
                law.resistance * one - offset * sin[n]
            } else {
                offset * sin_u - lever_turn + mass * rolling.tilt * one
            };
        }
        if law.is_massless() {
            s.demand[0] = lever;
            return s;
        }
        let forces = law.forces(angle, rate * rate);
        (s.normal[0], s.demand[1][0]) = (forces.normal, forces.friction);
        s.demand[0] = s.normal;
        s
    }

    /// μs N + σ F, which vanishes where a slip in the direction σ begins.
    pub(crate) fn margin(&self, mu_s: T, sigma: f64) -> Series<T> {
        let [normal, friction] = &self.demand;
        core::array::from_fn(|n| mu_s * normal[n] + friction[n] * sigma)
    }
}

impl RollingSeries {
    /// Angle and rate after a time.
    pub(super) fn point(&self, at: f64) -> PhasePoint {
        PhasePoint {
            theta: value(&self.theta, at),
            rate: value(&self.theta_rate, at),
        }
    }
}
