//! What a sweep keeps of a motion: outcome, sequence of phases, the end, first slip, lift-off and jump.

use core::fmt;

use crate::automaton::Cause;
use crate::state::{Direction, Mode, State};
use crate::trajectory::{Motion, Outcome, Trajectory};

/// The outcome as a number, for arrays.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[repr(u8)]
#[non_exhaustive]
pub enum OutcomeCode {
    /// [`Outcome::Landing`].
    Landing = 0,
    /// [`Outcome::RollsForever`].
    RollsForever = 1,
    /// [`Outcome::SlidesForever`].
    SlidesForever = 2,
    /// [`Outcome::ParticleAtPlane`].
    ParticleAtPlane = 3,
    /// [`Outcome::ParticleAtBottom`].
    ParticleAtBottom = 4,
    /// [`Outcome::ParticleAtTop`].
    ParticleAtTop = 5,
    /// [`Outcome::TimeLimit`].
    TimeLimit = 6,
    /// [`Outcome::TransitionLimit`].
    TransitionLimit = 7,
    /// [`Outcome::Inconsistent`].
    Inconsistent = 8,
    /// [`Outcome::Ambiguous`].
    Ambiguous = 9,
    /// [`Outcome::Singular`].
    Singular = 10,
    /// [`Outcome::Unresolved`].
    Unresolved = 11,
}

impl OutcomeCode {
    /// All codes, in order.
    pub const ALL: [Self; 12] = [
        Self::Landing,
        Self::RollsForever,
        Self::SlidesForever,
        Self::ParticleAtPlane,
        Self::ParticleAtBottom,
        Self::ParticleAtTop,
        Self::TimeLimit,
        Self::TransitionLimit,
        Self::Inconsistent,
        Self::Ambiguous,
        Self::Singular,
        Self::Unresolved,
    ];

    /// Of an outcome.
    #[must_use]
    pub const fn of(outcome: &Outcome) -> Self {
        match outcome {
            Outcome::Landing { .. } => Self::Landing,
            Outcome::RollsForever { .. } => Self::RollsForever,
            Outcome::SlidesForever { .. } => Self::SlidesForever,
            Outcome::ParticleAtPlane { .. } => Self::ParticleAtPlane,
            Outcome::ParticleAtBottom { .. } => Self::ParticleAtBottom,
            Outcome::ParticleAtTop { .. } => Self::ParticleAtTop,
            Outcome::TimeLimit { .. } => Self::TimeLimit,
            Outcome::TransitionLimit { .. } => Self::TransitionLimit,
            Outcome::Inconsistent { .. } => Self::Inconsistent,
            Outcome::Ambiguous { .. } => Self::Ambiguous,
            Outcome::Singular { .. } => Self::Singular,
            Outcome::Unresolved { .. } => Self::Unresolved,
        }
    }

    /// Lower-case name, as files and the command line write it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Landing => "landing",
            Self::RollsForever => "rolls_forever",
            Self::SlidesForever => "slides_forever",
            Self::ParticleAtPlane => "particle_at_plane",
            Self::ParticleAtBottom => "particle_at_bottom",
            Self::ParticleAtTop => "particle_at_top",
            Self::TimeLimit => "time_limit",
            Self::TransitionLimit => "transition_limit",
            Self::Inconsistent => "inconsistent",
            Self::Ambiguous => "ambiguous",
            Self::Singular => "singular",
            Self::Unresolved => "unresolved",
        }
    }
}

/// A sequence of phases in 64 bits: up to [`PhaseSequence::CAPACITY`] phases, then a mark that more follow.
///
/// Written with one letter a phase: `R` rolling, `+` and `-` sliding with σ = ±1, `g` and `n` gliding with σ = +1 and
/// −1, `G` gliding without slip, `F` flight; `…` where more phases follow than fit.
///
/// ```
/// use littlewood::{Hoop, Limits, Start};
///
/// let hoop = Hoop::figure_2(0.5, 0.4)?;
/// let motion = hoop.simulate(Start::at(std::f64::consts::FRAC_PI_2, 2.0), Limits::default())?;
/// assert_eq!(motion.summary().sequence.to_string(), "-R+F");
/// # Ok::<(), littlewood::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PhaseSequence(u64);

impl PhaseSequence {
    /// Number of phases that fit.
    pub const CAPACITY: u32 = 20;

    /// Bits of a phase; 0 ends the sequence.
    const BITS: u32 = 3;
    const OVERFLOW: u64 = 1 << 63;
    const LETTERS: [char; 8] = [' ', 'R', '-', '+', 'n', 'g', 'G', 'F'];

