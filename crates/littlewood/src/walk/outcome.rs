//! The outcome of a motion: as a number for arrays ([`OutcomeKind`]), and with its data
//! ([`Outcome`]).

use crate::model::{Detail, Dimension, State, getters, named};
use crate::modes::{GrazingOrbit, Recurrence, SlideLimit, Undecided};
use crate::walk::{Candidates, Cause};

named! {
    /// The kind of an outcome, as a number. The last two mark points of an array without a motion.
    pub enum OutcomeKind, "outcome",
    /// Label; whether the outcome is final, and not a limit; the event with which the motion ends.
    row: (&'static str, bool, Option<Cause>) {
        /// [`Outcome::Landing`].
        Landing = 0, "landing" => ("lands", true, Some(Cause::Landing));
        /// [`Outcome::RollsForever`].
        RollsForever = 1, "rolls_forever" => ("rolls for ever", true, None);
        /// [`Outcome::SlidesForever`].
        SlidesForever = 2, "slides_forever" => ("slides for ever", true, None);
        /// [`Outcome::ParticleAtPlane`].
        ParticleAtPlane = 3, "particle_at_plane" => ("particle at the plane", true, Some(Cause::ParticleAtPlane));
        /// [`Outcome::ParticleAtBottom`].
        ParticleAtBottom = 4, "particle_at_bottom" => ("particle at the bottom", true, Some(Cause::ParticleAtBottom));
        /// [`Outcome::ParticleAtTop`].
        ParticleAtTop = 5, "particle_at_top" => ("particle at the top", true, Some(Cause::ParticleAtTop));
        /// [`Outcome::TimeLimit`].
        TimeLimit = 6, "time_limit" => ("time limit", false, None);
        /// [`Outcome::TransitionLimit`].
        TransitionLimit = 7, "transition_limit" => ("transition limit", false, None);
        /// [`Outcome::Inconsistent`].
        Inconsistent = 8, "inconsistent" => ("no motion is consistent", true, None);
        /// [`Outcome::Ambiguous`].
        Ambiguous = 9, "ambiguous" => ("several motions are consistent", true, None);
        /// [`Outcome::Singular`].
        Singular = 10, "singular" => ("sliding is not solvable", true, Some(Cause::Singularity));
        /// [`Outcome::Unresolved`].
        Unresolved = 11, "unresolved" => ("unresolved", false, None);
        /// [`Outcome::StepLimit`].
        StepLimit = 12, "step_limit" => ("step limit", false, None);
        /// [`Outcome::SlipsForever`].
        SlipsForever = 13, "slips_forever" => ("slips for ever", true, None);
        /// [`Outcome::RepeatsForever`].
        RepeatsForever = 14, "repeats_forever" => ("repeats for ever", true, None);
        /// [`Outcome::StaysInContact`].
        StaysInContact = 15, "stays_in_contact" => ("stays in contact", true, None);
        /// [`Outcome::Rests`].
        Rests = 16, "rests" => ("rests", true, None);
        /// A point that has not been computed, as in the missing chunks of a partial grid.
        NotComputed = 254, "not_computed" => ("not computed", false, None);
        /// A point with contradictory parameters, such as μk > μs.
        Invalid = 255, "invalid" => ("invalid parameters", false, None);
    }
}

getters! {
    OutcomeKind, self:
    /// Label for tables and figures.
    pub label: &'static str = self.row().0;
    /// Whether the outcome is final, and not a limit.
    pub is_final: bool = self.row().1;
    /// The event with which the motion ends, its last transition; none if it ends without an event.
    pub last_event: Option<Cause> = self.row().2;
    /// Whether the last phase has no end.
    pub is_forever: bool = matches!(self, Self::RollsForever | Self::SlidesForever | Self::Rests);
    /// Whether the motion ended at P ≤ 0 (Painlevé): no consistent motion, several, or a slide that
    /// reaches P = 0.
    pub is_painleve: bool = matches!(self, Self::Inconsistent | Self::Ambiguous | Self::Singular);
}

