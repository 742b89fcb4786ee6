//! How long rolling takes, by Gauss sums of ∫ 2 √(D/κ) dψ (docs/engine.md).
//!
//! ψ is half the angle from the bottom on orbits over the top and the phase of the swing on others,
//! D = D(π) + β sin²ψ and κ = |κ(0)| + β cos²ψ, where β = 4ℓ̂ over the top, and the energy over the
//! bottom on others. The variable is t = tan(ψ − ψm) about the middle of a panel, so that a node
//! costs a square root and a division.

use crate::math::trig::Angle;
use crate::modes::rolling::OrbitEnergy;

use super::quadrature::{LONG_NODE, LONG_WEIGHT, NODE, WEIGHT};

/// The positive nodes of the shorter rule, and their weights.
const SHORT_NODE: [f64; 4] = [NODE[4], NODE[5], NODE[6], NODE[7]];
const SHORT_WEIGHT: [f64; 4] = [WEIGHT[4], WEIGHT[5], WEIGHT[6], WEIGHT[7]];

/// Half widths of panels in t, as parts of the distance of the singularities from the real axis:
/// the error of the Gauss sum is about r^(−2n) for n nodes, with r = 10.1 for eight and r = 3.3 for
/// sixteen: 1e-16 and 2e-17.
const SHORT_PANEL: f64 = 0.2;
const LONG_PANEL: f64 = 0.66;

/// Most nodes; beyond, elliptic integrals are cheaper.
const MAX_NODES: f64 = 128.0;

/// Time on an orbit from a phase on, over an arc of ψ. None where it comes so close to a
/// singularity, next to the separatrix or to the bottom of a light hoop, that it would take too many
/// nodes.
pub(super) fn duration(energy: &OrbitEnergy, from: Angle, arc: f64) -> Option<f64> {
    let distance = singularity_distance(energy);
    // tan H ≤ t for H = t − t³/3.
    let panels = |part: f64| {
        let t = part * distance;
        (arc / (2.0 * (t - t * t * t / 3.0))).ceil().max(1.0)
    };
    // Eight nodes on narrow panels, or sixteen on wide ones, whichever are fewer.
    let (short, long) = (panels(SHORT_PANEL), panels(LONG_PANEL));
    let is_short = short <= 2.0 * long;
    let count = if is_short { short } else { long };
    let nodes = if is_short { 8.0 * short } else { 16.0 * long };
    if nodes > MAX_NODES {
        return None;
    }
    let half_panel = Angle::of(0.5 * arc / count);
    let half = half_panel.sin / half_panel.cos;
    let mut phase = from;
    let mut sum = 0.0;
    let mut panel = 0.0;
    while panel < count {
        // From the end of a panel to its middle, and on to the next.
        let middle = phase.plus(half_panel);
        let on_panel = Panel {
            energy: *energy,
            middle,
            half,
        };
        sum += if is_short {
            on_panel.sum(&SHORT_NODE, &SHORT_WEIGHT)
        } else {
            on_panel.sum(&LONG_NODE, &LONG_WEIGHT)
        };
        phase = middle.plus(half_panel);
        panel += 1.0;
    }
    Some(2.0 * half * sum)
}

/// The same over an arc with this sine and cosine. None where it takes more than one panel: then
/// the arc itself is needed.
pub(super) fn duration_of_one_panel(energy: &OrbitEnergy, from: Angle, arc: Angle) -> Option<f64> {
    // t at the end of the panel.
    let half = arc.sin / (1.0 + arc.cos);
    let distance = singularity_distance(energy);
    if !(half >= 0.0 && half <= LONG_PANEL * distance) {
        return None;
    }
    let cos = (0.5 * (1.0 + arc.cos)).sqrt();
    let panel = Panel {
        energy: *energy,
        middle: from.plus(Angle {
            sin: half * cos,
            cos,
        }),
        half,
    };
    let sum = if half <= SHORT_PANEL * distance {
        panel.sum(&SHORT_NODE, &SHORT_WEIGHT)
    } else {
        panel.sum(&LONG_NODE, &LONG_WEIGHT)
    };
    Some(2.0 * half * sum)
}

/// The distance of the singularities of the time from the real axis of t.
fn singularity_distance(energy: &OrbitEnergy) -> f64 {
    // D vanishes at the tangent ± i √(D(π)/(D(π) + β)) from the bottom, κ likewise from the top.
    let min = energy.bottom.min(energy.separatrix_gap);
    (min / (min + energy.beta)).sqrt()
}

/// dτ/dψ at a phase.
pub(super) fn slowness(energy: &OrbitEnergy, phase: Angle) -> f64 {
    let d = energy.bottom + energy.beta * (phase.sin * phase.sin);
    let twice_kinetic = energy.separatrix_gap + energy.beta * (phase.cos * phase.cos);
    2.0 * (d / twice_kinetic).sqrt()
}

