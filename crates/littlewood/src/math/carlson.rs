//! Carlson's symmetric elliptic integrals `R_F`, `R_C`, `R_J` for the arguments of rolling.
//!
//! Duplication theorem (B. C. Carlson, *Numerical computation of real or complex elliptic
//! integrals*, Numer. Algorithms 10, 1995; <https://dlmf.nist.gov/19.36>). Existing crates take
//! `atan` and `log` from `std` or `libm` by a feature that any other dependency can enable, which
//! changes the last bits. The tests compare with such a crate.

/// Relative truncation error of the series.
const TRUNCATION: f64 = f64::EPSILON / 8.0;

/// `R_F(x, y, z)` for non-negative arguments of which at most one is zero (DLMF 19.16.1); relative
/// error a few ulp.
///
/// Infinite when two arguments vanish.
pub(crate) fn rf(x: f64, y: f64, z: f64) -> f64 {
    if x + y == 0.0 || y + z == 0.0 || x + z == 0.0 {
        return f64::INFINITY;
    }
    let (mut x, mut y, mut z) = (x, y, z);
    loop {
        let mean = (x + y + z) / 3.0;
        let (ex, ey) = (1.0 - x / mean, 1.0 - y / mean);
        let ez = -(ex + ey);
        let spread = ex.abs().max(ey.abs()).max(ez.abs());
        // The first omitted term is of order spread^8 / 50. NaN ends the loop, too.
        let s4 = spread * spread * spread * spread;
        if s4 * s4 < 50.0 * TRUNCATION || s4.is_nan() {
            let e2 = ex * ey - ez * ez;
            let e3 = ex * ey * ez;
            let series = 1.0
                + e2 * (-1.0 / 10.0 + e2 * (1.0 / 24.0 - e2 * 5.0 / 208.0) - e3 * 3.0 / 44.0)
                + e3 * (1.0 / 14.0 + e3 * 3.0 / 104.0 + e2 * e2 / 16.0);
            return series / mean.sqrt();
        }
        let (rx, ry, rz) = (x.sqrt(), y.sqrt(), z.sqrt());
        let lambda = rx * (ry + rz) + ry * rz;
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
        z = 0.25 * (z + lambda);
    }
}

/// `R_C(1, y)` for y > 0 (DLMF 19.6.15), the elementary function in the sum for `R_J`, from y and
/// e = y − 1: next to y = 0 and y = 1 one of them has lost digits.
fn rc_one(y: f64, e: f64) -> f64 {
    if e.abs() < 0.02 {
        // Alternating series 1 − e/3 + e²/5 − …; 0.02^10 / 21 is below half an ulp.
        let mut sum = 0.0;
        for k in (0..10_u32).rev() {
            sum = 1.0 / f64::from(2 * k + 1) - e * sum;
        }
        sum
    } else if e > 0.0 {
        let root = e.sqrt();
        libm::atan(root) / root
    } else if e > -0.5 {
        let root = (-e).sqrt();
        libm::atanh(root) / root
    } else {
        let root = (1.0 - y).sqrt();
        libm::log((1.0 + root) / y.sqrt()) / root
    }
}

