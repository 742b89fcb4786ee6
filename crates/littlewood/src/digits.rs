//! How many digits of a motion can be trusted: an estimate, by motions that start beside it.

use crate::error::ParameterError;
use crate::hoop::Hoop;
use crate::limits::Limits;
use crate::quantity::Quantity;
use crate::setup::Setup;
use crate::state::{Start, State};
use crate::transition::Transition;

/// Estimated numbers of significant decimal digits of the state at a transition, from 0 to 15.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Digits {
    /// Of the time τ.
    pub time: u8,
    /// Of the angle θ.
    pub theta: u8,
    /// Of the rate θ′.
    pub theta_rate: u8,
    /// Of the slip velocity η′.
    pub slip: u8,
    /// Of the position x.
    pub x: u8,
}

/// Digits of a number that nothing but its own last digit makes uncertain.
const ALL: u8 = 15;

/// Units of the last place by which a number is changed: enough to be seen through the rounding of the results.
const UNITS: u64 = 8;

impl Hoop {
    /// Estimates for each transition of the motion from `start` how many digits of its state the numbers of the hoop and of the
    /// start determine, and with them any computation in doubles.
    ///
    /// Each number is changed by a few units of its last place, up and down, and the motion is simulated again, up to 24 times. The
    /// changes of a state, added over the numbers, are its uncertainty. A transition is `None` from which on a motion with such a change has
    /// other events: the numbers do not decide what happens there. Numbers that are 0, ℓ̂ = 1 and e = 1 are taken to be meant
    /// exactly, and so is μs = μk, which are changed together.
    ///
    /// It is an estimate, not a bound: rounding within the simulation is not followed but taken to be of that size, and a change
    /// that is not proportional to that of the number may be larger between.
    ///
    /// ```
    /// use littlewood::{Hoop, Limits, Start};
    ///
    /// let hoop = Hoop::figure_2(0.5, 0.4)?;
    /// let digits = hoop.digits(Start::at(std::f64::consts::FRAC_PI_2, 2.0), Limits::default())?;
    /// assert!(digits.iter().all(|at| at.is_some_and(|at| at.time >= 13 && at.theta >= 13)));
    /// # Ok::<(), littlewood::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// As [`Hoop::simulate`].
    pub fn digits(&self, start: Start, limits: Limits) -> Result<Vec<Option<Digits>>, ParameterError> {
        let motion = self.simulate(start, limits)?;
        let mut spreads = Vec::from_iter(motion.transitions().iter().map(|_| Some([0.0; 5])));
        for pair in self.neighbours(start) {
            let changes = pair.map(|setup| {
                let hoop = Self::new(setup.hoop).ok()?;
                // A bound may forbid the one direction; the other remains.
                hoop.simulate(setup.start, limits).ok()
            });
            for (index, (spread, transition)) in spreads.iter_mut().zip(motion.transitions()).enumerate() {
                let mut largest = [0.0_f64; 5];
                for other in changes.iter().flatten() {
                    match other.transitions().get(index) {
                        Some(other) if is_alike(other, transition) => {
                            let numbers = numbers(&other.before).into_iter().zip(numbers(&transition.before));
                            for (most, (a, b)) in largest.iter_mut().zip(numbers) {
                                *most = most.max(if a == b { 0.0 } else { (a - b).abs() });
                            }
                        }
                        Some(_) | None => *spread = None,
                    }
                }
                for (sum, most) in spread.iter_mut().flatten().zip(largest) {
                    *sum += most;
                }
            }
        }
        let mut decided = true;
        Ok(Vec::from_iter(spreads.into_iter().zip(motion.transitions()).map(|(spread, transition)| {
            decided &= spread.is_some();
            let spread = spread.filter(|_| decided)?;
            let [time, theta, theta_rate, slip, x] = numbers(&transition.before);
            let digits = |value, place: usize| digits(value, spread[place]);
            Some(Digits {
                time: digits(time, 0),
                theta: digits(theta, 1),
                theta_rate: digits(theta_rate, 2),
                slip: digits(slip, 3),
                x: digits(x, 4),
            })
        })))
    }

    /// Hoops and starts that differ in the last place of one number, closer to zero and farther.
    fn neighbours(&self, start: Start) -> impl Iterator<Item = [Setup; 2]> {
        let setup = Setup::new(self.parameters(), start);
        let is_exact = |quantity, value: f64| {
            value == 0.0 || (value == 1.0 && matches!(quantity, Quantity::Offset | Quantity::Restitution))
        };
        let coefficients_are_equal = self.mu_s() == self.mu_k();
        Quantity::HOOP.into_iter().chain(Quantity::START).filter_map(move |quantity| {
            let value = setup.get(quantity).filter(|value| !is_exact(quantity, *value))?;
            if coefficients_are_equal && quantity == Quantity::MuK {
                return None;
            }
            Some([value.to_bits().saturating_sub(UNITS), value.to_bits() + UNITS].map(|bits| {
                let value = f64::from_bits(bits);
                let mut setup = setup;
                setup.set(quantity, value);
                if coefficients_are_equal && quantity == Quantity::MuS {
                    setup.set(Quantity::MuK, value);
                }
                setup
            }))
        })
    }
}

impl Digits {
    /// The least of the five.
    #[must_use]
    pub fn least(&self) -> u8 {
        let Self { time, theta, theta_rate, slip, x } = *self;
        [time, theta, theta_rate, slip, x].into_iter().min().unwrap_or(0)
    }
}

/// Whether two transitions are the same event.
fn is_alike(a: &Transition, b: &Transition) -> bool {
    (a.cause, a.from, a.to, a.direction) == (b.cause, b.from, b.to, b.direction)
}

const fn numbers(state: &State) -> [f64; 5] {
    [state.time, state.theta, state.theta_rate, state.slip, state.x]
}

/// Significant digits of a value that is uncertain by `spread`.
fn digits(value: f64, spread: f64) -> u8 {
    if value.is_infinite() || spread == 0.0 {
        return if spread == 0.0 { ALL } else { 0 };
    }
    let relative = f64::EPSILON + spread / value.abs();
    // Rounds down; infinite where the value is 0.
    (-libm::log10(relative)).clamp(0.0, f64::from(ALL)) as u8
}
