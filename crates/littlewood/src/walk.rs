//! The walk of a motion along the automaton: one phase after the other, each solved by a [`Solver`], told to a
//! [`Recorder`].
//!
//! There is one loop and one decision on what follows, whether the phases are solved exactly or looked up in tables, and
//! whether a trajectory is kept or a summary. What the engine does can therefore differ from what the simulation does
//! only where a solver of a phase differs.

use core::f64::consts::TAU;

use crate::automaton::Cause;
use crate::candidates::{Arrival, Next};
use crate::flight::{Flight, TakeOff};
use crate::hoop::{Body, Heavy, Hoop, Massless};
use crate::impact::{Contact, ContactVelocities, Impact};
use crate::mode::{Direction, Mode};
use crate::outcome::Outcome;
use crate::rolling::Recurrence;
use crate::settling::Settling;
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

    fn hoop(&self) -> &Hoop;
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
    fn fly(&self, place: &Self::Place, body: &Heavy, take_off: TakeOff) -> SolvedBy<Self>;
    /// Bounces without number.
    fn settle(&self, place: &Self::Place, body: &Heavy, settling: &Settling) -> SolvedBy<Self>;
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
    /// By the landing of the rim.
    Landing { place: P, gap_rate: f64 },
    /// By the end of bounces.
    Settled { place: P, settling: Box<Settling> },
    /// By P = 0 in a slide, with P there.
    Singular { place: P, solvability: f64 },
    /// With the motion: `event` is its last transition, if there is one, `end` the state at the end of the phase, if
    /// it has one.
    Motion { event: Option<(Cause, State)>, end: Option<State>, verdict: V },
}

/// Records the phases and transitions of a motion.
pub(crate) trait Recorder<S> {
    /// A phase in a mode, from a state to a state, or without end.
    fn phase(&mut self, phase: PhaseSeen, solution: S);
    /// The transition that ends the last phase.
    fn transition(&mut self, transition: &Transition);
}

/// A phase as it is passed to a recorder.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PhaseSeen {
    pub(crate) mode: Mode,
    pub(crate) direction: Option<Direction>,
    pub(crate) start: State,
    pub(crate) end: Option<State>,
}

/// What begins.
enum Begin {
    /// A motion that was decided on.
    Motion(Next),
    /// Bounces that accumulate.
    Settle(Heavy, Box<Settling>),
}

/// What follows an event: the transition, of which the direction of the phase behind it is not yet known, where it leads,
/// and what begins there.
struct Follows<P> {
    transition: Transition,
    place: P,
    begin: Begin,
}

