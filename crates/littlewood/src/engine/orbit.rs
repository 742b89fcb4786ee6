//! An orbit of rolling, entered at a state: when it is where, and where it is when.
//!
//! Everything is seen in the direction of motion. The phase ψ is half the angle from the bottom on
//! orbits over the top, and that of the swing on others; the time is the Gauss sum of [`duration`],
//! or, where that would be long, the elliptic integral.

use core::f64::consts::TAU;

use crate::math::trig::sincos;
use crate::mechanics::RollingLaw;
use crate::modes::rolling::{reduce, time_from_bottom};

use super::duration::{duration, slowness};

/// Orbits whose energy over the top is a smaller part of their constant are left to the exact
/// solver.
pub(super) const MIN_SEPARATRIX_DISTANCE: f64 = 1e-9;

/// Newton's method for the phase at a time ends with a shorter step: its error is of the second
/// order.
const MAX_LAST_STEP: f64 = 1e-9;

/// It takes four steps or five.
const MAX_STEPS: usize = 12;

/// An orbit entered at a state: z = −cos ϑ/2 and y = sin ϑ/2 ≥ 0 there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Orbit<'a> {
    pub(super) law: &'a RollingLaw,
    pub(super) rotates: bool,
    pub(super) lap: f64,
    pub(super) z: f64,
    pub(super) y: f64,
    /// D ϑ′².
    pub(super) kinetic: f64,
    /// |K − D(0)|.
    pub(super) excess: f64,
    /// 4ℓ̂ over the top, and the energy over the bottom on others.
    pub(super) swing: f64,
}

#[derive(Clone, Copy, Debug)]
pub(super) enum OrbitPass {
    First,
    NextTurn,
    WayBack,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Reached {
    pub(super) theta: f64,
    pub(super) theta_rate: f64,
}

impl<'a> Orbit<'a> {
    /// The orbit through an angle at a positive rate. None next to the separatrix.
    pub(super) fn enter(law: &'a RollingLaw, theta: f64, theta_rate: f64) -> Option<Self> {
        let (lap, z, y) = reduce(theta, sincos(0.5 * theta));
        let four_l = 4.0 * law.offset;
        let kinetic = (law.bottom + four_l * z * z) * theta_rate * theta_rate;
        let over_top = kinetic - four_l * y * y;
        let over_bottom = kinetic + four_l * z * z;
        let rotates = over_top > 0.0;
        let swing = if rotates { four_l } else { over_bottom };
        let is_clear = over_top.abs() > MIN_SEPARATRIX_DISTANCE * (law.bottom + over_bottom);
        is_clear.then_some(Self {
            law,
            rotates,
            lap,
            z,
            y,
            kinetic,
            excess: over_top.abs(),
            swing,
        })
    }

    /// The level K − D(π), twice the energy over the bottom.
    pub(super) fn level(&self) -> f64 {
        self.kinetic + 4.0 * self.law.offset * self.z * self.z
    }

    /// Sine and cosine of the phase at a point, by z, y, and D ϑ′² there.
    pub(super) fn phase(&self, z: f64, y: f64, kinetic: f64) -> (f64, f64) {
        if self.rotates {
            (z, y)
        } else {
            let sine = z * (4.0 * self.law.offset / self.swing).sqrt();
            (sine.clamp(-1.0, 1.0), (kinetic / self.swing).sqrt())
        }
    }

    fn entry(&self) -> (f64, f64) {
        self.phase(self.z, self.y, self.kinetic)
    }

    /// Time from the entry to a phase on an arc.
    pub(super) fn time(&self, (sine, cosine): (f64, f64), pass: OrbitPass) -> f64 {
        let orbit = (self.excess, self.swing);
        let (s0, c0) = self.entry();
        let (s1, c1) = match pass {
            OrbitPass::First => (sine, cosine),
            OrbitPass::NextTurn => (-sine, -cosine),
            OrbitPass::WayBack => (sine, -cosine),
        };
        let turned = libm::atan2(s1 * c0 - c1 * s0, c1 * c0 + s1 * s0);
        // Up to half a turn of the phase, give or take rounding.
        let arc = if turned < -1.0 {
            turned + TAU
        } else {
            turned.max(0.0)
        };
        if let Some(time) = duration(self.law.bottom, orbit, (s0, c0), arc) {
            return time;
        }
        let from_bottom = |phase| time_from_bottom(self.law.bottom, orbit, phase);
        let half_period = || 2.0 * from_bottom((1.0, 0.0));
        let (entered, reached) = (from_bottom((s0, c0)), from_bottom((sine, cosine)));
        let elapsed = match pass {
            OrbitPass::First => reached - entered,
            OrbitPass::NextTurn => half_period() + reached - entered,
            OrbitPass::WayBack => half_period() - reached - entered,
        };
        elapsed.max(0.0)
    }

