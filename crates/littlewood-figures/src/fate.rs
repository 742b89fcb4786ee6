//! What becomes of a motion, as figures of many motions show it.

use littlewood::tables::Class;
use littlewood::{Hoop, Summary};

/// Which end of its motions a figure of a hoop shows: the first lift-off ends all where no landing
/// can be followed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Fates {
    /// Whether motions go on after a landing, so that a lift-off decides nothing.
    pub(crate) go_on: bool,
}

impl Fates {
    pub(crate) const fn of(hoop: &Hoop) -> Self {
        Self {
            go_on: hoop.restitution().is_some(),
        }
    }

    /// The class of a motion: of its end, if it goes on after a landing.
    pub(crate) fn class(self, summary: &Summary) -> Class {
        if self.go_on {
            Class::of_end(summary.outcome)
        } else {
            Class::of(summary)
        }
    }

    /// A class in words.
    pub(crate) const fn label(self, class: Class) -> &'static str {
        match class {
            // It may be in flight.
            Class::InContact if self.go_on => "goes on",
            _ => class.label(),
        }
    }
}
