//! A tile of a turn: what is kept of rolling over it, and G and D about any angle.

use core::f64::consts::TAU;

use crate::engine::orbit::MIN_SEPARATRIX_DISTANCE;
use crate::engine::quadrature::{LONG_NODE, LONG_WEIGHT, PAIRS};
use crate::engine::roll::{LinearNumber, MarginSigns, OrbitRange, RoundedNumber};
use crate::math::bernstein::{Bernstein, value_and_slope};
use crate::math::bracket::Bracket;
use crate::math::series::{DEGREE, Series, convolve, crossing, shifted, value};
use crate::math::trig::{Angle, taylor};
use crate::mechanics::RollingLaw;
use crate::modes::rolling::MarginSeries;

/// Tiles of a turn, and the angle of one.
pub(super) const TABLES: usize = 16;
pub(super) const WIDTH: f64 = TAU / TABLES as f64;

/// G and D change by at most this part of themselves on the ellipse about a panel with the half
/// axes 1.76 and 1.45 times its own: the Gauss sum with 16 nodes is then exact to rounding, r = 3.2
/// and r⁻³² = 7e-17.
const MAX_CHANGE: f64 = 0.9;
const ELLIPSE: f64 = 1.76;

/// Bounds of what sines and cosines of complex angles |φ| ≤ 1 add to the linear terms, as a part of
/// |φ|²/2.
const CURVATURE: f64 = 1.15;

/// Newton's method for the distance of a turning point takes two steps or three.
const MAX_STEPS: u32 = 12;

/// (sin φ − φ)/φ³ and (1 − cos φ)/φ² in φ², up to half a radian.
pub(super) const MAX_BEND: f64 = 0.5;
const SINE: [f64; 7] = taylor(3, -1.0);
const VERSINE: [f64; 7] = taylor(2, 1.0);

/// sin φ − φ and 1 − cos φ.
#[inline(always)]
fn bends(angle: f64) -> (f64, f64) {
    let square = angle * angle;
    let sum = |coefficients: &[f64; 7]| coefficients.iter().fold(0.0, |sum, c| sum * square + c);
    (angle * square * sum(&SINE), square * sum(&VERSINE))
}

/// The sum of two angles, of which the second is small.
pub(super) fn rotated(Angle { sin, cos }: Angle, by: f64) -> Angle {
    let (bend, versine) = bends(by);
    let sine = by + bend;
    Angle {
        sin: sin + (cos * sine - sin * versine),
        cos: cos - (sin * sine + cos * versine),
    }
}

/// A function a + g b on a tile.
#[derive(Clone, Debug)]
pub(super) struct Linear {
    /// In powers of the distance from the beginning of the tile.
    pub(super) taylor: [Series; 2],
    bernstein: [Series; 2],
    /// Sums of the sizes of their terms.
    sizes: [f64; 2],
}

impl Linear {
    pub(super) fn new(taylor: [Series; 2]) -> Self {
        let bernstein = [0, 1].map(|part: usize| {
            let form = Bernstein::from_taylor(&taylor[part], WIDTH);
            core::array::from_fn(|k| form.coefficients()[k])
        });
        let sizes = [0, 1].map(|part: usize| value(&taylor[part].map(f64::abs), WIDTH));
        Self {
            taylor,
            bernstein,
            sizes,
        }
    }

    /// The g for which it certainly exceeds `min` everywhere.
    fn g_range(&self, min: f64) -> OrbitRange {
        let [a, b] = &self.bernstein;
        let [a_scale, b_scale] = self.sizes;
        let numbers = (0..=DEGREE).map(|k| LinearNumber {
            a: RoundedNumber {
                value: a[k] - min,
                scale: a_scale,
            },
            b: RoundedNumber {
                value: b[k],
                scale: b_scale,
            },
        });
        OrbitRange::of_positive(f64::NEG_INFINITY, numbers)
    }

    fn signs(&self, g: f64) -> MarginSigns {
        let [a, b] = &self.bernstein;
        let on_orbit: Series = core::array::from_fn(|k| a[k] + g * b[k]);
        MarginSigns::of(&on_orbit)
    }

    pub(super) fn on_orbit(&self, g: f64) -> Series {
        let [a, b] = &self.taylor;
        core::array::from_fn(|k| a[k] + g * b[k])
    }

    pub(super) fn size(&self, g: f64) -> f64 {
        self.sizes[0] + g.abs() * self.sizes[1]
    }

