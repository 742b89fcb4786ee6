//! Gauss–Legendre quadrature on [−1, 1], with eight nodes and with sixteen.

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

/// Number of pairs of nodes of the longer rule.
pub(super) const PAIRS: usize = 8;

/// Positive nodes of the longer rule.
#[rustfmt::skip]
pub(super) const LONG_NODE: [f64; PAIRS] = [
    0.095_012_509_837_637_44, 0.281_603_550_779_258_9, 0.458_016_777_657_227_4, 0.617_876_244_402_643_7,
    0.755_404_408_355_003, 0.865_631_202_387_831_7, 0.944_575_023_073_232_6, 0.989_400_934_991_649_9,
];

/// Their weights.
#[rustfmt::skip]
pub(super) const LONG_WEIGHT: [f64; PAIRS] = [
    0.189_450_610_455_068_5, 0.182_603_415_044_923_6, 0.169_156_519_395_002_54, 0.149_595_988_816_576_73,
    0.124_628_971_255_533_87, 0.095_158_511_682_492_78, 0.062_253_523_938_647_894, 0.027_152_459_411_754_095,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_are_integrated_exactly() {
        for degree in 0..16 {
            let power = |x: f64| (0..degree).fold(1.0, |product, _| product * x);
            let sum: f64 = NODE.iter().zip(WEIGHT).map(|(x, w)| w * power(*x)).sum();
            let exact = if degree % 2 == 0 { 2.0 / f64::from(degree + 1) } else { 0.0 };
            assert!((sum - exact).abs() < 4e-16, "degree {degree}: {sum}");
        }
        for degree in 0..32 {
            let power = |x: f64| (0..degree).fold(1.0, |product, _| product * x);
            let sum: f64 = LONG_NODE.iter().zip(LONG_WEIGHT).map(|(x, w)| w * (power(*x) + power(-*x))).sum();
            let exact = if degree % 2 == 0 { 2.0 / f64::from(degree + 1) } else { 0.0 };
            assert!((sum - exact).abs() < 4e-16, "degree {degree}: {sum}");
        }
    }
}
