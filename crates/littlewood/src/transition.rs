//! Changes of the mode of motion.

use crate::automaton::Cause;
use crate::mode::{Direction, Mode};
use crate::state::State;

/// The impulse of the plane on the body at a transition, over m2 √(gR).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Impulse {
    /// Upwards.
    pub normal: f64,
    /// Along E1.
    pub friction: f64,
}

/// A change of the mode of motion, or the event that ends the simulation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Transition {
    /// State just before.
    pub before: State,
    /// State just after: the same, unless there is an impulse.
    pub after: State,
    /// The impulse, if the velocities jump.
    pub impulse: Option<Impulse>,
    /// Mode that ends.
    pub from: Mode,
    /// Mode that begins; none where the motion is not followed further.
    pub to: Option<Mode>,
    /// Direction of slip of the motion that begins.
    pub direction: Option<Direction>,
    /// Event.
    pub cause: Cause,
}

impl Transition {
    /// A transition through which the state is continuous.
    pub(crate) const fn continuous(
        state: State,
        from: Mode,
        to: Option<Mode>,
        direction: Option<Direction>,
        cause: Cause,
    ) -> Self {
        Self { before: state, after: state, impulse: None, from, to, direction, cause }
    }

    /// Time.
    #[must_use]
    pub const fn time(&self) -> f64 {
        self.before.time
    }
}