    /// From the 64 bits of [`PhaseSequence::bits`].
    #[must_use]
    pub const fn from_bits(bits: u64) -> Self {
        Self(bits)
    }

    /// Three bits a phase, the first phase lowest: the number that arrays hold.
    #[must_use]
    pub const fn bits(self) -> u64 {
        self.0
    }

    /// Adds a phase.
    pub fn push(&mut self, mode: Mode, direction: Option<Direction>) {
        let code = match (mode, direction) {
            (Mode::Rolling, _) => 1,
            (Mode::Sliding, Some(Direction::Positive)) => 3,
            (Mode::Sliding, _) => 2,
            (Mode::Gliding, Some(Direction::Negative)) => 4,
            (Mode::Gliding, Some(Direction::Positive)) => 5,
            (Mode::Gliding, None) => 6,
            (Mode::Flight, _) => 7,
        };
        let length = self.len();
        if length < Self::CAPACITY {
            self.0 |= code << (Self::BITS * length);
        } else {
            self.0 |= Self::OVERFLOW;
        }
    }

    /// Number of phases that are kept.
    #[must_use]
    pub const fn len(self) -> u32 {
        let used = u64::BITS - (self.0 & !Self::OVERFLOW).leading_zeros();
        used.div_ceil(Self::BITS)
    }

    /// Whether there is no phase: no motion was consistent at the start.
    #[must_use]
    pub const fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Whether there were more phases than fit.
    #[must_use]
    pub const fn is_truncated(self) -> bool {
        self.0 & Self::OVERFLOW != 0
    }
}

impl fmt::Display for PhaseSequence {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = String::new();
        for i in 0..self.len() {
            let code = (self.0 >> (Self::BITS * i)) & 7;
            text.push(Self::LETTERS[usize::try_from(code).unwrap_or(0)]);
        }
        if self.is_truncated() {
            text.push('…');
        }
        f.pad(&text)
    }
}

/// What a sweep keeps of a motion. Times, angles and lengths are dimensionless; what did not happen is NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Summary {
    /// Outcome.
    pub outcome: OutcomeCode,
    /// Sequence of phases.
    pub sequence: PhaseSequence,
    /// Number of transitions.
    pub transitions: u32,
    /// State at the end, or where the phase begins that lasts for ever ([`Outcome::state`]).
    pub end: State,
    /// Energy there (2.8). Infinite rates make it NaN.
    pub energy: f64,
    /// Time of the first slip out of rolling; NaN if none.
    pub first_slip_time: f64,
    /// Time of the lift-off: the start of the flight, which may be the start of the motion; NaN if none.
    pub lift_off_time: f64,
    /// Distance that the geometric centre travels in flight; NaN without landing.
    pub jump_length: f64,
    /// Largest gap between the rim and the plane in flight; NaN without landing.
    pub jump_height: f64,
    /// Whether the motion met P ≤ 0 (Painlevé): no motion, several, or a singular slide.
    pub painleve: bool,
}

impl Trajectory {
    /// The motion in a few numbers.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let outcome = self.outcome();
        let code = OutcomeCode::of(&outcome);
        let mut sequence = PhaseSequence::default();
        for phase in self.phases() {
            sequence.push(phase.mode(), phase.direction());
        }
        let end = outcome.state();
        let forever = matches!(code, OutcomeCode::RollsForever | OutcomeCode::SlidesForever);
        let energy = self.phases().last().map_or(f64::NAN, |phase| {
            let sample = if forever { Some(phase.first()) } else { phase.last() };
            sample.map_or(f64::NAN, |sample| sample.energy)
        });
        let mut summary = Summary {
            outcome: code,
            sequence,
            transitions: u32::try_from(self.transitions().len()).unwrap_or(u32::MAX),
            end,
            energy: if energy.is_finite() { energy } else { f64::NAN },
            first_slip_time: f64::NAN,
            lift_off_time: f64::NAN,
            jump_length: f64::NAN,
            jump_height: f64::NAN,
            painleve: matches!(
                code,
                OutcomeCode::Inconsistent | OutcomeCode::Ambiguous | OutcomeCode::Singular
            ),
        };
        if let Some(slip) = self.transitions().iter().find(|transition| transition.cause == Cause::Slip) {
            summary.first_slip_time = slip.state.time;
        }
        if let Some(phase) = self.phases().last()
            && let Motion::Flight(flight) = phase.motion()
        {
            summary.lift_off_time = phase.start().time;
            if code == OutcomeCode::Landing {
                summary.jump_length = (end.x - phase.start().x).abs();
                summary.jump_height = flight.apex().1;
            }
        }
        summary
    }
}
