//! The summary of a motion: outcome, sequence of phases, end, first slip, lift-off and jump.

use crate::math::trig::Angle;
use crate::mechanics::{Clearance, Impact, energy_at};
use crate::model::{Hoop, Mode, SlipDirection, State};
use crate::walk::{
    Cause, Event, Origin, OutcomeKind, PhaseDetail, PhaseRecord, PhaseSequence, Recorder, Solution,
};

/// The summary of a motion. All values are dimensionless; the values of absent events are NaN.
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
    /// State at the end, or at the start of an endless phase ([`crate::Outcome::state`]).
    pub end: State,
    /// Energy at this state (2.8); NaN if a rate is infinite, or the last digit of the angle leaves
    /// the energy of a massless hoop open.
    pub energy: f64,
    /// Time of the first slip out of rolling; NaN if none.
    pub first_slip_time: f64,
    /// Time of the lift-off: the start of the flight, which may be the start of the motion; NaN if
    /// none.
    pub lift_off_time: f64,
    /// Distance that the geometric centre travels in the first flight; NaN without landing.
    pub jump_length: f64,
    /// Largest gap between the rim and the plane in the first flight; NaN without landing.
    pub jump_height: f64,
    /// Number of landings, without settling bounces.
    pub landings: u32,
    /// Energy lost in impacts, including settling and jams.
    pub impact_energy_lost: f64,
    /// Time after which the rim stays on the plane: the last landing without rebound, or the end of
    /// the last settling bounces. NaN if the rim never leaves the plane, or is off the plane at the
    /// end.
    pub settle_time: f64,
    /// Number of half swings: rolling with rolling resistance from one turning point to the next.
    #[cfg_attr(feature = "serde", serde(default))]
    pub half_swings: u32,
    /// Whether P ≤ 0 occurred (Painlevé): no consistent motion, several, a singular slide, or a
    /// jam.
    pub painleve: bool,
}

impl Summary {
    /// The summary of a point with contradictory parameters.
    pub const INVALID: Self = Self::without_motion(OutcomeKind::Invalid);

    /// The summary of a point that has not been computed.
    pub const NOT_COMPUTED: Self = Self::without_motion(OutcomeKind::NotComputed);

    const fn without_motion(outcome: OutcomeKind) -> Self {
        Self {
            outcome,
            sequence: PhaseSequence::from_bits(0),
            transitions: 0,
            end: State {
                time: f64::NAN,
                theta: f64::NAN,
                theta_rate: f64::NAN,
                slip: f64::NAN,
                x: f64::NAN,
            },
            energy: f64::NAN,
            first_slip_time: f64::NAN,
            lift_off_time: f64::NAN,
            jump_length: f64::NAN,
            jump_height: f64::NAN,
            landings: 0,
            impact_energy_lost: f64::NAN,
            settle_time: f64::NAN,
            half_swings: 0,
            painleve: false,
        }
    }
}

/// Builds a summary from the phases and transitions of a motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SummaryRecorder<'a> {
    hoop: &'a Hoop,
    origin: &'a Origin,
    summary: Summary,
    /// Start and initial gap rate of the last phase, if it is a flight not yet ended by an impact.
    flight: Option<(State, f64)>,
    /// Largest gap of the flight before the first landing.
    jump_height: f64,
    /// Gap rate after the last impact, if no phase has followed.
    gap_rate: f64,
    /// Whether the next phase continues the last one with the rotation reversed, so that both are
    /// one in the sequence.
    turns_back: bool,
    /// Whether the last phase rolls from a turning point.
    swings: bool,
}

