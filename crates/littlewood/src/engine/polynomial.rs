//! Polynomials of even degree.

/// The value at a point, even and odd powers apart: two short chains instead of a long one. The number of coefficients is odd.
#[inline(always)]
pub(super) fn value(coefficients: &[f64], at: f64) -> f64 {
    let Some((last, others)) = coefficients.split_last() else { return 0.0 };
    let (pairs, rest) = others.as_chunks();
    debug_assert!(rest.is_empty(), "an even degree");
    let square = at * at;
    let (mut even, mut odd) = (*last, 0.0);
    for [lower, upper] in pairs.iter().rev() {
        odd = odd * square + upper;
        even = even * square + lower;
    }
    even + at * odd
}