    /// The first zero behind a point at which it is positive, or zero and rising.
    pub(super) fn crossing(&self, g: f64, from: f64, starts_at_zero: bool) -> Option<f64> {
        let on_orbit = self.on_orbit(g);
        match self.signs(g) {
            MarginSigns::Holds => None,
            MarginSigns::Falls if !starts_at_zero => {
                let bracket = Bracket {
                    low: from,
                    high: WIDTH,
                };
                Some(bracket.refine_from_secant(|at| value_and_slope(&on_orbit, at)))
            }
            MarginSigns::Falls | MarginSigns::Unclear => {
                let mut ahead = shifted(on_orbit, from);
                if starts_at_zero {
                    ahead[0] = 0.0;
                }
                Some(from + crossing(&ahead, WIDTH - from)?)
            }
        }
    }
}

/// G and D about an angle, as functions of the distance φ.
#[derive(Clone, Copy, Debug)]
pub(super) struct LocalExpansion {
    /// G = g + slope φ + g_sine (sin φ − φ) + g_versine (1 − cos φ).
    pub(super) g: f64,
    pub(super) slope: f64,
    g_sine: f64,
    g_versine: f64,
    /// D = d + d_sine sin φ + d_versine (1 − cos φ).
    pub(super) d: f64,
    d_sine: f64,
    d_versine: f64,
    /// Bounds of what is left of G and D beyond their linear terms, over |φ|².
    g_bend: f64,
    d_bend: f64,
}

impl LocalExpansion {
    pub(super) fn new(law: &RollingLaw, angle: Angle, g: f64) -> Self {
        let Angle { sin, cos } = angle;
        let RollingLaw {
            offset, mass, tilt, ..
        } = *law;
        Self {
            g,
            slope: 2.0 * (offset * sin + tilt * (mass + offset * cos)),
            g_sine: 2.0 * offset * (sin + tilt * cos),
            g_versine: 2.0 * offset * (cos - tilt * sin),
            d: law.denominator_of(angle),
            d_sine: -2.0 * offset * sin,
            d_versine: -2.0 * offset * cos,
            g_bend: CURVATURE * offset * (1.0 + tilt * tilt).sqrt(),
            d_bend: CURVATURE * offset,
        }
    }

    /// G minus that at φ = 0.
    pub(super) fn gain(&self, angle: f64) -> f64 {
        let (bend, versine) = bends(angle);
        self.slope * angle + (self.g_sine * bend + self.g_versine * versine)
    }

    /// Whether the Gauss sum over a panel of this half width is exact to rounding.
    pub(super) fn is_smooth(&self, half: f64) -> bool {
        let reach = ELLIPSE * half;
        reach <= 1.0
            && reach * (self.slope.abs() + reach * self.g_bend) <= MAX_CHANGE * self.g
            && reach * (self.d_sine.abs() + reach * self.d_bend) <= MAX_CHANGE * self.d
    }

    /// √(D/G) at φ and −φ.
    #[inline(always)]
    pub(super) fn slowness(&self, angle: f64) -> [f64; 2] {
        let (bend, versine) = bends(angle);
        let (even, odd) = (
            self.g + self.g_versine * versine,
            self.slope * angle + self.g_sine * bend,
        );
        let (d_even, d_odd) = (
            self.d + self.d_versine * versine,
            self.d_sine * (angle + bend),
        );
        [
            ((d_even + d_odd) / (even + odd)).sqrt(),
            ((d_even - d_odd) / (even - odd)).sqrt(),
        ]
    }

    /// The time from −half to half.
    pub(super) fn time(&self, half: f64) -> f64 {
        let mut sum = 0.0;
        for j in 0..PAIRS {
            let [ahead, behind] = self.slowness(half * LONG_NODE[j]);
            sum += LONG_WEIGHT[j] * (ahead + behind);
        }
        half * sum
    }

    /// About a turning point: how far from it, in a direction, time is a Gauss sum in the square
    /// root of the distance.
    pub(super) fn turning_radius(&self) -> f64 {
        let of_g = MAX_CHANGE * self.slope.abs() / self.g_bend;
        let square = self.d_sine * self.d_sine + 4.0 * self.d_bend * (MAX_CHANGE * self.d);
        let of_d = (square.sqrt() - self.d_sine.abs()) / (2.0 * self.d_bend);
        of_g.min(of_d).min(1.0) / (ELLIPSE * ELLIPSE)
    }

    /// The distance of the turning point on the side of this sign, where G is `twice_kinetic` here, if it
    /// is near.
    pub(super) fn turning_distance(&self, twice_kinetic: f64, side: f64) -> Option<f64> {
        let slope = self.slope.abs();
        let mut distance = twice_kinetic / slope;
        for _ in 0..MAX_STEPS {
            if distance.is_nan() || distance > 1.0 {
                return None;
            }
            let next = distance + (twice_kinetic + self.gain(side * distance)) / slope;
            // Rounding of the slope and of the gain, a few terms each.
            let is_last = (next - distance).abs() <= 8.0 * f64::EPSILON * distance;
            distance = next;
            if is_last {
                return Some(distance);
            }
        }
        None
    }

