//! Sine and cosine together, for flight and the engine.
//!
//! Multiples of π/2, in two parts, reduce the angle to [−π/4, π/4], where both functions are Taylor
//! sums. All operations are IEEE sums and products, so the bits are the same on every platform. The
//! error is below one unit in the last place; the cost is a third of that of `libm`.

use core::f64::consts::{FRAC_2_PI, TAU};

use crate::math::number::Number;

/// Largest reducible angle: its multiple of π/2 stays below 2²⁰, where the product with the leading
/// part is exact.
const MAX_REDUCIBLE_ANGLE: f64 = 1e5;

/// Least distance to the nth multiple of π/2, over n: the trailing part is rounded by up to 7e-27
/// n, 7e-17 of this.
const MIN_REMAINDER_PER_MULTIPLE: f64 = 1e-10;

/// 1.5 × 2⁵²: adding and subtracting it rounds to an integer.
const ROUNDING_SHIFT: f64 = 6_755_399_441_055_744.0;

/// π/2 in two parts. The first has 33 bits: its product with a multiple below 2²⁰ is exact.
const HALF_PI_HIGH: f64 = 1.570_796_326_734_125_6;
const HALF_PI_LOW: f64 = 6.077_100_506_506_192e-11;

/// `sign` (−1)^k/(2k + `first`)! for k = N − 1, …, 0: coefficients of (sin y)/y, (1 − cos y)/y², (y
/// − sin y)/y³, … in y² for `first` = 1, 2, 3, …
pub(crate) const fn taylor<const N: usize>(first: usize, sign: f64) -> [f64; N] {
    let mut coefficients = [0.0; N];
    let (mut term, mut power) = (sign, 1);
    while power <= first {
        term /= power as f64;
        power += 1;
    }
    let mut k = N;
    while k > 0 {
        k -= 1;
        coefficients[k] = term;
        term /= -((power * (power + 1)) as f64);
        power += 2;
    }
    coefficients
}

/// Coefficients of sin r/r and cos r in r², from the highest power down to r².
const SINE: [f64; 8] = taylor(3, -1.0);
const COSINE: [f64; 9] = taylor(2, -1.0);

/// 2π in three parts. The first two have 25 bits: their products with up to 2²⁸ turns are exact.
const TURN: [f64; 3] = [
    6.283_185_243_606_567,
    6.357_301_884_918_343e-8,
    2.449_293_598_294_706_4e-16,
];

/// An angle up to 1e9 modulo 2π, in [−π, π].
pub(crate) fn without_turns(theta: f64) -> f64 {
    let turns = theta / TAU;
    // Preserves the sign of −0.
    if turns.abs() <= 0.5 {
        theta
    } else {
        let turns = turns.round_ties_even();
        TURN.iter().fold(theta, |rest, part| rest - turns * part)
    }
}

/// Whole turns as an unevaluated sum of two numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct WholeTurns {
    turns: f64,
    rest: f64,
}

impl WholeTurns {
    /// An angle with these turns; that of [`split_turns`] comes back to the last bit.
    pub(crate) const fn add_to(self, theta: f64) -> f64 {
        self.turns + (self.rest + theta)
    }
}

/// An angle and a number of whole turns.
pub(crate) fn with_turns(theta: f64, turns: f64) -> f64 {
    turns * TAU + (turns * TURN[2] + theta)
}

/// An angle of up to two turns, less a turn in its direction.
pub(crate) fn less_a_turn(theta: f64) -> f64 {
    let direction = theta.signum();
    (theta - direction * TAU) - direction * TURN[2]
}

/// An angle up to 1e9 modulo 2π, in [−π, π], and the whole turns of the rest. The turns are a sum
/// of two numbers, since 2π has more digits than a double.
pub(crate) fn split_turns(theta: f64) -> (f64, WholeTurns) {
    let remainder = without_turns(theta);
    let turns = theta - remainder;
    let rest = (theta - turns) - remainder;
    let [turns, rest] = [turns, rest].map(neutral_zero);
    (remainder, WholeTurns { turns, rest })
}

/// A number to be added to others, with zero made negative: adding a negative zero leaves every
/// number unchanged, the sign of a zero included.
pub(crate) const fn neutral_zero(value: f64) -> f64 {
    if value == 0.0 { -0.0 } else { value }
}

/// A polynomial, highest power first. Even and odd powers are summed separately, for two short
/// dependency chains.
#[inline(always)]
fn polynomial(coefficients: &[f64], x: f64) -> f64 {
    let square = x * x;
    let (mut this, mut other) = (coefficients[0], 0.0);
    for c in &coefficients[1..] {
        (this, other) = (other * square + c, this);
    }
    other * x + this
}

