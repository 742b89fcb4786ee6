//! The period of endless rolling and its turning points.

use core::f64::consts::{PI, TAU};

use crate::math::number::{Dual, Number};
use crate::math::panel::{ROUNDING, TAIL_TOLERANCE, integral};
use crate::mechanics::RollingLaw;

use super::flow::Point;

/// Derivatives of an integrand that has converged converge a little later.
const TOLERANCE: f64 = 1e-2 * TAIL_TOLERANCE;

/// An angle on an orbit of rolling, at which the integrand √(D/G) is evaluated.
struct Node {
    /// The angle from which G is followed, and the angle turned from there.
    from: Dual,
    by: Dual,
    /// G at `from`.
    start: f64,
    /// D and G at the angle.
    inertia: Dual,
    twice_kinetic: Dual,
}

impl Node {
    /// The rounding of √(D/G), as a part of it: that of the terms of G, and of D, whose angles are
    /// rounded themselves.
    fn rounding(&self, law: &RollingLaw<Dual>) -> f64 {
        let [offset, mass, tilt] = [law.offset, law.mass, law.tilt].map(|it| it.value.abs());
        let [from, by] = [self.from, self.by].map(Dual::value);
        let (turned, angle) = (by.abs(), from.abs() + by.abs());
        let swing = offset * turned.min(2.0) * (1.0 + tilt) * (1.0 + angle);
        let terms = self.start + 2.0 * (swing + tilt * mass * turned);
        let of_angle = angle * offset * libm::sin(from + by).abs();
        ROUNDING * (terms / self.twice_kinetic.value.abs() + of_angle / self.inertia.value)
    }
}

/// The turning point at an angle, which has the energy of a state.
pub(super) fn turning_point(law: &RollingLaw<Dual>, from: &Point<Dual>, theta: f64) -> Dual {
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
pub(super) fn of_libration(law: &RollingLaw<Dual>, turning_points: [Dual; 2]) -> Dual {
    let [a, b] = turning_points;
    let width = b - a;
    let integrand = |psi: f64| {
        let (sin, cos) = libm::sincos(0.5 * psi);
        let [passed, left] = [width * (sin * sin), width * (cos * cos)];
        // From the nearer of the two, next to which G vanishes.
        let (from, by) = if psi < 0.5 * PI {
            (a, passed)
        } else {
            (b, -left)
        };
        let half = by * 0.5;
        let node = Node {
            from,
            by,
            start: 0.0,
            inertia: law.denominator_of((from + by).angle()),
            twice_kinetic: law.gain((from + half).angle(), half.angle().sin * 2.0, by),
        };
        (
            (node.inertia * passed * left / node.twice_kinetic).sqrt(),
            node.rounding(law),
        )
    };
    integral(TOLERANCE, 0.0..PI, integrand) * 2.0
}

/// The time of a turn on a level plane, ∫ √(D/G) dθ.
pub(super) fn of_rotation(law: &RollingLaw<Dual>, from: &Point<Dual>) -> Dual {
    let start = law.denominator_of(from.theta.angle()) * from.rate * from.rate;
    let integrand = |theta: f64| {
        let by = -from.theta + theta;
        let half = by * 0.5;
        let gain = law.gain((from.theta + half).angle(), half.angle().sin * 2.0, by);
        let node = Node {
            from: from.theta,
            by,
            start: start.value,
            inertia: law.denominator_of(Dual::constant(theta).angle()),
            twice_kinetic: start + gain,
        };
        (
            (node.inertia / node.twice_kinetic).sqrt(),
            node.rounding(law),
        )
    };
    integral(TOLERANCE, 0.0..TAU, integrand)
}
