//! Gauss–Legendre quadrature on [−1, 1], with four, eight, twelve and sixteen nodes in increasing order,
//! of the longest rule the positive ones.

pub(super) const SHORT_NODES: usize = 4;

#[rustfmt::skip]
pub(super) const SHORT_NODE: [f64; SHORT_NODES] = [
    -0.861_136_311_594_052_6, -0.339_981_043_584_856_26, 0.339_981_043_584_856_26, 0.861_136_311_594_052_6,
];

#[rustfmt::skip]
pub(super) const SHORT_WEIGHT: [f64; SHORT_NODES] = [
    0.347_854_845_137_453_85, 0.652_145_154_862_546_2, 0.652_145_154_862_546_2, 0.347_854_845_137_453_85,
];

pub(super) const NODES: usize = 8;

#[rustfmt::skip]
pub(super) const NODE: [f64; NODES] = [
    -0.960_289_856_497_536_2, -0.796_666_477_413_626_7, -0.525_532_409_916_329, -0.183_434_642_495_649_8,
    0.183_434_642_495_649_8, 0.525_532_409_916_329, 0.796_666_477_413_626_7, 0.960_289_856_497_536_2,
];

#[rustfmt::skip]
pub(super) const WEIGHT: [f64; NODES] = [
    0.101_228_536_290_376_26, 0.222_381_034_453_374_48, 0.313_706_645_877_887_3, 0.362_683_783_378_362,
    0.362_683_783_378_362, 0.313_706_645_877_887_3, 0.222_381_034_453_374_48, 0.101_228_536_290_376_26,
];

pub(super) const MIDDLE_NODES: usize = 12;

#[rustfmt::skip]
pub(super) const MIDDLE_NODE: [f64; MIDDLE_NODES] = [
    -0.981_560_634_246_719_2, -0.904_117_256_370_474_9, -0.769_902_674_194_304_7, -0.587_317_954_286_617_5,
    -0.367_831_498_998_180_2, -0.125_233_408_511_468_9, 0.125_233_408_511_468_9, 0.367_831_498_998_180_2,
    0.587_317_954_286_617_5, 0.769_902_674_194_304_7, 0.904_117_256_370_474_9, 0.981_560_634_246_719_2,
];

#[rustfmt::skip]
pub(super) const MIDDLE_WEIGHT: [f64; MIDDLE_NODES] = [
    0.047_175_336_386_511_83, 0.106_939_325_995_318_43, 0.160_078_328_543_346_22, 0.203_167_426_723_065_92,
    0.233_492_536_538_354_8, 0.249_147_045_813_402_77, 0.249_147_045_813_402_77, 0.233_492_536_538_354_8,
    0.203_167_426_723_065_92, 0.160_078_328_543_346_22, 0.106_939_325_995_318_43, 0.047_175_336_386_511_83,
];

pub(super) const PAIRS: usize = 8;

#[rustfmt::skip]
pub(super) const LONG_NODE: [f64; PAIRS] = [
    0.095_012_509_837_637_44, 0.281_603_550_779_258_9, 0.458_016_777_657_227_4, 0.617_876_244_402_643_7,
    0.755_404_408_355_003, 0.865_631_202_387_831_7, 0.944_575_023_073_232_6, 0.989_400_934_991_649_9,
];

#[rustfmt::skip]
pub(super) const LONG_WEIGHT: [f64; PAIRS] = [
    0.189_450_610_455_068_5, 0.182_603_415_044_923_6, 0.169_156_519_395_002_54, 0.149_595_988_816_576_73,
    0.124_628_971_255_533_87, 0.095_158_511_682_492_78, 0.062_253_523_938_647_894, 0.027_152_459_411_754_095,
];

#[cfg(test)]
mod tests {
    use super::*;

    fn is_exact_below(end: i32, rule: impl Fn(&dyn Fn(f64) -> f64) -> f64) {
        for degree in 0..end {
            let sum = rule(&|x| (0..degree).fold(1.0, |product, _| product * x));
            let exact = if degree % 2 == 0 {
                2.0 / f64::from(degree + 1)
            } else {
                0.0
            };
            assert!((sum - exact).abs() < 4e-16, "degree {degree}: {sum}");
        }
    }

    #[test]
    fn polynomials_are_integrated_exactly() {
        is_exact_below(8, |f| {
            SHORT_NODE
                .iter()
                .zip(SHORT_WEIGHT)
                .map(|(x, w)| w * f(*x))
                .sum()
        });
        is_exact_below(16, |f| {
            NODE.iter().zip(WEIGHT).map(|(x, w)| w * f(*x)).sum()
        });
        is_exact_below(24, |f| {
            MIDDLE_NODE
                .iter()
                .zip(MIDDLE_WEIGHT)
                .map(|(x, w)| w * f(*x))
                .sum()
        });
        is_exact_below(32, |f| {
            LONG_NODE
                .iter()
                .zip(LONG_WEIGHT)
                .map(|(x, w)| w * (f(*x) + f(-x)))
                .sum()
        });
    }
}