impl<S: Solution> Recorder<S> for SummaryRecorder<'_> {
    #[inline]
    fn phase(&mut self, phase: PhaseRecord, solution: S) {
        if !self.turns_back {
            self.summary.sequence.push(phase.mode, phase.direction);
        }
        self.swings = phase.swings();
        (self.flight, self.gap_rate) = (None, 0.0);
        let Some(take_off_rate) = solution.take_off_rate() else {
            return;
        };
        self.flight = Some((phase.start, take_off_rate));
        self.summary.settle_time = f64::NAN;
        if self.summary.lift_off_time.is_nan() {
            self.summary.lift_off_time = self.origin.time(phase.start.time);
        }
        if self.summary.landings == 0 {
            self.jump_height = solution.height();
        }
    }

    #[inline]
    fn transition(&mut self, event: &Event, impact: Option<&Impact>, _: Option<SlipDirection>) {
        self.summary.transitions = self.summary.transitions.saturating_add(1);
        self.turns_back = event.cause == Cause::TurningPoint && event.from == event.to;
        match event.cause {
            Cause::Slip if self.summary.first_slip_time.is_nan() => {
                self.summary.first_slip_time = self.origin.time(event.state.time);
            }
            Cause::Landing => {
                if self.summary.landings == 0
                    && let Some((start, _)) = self.flight
                {
                    self.summary.jump_length = (event.state.x - start.x).abs();
                    self.summary.jump_height = self.jump_height;
                }
                self.summary.landings += 1;
            }
            Cause::TurningPoint if self.swings => self.summary.half_swings += 1,
            Cause::Jam => self.summary.painleve = true,
            Cause::Slip
            | Cause::NormalForceZero
            | Cause::Stick
            | Cause::Reversal
            | Cause::Graze
            | Cause::LiftOff
            | Cause::ParticleAtPlane
            | Cause::ParticleAtBottom
            | Cause::ParticleAtTop
            | Cause::Singularity
            | Cause::Settle
            | Cause::TurningPoint => {}
        }
        if let Some(impact) = impact {
            (self.flight, self.gap_rate) = (None, impact.after.gap_rate);
            self.summary.impact_energy_lost += self.origin.force(impact.energy_lost());
            if event.from == Some(Mode::Flight) && event.to != Some(Mode::Flight) {
                self.summary.settle_time = self.origin.time(event.state.time);
            }
        }
    }

    fn half_swings(&self) -> usize {
        self.summary.half_swings as usize
    }

    fn detail(&self) -> PhaseDetail {
        if self.summary.sequence.is_truncated() {
            PhaseDetail::Number
        } else {
            PhaseDetail::Modes
        }
    }

    fn links(&mut self, transitions: u32, phases: PhaseSequence) {
        self.summary.transitions = self.summary.transitions.saturating_add(transitions);
        self.summary.sequence.append(phases);
    }
}

impl<'a> SummaryRecorder<'a> {
    pub(crate) const fn new(hoop: &'a Hoop, origin: &'a Origin) -> Self {
        let summary = Summary {
            impact_energy_lost: 0.0,
            ..Summary::without_motion(OutcomeKind::NotComputed)
        };
        Self {
            hoop,
            origin,
            summary,
            flight: None,
            jump_height: f64::NAN,
            gap_rate: 0.0,
            turns_back: false,
            swings: false,
        }
    }

    /// The summary of a motion with this outcome and end; the end is relative to the origin.
    pub(crate) fn finish(self, outcome: OutcomeKind, end: State) -> Summary {
        let Self {
            hoop,
            origin,
            mut summary,
            flight,
            mut gap_rate,
            ..
        } = self;
        (summary.outcome, summary.end) = (outcome, origin.state(end));
        summary.painleve |= outcome.is_painleve();
        let mut last = end;
        if let Some(start) = flight {
            // The energy of a flight is that of its start, where the gap is zero.
            (last, gap_rate) = start;
        }
        if !summary.sequence.is_empty() {
            let energy = energy_at(
                hoop,
                &last,
                Angle::of(last.theta),
                Clearance { gap: 0.0, gap_rate },
            );
            // The energy is NaN if a rate is infinite, or the angle does not tell it.
            let is_told =
                outcome != OutcomeKind::Unresolved || hoop.undecided_place(last.theta).is_none();
            summary.energy = if energy.is_finite() && is_told {
                origin.energy(energy)
            } else {
                f64::NAN
            };
        }
        summary
    }
}
