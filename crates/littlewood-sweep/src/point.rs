//! A point of a sweep: a hoop and a start.

use littlewood::{HoopParameters, Start};

/// One motion that a sweep computes. The values are checked when it is computed, not before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// The hoop, in the dimensionless parameters of (2.9).
    pub hoop: HoopParameters,
    /// The start, dimensionless.
    pub start: Start,
}

impl Point {
    /// The bits of the five parameters of the hoop: points that agree in them share one engine.
    pub(crate) const fn hoop_bits(&self) -> [u64; 5] {
        let HoopParameters { mass_ratio, offset, inertia, mu_s, mu_k } = self.hoop;
        [mass_ratio.to_bits(), offset.to_bits(), inertia.to_bits(), mu_s.to_bits(), mu_k.to_bits()]
    }
}
