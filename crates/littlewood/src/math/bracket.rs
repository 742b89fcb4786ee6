//! Roots to the last digits: one loop, [`Bracket::iterate`], for every root that is known to lie between two numbers, with a guess for
//! the first step and a rule for the last one.

use core::cmp::Ordering;

/// An interval that holds the first crossing from non-negative to negative, and no other root.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bracket {
    pub(crate) low: f64,
    pub(crate) high: f64,
}

/// A step towards a root.
pub(crate) struct Step {
    /// Value where the step begins.
    pub(crate) value: f64,
    pub(crate) step: f64,
    /// Its end is the root, and not looked at again, if the step is no longer than this.
    pub(crate) last: f64,
}

/// The last digit of a number.
pub(crate) fn last_digit(x: f64) -> f64 {
    0.5 * f64::EPSILON * x.abs()
}

/// Newton's method ends with a step no longer than this in an interval of length two: its error is of the second order.
const LAST_NEWTON_STEP: f64 = 1e-9;

/// Steps after which a model of a function has told what it can.
const STEPS_OF_A_MODEL: u32 = 4;

/// The step of Halley's method, and whether its end is the root to the last digit of a number: its error is of the third
/// power in units of a length, unless another root is close.
fn halley((value, slope, curvature): (f64, f64, f64), of: f64, length: f64) -> (f64, bool) {
    let newton = -value / slope;
    // Far from the root the second derivative is not to be trusted.
    let bend = (0.5 * newton * curvature / slope).clamp(-0.5, 0.5);
    let step = newton / (1.0 + bend);
    // Next to another root a short step is not yet the last.
    let is_last =
        step.abs() <= 1e-6 * of.abs().min(length) && bend * bend * step.abs() <= f64::EPSILON * of.abs();
    (step, is_last)
}

impl Step {
    /// Newton's method, from the value and the slope at a point.
    pub(crate) fn newton(at: f64, (value, slope): (f64, f64)) -> Self {
        Self { value, step: -value / slope, last: last_digit(at) }
    }

    /// Halley's method with a model of the function about a point, which costs less than the function itself: value and first two
    /// derivatives there, and so far from it. The model is the function, to rounding, up to `reach`, and hardly takes another course over
    /// `length`.
    #[inline]
    pub(crate) fn by_model(
        at: f64,
        here: (f64, f64, f64),
        (reach, length): (f64, f64),
        model: impl Fn(f64) -> (f64, f64, f64),
    ) -> Self {
        let (mut step, mut is_last) = halley(here, at, length);
        let mut steps = 1;
        while !is_last && step.abs() <= reach && steps < STEPS_OF_A_MODEL {
            let (more, is_short) = halley(model(step), at, length);
            step += more;
            is_last = is_short && step.abs() <= reach;
            steps += 1;
        }
        Self { value: here.0, step, last: if is_last { f64::INFINITY } else { last_digit(at) } }
    }
}

impl Bracket {
    /// The root of `function` inside, to the last digits, by Newton's method from the middle.
    ///
    /// `function` returns the value and the derivative; it is non-negative at `low` and not positive at `high`.
    pub(crate) fn refine(self, mut function: impl FnMut(f64) -> (f64, f64)) -> f64 {
        self.iterate(0.5 * (self.low + self.high), |x| Step::newton(x, function(x)))
    }

    /// The same from where the secant through the ends vanishes, in an interval of length two at the most on which the function is
    /// a polynomial with coefficients of its size: the last step is not looked at again.
    pub(crate) fn refine_from_secant(self, mut function: impl FnMut(f64) -> (f64, f64)) -> f64 {
        let Self { low, high } = self;
        let (first, last) = (function(low).0, function(high).0);
        let is_known = first > 0.0 && last < 0.0;
        let guess = if is_known { (low * last - high * first) / (last - first) } else { 0.5 * (low + high) };
        self.iterate(guess, |x| Step { last: LAST_NEWTON_STEP, ..Step::newton(x, function(x)) })
    }

