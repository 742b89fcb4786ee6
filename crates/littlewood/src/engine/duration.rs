//! How long rolling takes, by Gauss sums of ∫ 2 √(D/κ) dψ (docs/engine.md).
//!
//! ψ is half the angle from the bottom on orbits over the top and the phase of the swing on others,
//! D = D(π) + β sin²ψ and κ = |κ(0)| + β cos²ψ, where β = 4ℓ̂ over the top, and the energy over the
//! bottom on others. The variable is t = tan(ψ − ψm) about the middle of a panel, so that a node
//! costs a square root and a division.

use crate::math::trig::sincos;

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

/// Time on the orbit with D(π), |κ(0)| and β, from where ψ has this sine and cosine on, over an arc
/// of ψ. None where it comes so close to a singularity, next to the separatrix or to the bottom of
/// a light hoop, that it would take too many nodes.
pub(super) fn duration(
    bottom: f64,
    (excess, swing): (f64, f64),
    from: (f64, f64),
    arc: f64,
) -> Option<f64> {
    // D vanishes at the tangent ± i √(D(π)/(D(π) + β)) from the bottom, κ likewise from the top.
    let least = bottom.min(excess);
    let clear = (least / (least + swing)).sqrt();
    // tan H ≤ t for H = t − t³/3.
    let panels = |part: f64| {
        let t = part * clear;
        (arc / (2.0 * (t - t * t * t / 3.0))).ceil().max(1.0)
    };
    let (short, long) = (panels(SHORT_PANEL), panels(LONG_PANEL));
    let is_short = short <= 2.0 * long;
    let count = if is_short { short } else { long };
    let nodes = if is_short { 8.0 * short } else { 16.0 * long };
    if nodes > MAX_NODES {
        return None;
    }
    let (sin, cos) = sincos(0.5 * arc / count);
    let half = sin / cos;
    // From the end of a panel to its middle, and on to the next.
    let turned = |(s, c): (f64, f64)| (s * cos + c * sin, c * cos - s * sin);
    let mut here = from;
    let mut sum = 0.0;
    let mut panel = 0.0;
    while panel < count {
        let middle = turned(here);
        let orbit = Panel {
            bottom,
            excess,
            swing,
            middle,
            half,
        };
        sum += if is_short {
            orbit.sum(&SHORT_NODE, &SHORT_WEIGHT)
        } else {
            orbit.sum(&LONG_NODE, &LONG_WEIGHT)
        };
        here = turned(middle);
        panel += 1.0;
    }
    Some(2.0 * half * sum)
}

/// dτ/dψ where ψ has this sine and cosine.
pub(super) fn slowness(
    bottom: f64,
    (excess, swing): (f64, f64),
    (sine, cosine): (f64, f64),
) -> f64 {
    2.0 * ((bottom + swing * (sine * sine)) / (excess + swing * (cosine * cosine))).sqrt()
}

struct Panel {
    bottom: f64,
    excess: f64,
    swing: f64,
    /// sin ψ and cos ψ at its middle.
    middle: (f64, f64),
    /// t at its end.
    half: f64,
}

impl Panel {
    /// The Gauss sum of half the slowness, over half the width, from the positive nodes.
    #[inline(always)]
    fn sum<const N: usize>(&self, nodes: &[f64; N], weights: &[f64; N]) -> f64 {
        let (s, c) = self.middle;
        let mut sum = 0.0;
        for j in 0..N {
            let t = self.half * nodes[j];
            let n = 1.0 + t * t;
            let slowness = |t: f64| {
                let (sine, cosine) = (s + c * t, c - s * t);
                let d = self.bottom * n + self.swing * (sine * sine);
                let kinetic = self.excess * n + self.swing * (cosine * cosine);
                (d / (kinetic * (n * n))).sqrt()
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
    use crate::modes::rolling::{time_between, time_from_bottom};

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        #[test]
        fn a_gauss_sum_is_the_elliptic_integral(
            bottom in prop_oneof![0.01..10.0_f64, 1e-4..0.01_f64],
            excess in prop_oneof![0.01..10.0_f64, 1e-4..0.01_f64],
            swing in 0.01..10.0_f64,
            from in -FRAC_PI_2..FRAC_PI_2,
            arc in prop_oneof![0.0..PI, 0.0..1e-3_f64],
        ) {
            let orbit = (excess, swing);
            let Some(found) = duration(bottom, orbit, libm::sincos(from), arc) else { return Ok(()) };
            // Beyond the top a swing of π is a half period.
            let to_place = |phase: f64| {
                let turns = ((phase + FRAC_PI_2) / PI).floor();
                let half_period = 2.0 * time_from_bottom(bottom, orbit, (1.0, 0.0));
                let (sine, cosine) = libm::sincos(phase - PI * turns);
                turns * half_period + time_from_bottom(bottom, orbit, (sine, cosine.max(0.0)))
            };
            let (begin, end) = (to_place(from), to_place(from + arc));
            let size = begin.abs() + end.abs();
            prop_assert!((found - (end - begin)).abs() <= 1e-14 * size, "{found} {}", end - begin);
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        /// A difference of two elliptic integrals would have lost up to fifteen digits.
        #[test]
        fn a_short_arc_has_all_digits(
            bottom in prop_oneof![0.01..10.0_f64, 1e-4..0.01_f64],
            excess in prop_oneof![0.01..10.0_f64, 1e-4..0.01_f64],
            swing in 0.01..10.0_f64,
            from in 0.01..FRAC_PI_2,
            exponent in -15.0..-0.3_f64,
            is_before_bottom in any::<bool>(),
        ) {
            let orbit = (excess, swing);
            let arc = libm::exp10(exponent).min(FRAC_PI_2 - from);
            let ((s0, c0), (sin, cos)) = (libm::sincos(from), libm::sincos(arc));
            let (s1, c1) = (s0 * cos + c0 * sin, (c0 * cos - s0 * sin).max(0.0));
            let gain = sin * (s0 * c1 + c0 * s1);
            let Some(expected) = duration(bottom, orbit, (s0, c0), arc) else { return Ok(()) };
            let found = if is_before_bottom {
                time_between(bottom, orbit, [(-s1, c1), (-s0, c0)], -gain)
            } else {
                time_between(bottom, orbit, [(s0, c0), (s1, c1)], gain)
            };
            prop_assert!((found - expected).abs() <= 2e-14 * expected, "{found} {expected}");
        }
    }

    #[test]
    fn next_to_a_singularity_there_is_no_sum() {
        assert!(duration(1.0, (1e-9, 1.0), (0.0, 1.0), FRAC_PI_2).is_none());
        assert!(duration(1e-9, (1.0, 1.0), (0.0, 1.0), FRAC_PI_2).is_none());
        assert_eq!(duration(1.0, (1.0, 1.0), (0.0, 1.0), 0.0), Some(0.0));
    }
}
