//! Sign changes of a polynomial of degree three between its extrema.

use crate::math::bracket::Bracket;

/// c0 + c1 x + c2 x² + c3 x³. Where c0 is small against the other terms, a root near 0 is as exact as c0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cubic(pub(super) [f64; 4]);

impl Cubic {
    /// Divides by x, where the value at 0 is 0.
    pub(super) const fn without_root_at_zero(self) -> Self {
        let [_, c1, c2, c3] = self.0;
        Self([c1, c2, c3, 0.0])
    }

    /// Sign just right of 0.
    pub(super) fn initial_sign(&self) -> f64 {
        self.0.into_iter().find(|c| *c != 0.0).map_or(0.0, f64::signum)
    }

    pub(super) fn value_and_slope(&self, x: f64) -> (f64, f64) {
        let [c0, c1, c2, c3] = self.0;
        (c0 + x * (c1 + x * (c2 + x * c3)), c1 + x * (2.0 * c2 + x * (3.0 * c3)))
    }

    /// The zeros of the slope, the smaller first, each without cancellation.
    fn extrema(&self) -> [Option<f64>; 2] {
        let [_, c1, c2, c3] = self.0;
        if c3 == 0.0 {
            return [(c2 != 0.0).then(|| -0.5 * c1 / c2), None];
        }
        let discriminant = c2 * c2 - 3.0 * c1 * c3;
        if discriminant < 0.0 {
            return [None; 2];
        }
        let sum = -(c2 + discriminant.sqrt().copysign(c2));
        if sum == 0.0 {
            return [Some(0.0), None];
        }
        let (one, other) = (sum / (3.0 * c3), c1 / sum);
        [Some(one.min(other)), Some(one.max(other))]
    }

    /// The first change of sign on the way from one number to another, if it has `sign` where the way begins. Between extrema
    /// there is one at most.
    pub(super) fn first_change(&self, from: f64, to: f64, sign: f64) -> Option<f64> {
        let mut extrema = self.extrema();
        if from > to {
            extrema.reverse();
        }
        let (least, most) = (from.min(to), from.max(to));
        let between = extrema.into_iter().flatten().filter(|x| *x > least && *x < most);
        let mut at = from;
        for next in between.chain([to]) {
            if sign * self.value_and_slope(next).0 < 0.0 {
                let fall = if from < to { sign } else { -sign };
                return Some(Bracket { low: at.min(next), high: at.max(next) }.refine(|x| {
                    let (value, slope) = self.value_and_slope(x);
                    (fall * value, fall * slope)
                }));
            }
            at = next;
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_slope_is_that_of_the_value() {
        // (x + 1)(x − 2)(x − 3) = 6 + x − 4x² + x³, and its derivative.
        let cubic = Cubic([6.0, 1.0, -4.0, 1.0]);
        for k in -4..=8 {
            let x = 0.5 * f64::from(k);
            let (a, b, c) = (x + 1.0, x - 2.0, x - 3.0);
            assert_eq!(cubic.value_and_slope(x), (a * b * c, a * b + a * c + b * c));
        }
    }
}
