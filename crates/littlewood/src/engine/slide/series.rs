//! u = θ′² of a slide as a power series in z, the tangent of half the angle turned, and the sign of
//! η″ (docs/engine.md).
//!
//! With n = 1 + z², sin ϑ = S/n, cos ϑ = C/n, q = Q/n and P = R/n², n R du/dz = 4 m Q (n − h C u)
//! has polynomial coefficients: each coefficient of u follows from the six before it. The series
//! converges up to the nearest zero of P, or to z = ± i.

use crate::engine::roll::{LinearNumber, OrbitRange, RoundedNumber};
use crate::math::series::product;
use crate::math::trig::Angle;
use crate::mechanics::SlidingLaw;
use crate::model::Heavy;

pub(super) const DEGREE: usize = 32;

/// Number of coefficients of u from which the next follows.
const TERMS: usize = 6;

/// Part of the first coefficient that the last of a series may be.
pub(super) const CONVERGENCE: f64 = f64::EPSILON / 16.0;

/// A trial width is so much less than the parabola gives: where the terms are a parabola, rounding
/// would decide whether it is too wide.
const WIDTH_MARGIN: f64 = 0.98;

/// Degree of the polynomials whose sign is examined; what they leave out is bounded.
pub(super) const SIGN_DEGREE: usize = 10;

/// Coefficients of powers, the lowest first.
pub(super) type Series = [f64; DEGREE + 1];

/// The lowest of them.
pub(super) type Low = [f64; SIGN_DEGREE + 1];

/// A polynomial whose terms above [`SIGN_DEGREE`] are only bounded.
#[derive(Clone, Copy, Debug)]
pub(super) struct TruncatedPolynomial {
    pub(super) low: Low,
    /// The other terms are nowhere larger.
    pub(super) remainder: f64,
}

const RECIPROCALS: Series = {
    let mut table = [0.0; DEGREE + 1];
    let mut n = 1;
    while n <= DEGREE {
        table[n] = 1.0 / n as f64;
        n += 1;
    }
    table
};

/// A polynomial in t = z/width from one in z.
#[inline(always)]
pub(super) fn scaled<const N: usize>(mut polynomial: [f64; N], width: f64) -> [f64; N] {
    let mut power = 1.0;
    for c in &mut polynomial {
        *c *= power;
        power *= width;
    }
    polynomial
}

/// The value of a polynomial of even degree at a point, even and odd powers apart: two short chains
/// instead of a long one.
#[inline(always)]
pub(super) fn value(coefficients: &[f64], at: f64) -> f64 {
    let Some((last, others)) = coefficients.split_last() else {
        return 0.0;
    };
    let (pairs, rest) = others.as_chunks();
    debug_assert!(rest.is_empty(), "an even degree");
    let square = at * at;
    let (mut even, mut odd) = (*last, 0.0);
    for [lower, upper] in pairs.iter().rev() {
        odd = odd * square + upper;
        even = even * square + lower;
    }
    even + at * odd
}

/// The 32nd root.
fn root(x: f64) -> f64 {
    x.sqrt().sqrt().sqrt().sqrt().sqrt()
}

#[inline(always)]
fn power(x: f64, mut exponent: usize) -> f64 {
    let (mut square, mut result) = (x, 1.0);
    while exponent > 0 {
        if exponent % 2 == 1 {
            result *= square;
        }
        square *= square;
        exponent /= 2;
    }
    result
}

/// Signs of a function on an interval, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum SignPattern {
    Positive,
    Negative,
    /// From positive to negative.
    Falling,
    /// From negative to positive.
    Rising,
    Unknown,
}

/// The signs of σ η″ on an interval.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlipSigns {
    pub(super) pattern: SignPattern,
    /// Largest |η″| where its sign is not known, about a change of sign.
    pub(super) sign_uncertainty: f64,
}