/// The outcome of a simulation.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[expect(missing_docs, reason = "the text of each says what its fields are")]
pub enum Outcome {
    /// The body lands after a flight; the state is just before the impact, and the rate of the gap,
    /// which closes, negative.
    Landing { state: State, gap_rate: f64 },
    /// Static friction holds on the whole orbit ahead, from `since`, the start of the last phase.
    RollsForever {
        since: State,
        recurrence: Recurrence,
    },
    /// Without kinetic friction energy and horizontal momentum are conserved, and a whole period
    /// passed without an event since the start of the last phase. The recurrence is that of θ and
    /// θ′.
    SlidesForever {
        since: State,
        recurrence: Recurrence,
    },
    /// With μs = μk the motion rolls and slips for ever and converges to the grazing orbit: E − E*
    /// decreases like 1/n with the number n of slips, and halves in 1/(c (E − E*)) of them.
    /// Declared at the end of a slip whose energy loss proves it.
    SlipsForever {
        state: State,
        orbit: GrazingOrbit,
        slips_to_halve: f64,
    },
    /// Without kinetic friction, or for a massless hoop, energy is conserved in contact. The motion
    /// returned to an earlier event, so it repeats. `since` is the state at the first of the two; θ
    /// gains a multiple of 2π in a period.
    RepeatsForever {
        since: State,
        period: f64,
        theta_gained: f64,
        transitions: usize,
    },
    /// Energy and momentum exclude any later lift-off ([`crate::Hoop::never_lifts_off`]). The
    /// simulation stopped here, either on request or at a limit.
    StaysInContact { state: State },
    /// Rolling resistance holds the hoop at rest for ever, from `since`, the start of the last
    /// phase. A half swing is rolling between two turning points; they are counted over the motion.
    Rests { since: State, half_swings: usize },
    /// The particle on the rim of a massless hoop reaches the plane, θ = ±π, at an infinite rate.
    /// No impact law applies, since the rim has no inertia.
    ParticleAtPlane { state: State },
    /// The particle inside the rim of a massless hoop reaches its lowest point, θ = ±π, at an
    /// infinite rate.
    ParticleAtBottom { state: State },
    /// The particle of a massless hoop reaches its highest point with upward velocity left, at an
    /// infinite rate.
    ParticleAtTop { state: State },
    /// The time limit was reached.
    TimeLimit { state: State },
    /// The largest number of transitions was reached.
    TransitionLimit { state: State, transitions: usize },
    /// No motion is consistent with the laws of friction and contact.
    Inconsistent {
        state: State,
        candidates: Candidates,
    },
    /// Several motions are consistent.
    Ambiguous {
        state: State,
        candidates: Candidates,
    },
    /// A slide reaches P = 0 with N > 0, beyond which it has no solution (Painlevé). `solvability`
    /// is P there.
    Singular { state: State, solvability: f64 },
    /// The slides exceeded a limit.
    StepLimit { state: State, limit: SlideLimit },
    /// The time scale falls below double precision: a slide of a hoop with very small inertia whose
    /// particle passes the bottom, or a slide next to P = 0 whose end depends on rounding. Or an
    /// impact beyond the bounds of θ and x of a start, with velocities that overflow or a gap rate
    /// that underflows, or where rounding decides between stick and slip. Or an unbalanced hoop
    /// that rolls down a slope beyond these bounds, a flight of more turns than doubles resolve, or
    /// a massless hoop whose particle passes the contact point, but for rounding. It names the number
    /// that decides.
    Unresolved { state: State, undecided: Undecided },
}

impl Outcome {
    /// The kind, with a name, a number and a label.
    pub const fn kind(&self) -> OutcomeKind {
        match self {
            Self::Landing { .. } => OutcomeKind::Landing,
            Self::RollsForever { .. } => OutcomeKind::RollsForever,
            Self::SlidesForever { .. } => OutcomeKind::SlidesForever,
            Self::ParticleAtPlane { .. } => OutcomeKind::ParticleAtPlane,
            Self::ParticleAtBottom { .. } => OutcomeKind::ParticleAtBottom,
            Self::ParticleAtTop { .. } => OutcomeKind::ParticleAtTop,
            Self::TimeLimit { .. } => OutcomeKind::TimeLimit,
            Self::TransitionLimit { .. } => OutcomeKind::TransitionLimit,
            Self::Inconsistent { .. } => OutcomeKind::Inconsistent,
            Self::Ambiguous { .. } => OutcomeKind::Ambiguous,
            Self::Singular { .. } => OutcomeKind::Singular,
            Self::Unresolved { .. } => OutcomeKind::Unresolved,
            Self::StepLimit { .. } => OutcomeKind::StepLimit,
            Self::SlipsForever { .. } => OutcomeKind::SlipsForever,
            Self::RepeatsForever { .. } => OutcomeKind::RepeatsForever,
            Self::StaysInContact { .. } => OutcomeKind::StaysInContact,
            Self::Rests { .. } => OutcomeKind::Rests,
        }
    }

