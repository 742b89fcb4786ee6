//! Links of a chain of slips, for solvers that pass them whole: what a motion has room for, and what has been passed.

use crate::mode::{Direction, Mode};
use crate::state::State;

/// What a motion has room for before something else may end it.
pub(crate) struct Room<'a> {
    /// Most transitions.
    pub(crate) transitions: u32,
    /// Whether its phases are told: one link at a time.
    pub(crate) one_link: bool,
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
    pub(crate) phases: LinkPhases,
}

/// The phases of one link; none of several links.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct LinkPhases([Option<(Mode, Option<Direction>)>; LinkPhases::MOST]);

impl LinkPhases {
    /// Links of more phases are followed phase by phase.
    pub(crate) const MOST: usize = 12;

    /// Adds a phase; whether there was room.
    pub(crate) fn push(&mut self, mode: Mode, direction: Option<Direction>) -> bool {
        let free = self.0.iter_mut().find(|phase| phase.is_none());
        free.map(|free| *free = Some((mode, direction))).is_some()
    }

    /// The phases in order.
    pub(crate) fn iter(&self) -> impl Iterator<Item = (Mode, Option<Direction>)> {
        self.0.into_iter().flatten()
    }

    /// The same phases in a frame that is mirrored for −1.
    pub(crate) fn mirrored(self, sign: f64) -> Self {
        let seen = |direction: Direction| if sign < 0.0 { direction.reversed() } else { direction };
        Self(self.0.map(|phase| phase.map(|(mode, direction)| (mode, direction.map(seen)))))
    }
}