impl SlipSigns {
    /// The pattern behind a point at which σ η″ has this value: the change of sign may lie before
    /// it.
    pub(super) fn pattern_behind(&self, slip_acceleration: f64) -> SignPattern {
        match self.pattern {
            SignPattern::Rising if slip_acceleration > self.sign_uncertainty => {
                SignPattern::Positive
            }
            SignPattern::Falling if slip_acceleration < -self.sign_uncertainty => {
                SignPattern::Negative
            }
            pattern => pattern,
        }
    }
}

impl SignPattern {
    pub(super) const fn reversed(self) -> Self {
        match self {
            Self::Falling => Self::Rising,
            Self::Rising => Self::Falling,
            Self::Positive | Self::Negative | Self::Unknown => self,
        }
    }
}

/// The value of a solution at the centre, and the part of the drive that it has.
#[derive(Clone, Copy, Debug)]
pub(super) struct InitialValue {
    pub(super) u: f64,
    pub(super) drive: f64,
}

/// The terms of a series from the one with index `first` on, at `stretch` times a width of at most
/// `max_width`, are at most `max_ratio` of the term with index `lead`.
#[derive(Clone, Copy, Debug)]
pub(super) struct TermBound {
    pub(super) lead: usize,
    pub(super) first: usize,
    pub(super) max_width: f64,
    pub(super) stretch: f64,
    pub(super) max_ratio: f64,
}

/// The linear equation that u obeys, of a slide or of rolling with resistance, about an angle:
/// M du/dz = `scale` (drive − `factor` damping u) with polynomials in z.
#[derive(Clone, Copy, Debug)]
pub(super) struct LinearTerms {
    pub(super) multiplier: [f64; 7],
    pub(super) scale: f64,
    pub(super) drive: [f64; 5],
    pub(super) factor: f64,
    pub(super) damping: [f64; 5],
}

/// Its coefficients: (k + 1) u_{k+1} = drive_k − Σ_j ((k + 1) l_j + rest_j) u_{k−j}, with u_k = 0 for
/// k < 0.
#[derive(Clone, Debug)]
pub(super) struct LinearEquation {
    l: [f64; TERMS],
    rest: [f64; TERMS],
    drive: [f64; 5],
}

impl LinearEquation {
    pub(super) fn new(terms: &LinearTerms) -> Self {
        let LinearTerms {
            multiplier,
            scale,
            drive,
            factor,
            damping,
        } = terms;
        let inverse = 1.0 / multiplier[0];
        let scale = scale * inverse;
        let l: [f64; TERMS] = core::array::from_fn(|j| multiplier[j + 1] * inverse);
        let rest = core::array::from_fn(|j| {
            let damped = if j < 5 {
                scale * factor * damping[j]
            } else {
                0.0
            };
            damped - (j + 1) as f64 * l[j]
        });
        Self {
            l,
            rest,
            drive: drive.map(|c| scale * c),
        }
    }

    /// The solutions with these values at the angle, computed side by side.
    #[inline(always)]
    pub(super) fn solutions<const N: usize>(&self, initial: [InitialValue; N]) -> [Series; N] {
        let Self { l, rest, drive, .. } = self;
        let mut u = [[0.0; DEGREE + 1]; N];
        // The last coefficients, the latest first: in registers, not read again as soon as they are
        // written.
        let mut last = [[0.0; N]; TERMS];
        for i in 0..N {
            last[0][i] = initial[i].u;
            u[i][0] = initial[i].u;
        }
        let drive = |k: usize| drive.get(k).copied().unwrap_or(0.0);
        for k in 0..DEGREE {
            let part = RECIPROCALS[k + 1];
            let factor = |j: usize| l[j] + rest[j] * part;
            let drive = drive(k) * part;
            let mut next = [0.0; N];
            for i in 0..N {
                let far = factor(5) * last[5][i] + factor(4) * last[4][i];
                let near = factor(3) * last[3][i] + factor(2) * last[2][i];
                let sum = (initial[i].drive * drive - far) - (near + factor(1) * last[1][i]);
                // The latest alone: it is waited for.
                next[i] = sum - factor(0) * last[0][i];
                u[i][k + 1] = next[i];
            }
            last = [next, last[0], last[1], last[2], last[3], last[4]];
        }
        u
    }
}

