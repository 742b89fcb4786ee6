//! The grazing orbit: the rolling orbit that touches the limit of static friction (docs/ends.md).
//! Motions with μs = μk can converge to it.
//!
//! On the orbit with K = D(π) + L the margin (μs N − F) D² is A(θ) + L B(θ). Rolling holds for ever
//! below the lowest level L* = −A/B that the orbit meets, at a minimum of the level or at a turning
//! point. (The margin of the other side is the mirror image.) With
//!
//! ```text
//! a = −B/D²,               ω = ½ (A + L* B)″ θ′²/D²       at a minimum of the level,
//! a = −(B + (A + L* B)′/D′)/D²,  ω = ½ (A + L* B)′ θ″/D²    at a turning point,
//! ```
//!
//! a slip at the energy E* + ε dissipates c ε² with c = 9 μ N a² D/(m P ω).

use core::f64::consts::PI;

use std::sync::OnceLock;

use crate::math::form::Trigonometric;
use crate::math::number::Number;
use crate::math::trig::Angle;
use crate::mechanics::{Loads, RollingLaw, SlidingLaw};
use crate::model::{Body, Detail, Dimension, Heavy, Hoop, SlipDirection, State};

use super::boundary::margin_forms;
use super::orbit::RollingOrbit;
use super::recurrence::Recurrence;

/// Distance below which two extrema of a level count as one: a double root is found to √ε only.
const SAME_ANGLE_TOLERANCE: f64 = 1e-7;

/// The rolling orbit that grazes the limit of static friction.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct GrazingOrbit {
    /// Energy E* of the orbit; just below it static friction holds for ever.
    pub energy: f64,
    /// Angle θ* from 0 to π at which |F| = μs N; the orbit also grazes the limit at −θ*.
    pub theta: f64,
    /// |θ′| there; zero at a turning point.
    pub theta_rate: f64,
    /// Recurrence of the orbit.
    pub recurrence: Recurrence,
    /// c of the loss c (E − E*)² of a slip with μk = μs, in the limit E → E*.
    pub loss: f64,
    /// Energy up to which the limit is exceeded only at θ*.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub(crate) ceiling: f64,
}

impl GrazingOrbit {
    /// The grazing orbit of the highest energy below `energy`, among rotations if an orbit of this
    /// energy rotates, otherwise among librations. None if static friction holds on all such
    /// orbits, or on none; none for a massless hoop and on a slope.
    pub fn below(hoop: &Hoop, energy: f64) -> Option<Self> {
        Levels::new(hoop)?.orbit_below(hoop, energy)
    }

    /// Values with their names in records.
    pub(crate) fn details(&self) -> Vec<(&'static str, Detail)> {
        let mut details = vec![
            (
                "grazing_energy",
                Detail::Real(self.energy, Dimension::Energy),
            ),
            ("grazing_theta", Detail::Real(self.theta, Dimension::Angle)),
            (
                "grazing_theta_rate",
                Detail::Real(self.theta_rate, Dimension::AngularRate),
            ),
        ];
        details.extend(self.recurrence.details());
        details
    }

    /// Whether a slip with μk = μs from the energy `before` to `after` proves convergence to this
    /// orbit: E > E*, the limit is exceeded only at θ*, and the slip lost the energy c (E − E*)², a
    /// small fraction of E − E*, as all later slips will.
    fn attracts(&self, before: f64, after: f64) -> bool {
        /// Largest fraction of E − E* that the slip may have lost: the law of the loss holds to
        /// leading order only.
        const SMALL_LOSS: f64 = 0.125;
        let distance = before - self.energy;
        let expected = self.loss * distance * distance;
        let lost = before - after;
        // Close to E* the loss is below the rounding of the energy.
        let rounding = 64.0 * f64::EPSILON * (1.0 + before.abs());
        after > self.energy
            && before < self.ceiling
            && expected <= SMALL_LOSS * distance
            && (lost - expected).abs() <= 0.5 * expected + rounding
    }
}

/// The levels at which orbits begin, or cease, to exceed the limit of static friction.
#[derive(Clone, Debug)]
pub(crate) struct Levels {
    law: RollingLaw,
    body: Heavy,
    mu_k: f64,
    /// The margin (μs N − F) D² = A + L B of one side.
    constant: Trigonometric,
    slope: Trigonometric,
    /// In ascending order of L.
    levels: Vec<Level>,
}

/// A level at which a margin may begin to vanish.
#[derive(Clone, Debug)]
struct Level {
    /// L = K − D(π), twice the energy over the bottom.
    orbit_level: f64,
    angle: f64,
    at_turning_point: bool,
    /// The grazing orbit at this level, if any; computed on demand.
    orbit: OnceLock<Option<GrazingOrbit>>,
}

impl Level {
    const fn new(orbit_level: f64, angle: f64, at_turning_point: bool) -> Self {
        Self {
            orbit_level,
            angle,
            at_turning_point,
            orbit: OnceLock::new(),
        }
    }
}

