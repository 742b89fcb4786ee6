//! Polynomials of even degree.

/// The value at a point, even and odd powers apart: two short chains instead of a long one. The number N of coefficients is odd.
#[inline]
pub(super) fn value<const N: usize>(coefficients: &[f64; N], at: f64) -> f64 {
    const { assert!(N % 2 == 1) };
    let square = at * at;
    let (mut even, mut odd) = (coefficients[N - 1], 0.0);
    let mut k = N - 1;
    while k > 0 {
        odd = odd * square + coefficients[k - 1];
        even = even * square + coefficients[k - 2];
        k -= 2;
    }
    even + at * odd
}
