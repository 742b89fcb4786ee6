//! Changes of the mode of motion.

use crate::mechanics::impact::Impact;
use crate::model::mode::{Direction, Mode};
use crate::model::state::State;
use crate::walk::automaton::Cause;

/// A change of the mode of motion, or the event that ends the simulation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Transition {
    /// State just before.
    pub before: State,
    /// State just after: the same, unless there is an impact.
    pub after: State,
    /// The impact, if the velocities jump. Where bounces have settled it is all of theirs together.
    pub impact: Option<Impact>,
    /// Mode that ends; none where a hoop jams from a state at which no motion was consistent.
    pub from: Option<Mode>,
    /// Mode that begins; none where the motion is not followed further.
    pub to: Option<Mode>,
    /// Direction of slip of the motion that begins.
    pub direction: Option<Direction>,
    /// Event.
    pub cause: Cause,
}

impl Transition {
    /// Time.
    #[must_use]
    pub const fn time(&self) -> f64 {
        self.before.time
    }
}
