//! Taylor series of rolling with rolling resistance about an instant.

use crate::math::number::Number;
use crate::math::series::{DEGREE, Series, convolve, value};
use crate::math::trig::Angle;
use crate::mechanics::ResistedRollingLaw;
use crate::modes::PhasePoint;
use crate::modes::sliding::{convergence_radius, finite_degree};

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

/// Series of the angle and of what follows from it alone.
struct Turning<T> {
    theta: Series<T>,
    rate: Series<T>,
    sin: Series<T>,
    cos: Series<T>,
    u: Series<T>,
    /// j θ_j, as in a slide.
    increment: Series<T>,
}

impl<T: Number> Turning<T> {
    fn new(place: PhasePoint<T>, angle: Angle<T>) -> Self {
        let zero = [T::constant(0.0); DEGREE + 1];
        let begins = |value: T| core::array::from_fn(|n| if n == 0 { value } else { zero[n] });
        Self {
            theta: begins(place.theta),
            rate: begins(place.rate),
            sin: begins(angle.sin),
            cos: begins(angle.cos),
            u: zero,
            increment: zero,
        }
    }

    /// Coefficient n, from θ″ up to the one before.
    fn advance(&mut self, n: usize, acceleration: &Series<T>) {
        let count = n as f64;
        if n > 0 {
            self.rate[n] = acceleration[n - 1] / count;
            self.theta[n] = self.rate[n - 1] / count;
            self.increment[n] = self.rate[n - 1];
        }
        let [square, forth, back] = convolve(
            [
                (&self.rate, &self.rate),
                (&self.increment, &self.cos),
                (&self.increment, &self.sin),
            ],
            n,
        );
        self.u[n] = square;
        if n > 0 {
            (self.sin[n], self.cos[n]) = (forth / count, -(back / count));
        }
    }
}

impl<T: Number> RollingSeries<T> {
    /// About (θ, θ′), up to an order.
    pub(crate) fn new(law: &ResistedRollingLaw<T>, place: PhasePoint<T>, order: usize) -> Self {
        let (mass, offset) = (law.rolling.mass, law.rolling.offset);
        let zero = [T::constant(0.0); DEGREE + 1];
        let angle = place.theta.angle();
        let mut turning = Turning::new(place, angle);
        let (mut normal, mut demand, mut denominator) = (zero, [zero; 2], zero);
        // θ″, sin θ (1 + u), and m + ℓ̂ cos θ.
        let (mut acceleration, mut weighted_sin, mut lever) = (zero, zero, zero);
        for n in 0..=order {
            turning.advance(n, &acceleration);
            let Turning { sin, cos, u, .. } = &turning;
            let one = if n == 0 { 1.0 } else { 0.0 };
            let [sin_u, cos_u] = convolve([(sin, u), (cos, u)], n);
            weighted_sin[n] = sin[n] + sin_u;
            lever[n] = mass * one + offset * cos[n];
            denominator[n] = if n == 0 {
                law.denominator_of(angle)
            } else {
                offset * (cos[n] * 2.0 - law.resistance * sin[n])
            };
            let mut remainder = law.driving_moment(one, cos[n], weighted_sin[n], cos_u);
            for j in 1..=n {
                remainder = remainder - denominator[j] * acceleration[n - j];
            }
            acceleration[n] = remainder / denominator[0];
            let [sin_turn, lever_turn] =
                convolve([(sin, &acceleration), (&lever, &acceleration)], n);
            normal[n] = mass * one - offset * (sin_turn + cos_u);
            demand[1][n] = if law.is_massless() {
                law.resistance * one - offset * sin[n]
            } else {
                offset * sin_u - lever_turn + mass * law.rolling.tilt * one
            };
        }
        if law.is_massless() {
            demand[0] = lever;
        } else {
            let forces = law.forces(angle, place.rate * place.rate);
            (normal[0], demand[1][0]) = (forces.normal, forces.friction);
            demand[0] = normal;
        }
        Self {
            theta: turning.theta,
            theta_rate: turning.rate,
            normal,
            demand,
            denominator,
        }
    }

    /// μs N + σ F, which vanishes where a slip in the direction σ begins.
    pub(crate) fn margin(&self, mu_s: T, sigma: f64) -> Series<T> {
        let [normal, friction] = &self.demand;
        core::array::from_fn(|n| mu_s * normal[n] + friction[n] * sigma)
    }
}

impl RollingSeries {
    /// As that of a slide.
    pub(super) fn convergence_radius(&mut self, max_radius: f64) -> f64 {
        let degree = finite_degree(self.deciding());
        if degree < DEGREE {
            let Self {
                theta,
                theta_rate,
                normal,
                demand: [first, second],
                denominator,
            } = self;
            for series in [theta, theta_rate, normal, first, second, denominator] {
                series[degree + 1..].fill(0.0);
            }
        }
        convergence_radius(&self.theta_rate, self.deciding(), degree, max_radius)
    }

    const fn deciding(&self) -> [&Series; 4] {
        let Self {
            theta_rate,
            normal,
            demand: [_, friction],
            denominator,
            ..
        } = self;
        [theta_rate, normal, friction, denominator]
    }

    /// Angle and rate after a time.
    pub(super) fn point(&self, at: f64) -> PhasePoint {
        PhasePoint {
            theta: value(&self.theta, at),
            rate: value(&self.theta_rate, at),
        }
    }
}
