//! The simulation: one phase after the other, along the edges of the automaton.

use core::f64::consts::TAU;

use crate::automaton::Cause;
use crate::candidates::{Arrival, Next, next_motion};
use crate::error::{Bound, ParameterError, within};
use crate::flight::Flight;
use crate::gliding::{Gliding, GlidingEnd};
use crate::hoop::{Heavy, Hoop, Massless};
use crate::mode::{Direction, Mode};
use crate::outcome::Outcome;
use crate::quantity::Quantity;
use crate::rolling::{Recurrence, Rolling};
use crate::sliding::{Entry, Sliding, SlidingEnd, SlidingLaw};
use crate::state::{Start, State};
use crate::trajectory::{Phase, PhaseSolution, Trajectory, Transition};

/// Two states of a conservative orbit that differ by no more are the same but for rounding.
const RETURN: f64 = 1e-9;

/// When to stop a motion that has not come to its end.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Limits {
    /// Time τ at which to stop, if any. A motion that is proved to roll for ever is reported as such all the same.
    pub until: Option<f64>,
    /// Largest number of transitions. Only μs = μk needs it: there slips can shrink without end towards the orbit
    /// that grazes the static limit.
    pub transitions: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self { until: None, transitions: 10_000 }
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
}

/// What a phase leads to.
enum Follow {
    /// An event, the state there and what is known of it.
    Event(State, Cause, Arrival),
    /// Lift-off: the only motion that follows is flight.
    Lift(State, Heavy),
    /// The end of the simulation, by an event or not.
    End(Option<Cause>, Outcome),
}

impl Hoop {
    /// Simulates the motion from `start` to its end, or to a limit.
    ///
    /// Every transition is located to the last digits; none is missed. The result is the same on every platform,
    /// bit for bit.
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
        let checked = start.check()?;
        limits.check(&start)?;
        let start = checked;
        let mut trajectory = Trajectory {
            hoop: *self,
            start,
            phases: Vec::new(),
            transitions: Vec::new(),
            outcome: Outcome::TimeLimit { state: start },
        };
        trajectory.outcome = Run { hoop: *self, limits, trajectory: &mut trajectory }.run(start);
        Ok(trajectory)
    }
}

struct Run<'a> {
    hoop: Hoop,
    limits: Limits,
    trajectory: &'a mut Trajectory,
}

