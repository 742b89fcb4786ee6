//! The times of many turns, summed (docs/theory/many-turns.md).
//!
//! A polynomial p(x), x = 2 k/M − 1, through the times of M turns at Chebyshev nodes has the sum
//!
//! ```text
//! Σ p = D(x) − D(−1),      D(x + 1/M) − D(x − 1/M) = p(x),      D = (M/2) Σ_j c_j M^(−2j) d^(2j−1)p/dx^(2j−1),
//! ```
//!
//! with c_j the coefficients of z/sinh z (Euler and Maclaurin).

use core::f64::consts::PI;

/// Least number of turns, or periods, of a leap; fewer are integrated step by step.
pub(super) const MIN_LEAP_TURNS: f64 = 16.0;

/// Largest number of turns, or periods, of a leap: the angle after so many has an error of 1e-6 of
/// a turn.
pub(super) const MAX_LEAP_TURNS: f64 = 1e9;

/// Largest number of turns whose times are summed one by one: half the nodes of a polynomial.
pub(super) const MAX_SINGLY_SUMMED: usize = 8;

const NODES: usize = 16;

/// Largest ratio of min u between the turns of a block. The zero of u is then five half widths
/// from the middle, and the interpolation error through 16 nodes is (5 + √24)^−16 = 9.9^−16.
pub(super) const MAX_ENERGY_RATIO: f64 = 1.5;

/// Largest |κ| times the number of turns of a block: ε_k is then nearly quadratic in k.
pub(super) const MAX_GROWTH: f64 = 0.5;

#[derive(Clone, Debug)]
pub(super) enum Times {
    /// Each takes the same time, after a time before.
    Equal { before: f64, each: f64 },
    /// Coefficients of D(x) − D(−1) in powers of x.
    Smooth([f64; NODES + 1]),
}

impl Times {
    /// Of so many turns, from the time of turn `n` of them, which need not be a whole number.
    pub(super) fn smooth(turns: f64, time: impl Fn(f64) -> f64) -> Self {
        let values = core::array::from_fn(|k| {
            let x = libm::cos(PI * (2 * k + 1) as f64 / (2 * NODES) as f64);
            time(0.5 * ((x + 1.0) * turns - 1.0))
        });
        Self::Smooth(sum_of_turns(&values, turns))
    }
}

/// Consecutive turns whose times are summed together.
#[derive(Clone, Debug)]
pub(super) struct TurnBlock {
    pub(super) first: f64,
    pub(super) turns: f64,
    pub(super) begin: f64,
    pub(super) times: Times,
}

impl TurnBlock {
    /// Time at the beginning of turn `n` of the leap, a turn of the block or the next turn.
    pub(super) fn time(&self, n: f64) -> f64 {
        let within = n - self.first;
        let passed = match &self.times {
            Times::Equal { before, each } => before + within * each,
            Times::Smooth(powers) => {
                let x = 2.0 * within / self.turns - 1.0;
                powers.iter().rev().fold(0.0, |sum, c| sum * x + c)
            }
        };
        self.begin + passed
    }
}

/// Coefficients of D(x) − D(−1) from the values of p at the Chebyshev nodes of a block of `turns`
/// turns.
fn sum_of_turns(values: &[f64; NODES], turns: f64) -> [f64; NODES + 1] {
    // Coefficients of p in powers of x, by the recurrence of the Chebyshev polynomials.
    let mut powers = [0.0; NODES];
    let (mut before, mut this) = ([0.0; NODES], [0.0; NODES]);
    this[0] = 1.0;
    for j in 0..NODES {
        let mut coefficient = 0.0;
        for (k, value) in values.iter().enumerate() {
            coefficient += value * libm::cos(PI * (j * (2 * k + 1)) as f64 / (2 * NODES) as f64);
        }
        coefficient *= if j == 0 { 1.0 } else { 2.0 } / NODES as f64;
        for (power, c) in powers.iter_mut().zip(this) {
            *power += coefficient * c;
        }
        let mut next = [0.0; NODES];
        for k in 0..NODES {
            let raised = if k == 0 { 0.0 } else { this[k - 1] };
            next[k] = if j == 0 {
                raised
            } else {
                2.0 * raised - before[k]
            };
        }
        (before, this) = (this, next);
    }
    // z/sinh z, from its product with sinh z/z = Σ z^(2i)/(2i + 1)!.
    let mut series = [0.0; NODES / 2 + 1];
    series[0] = 1.0;
    for j in 1..series.len() {
        let mut factorial = 1.0;
        for i in 1..=j {
            factorial *= (2 * i * (2 * i + 1)) as f64;
            series[j] -= series[j - i] / factorial;
        }
    }
    let mut sum = [0.0; NODES + 1];
    for (k, power) in powers.iter().enumerate() {
        // The integral of x^k, then its odd derivatives.
        let mut factor = 0.5 * turns * power / (k + 1) as f64;
        let mut degree = k + 1;
        for c in series {
            sum[degree] += c * factor;
            if degree < 2 {
                break;
            }
            factor *= (degree * (degree - 1)) as f64 / (turns * turns);
            degree -= 2;
        }
    }
    sum[0] = 0.0;
    sum[0] = -sum.iter().rev().fold(0.0, |sum, c| c - sum);
    sum
}
