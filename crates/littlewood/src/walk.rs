//! The walk of a motion along the automaton: one phase after the other, each solved by a [`Solver`], told to a
//! [`Recorder`].
//!
//! There is one loop and one decision on what follows, whether the phases are solved exactly or looked up in tables, and
//! whether a trajectory is kept or a summary. What the engine does can therefore differ from what the simulation does
//! only where a solver of a phase differs.

use core::f64::consts::TAU;

use crate::automaton::Cause;
use crate::candidates::{Arrival, Next};
use crate::flight::Flight;
use crate::hoop::{Heavy, Massless};
use crate::mode::{Direction, Mode};
use crate::outcome::Outcome;
use crate::rolling::Recurrence;
use crate::state::State;
use crate::transition::Transition;

/// Two states of a conservative orbit that differ by no more are the same but for rounding.
const SAME_STATE: f64 = 1e-9;

/// Solves phases of motion, each from the place where it begins to the event that ends it, or to the time limit.
pub(crate) trait Solver {
    /// A state, with what the solver has computed for it.
    type Place;
    /// The solution of a phase.
    type Solution: Solution;
    /// How the motion ended.
    type Verdict: From<Outcome>;

    fn place(&self, state: State) -> Self::Place;
    fn state(place: &Self::Place) -> State;
    /// Which motion follows.
    fn decide(&self, place: &Self::Place, arrival: Arrival) -> Next;
    fn roll(&self, place: &Self::Place) -> SolvedBy<Self>;
    /// `slip_acceleration` where η′ = 0 at the start.
    fn slide(
        &self,
        place: &Self::Place,
        body: &Heavy,
        direction: Direction,
        slip_acceleration: Option<f64>,
    ) -> SolvedBy<Self>;
    /// `grazing` where the normal force has just vanished.
    fn fly(&self, place: &Self::Place, body: &Heavy, grazing: bool) -> SolvedBy<Self>;
    /// `from_extremum` where η″ = 0 at the start.
    fn glide(&self, place: &Self::Place, body: &Massless, from_extremum: bool) -> SolvedBy<Self>;
}

/// Properties of a solved phase, exact or tabulated.
pub(crate) trait Solution {
    /// The flight, if it is one.
    fn flight(&self) -> Option<&Flight>;
    /// Smallest and largest angle of a slide.
    fn theta_range(&self) -> Option<(f64, f64)>;
}

/// A phase that has been solved.
pub(crate) struct Solved<S, P, V> {
    pub(crate) solution: S,
    /// Direction of slip, which for a glide from η′ = 0 only its solution tells.
    pub(crate) direction: Option<Direction>,
    pub(crate) ending: Ending<P, V>,
}

pub(crate) type SolvedBy<T> = Solved<<T as Solver>::Solution, <T as Solver>::Place, <T as Solver>::Verdict>;

/// How a phase ends.
pub(crate) enum Ending<P, V> {
    /// By an event after which the motion goes on.
    Event { place: P, cause: Cause, arrival: Arrival },
    /// With the motion: `event` is its last transition, if there is one, `end` the state at the end of the phase, if
    /// it has one.
    Motion { event: Option<(Cause, State)>, end: Option<State>, verdict: V },
}

/// Records the phases and transitions of a motion.
pub(crate) trait Recorder<S> {
    /// A phase in a mode, from a state to a state, or without end.
    fn phase(&mut self, phase: PhaseSeen, solution: S);
    /// The transition that ends the last phase.
    fn transition(&mut self, transition: Transition);
}

/// A phase as it is passed to a recorder.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PhaseSeen {
    pub(crate) mode: Mode,
    pub(crate) direction: Option<Direction>,
    pub(crate) start: State,
    pub(crate) end: Option<State>,
}

