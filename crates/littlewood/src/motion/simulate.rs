//! The simulation: the walk along the automaton with exact solutions, recorded as a trajectory.

use crate::mechanics::Impact;
use crate::model::{Body, Hoop, Limits, ParameterError, SlipDirection, Start, State};
use crate::modes::PhaseSolution;
use crate::motion::summary::SummaryRecorder;
use crate::motion::trajectory::{Phase, Trajectory};
use crate::walk::{
    Event, Exact, Origin, Outcome, PhaseRecord, Recorder, SharedProofData, Solution, Solver,
    Transition, WalkSettings, walk,
};

impl Hoop {
    /// Simulates the motion from `start` to its end, or to a limit.
    ///
    /// Each transition is isolated as a root of the solution and located to machine precision, that
    /// is, to a few times the uncertainty due to the last digits of hoop and start
    /// (docs/accuracy.md gives measurements). The result is identical on every platform, bit for
    /// bit. Without a coefficient of restitution the motion ends at the first landing.
    ///
    /// ```
    /// use littlewood::{Hoop, Limits, Mode, Start};
    ///
    /// // Figure 3 of the paper: slides, rolls, slides, jumps.
    /// let hoop = Hoop::equal_masses(0.5, 0.4)?;
    /// let start = Start::at(std::f64::consts::FRAC_PI_2, 2.0);
    /// let motion = hoop.simulate(start, Limits::default())?;
    /// let modes: Vec<Mode> = motion.phases().iter().map(|phase| phase.mode()).collect();
    /// assert_eq!(modes, [Mode::Sliding, Mode::Rolling, Mode::Sliding, Mode::Flight]);
    /// assert!((motion.phases()[3].start().time - 1.518_670_213_819_437).abs() < 1e-14);
    /// # Ok::<(), littlewood::ParameterError>(())
    /// ```
    ///
    /// # Errors
    /// A start or a limit that is not finite, or a time limit before the start.
    pub fn simulate(&self, start: Start, limits: Limits) -> Result<Trajectory, ParameterError> {
        self.simulate_by(start, limits, |exact| exact)
    }

    /// [`Hoop::simulate`] by a solver that is made from the exact one.
    pub(super) fn simulate_by<'a, S>(
        &'a self,
        start: Start,
        limits: Limits,
        solver: impl FnOnce(Exact<'a>) -> S,
    ) -> Result<Trajectory, ParameterError>
    where
        S: Solver<Solution = PhaseSolution, Outcome = Outcome>,
    {
        let state = self.check(start)?;
        limits.check(&start)?;
        let (origin, relative, limits) = Origin::of(self, &start, limits);
        let mut recording = Recording {
            hoop: *self,
            origin,
            phases: Vec::new(),
            transitions: Vec::new(),
            summary: SummaryRecorder::new(self, &origin),
        };
        let solver = solver(Exact::new(self, &limits));
        let settings = WalkSettings {
            limits: &limits,
            shared: SharedProofData::default(),
        };
        let outcome = walk(&solver, relative, settings, &mut recording);
        let Recording {
            hoop,
            phases,
            transitions,
            summary,
            ..
        } = recording;
        let summary = summary.finish(outcome.kind(), outcome.state());
        Ok(Trajectory {
            hoop,
            origin,
            start: state,
            relative: relative.state,
            phases,
            transitions,
            outcome,
            summary,
        })
    }

    pub(crate) fn check(&self, start: Start) -> Result<State, ParameterError> {
        let state = start.check()?;
        match self.body() {
            Body::Massless(_) if start.gap_rate > 0.0 => Err(ParameterError::MasslessFlight {
                gap_rate: start.gap_rate,
            }),
            Body::Massless(_) | Body::Heavy(_) => Ok(state),
        }
    }
}

/// The parts of a trajectory, while it is walked.
struct Recording<'a> {
    hoop: Hoop,
    origin: Origin,
    phases: Vec<Phase>,
    transitions: Vec<Transition>,
    summary: SummaryRecorder<'a>,
}

impl Recorder<PhaseSolution> for Recording<'_> {
    fn phase(&mut self, phase: PhaseRecord, solution: PhaseSolution) {
        self.summary.phase(phase, &solution);
        let PhaseRecord { start, end, .. } = phase;
        let Self { hoop, origin, .. } = *self;
        self.phases.push(Phase {
            hoop,
            origin,
            solution,
            start,
            end,
            ended_by: None,
        });
    }

    fn transition(
        &mut self,
        event: &Event,
        impact: Option<&Impact>,
        direction: Option<SlipDirection>,
    ) {
        Recorder::<&PhaseSolution>::transition(&mut self.summary, event, impact, direction);
        let Event {
            state: before,
            from,
            to,
            cause,
        } = *event;
        let after = impact.map_or(before, |impact| impact.state_after(&before));
        let impact = impact.map(|impact| self.origin.impact(*impact));
        if from.is_some()
            && let Some(phase) = self.phases.last_mut()
        {
            phase.ended_by = Some(self.transitions.len());
        }
        let [before, after] = [before, after].map(|state| self.origin.state(state));
        self.transitions.push(Transition {
            before,
            after,
            impact,
            from,
            to,
            direction,
            cause,
        });
    }

    fn half_swings(&self) -> usize {
        Recorder::<&PhaseSolution>::half_swings(&self.summary)
    }
}

impl Solution for &PhaseSolution {
    fn take_off_rate(&self) -> Option<f64> {
        (**self).take_off_rate()
    }

    fn height(&self) -> f64 {
        (**self).height()
    }
}
