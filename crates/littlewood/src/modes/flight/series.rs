//! Sine and cosine without the first terms of their series.

use crate::math::trig::sincos;

/// 1/(k(k + 1)) and 1/((k + 1)(k + 2)) for k = 20, 18, …, 4: the ratios of terms of the series of `TruncatedSeries`.
const RECIPROCALS: [(f64, f64); 9] = {
    let mut table = [(0.0, 0.0); 9];
    let mut i = 0;
    while i < 9 {
        let k = (20 - 2 * i) as f64;
        table[i] = (1.0 / (k * (k + 1.0)), 1.0 / ((k + 1.0) * (k + 2.0)));
        i += 1;
    }
    table
};

/// sin φ, 1 − cos φ, φ − sin φ and cos φ − 1 + φ²/2, the latter without cancellation.
#[derive(Clone, Copy, Debug)]
pub(super) struct TruncatedSeries {
    pub(super) sine: f64,
    pub(super) versine: f64,
    pub(super) odd: f64,
    pub(super) even: f64,
}

impl TruncatedSeries {
    // Within its callers the sums are not computed side by side.
    #[inline(never)]
    pub(super) fn new(phi: f64) -> Self {
        let square = phi * phi;
        if phi.abs() > 1.0 {
            let (sine, cosine) = sincos(phi);
            let versine = 1.0 - cosine;
            return Self { sine, versine, odd: phi - sine, even: 0.5 * square - versine };
        }
        // φ³/3! − φ⁵/5! + … and φ⁴/4! − φ⁶/6! + …; the terms left out are below 1/23!.
        let (mut odd, mut even) = (1.0, 1.0);
        for (a, b) in RECIPROCALS {
            odd = 1.0 - odd * (square * a);
            even = 1.0 - even * (square * b);
        }
        let (odd, even) = (phi * square / 6.0 * odd, square * square / 24.0 * even);
        Self { sine: phi - odd, versine: 0.5 * square - even, odd, even }
    }
}