/// 1 + cos θ without cancellation near the bottom.
#[inline]
pub(crate) fn above_bottom<T: Number>(Angle { sin, cos }: Angle<T>) -> T {
    if cos.value() < 0.0 {
        sin * sin / (-cos + 1.0)
    } else {
        cos + 1.0
    }
}

#[inline]
pub(crate) fn sincos(x: f64) -> (f64, f64) {
    if x.is_nan() || x.abs() >= MAX_REDUCIBLE_ANGLE {
        return libm::sincos(x);
    }
    let shifted = x * FRAC_2_PI + ROUNDING_SHIFT;
    let multiple = shifted - ROUNDING_SHIFT;
    let high = x - multiple * HALF_PI_HIGH;
    let tail = multiple * HALF_PI_LOW;
    let r = high - tail;
    if r.abs() < MIN_REMAINDER_PER_MULTIPLE * multiple.abs() {
        return libm::sincos(x);
    }
    // The rounding error of the difference.
    let rest = (high - r) - tail;
    let (sin, cos) = core_sincos(r, rest);
    // The quadrant is the last two bits of the mantissa.
    let quadrant = shifted.to_bits();
    let (sin, cos) = if quadrant & 1 == 0 {
        (sin, cos)
    } else {
        (cos, -sin)
    };
    if quadrant & 2 == 0 {
        (sin, cos)
    } else {
        (-sin, -cos)
    }
}

/// (sin, cos) of r + `rest`, for |r| ≤ π/4 and a correction below the last digit of r.
#[inline]
fn core_sincos(r: f64, rest: f64) -> (f64, f64) {
    let square = r * r;
    let sine = polynomial(&SINE, square);
    let cosine = polynomial(&COSINE[..COSINE.len() - 1], square);
    // 1 − r²/2 exactly, as the sum `one` + `lost`.
    let half = 0.5 * square;
    let one = 1.0 - half;
    let lost = (1.0 - one) - half;
    (
        r + (rest + r * (square * sine)),
        one + (lost + (square * square * cosine - r * rest)),
    )
}

/// An angle by its sine and cosine, which solvers compute once and pass on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Angle<T = f64> {
    pub(crate) sin: T,
    pub(crate) cos: T,
}

impl Angle {
    /// By [`sincos`]; [`Number::angle`] uses `libm`, whose last digit can differ.
    pub(crate) fn of(theta: f64) -> Self {
        let (sin, cos) = sincos(theta);
        Self { sin, cos }
    }

    /// The angle −θ.
    #[must_use]
    pub(crate) const fn mirrored(self) -> Self {
        Self {
            sin: -self.sin,
            ..self
        }
    }

    /// The angle in a frame that is mirrored for −1.
    #[inline(always)]
    #[must_use]
    pub(crate) const fn mirrored_by(self, mirror: f64) -> Self {
        Self {
            sin: mirror * self.sin,
            ..self
        }
    }

    #[inline(always)]
    #[must_use]
    pub(crate) const fn plus(self, other: Self) -> Self {
        Self {
            sin: self.sin * other.cos + self.cos * other.sin,
            cos: self.cos * other.cos - self.sin * other.sin,
        }
    }

    #[inline(always)]
    #[must_use]
    pub(crate) const fn minus(self, other: Self) -> Self {
        Self {
            sin: self.sin * other.cos - self.cos * other.sin,
            cos: self.cos * other.cos + self.sin * other.sin,
        }
    }

    /// The angle 2 atan z.
    #[inline(always)]
    pub(crate) const fn of_half_tangent(z: f64) -> Self {
        let square = z * z;
        let inverse = 1.0 / (1.0 + square);
        Self {
            sin: 2.0 * z * inverse,
            cos: (1.0 - square) * inverse,
        }
    }
}

/// 1/(k(k + 1)) and 1/((k + 1)(k + 2)) for k = 20, 18, …, 4: ratios of successive terms in
/// `TruncatedSeries`.
const TERM_RATIOS: [(f64, f64); 9] = {
    let mut table = [(0.0, 0.0); 9];
    let mut i = 0;
    while i < 9 {
        let k = (20 - 2 * i) as f64;
        table[i] = (1.0 / (k * (k + 1.0)), 1.0 / ((k + 1.0) * (k + 2.0)));
        i += 1;
    }
    table
};

