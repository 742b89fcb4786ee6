//! Events of a motion.

use crate::model::mode::Mode;
use crate::model::state::State;
use crate::walk::automaton::Cause;

/// An event between two phases, or at the end of the last.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Event {
    /// State just before.
    pub(crate) state: State,
    pub(crate) from: Option<Mode>,
    pub(crate) to: Option<Mode>,
    pub(crate) cause: Cause,
}

impl Event {
    /// An event that ends a mode.
    pub(crate) const fn new(state: State, from: Mode, cause: Cause) -> Self {
        Self { state, from: Some(from), to: None, cause }
    }
}
