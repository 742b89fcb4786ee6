//! The curves of the phase plane on which rolling slips, |F| = μs N, in the direction of motion.
//!
//! The margins (μs N ∓ F) D² of an orbit are linear in its level L = K − D(π): A(ϑ) + L B(ϑ). The
//! level L*(ϑ) = −A/B at which a margin vanishes belongs to the body. Between its extrema and poles
//! it is monotone, so that on such a piece a margin changes sign at most once, whatever the orbit.

use core::f64::consts::{PI, TAU};

use crate::engine::roll::{MarginForm, Margins, mirrored_slip};
use crate::engine::state::heading;
use crate::math::bracket::Bracket;
use crate::math::form::Trigonometric;
use crate::mechanics::RollingLaw;
use crate::model::{SlipDirection, State};

/// Where rolling has slipped, in the frame of motion: the direction of slip, and the angle reduced
/// to a turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::engine) struct SlipPoint {
    pub(in crate::engine) slip: SlipDirection,
    pub(in crate::engine) angle: f64,
}

impl SlipPoint {
    pub(super) fn of(state: &State, direction: SlipDirection) -> Self {
        let heading = heading(state);
        let theta = heading * state.theta;
        Self {
            slip: mirrored_slip(direction, heading),
            angle: theta - TAU * (theta / TAU).floor(),
        }
    }
}

#[derive(Clone, Debug)]
pub(in crate::engine) struct SlipCurves {
    margins: Margins,
    law: RollingLaw,
}

impl SlipCurves {
    pub(in crate::engine) const fn new(margins: Margins, law: RollingLaw) -> Self {
        Self { margins, law }
    }

    pub(super) fn rate_squared(&self, level: f64, angle: f64) -> f64 {
        (level - self.law.height(angle)) / self.law.denominator(angle)
    }

    /// The level of the orbit with this θ′² at an angle.
    pub(super) fn level(&self, u: f64, angle: f64) -> f64 {
        self.law.height(angle) + self.law.denominator(angle) * u
    }

    /// Of a level L, 1/K = 1/(D(π) + L).
    pub(super) fn inverse(&self, level: f64) -> f64 {
        1.0 / (self.law.bottom + level)
    }

    /// The level of 1/K.
    pub(super) fn level_of(&self, inverse: f64) -> f64 {
        1.0 / inverse - self.law.bottom
    }

    /// θ′² where the margin of a direction of slip vanishes on the orbit that reaches it at this angle.
    pub(in crate::engine) fn slip_rate_squared(
        &self,
        slip: SlipDirection,
        angle: f64,
    ) -> Option<f64> {
        let (y, x) = libm::sincos(0.5 * angle);
        let MarginForm { a, b } = &self.margins[slip.index()];
        let level = -a.value([x, y]) / b.value([x, y]);
        level.is_finite().then(|| self.rate_squared(level, angle))
    }

    /// The same with its derivative by the angle.
    pub(super) fn slip_rate_squared_and_slope(
        &self,
        slip: SlipDirection,
        angle: f64,
    ) -> (f64, f64) {
        let (y, x) = libm::sincos(0.5 * angle);
        let MarginForm { a, b } = &self.margins[slip.index()];
        let [(a, a_slope), (b, b_slope)] =
            [a, b].map(|form| form.value_and_slope([x, y], [-0.5 * y, 0.5 * x]));
        let d_slope = -4.0 * self.law.offset * x * y;
        let level = -a / b;
        let level_slope = -(a_slope + level * b_slope) / b;
        let u = self.rate_squared(level, angle);
        (
            u,
            (level_slope - (1.0 + u) * d_slope) / self.law.denominator(angle),
        )
    }

    /// The angles at which θ′² of [`SlipCurves::slip_rate_squared`] vanishes, and those at which it has an
    /// extremum.
    pub(super) fn rests_and_extrema(&self, slip: SlipDirection) -> (Vec<f64>, Vec<f64>) {
        let MarginForm { a, b } = &self.margins[slip.index()];
        let [a, b] = [a, b].map(Trigonometric::from_form);
        // u = (K − D)/D with K = −(A − D(π) B)/B.
        let rests = a.plus(&self.law.above_bottom().times(&b));
        let (a, b) = (
            a.minus(&b.scaled(self.law.bottom)),
            self.law.denominator_polynomial().times(&b),
        );
        let extrema = a.derivative().times(&b).minus(&a.times(&b.derivative()));
        (rests.sign_changes(), extrema.sign_changes())
    }

