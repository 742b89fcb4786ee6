//! Derivatives of a motion with respect to the quantities of its hoop, plane and start.
//!
//! With the state y, a quantity p, the flow of a phase and the condition g(y, p) = 0 of the event
//! that ends it:
//!
//! ```text
//! δτ = −δg/g′,     δy = δy(fixed τ) + y′ δτ     at the event,
//! δy⁺ = ∂R/∂y δy + ∂R/∂p                       after an impact R,
//! ```
//!
//! and the next phase begins with δy⁺ at the time τ + δτ (R. I. Leine and H. Nijmeijer, Dynamics
//! and Bifurcations of Non-Smooth Mechanical Systems, Springer 2004). The equations of contact, of
//! impacts and of bounces that settle are those of the simulation, over numbers that carry
//! derivatives ([`crate::math::number`]); there is no difference quotient. Where a derivative does
//! not exist, [`NoDerivative`] says why.
//!
//! With rolling resistance a phase keeps its direction of rotation, and θ′ = 0 is an event like the
//! others. Without it the derivative by χ is that from within: to first order the couple −ς χ N acts
//! along the motion that it has not yet changed, with the sign of its rate.
//!
//! [`tangents`] passes from phase to phase, [`flow`] evolves a state in a phase, and [`event`] has the conditions g.

mod event;
mod flow;
mod period;
mod summary;
mod tangents;

use thiserror::Error;

use crate::math::number::WIDTH;
use crate::model::{Quantity, State, getters, named};
use crate::modes::Recurrence;
use crate::motion::columns::SummaryColumn;
use crate::motion::trajectory::Trajectory;

use summary::{PassedMotion, is_of_end};
use tangents::{InstantOfPhase, Tangents};

named! {
    /// Why a derivative does not exist.
    pub enum NoDerivative, "reason",
    /// Sentence for tables and messages.
    pub label: &'static str {
        /// The condition of the event vanishes along with its rate, but for the rounding of its
        /// terms.
        Grazing = 0, "grazing" => "the event is touched, not crossed, but for rounding: its time has no derivative";
        /// The motion begins differently on the two sides of the value. At an end of its range a
        /// quantity has the derivative from within; but a motion that goes on for ever without
        /// rolling resistance ends with the least of it.
        OneSided = 1, "one_sided" => "on the two sides of this value the motion begins differently";
        /// P = 0, or a rate or a force without bound.
        Singular = 2, "singular" => "the equations of motion are singular there";
        /// A slide of very many turns.
        TooLong = 3, "too_long" => "the slide turns too often to be followed turn by turn";
    }
}

/// A quantity with respect to which a motion has no derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("there are no derivatives with respect to {quantity}: {}", reason(*quantity))]
pub struct NotDifferentiable {
    /// The quantity.
    pub quantity: Quantity,
}

fn reason(quantity: Quantity) -> String {
    if quantity == Quantity::Restitution {
        return "the motion ends at its first landing, without a coefficient of restitution"
            .to_owned();
    }
    let known = differentiable(true);
    format!(
        "quantities of hoop and start are {}",
        Vec::from_iter(known.map(Quantity::name)).join(", ")
    )
}

/// The quantities of a hoop and a start with respect to which motions have derivatives: the
/// coefficient of restitution only of a hoop that bounces.
pub fn differentiable(bounces: bool) -> impl Iterator<Item = Quantity> {
    Quantity::HOOP
        .into_iter()
        .chain(Quantity::START)
        .filter(move |quantity| bounces || *quantity != Quantity::Restitution)
}

/// The derivatives of one transition with respect to one quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct EventDerivative {
    /// Of its time and of the state before it, along the event.
    pub before: State,
    /// Of its time and of the state after it, along the event.
    pub after: State,
}

/// The derivatives of a motion at a fixed time with respect to one quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct InstantDerivative {
    /// Of the state; that of the time is zero.
    pub state: State,
    /// Of the gap under the rim; zero in contact.
    pub gap: f64,
}

/// The derivatives of the end of a motion with respect to one quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct OutcomeDerivative {
    /// Of the state of the outcome: of its last event, or at the time limit, or at the start of an
    /// endless phase.
    pub state: State,
    /// Of the recurrence of an endless motion: the derivatives of its numbers in their places; none
    /// for other outcomes, or where the recurrence has no derivative.
    pub recurrence: Option<Recurrence>,
}

/// A derivative, or the reason why there is none.
pub type Derivative<T> = Result<T, NoDerivative>;

/// The derivatives of a motion.
#[derive(Clone, Debug, PartialEq)]
pub struct Derivatives {
    quantities: Vec<Quantity>,
    transitions: Vec<Vec<Derivative<EventDerivative>>>,
    outcome: Vec<Derivative<OutcomeDerivative>>,
    summary: Vec<Vec<Derivative<f64>>>,
}

getters! {
    Derivatives, [self]:
    /// The quantities, in the order of all lists.
    pub quantities: &[Quantity] = self.quantities.as_slice();
    /// For each transition its derivatives with respect to each quantity.
    pub transitions: &[Vec<Derivative<EventDerivative>>] = self.transitions.as_slice();
    /// The derivatives of the summary: for each of [`SummaryColumn::reals`] those with respect to
    /// each quantity, NaN where the number is absent.
    pub summary: &[Vec<Derivative<f64>>] = self.summary.as_slice();
}

impl Derivatives {
    /// The derivatives of the outcome with respect to each quantity.
    pub fn outcome(&self) -> &[Derivative<OutcomeDerivative>] {
        &self.outcome
    }
}

