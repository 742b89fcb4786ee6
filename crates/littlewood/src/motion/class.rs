//! The classes of outcomes that maps show.

use crate::model::named;
use crate::motion::summary::Summary;
use crate::walk::OutcomeKind;

named! {
    /// A class of outcomes for maps: coarser than the outcome, but with early and late lift-offs
    /// distinguished.
    pub enum Class, "class of outcomes",
    /// Label for legends.
    pub label: &'static str {
        /// In flight from the start.
        LeavesAtOnce = 0, "leaves_at_once" => "leaves at once";
        /// Lifts off after some time in contact. A motion in flight at the time limit counts as
        /// lifted off.
        LiftsOffLater = 1, "lifts_off_later" => "lifts off later";
        /// Rolls for ever (proved).
        RollsForever = 2, "rolls_forever" => "rolls for ever";
        /// Repeats a cycle of slides, or of rolls and slides, without kinetic friction or mass
        /// (proved).
        RepeatsForever = 3, "repeats_forever" => "repeats for ever";
        /// Rolls and slips for ever with μs = μk (proved).
        SlipsForever = 4, "slips_forever" => "slips for ever";
        /// In contact up to a limit of time, transitions or steps, or until its energy proves that
        /// it never lifts off.
        InContact = 5, "in_contact" => "in contact";
        /// The particle reaches the plane.
        ParticleAtPlane = 6, "particle_at_plane" => "particle at the plane";
        /// The particle reaches its lowest point inside a massless rim.
        ParticleAtBottom = 7, "particle_at_bottom" => "particle at the bottom";
        /// The particle reaches the top with upward velocity left.
        ParticleAtTop = 8, "particle_at_top" => "particle at the top";
        /// A Painlevé paradox: no consistent motion, several, or a slide that reaches P = 0.
        Painleve = 9, "painleve" => "Painlevé paradox";
        /// The time scale falls below double precision.
        Unresolved = 10, "unresolved" => "unresolved";
        /// Contradictory parameters.
        Invalid = 11, "invalid" => "invalid parameters";
        /// Not computed.
        NotComputed = 12, "not_computed" => "not computed";
        /// Rolling resistance stops it in contact.
        Rests = 13, "rests" => "rests";
    }
}

impl Class {
    /// The class of a motion.
    #[must_use]
    pub fn of(summary: &Summary) -> Self {
        if summary
            .sequence
            .first()
            .is_some_and(|(mode, _)| !mode.touches_plane())
        {
            return Self::LeavesAtOnce;
        }
        if !summary.lift_off_time.is_nan() {
            return Self::LiftsOffLater;
        }
        Self::of_end(summary.outcome)
    }

    /// The class of an outcome, without regard to an earlier lift-off.
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
            OutcomeKind::Inconsistent | OutcomeKind::Ambiguous | OutcomeKind::Singular => {
                Self::Painleve
            }
            OutcomeKind::Rests => Self::Rests,
            OutcomeKind::Unresolved => Self::Unresolved,
            OutcomeKind::NotComputed => Self::NotComputed,
            OutcomeKind::Invalid => Self::Invalid,
        }
    }

    /// Whether the body stays in contact up to the end of the simulation.
    pub const fn stays_in_contact(self) -> bool {
        matches!(
            self,
            Self::RollsForever
                | Self::RepeatsForever
                | Self::SlipsForever
                | Self::InContact
                | Self::Rests
        )
    }
}
