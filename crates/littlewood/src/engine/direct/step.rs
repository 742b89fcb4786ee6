//! A step of a slide: u = θ′² as a power series in the tangent of half the angle turned.
//!
//! With z = tan(φ/2), φ the angle since the beginning of the step in the direction of motion, and n = 1 + z², the sine and the
//! cosine of ϑ are quadratic in z over n, q = Q/n and P = S/n² with polynomials Q and S of degrees two and four, so that the
//! linear equation of sliding, du/dϑ = 2 m q (1 − h cos ϑ u)/P, reads
//!
//! ```text
//! n S du/dz = 4 m Q (n − h C u),        C = n cos ϑ.
//! ```
//!
//! Its coefficients are polynomials: each coefficient of u follows from the six before it. The series converges up to the nearest
//! zero of P, or to z = ± i.

use crate::equations::SlidingLaw;
use crate::hoop::Heavy;

use super::super::piece::Piece;
use super::super::quadrature::{NODE, NODES, WEIGHT};

/// Degree of the series.
const DEGREE: usize = 32;

/// Part of u that the last coefficient of a step may be.
const CONVERGED: f64 = f64::EPSILON / 16.0;

/// By how much of itself u may change on a step: the Gauss sum of 1/√u is then exact to rounding.
const SMOOTH: f64 = 0.5;

/// Degree of the polynomials whose sign is examined; what they leave out is bounded.
const LOW: usize = 10;

/// Number of coefficients of u from which the next follows.
const TERMS: usize = 6;

type Series = [f64; DEGREE + 1];

/// 1/n.
const RECIPROCALS: Series = {
    let mut table = [0.0; DEGREE + 1];
    let mut n = 1;
    while n <= DEGREE {
        table[n] = 1.0 / n as f64;
        n += 1;
    }
    table
};

/// Powers of the Gauss nodes on [0, 1], by power.
const POWERS: [[f64; NODES]; DEGREE + 1] = {
    let mut table = [[1.0; NODES]; DEGREE + 1];
    let mut k = 1;
    while k <= DEGREE {
        let mut j = 0;
        while j < NODES {
            table[k][j] = table[k - 1][j] * (0.5 + 0.5 * NODE[j]);
            j += 1;
        }
        k += 1;
    }
    table
};

/// 1 over the binomial coefficients of `LOW`.
const INVERSE_BINOMIALS: [f64; LOW + 1] = {
    let mut table = [1.0; LOW + 1];
    let mut binomial = 1.0;
    let mut k = 1;
    while k <= LOW {
        binomial = binomial * (LOW + 1 - k) as f64 / k as f64;
        table[k] = 1.0 / binomial;
        k += 1;
    }
    table
};

/// Product of two polynomials.
#[inline(always)]
fn product<const A: usize, const B: usize, const C: usize>(a: [f64; A], b: [f64; B]) -> [f64; C] {
    let mut result = [0.0; C];
    for i in 0..A {
        for j in 0..B {
            result[i + j] += a[i] * b[j];
        }
    }
    result
}

/// Signs of a function on a step, in order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Signs {
    Positive,
    Negative,
    /// From positive to negative, once.
    Falling,
    /// From negative to positive, once.
    Rising,
    Unknown,
}

/// A step of a slide, in the frame of motion.
#[derive(Clone, Copy, Debug)]
pub(super) struct Step {
    /// z at the end.
    pub(super) width: f64,
    /// u as a polynomial in t = z/width.
    u: Series,
    /// Signs of σ η″ on the step.
    pub(super) signs: Signs,
    /// Largest |η″| where its sign is not known, about a change of sign.
    pub(super) doubt: f64,
    /// sin ϑ and cos ϑ at the beginning.
    direction: (f64, f64),
}