/// Walks from a start, which leaves the plane at `gap_rate`, to the end of the motion, or to a limit.
///
/// `transitions` is the largest number of transitions; `conservative` says that the hoop is without friction and the
/// time without limit, so that a motion that only reverses its slip is followed for one period.
pub(crate) fn walk<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    (start, gap_rate): (State, f64),
    transitions: usize,
    conservative: bool,
    recorder: &mut R,
) -> T::Verdict {
    let mut place = solver.place(start);
    let mut begin = match solver.hoop().body() {
        Body::Heavy(body) if gap_rate > 0.0 => rise(solver, &body, &start, gap_rate),
        Body::Heavy(_) | Body::Massless(_) => Begin::Motion(solver.decide(&place, Arrival::Open)),
    };
    let mut pending: Option<Transition> = None;
    let mut reversals = Reversals::default();
    let mut count = 0;
    loop {
        let state = T::state(&place);
        let mut range = None;
        let follows = 'event: {
            let (mode, solved) = match &begin {
                Begin::Motion(Next::Roll) => (Mode::Rolling, solver.roll(&place)),
                Begin::Motion(Next::Slide { body, direction, slip_acceleration }) => {
                    (Mode::Sliding, solver.slide(&place, body, *direction, *slip_acceleration))
                }
                Begin::Motion(Next::Fly { body, take_off }) => {
                    (Mode::Flight, solver.fly(&place, body, *take_off))
                }
                Begin::Motion(Next::Glide { body, from_extremum }) => {
                    (Mode::Gliding, solver.glide(&place, body, *from_extremum))
                }
                Begin::Settle(body, settling) => (Mode::Flight, solver.settle(&place, body, settling)),
                Begin::Motion(Next::None(candidates)) => {
                    flush(recorder, &mut pending, None);
                    match jam(solver, None, &place) {
                        Some(follows) => break 'event follows,
                        None => return Outcome::Inconsistent { state, candidates: *candidates }.into(),
                    }
                }
                Begin::Motion(Next::Several(candidates)) => {
                    flush(recorder, &mut pending, None);
                    return Outcome::Ambiguous { state, candidates: *candidates }.into();
                }
            };
            let Solved { solution, direction, ending } = solved;
            flush(recorder, &mut pending, direction);
            if conservative {
                range = solution.theta_range();
            }
            let record = |end| recorder.phase(PhaseSeen { mode, direction, start: state, end }, solution);
            // Without an impact to follow, an event is the last.
            let (event, end, outcome) = match ending {
                Ending::Motion { event, end, verdict } => {
                    record(end);
                    if let Some((cause, before)) = event {
                        recorder.transition(&Transition::continuous(before, mode, None, cause));
                    }
                    return verdict;
                }
                Ending::Event { place: reached, cause, arrival } => {
                    record(Some(T::state(&reached)));
                    break 'event continues(solver, (mode, direction), reached, cause, arrival);
                }
                Ending::Settled { place: reached, settling } => {
                    record(Some(T::state(&reached)));
                    break 'event settles(solver, &reached, &settling);
                }
                Ending::Landing { place: reached, gap_rate } => {
                    let end = T::state(&reached);
                    record(Some(end));
                    if let Some(follows) = lands(solver, &reached, gap_rate) {
                        break 'event follows;
                    }
                    (Cause::Landing, end, Outcome::Landing { state: end, gap_rate })
                }
                Ending::Singular { place: reached, solvability } => {
                    let end = T::state(&reached);
                    record(Some(end));
                    if let Some(follows) = jam(solver, Some(mode), &reached) {
                        break 'event follows;
                    }
                    (Cause::Singularity, end, Outcome::Singular { state: end, solvability })
                }
            };
            recorder.transition(&Transition::continuous(end, mode, None, event));
            return outcome.into();
        };
        let Follows { mut transition, place: reached, begin: then } = follows;
        transition.to = then.mode();
        let (to_direction, event, end) = (then.direction(), transition.cause, transition.before);
        let (after, goes_on) = (transition.after, transition.to.is_some());
        if transition.to == Some(Mode::Gliding) {
            // The direction of a glide from rest is known only once it is followed.
            pending = Some(transition);
        } else {
            transition.direction = to_direction;
            recorder.transition(&transition);
        }
        count += 1;
        if conservative {
            let returned = reversals.add(event, end, to_direction, range);
            if let Some((since, recurrence)) = returned {
                flush(recorder, &mut pending, to_direction);
                return Outcome::SlidesForever { since, recurrence }.into();
            }
        }
        if count >= transitions && goes_on {
            flush(recorder, &mut pending, to_direction);
            return Outcome::TransitionLimit { state: after, transitions }.into();
        }
        (place, begin) = (reached, then);
    }
}

/// What follows an event without an impact.
#[inline(always)]
fn continues<T: Solver>(
    solver: &T,
    (mode, direction): (Mode, Option<Direction>),
    place: T::Place,
    cause: Cause,
    arrival: Arrival,
) -> Follows<T::Place> {
    let begin = Begin::Motion(solver.decide(&place, arrival));
    // Only now is it known what coming to rest leads to.
    let goes_on = begin.mode().is_some_and(|to| to != Mode::Rolling);
    let cause = if cause == Cause::Stick && goes_on {
        let same = begin.direction().is_some() && begin.direction() == direction;
        if same { Cause::Graze } else { Cause::Reversal }
    } else {
        cause
    };
    Follows { transition: Transition::continuous(T::state(&place), mode, None, cause), place, begin }
}

/// What follows a landing of a hoop with restitution.
fn lands<T: Solver>(solver: &T, place: &T::Place, gap_rate: f64) -> Option<Follows<T::Place>> {
    let hoop = solver.hoop();
    let (Body::Heavy(body), Some(restitution)) = (hoop.body(), hoop.restitution()) else { return None };
    let state = T::state(place);
    // The gap comes from above: where it touches without crossing, its rate may round to a positive number.
    let before = velocities(&state, gap_rate.min(0.0));
    let impact = Contact::new(hoop, &body, state.theta).impact(before, restitution);
    let transition = Transition::by_impact(state, Some(Mode::Flight), impact, Cause::Landing);
    Some(rebounds(solver, &body, transition))
}

