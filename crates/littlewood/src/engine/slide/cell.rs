//! A cell of angles, with the slides through it as polynomials.

use crate::math::trig::{sincos, sincos_small};
use crate::mechanics::equations::SlidingLaw;
use crate::model::hoop::Heavy;

use super::super::polynomial::value;
use super::super::quadrature::{MIDDLE_NODE, MIDDLE_NODES, MIDDLE_WEIGHT, NODE, NODES, WEIGHT};

/// Degree of the polynomials of a cell.
pub(super) const DEGREE: usize = 18;

/// A series has converged when its last coefficients are below this part of the largest.
const CONVERGED: f64 = 1e-17;

/// Coefficients of the powers of z, the lowest first.
pub(super) type Polynomial = [f64; DEGREE + 1];

/// What belongs to the body at the end of a cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) p: f64,
    pub(super) h: f64,
    pub(super) cos: f64,
    /// 1 + h cos ϑ + μk h sin ϑ.
    pub(super) lever: f64,
    /// η″ = α + β u.
    pub(super) alpha: f64,
    pub(super) beta: f64,
}

/// A cell, z ∈ [−1, 1] from its left end to its right.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    pub(super) left: f64,
    pub(super) centre: f64,
    pub(super) half: f64,
    /// sin ϑ and cos ϑ at the centre.
    pub(super) direction: (f64, f64),
    pub(super) p: Polynomial,
    pub(super) h: Polynomial,
    pub(super) p_nodes: [f64; NODES],
    pub(super) h_nodes: [f64; NODES],
    /// At the nodes of the middle rule.
    p_middle: [f64; MIDDLE_NODES],
    h_middle: [f64; MIDDLE_NODES],
    /// At z = −1 and z = 1.
    pub(super) edges: [Edge; 2],
    /// Whether it is left out: P ≤ 0, or so close to a zero of P that its series do not converge. Nothing else holds of it then.
    pub(super) is_gap: bool,
}

impl Edge {
    fn new(law: &SlidingLaw, theta: f64, p: f64, h: f64) -> Self {
        let (sin, cos) = sincos(theta);
        let (alpha, beta) = law.slip_acceleration(sin, cos);
        Self { p, h, cos, lever: law.lever(sin, cos), alpha, beta }
    }
}

impl Cell {
    /// The cell about `left..right`, if its series converge.
    pub(super) fn new(law: &SlidingLaw, left: f64, right: f64) -> Option<Self> {
        let Heavy { mass, h, inertia, .. } = law.body;
        let (centre, half) = (0.5 * (left + right), 0.5 * (right - left));
        let mut sin = [0.0; DEGREE + 1];
        let mut cos = [0.0; DEGREE + 1];
        (sin[0], cos[0]) = libm::sincos(centre);
        for k in 1..=DEGREE {
            let factor = half / k as f64;
            sin[k] = factor * cos[k - 1];
            cos[k] = -factor * sin[k - 1];
        }
        let q: Polynomial = core::array::from_fn(|k| law.q(if k == 0 { 1.0 } else { 0.0 }, sin[k], cos[k]));
        let mut solvability = product(&sin, &q).map(|c| mass * h * c);
        solvability[0] += inertia;
        let drive = quotient(&q.map(|c| 2.0 * mass * c), &solvability);
        let weight = product(&cos, &drive).map(|c| -h * c);
        let (mut u_p, mut u_h) = ([0.0; DEGREE + 1], [0.0; DEGREE + 1]);
        u_h[0] = 1.0;
        for k in 0..DEGREE {
            let factor = half / (k + 1) as f64;
            let (mut sum_p, mut sum_h) = (drive[k], 0.0);
            for j in 0..=k {
                sum_p += weight[j] * u_p[k - j];
                sum_h += weight[j] * u_h[k - j];
            }
            u_p[k + 1] = factor * sum_p;
            u_h[k + 1] = factor * sum_h;
        }
        let converged = |series: &Polynomial| {
            let largest = series.iter().fold(0.0_f64, |max, c| max.max(c.abs()));
            series[DEGREE - 2..].iter().all(|c| c.abs() <= CONVERGED * largest.max(1e-3))
        };
        if !(converged(&u_p) && converged(&u_h)) {
            return None;
        }
        let edge = |theta, z| Edge::new(law, theta, value(&u_p, z), value(&u_h, z));
        Some(Self {
            left,
            centre,
            half,
            direction: (sin[0], cos[0]),
            p_nodes: NODE.map(|z| value(&u_p, z)),
            h_nodes: NODE.map(|z| value(&u_h, z)),
            p_middle: MIDDLE_NODE.map(|z| value(&u_p, z)),
            h_middle: MIDDLE_NODE.map(|z| value(&u_h, z)),
            edges: [edge(left, -1.0), edge(right, 1.0)],
            p: u_p,
            h: u_h,
            is_gap: false,
        })
    }