/// `R_J(x, y, z, p)` for non-negative x, y, z, at most one of them zero, and p > 0 (DLMF 19.16.2).
///
/// Infinite when two of x, y, z vanish.
pub(crate) fn rj(x: f64, y: f64, z: f64, p: f64) -> f64 {
    if x + y == 0.0 || y + z == 0.0 || x + z == 0.0 {
        return f64::INFINITY;
    }
    let (mut x, mut y, mut z, mut p) = (x, y, z, p);
    let mut delta = (p - x) * (p - y) * (p - z);
    let mut factor = 1.0;
    let mut elementary = 0.0;
    loop {
        let mean = (x + y + z + 2.0 * p) / 5.0;
        let (ex, ey, ez) = (1.0 - x / mean, 1.0 - y / mean, 1.0 - z / mean);
        let ep = -(ex + ey + ez) / 2.0;
        let spread = ex.abs().max(ey.abs()).max(ez.abs()).max(ep.abs());
        let s4 = spread * spread * spread * spread;
        if s4 * s4 < 5.0 * TRUNCATION || s4.is_nan() {
            let xyz = ex * ey * ez;
            let p2 = ep * ep;
            let e2 = ex * ey + ex * ez + ey * ez - 3.0 * p2;
            let e3 = xyz + 2.0 * ep * (e2 + 2.0 * p2);
            let e4 = (2.0 * xyz + ep * (e2 + 3.0 * p2)) * ep;
            let e5 = xyz * p2;
            let series = 1.0 - 3.0 * e2 / 14.0 + e3 / 6.0 + 9.0 * e2 * e2 / 88.0
                - 3.0 * e4 / 22.0
                - 9.0 * e2 * e3 / 52.0
                + 3.0 * e5 / 26.0
                - e2 * e2 * e2 / 16.0
                + 3.0 * e3 * e3 / 40.0
                + 3.0 * e2 * e4 / 20.0
                + 45.0 * e2 * e2 * e3 / 272.0
                - 9.0 * (e3 * e4 + e2 * e5) / 68.0;
            return factor * series / (mean * mean.sqrt()) + 6.0 * elementary;
        }
        let (rx, ry, rz, rp) = (x.sqrt(), y.sqrt(), z.sqrt(), p.sqrt());
        let lambda = rx * (ry + rz) + ry * rz;
        let d = (rp + rx) * (rp + ry) * (rp + rz);
        // d² + delta = 2 √p (p + λ) d, a sum of positive terms.
        elementary += factor / d * rc_one(2.0 * rp * (p + lambda) / d, delta / (d * d));
        factor *= 0.25;
        delta /= 64.0;
        x = 0.25 * (x + lambda);
        y = 0.25 * (y + lambda);
        z = 0.25 * (z + lambda);
        p = 0.25 * (p + lambda);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn relative(a: f64, b: f64) -> f64 {
        ((a - b) / b).abs()
    }

    #[test]
    fn agree_with_the_worked_values_of_carlson() {
        // Carlson 1995, section 3.
        assert!(relative(rf(1.0, 2.0, 0.0), 1.311_028_777_146_059_9) < 4e-16);
        assert!(relative(rf(2.0, 3.0, 4.0), 0.584_082_841_677_151_7) < 4e-16);
        assert!(relative(rj(0.0, 1.0, 2.0, 3.0), 0.776_886_237_785_823_3) < 4e-16);
        assert!(relative(rj(2.0, 3.0, 4.0, 5.0), 0.142_975_796_671_567_53) < 6e-16);
    }

    #[test]
    fn agree_with_arb_where_arguments_differ_by_many_decades() {
        let arguments = [
            (1e-32, 2e-32, 2e9, 2.458_767_048_734_987e-3),
            (1e-20, 1e-10, 1e4, 0.366_174_681_378_435_8),
            (0.0, 1e-12, 1e12, 4.352_597_321_557_266e-5),
            (1e-3, 1.0, 1e15, 9.196_029_009_514_572e-8),
        ];
        for (x, y, z, exact) in arguments {
            assert!(relative(rj(x, y, z, 1.0), exact) < 1e-15, "{x} {y} {z}");
        }
    }

    proptest! {
        #[test]
        fn agree_with_an_independent_crate(
            x in 0.0..1.0_f64, y in 1e-12..1.0_f64, stretch in 0.0..12.0_f64,
        ) {
            // The arguments of the rolling time: x, y ≤ 1 ≤ z and p = 1.
            let z = 1.0 + libm::exp(2.0 * stretch) * 1e-4;
            let ours = (rf(x, y, z), rj(x, y, z, 1.0));
            let theirs = (ellip::elliprf(x, y, z).unwrap(), ellip::elliprj(x, y, z, 1.0).unwrap());
            prop_assert!(relative(ours.0, theirs.0) < 2e-15);
            prop_assert!(relative(ours.1, theirs.1) < 1e-14, "{ours:?} {theirs:?}");
        }
    }
}
