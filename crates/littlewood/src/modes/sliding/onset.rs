//! How a slide begins at η′ = 0 where η″ vanishes: by the first derivative of η′ that does not
//! (docs/theory/contact.md). That is so without friction, and on the limit |F| = μs N.
//!
//! η″ = h s [m (1 + hc) − u (m h c + m h² + Î)]/(Î + m h² s²) on a level plane vanishes at the top
//! and at the bottom, on a curve between them, and for a particle on a thin rim, with Î + m h² = m,
//! at u = 1 whatever the angle. Computed there it is rounding, and its sign tells nothing. So a
//! coefficient of the series of η′ counts only if it exceeds the rounding of its terms.

use crate::math::series::{DEGREE, Series, convolve};
use crate::math::trig::{Angle, above_bottom};
use crate::mechanics::{ContactForces, Loads, RollingLaw, SlidingLaw};
use crate::model::{Body, Heavy, Hoop, SlipDirection};

use super::series::{PhasePoint, SlideSeries};
use crate::modes::static_friction_holds;

/// The first derivative of η′ that does not vanish.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Onset {
    /// 1 for η″.
    pub(crate) order: usize,
    /// Its sign: the direction of the slip that begins.
    pub(crate) direction: SlipDirection,
}

impl Onset {
    /// Of a slide without kinetic friction; none if rounding decides all coefficients, as at rest
    /// in an equilibrium.
    pub(crate) fn of(law: &SlidingLaw, place: PhasePoint) -> Option<Self> {
        // Nearly always η″ decides.
        let acceleration = law.accelerations(place.theta, place.rate).slip;
        if acceleration.abs() > Sizes::new(law, place, 1).rounding(1) {
            let direction = SlipDirection::of_sign(acceleration)?;
            return Some(Self {
                order: 1,
                direction,
            });
        }
        Self::beyond_acceleration(law, place, &SlideSeries::new(law, place, 0.0).slip)
    }

    /// Where η″ vanishes, from the series of η′.
    pub(super) fn beyond_acceleration(
        law: &SlidingLaw,
        place: PhasePoint,
        slip: &Series,
    ) -> Option<Self> {
        // Nearly always η‴ decides.
        let is_second = slip[2].abs() > Sizes::new(law, place, 2).rounding(2);
        let order = if is_second {
            2
        } else {
            let sizes = Sizes::new(law, place, DEGREE);
            (3..=DEGREE).find(|n| slip[*n].abs() > sizes.rounding(*n))?
        };
        let direction = SlipDirection::of_sign(slip[order])?;
        Some(Self { order, direction })
    }

    /// Of a hoop with so little friction that F and μs N are rounding.
    fn without_friction(body: Heavy, place: PhasePoint) -> Option<Self> {
        Self::of(
            &SlidingLaw::of_body(body, 0.0, SlipDirection::Positive),
            place,
        )
    }
}

/// What follows at a start where |F| = μs N, but for rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum StaticLimit {
    /// |F| < μs N just after.
    Holds,
    /// The contact slips. The excess of |F| over μs N is zero, unless N is rounding, too.
    Slips {
        direction: SlipDirection,
        excess: f64,
    },
    /// |F| − μs N stays as it is: static friction holds, or the contact slips in this direction.
    Undecided(SlipDirection),
}

