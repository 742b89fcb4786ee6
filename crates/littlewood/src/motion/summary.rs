//! The summary of a motion: outcome, sequence of phases, the end, first slip, lift-off and jump.

use crate::math::trig::sincos;
use crate::mechanics::{Impact, energy_at};
use crate::model::{Direction, Hoop, Mode, State};
use crate::modes::{Flight, PhaseSolution};
use crate::motion::trajectory::{Phase, Trajectory};
use crate::walk::{
    Cause, Event, MaybeFlight, Origin, OutcomeKind, PhaseSeen, PhaseSequence, Recorder, Transition, Wants,
};

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
    /// Distance that the geometric centre travels in the first flight; NaN without landing.
    pub jump_length: f64,
    /// Largest gap between the rim and the plane in the first flight; NaN without landing.
    pub jump_height: f64,
    /// Number of landings; bounces that settle, all together, count as none.
    pub landings: u32,
    /// Energy lost in impacts, those of settling and jams among them.
    pub impact_energy_lost: f64,
    /// Time from which on the rim stays at the plane after it has left it: of the last landing without rebound, or of the end
    /// of the last bounces. NaN where it has never left it, or is off it at the end.
    pub settle_time: f64,
    /// Whether the motion met P ≤ 0 (Painlevé): no motion, several, a singular slide, or a jam.
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
            landings: 0,
            impact_energy_lost: f64::NAN,
            settle_time: f64::NAN,
            painleve: false,
        }
    }
}

/// Makes a summary of a motion from its phases and transitions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SummaryRecorder<'a> {
    hoop: &'a Hoop,
    origin: Origin,
    summary: Summary,
    /// Where the last phase begins and with which rate of the gap, if it is a flight that no impact has ended.
    flight: Option<(State, f64)>,
    /// Largest gap of the flight before the first landing.
    jump_height: f64,
    /// Rate of the gap after the last impact, if no phase has followed it.
    gap_rate: f64,
}

impl<S: MaybeFlight> Recorder<S> for SummaryRecorder<'_> {
    #[inline]
    fn phase(&mut self, phase: PhaseSeen, solution: S) {
        self.summary.sequence.push(phase.mode, phase.direction);
        (self.flight, self.gap_rate) = (None, 0.0);
        let Some(flight) = solution.flight() else { return };
        self.flight = Some((phase.start, flight.take_off_rate()));
        self.summary.settle_time = f64::NAN;
        if self.summary.lift_off_time.is_nan() {
            self.summary.lift_off_time = self.origin.time(phase.start.time);
        }
        if self.summary.landings == 0 {
            self.jump_height = flight.apex().1;
        }
    }

    #[inline]
    fn transition(&mut self, event: &Event, impact: Option<&Impact>, _: Option<Direction>) {
        self.summary.transitions = self.summary.transitions.saturating_add(1);
        if event.cause == Cause::Slip && self.summary.first_slip_time.is_nan() {
            self.summary.first_slip_time = self.origin.time(event.state.time);
        }
        if event.cause == Cause::Landing {
            if self.summary.landings == 0
                && let Some((start, _)) = self.flight
            {
                self.summary.jump_length = (event.state.x - start.x).abs();
                self.summary.jump_height = self.jump_height;
            }
            self.summary.landings += 1;
        }
        self.summary.painleve |= event.cause == Cause::Jam;
        if let Some(impact) = impact {
            (self.flight, self.gap_rate) = (None, impact.after.gap_rate);
            self.summary.impact_energy_lost += impact.energy_lost();
            if event.from == Some(Mode::Flight) && event.to != Some(Mode::Flight) {
                self.summary.settle_time = self.origin.time(event.state.time);
            }
        }
    }

    fn wants(&self) -> Wants {
        if self.summary.sequence.is_truncated() { Wants::Number } else { Wants::Modes }
    }

    fn links(&mut self, transitions: u32, phases: PhaseSequence) {
        self.summary.transitions = self.summary.transitions.saturating_add(transitions);
        self.summary.sequence.append(phases);
    }
}

impl<'a> SummaryRecorder<'a> {
    /// Of a motion that is followed from this origin.
    pub(crate) const fn new(hoop: &'a Hoop, origin: Origin) -> Self {
        let summary =
            Summary { impact_energy_lost: 0.0, ..Summary::without_motion(OutcomeKind::NotComputed) };
        Self { hoop, origin, summary, flight: None, jump_height: f64::NAN, gap_rate: 0.0 }
    }

    /// The summary of a motion that ended in this way, at this state, as seen from the origin.
    pub(crate) fn finish(self, outcome: OutcomeKind, end: State) -> Summary {
        let Self { hoop, origin, mut summary, flight, mut gap_rate, .. } = self;
        (summary.outcome, summary.end) = (outcome, origin.state(end));
        summary.painleve |= outcome.is_painleve();
        let mut last = end;
        if let Some(start) = flight {
            // The energy of a flight is that of its start, where there is no gap.
            (last, gap_rate) = start;
        }
        if !summary.sequence.is_empty() {
            let energy = energy_at(hoop, &last, sincos(last.theta), (0.0, gap_rate));
            // Where a rate is infinite the energy is not a number.
            summary.energy = if energy.is_finite() { energy } else { f64::NAN };
        }
        summary
    }
}

/// A borrowed solution.
impl MaybeFlight for &PhaseSolution {
    fn flight(&self) -> Option<&Flight> {
        (**self).flight()
    }
}

impl Trajectory {
    /// The motion in a few numbers.
    #[must_use]
    pub fn summary(&self) -> Summary {
        let mut recorder = SummaryRecorder::new(self.hoop(), self.origin);
        let mut transitions = self.transitions().iter().peekable();
        // A transition has its place at the end of a phase, as seen from the origin; a jam before a phase has none, and needs none.
        let mut tell = |recorder: &mut SummaryRecorder<'_>, ended: Option<&Phase>| {
            let ends = ended.is_some();
            while let Some(transition) = transitions.next_if(|next| next.from.is_some() == ends) {
                let Transition { before, impact, from, to, direction, cause, .. } = *transition;
                let state = ended.and_then(|phase| phase.end).unwrap_or(before);
                let event = Event { state, from, to, cause };
                Recorder::<&PhaseSolution>::transition(recorder, &event, impact.as_ref(), direction);
                if ends {
                    return;
                }
            }
        };
        for phase in self.phases() {
            // Jams from states without a consistent motion come before the phase that they lead to.
            tell(&mut recorder, None);
            let seen = PhaseSeen {
                mode: phase.mode(),
                direction: phase.direction(),
                start: phase.start,
                end: phase.end,
            };
            recorder.phase(seen, phase.solution());
            tell(&mut recorder, Some(phase));
        }
        tell(&mut recorder, None);
        recorder.finish(self.outcome.kind(), self.outcome.state())
    }
}
