//! A slide through a cell near a turning point, at which θ′ changes its sign.
//!
//! The friction does not ask for the sign of θ′, so that u is the same function of the angle before and behind the turning point z0,
//! which may lie outside the cell. With z = z0 ∓ y², y growing with time and zero at the turning point, u = y² v(z), and
//! dτ = 2 dϑ/dz dy/√v has no singularity.

use super::super::piece::Piece;
use super::super::polynomial::value;
use super::super::quadrature::{MIDDLE_NODE as NODE, MIDDLE_NODES as NODES, MIDDLE_WEIGHT as WEIGHT};
use super::cell::{Cell, DEGREE, Polynomial};
use super::crossing::{MOST_HALVINGS, in_parts};

/// A turning point farther from the centre, in half widths of the cell, is not looked for: u has not changed by a factor of two.
const FARTHEST: f64 = 4.0;

/// Newton's method ends with a step shorter than this, where the slope changes little: its error is of the second order.
const LAST_STEP: f64 = 2e-8;

/// The angle of a turning point must be known to this: rounding moves it by more where u hardly changes with the angle, as in a libration
/// of a hoop that is next to rest.
const ANGLE_ERROR: f64 = 2e-13;

/// Terms of a polynomial that tell its zero well enough to begin with.
const FIRST_TERMS: usize = 6;

/// One slide through a cell, with the coordinate y.
#[derive(Clone, Debug)]
pub(super) struct Turning<'a> {
    cell: &'a Cell,
    /// The turning point.
    z0: f64,
    /// Sign of z0 − z.
    side: f64,
    /// v in powers of z; the last coefficient is 0.
    v: Polynomial,
}

impl<'a> Turning<'a> {
    /// The way of a slide with this u through a cell, about the zero of u next to the line through two of its values, z and u. None
    /// where there is none, or another next to it.
    pub(super) fn new(
        cell: &'a Cell,
        motion: &Polynomial,
        (z, u): (f64, f64),
        (end, u_end): (f64, f64),
    ) -> Option<Self> {
        let z0 = zero(motion, z - u * (end - z) / (u_end - u))?;
        let side = if u_end < u { 1.0 } else { -1.0 } * (end - z).signum();
        let mut v = quotient(motion, z0);
        for c in &mut v {
            *c *= -side;
        }
        let turning = Self { cell, z0, side, v };
        let rounding = f64::EPSILON * (motion[0].abs() + motion[1].abs()) * cell.half;
        if turning.v(z0) * ANGLE_ERROR < rounding {
            return None;
        }
        // A slide that turns in the cell leaves it where it has entered, or would have.
        let is_good = if turning.is_inside() && u_end < u {
            [z, z0, -end].into_iter().all(|z| turning.v(z) > 0.0)
        } else {
            [z, end].into_iter().all(|z| turning.v(z) > 0.0)
        };
        is_good.then_some(turning)
    }

    /// Whether the slide turns in the cell.
    pub(super) fn is_inside(&self) -> bool {
        self.z0.abs() < 1.0
    }

    /// Sign of θ′ before the turning point.
    pub(super) const fn travel(&self) -> f64 {
        self.side
    }

    /// Where z is behind the turning point, as y.
    pub(super) fn coordinate(&self, z: f64) -> f64 {
        (self.side * (self.z0 - z)).max(0.0).sqrt()
    }

    /// The same from u there, which tells more next to the turning point.
    pub(super) fn coordinate_of(&self, z: f64, u: f64) -> f64 {
        (u / self.v(z)).sqrt()
    }

    /// z at y.
    pub(super) fn place(&self, y: f64) -> f64 {
        self.z0 - self.side * (y * y)
    }

    fn v(&self, z: f64) -> f64 {
        value(&self.v, z)
    }

    /// Time from y to y, if v changes little.
    fn gauss(&self, from: f64, to: f64) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let z = NODE.map(|node| self.place(middle + half * node));
        let mut v = [0.0; NODES];
        for c in self.v[..DEGREE].iter().rev() {
            for j in 0..NODES {
                v[j] = v[j] * z[j] + c;
            }
        }
        let mut sum = 0.0;
        for (weight, v) in WEIGHT.iter().zip(v) {
            sum += weight / v.sqrt();
        }
        2.0 * self.cell.half * half * sum
    }

    /// dτ/dy.
    fn slowness(&self, y: f64) -> f64 {
        2.0 * self.cell.half / self.v(self.place(y)).sqrt()
    }
}

/// The zero of a polynomial next to a guess.
fn zero(motion: &Polynomial, guess: f64) -> Option<f64> {
    let newton = |terms: &[f64], z: f64| {
        let (mut value, mut slope) = (0.0, 0.0);
        for c in terms.iter().rev() {
            (value, slope) = (value * z + c, slope * z + value);
        }
        (-value / slope, slope)
    };
    let mut z = guess;
    for _ in 0..2 {
        z += newton(&motion[..FIRST_TERMS], z).0;
    }
    let mut curvature = 0.0;
    for (k, c) in motion[..FIRST_TERMS].iter().enumerate().skip(2).rev() {
        curvature = curvature * z + (k * (k - 1)) as f64 * c;
    }
    for _ in 0..20 {
        if z.is_nan() || z.abs() > FARTHEST {
            return None;
        }
        let (step, slope) = newton(motion, z);
        z += step;
        // About the bottom two zeros can be close to each other: what is left is step² u″/(2 u′).
        if step * step * (curvature / slope).abs().max(1.0) <= LAST_STEP * LAST_STEP {
            return Some(z);
        }
    }
    None
}

/// A polynomial over z − z0, z0 being a zero: from the side that does not amplify rounding.
fn quotient(motion: &Polynomial, z0: f64) -> Polynomial {
    let mut result = [0.0; DEGREE + 1];
    if z0.abs() <= 1.0 {
        let mut sum = 0.0;
        for k in (0..DEGREE).rev() {
            sum = sum * z0 + motion[k + 1];
            result[k] = sum;
        }
    } else {
        let mut sum = 0.0;
        for k in 0..DEGREE {
            sum = (sum - motion[k]) / z0;
            result[k] = sum;
        }
    }
    result
}

impl Piece for Turning<'_> {
    fn u(&self, y: f64) -> f64 {
        y * y * self.v(self.place(y))
    }

    fn rate(&self, y: f64, u: f64) -> f64 {
        if y > 0.0 { -self.side * u.sqrt() } else { self.side * u.sqrt() }
    }

    fn direction(&self, y: f64) -> (f64, f64) {
        self.cell.direction(self.place(y))
    }

    fn turned(&self, _: (f64, f64), y: f64, step: f64) -> (f64, f64) {
        self.direction(y + step)
    }

    fn turning(&self, y: f64) -> f64 {
        -2.0 * self.side * self.cell.half * y
    }

    fn by_coordinate(&self, y: f64, _: f64, by_time: f64) -> f64 {
        by_time * self.slowness(y)
    }

    fn time(&self, (from, _): (f64, f64), (to, _): (f64, f64)) -> Option<f64> {
        let v = |y: f64| self.v(self.place(y));
        in_parts(&v, &|(from, _), (to, _)| self.gauss(from, to), (from, v(from)), (to, v(to)), MOST_HALVINGS)
    }
}
