//! The limits of rolling on a slope: margins μs N ∓ F, linear in G, as power series that converge
//! to rounding on an eighth of a half turn.
//!
//! In the direction of motion, with T = ± tan α and G = D θ′²,
//!
//! ```text
//! N D² = D [m Î + (m + ℓ̂c)² − T ℓ̂ s (m + ℓ̂c)] − G ℓ̂ (ℓ̂ s² + c D),
//! F D² = ℓ̂ s [G (Î + ℓ̂(h + c)) − (m + ℓ̂c) D] + T (m Î + ℓ̂² s²) D.
//! ```

use crate::math::series::{DEGREE, Series, led, times};
use crate::math::trig::{Angle, above_bottom};
use crate::mechanics::RollingLaw;
use crate::model::{Hoop, SlipDirection};

use super::boundary::RollingLimit;

/// What bounds rolling in one direction of motion, in which the angle ϑ increases.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MarginSeries {
    /// With tan α positive downhill.
    pub(crate) law: RollingLaw,
    mu: f64,
    /// Î; a hoop without has a contact force that points at the particle.
    inertia: f64,
}

/// D and the parts of the margins in powers of the distance from an angle.
struct Terms {
    sin: Series,
    cos: Series,
    over_bottom: f64,
    /// D and m + ℓ̂c.
    d: Series,
    carried: Series,
}

impl MarginSeries {
    pub(crate) fn new(hoop: &Hoop, heading: f64) -> Self {
        let law = RollingLaw::of(hoop);
        Self {
            law: RollingLaw {
                tilt: heading * law.tilt,
                ..law
            },
            mu: hoop.mu_s(),
            inertia: hoop.body().inertia_about_mass_centre(),
        }
    }

    pub(super) fn reversed(self) -> Self {
        Self {
            law: RollingLaw {
                tilt: -self.law.tilt,
                ..self.law
            },
            ..self
        }
    }

    fn terms(&self, angle: Angle) -> Terms {
        let (l, m) = (self.law.offset, self.law.mass);
        let (mut sin, mut cos) = ([0.0; DEGREE + 1], [0.0; DEGREE + 1]);
        (sin[0], cos[0]) = (angle.sin, angle.cos);
        for n in 1..=DEGREE {
            (sin[n], cos[n]) = (cos[n - 1] / n as f64, -sin[n - 1] / n as f64);
        }
        let over_bottom = above_bottom(angle);
        Terms {
            d: led(self.law.bottom + 2.0 * l * over_bottom, 2.0 * l, &cos),
            carried: led((m - l) + l * over_bottom, l, &cos),
            sin,
            cos,
            over_bottom,
        }
    }

    /// G about an angle where it is `kinetic`.
    pub(crate) fn kinetic(&self, angle: Angle, kinetic: f64) -> Series {
        let (l, pull) = (self.law.offset, self.law.tilt);
        let Terms { sin, cos, .. } = self.terms(angle);
        core::array::from_fn(|n| match n {
            0 => kinetic,
            1 => 2.0 * (l * angle.sin + pull * (self.law.mass + l * angle.cos)),
            _ => 2.0 * l * (pull * sin[n] - cos[n]),
        })
    }

    /// The margins of a heavy hoop about an angle, of a slip to each side as A + G B: A and B.
    pub(crate) fn heavy(&self, angle: Angle) -> [[Series; 2]; 2] {
        let RollingLaw {
            offset: l,
            tilt: pull,
            mass_inertia,
            inertia_excess: excess_at_ends,
            ..
        } = self.law;
        let Terms {
            sin,
            cos,
            over_bottom,
            d,
            carried,
        } = self.terms(angle);
        let square = times(&sin, &sin);
        let carried_square = times(&carried, &carried);
        let sin_carried = times(&sin, &carried);
        let weighed: Series = core::array::from_fn(|n| {
            carried_square[n] - pull * l * sin_carried[n] + if n == 0 { mass_inertia } else { 0.0 }
        });
        let c_d = times(&cos, &d);
        let held = times(&d, &weighed);
        let inertia_excess = led(excess_at_ends[1] + l * over_bottom, l, &cos);
        let [driven, loaded] = [times(&sin, &inertia_excess), times(&sin_carried, &d)];
        let along: Series =
            core::array::from_fn(|n| l * l * square[n] + if n == 0 { mass_inertia } else { 0.0 });
        let along = times(&d, &along);
        [-1.0, 1.0].map(|sign| {
            [
                core::array::from_fn(|n| {
                    self.mu * held[n] + sign * (pull * along[n] - l * loaded[n])
                }),
                core::array::from_fn(|n| {
                    l * (sign * driven[n] - self.mu * (l * square[n] + c_d[n]))
                }),
            ]
        })
    }