impl StaticLimit {
    /// By the first derivative of |F| − μs N along the rolling that does not vanish. None off the
    /// limit, and if rounding decides all derivatives of a hoop whose forces change.
    pub(crate) fn at(hoop: &Hoop, place: &PhasePoint) -> Option<Self> {
        let (place, mu) = (*place, hoop.mu_s());
        let Body::Heavy(body) = hoop.body() else {
            return None;
        };
        if mu == 0.0 {
            return None;
        }
        let rolling = RollingLaw::of(hoop);
        let forces = rolling.forces(place.theta, place.rate);
        let rounding = ForceRounding::new(&rolling, &place, Angle::of(place.theta));
        if rounding.clears(&forces, mu) {
            return None;
        }
        if forces.friction.abs() <= rounding.friction {
            let is_negligible = forces.normal > 0.0 && mu * forces.normal <= rounding.friction;
            let onset = is_negligible.then(|| Onset::without_friction(body, place));
            return onset.flatten().map(|onset| Self::Slips {
                direction: onset.direction,
                excess: 0.0,
            });
        }
        let slip = SlipDirection::of_sign(-forces.friction)?;
        let law = SlidingLaw::of_body(body, mu, slip);
        // With P ≤ 0 no slide begins (docs/theory/contact.md).
        if law.painleve(place.theta) <= 0.0 {
            return None;
        }
        match static_friction_holds(hoop, &rolling, &place, slip) {
            Some(true) => Some(Self::Holds),
            Some(false) => Some(Self::Slips {
                direction: slip,
                excess: if forces.normal > rounding.normal {
                    0.0
                } else {
                    (forces.friction.abs() - mu * forces.normal).max(0.0)
                },
            }),
            None => rolling
                .is_steady(place.theta, place.rate)
                .then_some(Self::Undecided(slip)),
        }
    }

    /// Where N = F = 0, but for rounding: w = 0, and h sin θ u + tan α = 0, as at the top at the rate
    /// of the lift-off. There the hoop moves as without a plane, and the rates at which w and h sin θ
    /// u change take their places.
    pub(crate) fn in_free_fall(hoop: &Hoop, place: &PhasePoint) -> Option<Self> {
        let PhasePoint { theta, rate } = *place;
        let Body::Heavy(body) = hoop.body() else {
            return None;
        };
        let Heavy {
            mass, h, inertia, ..
        } = body;
        let Angle { sin, cos } = Angle::of(theta);
        let u = rate * rate;
        let (pull, force) = (body.pull(), h * sin * u);
        // A term has at most 15 roundings, as that of w; the angle is rounded, too.
        let rounding = 15.0 * (force.abs() + pull.abs()) + theta.abs();
        if (force + pull).abs() > 0.5 * f64::EPSILON * rounding {
            return None;
        }
        let (lifts, drifts) = if pull == 0.0 {
            (0.0, h * cos * u * rate)
        } else {
            (force * rate, h * cos * u * rate)
        };
        // A, B and C times m Î.
        let lever = 1.0 + h * cos;
        let (a, b, c) = (
            inertia + mass * lever * lever,
            mass * h * sin * lever,
            inertia + mass * (h * sin) * (h * sin),
        );
        let (normal, friction) = (a * lifts - b * drifts, c * drifts - b * lifts);
        let holds = normal > 0.0 && friction.abs() <= hoop.mu_s() * normal;
        Some(if holds {
            Self::Holds
        } else {
            Self::Slips {
                direction: SlipDirection::of_sign(-friction)?,
                excess: 0.0,
            }
        })
    }
}

/// Bounds on the rounding of N and F of rolling.
pub(crate) struct ForceRounding {
    normal: f64,
    friction: f64,
}

