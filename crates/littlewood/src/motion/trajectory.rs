//! A motion: its phases, the transitions between them, its outcome, and the state at any time.

use crate::mechanics::{Accelerations, Clearance, ContactForces, energy};
use crate::model::{Hoop, Mode, SlipDirection, State, getters};
use crate::modes::{Instant, PhaseSolution, Recurrence, Sample};
use crate::motion::summary::Summary;
use crate::walk::{Origin, Outcome, Transition};

/// A phase of motion in one mode.
#[derive(Clone, Debug)]
pub struct Phase {
    pub(crate) hoop: Hoop,
    pub(crate) origin: Origin,
    pub(crate) solution: PhaseSolution,
    /// Start and end, relative to the origin.
    pub(crate) start: State,
    pub(crate) end: Option<State>,
    /// Index of the transition that ends the phase.
    pub(crate) ended_by: Option<usize>,
}

getters! {
    Phase, [self]:
    /// Mode of motion.
    pub mode: Mode = self.solution.mode();
    /// The solution.
    pub solution: &PhaseSolution = &self.solution;
    /// State at the start.
    pub start: State = self.origin.state(self.start);
}

impl Phase {
    /// Direction of slip; none for rolling, rest and flight.
    pub fn direction(&self) -> Option<SlipDirection> {
        self.solution.direction()
    }

    /// State at the end; none for an endless phase. The rate is infinite if a gliding particle
    /// reaches θ = 0 or ±π.
    pub const fn end(&self) -> Option<State> {
        match self.end {
            Some(end) => Some(self.origin.state(end)),
            None => None,
        }
    }

    /// Time at the end; infinite for an endless phase.
    pub fn end_time(&self) -> f64 {
        self.end
            .map_or(f64::INFINITY, |end| self.origin.time(end.time))
    }

    /// Duration; infinite for an endless phase.
    pub fn duration(&self) -> f64 {
        self.origin.duration(self.last_instant()) - self.origin.duration(self.start.time)
    }

    /// Duration in the units of the solution.
    fn relative_duration(&self) -> f64 {
        self.last_instant() - self.start.time
    }

    /// Time from the start of the motion to the end of the phase.
    fn last_instant(&self) -> f64 {
        self.end.map_or(f64::INFINITY, |end| end.time)
    }

    /// Time from the start of the phase to `time`, clamped to the phase, in the units of the
    /// solution.
    fn elapsed(&self, time: f64) -> f64 {
        if time <= self.origin.time(self.start.time) {
            0.0
        } else if time >= self.end_time() {
            self.relative_duration()
        } else {
            self.origin.elapsed(time) - self.start.time
        }
    }

    /// The sample at `time`, clamped to the phase.
    fn at(&self, time: f64) -> Sample {
        self.relative_sample(self.elapsed(time))
    }

    /// Time since the start, and height, of the largest gap in a flight, also if the flight is cut
    /// before; none for other modes and for settling bounces, whose gap is not resolved.
    pub fn apex(&self) -> Option<(f64, f64)> {
        let PhaseSolution::Flight(flight) = &self.solution else {
            return None;
        };
        let (elapsed, height) = flight.apex();
        (!flight.settles()).then_some((self.origin.duration(elapsed), height))
    }

    /// Rate of the gap at the start of a flight; zero for other modes.
    pub fn take_off_rate(&self) -> f64 {
        match &self.solution {
            PhaseSolution::Flight(flight) => self.origin.velocity(flight.take_off_rate()),
            PhaseSolution::Rolling(_)
            | PhaseSolution::ResistedRolling(_)
            | PhaseSolution::Sliding(_)
            | PhaseSolution::Gliding(_)
            | PhaseSolution::Skidding(_)
            | PhaseSolution::Rest(_) => 0.0,
        }
    }

    /// The recurrence of the orbit of rolling, as long as static friction holds; none for other
    /// modes.
    pub fn recurrence(&self) -> Option<Recurrence> {
        match &self.solution {
            PhaseSolution::Rolling(rolling) => {
                Some(self.origin.recurrence(rolling.orbit().recurrence()))
            }
            PhaseSolution::Sliding(_)
            | PhaseSolution::ResistedRolling(_)
            | PhaseSolution::Gliding(_)
            | PhaseSolution::Flight(_)
            | PhaseSolution::Skidding(_)
            | PhaseSolution::Rest(_) => None,
        }
    }

    /// Whether friction or rolling resistance takes energy.
    pub(crate) fn loses_energy(&self) -> bool {
        let (slips, turns) = match self.mode() {
            Mode::Rolling => (false, true),
            Mode::Sliding => (true, true),
            Mode::Skidding => (true, false),
            Mode::Gliding | Mode::Flight | Mode::Rest => (false, false),
        };
        slips && self.hoop.mu_k() > 0.0 || turns && self.hoop.rolling_resistance() > 0.0
    }

