//! Links of a chain of slips, for solvers that pass them whole: what a motion has room for, and what has been passed.

use crate::model::mode::Direction;
use crate::model::state::State;
use crate::walk::sequence::PhaseSequence;

/// What a motion has room for before something else may end it.
pub(crate) struct Room<'a> {
    /// Most transitions.
    pub(crate) transitions: u32,
    /// Largest length of slides.
    pub(crate) slides: f64,
    /// Whether its phases are told: no more of them than a sequence holds.
    pub(crate) are_told: bool,
    /// Whether nothing that would end the motion is known in a state, where that is asked at each event; what is known in a state is known
    /// in all that follow.
    pub(crate) open: Option<&'a dyn Fn(&State) -> bool>,
}

/// Links from a slip out of rolling to a later one.
pub(crate) struct Linked<P> {
    pub(crate) place: P,
    /// Of the slip there.
    pub(crate) direction: Direction,
    pub(crate) transitions: u32,
    /// Length of the slides.
    pub(crate) slid: f64,
    /// If they are told.
    pub(crate) phases: PhaseSequence,
}
