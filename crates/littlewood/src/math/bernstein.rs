//! Isolation of the sign changes of a polynomial by the variation-diminishing property of its
//! Bernstein form.
//!
//! On [0, 1] the number of roots in (0, 1) is at most the number of sign changes of the Bernstein
//! coefficients, and has the same parity. No sign change proves that there is no root, one proves
//! exactly one root. Otherwise de Casteljau's scheme halves the interval, and the left half is
//! examined first. No crossing is missed, however short the excursion. An excursion shorter than
//! 2⁻⁵⁰ of the interval cannot be distinguished from a double root in double precision; its end
//! values decide.

use crate::math::bracket::Bracket;

/// Largest degree: above that of any Taylor series of a slide.
pub(crate) const MAX_DEGREE: usize = 24;

/// Maximum number of halvings: 2⁻⁵⁰ of the interval is at the resolution of doubles.
const MAX_HALVINGS: u32 = 50;

/// Rounding of a coefficient of a margin of rolling beside its terms: 64 roundings of the body, the
/// angle, four forms and their conversion to an arc.
const FORM_ROUNDING: f64 = 64.0 * f64::EPSILON;

/// A polynomial of degree at most [`MAX_DEGREE`] on [0, 1] in Bernstein form.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bernstein {
    coefficients: [f64; MAX_DEGREE + 1],
    degree: usize,
}

/// The interval on which the Bernstein form is one.
const UNIT: Bracket = Bracket::new(0.0, 1.0);

const BINOMIAL: [[f64; MAX_DEGREE + 1]; MAX_DEGREE + 1] = {
    let mut table = [[0.0; MAX_DEGREE + 1]; MAX_DEGREE + 1];
    let mut n = 0;
    while n <= MAX_DEGREE {
        table[n][0] = 1.0;
        let mut k = 1;
        while k <= n {
            table[n][k] = table[n - 1][k - 1] + if k < n { table[n - 1][k] } else { 0.0 };
            k += 1;
        }
        n += 1;
    }
    table
};

impl Bernstein {
    /// From Taylor coefficients about 0 on [0, width]: b_j = Σ_{i ≤ j} C(j, i)/C(n, i) a_i width^i.
    pub(crate) fn from_taylor(taylor: &[f64], width: f64) -> Self {
        let degree = taylor.len() - 1;
        let mut scaled = [0.0; MAX_DEGREE + 1];
        let mut power = 1.0;
        for (i, a) in taylor.iter().enumerate() {
            scaled[i] = a * power / BINOMIAL[degree][i];
            // Keeps 0 · ∞ = NaN out: a slide of 1e30 time units has zero coefficients from the
            // third on.
            power = (power * width).min(f64::MAX);
        }
        let mut coefficients = [0.0; MAX_DEGREE + 1];
        for j in 0..=degree {
            let mut sum = 0.0;
            for i in (0..=j).rev() {
                sum += BINOMIAL[j][i] * scaled[i];
            }
            coefficients[j] = sum;
        }
        Self {
            coefficients,
            degree,
        }
    }

    /// From the coefficients of a form Σ g_k a^{n−k} b^k in the barycentric coordinates of an arc.
    pub(crate) fn from_form(form: &[f64]) -> Self {
        let degree = form.len() - 1;
        let mut coefficients = [0.0; MAX_DEGREE + 1];
        for (k, g) in form.iter().enumerate() {
            coefficients[k] = g / BINOMIAL[degree][k];
        }
        Self {
            coefficients,
            degree,
        }
    }

    pub(crate) fn coefficients(&self) -> &[f64] {
        &self.coefficients[..=self.degree]
    }

    pub(crate) fn negated(mut self) -> Self {
        for b in &mut self.coefficients[..=self.degree] {
            *b = -*b;
        }
        self
    }

    /// Sign just right of 0: that of the first non-zero coefficient.
    pub(crate) fn initial_sign(&self) -> f64 {
        first_sign(self.coefficients().iter())
    }

    /// Value and derivative at x by de Casteljau's scheme, stable on [0, 1].
    pub(crate) fn value_and_slope(&self, x: f64) -> (f64, f64) {
        if self.degree == 0 {
            return (self.coefficients[0], 0.0);
        }
        let mut work = self.coefficients;
        for level in (1..self.degree).rev() {
            for i in 0..=level {
                work[i] = (1.0 - x) * work[i] + x * work[i + 1];
            }
        }
        let degree = f64::from(u32::try_from(self.degree).unwrap_or(0));
        (
            (1.0 - x) * work[0] + x * work[1],
            degree * (work[1] - work[0]),
        )
    }

