//! The summary of a motion: outcome, sequence of phases, the end, first slip, lift-off and jump.

use crate::automaton::Cause;
use crate::equations::energy_at;
use crate::flight::Flight;
use crate::hoop::Hoop;
use crate::outcome::OutcomeKind;
use crate::sequence::PhaseSequence;
use crate::state::State;
use crate::trajectory::{PhaseSolution, Trajectory};
use crate::transition::Transition;
use crate::trig::sincos;
use crate::walk::{PhaseSeen, Recorder, Solution};

/// The summary of a motion. Times, angles and lengths are dimensionless; what did not happen is NaN.
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
    /// State at the end, or where the phase begins that lasts for ever ([`crate::Outcome::state`]).
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

/// Makes a summary of a motion from its phases and transitions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SummaryRecorder<'a> {
    hoop: &'a Hoop,
    summary: Summary,
    /// The last phase, if it is a flight: where it begins and what it is.
    flight: Option<(State, Flight)>,
}

impl<S: Solution> Recorder<S> for SummaryRecorder<'_> {
    #[inline]
    fn phase(&mut self, phase: PhaseSeen, solution: S) {
        self.summary.sequence.push(phase.mode, phase.direction);
        self.flight = solution.flight().map(|flight| (phase.start, *flight));
        if self.flight.is_some() && self.summary.lift_off_time.is_nan() {
            self.summary.lift_off_time = phase.start.time;
        }
    }

    #[inline]
    fn transition(&mut self, transition: Transition) {
        self.summary.transitions = self.summary.transitions.saturating_add(1);
        if transition.cause == Cause::Slip && self.summary.first_slip_time.is_nan() {
            self.summary.first_slip_time = transition.time();
        }
    }
}

impl<'a> SummaryRecorder<'a> {
    pub(crate) const fn new(hoop: &'a Hoop) -> Self {
        Self { hoop, summary: Summary::without_motion(OutcomeKind::NotComputed), flight: None }
    }

    /// The summary of a motion that ended in this way, at this state.
    pub(crate) fn finish(self, outcome: OutcomeKind, end: State) -> Summary {
        let Self { hoop, mut summary, flight } = self;
        (summary.outcome, summary.end, summary.painleve) = (outcome, end, outcome.is_painleve());
        let mut last = end;
        if let Some((start, flight)) = flight {
            // The energy of a flight is that of its start, where there is no gap.
            last = start;
            if outcome == OutcomeKind::Landing {
                summary.jump_length = (end.x - start.x).abs();
                summary.jump_height = flight.apex().1;
            }
        }
        if !summary.sequence.is_empty() {
            let energy = energy_at(hoop, &last, sincos(last.theta), (0.0, 0.0));
            // Where a rate is infinite the energy is not a number.
            summary.energy = if energy.is_finite() { energy } else { f64::NAN };
        }
        summary
    }
}

/// A borrowed solution.
impl Solution for &PhaseSolution {
    fn flight(&self) -> Option<&Flight> {
        (**self).flight()
    }

    fn theta_range(&self) -> Option<(f64, f64)> {
        (**self).theta_range()
    }
}

impl Trajectory {
    /// The motion in a few numbers.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let mut recorder = SummaryRecorder::new(self.hoop());
        for phase in self.phases() {
            let seen = PhaseSeen {
                mode: phase.mode(),
                direction: phase.direction(),
                start: phase.start(),
                end: phase.end(),
            };
            recorder.phase(seen, phase.solution());
        }
        for transition in self.transitions() {
            Recorder::<&PhaseSolution>::transition(&mut recorder, *transition);
        }
        let outcome = self.outcome();
        recorder.finish(outcome.kind(), outcome.state())
    }
}