    /// 1/K of the orbit whose margin of a direction of slip vanishes at this angle.
    pub(super) fn inverse_level(&self, slip: SlipDirection, angle: f64) -> f64 {
        let (y, x) = libm::sincos(0.5 * angle);
        let MarginForm { a, b } = &self.margins[slip.index()];
        let [a, b] = [a, b].map(|form| form.value([x, y]));
        b / (self.law.bottom * b - a)
    }

    /// The pieces of a turn on which orbits pass from a positive to a negative margin of a direction of slip.
    pub(super) fn slips(&self, slip: SlipDirection) -> Vec<(f64, f64)> {
        let mut angles = vec![0.0, 0.5 * PI, PI, 1.5 * PI, TAU];
        for MarginForm { a, b } in &self.margins {
            // The poles of −A/B, and its extrema, the zeros of A′B − AB′.
            let [a, b] = [a, b].map(Trigonometric::from_form);
            angles.extend(b.sign_changes());
            angles.extend(
                a.derivative()
                    .times(&b)
                    .minus(&a.times(&b.derivative()))
                    .sign_changes(),
            );
        }
        angles.sort_by(f64::total_cmp);
        angles.dedup_by(|a, b| *a - *b < 1e-9);
        // The margin for the level at the middle falls through zero there or rises, as at all
        // levels of the piece, those among them that no orbit has (u < 0).
        let falls = |(left, right): &(f64, f64)| {
            let middle = 0.5 * (left + right);
            self.slip_rate_squared(slip, middle).is_some_and(|u| {
                let level = self.level(u, middle);
                self.margin(slip, level, *left).0 > self.margin(slip, level, *right).0
            })
        };
        angles
            .windows(2)
            .map(|pair| (pair[0], pair[1]))
            .filter(falls)
            .collect()
    }

    /// The margin of a direction of slip on the orbit with a level, and its derivative by the angle.
    fn margin(&self, slip: SlipDirection, level: f64, angle: f64) -> (f64, f64) {
        let (y, x) = libm::sincos(0.5 * angle);
        let MarginForm { a, b } = &self.margins[slip.index()];
        let [(a, a_slope), (b, b_slope)] =
            [a, b].map(|form| form.value_and_slope([x, y], [-0.5 * y, 0.5 * x]));
        (a + level * b, a_slope + level * b_slope)
    }

    /// The angle on a piece at which the orbit with a level slips.
    pub(super) fn slip_on(&self, piece: Bracket, slip: SlipDirection, level: f64) -> Option<f64> {
        level
            .is_finite()
            .then(|| piece.refine(|angle| self.margin(slip, level, angle)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::roll::margins_of;
    use crate::model::{Hoop, HoopParameters};

    #[test]
    fn the_limit_has_its_slope_its_zeros_and_its_extrema() {
        let mut found = (0, 0);
        for (mass_ratio, inertia, mu_s) in [(1.0, 1.0, 0.5), (2.0, 0.5, 0.2), (0.1, 0.07, 0.09)] {
            let hoop = HoopParameters::thin(mass_ratio)
                .with_offset(0.9)
                .with_inertia(inertia)
                .with_friction(mu_s, mu_s);
            let hoop = Hoop::new(hoop).unwrap();
            let curves = SlipCurves::new(margins_of(&hoop, 1.0).unwrap(), RollingLaw::of(&hoop));
            for slip in SlipDirection::ALL {
                let mut compared = 0;
                for k in 1..200 {
                    let angle = TAU / 200.0 * f64::from(k);
                    let (u, slope) = curves.slip_rate_squared_and_slope(slip, angle);
                    assert_eq!(curves.slip_rate_squared(slip, angle), Some(u));
                    let [before, after] = [-1e-6, 1e-6]
                        .map(|step| curves.slip_rate_squared(slip, angle + step).unwrap());
                    let quotient = (after - before) / 2e-6;
                    if quotient.abs() < 100.0 {
                        assert!(
                            (slope - quotient).abs() < 1e-6 * (1.0 + u * u),
                            "{angle}: {slope} {quotient}"
                        );
                        compared += 1;
                    }
                }
                assert!(compared > 100, "{compared}");
                let (rests, extrema) = curves.rests_and_extrema(slip);
                found = (found.0 + rests.len(), found.1 + extrema.len());
                for angle in rests {
                    assert!(
                        curves.slip_rate_squared(slip, angle).unwrap().abs() < 1e-12,
                        "{angle}"
                    );
                }
                for angle in extrema {
                    let (u, slope) = curves.slip_rate_squared_and_slope(slip, angle);
                    assert!(slope.abs() < 1e-11 * (1.0 + u * u), "{angle}: {u} {slope}");
                }
            }
        }
        assert!(found.0 > 4 && found.1 > 4, "{found:?}");
    }
}