impl ForceRounding {
    /// A term has at most 34 roundings: 18 of its products and sums, 6 of at most three sines and
    /// cosines, 7 of m, h and Î, 2 of the coefficient and 1 of the slope. The angle is rounded, too,
    /// which changes the forces as a rotation does.
    #[inline]
    pub(crate) fn new(law: &RollingLaw, place: &PhasePoint, angle: Angle) -> Self {
        let Angle { sin, cos } = angle;
        let (d, u) = (law.denominator_of(angle), place.rate * place.rate);
        let (m, l, pull) = (law.mass, law.offset, law.tilt.abs());
        let beyond_mass = law.inertia_excess[1].abs() + l * above_bottom(angle);
        let drive = l * sin.abs() * (1.0 + u) + (m + l * cos.abs()) * pull;
        let arm = l * sin.abs();
        let level = arm * (u * beyond_mass + m + l * cos.abs());
        let terms = ContactForces {
            normal: m + l * (sin.abs() * drive / d + cos.abs() * u),
            friction: (level + (law.mass_inertia + arm * arm) * pull) / d,
        };
        let forces_of = |angle: Angle| {
            let loads = Loads { gravity: 1.0, u };
            law.forces_at(angle, loads, law.denominator_of(angle))
        };
        let forces = forces_of(angle);
        let turn = 0.5 * f64::EPSILON * place.theta.abs();
        let turned = [turn, -turn].map(|turn| {
            forces_of(Angle {
                sin: sin + turn * cos,
                cos: cos - turn * sin,
            })
        });
        let bound = |terms: f64, of: fn(&ContactForces) -> f64| {
            let changes = turned.iter().map(|other| (of(other) - of(&forces)).abs());
            changes.fold(0.0, f64::max) + 17.0 * f64::EPSILON * terms
        };
        Self {
            normal: bound(terms.normal, |forces| forces.normal),
            friction: bound(terms.friction, |forces| forces.friction),
        }
    }

    /// A bound, in one line, of that of |F| − μs N, from D.
    ///
    /// ℓ̂ |sin θ| and m + ℓ̂ cos θ are at most √(m D). So with U = 1 + u + |tan α| and r = √(m/D) the
    /// terms of either force are at most 2.5 m U (1 + r), which round by 17 ε in each of three
    /// evaluations, and with the angle it changes by at most m U (2 + 6 r). And r < 1 + m/D.
    #[inline]
    pub(crate) fn bound(law: &RollingLaw, place: &PhasePoint, d: f64, mu_s: f64) -> f64 {
        let size = law.mass * (1.0 + place.rate * place.rate + law.tilt.abs()) * (1.0 + mu_s);
        128.0 * f64::EPSILON * (1.0 + place.theta.abs()) * (2.0 + law.mass / d) * size
    }

    /// Whether |F| differs from μs N by more than rounding.
    #[inline]
    pub(crate) fn clears(&self, forces: &ContactForces, mu_s: f64) -> bool {
        let excess = forces.friction.abs() - mu_s * forces.normal;
        excess.abs() > self.friction + mu_s * self.normal
    }
}

/// Sums of the sizes of the terms of the coefficients of η′.
struct Sizes {
    terms: Series,
    /// The same with the largest values of sine and cosine: the change with the angle.
    turned: Series,
    /// The rounding of the angle, and the relative change of P with the angle.
    angle: f64,
    steepness: f64,
    /// The sum of the sizes of the terms of P, over P.
    cancellation: f64,
    has_friction: bool,
}

impl Sizes {
    fn new(law: &SlidingLaw, place: PhasePoint, max_order: usize) -> Self {
        let (sin, cos) = libm::sincos(place.theta);
        let (sin, cos) = (sin.abs(), cos.abs());
        let Heavy {
            mass, h, inertia, ..
        } = law.body;
        let friction = law.friction.abs();
        let p = law.painleve(place.theta);
        let q = h * sin + friction * (1.0 + h * cos) + law.resistance.abs();
        let sum = |angle| sum_of_sizes(law, p, angle, place.rate.abs(), max_order);
        Self {
            terms: sum(Angle { sin, cos }),
            turned: sum(Angle {
                sin: sin + cos,
                cos: sin + cos,
            }),
            angle: 0.5 * f64::EPSILON * place.theta.abs(),
            steepness: mass * h * (cos * q + sin * h * (cos + friction * sin)) / p,
            cancellation: (inertia + mass * h * sin * q) / p,
            has_friction: friction != 0.0,
        }
    }