/// A number a + b u, with polynomials in z.
#[derive(Clone, Debug)]
pub(super) struct LinearForm {
    pub(super) a: [f64; 7],
    pub(super) b: [f64; 7],
}

impl LinearForm {
    /// So much of a, and b u, in powers of t = z/width, where u is given in them.
    #[inline(always)]
    pub(super) fn on(&self, u: &Series, width: f64, part_of_a: f64) -> TruncatedPolynomial {
        let b = scaled(self.b, width);
        // Sums of the sizes of the coefficients of u from each on.
        let mut rest = 0.0;
        for c in u[SIGN_DEGREE + 1..].iter().rev() {
            rest += c.abs();
        }
        let mut low = [0.0; SIGN_DEGREE + 1];
        let mut remainder = 0.0;
        for j in 0..7 {
            // What the factor b_j leaves out: the coefficients of u above SIGN_DEGREE − j.
            remainder += b[j].abs() * rest;
            rest += u[SIGN_DEGREE - j].abs();
            for k in j..SIGN_DEGREE + 1 {
                low[k] += b[j] * u[k - j];
            }
        }
        for (low, a) in low.iter_mut().zip(scaled(self.a, width)) {
            *low += part_of_a * a;
        }
        TruncatedPolynomial { low, remainder }
    }
}

/// What is known of the solutions of one family about an angle.
pub(super) trait Family {
    /// The signs of the numbers that decide on events.
    type Signs: Signs;

    /// The signs up to a width, from u in powers of t = z/width. Where what decides vanishes at t = 0
    /// (`from_zero`), those behind that. None where the equation is not known to be regular.
    fn signs(&self, u: &Series, width: f64, from_zero: bool) -> Option<Self::Signs>;
}

pub(super) trait Signs: Clone {
    /// Whether an event can neither be found nor excluded.
    fn are_unknown(&self) -> bool;
}

impl Signs for SlipSigns {
    fn are_unknown(&self) -> bool {
        self.pattern == SignPattern::Unknown
    }
}

/// The polynomials in z of a body that slides in one direction about an angle.
#[derive(Clone, Debug)]
pub(super) struct SlidePolynomials {
    /// n² P.
    p: [f64; 5],
    /// n³ P σ η″.
    pub(super) slip_acceleration: LinearForm,
    pub(super) equation: LinearEquation,
}

impl SlidePolynomials {
    /// About an angle, for the direction `sigma` of slip.
    pub(super) fn new(law: &SlidingLaw, sigma: f64, Angle { sin, cos }: Angle) -> Self {
        let Heavy {
            mass, h, inertia, ..
        } = law.body;
        let (n, nn) = ([1.0, 0.0, 1.0], [1.0, 0.0, 2.0, 0.0, 1.0]);
        let (s, c) = ([sin, 2.0 * cos, -sin], [cos, -2.0 * sin, -cos]);
        let q: [f64; 3] = core::array::from_fn(|k| law.q(n[k], s[k], c[k]));
        let sq: [f64; 5] = product(&s, &q);
        let p: [f64; 5] = core::array::from_fn(|k| inertia * nn[k] + mass * h * sq[k]);
        let equation = LinearEquation::new(&LinearTerms {
            multiplier: product(&p, &n),
            scale: 4.0 * mass,
            drive: product(&n, &q),
            factor: h,
            damping: product(&c, &q),
        });
        // α = A/P and β = B/P of η″ = α + β u.
        let slip_coefficient: [f64; 3] = core::array::from_fn(|k| n[k] + h * c[k]);
        let lq: [f64; 5] = product(&slip_coefficient, &q);
        let a: [f64; 5] =
            core::array::from_fn(|k| sigma * (mass * lq[k] - law.friction * inertia * nn[k]));
        let ca: [f64; 7] = product(&c, &a);
        let sp: [f64; 7] = product(&s, &p);
        let b = core::array::from_fn(|k| -h * (ca[k] + sigma * sp[k]));
        let pulled: [f64; 5] = core::array::from_fn(|k| a[k] - sigma * law.body.pull() * p[k]);
        Self {
            p,
            slip_acceleration: LinearForm {
                a: product(&pulled, &n),
                b,
            },
            equation,
        }
    }