impl Levels {
    /// The levels of a heavy hoop; none if it is balanced, or on a slope.
    pub(crate) fn new(hoop: &Hoop) -> Option<Self> {
        let Body::Heavy(body) = hoop.body() else {
            return None;
        };
        if body.h == 0.0 || hoop.slope() != 0.0 {
            return None;
        }
        let [[a, b], _] =
            margin_forms(hoop, 1.0)?.map(|parts| parts.map(|part| Trigonometric::from_form(&part)));
        let law = RollingLaw::of(hoop);
        let extrema = a
            .derivative()
            .times(&b)
            .minus(&a.times(&b.derivative()))
            .sign_changes();
        let inside = extrema.into_iter().filter_map(|angle| {
            let orbit_level = -a.value(angle) / b.value(angle);
            (orbit_level > law.height(angle)).then(|| Level::new(orbit_level, angle, false))
        });
        // At rest |F| = μs N where A + (D − D(π)) B = 0.
        let at_rest = a
            .plus(&law.above_bottom().times(&b))
            .sign_changes()
            .into_iter();
        let at_rest = at_rest.map(|angle| Level::new(law.height(angle), angle, true));
        let mut levels: Vec<Level> = inside.chain(at_rest).collect();
        levels.sort_by(|a, b| a.orbit_level.total_cmp(&b.orbit_level));
        levels.dedup_by(|a, b| {
            (a.angle - b.angle).abs() < SAME_ANGLE_TOLERANCE
                && a.at_turning_point == b.at_turning_point
        });
        Some(Self {
            law,
            body,
            mu_k: hoop.mu_k(),
            constant: a,
            slope: b,
            levels,
        })
    }

    /// L/2 − ℓ̂.
    fn energy_of(&self, orbit_level: f64) -> f64 {
        0.5 * orbit_level - self.law.offset
    }

    pub(crate) fn energy(&self, state: &State) -> f64 {
        self.law.energy(state.theta, state.theta_rate)
    }

    /// The grazing orbit to which a slip with μk = μs from one energy to another provably leads.
    pub(crate) fn attracting(&self, hoop: &Hoop, before: f64, after: f64) -> Option<GrazingOrbit> {
        self.orbit_below(hoop, after)
            .filter(|orbit| orbit.attracts(before, after))
    }

    /// The grazing orbit of the highest energy below `energy`.
    fn orbit_below(&self, hoop: &Hoop, energy: f64) -> Option<GrazingOrbit> {
        let above = self
            .levels
            .partition_point(|level| self.energy_of(level.orbit_level) < energy);
        let rotates = energy > self.law.separatrix_energy();
        let swing = |level: &Level| rotates == (level.orbit_level > 4.0 * self.law.offset);
        (0..above)
            .rev()
            .take_while(|at| swing(&self.levels[*at]))
            .find_map(|at| {
                *self.levels[at]
                    .orbit
                    .get_or_init(|| self.orbit_at(hoop, at))
            })
    }

    /// The grazing orbit at a level, if orbits above exceed the limit and orbits below do not.
    fn orbit_at(&self, hoop: &Hoop, at: usize) -> Option<GrazingOrbit> {
        let Level {
            orbit_level,
            angle,
            at_turning_point,
            ..
        } = self.levels[at];
        let over_top = 4.0 * self.law.offset;
        let lowest = if orbit_level > over_top {
            over_top
        } else {
            0.0
        };
        let floor = at
            .checked_sub(1)
            .map_or(lowest, |lower| self.levels[lower].orbit_level.max(lowest));
        let ceiling = self
            .levels
            .get(at + 1)
            .map_or(f64::INFINITY, |next| self.energy_of(next.orbit_level));

        let d = self.law.denominator(angle);
        let direction = angle.angle();
        let Angle { sin, cos } = direction;
        let u = if at_turning_point {
            0.0
        } else {
            (orbit_level - self.law.height(angle)) / d
        };
        let margin = self.constant.plus(&self.slope.scaled(orbit_level));
        let slope = margin.derivative();
        let (rise, fall) = if at_turning_point {
            let steepness = -2.0 * self.law.offset * sin;
            let acceleration = self.law.acceleration(direction, Loads::of(0.0), d);
            let along = slope.value(angle);
            (
                -(self.slope.value(angle) + along / steepness),
                0.5 * along * acceleration,
            )
        } else {
            (
                -self.slope.value(angle),
                0.5 * slope.derivative().value(angle) * u,
            )
        };
        let sliding = SlidingLaw::of_body(self.body, self.mu_k, SlipDirection::Negative);
        let painleve = sliding.p(sin, sliding.q(1.0, sin, cos));
        let normal = self.law.forces_at(direction, Loads::of(u), d).normal;
        let begins = painleve > 0.0 && normal > 0.0 && rise > 0.0 && fall > 0.0;
        (begins && self.holds(hoop, 0.5 * (floor + orbit_level))).then(|| {
            let theta_rate = u.sqrt();
            GrazingOrbit {
                energy: self.energy_of(orbit_level),
                theta: if angle > PI { 2.0 * PI - angle } else { angle },
                theta_rate,
                recurrence: RollingOrbit::of(hoop, angle, theta_rate).recurrence(),
                loss: 9.0 * self.mu_k * normal * rise * rise
                    / (self.body.mass * painleve * d * fall),
                ceiling,
            }
        })
    }

    /// Whether static friction holds on the whole orbit of a level.
    fn holds(&self, hoop: &Hoop, orbit_level: f64) -> bool {
        let u = orbit_level / self.law.bottom;
        RollingOrbit::of(hoop, PI, u.max(0.0).sqrt())
            .end()
            .is_none()
    }
}
