//! What errors of the given numbers make of a motion: to first order, by its derivatives, and in a
//! sample of motions.

use littlewood::derivatives::{Derivative, Derivatives, NotDifferentiable};
use littlewood::tables::{Quantity, Setup};
use littlewood::{Hoop, Limits, State, Trajectory};

/// Number of motions of a sample.
pub const SAMPLE: usize = 10_000;

/// The standard errors of a motion whose numbers have independent normal errors.
#[derive(Clone, Debug)]
pub struct Uncertainty {
    /// The quantities with their standard errors.
    pub given: Vec<(Quantity, f64)>,
    /// Number of motions of the sample whose numbers are accepted.
    pub motions: usize,
    /// Those with the outcome of the motion, after the same transitions.
    pub alike: usize,
    /// For each transition, and last for the outcome.
    pub spreads: Vec<Spread>,
}

/// The standard errors of a state.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    /// To first order; none where a derivative does not exist.
    pub first_order: Option<State>,
    /// In the motions of the sample that have had the same transitions; none with fewer than two.
    pub sample: Option<State>,
    /// The number of these motions.
    pub motions: usize,
}

/// Sums of the numbers of states, about a first state.
#[derive(Clone, Copy, Debug)]
struct Sums {
    count: usize,
    sum: [f64; 5],
    squares: [f64; 5],
}

impl Sums {
    fn add(&mut self, state: &State, about: &State) {
        self.count += 1;
        for (n, (value, from)) in state.numbers().into_iter().zip(about.numbers()).enumerate() {
            let change = value - from;
            self.sum[n] += change;
            self.squares[n] += change * change;
        }
    }

    fn deviation(&self) -> Option<State> {
        let count = self.count as f64;
        let spread = |n: usize| {
            let mean = self.sum[n] / count;
            ((self.squares[n] / count - mean * mean).max(0.0) * count / (count - 1.0)).sqrt()
        };
        (self.count > 1).then(|| state_of(spread))
    }
}

/// A state by its numbers, in the order of [`State::COLUMNS`].
fn state_of(number: impl Fn(usize) -> f64) -> State {
    State {
        time: number(0),
        theta: number(1),
        theta_rate: number(2),
        slip: number(3),
        x: number(4),
    }
}

impl Uncertainty {
    /// The standard errors of a motion with these limits. A number whose sample is out of bounds,
    /// such as a friction below 0, is left out. `progress` is told how many motions of the sample
    /// are done.
    ///
    /// # Errors
    /// A quantity with respect to which the motion has no derivatives.
    pub fn new(
        setup: &Setup,
        limits: Limits,
        motion: &Trajectory,
        given: Vec<(Quantity, f64)>,
        mut progress: impl FnMut(usize),
    ) -> Result<Self, NotDifferentiable> {
        let quantities: Vec<Quantity> = given.iter().map(|(quantity, _)| *quantity).collect();
        let derivatives = motion.derivatives(&quantities)?;
        let first_orders = first_orders(&derivatives, &given);
        let events = motion.transitions().len();
        let mut sums = vec![
            Sums {
                count: 0,
                sum: [0.0; 5],
                squares: [0.0; 5]
            };
            events + 1
        ];
        let (mut motions, mut alike) = (0, 0);
        for number in 0..SAMPLE {
            progress(number);
            let drawn = drawn(setup, &given, number);
            let other = Hoop::new(drawn.hoop).and_then(|hoop| hoop.simulate(drawn.start, limits));
            let Ok(other) = other else { continue };
            motions += 1;
            let pairs = motion.transitions().iter().zip(other.transitions());
            let same = pairs
                .take_while(|(ours, theirs)| (ours.cause, ours.to) == (theirs.cause, theirs.to));
            let mut passed = 0;
            for (ours, theirs) in same {
                sums[passed].add(&theirs.after, &ours.after);
                passed += 1;
            }
            let ends = (motion.outcome(), other.outcome());
            if passed == events
                && other.transitions().len() == events
                && ends.0.kind() == ends.1.kind()
            {
                alike += 1;
                sums[events].add(&ends.1.state(), &ends.0.state());
            }
        }
        let spreads = first_orders
            .into_iter()
            .zip(&sums)
            .map(|(first_order, sums)| Spread {
                first_order,
                sample: sums.deviation(),
                motions: sums.count,
            });
        Ok(Self {
            given,
            motions,
            alike,
            spreads: spreads.collect(),
        })
    }
}

/// The setup of a motion of the sample: each given quantity has its own normal deviate.
fn drawn(setup: &Setup, given: &[(Quantity, f64)], number: usize) -> Setup {
    let mut drawn = *setup;
    for ((quantity, error), deviate) in given.iter().zip(deviates(number, given.len())) {
        let value = setup.get(*quantity).unwrap_or(0.0) + error * deviate;
        drawn.set(*quantity, value);
    }
    drawn
}

/// The standard errors of each transition and of the outcome to first order: errors of different
/// quantities add in squares.
fn first_orders(derivatives: &Derivatives, given: &[(Quantity, f64)]) -> Vec<Option<State>> {
    let of = |each: Vec<Derivative<State>>| {
        let mut squares = [0.0; 5];
        for (derivative, (_, error)) in each.into_iter().zip(given) {
            for (square, slope) in squares.iter_mut().zip(derivative.ok()?.numbers()) {
                *square += (slope * error) * (slope * error);
            }
        }
        Some(state_of(|n| squares[n].sqrt()))
    };
    let events = derivatives.transitions().iter();
    let events = events.map(|each| each.iter().map(|it| it.map(|it| it.after)).collect());
    let outcome = derivatives
        .outcome()
        .iter()
        .map(|it| it.map(|it| it.state))
        .collect();
    events.chain([outcome]).map(of).collect()
}

/// Normal deviates of a point of a sequence that fills a cube evenly (the multiples of powers of a
/// generalized golden ratio), by pairs of its coordinates (Box and Muller).
fn deviates(number: usize, count: usize) -> impl Iterator<Item = f64> {
    let dimensions = 2 * count;
    // The root of x^(d + 1) = x + 1.
    let mut ratio = 2.0_f64;
    for _ in 0..64 {
        ratio = libm::pow(1.0 + ratio, 1.0 / (dimensions + 1) as f64);
    }
    let coordinate = move |dimension: usize| {
        let at = 0.5 + (number + 1) as f64 * libm::pow(ratio, -((dimension + 1) as f64));
        at - at.floor()
    };
    (0..count).map(move |k| {
        let (radius, angle) = (
            1.0 - coordinate(2 * k),
            core::f64::consts::TAU * coordinate(2 * k + 1),
        );
        (-2.0 * libm::log(radius)).sqrt() * libm::cos(angle)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn deviates_are_normal_and_independent() {
        let (mut means, mut products) = ([0.0; 3], [[0.0; 3]; 3]);
        for number in 0..SAMPLE {
            let drawn: Vec<f64> = deviates(number, 3).collect();
            for i in 0..3 {
                means[i] += drawn[i] / SAMPLE as f64;
                for j in 0..3 {
                    products[i][j] += drawn[i] * drawn[j] / SAMPLE as f64;
                }
            }
        }
        for i in 0..3 {
            assert!(means[i].abs() < 0.02, "{means:?}");
            for j in 0..3 {
                let expected = if i == j { 1.0 } else { 0.0 };
                assert!((products[i][j] - expected).abs() < 0.03, "{products:?}");
            }
        }
    }
}
