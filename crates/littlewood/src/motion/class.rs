//! The coarser division of outcomes that maps show.

use crate::model::named;
use crate::motion::summary::Summary;
use crate::walk::OutcomeKind;

named! {
    /// Class of outcomes that maps show: coarser than the outcome, but with jumps divided by when they begin.
    pub enum Class, "class of outcomes",
    /// In words, for legends.
    pub label: &'static str {
        /// In flight from the start.
        LeavesAtOnce = 0, "leaves_at_once" => "leaves at once";
        /// Lifts off after some time in contact. A motion in flight at the time limit counts as lifted off.
        LiftsOffLater = 1, "lifts_off_later" => "lifts off later";
        /// Rolls for ever, which is proved.
        RollsForever = 2, "rolls_forever" => "rolls for ever";
        /// Slides, or rolls and slides, in the same way again and again, without kinetic friction or without mass, which is proved.
        RepeatsForever = 3, "repeats_forever" => "repeats for ever";
        /// Rolls and slips for ever, with μs = μk, which is proved.
        SlipsForever = 4, "slips_forever" => "slips for ever";
        /// In contact, as far as it was followed: to a limit of time, of transitions or of steps, or until its energy proved that it
        /// never lifts off.
        InContact = 5, "in_contact" => "in contact";
        /// The particle has reached the plane.
        ParticleAtPlane = 6, "particle_at_plane" => "particle at the plane";
        /// The particle has reached its lowest place inside a massless rim.
        ParticleAtBottom = 7, "particle_at_bottom" => "particle at the bottom";
        /// The particle has reached the top with velocity to spare.
        ParticleAtTop = 8, "particle_at_top" => "particle at the top";
        /// A Painlevé paradox: no motion, several motions, or a slide that runs into a singularity.
        Painleve = 9, "painleve" => "Painlevé paradox";
        /// Faster than the clock resolves.
        Unresolved = 10, "unresolved" => "unresolved";
        /// Parameters that contradict each other.
        Invalid = 11, "invalid" => "invalid parameters";
        /// Not computed.
        NotComputed = 12, "not_computed" => "not computed";
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
        Self::of_end(summary.outcome)
    }

    /// The class of an end, whenever the body has lifted off before it.
    #[must_use]
    pub const fn of_end(outcome: OutcomeKind) -> Self {
        match outcome {
            OutcomeKind::Landing => Self::LiftsOffLater,
            OutcomeKind::RollsForever => Self::RollsForever,
            OutcomeKind::SlidesForever | OutcomeKind::RepeatsForever => Self::RepeatsForever,
            OutcomeKind::SlipsForever => Self::SlipsForever,
            OutcomeKind::TimeLimit
            | OutcomeKind::TransitionLimit
            | OutcomeKind::StepLimit
            | OutcomeKind::StaysInContact => Self::InContact,
            OutcomeKind::ParticleAtPlane => Self::ParticleAtPlane,
            OutcomeKind::ParticleAtBottom => Self::ParticleAtBottom,
            OutcomeKind::ParticleAtTop => Self::ParticleAtTop,
            OutcomeKind::Inconsistent | OutcomeKind::Ambiguous | OutcomeKind::Singular => Self::Painleve,
            OutcomeKind::Unresolved => Self::Unresolved,
            OutcomeKind::NotComputed => Self::NotComputed,
            OutcomeKind::Invalid => Self::Invalid,
        }
    }

    /// Whether the body stays in contact, as far as it was followed.
    #[must_use]
    pub const fn stays_in_contact(self) -> bool {
        matches!(self, Self::RollsForever | Self::RepeatsForever | Self::SlipsForever | Self::InContact)
    }
}
