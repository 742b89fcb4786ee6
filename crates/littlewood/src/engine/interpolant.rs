//! Polynomials through values at Chebyshev nodes, several functions at once.

use core::f64::consts::PI;

/// Number of nodes and of coefficients.
pub(super) const NODES: usize = 14;

/// How small the last coefficients of a polynomial that has converged are.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tolerance {
    /// Part of the largest value.
    pub(super) relative: f64,
    /// The least bound, however small the values are.
    pub(super) least: f64,
}

impl Tolerance {
    pub(super) const ROUNDING: Self = Self {
        relative: 2e-15,
        least: 0.0,
    };

    pub(super) fn of(&self, size: f64) -> f64 {
        (self.relative * size.abs()).max(self.least)
    }
}

/// `LANES` polynomials on one interval.
#[derive(Clone, Debug)]
pub(super) struct Interpolant<const LANES: usize> {
    pub(super) right: f64,
    centre: f64,
    /// 1 over half the width.
    scale: f64,
    /// Coefficients of the powers of z ∈ [−1, 1], the highest first.
    series: [[f64; LANES]; NODES],
}

/// From values at the Chebyshev nodes to powers.
#[derive(Clone, Debug)]
pub(super) struct Basis {
    /// The nodes of [−1, 1], in increasing order.
    nodes: [f64; NODES],
    /// Coefficient of T_j from the value at node k.
    chebyshev: [[f64; NODES]; NODES],
    /// T_j in powers of z, the lowest first.
    powers: [[f64; NODES]; NODES],
}

impl Basis {
    pub(super) fn new() -> Self {
        let count = NODES as f64;
        let cos = |j: usize, k: usize| libm::cos(PI * (j * (2 * k + 1)) as f64 / (2.0 * count));
        let chebyshev = core::array::from_fn(|j| {
            let weight = if j == 0 { 1.0 } else { 2.0 } / count;
            // T_j(z_k) = cos(j (π − t_k)).
            let sign = if j % 2 == 0 { weight } else { -weight };
            core::array::from_fn(|k| sign * cos(j, k))
        });
        let mut powers = [[0.0; NODES]; NODES];
        powers[0][0] = 1.0;
        powers[1][1] = 1.0;
        for j in 2..NODES {
            for k in 0..NODES {
                let raised = if k == 0 {
                    0.0
                } else {
                    2.0 * powers[j - 1][k - 1]
                };
                powers[j][k] = raised - powers[j - 2][k];
            }
        }
        Self {
            nodes: core::array::from_fn(|k| -cos(1, k)),
            chebyshev,
            powers,
        }
    }

    pub(super) fn nodes(&self, left: f64, right: f64) -> [f64; NODES] {
        let (centre, half) = (0.5 * (left + right), 0.5 * (right - left));
        self.nodes.map(|node| centre + half * node)
    }

    /// Polynomials through the values at the nodes, if they have converged.
    pub(super) fn through<const LANES: usize>(
        &self,
        left: f64,
        right: f64,
        values: &[[f64; LANES]; NODES],
        tolerances: &[Tolerance; LANES],
    ) -> Option<Interpolant<LANES>> {
        // Of the differences from one of them, whose sums round less.
        let level = values[NODES / 2];
        let mut chebyshev = [[0.0; LANES]; NODES];
        for (coefficient, factors) in chebyshev.iter_mut().zip(&self.chebyshev) {
            for (value, factor) in values.iter().zip(factors) {
                for lane in 0..LANES {
                    coefficient[lane] += factor * (value[lane] - level[lane]);
                }
            }
        }
        for lane in 0..LANES {
            let largest = values
                .iter()
                .fold(0.0_f64, |largest, value| largest.max(value[lane].abs()));
            if !chebyshev[NODES - 2..]
                .iter()
                .all(|c| c[lane].abs() <= tolerances[lane].of(largest))
            {
                return None;
            }
        }
        // To powers of z: the coefficients fall faster than those of T_j grow.
        let mut series = [[0.0; LANES]; NODES];
        for (coefficient, powers) in chebyshev.iter().zip(&self.powers) {
            for (sum, power) in series.iter_mut().rev().zip(powers) {
                for lane in 0..LANES {
                    sum[lane] += coefficient[lane] * power;
                }
            }
        }
        for lane in 0..LANES {
            series[NODES - 1][lane] += level[lane];
        }
        let (centre, scale) = (0.5 * (left + right), 2.0 / (right - left));
        Some(Interpolant {
            right,
            centre,
            scale,
            series,
        })
    }
}

impl<const LANES: usize> Interpolant<LANES> {
    #[inline]
    pub(super) fn at(&self, x: f64) -> [f64; LANES] {
        let z = (x - self.centre) * self.scale;
        // Even and odd powers apart: two short chains instead of a long one.
        let square = z * z;
        let (mut odd, mut even) = (self.series[0], self.series[1]);
        for pair in self.series[2..].chunks_exact(2) {
            for lane in 0..LANES {
                odd[lane] = odd[lane] * square + pair[0][lane];
                even[lane] = even[lane] * square + pair[1][lane];
            }
        }
        core::array::from_fn(|lane| odd[lane] * z + even[lane])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_kink_does_not_converge() {
        let basis = Basis::new();
        let values = basis.nodes(-1.0, 1.0).map(|x| [(x - 0.1).abs()]);
        assert!(
            basis
                .through(-1.0, 1.0, &values, &[Tolerance::ROUNDING])
                .is_none()
        );
    }
}
