//! What becomes of a motion, as figures of many motions show it.

use littlewood::tables::{Class, PhaseCode};
use littlewood::{Hoop, OutcomeKind, Summary};
use littlewood_style::ticks::minus;

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

/// What the letters of some kinds of phases mean.
pub(crate) fn meanings(is_named: impl Fn(&PhaseCode) -> bool) -> String {
    let codes = PhaseCode::ALL.into_iter().filter(is_named);
    codes
        .map(|code| format!("{} {}", minus(code.name()), code.meaning()))
        .collect::<Vec<_>>()
        .join(", ")
}

/// What becomes of the motions of a band.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Fate {
    pub(crate) class: Class,
    /// Whether more phases follow the last one of the sequence.
    pub(crate) goes_on: bool,
    /// Why there is no phase.
    pub(crate) no_phase: Option<OutcomeKind>,
}

impl Fate {
    pub(crate) fn new(fates: Fates, summary: &Summary) -> Self {
        let class = fates.class(summary);
        Self {
            class,
            goes_on: class.stays_in_contact() && !summary.outcome.is_forever(),
            no_phase: summary.sequence.is_empty().then_some(summary.outcome),
        }
    }

    /// As a number.
    pub(crate) fn kind(self) -> u16 {
        let outcome = self
            .no_phase
            .map_or(0, |outcome| 1 + u16::from(outcome.code()));
        u16::from(self.class.code()) | u16::from(self.goes_on) << 5 | outcome << 6
    }

    /// From its number.
    pub(crate) fn of(kind: u16) -> Self {
        let class = |class: &Class| u16::from(class.code()) == kind & CLASSES;
        let outcome = |outcome: &OutcomeKind| 1 + u16::from(outcome.code()) == kind >> 6;
        Self {
            class: Class::ALL
                .into_iter()
                .find(class)
                .unwrap_or(Class::NotComputed),
            goes_on: kind >> 5 & 1 == 1,
            no_phase: OutcomeKind::ALL.into_iter().find(outcome),
        }
    }
}

/// Bits of a class.
const CLASSES: u16 = 0x1f;

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_fate_comes_back_from_its_number() {
        for class in Class::ALL {
            for goes_on in [false, true] {
                for no_phase in OutcomeKind::ALL.into_iter().map(Some).chain([None]) {
                    let fate = Fate {
                        class,
                        goes_on,
                        no_phase,
                    };
                    assert_eq!(Fate::of(fate.kind()), fate);
                }
            }
        }
    }
}
