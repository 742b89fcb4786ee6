//! Contact with rolling resistance: rolling, skidding and rest
//! (docs/theory/rolling-resistance.md). A slide has the equations of
//! [`SlidingLaw`](crate::mechanics::SlidingLaw).
//!
//! Symbols as in [`crate::mechanics::equations`]; χ coefficient of rolling resistance, ς =
//! sign(θ′), M couple, a = h sin θ and d = 1 + h cos θ arms of N and F.

use crate::math::number::Number;
use crate::math::trig::Angle;
use crate::mechanics::{ContactForces, Loads, RollingLaw};
use crate::model::Heavy;

/// The equations of rolling in one direction:
///
/// ```text
/// Dχ θ″ = ℓ̂ sin θ (1 + u) + (m + ℓ̂ cos θ) tan α − ς χ m (1 − h cos θ u),  Dχ = D − ς χ ℓ̂ sin θ,
/// N = m − ℓ̂ (sin θ θ″ + cos θ u),
/// F = ℓ̂ sin θ u − (m + ℓ̂ cos θ) θ″ + m tan α.
/// ```
#[derive(Clone, Copy, Debug)]
pub(crate) struct ResistedRollingLaw<T = f64> {
    pub(crate) rolling: RollingLaw<T>,
    /// ς χ.
    pub(crate) resistance: T,
}

impl<T: Number> ResistedRollingLaw<T> {
    pub(crate) fn of_body(body: &Heavy<T>, resistance: T) -> Self {
        Self {
            rolling: RollingLaw::of_body(body),
            resistance,
        }
    }

    /// Whether the hoop has no inertia: its force of contact then passes the particle.
    pub(crate) fn is_massless(&self) -> bool {
        self.rolling.mass_inertia.value() == 0.0
    }

    /// Dχ.
    pub(crate) fn denominator_of(&self, angle: Angle<T>) -> T {
        let drag = self.resistance * (self.rolling.offset * angle.sin);
        self.rolling.denominator_of(angle) - drag
    }

    /// Dχ θ″, from 1, sin θ, cos θ, sin θ (1 + u) and cos θ u.
    pub(crate) fn driving_moment(&self, one: f64, cos: T, weighted_sin: T, cos_u: T) -> T {
        let RollingLaw { mass, offset, .. } = self.rolling;
        let press = mass * one - offset * cos_u;
        self.rolling
            .driving_moment(T::constant(one), cos, weighted_sin)
            - self.resistance * press
    }

    /// θ″.
    pub(crate) fn acceleration(&self, angle: Angle<T>, u: T) -> T {
        let Angle { sin, cos } = angle;
        self.driving_moment(1.0, cos, sin * (u + 1.0), cos * u) / self.denominator_of(angle)
    }

    /// N and F. F is computed as the friction without resistance plus what resistance changes: with
    /// one fraction a heavy hoop would lose digits.
    pub(crate) fn forces(&self, angle: Angle<T>, u: T) -> ContactForces<T> {
        let Angle { sin, cos } = angle;
        let RollingLaw {
            mass, offset, tilt, ..
        } = self.rolling;
        let denominator = self.denominator_of(angle);
        // F D without resistance.
        let free = self
            .rolling
            .forces_at(angle, Loads::of(u), T::constant(1.0))
            .friction;
        let arm = offset * sin;
        let press = mass - offset * (cos * u);
        let resisted = (mass + offset * cos) * press - arm * (arm * u + mass * tilt);
        ContactForces {
            normal: mass - offset * (sin * self.acceleration(angle, u) + cos * u),
            friction: (free + self.resistance * resisted) / denominator,
        }
    }
}

/// The equations of skidding, with η′ ≠ 0 and θ′ = 0, and of rest, without either: N = m, and the
/// couple holds the angle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HeldLaw<T = f64> {
    pub(crate) body: Heavy<T>,
    /// μk σ of a skid.
    pub(crate) friction: T,
}

impl<T: Number> HeldLaw<T> {
    /// M/N of a skid, the arm by which the couple holds the angle: −(a − μk σ d).
    pub(crate) fn arm_of_skid(&self, Angle { sin, cos }: Angle<T>) -> T {
        self.friction * (self.body.h * cos + 1.0) - self.body.h * sin
    }

    /// M/N of rest: −(a + d tan α).
    pub(crate) fn arm_of_rest(&self, Angle { sin, cos }: Angle<T>) -> T {
        -((self.body.h * cos + 1.0) * self.body.tilt + self.body.h * sin)
    }