    /// n² P in powers of t = z/width.
    pub(super) fn p(&self, width: f64) -> [f64; 5] {
        scaled(self.p, width)
    }
}

/// A solution about an angle: a slide, or rolling with resistance.
#[derive(Clone, Debug)]
pub(super) struct Expansion<F = SlidePolynomials> {
    /// u in powers of z.
    pub(super) u: Series,
    pub(super) family: F,
}

impl Expansion {
    /// The slide in the direction `sigma` of slip through an angle with this u.
    pub(super) fn new(law: &SlidingLaw, sigma: f64, angle: Angle, u: f64) -> Self {
        let family = SlidePolynomials::new(law, sigma, angle);
        let [u] = family.equation.solutions([InitialValue { u, drive: 1.0 }]);
        Self { u, family }
    }
}

impl<F> Expansion<F> {
    /// The width in z on which u/z^`lead`, of which u has the factor, has converged.
    pub(super) fn convergence_radius(&self, lead: usize) -> f64 {
        convergence_radius(&self.u, lead, self.u[lead].abs())
    }

    /// z of the zero of u next to the centre, by Newton's method; none where it leads beyond the
    /// width on which u has converged.
    pub(super) fn zero(&self, convergence_radius: f64) -> Option<f64> {
        let mut z = -self.u[0] / self.u[1];
        for _ in 0..20 {
            let (mut value, mut slope) = (0.0, 0.0);
            for c in self.u.iter().rev() {
                (value, slope) = (value * z + c, slope * z + value);
            }
            let step = -value / slope;
            z += step;
            if z.is_nan() || z.abs() > convergence_radius {
                return None;
            }
            if step.abs() <= 1e-9 * z.abs() {
                return Some(z);
            }
        }
        None
    }

    /// The widest width, or nearly, that satisfies a bound.
    pub(super) fn smooth(&self, bound: TermBound) -> Option<f64> {
        let TermBound {
            lead,
            first,
            max_width,
            stretch,
            max_ratio,
        } = bound;
        let max_sum = max_ratio * self.u[lead].abs();
        let linear = if first == lead + 1 {
            self.u[first].abs()
        } else {
            0.0
        };
        let terms = |far: f64| sum_of_sizes(&self.u[first..], far) * power(far, first - lead);
        let far = stretch * max_width;
        let sum = terms(far);
        if sum <= max_sum {
            return (max_width > 0.0).then_some(max_width);
        }
        // Behind a linear term the sum grows at least with the square of the width: as far as the
        // parabola through it leads, and, by the parabola through the sum there, perhaps farther.
        let parabola = |far: f64, sum: f64| {
            let bend = (sum - linear * far) / (far * far);
            2.0 * max_sum / (linear + (linear * linear + 4.0 * bend * max_sum).sqrt())
        };
        let near = parabola(far, sum);
        let near_sum = terms(near);
        let farther = WIDTH_MARGIN * parabola(near, near_sum);
        let sum = terms(farther);
        // The secant of a convex function lies above it.
        let secant = || near + (farther - near) * (max_sum - near_sum) / (sum - near_sum);
        let width = if sum <= max_sum { farther } else { secant() } / stretch;
        (width > 0.0).then_some(width)
    }
}