/// What follows P ≤ 0 with slip left, for a hoop with restitution.
fn jam<T: Solver>(solver: &T, from: Option<Mode>, place: &T::Place) -> Option<Follows<T::Place>> {
    let hoop = solver.hoop();
    let (Body::Heavy(body), Some(restitution)) = (hoop.body(), hoop.restitution()) else { return None };
    let state = T::state(place);
    let direction = Direction::of_sign(state.slip)?;
    let contact = Contact::new(hoop, &body, state.theta);
    let runs_into_it = from.is_some();
    if !(runs_into_it || contact.jams(direction)) {
        return None;
    }
    let impact = contact.jam(velocities(&state, 0.0), restitution);
    Some(rebounds(solver, &body, Transition::by_impact(state, from, impact, Cause::Jam)))
}

/// What follows the end of bounces.
fn settles<T: Solver>(solver: &T, place: &T::Place, settling: &Settling) -> Follows<T::Place> {
    let state = T::state(place);
    // The flight has turned the hoop by so little that the sum took the angle for fixed: the last digits of the slip differ.
    let before = velocities(&state, settling.impact.before.gap_rate);
    let impact = Impact { before, ..settling.impact };
    let transition = Transition::by_impact(state, Some(Mode::Flight), impact, Cause::Settle);
    let place = solver.place(transition.after);
    let begin = Begin::Motion(solver.decide(&place, Arrival::Open));
    Follows { transition, place, begin }
}

/// What follows an impact: a flight, if the gap opens.
fn rebounds<T: Solver>(solver: &T, body: &Heavy, transition: Transition) -> Follows<T::Place> {
    let place = solver.place(transition.after);
    let opening = transition.impact.map_or(0.0, |impact| impact.after.gap_rate);
    let begin = if opening > 0.0 {
        rise(solver, body, &transition.after, opening)
    } else {
        Begin::Motion(solver.decide(&place, Arrival::Open))
    };
    Follows { transition, place, begin }
}

/// A gap that opens: bounces that settle, where they are short enough, and else a flight.
fn rise<T: Solver>(solver: &T, body: &Heavy, state: &State, gap_rate: f64) -> Begin {
    let hoop = solver.hoop();
    let settling =
        hoop.restitution().and_then(|restitution| hoop.short_settling(body, state, gap_rate, restitution));
    match settling {
        Some(settling) => Begin::Settle(*body, Box::new(settling)),
        None => Begin::Motion(Next::Fly { body: *body, take_off: TakeOff::Rising { gap_rate } }),
    }
}

const fn velocities(state: &State, gap_rate: f64) -> ContactVelocities {
    ContactVelocities { theta_rate: state.theta_rate, slip: state.slip, gap_rate }
}

/// Passes the pending transition to the recorder.
#[inline]
fn flush<S>(recorder: &mut impl Recorder<S>, pending: &mut Option<Transition>, direction: Option<Direction>) {
    if let Some(transition) = pending {
        transition.direction = direction;
        recorder.transition(transition);
        *pending = None;
    }
}

impl Begin {
    /// The mode that begins.
    const fn mode(&self) -> Option<Mode> {
        match self {
            Self::Motion(Next::Roll) => Some(Mode::Rolling),
            Self::Motion(Next::Slide { .. }) => Some(Mode::Sliding),
            Self::Motion(Next::Glide { .. }) => Some(Mode::Gliding),
            Self::Motion(Next::Fly { .. }) | Self::Settle(..) => Some(Mode::Flight),
            Self::Motion(Next::None(_) | Next::Several(_)) => None,
        }
    }

    /// The direction of slip, where it is known before the motion is followed.
    const fn direction(&self) -> Option<Direction> {
        match self {
            Self::Motion(Next::Slide { direction, .. }) => Some(*direction),
            Self::Motion(
                Next::Roll | Next::Glide { .. } | Next::Fly { .. } | Next::None(_) | Next::Several(_),
            )
            | Self::Settle(..) => None,
        }
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