    /// Bound of the rounding of coefficient n. A term of η″ has at most 24 roundings: 14 of its
    /// products and sums, 7 of m, h and Î, 3 of θ′; with friction four more. Each order adds as many
    /// to those before it, and sums of one more term. A term has at most n + 2 sines and cosines,
    /// and divides by P n times.
    fn rounding(&self, n: usize) -> f64 {
        let order = n as f64;
        let each = if self.has_friction { 14.0 } else { 12.0 };
        let roundings = each * order * (order + 1.0) * self.cancellation;
        let by_angle = (order + 2.0) + order * self.steepness;
        0.5 * f64::EPSILON * roundings * self.terms[n] + self.angle * by_angle * self.turned[n]
    }
}

/// The recurrence of [`SlideSeries`], of the sizes of its terms, up to `max_order`; from P.
fn sum_of_sizes(law: &SlidingLaw, p: f64, angle: Angle, rate0: f64, max_order: usize) -> Series {
    let Heavy {
        mass, h, inertia, ..
    } = law.body;
    let zero: Series = [0.0; DEGREE + 1];
    let (mut sin, mut cos, mut turn, mut rate) = (zero, zero, zero, zero);
    let (mut u, mut contact, mut painleve, mut acceleration) = (zero, zero, zero, zero);
    let (mut arm, mut lever, mut slip) = (zero, zero, zero);
    let friction = law.friction.abs();
    (sin[0], cos[0], rate[0]) = (angle.sin, angle.cos, rate0);
    for n in 0..=max_order {
        let order = n as f64;
        if n > 0 {
            rate[n] = acceleration[n - 1] / order;
            // n θ_n.
            turn[n] = rate[n - 1];
            let [forth, back] = convolve([(&turn, &cos), (&turn, &sin)], n);
            (sin[n], cos[n]) = (forth / order, back / order);
        }
        let one = if n == 0 { 1.0 } else { 0.0 };
        [u[n]] = convolve([(&rate, &rate)], n);
        arm[n] = h * sin[n] + friction * (one + h * cos[n]) + law.resistance.abs() * one;
        lever[n] = one + h * cos[n] + friction * h * sin[n];
        let [cos_u, armed, levered] = convolve([(&cos, &u), (&sin, &arm), (&rate, &lever)], n);
        contact[n] = one + h * cos_u;
        painleve[n] = inertia * one + mass * h * armed;
        slip[n] = levered;
        let [driven] = convolve([(&arm, &contact)], n);
        let mut sum = mass * driven;
        for j in 1..=n {
            sum += painleve[j] * acceleration[n - j];
        }
        acceleration[n] = sum / p;
    }
    slip[1] += law.mean_slip_loss().abs();
    slip
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use proptest::prelude::*;

    use super::*;
    use crate::model::HoopParameters;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4_096))]

        /// Light and heavy hoops, slow and fast, on steep planes; next to the bottom, where D of a
        /// light hoop is small.
        #[test]
        fn rounding_of_forces_is_within_its_bound(
            [mass_ratio, inertia, mu_s, tilt, rate] in [
                -4.0..4.0_f64, -5.0..2.0_f64, -4.0..3.0_f64, -6.0..2.0_f64, -3.0..5.0_f64
            ].prop_map(|exponents| exponents.map(libm::exp10)),
            offset in prop_oneof![Just(1.0), 0.0..1.0_f64],
            theta in prop_oneof![-PI..PI, 3.0..3.3_f64, -1e6..1e6_f64],
        ) {
            let parameters = HoopParameters::thin(mass_ratio)
                .with_offset(offset)
                .with_inertia(inertia)
                .with_friction(mu_s, mu_s)
                .with_slope(libm::atan(tilt));
            let law = RollingLaw::of(&Hoop::new(parameters).unwrap());
            let (place, angle) = (PhasePoint { theta, rate }, Angle::of(theta));
            let told = ForceRounding::bound(&law, &place, law.denominator_of(angle), mu_s);
            let ForceRounding { normal, friction } = ForceRounding::new(&law, &place, angle);
            prop_assert!(friction + mu_s * normal <= told, "{normal} {friction} {told}");
        }
    }
}