    /// The margins about an angle where G is `kinetic`, each with the limit that is reached when it
    /// becomes negative.
    pub(super) fn at(&self, angle: Angle, kinetic: f64) -> [Option<(Series, RollingLimit)>; 3] {
        let kinetic = self.kinetic(angle, kinetic);
        let [negative, positive] = SlipDirection::ALL.map(RollingLimit::Friction);
        if self.inertia > 0.0 {
            let [minus, plus] = self.heavy(angle).map(|[a, b]| {
                let driven = times(&kinetic, &b);
                core::array::from_fn(|n| a[n] + driven[n])
            });
            return [Some((minus, negative)), Some((plus, positive)), None];
        }
        // N D²/(1 + ℓ̂c) = D (1 + ℓ̂c − T ℓ̂ s) − G ℓ̂ (ℓ̂ + c); the force points at the particle.
        let (l, pull) = (self.law.offset, self.law.tilt);
        let Terms {
            sin,
            cos,
            over_bottom,
            d,
            carried,
        } = self.terms(angle);
        let held: Series = core::array::from_fn(|n| carried[n] - pull * l * sin[n]);
        let offset_plus_cos = led((l - 1.0) + over_bottom, 1.0, &cos);
        let [normal, pulled] = [times(&d, &held), times(&kinetic, &offset_plus_cos)];
        let cone = |sign: f64| -> Series {
            core::array::from_fn(|n| self.mu * carried[n] + sign * l * sin[n])
        };
        [
            Some((
                core::array::from_fn(|n| normal[n] - l * pulled[n]),
                RollingLimit::NormalForce,
            )),
            Some((cone(1.0), negative)),
            Some((cone(-1.0), positive)),
        ]
    }

    /// Whether the margins of a heavy hoop are positive within a distance of an angle where G is
    /// `g`, by their values there and bounds of their slopes, the sums of the sizes of all terms.
    pub(super) fn holds_about(&self, angle: Angle, g: f64, reach: f64) -> bool {
        let Angle { sin, cos } = angle;
        let RollingLaw {
            offset: l,
            mass: m,
            tilt: pull,
            top,
            mass_inertia,
            inertia_excess: excess_at_ends,
            ..
        } = self.law;
        let mu = self.mu;
        if self.inertia == 0.0 {
            return false;
        }
        let d = self.law.denominator_of(angle);
        let carried = m + l * cos;
        let offset_sin = l * sin;
        let normal = d * (mass_inertia + carried * carried - pull * offset_sin * carried)
            - g * l * (l * sin * sin + cos * d);
        let inertia_excess = excess_at_ends[1] + l * above_bottom(angle);
        let friction = offset_sin * (g * inertia_excess - carried * d)
            + pull * (mass_inertia + offset_sin * offset_sin) * d;
        let [most, tilt] = [m + l, pull.abs()];
        let rise = 2.0 * (l + tilt * most);
        let energy = g + rise * reach;
        let max_excess = excess_at_ends[0].abs().max(excess_at_ends[1].abs());
        let weighed = mass_inertia + most * most + tilt * l * most;
        let normal_slope = 2.0 * l * weighed
            + top * l * (2.0 * most + tilt * (most + l))
            + l * (rise * (l + top) + energy * (4.0 * l + top));
        let friction_slope = l
            * (energy * (max_excess + l)
                + rise * max_excess
                + most * top
                + l * top
                + 2.0 * l * most)
            + 2.0 * tilt * l * (l * top + mass_inertia + l * l);
        // The bounds exceed the slopes by far more than rounding the values.
        let least = mu * normal - friction.abs();
        least > (mu * normal_slope + friction_slope) * reach
    }
}
