//! Small changes of a problem, and by how much they move an event.

use littlewood::derivatives::{Derivative, differentiable};
use littlewood::tables::Quantity;
use littlewood::{State, Trajectory};

use crate::problem::Problem;

/// By how much the columns of [`State::COLUMNS`] change.
pub(crate) type Change = [f64; State::COLUMNS.len()];

/// The derivatives of a transition, and of the state after it, with respect to all quantities of
/// hoop, plane and start.
#[derive(Clone, Debug)]
pub(crate) struct Partials(Vec<(Quantity, Derivative<Change>)>);

impl Partials {
    /// Those of a transition of the motion of a problem, with the motion up to there; none if there
    /// is no such transition.
    pub(crate) fn of(problem: &Problem, transition: usize) -> Option<(Trajectory, Self)> {
        // What comes after it need not be differentiated.
        let until_then = problem.limits.with_transitions(transition + 1);
        let motion = problem.hoop.simulate(problem.start, until_then).ok()?;
        let bounces = problem.hoop.restitution().is_some();
        let quantities: Vec<Quantity> = differentiable(bounces).collect();
        let derivatives = motion.derivatives(&quantities).ok()?;
        let each = derivatives.transitions().get(transition)?.iter();
        let each = each.map(|derivative| derivative.map(|event| event.after.numbers()));
        let partials = Self(quantities.into_iter().zip(each).collect());
        Some((motion, partials))
    }

    /// By how much changes of quantities move the transition and the state after it, to first
    /// order. What does not change needs no derivative.
    pub(crate) fn move_of(&self, change: impl Fn(Quantity) -> f64) -> Derivative<Change> {
        let mut sum = [0.0; State::COLUMNS.len()];
        for (quantity, derivative) in &self.0 {
            let change = change(*quantity);
            if change != 0.0 {
                for (sum, slope) in sum.iter_mut().zip((*derivative)?) {
                    *sum += slope * change;
                }
            }
        }
        Ok(sum)
    }
}