struct Panel {
    energy: OrbitEnergy,
    /// ψ at its middle.
    middle: Angle,
    /// t at its end.
    half: f64,
}

impl Panel {
    /// The Gauss sum of half the slowness, over half the width, from the positive nodes.
    #[inline(always)]
    fn sum<const N: usize>(&self, nodes: &[f64; N], weights: &[f64; N]) -> f64 {
        let OrbitEnergy {
            bottom,
            separatrix_gap,
            beta,
        } = self.energy;
        let Angle { sin, cos } = self.middle;
        let mut sum = 0.0;
        for j in 0..N {
            let t = self.half * nodes[j];
            let n = 1.0 + t * t;
            // sin and cos of ψ times √n.
            let slowness = |t: f64| {
                let (sine, cosine) = (sin + cos * t, cos - sin * t);
                let d = bottom * n + beta * (sine * sine);
                let twice_kinetic = separatrix_gap * n + beta * (cosine * cosine);
                (d / (twice_kinetic * (n * n))).sqrt()
            };
            sum += weights[j] * (slowness(t) + slowness(-t));
        }
        sum
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{FRAC_PI_2, PI};

    use proptest::prelude::*;

    use super::*;

    fn angle(phase: f64) -> Angle {
        let (sin, cos) = libm::sincos(phase);
        Angle { sin, cos }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn a_gauss_sum_is_the_elliptic_integral(
            bottom in prop_oneof![0.01..10.0_f64, 1e-4..0.01_f64],
            separatrix_gap in prop_oneof![0.01..10.0_f64, 1e-4..0.01_f64],
            beta in 0.01..10.0_f64,
            from in -FRAC_PI_2..FRAC_PI_2,
            arc in prop_oneof![0.0..PI, 0.0..1e-3_f64],
        ) {
            let orbit = OrbitEnergy { bottom, separatrix_gap, beta };
            let Some(found) = duration(&orbit, angle(from), arc) else { return Ok(()) };
            let one_panel = duration_of_one_panel(&orbit, angle(from), angle(arc));
            // Beyond the top a swing of π is a half period.
            let to_place = |phase: f64| {
                let turns = ((phase + FRAC_PI_2) / PI).floor();
                let half_period = 2.0 * orbit.time_from_bottom(angle(FRAC_PI_2));
                let Angle { sin, cos } = angle(phase - PI * turns);
                turns * half_period + orbit.time_from_bottom(Angle { sin, cos: cos.max(0.0) })
            };
            let (begin, end) = (to_place(from), to_place(from + arc));
            let size = begin.abs() + end.abs();
            for found in [Some(found), one_panel].into_iter().flatten() {
                let error = (found - (end - begin)).abs();
                prop_assert!(error <= 1e-14 * size, "{found} {}", end - begin);
            }
            let is_short = libm::tan(0.5 * arc) <= 0.6 * singularity_distance(&orbit);
            prop_assert!(one_panel.is_some() || !is_short, "{arc}");
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        /// A difference of two elliptic integrals would have lost up to fifteen digits.
        #[test]
        fn a_short_arc_has_all_digits(
            bottom in prop_oneof![0.01..10.0_f64, 1e-4..0.01_f64],
            separatrix_gap in prop_oneof![0.01..10.0_f64, 1e-4..0.01_f64],
            beta in 0.01..10.0_f64,
            from in 0.01..FRAC_PI_2,
            exponent in -15.0..-0.3_f64,
            is_before_bottom in any::<bool>(),
        ) {
            let orbit = OrbitEnergy { bottom, separatrix_gap, beta };
            let arc = libm::exp10(exponent).min(FRAC_PI_2 - from);
            let (start, turned) = (angle(from), angle(arc));
            let Angle { sin, cos } = start.plus(turned);
            let end = Angle { sin, cos: cos.max(0.0) };
            let gain = turned.sin * (start.sin * end.cos + start.cos * end.sin);
            let Some(expected) = duration(&orbit, start, arc) else { return Ok(()) };
            let found = if is_before_bottom {
                orbit.time_between(end.mirrored(), start.mirrored(), -gain)
            } else {
                orbit.time_between(start, end, gain)
            };
            prop_assert!((found - expected).abs() <= 2e-14 * expected, "{found} {expected}");
        }
    }

    #[test]
    fn next_to_a_singularity_there_is_no_sum() {
        let orbit = |bottom, separatrix_gap| OrbitEnergy {
            bottom,
            separatrix_gap,
            beta: 1.0,
        };
        let from = angle(0.0);
        assert!(duration(&orbit(1.0, 1e-9), from, FRAC_PI_2).is_none());
        assert!(duration(&orbit(1e-9, 1.0), from, FRAC_PI_2).is_none());
        assert_eq!(duration(&orbit(1.0, 1.0), from, 0.0), Some(0.0));
    }
}