    /// η″ of a skid, −μk σ − tan α.
    pub(crate) fn slip_acceleration(&self) -> T {
        -(self.friction + self.body.tilt)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::mechanics::SlidingLaw;
    use crate::model::{Composition, SlipDirection};

    /// Solves linear equations, the last column on the right, by elimination with pivots.
    fn solve<const N: usize, const M: usize>(mut rows: [[f64; M]; N]) -> [f64; N] {
        for k in 0..N {
            let best = (k..N).max_by(|i, j| rows[*i][k].abs().total_cmp(&rows[*j][k].abs()));
            rows.swap(k, best.unwrap());
            for i in (0..N).filter(|i| *i != k) {
                let factor = rows[i][k] / rows[k][k];
                let pivot = rows[k];
                for (x, p) in rows[i].iter_mut().zip(pivot) {
                    *x -= factor * p;
                }
            }
        }
        core::array::from_fn(|k| rows[k][M - 1] / rows[k][k])
    }

    /// θ″, η″, N, F and M by the balances of force and moment, with the law of each friction in the
    /// last two rows.
    fn balances(body: &Heavy, angle: Angle, u: f64, slip: [f64; 6], turn: [f64; 6]) -> [f64; 5] {
        let Heavy {
            mass: m,
            h,
            inertia,
            tilt,
            ..
        } = *body;
        let Angle { sin, cos } = angle;
        let d = 1.0 + h * cos;
        solve([
            // The mass centre has the acceleration (η″ − d θ″ + h s u, −h s θ″ − h c u).
            [-m * d, m, 0.0, -1.0, 0.0, -m * (h * sin * u + tilt)],
            [-m * h * sin, 0.0, -1.0, 0.0, 0.0, m * (h * cos * u - 1.0)],
            [inertia, 0.0, -h * sin, -d, -1.0, 0.0],
            slip,
            turn,
        ])
    }

    fn close(name: &str, ours: f64, theirs: f64, size: f64) -> Result<(), TestCaseError> {
        let error = (ours - theirs).abs();
        prop_assert!(error <= 1e-12 * size, "{name}: {ours} {theirs}");
        Ok(())
    }

    proptest! {
        /// Rolling, sliding, skidding and rest, on slopes too.
        #[test]
        fn accelerations_and_forces_are_those_of_the_balances(
            mass_ratio in 0.05..3.0_f64, offset in 0.0..=1.0_f64, own in 0.05..2.0_f64,
            slope in prop_oneof![Just(0.0), -1.2..1.2_f64], theta in -4.0..4.0_f64,
            rate in -2.0..2.0_f64, mu in 0.0..1.0_f64, chi in 0.0..0.5_f64, positive in any::<bool>(),
        ) {
            let body = Heavy::of(Composition { mass_ratio, offset, inertia: own }, slope);
            let (angle, u) = (Angle::of(theta), rate * rate);
            let resistance = chi.copysign(rate);
            let direction = if positive { SlipDirection::Positive } else { SlipDirection::Negative };
            let friction = direction.sign() * mu;
            let [sticks, holds] = [[0.0, 1.0, 0.0, 0.0, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]];
            let [slides, turns] = [[0.0, 0.0, friction, 1.0, 0.0, 0.0], [0.0, 0.0, resistance, 0.0, 1.0, 0.0]];

            let law = ResistedRollingLaw::of_body(&body, resistance);
            prop_assume!(law.denominator_of(angle).abs() > 0.05);
            let [theta_acceleration, _, normal, force, _] = balances(&body, angle, u, sticks, turns);
            let size = 1.0 + theta_acceleration.abs() + normal.abs() + force.abs();
            let forces = law.forces(angle, u);
            close("rolling theta''", law.acceleration(angle, u), theta_acceleration, size)?;
            close("rolling N", forces.normal, normal, size)?;
            close("rolling F", forces.friction, force, size)?;

            let law = SlidingLaw { resistance, ..SlidingLaw::of_body(body, mu, direction) };
            prop_assume!(law.painleve(theta).abs() > 0.05);
            let [theta_acceleration, slip, normal, force, _] = balances(&body, angle, u, slides, turns);
            let size = 1.0 + theta_acceleration.abs() + slip.abs() + normal.abs();
            let (found, forces) = (law.accelerations(theta, rate), law.forces(theta, rate));
            close("sliding theta''", found.theta, theta_acceleration, size)?;
            close("sliding eta''", found.slip, slip, size)?;
            close("sliding N", forces.normal, normal, size)?;
            close("sliding F", forces.friction, force, size)?;

            let law = HeldLaw { body, friction };
            let [_, slip, normal, _, couple] = balances(&body, angle, 0.0, slides, holds);
            close("skidding eta''", law.slip_acceleration(), slip, 1.0 + slip.abs())?;
            close("skidding M", law.arm_of_skid(angle) * body.mass, couple, 1.0 + couple.abs())?;
            close("skidding N", body.mass, normal, normal)?;
            let [_, _, normal, force, couple] = balances(&body, angle, 0.0, sticks, holds);
            close("rest M", law.arm_of_rest(angle) * body.mass, couple, 1.0 + couple.abs())?;
            close("rest F", body.mass * body.tilt, force, 1.0 + force.abs())?;
            close("rest N", body.mass, normal, normal)?;
        }
    }
}