    /// Energy lost to friction and rolling resistance during the phase.
    pub fn energy_lost(&self) -> f64 {
        if !self.loses_energy() {
            return 0.0;
        }
        let energy = |state: State| energy(&self.hoop, &state, 0.0, 0.0);
        self.end.map_or(0.0, |end| {
            self.origin.force(energy(self.start) - energy(end))
        })
    }

    /// The part of the energy lost that rolling resistance took.
    pub fn rolling_resistance_energy_lost(&self) -> f64 {
        self.end.map_or(0.0, |_| {
            self.share_of_resistance(self.end_time(), self.energy_lost())
        })
    }

    /// The part that rolling resistance took of what the phase lost up to a time.
    pub(crate) fn share_of_resistance(&self, time: f64, lost: f64) -> f64 {
        let chi = self.hoop.rolling_resistance();
        match &self.solution {
            _ if chi == 0.0 => 0.0,
            // By the rounding of a large χ it may seem to take more than all.
            PhaseSolution::Sliding(slide) if self.hoop.mu_k() > 0.0 => self
                .origin
                .force(chi * slide.pressed_turn(self.elapsed(time)))
                .min(lost),
            PhaseSolution::Sliding(_) | PhaseSolution::ResistedRolling(_) => lost,
            PhaseSolution::Rolling(_)
            | PhaseSolution::Gliding(_)
            | PhaseSolution::Flight(_)
            | PhaseSolution::Skidding(_)
            | PhaseSolution::Rest(_) => 0.0,
        }
    }

    /// Whether the phase is gliding that is not the limit of sliding as the inertia of a heavy hoop
    /// vanishes.
    pub const fn is_outside_small_inertia_limit(&self) -> bool {
        matches!(&self.solution, PhaseSolution::Gliding(glide) if !glide.is_small_inertia_limit())
    }

    /// The sample at the time `elapsed` after the start of the phase, clamped to the phase.
    pub fn sample(&self, elapsed: f64) -> Sample {
        self.relative_sample(self.origin.passed(elapsed))
    }

    fn relative_sample(&self, elapsed: f64) -> Sample {
        let duration = self.relative_duration();
        let state = match self.end {
            _ if elapsed <= 0.0 => self.start,
            Some(end) if elapsed >= duration => end,
            Some(_) | None => self.solution.state(elapsed),
        };
        self.sample_of(state, elapsed.min(duration).max(0.0))
    }

    fn sample_of(&self, state: State, elapsed: f64) -> Sample {
        self.origin
            .sample(self.solution.sample(&self.hoop, state, elapsed))
    }

    /// The first sample.
    pub fn first(&self) -> Sample {
        self.relative_sample(0.0)
    }

    /// The last sample, before the transition that ends the phase; none for an endless phase.
    pub fn last(&self) -> Option<Sample> {
        // A phase may be shorter than the last digit of the time.
        self.end
            .map(|end| self.sample_of(end, self.relative_duration()))
    }
}

/// A simulated motion.
#[derive(Clone, Debug)]
pub struct Trajectory {
    pub(crate) hoop: Hoop,
    pub(crate) origin: Origin,
    pub(crate) start: State,
    /// The start relative to the origin.
    pub(crate) relative: State,
    pub(crate) phases: Vec<Phase>,
    pub(crate) transitions: Vec<Transition>,
    /// Relative to the origin.
    pub(crate) outcome: Outcome,
    pub(crate) summary: Summary,
}

getters! {
    Trajectory, [self]:
    /// The hoop.
    pub hoop: &Hoop = &self.hoop;
    /// The start.
    pub start: State = self.start;
    /// The phases in order; empty if no motion, or more than one, is consistent at the start.
    pub phases: &[Phase] = self.phases.as_slice();
    /// The transitions in order. Each ends a phase, except a jam from a state without a consistent
    /// motion;
    /// [`Trajectory::end_of`] returns the transition of a phase.
    pub transitions: &[Transition] = self.transitions.as_slice();
    /// The summary.
    pub summary: Summary = self.summary;
}

impl Trajectory {
    /// The outcome.
    pub fn outcome(&self) -> Outcome {
        self.origin.outcome(self.outcome)
    }

    /// The transition that ends a phase; none for a last phase that is endless or cut at a limit.
    pub fn end_of(&self, phase: &Phase) -> Option<&Transition> {
        self.transitions.get(phase.ended_by?)
    }