/// sin φ, 1 − cos φ, φ − sin φ and cos φ − 1 + φ²/2, without cancellation.
#[derive(Clone, Copy, Debug)]
pub(crate) struct TruncatedSeries {
    pub(crate) sine: f64,
    pub(crate) versine: f64,
    pub(crate) odd: f64,
    pub(crate) even: f64,
}

impl TruncatedSeries {
    // Inlined into its callers, the two sums are no longer interleaved.
    #[inline(never)]
    pub(crate) fn new(phi: f64) -> Self {
        let square = phi * phi;
        if phi.abs() > 1.0 {
            let (sine, cosine) = sincos(phi);
            let versine = 1.0 - cosine;
            return Self {
                sine,
                versine,
                odd: phi - sine,
                even: 0.5 * square - versine,
            };
        }
        // φ³/3! − φ⁵/5! + … and φ⁴/4! − φ⁶/6! + …; the omitted terms are below 1/23!.
        let (mut odd, mut even) = (1.0, 1.0);
        for (a, b) in TERM_RATIOS {
            odd = 1.0 - odd * (square * a);
            even = 1.0 - even * (square * b);
        }
        let (odd, even) = (phi * square / 6.0 * odd, square * square / 24.0 * even);
        Self {
            sine: phi - odd,
            versine: 0.5 * square - even,
            odd,
            even,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Next to multiples of a right angle.
    fn next_to_a_right_angle() -> impl Strategy<Value = f64> {
        (
            -60_000..60_000_i32,
            -17.0..-8.0_f64,
            prop_oneof![Just(1.0), Just(-1.0)],
        )
            .prop_map(|(multiple, exponent, sign)| {
                f64::from(multiple) * core::f64::consts::FRAC_PI_2 + sign * libm::exp10(exponent)
            })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(40_000))]

        #[test]
        fn libm_agrees_to_the_last_digit(
            x in prop_oneof![-7.0..7.0_f64, -2e5..2e5_f64, -1e-3..1e-3_f64, next_to_a_right_angle()]
        ) {
            let ((s, c), (sin, cos)) = (sincos(x), libm::sincos(x));
            prop_assert!((s - sin).abs() <= f64::EPSILON * sin.abs(), "{x}: {s} {sin}");
            prop_assert!((c - cos).abs() <= f64::EPSILON * cos.abs(), "{x}: {c} {cos}");
        }
    }

    #[test]
    fn mirror_images_are_equal_to_the_bit() {
        for k in 0..2000 {
            let x = 0.013 * f64::from(k);
            let ((s, c), (sin, cos)) = (sincos(x), sincos(-x));
            assert_eq!((s, c), (-sin, cos));
        }
    }

    #[test]
    fn nan_and_infinity_give_nan() {
        assert!(sincos(f64::NAN).0.is_nan() && sincos(f64::INFINITY).1.is_nan());
    }

    #[test]
    fn angles_add_and_subtract() {
        for (a, b) in [(0.3, 1.1), (-2.0, 0.4), (3.0, 3.1), (1e-9, -0.7)] {
            for (found, expected) in [
                (Angle::of(a).plus(Angle::of(b)), a + b),
                (Angle::of(a).minus(Angle::of(b)), a - b),
                (Angle::of(a).mirrored(), -a),
                (Angle::of(a).mirrored_by(-1.0), -a),
                (Angle::of_half_tangent(libm::tan(0.5 * a)), a),
            ] {
                let (sin, cos) = libm::sincos(expected);
                assert!((found.sin - sin).abs() < 4.0 * f64::EPSILON, "{a} {b}");
                assert!((found.cos - cos).abs() < 4.0 * f64::EPSILON, "{a} {b}");
            }
        }
    }

    /// θ − 2πk from 60 digits of π (mpmath).
    #[test]
    fn whole_turns_are_subtracted_exactly() {
        for (theta, expected) in [
            (1000000000.0, 0.5773954235013852),
            (999999999.4, -0.02260460034047274),
            (3.15, -3.1331853071795868),
            (core::f64::consts::TAU, -2.4492935982947064e-16),
            (31568288.730131123, 1.2337193930378547),
            (12.566370614359172, -4.898587196589413e-16),
            (679789.1632611979, -1.2214931759634842),
            (6776582.185939262, -2.8138572161744166),
            (19038202.888674572, 0.6114730527750171),
            (328535560.1235775, 2.3570234414263056),
            (6533532.079460616, -0.4630982336969978),
            (222602466.42574126, -0.7784590662441263),
        ] {
            assert_eq!(without_turns(theta), expected, "{theta}");
            assert_eq!(without_turns(-theta), -expected, "{theta}");
        }
    }
}
