//! What a sweep keeps of a motion: outcome, sequence of phases, the end, first slip, lift-off and jump.

use crate::automaton::Cause;
use crate::outcome::OutcomeKind;
use crate::sequence::PhaseSequence;
use crate::state::State;
use crate::trajectory::{PhaseSolution, Trajectory};

/// What a sweep keeps of a motion. Times, angles and lengths are dimensionless; what did not happen is NaN.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Summary {
    /// Outcome.
    pub outcome: OutcomeKind,
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

impl Summary {
    /// The summary of a point whose parameters contradict each other.
    pub const INVALID: Self = Self::without_motion(OutcomeKind::Invalid);

    /// The summary of a point that has not been computed.
    pub const NOT_COMPUTED: Self = Self::without_motion(OutcomeKind::NotComputed);

    const fn without_motion(outcome: OutcomeKind) -> Self {
        let nowhere =
            State { time: f64::NAN, theta: f64::NAN, theta_rate: f64::NAN, slip: f64::NAN, x: f64::NAN };
        Self {
            outcome,
            sequence: PhaseSequence::from_bits(0),
            transitions: 0,
            end: nowhere,
            energy: f64::NAN,
            first_slip_time: f64::NAN,
            lift_off_time: f64::NAN,
            jump_length: f64::NAN,
            jump_height: f64::NAN,
            painleve: false,
        }
    }
}

impl Trajectory {
    /// The motion in a few numbers.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let outcome = self.outcome();
        let kind = outcome.kind();
        let mut sequence = PhaseSequence::default();
        for phase in self.phases() {
            sequence.push(phase.mode(), phase.direction());
        }
        let end = outcome.state();
        let energy = self.phases().last().map_or(f64::NAN, |phase| {
            let sample = if kind.is_forever() { Some(phase.first()) } else { phase.last() };
            sample.map_or(f64::NAN, |sample| sample.energy)
        });
        let mut summary = Summary {
            sequence,
            transitions: u32::try_from(self.transitions().len()).unwrap_or(u32::MAX),
            end,
            energy: if energy.is_finite() { energy } else { f64::NAN },
            painleve: kind.is_painleve(),
            ..Summary::without_motion(kind)
        };
        if let Some(slip) = self.transitions().iter().find(|transition| transition.cause == Cause::Slip) {
            summary.first_slip_time = slip.time();
        }
        if let Some(phase) = self.phases().last()
            && let PhaseSolution::Flight(flight) = phase.motion()
        {
            summary.lift_off_time = phase.start().time;
            if kind == OutcomeKind::Landing {
                summary.jump_length = (end.x - phase.start().x).abs();
                summary.jump_height = flight.apex().1;
            }
        }
        summary
    }
}
