//! Gauss–Legendre quadrature on panels, with the integrals up to each node.

use std::sync::OnceLock;

use core::ops::Range;

use crate::math::number::Number;

pub(crate) const NODES: usize = 16;

/// Largest relative tail of an integrand on a panel: the rule is exact to twice the degree.
pub(crate) const TAIL_TOLERANCE: f64 = 1e-8;

/// What rounding of an integrand leaves in the tail, at most, as a multiple of its terms: a few
/// units in the last place, ten times in the sums over the nodes.
pub(crate) const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// Largest number of halvings of a panel: its width is then one unit in the last place.
const MAX_HALVINGS: u32 = 52;

/// Nodes on [−1, 1] with their weights.
#[derive(Clone, Debug)]
pub(crate) struct Rule {
    pub(crate) nodes: [f64; NODES],
    pub(crate) weights: [f64; NODES],
    /// Row i gives the integral from −1 to node i.
    integrals: [[f64; NODES]; NODES],
    /// The last two coefficients of the expansion in Legendre polynomials.
    tails: [[f64; NODES]; 2],
}

/// P_0 … P_n and P_n′ at x, for n = `NODES`.
fn legendre(x: f64) -> ([f64; NODES + 1], f64) {
    let mut p = [1.0; NODES + 1];
    p[1] = x;
    let mut k = 1.0;
    for i in 2..=NODES {
        k += 1.0;
        p[i] = ((2.0 * k - 1.0) * x * p[i - 1] - (k - 1.0) * p[i - 2]) / k;
    }
    let slope = k * (x * p[NODES] - p[NODES - 1]) / (x * x - 1.0);
    (p, slope)
}

impl Rule {
    pub(crate) fn get() -> &'static Self {
        static RULE: OnceLock<Rule> = OnceLock::new();
        RULE.get_or_init(Self::new)
    }

    fn new() -> Self {
        let count = NODES as f64;
        let mut nodes = [0.0; NODES];
        for i in 0..NODES / 2 {
            // Newton's method from an estimate with an error below 1e-3.
            let mut x = libm::cos(core::f64::consts::PI * (i as f64 + 0.75) / (count + 0.5));
            for _ in 0..6 {
                let (p, slope) = legendre(x);
                x -= p[NODES] / slope;
            }
            (nodes[i], nodes[NODES - 1 - i]) = (-x, x);
        }
        let values = nodes.map(|x| legendre(x).0);
        let weights = nodes.map(|x| {
            let (_, slope) = legendre(x);
            2.0 / ((1.0 - x * x) * slope * slope)
        });
        let mut integrals = [[0.0; NODES]; NODES];
        for (i, row) in integrals.iter_mut().enumerate() {
            for (j, entry) in row.iter_mut().enumerate() {
                // ∫ P_k = (P_{k+1} − P_{k−1})/(2k + 1), of the polynomial that is 1 at node j and 0
                // at the others.
                let mut sum = nodes[i] + 1.0;
                for k in 1..NODES {
                    sum += values[j][k] * (values[i][k + 1] - values[i][k - 1]);
                }
                *entry = 0.5 * weights[j] * sum;
            }
        }
        let tails = [NODES - 2, NODES - 1].map(|k| {
            let scale = k as f64 + 0.5;
            core::array::from_fn(|j| scale * weights[j] * values[j][k])
        });
        Self {
            nodes,
            weights,
            integrals,
            tails,
        }
    }

    pub(crate) fn integral(&self, values: &[f64; NODES]) -> f64 {
        dot(&self.weights, values)
    }

    /// Integrals from −1 to the nodes.
    pub(crate) fn up_to(&self, values: &[f64; NODES]) -> [f64; NODES] {
        core::array::from_fn(|i| dot(&self.integrals[i], values))
    }

    /// Magnitude of the last two coefficients, an estimate of the interpolation error.
    pub(crate) fn tail(&self, values: &[f64; NODES]) -> f64 {
        dot(&self.tails[0], values).abs() + dot(&self.tails[1], values).abs()
    }
}

pub(crate) fn largest(values: &[f64; NODES]) -> f64 {
    values
        .iter()
        .fold(0.0, |largest, value| largest.max(value.abs()))
}

/// The integral of a function over an interval, on panels that are halved until the rule resolves
/// it, or its rounding, which the function gives as a part of its value.
pub(crate) fn integral<T: Number>(
    tolerance: f64,
    Range {
        start: from,
        end: to,
    }: Range<f64>,
    f: impl Fn(f64) -> (T, f64),
) -> T {
    let rule = Rule::get();
    let pieces = (to - from).ceil().max(1.0);
    let width = (to - from) / pieces;
    if width.is_nan() || width <= 0.0 {
        return T::constant(0.0);
    }
    let mut sum = T::constant(0.0);
    let mut pending: Vec<(f64, f64, u32)> = (0..pieces as u32)
        .rev()
        .map(|k| {
            (
                from + width * f64::from(k),
                from + width * f64::from(k + 1),
                0,
            )
        })
        .collect();
    while let Some((low, high, halvings)) = pending.pop() {
        let (centre, half) = (0.5 * (low + high), 0.5 * (high - low));
        let nodes = rule.nodes.map(|x| f(centre + half * x));
        let values: [f64; NODES] = nodes.map(|node| node.0.value());
        let rounding = nodes.iter().fold(0.0_f64, |most, node| most.max(node.1));
        if halvings < MAX_HALVINGS
            && rule.tail(&values) > tolerance.max(rounding) * largest(&values)
        {
            pending.extend([(centre, high, halvings + 1), (low, centre, halvings + 1)]);
        } else {
            let terms = rule.weights.iter().zip(nodes);
            sum = sum
                + terms.fold(T::constant(0.0), |sum, (weight, node)| {
                    sum + node.0 * *weight
                }) * half;
        }
    }
    sum
}

fn dot(a: &[f64; NODES], b: &[f64; NODES]) -> f64 {
    a.iter().zip(b).fold(0.0, |sum, (a, b)| sum + a * b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_integrated_exactly() {
        let rule = Rule::get();
        for degree in 0..2 * NODES {
            let power = |x: f64, n: usize| (0..n).fold(1.0, |product, _| product * x);
            let exact =
                |x: f64| (power(x, degree + 1) - power(-1.0, degree + 1)) / (degree + 1) as f64;
            let values = rule.nodes.map(|x| power(x, degree));
            assert!(
                (rule.integral(&values) - exact(1.0)).abs() < 1e-15,
                "degree {degree}"
            );
            if degree < NODES {
                for (x, integral) in rule.nodes.iter().zip(rule.up_to(&values)) {
                    assert!(
                        (integral - exact(*x)).abs() < 1e-15,
                        "degree {degree} at {x}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_tail_is_small_for_polynomials_only() {
        let rule = Rule::get();
        let noise = rule.tail(&rule.nodes.map(|x| 1.0 + x * x));
        assert!(noise < 3e-15, "{noise:e}");
        assert!(rule.tail(&rule.nodes.map(f64::abs)) > 1e-4);
    }
}