impl Step {
    /// The step from an angle with this sine and cosine, with the direction `sigma` of slip. None where P vanishes so near that the
    /// series does not converge.
    pub(super) fn new(law: &SlidingLaw, sigma: f64, (sin, cos): (f64, f64), u0: f64) -> Option<Self> {
        let Heavy { mass, h, inertia, .. } = law.body;
        let n = [1.0, 0.0, 1.0];
        let (s, c) = ([sin, 2.0 * cos, -sin], [cos, -2.0 * sin, -cos]);
        let q: [f64; 3] = core::array::from_fn(|k| law.q(n[k], s[k], c[k]));
        let sq: [f64; 5] = product(s, q);
        let nn = [1.0, 0.0, 2.0, 0.0, 1.0];
        let p: [f64; 5] = core::array::from_fn(|k| inertia * nn[k] + mass * h * sq[k]);
        let left: [f64; 7] = product(p, n);
        let cq: [f64; 5] = product(c, q);
        let nq: [f64; 5] = product(n, q);
        let inverse = 1.0 / left[0];
        // (k + 1) u_{k+1} = drive_k − Σ (l_j (k − j) + g_j) u_{k−j}, with u_k = 0 for k < 0.
        let scale = 4.0 * mass * inverse;
        let drive = nq.map(|c| scale * c);
        let l: [f64; TERMS] = core::array::from_fn(|j| left[j + 1] * inverse);
        let rest: [f64; TERMS] =
            core::array::from_fn(|j| if j < 5 { scale * h * cq[j] } else { 0.0 } - j as f64 * l[j]);
        let mut padded = [0.0; DEGREE + TERMS];
        padded[TERMS - 1] = u0;
        for k in 0..DEGREE {
            let order = k as f64;
            let mut sum = if k < 5 { drive[k] } else { 0.0 };
            // The latest last: it is waited for.
            let window: &[f64; TERMS] = padded[k..].first_chunk()?;
            for (i, u) in window.iter().enumerate() {
                let j = TERMS - 1 - i;
                sum -= (l[j] * order + rest[j]) * u;
            }
            padded[k + TERMS] = sum * RECIPROCALS[k + 1];
        }
        let series: &Series = padded[TERMS - 1..].first_chunk()?;
        let width = width(series)?;
        let mut power = 1.0;
        let mut u = *series;
        for c in &mut u {
            *c *= power;
            power *= width;
        }
        // P η″ n³ = A n + B u.
        let a: [f64; 5] = {
            let lever: [f64; 3] = core::array::from_fn(|k| n[k] + h * c[k]);
            let aq: [f64; 5] = product(lever, q);
            core::array::from_fn(|k| mass * aq[k] - law.friction * inertia * nn[k])
        };
        let an: [f64; 7] = product(a, n);
        let ca: [f64; 7] = product(c, a);
        let sp: [f64; 7] = product(s, p);
        let b: [f64; 7] = core::array::from_fn(|k| -sigma * h * (ca[k] + sp[k]));
        let an = an.map(|c| sigma * c);
        let least = least(&scaled(p, width));
        if least <= 0.0 {
            return None;
        }
        let (signs, band) = signs(&u, &scaled(an, width), &scaled(b, width));
        Some(Self { width, u, signs, doubt: 2.0 * band / least, direction: (sin, cos) })
    }
}

/// A polynomial in t = z/width.
#[inline(always)]
fn scaled<const N: usize>(mut polynomial: [f64; N], width: f64) -> [f64; N] {
    let mut power = 1.0;
    for c in &mut polynomial {
        *c *= power;
        power *= width;
    }
    polynomial
}

/// The width on which a series has converged, and u changes little.
fn width(series: &Series) -> Option<f64> {
    let scale = CONVERGED * series[0];
    // The root of degree 32.
    let root = |x: f64| x.sqrt().sqrt().sqrt().sqrt().sqrt();
    let mut width = root(scale / series[DEGREE].abs()).min(1.0);
    for _ in 0..8 {
        let (mut change, mut power) = (0.0, 1.0);
        for c in &series[1..] {
            power *= width;
            change += c.abs() * power;
        }
        // The last coefficient may be small by chance.
        let before = series[DEGREE - 1].abs() * power / width;
        width *= if before > 2.0 * scale {
            root(scale / before)
        } else if change > SMOOTH * series[0] {
            0.98 * SMOOTH * series[0] / change
        } else {
            return (width > 0.0).then_some(width);
        };
    }
    None
}

/// The smallest Bernstein coefficient of a polynomial of degree four: it is nowhere less on [0, 1].
fn least(p: &[f64; 5]) -> f64 {
    let mut b = [p[0], p[1] / 4.0, p[2] / 6.0, p[3] / 4.0, p[4]];
    for level in 1..5 {
        for j in (level..5).rev() {
            b[j] += b[j - 1];
        }
    }
    b.into_iter().fold(f64::INFINITY, f64::min)
}