impl Family for SlidePolynomials {
    type Signs = SlipSigns;

    /// Of σ η″, or where that is zero at t = 0, of η″/t; none where P is not known to be positive.
    fn signs(&self, u: &Series, width: f64, from_zero: bool) -> Option<SlipSigns> {
        let min_p = min_value(self.p(width));
        if min_p <= 0.0 {
            return None;
        }
        let TruncatedPolynomial { mut low, remainder } = self.slip_acceleration.on(u, width, 1.0);
        if from_zero {
            // What is left of the first coefficient is the rounding of the start.
            low.rotate_left(1);
            low[SIGN_DEGREE] = 0.0;
        }
        let bernstein = TruncatedPolynomial {
            low: bernstein(low),
            remainder,
        };
        Some(bernstein.slip_signs(min_p))
    }
}

impl TruncatedPolynomial {
    /// a + u b with u > 0, or with either sign.
    #[inline(always)]
    pub(super) fn of(a: &Self, b: &Self, u: f64) -> Self {
        Self {
            low: core::array::from_fn(|k| a.low[k] + u * b.low[k]),
            remainder: a.remainder + u.abs() * b.remainder,
        }
    }

    /// The u > 0 for which a + u b with Bernstein coefficients, times `sign`, is certainly positive;
    /// `scale` is the size of the terms.
    pub(super) fn positive(a: &Self, b: &Self, sign: f64, scale: f64) -> OrbitRange {
        let least = |part: &Self| {
            let remainder = part.remainder;
            part.low.map(|c| RoundedNumber {
                value: sign * c - remainder,
                scale,
            })
        };
        let numbers = least(a).into_iter().zip(least(b));
        OrbitRange::of_positive(0.0, numbers.map(|(a, b)| LinearNumber { a, b }))
    }

    /// The signs of a function with these Bernstein coefficients.
    pub(super) fn pattern(&self) -> SignPattern {
        sign_pattern(&self.low, self.remainder)
    }

    /// The signs of σ η″ from n³ P σ η″ with Bernstein coefficients, where P is nowhere less than
    /// `min_p`.
    pub(super) fn slip_signs(&self, min_p: f64) -> SlipSigns {
        SlipSigns {
            pattern: self.pattern(),
            sign_uncertainty: sign_uncertainty(self.remainder, min_p),
        }
    }

    /// The largest coefficient, with what is left out.
    pub(super) fn size(&self) -> f64 {
        let largest = self.low.iter().fold(0.0, |max: f64, c| max.max(c.abs()));
        largest + self.remainder
    }
}

/// About a change of sign a function is at most twice what its sum leaves out.
pub(super) fn sign_uncertainty(remainder: f64, min_p: f64) -> f64 {
    2.0 * remainder / min_p
}

/// The width in z on which a series, divided by z^`lead`, has converged beside a number of this
/// size.
pub(super) fn convergence_radius(series: &Series, lead: usize, size: f64) -> f64 {
    let scale = CONVERGENCE * size;
    let width = root(scale / series[DEGREE].abs()).min(1.0);
    // The last coefficient may be small by chance.
    let before = series[DEGREE - 1].abs() * power(width, DEGREE - 1 - lead);
    if before > scale {
        width * root(scale / before)
    } else {
        width
    }
}

/// Σ |c_k| z^k.
pub(super) fn sum_of_sizes(coefficients: &[f64], z: f64) -> f64 {
    let fourth = (z * z) * (z * z);
    // Four sums, of every fourth term each: none waits for the others.
    let mut sums = [0.0; 4];
    for four in coefficients.chunks(4).rev() {
        for (sum, c) in sums.iter_mut().zip(four) {
            *sum = *sum * fourth + c.abs();
        }
    }
    let [a, b, c, d] = sums;
    ((d * z + c) * z + b) * z + a
}

