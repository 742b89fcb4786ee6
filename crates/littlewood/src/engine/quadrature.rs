//! Gauss–Legendre quadrature on [−1, 1].

/// Number of nodes.
pub(super) const NODES: usize = 8;

/// Nodes, in increasing order.
#[rustfmt::skip]
pub(super) const NODE: [f64; NODES] = [
    -0.960_289_856_497_536_2, -0.796_666_477_413_626_7, -0.525_532_409_916_329, -0.183_434_642_495_649_8,
    0.183_434_642_495_649_8, 0.525_532_409_916_329, 0.796_666_477_413_626_7, 0.960_289_856_497_536_2,
];

/// Weights.
#[rustfmt::skip]
pub(super) const WEIGHT: [f64; NODES] = [
    0.101_228_536_290_376_26, 0.222_381_034_453_374_48, 0.313_706_645_877_887_3, 0.362_683_783_378_362,
    0.362_683_783_378_362, 0.313_706_645_877_887_3, 0.222_381_034_453_374_48, 0.101_228_536_290_376_26,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_up_to_degree_15_are_integrated_exactly() {
        for degree in 0..16 {
            let power = |x: f64| (0..degree).fold(1.0, |product, _| product * x);
            let sum: f64 = NODE.iter().zip(WEIGHT).map(|(x, w)| w * power(*x)).sum();
            let exact = if degree % 2 == 0 { 2.0 / f64::from(degree + 1) } else { 0.0 };
            assert!((sum - exact).abs() < 4e-16, "degree {degree}: {sum}");
        }
    }
}
