//! The outcome of a point: as a number in arrays, as a class in pictures.

use littlewood::OutcomeCode;

use crate::columns::Row;

/// Code of a point that has not been computed: what a partial grid holds where chunks are missing.
pub const NOT_COMPUTED: u8 = 254;

/// Code of a point whose hoop has no physical meaning because of a combination of two axes, such as μk > μs.
pub const INVALID: u8 = 255;

/// Name of a code in arrays: that of [`OutcomeCode::name`], `not_computed` or `invalid`; none for other numbers.
#[must_use]
pub fn name(code: u8) -> Option<&'static str> {
    match code {
        NOT_COMPUTED => Some("not_computed"),
        INVALID => Some("invalid"),
        _ => OutcomeCode::ALL.into_iter().find(|known| *known as u8 == code).map(OutcomeCode::name),
    }
}

/// All codes with their names, in order.
pub fn codes() -> impl Iterator<Item = (u8, &'static str)> {
    OutcomeCode::ALL
        .into_iter()
        .map(|code| (code as u8, code.name()))
        .chain([(NOT_COMPUTED, "not_computed"), (INVALID, "invalid")])
}

/// What a map shows of a motion: a coarser division than the outcome, which tells the jumps apart by when they begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
pub enum Class {
    /// In flight from the start.
    LeavesAtOnce,
    /// Lifts off after some time in contact.
    LiftsOffLater,
    /// Rolls for ever, which is proved.
    RollsForever,
    /// Slides for ever, without kinetic friction, which is proved.
    SlidesForever,
    /// Still in contact when a limit of time or of transitions stopped it.
    InContactAtLimit,
    /// The particle has reached the plane.
    ParticleAtPlane,
    /// The particle has reached its lowest place inside a massless rim.
    ParticleAtBottom,
    /// The particle has reached the top with velocity to spare.
    ParticleAtTop,
    /// A Painlevé paradox: no motion, several motions, or a slide that runs into a singularity.
    Painleve,
    /// Faster than the clock resolves.
    Unresolved,
    /// Parameters without physical meaning.
    Invalid,
    /// Not computed.
    NotComputed,
}

impl Class {
    /// All classes, in the order of legends.
    pub const ALL: [Self; 12] = [
        Self::LeavesAtOnce,
        Self::LiftsOffLater,
        Self::RollsForever,
        Self::SlidesForever,
        Self::InContactAtLimit,
        Self::ParticleAtPlane,
        Self::ParticleAtBottom,
        Self::ParticleAtTop,
        Self::Painleve,
        Self::Unresolved,
        Self::Invalid,
        Self::NotComputed,
    ];

    /// The class of a computed point. Whoever is in flight at the end of the time has lifted off all the same.
    #[must_use]
    pub fn of(row: &Row) -> Self {
        let starts_in_flight = row.sequence.bits() & 7 == 7;
        if starts_in_flight {
            return Self::LeavesAtOnce;
        }
        if !row.lift_off_time.is_nan() {
            return Self::LiftsOffLater;
        }
        const fn is(code: u8, outcome: OutcomeCode) -> bool {
            code == outcome as u8
        }
        match row.outcome {
            INVALID => Self::Invalid,
            code if is(code, OutcomeCode::RollsForever) => Self::RollsForever,
            code if is(code, OutcomeCode::SlidesForever) => Self::SlidesForever,
            code if is(code, OutcomeCode::TimeLimit) || is(code, OutcomeCode::TransitionLimit) => {
                Self::InContactAtLimit
            }
            code if is(code, OutcomeCode::ParticleAtPlane) => Self::ParticleAtPlane,
            code if is(code, OutcomeCode::ParticleAtBottom) => Self::ParticleAtBottom,
            code if is(code, OutcomeCode::ParticleAtTop) => Self::ParticleAtTop,
            code if is(code, OutcomeCode::Inconsistent)
                || is(code, OutcomeCode::Ambiguous)
                || is(code, OutcomeCode::Singular) =>
            {
                Self::Painleve
            }
            code if is(code, OutcomeCode::Unresolved) => Self::Unresolved,
            _ => Self::NotComputed,
        }
    }

    /// Lower-case name, as files and programs write it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::LeavesAtOnce => "leaves_at_once",
            Self::LiftsOffLater => "lifts_off_later",
            Self::RollsForever => "rolls_forever",
            Self::SlidesForever => "slides_forever",
            Self::InContactAtLimit => "in_contact_at_limit",
            Self::ParticleAtPlane => "particle_at_plane",
            Self::ParticleAtBottom => "particle_at_bottom",
            Self::ParticleAtTop => "particle_at_top",
            Self::Painleve => "painleve",
            Self::Unresolved => "unresolved",
            Self::Invalid => "invalid",
            Self::NotComputed => "not_computed",
        }
    }

    /// The class of this name.
    #[must_use]
    pub fn find(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|class| class.name() == name)
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
            Self::Invalid => "not a hoop",
            Self::NotComputed => "not computed",
        }
    }

    /// Whether the body stays in contact, as far as it was followed.
    #[must_use]
    pub const fn stays_in_contact(self) -> bool {
        matches!(self, Self::RollsForever | Self::SlidesForever | Self::InContactAtLimit)
    }
}
