//! Bracketed roots to machine precision. One loop, [`Bracket::iterate`], takes a guess, a rule for
//! each step and a criterion for the last step.

use core::cmp::Ordering;

/// An interval that contains one crossing from non-negative to negative and no other root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bracket {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

pub(crate) struct RootStep {
    /// Value at the beginning of the step.
    pub(crate) value: f64,
    pub(crate) step: f64,
    /// A step no longer than this ends at the root; the function is not evaluated there.
    pub(crate) last: f64,
}

/// 2⁻⁵³ |x|: from half a unit to one unit in the last place.
pub(crate) fn last_digit(x: f64) -> f64 {
    0.5 * f64::EPSILON * x.abs()
}

/// The last of `low`, `low` + 1, … below `high` for which a monotone condition holds; it holds for
/// `low`.
pub(crate) fn last_of(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    while high - low > 1.0 {
        let middle = (0.5 * (low + high)).floor();
        // Beyond 2⁵³ there may be no number between.
        if middle <= low {
            break;
        }
        if holds(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Longest last step of Newton's method on an interval of length 2. The error of order 1e-18 is
/// below rounding.
const LAST_NEWTON_STEP: f64 = 1e-9;

/// Maximum number of Halley steps on one model: each triples the number of correct digits, so three
/// suffice after the first.
const MAX_MODEL_STEPS: u32 = 4;

/// The step of Halley's method, and whether it ends at the root to the last digit of `of`. The
/// error is of the third order in step/`length`, unless another root is close.
fn halley((value, slope, curvature): (f64, f64, f64), of: f64, length: f64) -> (f64, bool) {
    let newton = -value / slope;
    // Far from the root the second derivative is unreliable.
    let bend = (0.5 * newton * curvature / slope).clamp(-0.5, 0.5);
    let step = newton / (1.0 + bend);
    // A short step next to another root is not the last.
    let is_last = step.abs() <= 1e-6 * of.abs().min(length)
        && bend * bend * step.abs() <= f64::EPSILON * of.abs();
    (step, is_last)
}

impl RootStep {
    /// Newton's method, from the value and the slope at a point.
    pub(crate) fn newton(at: f64, (value, slope): (f64, f64)) -> Self {
        Self {
            value,
            step: -value / slope,
            last: last_digit(at),
        }
    }

    /// Halley's method with a model of the function about `at`, which is cheaper than the function.
    ///
    /// `here` holds the value and the first two derivatives at `at`; `model` gives them at a
    /// distance from it. The model is accurate to rounding up to the distance `reach`; `length` is
    /// the scale on which the function changes.
    #[inline]
    pub(crate) fn by_model(
        at: f64,
        here: (f64, f64, f64),
        reach: f64,
        length: f64,
        model: impl Fn(f64) -> (f64, f64, f64),
    ) -> Self {
        let (mut step, mut is_last) = halley(here, at, length);
        let mut steps = 1;
        while !is_last && step.abs() <= reach && steps < MAX_MODEL_STEPS {
            let (more, is_short) = halley(model(step), at, length);
            step += more;
            is_last = is_short && step.abs() <= reach;
            steps += 1;
        }
        Self {
            value: here.0,
            step,
            last: if is_last {
                f64::INFINITY
            } else {
                last_digit(at)
            },
        }
    }
}

impl Bracket {
    pub(crate) const fn new(low: f64, high: f64) -> Self {
        Self { low, high }
    }

    /// The root of `function` by Newton's method from the midpoint.
    ///
    /// `function` returns the value and the derivative; it is non-negative at `low` and not
    /// positive at `high`.
    pub(crate) fn refine(self, mut function: impl FnMut(f64) -> (f64, f64)) -> f64 {
        self.iterate(0.5 * (self.low + self.high), |x| {
            RootStep::newton(x, function(x))
        })
    }

    /// The root of `function` by Newton's method from the zero of the secant. The interval is no
    /// longer than 2, and `function` a polynomial with coefficients of the order of its values. The
    /// last step is not verified.
    pub(crate) fn refine_from_secant(self, mut function: impl FnMut(f64) -> (f64, f64)) -> f64 {
        let (first, last) = (function(self.low).0, function(self.high).0);
        self.refine_from_values(first, last, function)
    }

    /// The same, where the values at both ends are known.
    pub(crate) fn refine_from_values(
        self,
        first: f64,
        last: f64,
        mut function: impl FnMut(f64) -> (f64, f64),
    ) -> f64 {
        let Self { low, high } = self;
        let is_known = first > 0.0 && last < 0.0;
        let guess = if is_known {
            (low * last - high * first) / (last - first)
        } else {
            0.5 * (low + high)
        };
        self.iterate(guess, |x| {
            let newton = RootStep::newton(x, function(x));
            // A step that leads nowhere else would not be taken, and the bracket halved fifty times.
            if newton.step.abs() <= newton.last {
                return RootStep {
                    value: 0.0,
                    ..newton
                };
            }
            RootStep {
                last: LAST_NEWTON_STEP,
                ..newton
            }
        })
    }

    /// The root of a function that is positive below the root and negative above it. `next_step`
    /// evaluates the function and proposes a step. A proposal that leaves the bracket, or is longer
    /// than half the previous step, is replaced by bisection. The guess may lie outside the
    /// bracket.
    pub(crate) fn iterate(self, guess: f64, mut next_step: impl FnMut(f64) -> RootStep) -> f64 {
        let (mut low, mut high) = (self.low, self.high);
        if high <= low {
            return low;
        }
        let mut x = if guess > low && guess < high {
            guess
        } else {
            0.5 * (low + high)
        };
        let mut width = high - low;
        loop {
            let RootStep { value, step, last } = next_step(x);
            match value.partial_cmp(&0.0) {
                Some(Ordering::Equal) => return x,
                Some(Ordering::Greater) => low = x,
                Some(Ordering::Less) | None => high = x,
            }
            let proposed = x + step;
            let taken = proposed > low && proposed < high && step.abs() < 0.5 * width;
            let next = if taken {
                proposed
            } else {
                low + 0.5 * (high - low)
            };
            width = (next - x).abs();
            let last = if taken { last } else { last_digit(x) };
            if next == x || next <= low || next >= high || width <= last {
                return next;
            }
            x = next;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// π between 2 and 4 by models of sin x, and the number of models.
    fn pi_from(guess: f64, reach: f64) -> (f64, u32) {
        let mut models = 0;
        let root = Bracket::new(2.0, 4.0).iterate(guess, |point| {
            models += 1;
            let model = |step: f64| {
                let (sin, cos) = libm::sincos(point + step);
                (sin, cos, -sin)
            };
            RootStep::by_model(point, model(0.0), reach, 1.0, model)
        });
        (root, models)
    }

    #[test]
    fn a_root_within_reach_takes_one_model_and_a_root_out_of_reach_few() {
        let within = [2.9, 3.0, 3.15, 3.3].map(|guess| (guess, 0.25, 1..=1));
        let beyond = [
            (2.3, 0.25, 2),
            (3.9, 0.25, 2),
            (3.0, 0.0, 3),
            (9.0, 1e-3, 3),
            (2.1, 0.0, 4),
        ]
        .map(|(guess, reach, most)| (guess, reach, 2..=most));
        for (guess, reach, expected) in within.into_iter().chain(beyond) {
            let (root, models) = pi_from(guess, reach);
            assert!(
                (root - core::f64::consts::PI).abs() < 1e-15,
                "{guess} {reach}: {root}"
            );
            assert!(expected.contains(&models), "{guess} {reach}: {models}");
        }
    }

    #[test]
    fn a_secant_leads_to_a_root_in_few_steps() {
        for root in [0.0, 1e-6, 0.2, 0.5, 0.9, 1.0] {
            let mut evaluations = 0;
            // (root − x)(2 + x) has a small curvature.
            let found = Bracket::new(0.0, 1.0).refine_from_secant(|x| {
                evaluations += 1;
                ((root - x) * (2.0 + x), root - 2.0 - 2.0 * x)
            });
            assert!((found - root).abs() < 2e-16, "{root}: {found}");
            // A root at an end of the bracket is found by bisection.
            assert!(
                evaluations <= 6 || root == 0.0 || root == 1.0,
                "{root}: {evaluations}"
            );
        }
    }

    /// Rounding may leave a value at the root whose Newton step moves nothing.
    #[test]
    fn a_secant_leads_to_the_root_of_a_rounded_polynomial_in_few_steps() {
        for k in 0..4_000 {
            let (root, mut evaluations) = ((f64::from(k) + 0.5) / 4_000.0, 0);
            // (root − x)(1 + x + 0.3 x²).
            let [a, b, c, d] = [root, root - 1.0, 0.3 * root - 1.0, -0.3];
            let found = Bracket::new(0.0, 1.0).refine_from_secant(|x| {
                evaluations += 1;
                let value = a + x * (b + x * (c + x * d));
                (value, b + x * (2.0 * c + 3.0 * x * d))
            });
            assert!((found - root).abs() < 1e-15, "{root}: {found}");
            assert!(evaluations <= 8, "{root}: {evaluations}");
        }
    }

    #[test]
    fn newtons_method_stays_in_the_bracket() {
        // From the middle its first step would leave it.
        let root = Bracket::new(0.0, 10.0).refine(|x| (1.0 - x * x * x / 8.0, -3.0 * x * x / 8.0));
        assert!((root - 2.0).abs() < 1e-15, "{root}");
        let root = Bracket::new(-1.0, 9.0).refine(|x| (-libm::atan(x), -1.0 / (1.0 + x * x)));
        assert!(root.abs() < 1e-300, "{root}");
        assert_eq!(
            Bracket {
                low: 3.0,
                high: 3.0
            }
            .refine(|_| (f64::NAN, f64::NAN)),
            3.0
        );
    }
}
