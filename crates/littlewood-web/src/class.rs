//! What a map shows of a motion.

use littlewood::{OutcomeCode, Summary};
use wasm_bindgen::prelude::wasm_bindgen;

/// A coarser division than the outcome, which tells the jumps apart by when they begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum Class {
    /// Not computed yet.
    Unknown,
    /// In flight from the start.
    LeavesAtOnce,
    /// Lifts off after some time in contact.
    LiftsOffLater,
    /// Rolls for ever, which is proved.
    RollsForever,
    /// Slides for ever, without kinetic friction, which is proved.
    SlidesForever,
    /// Still in contact when the limit of transitions stopped it.
    InContactAtLimit,
    /// The particle has reached the plane, or its lowest place inside a massless rim.
    ParticleDown,
    /// The particle has reached the top with velocity to spare.
    ParticleAtTop,
    /// A Painlevé paradox: no motion, several, or a slide that runs into a singularity.
    Painleve,
    /// Faster than the clock resolves.
    Unresolved,
}

impl Class {
    /// All classes, in the order of their numbers.
    pub const ALL: [Self; 10] = [
        Self::Unknown,
        Self::LeavesAtOnce,
        Self::LiftsOffLater,
        Self::RollsForever,
        Self::SlidesForever,
        Self::InContactAtLimit,
        Self::ParticleDown,
        Self::ParticleAtTop,
        Self::Painleve,
        Self::Unresolved,
    ];

    /// Of a motion.
    #[must_use]
    pub fn of(motion: &Summary) -> Self {
        const FLIGHT: u64 = 7;
        if motion.sequence.bits() & 7 == FLIGHT {
            return Self::LeavesAtOnce;
        }
        if !motion.lift_off_time.is_nan() {
            return Self::LiftsOffLater;
        }
        match motion.outcome {
            OutcomeCode::RollsForever => Self::RollsForever,
            OutcomeCode::SlidesForever => Self::SlidesForever,
            OutcomeCode::TimeLimit | OutcomeCode::TransitionLimit => Self::InContactAtLimit,
            OutcomeCode::ParticleAtPlane | OutcomeCode::ParticleAtBottom => Self::ParticleDown,
            OutcomeCode::ParticleAtTop => Self::ParticleAtTop,
            OutcomeCode::Inconsistent | OutcomeCode::Ambiguous | OutcomeCode::Singular => Self::Painleve,
            _ => Self::Unresolved,
        }
    }

    /// Name, for style sheets and tests.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Unknown => "unknown",
            Self::LeavesAtOnce => "leaves-at-once",
            Self::LiftsOffLater => "lifts-off-later",
            Self::RollsForever => "rolls-forever",
            Self::SlidesForever => "slides-forever",
            Self::InContactAtLimit => "in-contact-at-limit",
            Self::ParticleDown => "particle-down",
            Self::ParticleAtTop => "particle-at-top",
            Self::Painleve => "painleve",
            Self::Unresolved => "unresolved",
        }
    }
}

/// Names of the classes, in the order of their numbers.
#[wasm_bindgen(js_name = classNames)]
#[must_use]
pub fn class_names() -> Vec<String> {
    Class::ALL.iter().map(|class| class.name().to_owned()).collect()
}
