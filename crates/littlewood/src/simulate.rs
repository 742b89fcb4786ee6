//! The simulation: the walk along the automaton with exact solutions, kept as a trajectory.

use crate::error::{ParameterError, within};
use crate::exact::Exact;
use crate::hoop::{Body, Hoop};
use crate::impact::Impact;
use crate::mode::Direction;
use crate::outcome::Outcome;
use crate::proof::Proof;
use crate::quantity::{Bound, Quantity};
use crate::state::{Start, State};
use crate::trajectory::{Phase, PhaseSolution, Trajectory};
use crate::transition::Transition;
use crate::walk::{Event, PhaseSeen, Recorder, walk};

/// When to stop a motion that has not come to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Limits {
    /// Time τ at which to stop, if any. A motion that is proved to roll for ever is reported as such in any case.
    pub until: Option<f64>,
    /// Largest number of transitions. Light hoops on nearly smooth planes need it, whose friction takes off next to no energy,
    /// and e = 1, where bounces need not end.
    pub transitions: usize,
    /// Which proofs end a motion that is not followed to a time limit.
    pub proof: Proof,
}

impl Default for Limits {
    fn default() -> Self {
        Self { until: None, transitions: 10_000, proof: Proof::default() }
    }
}

impl Limits {
    pub(crate) fn check(&self, start: &Start) -> Result<(), ParameterError> {
        if let Some(until) = self.until {
            Quantity::Until.check(until)?;
            within(Quantity::Until, until, Bound::AtLeast(Quantity::Time, start.time))?;
        }
        Ok(())
    }

    /// The proofs that end a motion: none where the states up to a time limit are wanted.
    pub(crate) const fn proof(&self) -> Proof {
        if self.until.is_some() { Proof::None } else { self.proof }
    }

    /// Stops at the time τ.
    #[must_use]
    pub fn until(time: f64) -> Self {
        Self::default().with_until(Some(time))
    }

    /// The same limits with a time limit, or without one.
    #[must_use]
    pub const fn with_until(self, until: Option<f64>) -> Self {
        Self { until, ..self }
    }

    /// The same limits with a largest number of transitions.
    #[must_use]
    pub const fn with_transitions(self, transitions: usize) -> Self {
        Self { transitions, ..self }
    }

    /// The same limits, ending a motion by these proofs.
    #[must_use]
    pub const fn with_proof(self, proof: Proof) -> Self {
        Self { proof, ..self }
    }
}

impl Hoop {
    /// Simulates the motion from `start` to its end, or to a limit.
    ///
    /// Every transition is located to the last digits; none is missed. The result is the same on every platform,
    /// bit for bit. Without a coefficient of restitution the motion ends where the rim lands; with one it goes on.
    ///
    /// ```
    /// use littlewood::{Hoop, Limits, Mode, Start};
    ///
    /// // Figure 3 of the paper: slides, rolls, slides, jumps.
    /// let hoop = Hoop::figure_2(0.5, 0.4)?;
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
        let state = self.check(start)?;
        limits.check(&start)?;
        let mut trajectory = Trajectory {
            hoop: *self,
            start: state,
            phases: Vec::new(),
            transitions: Vec::new(),
            outcome: Outcome::TimeLimit { state },
        };
        let solver = Exact::new(self, &limits);
        trajectory.outcome = walk(&solver, (state, start.gap_rate), &limits, &mut trajectory);
        Ok(trajectory)
    }

    /// Refuses a start that this hoop cannot have.
    pub(crate) fn check(&self, start: Start) -> Result<State, ParameterError> {
        let state = start.check()?;
        match self.body() {
            Body::Massless(_) if start.gap_rate > 0.0 => {
                Err(ParameterError::MasslessFlight { gap_rate: start.gap_rate })
            }
            Body::Massless(_) | Body::Heavy(_) => Ok(state),
        }
    }
}

impl Recorder<PhaseSolution> for Trajectory {
    fn phase(&mut self, phase: PhaseSeen, solution: PhaseSolution) {
        let PhaseSeen { start, end, .. } = phase;
        self.phases.push(Phase { hoop: self.hoop, solution, start, end, ended_by: None });
    }

    fn transition(&mut self, event: &Event, impact: Option<&Impact>, direction: Option<Direction>) {
        let Event { state: before, from, to, cause } = *event;
        let after = impact.map_or(before, |impact| impact.state_after(&before));
        let impact = impact.copied();
        if from.is_some()
            && let Some(phase) = self.phases.last_mut()
        {
            phase.ended_by = Some(self.transitions.len());
        }
        self.transitions.push(Transition { before, after, impact, from, to, direction, cause });
    }
}