    /// The polynomial in 1 − x.
    pub(crate) fn reversed(mut self) -> Self {
        self.coefficients[..=self.degree].reverse();
        self
    }

    /// Sets the value at 0 to zero, for a polynomial that vanishes there up to rounding.
    pub(crate) fn starting_at_zero(mut self) -> Self {
        self.coefficients[0] = 0.0;
        self
    }

    /// Sets the first coefficients to zero that are rounding, for a polynomial that is known to be
    /// positive right of 0.
    pub(crate) fn without_rounding_at_start(mut self) -> Self {
        remove_rounding_at_start(&mut self.coefficients[..=self.degree]);
        self
    }

    /// First crossing from non-negative to negative in [0, 1]. A polynomial that is negative right
    /// of 0 crosses at 0. A root without a sign change is not a crossing.
    pub(crate) fn first_crossing(&self) -> Option<Bracket> {
        self.search(UNIT, 0, &mut 1.0, &mut |_, bracket| Some(bracket))
    }

    /// All points of (0, 1) at which the sign changes, in order; roots without a sign change are
    /// left out.
    pub(crate) fn sign_changes(&self) -> Vec<f64> {
        let mut changes = Vec::new();
        self.search(UNIT, 0, &mut 0.0, &mut |part, Bracket { low, high }| {
            let falling = if part.initial_sign() > 0.0 {
                *part
            } else {
                part.negated()
            };
            let at = UNIT.refine(|x| falling.value_and_slope(x));
            changes.push(if low < high {
                low + at * (high - low)
            } else {
                low
            });
            None::<()>
        });
        changes
    }

    /// Sign just left of 1.
    pub(crate) fn final_sign(&self) -> f64 {
        first_sign(self.coefficients().iter().rev())
    }

    /// Passes the sign changes to `found`, in order, until it returns an answer.
    ///
    /// `self` is the polynomial on the subinterval `on` of [0, 1], `sign` the sign before it.
    /// `found` gets the polynomial on the subinterval that isolates the change; a change at a
    /// boundary has an empty subinterval.
    fn search<T>(
        &self,
        on: Bracket,
        halvings: u32,
        sign: &mut f64,
        found: &mut impl FnMut(&Self, Bracket) -> Option<T>,
    ) -> Option<T> {
        let (mut changes, mut first, mut last) = (0, 0.0, 0.0);
        let coefficients = self.coefficients().iter().filter(|b| **b != 0.0);
        for b in coefficients.map(|b| b.signum()) {
            if first == 0.0 {
                first = b;
            } else if b != last {
                changes += 1;
            }
            last = b;
        }
        if first == 0.0 {
            return None;
        }
        if first * *sign < 0.0 {
            *sign = first;
            if let Some(answer) = found(self, Bracket::new(on.low, on.low)) {
                return Some(answer);
            }
        }
        if changes > 1 && halvings < MAX_HALVINGS {
            let (left, right) = self.halves();
            let middle = 0.5 * (on.low + on.high);
            return left
                .search(Bracket { high: middle, ..on }, halvings + 1, sign, found)
                .or_else(|| {
                    right.search(Bracket { low: middle, ..on }, halvings + 1, sign, found)
                });
        }
        *sign = last;
        if first == last { None } else { found(self, on) }
    }

    fn halves(&self) -> (Self, Self) {
        let mut left = *self;
        let mut right = *self;
        for level in 1..=self.degree {
            for i in 0..=self.degree - level {
                right.coefficients[i] = 0.5 * (right.coefficients[i] + right.coefficients[i + 1]);
            }
            left.coefficients[level] = right.coefficients[0];
        }
        (left, right)
    }
}

/// The sign of the first number that is not zero; zero without one.
fn first_sign<'a>(mut numbers: impl Iterator<Item = &'a f64>) -> f64 {
    numbers
        .find(|number| **number != 0.0)
        .map_or(0.0, |number| number.signum())
}

/// Sets the first coefficients to zero that are rounding beside the largest.
pub(crate) fn remove_rounding_at_start(coefficients: &mut [f64]) {
    let size = |largest: f64, c: &f64| largest.max(c.abs());
    let rounding = FORM_ROUNDING * coefficients.iter().fold(0.0, size);
    let leading = coefficients.iter_mut().take_while(|c| c.abs() <= rounding);
    leading.for_each(|c| *c = 0.0);
}