/// Walks from a start to the end of the motion, or to a limit.
///
/// `transitions` is the largest number of transitions; `conservative` says that the hoop is without friction and the
/// time without limit, so that a motion that only reverses its slip is followed for one period.
pub(crate) fn walk<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    start: State,
    transitions: usize,
    conservative: bool,
    recorder: &mut R,
) -> T::Verdict {
    let mut place = solver.place(start);
    let mut next = solver.decide(&place, Arrival::Open);
    let mut pending: Option<Pending> = None;
    let mut reversals = Reversals::default();
    let mut count = 0;
    loop {
        let state = T::state(&place);
        let (mode, solved) = match next {
            Next::Roll => (Mode::Rolling, solver.roll(&place)),
            Next::Slide { body, direction, slip_acceleration } => {
                (Mode::Sliding, solver.slide(&place, &body, direction, slip_acceleration))
            }
            Next::Fly { body, grazing } => (Mode::Flight, solver.fly(&place, &body, grazing)),
            Next::Glide { body, from_extremum } => {
                (Mode::Gliding, solver.glide(&place, &body, from_extremum))
            }
            Next::None(candidates) => {
                flush(recorder, &mut pending, None);
                return Outcome::Inconsistent { state, candidates }.into();
            }
            Next::Several(candidates) => {
                flush(recorder, &mut pending, None);
                return Outcome::Ambiguous { state, candidates }.into();
            }
        };
        let Solved { solution, direction, ending } = solved;
        flush(recorder, &mut pending, direction);
        let range = if conservative { solution.theta_range() } else { None };
        match ending {
            Ending::Motion { event, end, verdict } => {
                recorder.phase(PhaseSeen { mode, direction, start: state, end }, solution);
                if let Some((cause, before)) = event {
                    recorder.transition(Transition::continuous(before, mode, None, None, cause));
                }
                return verdict;
            }
            Ending::Event { place: reached, cause, arrival } => {
                let end = T::state(&reached);
                recorder.phase(PhaseSeen { mode, direction, start: state, end: Some(end) }, solution);
                next = solver.decide(&reached, arrival);
                let begins = mode_of(&next);
                let to_direction = direction_of(&next);
                // Only now is it known what coming to rest leads to.
                let goes_on = begins.is_some_and(|to| to != Mode::Rolling);
                let cause = if cause == Cause::Stick && goes_on {
                    let same = to_direction.is_some() && to_direction == direction;
                    if same { Cause::Graze } else { Cause::Reversal }
                } else {
                    cause
                };
                pending = Some(Pending { state: end, from: mode, to: begins, cause });
                count += 1;
                if conservative {
                    let returned = reversals.add(cause, end, to_direction, range);
                    if let Some((since, recurrence)) = returned {
                        flush(recorder, &mut pending, to_direction);
                        return Outcome::SlidesForever { since, recurrence }.into();
                    }
                }
                if count >= transitions && begins.is_some() {
                    flush(recorder, &mut pending, to_direction);
                    return Outcome::TransitionLimit { state: end, transitions }.into();
                }
                place = reached;
            }
        }
    }
}

/// A transition of which the direction of the phase behind it is not yet known.
struct Pending {
    state: State,
    from: Mode,
    to: Option<Mode>,
    cause: Cause,
}

/// Passes the pending transition to the recorder.
#[inline]
fn flush<S>(recorder: &mut impl Recorder<S>, pending: &mut Option<Pending>, direction: Option<Direction>) {
    if let Some(Pending { state, from, to, cause }) = pending.take() {
        recorder.transition(Transition::continuous(state, from, to, direction, cause));
    }
}

/// The mode that begins.
const fn mode_of(next: &Next) -> Option<Mode> {
    match next {
        Next::Roll => Some(Mode::Rolling),
        Next::Slide { .. } => Some(Mode::Sliding),
        Next::Glide { .. } => Some(Mode::Gliding),
        Next::Fly { .. } => Some(Mode::Flight),
        Next::None(_) | Next::Several(_) => None,
    }
}

/// The direction of slip of the motion that begins, where that is known before it is followed.
const fn direction_of(next: &Next) -> Option<Direction> {
    match next {
        Next::Slide { direction, .. } => Some(*direction),
        Next::Roll | Next::Glide { .. } | Next::Fly { .. } | Next::None(_) | Next::Several(_) => None,
    }
}

/// The reversals of a motion without any friction. Energy and horizontal momentum are conserved through them, and the
/// orbit of (θ, θ′) is closed: once a reversal comes back to the place of an earlier one, a whole period has passed,
/// and the motion repeats itself.
#[derive(Debug, Default)]
struct Reversals(Vec<Reversal>);

#[derive(Clone, Copy, Debug)]
struct Reversal {
    state: State,
    direction: Option<Direction>,
    /// Angles of the slide that it ends.
    range: (f64, f64),
}

impl Reversals {
    /// Adds an event; the state since which the motion recurs, and how, if it has come back.
    fn add(
        &mut self,
        cause: Cause,
        state: State,
        direction: Option<Direction>,
        range: Option<(f64, f64)>,
    ) -> Option<(State, Recurrence)> {
        let (Cause::Reversal, Some(range)) = (cause, range) else {
            self.0.clear();
            return None;
        };
        let same = |a: f64, b: f64| (a - b).abs() <= SAME_STATE * (1.0 + a.abs());
        let back = self.0.iter().rposition(|earlier| {
            let turned = (state.theta - earlier.state.theta) / TAU;
            direction == earlier.direction
                && same(earlier.state.theta_rate, state.theta_rate)
                && same(turned.round() * TAU + earlier.state.theta, state.theta)
        });
        self.0.push(Reversal { state, direction, range });
        let back = back?;
        let since = self.0[back].state;
        let period = state.time - since.time;
        let recurrence = if (state.theta - since.theta).abs() > 1.0 {
            Recurrence::Rotation { period }
        } else {
            let (theta_min, theta_max) = self.0[back + 1..]
                .iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), reversal| {
                    (low.min(reversal.range.0), high.max(reversal.range.1))
                });
            Recurrence::Libration { period, theta_min, theta_max }
        };
        Some((since, recurrence))
    }
}
