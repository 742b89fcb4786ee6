//! Power series of a fixed degree about a point: products, values and sign changes.

use crate::math::bernstein::{first_crossing, value_and_slope};
use crate::math::bracket::Bracket;
use crate::math::number::Number;

/// Degree of the series. The step-size rule of Jorba and Zou gives 20 at double precision; two more
/// cost little and allow longer steps.
pub(crate) const DEGREE: usize = 22;

/// Coefficients 0 to `DEGREE` of a power series in the distance from its centre.
pub(crate) type Series<T = f64> = [T; DEGREE + 1];

/// Coefficients `n` of products of series, each summed in the order of its first factor. The
/// interleaved sums hide the latency of the additions.
#[inline(always)]
pub(crate) fn convolve<T: Number, const N: usize>(
    products: [(&Series<T>, &Series<T>); N],
    n: usize,
) -> [T; N] {
    let mut sums = [T::constant(0.0); N];
    if n > DEGREE {
        return sums;
    }
    let mut j = 0;
    while j <= n {
        for i in 0..N {
            sums[i] = sums[i] + products[i].0[j] * products[i].1[n - j];
        }
        j += 1;
    }
    sums
}

/// The last coefficients of the products of the first two of pairs of series, and of the second two,
/// summed in the order of the first factors. The second factors come in the opposite order, so that
/// both are read forwards.
#[inline(always)]
pub(crate) fn convolve_pairs<T: Number>(left: &[[T; 2]], reversed: &[[T; 2]]) -> [T; 2] {
    let mut sums = [T::constant(0.0); 2];
    for (left, right) in left.iter().zip(reversed) {
        for lane in 0..2 {
            sums[lane] = sums[lane] + left[lane] * right[lane];
        }
    }
    sums
}

/// The product of two series, to the same degree.
pub(crate) fn times(a: &Series, b: &Series) -> Series {
    core::array::from_fn(|n| convolve([(a, b)], n)[0])
}

/// A series from its value and the others as a multiple of those of another.
pub(crate) fn led(lead: f64, factor: f64, series: &Series) -> Series {
    core::array::from_fn(|n| if n == 0 { lead } else { factor * series[n] })
}

/// Value of a series, by Horner's scheme.
#[inline]
pub(crate) fn value<T: Number>(series: &Series<T>, at: f64) -> T {
    series
        .iter()
        .rev()
        .fold(T::constant(0.0), |sum, c| sum * at + *c)
}

/// A series, or a polynomial, about a point at a distance.
pub(crate) fn shifted<const N: usize>(mut series: [f64; N], by: f64) -> [f64; N] {
    if by != 0.0 {
        for first in 0..N - 1 {
            for k in (first..N - 1).rev() {
                series[k] += by * series[k + 1];
            }
        }
    }
    series
}

#[inline(always)]
pub(crate) fn product<const A: usize, const B: usize, const C: usize>(
    a: &[f64; A],
    b: &[f64; B],
) -> [f64; C] {
    let mut result = [0.0; C];
    for i in 0..A {
        for j in 0..B {
            result[i + j] += a[i] * b[j];
        }
    }
    result
}

/// First crossing of a series from non-negative to negative in [0, width].
pub(crate) fn crossing(series: &Series, width: f64) -> Option<f64> {
    let mut swing = 0.0;
    for c in series[1..].iter().rev() {
        swing = (swing + c.abs()) * width;
    }
    if series[0] > swing {
        return None;
    }
    first_crossing(series, width)
}

/// The point of [0, width] where a monotone series takes the value `level`; `sign` is the sign of
/// series − level at 0.
pub(crate) fn root(series: &Series, level: f64, sign: f64, width: f64) -> f64 {
    Bracket::new(0.0, width).refine(|at| {
        let (value, slope) = value_and_slope(series, at);
        (sign * (value - level), sign * slope)
    })
}