    /// The time from a turning point to a distance on the side of this sign, or back: ∫ 2 √(D/ρ) ds
    /// with the distance s² and G = s² ρ.
    pub(super) fn time_from_turn(&self, distance: f64, side: f64) -> f64 {
        let far = distance.sqrt();
        if distance == 0.0 {
            return 0.0;
        }
        let mut sum = 0.0;
        for j in 0..PAIRS {
            let s = far * LONG_NODE[j];
            let square = s * s;
            let (bend, versine) = bends(square);
            let g = side * (self.slope * square + self.g_sine * bend) + self.g_versine * versine;
            let d = self.d + side * (self.d_sine * (square + bend)) + self.d_versine * versine;
            sum += LONG_WEIGHT[j] * (d * square / g).sqrt();
        }
        2.0 * far * sum
    }
}

#[derive(Clone, Debug)]
pub(super) struct RollTable {
    /// At its beginning.
    pub(super) angle: Angle,
    pub(super) expansion: LocalExpansion,
    /// The margins of slips to the two sides, and G.
    pub(super) margins: [Linear; 2],
    pub(super) twice_kinetic: Linear,
    /// The g of orbits that certainly pass it.
    pub(super) g_range: OrbitRange,
    /// What G gains over it.
    pub(super) gain: f64,
    /// Above this g the time over it is the Gauss sum with its own nodes.
    pub(super) smooth: f64,
    /// G − g, and √D times the weights, at the nodes.
    nodes: [[f64; 2 * PAIRS]; 2],
}

impl RollTable {
    pub(super) fn new(limits: &MarginSeries, number: usize) -> Self {
        let law = &limits.law;
        let angle = Angle::of(WIDTH * number as f64);
        let gains = limits.kinetic(angle, 0.0);
        let margins = limits.heavy(angle).map(|[a, b]| {
            let with_gain = core::array::from_fn(|n| a[n] + convolve([(&gains, &b)], n)[0]);
            Linear::new([with_gain, b])
        });
        let twice_kinetic = Linear::new([
            gains,
            core::array::from_fn(|n| if n == 0 { 1.0 } else { 0.0 }),
        ]);
        let expansion = LocalExpansion::new(law, angle, 0.0);
        let half = 0.5 * WIDTH;
        let middle = LocalExpansion::new(law, rotated(angle, half), expansion.gain(half));
        // Of which g is_smooth would hold.
        let reach = ELLIPSE * half;
        let smooth = reach * (middle.slope.abs() + reach * middle.g_bend) / MAX_CHANGE - middle.g;
        let smooth = if (LocalExpansion {
            g: f64::INFINITY,
            ..middle
        })
        .is_smooth(half)
        {
            smooth
        } else {
            f64::INFINITY
        };
        let from_middle = |j: usize| {
            let side = if j.is_multiple_of(2) { half } else { -half };
            side * LONG_NODE[j / 2]
        };
        let gains = core::array::from_fn(|j| middle.g + middle.gain(from_middle(j)));
        let weights = core::array::from_fn(|j| {
            let d = law.denominator_of(rotated(angle, half + from_middle(j)));
            half * LONG_WEIGHT[j / 2] * d.sqrt()
        });
        let g_range = margins.iter().map(|margin| margin.g_range(0.0));
        let g_range = g_range.fold(
            twice_kinetic.g_range(separatrix_distance(law)),
            OrbitRange::intersection,
        );
        Self {
            angle,
            expansion,
            margins,
            g_range,
            gain: expansion.gain(WIDTH),
            smooth,
            nodes: [gains, weights],
            twice_kinetic,
        }
    }

    pub(super) fn time(&self, g: f64) -> f64 {
        let [gains, weights] = &self.nodes;
        let mut sum = 0.0;
        for j in 0..2 * PAIRS {
            sum += weights[j] / (g + gains[j]).sqrt();
        }
        sum
    }
}

/// G of orbits next to the separatrix is less at the top, by the energies as a function of the
/// angle.
pub(super) fn separatrix_distance(law: &RollingLaw) -> f64 {
    MIN_SEPARATRIX_DISTANCE * (law.bottom + energy_variation(law))
}

/// By how much G less its growth downhill varies.
pub(super) fn energy_variation(law: &RollingLaw) -> f64 {
    4.0 * law.offset * (1.0 + law.tilt * law.tilt).sqrt()
}