    /// Where it is after a time, less than a period: Newton's method for the phase, each step of
    /// which adds its own time. None where the sum would be long.
    pub(super) fn after(&self, time: f64) -> Option<Reached> {
        let orbit = (self.excess, self.swing);
        let (mut here, mut left) = (self.entry(), time);
        for _ in 0..MAX_STEPS {
            let arc = left / slowness(self.law.bottom, orbit, here);
            let (sin, cos) = sincos(arc);
            let there = (here.0 * cos + here.1 * sin, here.1 * cos - here.0 * sin);
            if arc.abs() < MAX_LAST_STEP {
                return Some(self.at(there));
            }
            left -= if arc > 0.0 {
                duration(self.law.bottom, orbit, here, arc)?
            } else {
                -duration(self.law.bottom, orbit, there, -arc)?
            };
            here = there;
        }
        None
    }

    /// Where it is at a phase, up to a period behind the entry.
    fn at(&self, (sine, cosine): (f64, f64)) -> Reached {
        let four_l = 4.0 * self.law.offset;
        let (lap, z, y, kinetic) = if !self.rotates {
            let kinetic = self.swing * (cosine * cosine);
            (
                self.lap,
                sine * (self.swing / four_l).sqrt(),
                ((kinetic + self.excess) / four_l).sqrt(),
                kinetic,
            )
        } else if cosine < 0.0 {
            (
                self.lap + 1.0,
                -sine,
                -cosine,
                self.excess + four_l * (cosine * cosine),
            )
        } else {
            (
                self.lap,
                sine,
                cosine,
                self.excess + four_l * (cosine * cosine),
            )
        };
        let rate = (kinetic / (self.law.bottom + four_l * z * z)).sqrt();
        Reached {
            theta: TAU * lap + 2.0 * libm::atan2(y, -z),
            theta_rate: if self.rotates {
                rate
            } else {
                rate.copysign(cosine)
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::model::{Hoop, HoopParameters, State};
    use crate::modes::Rolling;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        /// Against the elliptic integral, within a period.
        #[test]
        fn an_orbit_is_after_a_time_where_rolling_is(
            mass_ratio in prop_oneof![0.03..3.0_f64, Just(0.0)],
            offset in 0.05..1.0_f64,
            inertia in prop_oneof![0.01..2.0_f64, 1e-4..0.01_f64],
            theta in -7.0..7.0_f64,
            theta_rate in prop_oneof![0.1..4.0_f64, 0.01..0.1_f64],
            part in 0.0..1.0_f64,
        ) {
            let hoop = Hoop::new(HoopParameters::thin(mass_ratio).with_offset(offset).with_inertia(inertia)).unwrap();
            let law = RollingLaw::of(&hoop);
            let start = State { time: 0.0, theta, theta_rate, slip: 0.0, x: 0.0 };
            let rolling = Rolling::new(&hoop, start);
            let Some(period) = rolling.orbit().recurrence().period() else { return Ok(()) };
            let Some(orbit) = Orbit::enter(&law, theta, theta_rate) else { return Ok(()) };
            let Some(found) = orbit.after(part * period) else { return Ok(()) };
            let expected = rolling.state(part * period);
            // A change of the constant K by its last digits moves the orbit by so much, next to the
            // separatrix most.
            let k = law.bottom + orbit.level();
            let conditioning = k / orbit.excess.min(law.bottom);
            let allowed = 1e-14 * conditioning * (1.0 + period * (1.0 + expected.theta_rate.abs()));
            prop_assert!((found.theta - expected.theta).abs() <= allowed, "{found:?} {expected:?} {allowed:e}");
            let allowed = allowed * (1.0 + expected.theta_rate * expected.theta_rate) * k / law.bottom;
            prop_assert!((found.theta_rate - expected.theta_rate).abs() <= allowed, "{found:?} {expected:?} {allowed:e}");
        }
    }

    /// What is not found is computed for much longer, which no test of answers would notice.
    #[test]
    fn nearly_all_orbits_are_found() {
        let law = RollingLaw::of(&Hoop::figure_2(0.5, 0.4).unwrap());
        let (mut all, mut found) = (0, 0);
        for (i, j) in (0..40).flat_map(|i| (1..40).map(move |j| (i, j))) {
            let (theta, theta_rate) = (0.16 * f64::from(i) - 3.1, 0.1 * f64::from(j));
            let Some(orbit) = Orbit::enter(&law, theta, theta_rate) else {
                continue;
            };
            for time in [1e-9, 0.3, 2.0] {
                all += 1;
                found += usize::from(orbit.after(time).is_some());
            }
        }
        assert!(all > 4_000 && 100 * found > 99 * all, "{found} of {all}");
    }
}
