//! The time on an orbit of rolling, and the point after a time.
//!
//! The time is the Gauss sum of [`duration`], or, where that would be long, the elliptic integral.

use core::f64::consts::TAU;

use crate::math::trig::Angle;
use crate::mechanics::RollingLaw;
use crate::modes::rolling::{HalfAngleOrbit, OrbitPass, ReducedAngle};

use super::duration::{duration, duration_of_one_panel, slowness};

/// Orbits whose energy over the top is a smaller part of their constant are left to the exact
/// solver.
pub(super) const MIN_SEPARATRIX_DISTANCE: f64 = 1e-9;

/// Newton's method for the phase at a time ends with a shorter step: its error is of the second
/// order.
const MAX_LAST_STEP: f64 = 1e-9;

/// It takes four steps or five.
const MAX_STEPS: usize = 12;

/// A point of an orbit, in the direction of motion at its start.
#[derive(Clone, Copy, Debug)]
pub(super) struct OrbitPoint {
    pub(super) theta: f64,
    pub(super) theta_rate: f64,
}

impl HalfAngleOrbit {
    /// The orbit through an angle at a positive rate. None next to the separatrix.
    pub(super) fn enter(law: &RollingLaw, theta: f64, theta_rate: f64) -> Option<Self> {
        let orbit = Self::new(law, theta, Angle::of(0.5 * theta), theta_rate);
        let k = orbit.energy.bottom + orbit.orbit_level();
        (orbit.energy.separatrix_gap > MIN_SEPARATRIX_DISTANCE * k).then_some(orbit)
    }

    /// Time from the start to a phase on an arc.
    pub(super) fn time(&self, phase: Angle, pass: OrbitPass) -> f64 {
        let start = self.start_phase();
        let end = match pass {
            OrbitPass::First => phase,
            OrbitPass::NextTurn => Angle {
                sin: -phase.sin,
                cos: -phase.cos,
            },
            OrbitPass::WayBack => Angle {
                cos: -phase.cos,
                ..phase
            },
        };
        let turned = end.minus(start);
        if let Some(time) = duration_of_one_panel(&self.energy, start, turned) {
            return time;
        }
        let turned = libm::atan2(turned.sin, turned.cos);
        // Up to half a turn of the phase, give or take rounding.
        let arc = if turned < -1.0 {
            turned + TAU
        } else {
            turned.max(0.0)
        };
        if let Some(time) = duration(&self.energy, start, arc) {
            return time;
        }
        let from_bottom = |phase| self.energy.time_from_bottom(phase);
        let half_period = || 2.0 * from_bottom(Angle { sin: 1.0, cos: 0.0 });
        let (started, reached) = (from_bottom(start), from_bottom(phase));
        let elapsed = match pass {
            OrbitPass::First => reached - started,
            OrbitPass::NextTurn => half_period() + reached - started,
            OrbitPass::WayBack => half_period() - reached - started,
        };
        elapsed.max(0.0)
    }

    /// The point after a time, less than a period: Newton's method for the phase, each step of
    /// which adds its own time. None where the sum would be long.
    pub(super) fn after(&self, time: f64) -> Option<OrbitPoint> {
        let (mut phase, mut time_left) = (self.start_phase(), time);
        for _ in 0..MAX_STEPS {
            let arc = time_left / slowness(&self.energy, phase);
            let end = phase.plus(Angle::of(arc));
            if arc.abs() < MAX_LAST_STEP {
                return Some(self.point(end));
            }
            time_left -= if arc > 0.0 {
                duration(&self.energy, phase, arc)?
            } else {
                -duration(&self.energy, end, -arc)?
            };
            phase = end;
        }
        None
    }

    /// The point at a phase, up to a period behind the start.
    fn point(&self, phase: Angle) -> OrbitPoint {
        let (four_l, energy) = (self.four_l, &self.energy);
        let cos_squared = phase.cos * phase.cos;
        let (position, twice_kinetic) = if self.rotates {
            // Behind the top the half angle is that of the next turn.
            let position = if phase.cos < 0.0 {
                ReducedAngle {
                    turn: self.start.turn + 1.0,
                    z: -phase.sin,
                    y: -phase.cos,
                }
            } else {
                ReducedAngle {
                    z: phase.sin,
                    y: phase.cos,
                    ..self.start
                }
            };
            (position, energy.separatrix_gap + four_l * cos_squared)
        } else {
            let twice_kinetic = energy.beta * cos_squared;
            let position = ReducedAngle {
                z: phase.sin * (energy.beta / four_l).sqrt(),
                y: ((twice_kinetic + energy.separatrix_gap) / four_l).sqrt(),
                ..self.start
            };
            (position, twice_kinetic)
        };
        let d = energy.bottom + four_l * position.z * position.z;
        let rate = (twice_kinetic / d).sqrt();
        OrbitPoint {
            theta: position.angle(),
            theta_rate: if self.rotates {
                rate
            } else {
                rate.copysign(phase.cos)
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
            let Some(orbit) = HalfAngleOrbit::enter(&law, theta, theta_rate) else { return Ok(()) };
            let Some(found) = orbit.after(part * period) else { return Ok(()) };
            let expected = rolling.state(part * period);
            // A change of the constant K by its last digits moves the orbit by so much, next to the
            // separatrix most.
            let k = law.bottom + orbit.orbit_level();
            let conditioning = k / orbit.energy.separatrix_gap.min(law.bottom);
            let allowed = 1e-14 * conditioning * (1.0 + period * (1.0 + expected.theta_rate.abs()));
            prop_assert!((found.theta - expected.theta).abs() <= allowed, "{found:?} {expected:?} {allowed:e}");
            let allowed = allowed * (1.0 + expected.theta_rate * expected.theta_rate) * k / law.bottom;
            prop_assert!((found.theta_rate - expected.theta_rate).abs() <= allowed, "{found:?} {expected:?} {allowed:e}");
        }
    }

    /// What is not found is computed for much longer, which no test of answers would notice.
    #[test]
    fn nearly_all_orbits_are_found() {
        let law = RollingLaw::of(&Hoop::equal_masses(0.5, 0.4).unwrap());
        let (mut all, mut found) = (0, 0);
        for (i, j) in (0..40).flat_map(|i| (1..40).map(move |j| (i, j))) {
            let (theta, theta_rate) = (0.16 * f64::from(i) - 3.1, 0.1 * f64::from(j));
            let Some(orbit) = HalfAngleOrbit::enter(&law, theta, theta_rate) else {
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
