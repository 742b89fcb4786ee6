//! The period of endless rolling and its turning points.

use core::f64::consts::{PI, TAU};

use crate::math::number::{Dual, Number};
use crate::math::panel::{ROUNDING, TAIL_TOLERANCE, integral};
use crate::mechanics::RollingLaw;

use super::flow::Point;

/// Derivatives of an integrand that has converged converge a little later.
const TOLERANCE: f64 = 1e-2 * TAIL_TOLERANCE;

/// The rounding of √(D/G), as a part of it, where G has begun with a value: that of its terms, and
/// of D, whose angles are rounded themselves.
fn rounding<const K: usize>(
    law: &RollingLaw<Dual<K>>,
    (from, by, begins): (Dual<K>, Dual<K>, f64),
    (d, kinetic): (Dual<K>, Dual<K>),
) -> f64 {
    let [offset, mass, tilt] = [law.offset, law.mass, law.tilt].map(|it| it.value.abs());
    let (turned, angle) = (by.value.abs(), from.value.abs() + by.value.abs());
    let swing = offset * turned.min(2.0) * (1.0 + tilt) * (1.0 + angle);
    let terms = begins + 2.0 * (swing + tilt * mass * turned);
    let of_angle = angle * offset * libm::sin(from.value + by.value).abs();
    ROUNDING * (terms / kinetic.value.abs() + of_angle / d.value)
}

/// The turning point at an angle, which has the energy of a state.
pub(super) fn turning_point<const K: usize>(
    law: &RollingLaw<Dual<K>>,
    from: &Point<Dual<K>>,
    theta: f64,
) -> Dual<K> {
    let kinetic = law.denominator_of(from.theta.angle()) * 0.5 * from.rate * from.rate;
    let energy = law.energy_of(kinetic, from.theta, from.theta.angle());
    let at = Dual::constant(theta);
    let angle = at.angle();
    let excess = energy - law.energy_of(Dual::constant(0.0), at, angle);
    let slope = -law
        .driving_moment(Dual::constant(1.0), angle.cos, angle.sin)
        .value;
    Dual {
        value: theta,
        parts: excess.parts.map(|part| part / slope),
    }
}

/// The time between two turning points and back: with G = D θ′² and θ = a + (b − a) sin²(ψ/2)
///
/// ```text
/// T = 2 ∫ √(D (θ − a)(b − θ)/G) dψ    from 0 to π,
/// ```
///
/// whose integrand is smooth.
pub(super) fn of_libration<const K: usize>(
    law: &RollingLaw<Dual<K>>,
    [a, b]: [Dual<K>; 2],
) -> Dual<K> {
    let width = b - a;
    let integrand = |psi: f64| {
        let (sin, cos) = libm::sincos(0.5 * psi);
        let [passed, left] = [width * (sin * sin), width * (cos * cos)];
        // From the nearer of the two, next to which G vanishes.
        let (begins, by) = if psi < 0.5 * PI {
            (a, passed)
        } else {
            (b, -left)
        };
        let half = by * 0.5;
        let gained = law.gain((begins + half).angle(), half.angle().sin * 2.0, by);
        let d = law.denominator_of((begins + by).angle());
        (
            (d * passed * left / gained).sqrt(),
            rounding(law, (begins, by, 0.0), (d, gained)),
        )
    };
    integral(TOLERANCE, 0.0..PI, integrand) * 2.0
}

/// The time of a turn on a level plane, ∫ √(D/G) dθ.
pub(super) fn of_rotation<const K: usize>(
    law: &RollingLaw<Dual<K>>,
    from: &Point<Dual<K>>,
) -> Dual<K> {
    let start = law.denominator_of(from.theta.angle()) * from.rate * from.rate;
    let integrand = |theta: f64| {
        let by = -from.theta + theta;
        let half = by * 0.5;
        let kinetic = start + law.gain((from.theta + half).angle(), half.angle().sin * 2.0, by);
        let d = law.denominator_of(Dual::constant(theta).angle());
        (
            (d / kinetic).sqrt(),
            rounding(law, (from.theta, by, start.value), (d, kinetic)),
        )
    };
    integral(TOLERANCE, 0.0..TAU, integrand)
}