impl Run<'_> {
    fn run(&mut self, start: State) -> Outcome {
        let mut state = start;
        let mut next = next_motion(&self.hoop, &state, Arrival::Open);
        loop {
            let (motion, end, follow) = match next {
                Next::None(candidates) => return Outcome::Inconsistent { state, candidates },
                Next::Several(candidates) => return Outcome::Ambiguous { state, candidates },
                Next::Roll => self.roll(state),
                Next::Slide { body, direction, slip_acceleration } => {
                    self.slide(&body, state, direction, slip_acceleration)
                }
                Next::Fly { body, grazing } => self.fly(&body, state, grazing),
                Next::Glide { body, from_extremum } => self.glide(&body, state, from_extremum),
            };
            let phase = Phase { hoop: self.hoop, motion, start: state, end };
            let (from, before) = (phase.mode(), phase.direction());
            if let (Mode::Gliding, Some(transition)) = (from, self.trajectory.transitions.last_mut()) {
                // The direction of a glide that begins at η′ = 0 follows from the glide.
                transition.direction = before;
            }
            self.trajectory.phases.push(phase);
            let (end, cause, arrival) = match follow {
                Follow::Event(end, cause, arrival) => (end, cause, arrival),
                Follow::Lift(end, body) => {
                    next = Next::Fly { body, grazing: true };
                    self.record(end, from, begins(&next), Cause::LiftOff);
                    state = end;
                    continue;
                }
                Follow::End(cause, outcome) => {
                    if let Some(cause) = cause {
                        self.record(outcome.state(), from, None, cause);
                    }
                    return outcome;
                }
            };
            next = next_motion(&self.hoop, &end, arrival);
            let begins = begins(&next);
            // Only now is it known what coming to rest leads to.
            let cause = match (cause, begins) {
                (Cause::Stick, Some((mode, direction))) if mode != Mode::Rolling => {
                    if direction.is_some() && direction == before { Cause::Graze } else { Cause::Reversal }
                }
                _ => cause,
            };
            self.record(end, from, begins, cause);
            if let Some(outcome) = self.frictionless_period() {
                return outcome;
            }
            if self.trajectory.transitions.len() >= self.limits.transitions && begins.is_some() {
                return Outcome::TransitionLimit { state: end, transitions: self.limits.transitions };
            }
            state = end;
        }
    }

    /// Without any friction the slip may reverse for ever. Energy and horizontal momentum are then conserved through
    /// the reversals, and the orbit of (θ, θ′) is closed: once a reversal comes back to the place of an earlier one,
    /// a whole period has passed, and nothing new can happen. The trajectory ends there.
    fn frictionless_period(&self) -> Option<Outcome> {
        let (latest, earlier) = self.trajectory.transitions.split_last()?;
        if self.hoop.mu_s() > 0.0 || self.limits.until.is_some() || latest.cause != Cause::Reversal {
            return None;
        }
        let same = |a: f64, b: f64| (a - b).abs() <= RETURN * (1.0 + a.abs());
        let back = earlier.iter().rev().take_while(|t| t.cause == Cause::Reversal).find(|t| {
            let turned = (latest.before.theta - t.before.theta) / TAU;
            t.direction == latest.direction
                && same(t.before.theta_rate, latest.before.theta_rate)
                && same(turned.round() * TAU + t.before.theta, latest.before.theta)
        })?;
        let period = latest.before.time - back.before.time;
        let gained = latest.before.theta - back.before.theta;
        let recurrence = if gained.abs() > 1.0 {
            Recurrence::Rotation { period }
        } else {
            let cycle = self.trajectory.phases.iter().filter(|phase| phase.start().time >= back.before.time);
            let (theta_min, theta_max) =
                cycle.fold((f64::INFINITY, f64::NEG_INFINITY), |(min, max), phase| {
                    let PhaseSolution::Sliding(slide) = phase.motion() else { return (min, max) };
                    let (low, high) = slide.theta_range();
                    (min.min(low), max.max(high))
                });
            Recurrence::Libration { period, theta_min, theta_max }
        };
        Some(Outcome::SlidesForever { since: back.before, recurrence })
    }

    fn record(&mut self, state: State, from: Mode, begins: Option<(Mode, Option<Direction>)>, cause: Cause) {
        let (to, direction) = begins.map_or((None, None), |(mode, direction)| (Some(mode), direction));
        self.trajectory.transitions.push(Transition {
            before: state,
            after: state,
            impulse: None,
            from,
            to,
            direction,
            cause,
        });
    }

    /// Time left until the limit.
    fn allowed(&self, state: &State) -> Option<f64> {
        self.limits.until.map(|until| until - state.time)
    }

    /// A state at the time limit, with just the time that was asked for.
    fn stopped(&self, state: State) -> State {
        State { time: self.limits.until.unwrap_or(state.time), ..state }
    }

    fn roll(&self, state: State) -> (PhaseSolution, Option<State>, Follow) {
        let rolling = Rolling::new(&self.hoop, state);
        let allowed = self.allowed(&state);
        let (end, follow) = match (rolling.orbit().end(), allowed) {
            (Some(end), allowed) if allowed.is_none_or(|allowed| end.elapsed <= allowed) => {
                let state = rolling.state_at(end.theta, end.theta_rate, end.elapsed);
                (Some(state), Follow::Event(state, end.limit.cause(), Arrival::RollingLimit(end.limit)))
            }
            (Some(_), allowed) => {
                let end = self.stopped(rolling.state(allowed.unwrap_or(0.0)));
                (Some(end), Follow::End(None, Outcome::TimeLimit { state: end }))
            }
            (None, allowed) => {
                let recurrence = rolling.orbit().recurrence();
                let end = allowed.map(|allowed| self.stopped(rolling.state(allowed)));
                (end, Follow::End(None, Outcome::RollsForever { since: state, recurrence }))
            }
        };
        (PhaseSolution::Rolling(rolling), end, follow)
    }

    fn slide(
        &self,
        body: &Heavy,
        state: State,
        direction: Direction,
        slip_acceleration: Option<f64>,
    ) -> (PhaseSolution, Option<State>, Follow) {
        let entry = slip_acceleration
            .map_or(Entry::Moving, |slip_acceleration| Entry::FromRest { slip_acceleration });
        let (slide, end) = Sliding::run(&self.hoop, body, state, direction, entry, self.allowed(&state));
        let (end, follow) = match end {
            SlidingEnd::Rest(end) => (Some(end), Follow::Event(end, Cause::Stick, Arrival::Open)),
            SlidingEnd::LiftOff(end) => (Some(end), Follow::Lift(end, *body)),
            SlidingEnd::Singular(end) => {
                let solvability = SlidingLaw::new(&self.hoop, body, direction).solvability(end.theta);
                (
                    Some(end),
                    Follow::End(Some(Cause::Singularity), Outcome::Singular { state: end, solvability }),
                )
            }
            SlidingEnd::Unresolved(end) => (Some(end), Follow::End(None, Outcome::Unresolved { state: end })),
            SlidingEnd::TimeLimit(end) => {
                let end = self.stopped(end);
                (Some(end), Follow::End(None, Outcome::TimeLimit { state: end }))
            }
            SlidingEnd::Endless(recurrence) => {
                let end = self.allowed(&state).map(|allowed| self.stopped(slide.state(allowed)));
                (end, Follow::End(None, Outcome::SlidesForever { since: state, recurrence }))
            }
        };
        (PhaseSolution::Sliding(Box::new(slide)), end, follow)
    }

    fn fly(&self, body: &Heavy, state: State, grazing: bool) -> (PhaseSolution, Option<State>, Follow) {
        let flight = Flight::new(body, state, grazing);
        let duration = flight.duration();
        let (end, follow) = match self.allowed(&state) {
            Some(allowed) if allowed < duration => {
                let end = self.stopped(flight.state(allowed));
                (Some(end), Follow::End(None, Outcome::TimeLimit { state: end }))
            }
            _ => {
                let end = flight.state(duration);
                let gap_rate = flight.gap(duration).1;
                (Some(end), Follow::End(Some(Cause::Landing), Outcome::Landing { state: end, gap_rate }))
            }
        };
        (PhaseSolution::Flight(flight), end, follow)
    }

    fn glide(
        &self,
        body: &Massless,
        state: State,
        from_extremum: bool,
    ) -> (PhaseSolution, Option<State>, Follow) {
        let (glide, end) = Gliding::run(body, self.hoop.mu_k(), state, from_extremum, self.allowed(&state));
        let (end, follow) = match end {
            GlidingEnd::Rest(end) => (Some(end), Follow::Event(end, Cause::Stick, Arrival::Open)),
            GlidingEnd::Bottom(end) if body.offset < 1.0 => (
                Some(end),
                Follow::End(Some(Cause::ParticleAtBottom), Outcome::ParticleAtBottom { state: end }),
            ),
            GlidingEnd::Bottom(end) => (
                Some(end),
                Follow::End(Some(Cause::ParticleAtPlane), Outcome::ParticleAtPlane { state: end }),
            ),
            GlidingEnd::Top(end) => {
                (Some(end), Follow::End(Some(Cause::ParticleAtTop), Outcome::ParticleAtTop { state: end }))
            }
            GlidingEnd::TimeLimit(end) => {
                let end = self.stopped(end);
                (Some(end), Follow::End(None, Outcome::TimeLimit { state: end }))
            }
        };
        (PhaseSolution::Gliding(glide), end, follow)
    }
}

/// The mode that begins, with its direction of slip where that is known before it is followed.
fn begins(next: &Next) -> Option<(Mode, Option<Direction>)> {
    match next {
        Next::Roll => Some((Mode::Rolling, None)),
        Next::Slide { direction, .. } => Some((Mode::Sliding, Some(*direction))),
        Next::Glide { .. } => Some((Mode::Gliding, None)),
        Next::Fly { .. } => Some((Mode::Flight, None)),
        Next::None(_) | Next::Several(_) => None,
    }
}