/// The coefficients of a polynomial in powers of t as Bernstein coefficients on [0, 1].
#[inline(always)]
pub(super) fn bernstein<const N: usize>(mut c: [f64; N]) -> [f64; N] {
    let mut inverse = 1.0;
    for (k, c) in c.iter_mut().enumerate().skip(1) {
        inverse *= k as f64 / (N - k) as f64;
        *c *= inverse;
    }
    for level in 1..N {
        for j in (level..N).rev() {
            c[j] += c[j - 1];
        }
    }
    c
}

/// The smallest Bernstein coefficient of a polynomial on [0, 1], on which it is nowhere less.
pub(super) fn min_value<const N: usize>(polynomial: [f64; N]) -> f64 {
    bernstein(polynomial)
        .into_iter()
        .fold(f64::INFINITY, f64::min)
}

/// A polynomial in (1 + t)/2 from one in t: what it is on [−1, 1] as one on [0, 1].
pub(super) fn from_both_sides<const N: usize>(mut c: [f64; N]) -> [f64; N] {
    for i in 0..N {
        for j in (i..N - 1).rev() {
            c[j] -= c[j + 1];
        }
    }
    scaled(c, 2.0)
}

/// Signs of a function whose Bernstein coefficients are known to `band`.
fn sign_pattern(coefficients: &Low, band: f64) -> SignPattern {
    // A function has no more changes of sign than its coefficients. One change for certain: a
    // prefix with the first sign, a suffix with the other, and between them only what is not known.
    let sign_of_first = f64::copysign(1.0, coefficients[0]);
    let is_first = |b: &&f64| sign_of_first * **b > band;
    let is_last = |b: &&f64| -sign_of_first * **b > band;
    let begin = coefficients.iter().take_while(is_first).count();
    if begin == coefficients.len() {
        return if sign_of_first > 0.0 {
            SignPattern::Positive
        } else {
            SignPattern::Negative
        };
    }
    let end = coefficients.iter().rev().take_while(is_last).count();
    if begin == 0 || end == 0 {
        return SignPattern::Unknown;
    }
    let between = &coefficients[begin..coefficients.len() - end];
    if between.iter().any(|b| b.abs() > band) {
        return SignPattern::Unknown;
    }
    if sign_of_first > 0.0 {
        SignPattern::Falling
    } else {
        SignPattern::Rising
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Body, Hoop, SlipDirection};

    /// The sign_pattern of coefficients that are these multiples of the band.
    fn pattern_of(coefficients: [f64; SIGN_DEGREE + 1]) -> SignPattern {
        sign_pattern(&coefficients.map(|b| 1e-3 * b), 1e-3)
    }

    /// Near rest, where u is small and hardly changes, too.
    #[test]
    fn widths_are_as_wide_as_they_may_be() {
        let Body::Heavy(body) = Hoop::equal_masses(0.5, 0.4).unwrap().body() else {
            unreachable!("it has mass")
        };
        let law = SlidingLaw::of_body(body, 0.4, SlipDirection::Positive);
        let mut narrower = 0;
        for (theta, u) in [0.3, 1.8, 2.9, 3.1, 4.4]
            .into_iter()
            .flat_map(|theta| [1e-12, 1e-8, 1e-5, 1e-2, 1.0, 30.0].map(|u| (theta, u)))
        {
            let expansion = Expansion::new(&law, 1.0, Angle::of(theta), u);
            for (lead, first) in [(0, 1), (0, 2), (1, 2)] {
                let terms = |far: f64| -> f64 {
                    (first..=DEGREE)
                        .map(|k| expansion.u[k].abs() * libm::pow(far, (k - lead) as f64))
                        .sum()
                };
                let max_sum = 0.9 * expansion.u[lead].abs();
                for max_width in [1e-3, 0.2] {
                    let bound = TermBound {
                        lead,
                        first,
                        max_width,
                        stretch: 1.8,
                        max_ratio: 0.9,
                    };
                    let width = expansion.smooth(bound).unwrap();
                    assert!(
                        width <= max_width && terms(1.8 * width) <= max_sum * (1.0 + 1e-12),
                        "{theta} {u}: {width}"
                    );
                    if width < max_width {
                        narrower += 1;
                        assert!(
                            terms(1.8 * 1.25 * width) > max_sum,
                            "{theta} {u} {lead} {first}: {width}"
                        );
                    }
                }
            }
        }
        assert!(narrower > 40, "{narrower}");
        // From rest there is no width on which u stays away from zero.
        let rest = Expansion::new(&law, 1.0, Angle::of(0.3), 0.0);
        let bound = TermBound {
            lead: 0,
            first: 1,
            max_width: rest.convergence_radius(0),
            stretch: 1.8,
            max_ratio: 0.9,
        };
        assert_eq!(rest.smooth(bound), None);
    }

    /// Where P is as small as it may be, and what the sum leaves out as large: the largest η″ at
    /// which the sum does not tell the sign.
    #[test]
    fn the_sign_of_a_slip_acceleration_is_uncertain_up_to_the_largest_that_may_have_either() {
        for (remainder, min_p) in [(0.01, 1.0), (0.01, 0.1), (0.03, 7.0), (1e-9, 0.3)] {
            let at = |part: f64| remainder * (4.0 * part - 2.0);
            let sum = TruncatedPolynomial {
                low: core::array::from_fn(|k| at(k as f64 / SIGN_DEGREE as f64)),
                remainder,
            };
            let values = (0..=1_000).map(|k| at(f64::from(k) / 1_000.0));
            let largest = values
                .filter(|low| low.abs() <= remainder)
                .flat_map(|low| [low - remainder, low + remainder])
                .fold(0.0_f64, |largest, value| largest.max(value.abs() / min_p));
            let told = sum.slip_signs(min_p).sign_uncertainty;
            assert!(
                told >= largest && told < 1.01 * largest,
                "{remainder} {min_p}: {told} {largest}"
            );
        }
    }

    #[test]
    fn sign_patterns_are_known_only_where_all_signs_are_certain() {
        let [up, down] = [[5.0; SIGN_DEGREE + 1], [-5.0; SIGN_DEGREE + 1]];
        assert_eq!(
            (pattern_of(up), pattern_of(down)),
            (SignPattern::Positive, SignPattern::Negative)
        );
        for at in 1..SIGN_DEGREE {
            // What is doubtful between two signs may be the change; what is clear is another
            // change.
            let with = |mut coefficients: [f64; SIGN_DEGREE + 1], doubtful: f64| {
                coefficients[at..].iter_mut().for_each(|b| *b = -*b);
                coefficients[at] = doubtful;
                pattern_of(coefficients)
            };
            for doubtful in [0.9, 0.0, -0.9] {
                assert_eq!(with(up, doubtful), SignPattern::Falling, "{at} {doubtful}");
                assert_eq!(with(down, doubtful), SignPattern::Rising, "{at} {doubtful}");
                let mut touched = up;
                touched[at] = doubtful;
                assert_eq!(pattern_of(touched), SignPattern::Unknown, "{at} {doubtful}");
            }
            let twice = |mut coefficients: [f64; SIGN_DEGREE + 1]| {
                coefficients[at] = -coefficients[at];
                coefficients[SIGN_DEGREE] = -coefficients[SIGN_DEGREE];
                pattern_of(coefficients)
            };
            let expected = if at == SIGN_DEGREE - 1 {
                [SignPattern::Falling, SignPattern::Rising]
            } else {
                [SignPattern::Unknown; 2]
            };
            assert_eq!([twice(up), twice(down)], expected, "{at}");
        }
        for end in [0, SIGN_DEGREE] {
            let mut doubtful = up;
            doubtful[end] = 0.9;
            assert_eq!(pattern_of(doubtful), SignPattern::Unknown, "{end}");
        }
    }
}