    /// The root inside of a function from whose value, positive below the root and negative above, `next_step` makes a step. The bracket
    /// only shrinks, and is halved where a step would leave it, or does not halve the last one. The guess may lie anywhere.
    pub(crate) fn iterate(self, guess: f64, mut next_step: impl FnMut(f64) -> Step) -> f64 {
        let (mut low, mut high) = (self.low, self.high);
        if high <= low {
            return low;
        }
        let mut x = if guess > low && guess < high { guess } else { 0.5 * (low + high) };
        let mut width = high - low;
        loop {
            let Step { value, step, last } = next_step(x);
            match value.partial_cmp(&0.0) {
                Some(Ordering::Equal) => return x,
                Some(Ordering::Greater) => low = x,
                Some(Ordering::Less) | None => high = x,
            }
            let proposed = x + step;
            let taken = proposed > low && proposed < high && step.abs() < 0.5 * width;
            let next = if taken { proposed } else { low + 0.5 * (high - low) };
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

    /// π between 2 and 4 by a model of sin x, and how many models it took.
    fn pi_from(guess: f64, reach: f64) -> (f64, u32) {
        let mut models = 0;
        let root = Bracket { low: 2.0, high: 4.0 }.iterate(guess, |point| {
            models += 1;
            let model = |step: f64| {
                let (sin, cos) = libm::sincos(point + step);
                (sin, cos, -sin)
            };
            Step::by_model(point, model(0.0), (reach, 1.0), model)
        });
        (root, models)
    }

    #[test]
    fn a_root_within_reach_takes_one_model() {
        for guess in [2.9, 3.0, 3.15, 3.3] {
            let (root, models) = pi_from(guess, 0.25);
            assert!((root - core::f64::consts::PI).abs() < 1e-15 && models == 1, "{guess}: {root} {models}");
        }
    }

    #[test]
    fn a_root_out_of_reach_takes_more() {
        for (guess, reach, most) in
            [(2.3, 0.25, 2), (3.9, 0.25, 2), (3.0, 0.0, 3), (9.0, 1e-3, 3), (2.1, 0.0, 4)]
        {
            let (root, models) = pi_from(guess, reach);
            let found = (root - core::f64::consts::PI).abs() < 1e-15;
            assert!(found && models > 1 && models <= most, "{guess} {reach}: {root} {models}");
        }
    }

    #[test]
    fn a_secant_leads_to_a_root_in_few_steps() {
        for root in [0.0, 1e-6, 0.2, 0.5, 0.9, 1.0] {
            let mut evaluations = 0;
            // (root − x)(2 + x), which hardly bends.
            let found = Bracket { low: 0.0, high: 1.0 }.refine_from_secant(|x| {
                evaluations += 1;
                ((root - x) * (2.0 + x), root - 2.0 - 2.0 * x)
            });
            assert!((found - root).abs() < 2e-16, "{root}: {found}");
            // Next to a root at an end no sign shows on which side it is, and the interval is halved.
            assert!(evaluations <= 6 || root == 0.0 || root == 1.0, "{root}: {evaluations}");
        }
    }

    #[test]
    fn newtons_method_stays_in_the_bracket() {
        // From the middle its first step would leave it.
        let root = Bracket { low: 0.0, high: 10.0 }.refine(|x| (1.0 - x * x * x / 8.0, -3.0 * x * x / 8.0));
        assert!((root - 2.0).abs() < 1e-15, "{root}");
        let root = Bracket { low: -1.0, high: 9.0 }.refine(|x| (-libm::atan(x), -1.0 / (1.0 + x * x)));
        assert!(root.abs() < 1e-300, "{root}");
        assert_eq!(Bracket { low: 3.0, high: 3.0 }.refine(|_| (f64::NAN, f64::NAN)), 3.0);
    }
}