impl Trajectory {
    /// The derivatives of each transition and of the outcome with respect to quantities of the
    /// hoop, the plane and the start.
    ///
    /// ```
    /// use littlewood::cases::find_case;
    /// use littlewood::tables::Quantity;
    ///
    /// // How a lift-off depends on friction.
    /// let motion = find_case("figure-3").expect("a named case").simulate()?;
    /// let derivatives = motion.derivatives(&[Quantity::MuK])?;
    /// let lift_off = derivatives.transitions()[2][0].expect("a regular event");
    /// assert!(lift_off.before.time.is_finite());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// A quantity that is not [`differentiable`].
    pub fn derivatives(&self, quantities: &[Quantity]) -> Result<Derivatives, NotDifferentiable> {
        let mut all = Derivatives {
            quantities: quantities.to_vec(),
            transitions: vec![Vec::new(); self.transitions.len()],
            outcome: Vec::new(),
            summary: vec![Vec::new(); SummaryColumn::reals().count()],
        };
        for quantity in quantities {
            self.check_quantity(*quantity)?;
        }
        for group in self.groups(quantities) {
            self.add_derivatives(group, &mut all);
        }
        Ok(all)
    }

    /// The derivatives at fixed times, in any order, with respect to each quantity; none outside
    /// the motion.
    ///
    /// # Errors
    /// As [`Trajectory::derivatives`].
    pub fn derivatives_at(
        &self,
        times: &[f64],
        quantities: &[Quantity],
    ) -> Result<Vec<Option<Vec<Derivative<InstantDerivative>>>>, NotDifferentiable> {
        for quantity in quantities {
            self.check_quantity(*quantity)?;
        }
        let is_within =
            |time: f64| time.is_finite() && time >= self.start.time && time <= self.end_time();
        let mut found: Vec<_> = times
            .iter()
            .map(|time| is_within(*time).then(Vec::new))
            .collect();
        let mut order: Vec<usize> = (0..times.len())
            .filter(|place| found[*place].is_some())
            .collect();
        order.sort_by(|one, other| times[*one].total_cmp(&times[*other]));
        let sorted: Vec<f64> = order.iter().map(|place| times[*place]).collect();
        for group in self.groups(quantities) {
            let mut walk = Tangents::new(self, group);
            for (place, at) in order.iter().zip(walk.instants(&sorted)) {
                let states =
                    walk.by_quantity(at, |InstantOfPhase { at, gap }, k| InstantDerivative {
                        state: State {
                            time: 0.0,
                            ..walk.state(&at, k)
                        },
                        gap: gap.parts[k],
                    });
                found[*place]
                    .iter_mut()
                    .for_each(|found| found.extend(&states));
            }
        }
        Ok(found)
    }

    /// Groups of quantities that share the series of the state. Rolling resistance that is zero is on
    /// its own: what is differentiated by it has the equations with resistance.
    fn groups<'a>(&self, quantities: &'a [Quantity]) -> impl Iterator<Item = &'a [Quantity]> {
        let begins = self.hoop.rolling_resistance() == 0.0;
        let is_alone = move |it: &Quantity| begins && *it == Quantity::RollingResistance;
        quantities
            .chunk_by(move |one, other| !is_alone(one) && !is_alone(other))
            .flat_map(|group| group.chunks(WIDTH))
    }

    fn check_quantity(&self, quantity: Quantity) -> Result<(), NotDifferentiable> {
        let bounces = self.hoop.restitution().is_some();
        if differentiable(bounces).any(|known| known == quantity) {
            Ok(())
        } else {
            Err(NotDifferentiable { quantity })
        }
    }

    /// Adds the derivatives with respect to a group of quantities, which share the series of the
    /// state.
    fn add_derivatives(&self, group: &[Quantity], all: &mut Derivatives) {
        let mut walk = Tangents::new(self, group);
        let mut failed = None;
        let mut passed = vec![None; self.transitions.len()];
        for phase in &self.phases {
            match walk.pass_phase(phase) {
                Ok(event) => {
                    if let (Some(number), Some(event)) = (phase.ended_by, event) {
                        passed[number] = Some(event);
                    }
                }
                Err(reason) => {
                    failed = Some(reason);
                    break;
                }
            }
        }
        for (row, event) in all.transitions.iter_mut().zip(&passed) {
            let event = event.ok_or(failed.unwrap_or(NoDerivative::Singular));
            row.extend(walk.by_quantity(event, |event, k| EventDerivative {
                before: walk.state(&event.before, k),
                after: walk.state(&event.after, k),
            }));
        }
        let end = match failed {
            Some(reason) => Err(reason),
            None => walk.outcome(&passed),
        };
        let numbers = PassedMotion {
            walk: &walk,
            events: &passed,
            end: end.map(|(at, _)| at),
        }
        .numbers();
        let rows = all.summary.iter_mut().zip(SummaryColumn::reals());
        for ((row, column), number) in rows.zip(numbers) {
            let parts = walk.by_quantity(number, |number, k| number.parts[k]);
            row.extend(if is_of_end(column) {
                walk.at_end(parts)
            } else {
                parts
            });
        }
        let outcome = walk.by_quantity(end, |(at, recurrence), k| OutcomeDerivative {
            state: walk.state(&at, k),
            recurrence: recurrence.map(|it| it.map(|number| number.parts[k])),
        });
        all.outcome.extend(walk.at_end(outcome));
    }
}