    /// The cell about `left..right`, left out.
    pub(super) fn gap(law: &SlidingLaw, left: f64, right: f64) -> Self {
        let (centre, half) = (0.5 * (left + right), 0.5 * (right - left));
        Self {
            left,
            centre,
            half,
            direction: sincos(centre),
            p: [0.0; DEGREE + 1],
            h: [0.0; DEGREE + 1],
            p_nodes: [0.0; NODES],
            h_nodes: [0.0; NODES],
            p_middle: [0.0; MIDDLE_NODES],
            h_middle: [0.0; MIDDLE_NODES],
            edges: [left, right].map(|theta| Edge::new(law, theta, 0.0, 0.0)),
            is_gap: true,
        }
    }
}

fn product(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let mut result = [0.0; DEGREE + 1];
    for k in 0..=DEGREE {
        for j in 0..=k {
            result[k] += a[j] * b[k - j];
        }
    }
    result
}

fn quotient(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let mut result = [0.0; DEGREE + 1];
    for k in 0..=DEGREE {
        let mut rest = a[k];
        for j in 1..=k {
            rest -= b[j] * result[k - j];
        }
        result[k] = rest / b[0];
    }
    result
}

impl Cell {
    /// sin ϑ and cos ϑ at z, by the addition theorems.
    pub(super) fn direction(&self, z: f64) -> (f64, f64) {
        let ((sin, cos), (turn_sin, turn_cos)) = (self.direction, sincos_small(self.half * z));
        (sin * turn_cos + cos * turn_sin, cos * turn_cos - sin * turn_sin)
    }

    /// u_c of the motion that has u at z.
    pub(super) fn level(&self, u: f64, z: f64) -> f64 {
        (u - value(&self.p, z)) / value(&self.h, z)
    }

    /// u of one motion as a polynomial in z.
    pub(super) fn motion(&self, level: f64) -> Polynomial {
        core::array::from_fn(|k| self.p[k] + level * self.h[k])
    }

    /// ∫ dϑ/√u over the whole cell, with the shorter rule if u changes very little (`is_even`).
    pub(super) fn whole_time(&self, level: f64, is_even: bool) -> f64 {
        let mut sum = 0.0;
        if is_even {
            for ((weight, p), h) in WEIGHT.iter().zip(&self.p_nodes).zip(&self.h_nodes) {
                sum += weight / (p + level * h).sqrt();
            }
        } else {
            for ((weight, p), h) in MIDDLE_WEIGHT.iter().zip(&self.p_middle).zip(&self.h_middle) {
                sum += weight / (p + level * h).sqrt();
            }
        }
        self.half * sum
    }

    /// ∫ dϑ/√u from z = from to z = to, not smaller, with the shorter rule if u changes very little.
    pub(super) fn time(&self, motion: &Polynomial, from: f64, to: f64, is_even: bool) -> f64 {
        if is_even {
            self.sum(motion, (from, to), (&NODE, &WEIGHT))
        } else {
            self.sum(motion, (from, to), (&MIDDLE_NODE, &MIDDLE_WEIGHT))
        }
    }

    /// The same by a rule.
    #[inline]
    fn sum<const N: usize>(
        &self,
        motion: &Polynomial,
        (from, to): (f64, f64),
        (nodes, weights): (&[f64; N], &[f64; N]),
    ) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let z = nodes.map(|node| middle + half * node);
        let mut u = [motion[DEGREE]; N];
        for c in motion[..DEGREE].iter().rev() {
            for j in 0..N {
                u[j] = u[j] * z[j] + c;
            }
        }
        let mut sum = 0.0;
        for (weight, u) in weights.iter().zip(u) {
            sum += weight / u.sqrt();
        }
        self.half * half * sum
    }
}