    /// The transitions between the phase before an index and that at it: the one that ends the
    /// former, and jams to which it leads, or with which the motion begins. With the number of
    /// phases, those after the last.
    pub fn leading_to(&self, index: usize) -> &[Transition] {
        let end = |index: usize| {
            let phase = self.phases.get(index);
            phase
                .and_then(|phase| phase.ended_by)
                .unwrap_or(self.transitions.len())
        };
        &self.transitions[index.checked_sub(1).map_or(0, end)..end(index)]
    }

    /// Time at the end of the motion; infinite if the motion is endless and has no time limit.
    pub fn end_time(&self) -> f64 {
        self.phases.last().map_or(self.start.time, Phase::end_time)
    }

    /// Energy lost to friction, rolling resistance and impacts.
    pub fn energy_lost(&self) -> f64 {
        self.phases.iter().map(Phase::energy_lost).sum::<f64>() + self.impact_energy_lost()
    }

    /// Energy lost to rolling resistance, but for impacts.
    pub fn rolling_resistance_energy_lost(&self) -> f64 {
        self.phases
            .iter()
            .map(Phase::rolling_resistance_energy_lost)
            .sum()
    }

    /// Energy lost in impacts.
    pub fn impact_energy_lost(&self) -> f64 {
        self.transitions
            .iter()
            .filter_map(|transition| transition.impact)
            // The sum of nothing would be −0.
            .fold(0.0, |sum, impact| sum + impact.energy_lost())
    }

    /// The sample at `time`, in O(log n) of the number of phases and steps; none outside the
    /// motion. At a transition it is the first sample of the next phase.
    pub fn at(&self, time: f64) -> Option<Sample> {
        if !(time.is_finite() && time >= self.start.time && time <= self.end_time()) {
            return None;
        }
        let after = self
            .phases
            .partition_point(|phase| phase.start().time <= time);
        Some(self.phases.get(after.checked_sub(1)?)?.at(time))
    }

    /// Up to when a picture shows a motion that rests for ever: a tenth longer than the hoop took to
    /// stop, so that one sees that it stays; ten units of time of a hoop that never moved. None for
    /// other motions.
    pub fn rest_shown_until(&self) -> Option<f64> {
        let Outcome::Rests { since, .. } = self.outcome() else {
            return None;
        };
        let moved = since.time - self.start.time;
        Some(since.time + if moved > 0.0 { 0.1 * moved } else { 10.0 })
    }

    /// The only sample of a motion without a phase: the state and its energy at the start.
    /// Accelerations and forces are NaN, and the mode is meaningless. None for a motion with a
    /// phase.
    pub fn only_instant(&self) -> Option<Sample> {
        let instant = Instant {
            mode: Mode::Rolling,
            direction: None,
            accelerations: Accelerations {
                theta: f64::NAN,
                slip: f64::NAN,
            },
            forces: ContactForces {
                normal: f64::NAN,
                friction: f64::NAN,
            },
            couple: f64::NAN,
            clearance: Clearance::NONE,
        };
        self.phases.is_empty().then(|| {
            self.origin
                .sample(instant.sample(&self.hoop, self.relative))
        })
    }

    /// `count` evenly spaced samples from the start to `until`, or to the end if that comes first.
    /// Every transition in between adds two samples, the last of the phase that ends and the first
    /// of the phase that begins, because the forces may jump.
    pub fn sample_evenly(&self, count: usize, until: f64) -> impl Iterator<Item = Sample> + '_ {
        // Times are relative to the start.
        let last = self.phases.last().map_or(0.0, Phase::last_instant);
        let end = if until < self.end_time() {
            self.origin.elapsed(until)
        } else {
            last
        };
        let intervals = count.saturating_sub(1).max(1);
        let grid = move |i: usize| {
            if i == intervals {
                end
            } else {
                end * (i as f64 / intervals as f64)
            }
        };
        // Number of grid points before a time.
        let before = move |time: f64| {
            let (mut low, mut high) = (0, count);
            while low < high {
                let middle = usize::midpoint(low, high);
                if grid(middle) < time {
                    low = middle + 1;
                } else {
                    high = middle;
                }
            }
            low
        };
        let last = self.phases.len().saturating_sub(1);
        self.phases
            .iter()
            .enumerate()
            .take_while(move |(i, phase)| *i == 0 || phase.start.time <= end)
            .flat_map(move |(index, phase)| {
                let (start, stop) = (phase.start.time, phase.last_instant());
                let first = (index > 0).then(|| phase.first());
                // Skips a grid point that coincides with a transition.
                let from = before(start)
                    + usize::from(
                        index > 0 && before(start) < count && grid(before(start)) == start,
                    );
                let to = if index == last { count } else { before(stop) };
                let between =
                    (from..to.max(from)).map(move |i| phase.relative_sample(grid(i) - start));
                let final_instant = phase.last().filter(|_| index < last && stop <= end);
                first.into_iter().chain(between).chain(final_instant)
            })
    }
}