/// Signs of a + b u on [0, 1], and to what it is known.
fn signs(u: &Series, a: &[f64; 7], b: &[f64; 7]) -> (Signs, f64) {
    // Sums of the sizes of the coefficients from each on.
    let mut rest = 0.0;
    for c in u[LOW + 1..].iter().rev() {
        rest += c.abs();
    }
    let mut low = [0.0; LOW + 1];
    let mut band = 0.0;
    for j in 0..7 {
        // What b_j leaves out: the coefficients of u above LOW − j.
        band += b[j].abs() * rest;
        if j < 6 {
            rest += u[LOW - j].abs();
        }
        low[j] = a[j];
    }
    for j in 0..7 {
        for k in j..=LOW {
            low[k] += b[j] * u[k - j];
        }
    }
    for (c, inverse) in low.iter_mut().zip(INVERSE_BINOMIALS) {
        *c *= inverse;
    }
    for level in 1..=LOW {
        for j in (level..=LOW).rev() {
            low[j] += low[j - 1];
        }
    }
    (pattern(&low, band), band)
}

/// Signs of a function whose Bernstein coefficients are known to `band`.
fn pattern(coefficients: &[f64; LOW + 1], band: f64) -> Signs {
    let sign = |b: f64| {
        if b > band {
            1
        } else if b < -band {
            -1
        } else {
            0
        }
    };
    let first = sign(coefficients[0]);
    let last = sign(coefficients[LOW]);
    let mut changed = false;
    for b in coefficients {
        let sign = sign(*b);
        if sign == first && changed || sign != first && sign != last && sign != 0 {
            return Signs::Unknown;
        }
        changed |= sign != first;
    }
    match (first, last) {
        (1, 1) => {
            if changed {
                Signs::Unknown
            } else {
                Signs::Positive
            }
        }
        (-1, -1) => {
            if changed {
                Signs::Unknown
            } else {
                Signs::Negative
            }
        }
        (1, -1) => Signs::Falling,
        (-1, 1) => Signs::Rising,
        _ => Signs::Unknown,
    }
}

impl Step {
    /// Time of the whole step.
    pub(super) fn whole_time(&self) -> f64 {
        let mut u = [0.0; NODES];
        for (c, powers) in self.u.iter().zip(&POWERS) {
            for j in 0..NODES {
                u[j] += c * powers[j];
            }
        }
        let square = self.width * self.width;
        let mut sum = 0.0;
        for j in 0..NODES {
            sum += WEIGHT[j] / ((1.0 + square * POWERS[2][j]) * u[j].sqrt());
        }
        self.width * sum
    }

    /// Angle turned at t.
    pub(super) fn turned_by(&self, t: f64) -> f64 {
        2.0 * libm::atan(self.width * t)
    }
}

impl Piece for Step {
    fn u(&self, t: f64) -> f64 {
        let square = t * t;
        let (mut even, mut odd) = (self.u[DEGREE], 0.0);
        let mut k = DEGREE;
        while k > 0 {
            odd = odd * square + self.u[k - 1];
            even = even * square + self.u[k - 2];
            k -= 2;
        }
        even + t * odd
    }

    fn direction(&self, t: f64) -> (f64, f64) {
        let z = self.width * t;
        let (square, twice) = (z * z, 2.0 * z);
        let (sin, cos) = self.direction;
        let inverse = 1.0 / (1.0 + square);
        let (turn_sin, turn_cos) = (twice * inverse, (1.0 - square) * inverse);
        (sin * turn_cos + cos * turn_sin, cos * turn_cos - sin * turn_sin)
    }

    fn turned(&self, _: (f64, f64), t: f64, step: f64) -> (f64, f64) {
        self.direction(t + step)
    }

    fn turning(&self, t: f64) -> f64 {
        let z = self.width * t;
        2.0 * self.width / (1.0 + z * z)
    }

    fn time(&self, from: f64, to: f64) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let t = NODE.map(|node| middle + half * node);
        let mut u = [self.u[DEGREE]; NODES];
        for c in self.u[..DEGREE].iter().rev() {
            for j in 0..NODES {
                u[j] = u[j] * t[j] + c;
            }
        }
        let mut sum = 0.0;
        for j in 0..NODES {
            let z = self.width * t[j];
            sum += WEIGHT[j] / ((1.0 + z * z) * u[j].sqrt());
        }
        2.0 * self.width * half * sum
    }
}