/// Value and derivative of the polynomial with these Taylor coefficients.
#[inline]
pub(crate) fn value_and_slope(taylor: &[f64], at: f64) -> (f64, f64) {
    taylor.iter().rev().fold((0.0, 0.0), |(sum, slope), c| {
        (sum * at + c, slope * at + sum)
    })
}

/// First crossing of the polynomial from non-negative to negative in [0, width].
pub(crate) fn first_crossing(taylor: &[f64], width: f64) -> Option<f64> {
    let Bracket { low, high } = Bernstein::from_taylor(taylor, width).first_crossing()?;
    let bracket = Bracket::new(low * width, high * width);
    Some(bracket.refine(|at| value_and_slope(taylor, at)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Bernstein form of Π (x − r) times a sign, by multiplying linear factors.
    fn planted(roots: &[f64], sign: f64) -> Bernstein {
        let mut taylor = vec![sign];
        for r in roots {
            let mut next = vec![0.0; taylor.len() + 1];
            for (i, a) in taylor.iter().enumerate() {
                next[i] -= r * a;
                next[i + 1] += a;
            }
            taylor = next;
        }
        Bernstein::from_taylor(&taylor, 1.0)
    }

    fn first_root(polynomial: &Bernstein) -> Option<f64> {
        polynomial
            .first_crossing()
            .map(|bracket| bracket.refine(|x| polynomial.value_and_slope(x)))
    }

    #[test]
    fn all_sign_changes_are_found() {
        let roots = [0.05, 0.2, 0.45, 0.46, 0.8, 0.97];
        for sign in [1.0, -1.0] {
            let found = planted(&roots, sign).sign_changes();
            assert_eq!(found.len(), roots.len());
            for (found, root) in found.into_iter().zip(roots) {
                assert!((found - root).abs() < 1e-10, "{found} {root}");
            }
        }
    }

    #[test]
    fn a_double_root_is_no_crossing_and_no_sign_change() {
        assert_eq!(planted(&[0.5, 0.5], 1.0).first_crossing(), None);
        let found = planted(&[0.5, 0.5, 0.75], -1.0);
        assert!(first_root(&found).is_some_and(|root| (root - 0.75).abs() < 1e-14));
        let found = planted(&[0.3, 0.3, 0.7], 1.0).sign_changes();
        // Rounding may split the double root in two.
        assert!(found.len() % 2 == 1 && found.len() <= 3, "{found:?}");
        assert!(
            found.last().is_some_and(|root| (root - 0.7).abs() < 1e-12),
            "{found:?}"
        );
        assert!(
            found
                .iter()
                .rev()
                .skip(1)
                .all(|root| (root - 0.3).abs() < 1e-7),
            "{found:?}"
        );
    }

    #[test]
    fn the_sign_after_a_root_at_zero_decides() {
        assert_eq!(planted(&[0.0], 1.0).first_crossing(), None);
        assert_eq!(
            planted(&[0.0], -1.0).first_crossing(),
            Some(Bracket {
                low: 0.0,
                high: 0.0
            })
        );
        let found = first_root(&planted(&[0.0, 0.25], -1.0)).expect("the second root");
        assert!((found - 0.25).abs() < 1e-15);
    }

    proptest! {
        #[test]
        fn planted_roots_are_found(
            first in 0.01..0.9_f64, gap in 1e-6..0.1_f64, outside in prop::collection::vec(1.1..3.0_f64, 0..6),
        ) {
            // Two close roots: an excursion of width `gap` that sampling would step over.
            let mut roots = vec![first, first + gap];
            roots.extend(&outside);
            let sign = if outside.len() % 2 == 0 { 1.0 } else { -1.0 };
            let found = first_root(&planted(&roots, sign));
            let found = found.expect("an excursion below zero");
            // Rounding of the coefficients moves a root by about ε·(size of the
            // coefficients)/slope.
            prop_assert!((found - first).abs() < 1e-11 / gap, "{found} {first}");
        }

        #[test]
        fn taylor_and_bernstein_forms_agree(a in prop::collection::vec(-1.0..1.0_f64, 1..20), x in 0.0..1.0_f64) {
            let (value, slope) = Bernstein::from_taylor(&a, 0.5).value_and_slope(x);
            let (same, same_slope) = value_and_slope(&a, 0.5 * x);
            prop_assert!((value - same).abs() < 1e-13 && (slope - 0.5 * same_slope).abs() < 1e-12);
            let horner = a.iter().rev().fold(0.0, |sum, c| sum * (0.5 * x) + c);
            prop_assert!((value - horner).abs() < 1e-13);
        }
    }
}