    /// The state at the end, or at the start of an endless phase.
    pub const fn state(&self) -> State {
        let mut copy = *self;
        *copy.state_mut()
    }

    /// Whether the outcome is final, and not a limit.
    pub const fn is_final(&self) -> bool {
        self.kind().is_final()
    }

    /// The recurrence of an endless motion; none for other outcomes.
    pub const fn recurrence(&self) -> Option<Recurrence> {
        if let Self::RollsForever { recurrence, .. } | Self::SlidesForever { recurrence, .. } = self
        {
            Some(*recurrence)
        } else {
            None
        }
    }

    /// The candidates, if no motion or more than one is consistent.
    pub const fn candidates(&self) -> Option<Candidates> {
        if let Self::Inconsistent { candidates, .. } | Self::Ambiguous { candidates, .. } = self {
            Some(*candidates)
        } else {
            None
        }
    }

    pub(crate) const fn state_mut(&mut self) -> &mut State {
        match self {
            Self::RollsForever { since: state, .. }
            | Self::SlidesForever { since: state, .. }
            | Self::RepeatsForever { since: state, .. }
            | Self::Rests { since: state, .. }
            | Self::Inconsistent { state, .. }
            | Self::Ambiguous { state, .. }
            | Self::Landing { state, .. }
            | Self::SlipsForever { state, .. }
            | Self::StaysInContact { state }
            | Self::ParticleAtPlane { state }
            | Self::ParticleAtBottom { state }
            | Self::ParticleAtTop { state }
            | Self::TimeLimit { state }
            | Self::TransitionLimit { state, .. }
            | Self::Singular { state, .. }
            | Self::StepLimit { state, .. }
            | Self::Unresolved { state, .. } => state,
        }
    }

    /// The values besides kind, state and candidates, with their names in records.
    pub fn details(&self) -> Vec<(&'static str, Detail)> {
        match *self {
            Self::Landing { gap_rate, .. } => {
                vec![("gap_rate", Detail::Real(gap_rate, Dimension::Velocity))]
            }
            Self::RollsForever { recurrence, .. } | Self::SlidesForever { recurrence, .. } => {
                recurrence.details()
            }
            Self::SlipsForever {
                orbit,
                slips_to_halve,
                ..
            } => orbit
                .details()
                .into_iter()
                .chain([(
                    "slips_to_halve",
                    Detail::Real(slips_to_halve, Dimension::Ratio),
                )])
                .collect(),
            Self::RepeatsForever {
                period,
                theta_gained,
                transitions,
                ..
            } => vec![
                ("period", Detail::Real(period, Dimension::Time)),
                ("theta_gained", Detail::Real(theta_gained, Dimension::Angle)),
                ("transitions", Detail::Count(transitions)),
            ],
            Self::TransitionLimit { transitions, .. } => {
                vec![("transitions", Detail::Count(transitions))]
            }
            Self::Rests { half_swings, .. } => {
                vec![("half_swings", Detail::Count(half_swings))]
            }
            Self::StepLimit { limit, .. } => match limit {
                SlideLimit::All { slides } => vec![("slides", Detail::Count(slides))],
                SlideLimit::One { steps, time_left } => vec![
                    ("steps", Detail::Count(steps)),
                    ("time_left", Detail::Real(time_left, Dimension::Time)),
                ],
            },
            Self::Unresolved { undecided, .. } => undecided.details().to_vec(),
            Self::Singular { solvability, .. } => {
                vec![("solvability", Detail::Real(solvability, Dimension::Ratio))]
            }
            Self::ParticleAtPlane { .. }
            | Self::ParticleAtBottom { .. }
            | Self::ParticleAtTop { .. }
            | Self::TimeLimit { .. }
            | Self::StaysInContact { .. }
            | Self::Inconsistent { .. }
            | Self::Ambiguous { .. } => Vec::new(),
        }
    }
}
