//! The coarser division of outcomes that maps show.

use crate::named::named;
use crate::outcome::OutcomeKind;
use crate::summary::Summary;

named! {
    /// Class of outcomes that maps show: coarser than the outcome, but with jumps divided by when they begin.
    pub enum Class, "class of outcomes" {
        /// In flight from the start.
        LeavesAtOnce = 0, "leaves_at_once";
        /// Lifts off after some time in contact. A motion in flight at the time limit counts as lifted off.
        LiftsOffLater = 1, "lifts_off_later";
        /// Rolls for ever, which is proved.
        RollsForever = 2, "rolls_forever";
        /// Slides for ever, without kinetic friction, which is proved.
        SlidesForever = 3, "slides_forever";
        /// Still in contact when a limit of time, of transitions or of steps stopped it.
        InContactAtLimit = 4, "in_contact_at_limit";
        /// The particle has reached the plane.
        ParticleAtPlane = 5, "particle_at_plane";
        /// The particle has reached its lowest place inside a massless rim.
        ParticleAtBottom = 6, "particle_at_bottom";
        /// The particle has reached the top with velocity to spare.
        ParticleAtTop = 7, "particle_at_top";
        /// A Painlevé paradox: no motion, several motions, or a slide that runs into a singularity.
        Painleve = 8, "painleve";
        /// Faster than the clock resolves.
        Unresolved = 9, "unresolved";
        /// Parameters that contradict each other.
        Invalid = 10, "invalid";
        /// Not computed.
        NotComputed = 11, "not_computed";
    }
}

impl Class {
    /// The class of a motion.
    #[must_use]
    pub fn of(summary: &Summary) -> Self {
        if summary.sequence.first().is_some_and(|(mode, _)| !mode.touches_plane()) {
            return Self::LeavesAtOnce;
        }
        if !summary.lift_off_time.is_nan() {
            return Self::LiftsOffLater;
        }
        match summary.outcome {
            OutcomeKind::Landing => Self::LiftsOffLater,
            OutcomeKind::RollsForever => Self::RollsForever,
            OutcomeKind::SlidesForever => Self::SlidesForever,
            OutcomeKind::TimeLimit | OutcomeKind::TransitionLimit | OutcomeKind::StepLimit => {
                Self::InContactAtLimit
            }
            OutcomeKind::ParticleAtPlane => Self::ParticleAtPlane,
            OutcomeKind::ParticleAtBottom => Self::ParticleAtBottom,
            OutcomeKind::ParticleAtTop => Self::ParticleAtTop,
            OutcomeKind::Inconsistent | OutcomeKind::Ambiguous | OutcomeKind::Singular => Self::Painleve,
            OutcomeKind::Unresolved => Self::Unresolved,
            OutcomeKind::NotComputed => Self::NotComputed,
            OutcomeKind::Invalid => Self::Invalid,
        }
    }

    /// In words, for legends.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Self::LeavesAtOnce => "leaves at once",
            Self::LiftsOffLater => "lifts off later",
            Self::RollsForever => "rolls for ever",
            Self::SlidesForever => "slides for ever",
            Self::InContactAtLimit => "in contact at the limit",
            Self::ParticleAtPlane => "particle at the plane",
            Self::ParticleAtBottom => "particle at the bottom",
            Self::ParticleAtTop => "particle at the top",
            Self::Painleve => "Painlevé paradox",
            Self::Unresolved => "unresolved",
            Self::Invalid => "invalid parameters",
            Self::NotComputed => "not computed",
        }
    }

    /// Whether the body stays in contact, as far as it was followed.
    #[must_use]
    pub const fn stays_in_contact(self) -> bool {
        matches!(self, Self::RollsForever | Self::SlidesForever | Self::InContactAtLimit)
    }
}
