//! The walk of a motion along the automaton: a [`Solver`] solves each phase, and a [`Recorder`]
//! records it.
//!
//! Exact and tabulated phases, trajectories and summaries share one loop and one decision on the
//! next motion. So the engine can differ from the simulation only in the solution of a phase.

use crate::mechanics::{Contact, ContactVelocities, Impact, Settling};
use crate::model::{
    Body, Direction, Heavy, Hoop, Limits, Massless, Mode, Quantity, State, length_of_slide,
    weight_of_slides,
};
use crate::modes::{Entry, Flight, GlideEntry, RollingLimit, SlideLimit, TakeOff};
use crate::walk::{
    Arrival, Cause, Event, Known, LastSlip, NextMotion, Outcome, PhaseSequence, Proofs,
};

/// Solves phases of motion, each from its start to the event that ends it, or to the time limit.
pub(crate) trait Solver {
    /// A state with the quantities that the solver derives from it.
    type Place;
    type Solution: Solution;
    /// The outcome of a motion.
    type Verdict: From<Outcome>;

    fn hoop(&self) -> &Hoop;
    /// The time limit of the motion, or infinity.
    fn until(&self) -> f64;
    fn place(&self, state: State) -> Self::Place;
    fn state(place: &Self::Place) -> State;
    fn decide(&self, place: &Self::Place, arrival: Arrival) -> NextMotion;
    /// `on_limit` if |F| = μs N at the start and static friction holds after it.
    fn roll(&self, place: &Self::Place, on_limit: bool) -> SolvedBy<Self>;
    fn slide(
        &self,
        place: &Self::Place,
        body: &Heavy,
        direction: Direction,
        entry: Entry,
    ) -> SolvedBy<Self>;
    fn fly(&self, place: &Self::Place, body: &Heavy, take_off: TakeOff) -> SolvedBy<Self>;
    /// Infinitely many bounces.
    fn settle(&self, place: &Self::Place, body: &Heavy, settling: &Settling) -> SolvedBy<Self>;
    fn glide(&self, place: &Self::Place, body: &Massless, entry: GlideEntry) -> SolvedBy<Self>;
    /// Skips links of a chain of slips, from a slip out of rolling, if none of them provably leads
    /// to a grazing orbit. None if the phases must be solved one by one.
    fn pass_links(
        &self,
        _: &Self::Place,
        _: Direction,
        _: &ChainBudget<'_>,
    ) -> Option<ChainSegment<Self::Place>> {
        None
    }
}

/// Limits of the links that may be skipped.
pub(crate) struct ChainBudget<'a> {
    pub(crate) transitions: u32,
    pub(crate) slides: f64,
    /// Whether to record the phases, at most as many as a sequence holds.
    pub(crate) record_phases: bool,
    /// If proofs examine each state: whether a state leaves the outcome open. Once decided, the
    /// outcome is decided in all later states.
    pub(crate) open: Option<&'a dyn Fn(&State) -> bool>,
}

/// Skipped links, from a slip out of rolling to a later one.
pub(crate) struct ChainSegment<P> {
    pub(crate) place: P,
    pub(crate) direction: Direction,
    pub(crate) transitions: u32,
    pub(crate) slid: f64,
    pub(crate) phases: PhaseSequence,
}

/// What is kept of a solved phase.
pub(crate) trait Solution {
    fn flight(&self) -> Option<&Flight>;
    /// The range of the angle of a slide, where it is kept.
    fn theta_range(&self) -> Option<(f64, f64)> {
        None
    }
}

pub(crate) struct Solved<S, P, V> {
    pub(crate) solution: S,
    /// Direction of slip; for a glide from η′ = 0 it follows from the solution.
    pub(crate) direction: Option<Direction>,
    pub(crate) ending: Ending<P, V>,
}

pub(crate) type SolvedBy<T> =
    Solved<<T as Solver>::Solution, <T as Solver>::Place, <T as Solver>::Verdict>;

pub(crate) enum Ending<P, V> {
    /// An event after which the motion continues.
    Event {
        place: P,
        cause: Cause,
        arrival: Arrival,
    },
    /// The landing of the rim.
    Landing { state: State, gap_rate: f64 },
    /// The end of infinitely many bounces.
    Settled {
        state: State,
        settling: Box<Settling>,
    },
    /// P = 0 in a slide, with the computed value of P.
    Singular { state: State, solvability: f64 },
    /// The end of the motion: `event` is its last transition, `end` the state at the end of the
    /// phase, if any.
    Motion {
        event: Option<(Cause, State)>,
        end: Option<State>,
        verdict: V,
    },
}

impl<P, V> Ending<P, V> {
    pub(crate) fn state(&self, of: impl Fn(&P) -> State) -> Option<State> {
        match self {
            Self::Event { place, .. } => Some(of(place)),
            Self::Landing { state, .. }
            | Self::Settled { state, .. }
            | Self::Singular { state, .. } => Some(*state),
            Self::Motion { end, .. } => *end,
        }
    }
}

pub(crate) trait Recorder<S> {
    fn phase(&mut self, phase: PhaseRecord, solution: S);
    /// Records an event, with its impact and the direction of slip of the motion that begins. It
    /// ends the last phase if its `from` is a mode.
    fn transition(&mut self, event: &Event, impact: Option<&Impact>, direction: Option<Direction>);
    fn detail(&self) -> PhaseDetail {
        PhaseDetail::Solutions
    }
    /// Records skipped links: the number of transitions, and the phases at the current detail.
    fn links(&mut self, _transitions: u32, _phases: PhaseSequence) {}
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PhaseDetail {
    Solutions,
    /// Modes and directions of slip.
    Modes,
    /// The number of transitions only.
    Number,
}

/// A phase as passed to a recorder; `end` is `None` if the phase never ends.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PhaseRecord {
    pub(crate) mode: Mode,
    pub(crate) direction: Option<Direction>,
    pub(crate) start: State,
    pub(crate) end: Option<State>,
}

/// The current place of a motion, and the motion that begins there.
struct Current<P> {
    place: P,
    begin: NextMotion,
    /// The last slip, while the slides after it conserve energy and horizontal momentum.
    limit: Option<LastSlip>,
    /// The direction of slip, if rolling ended in this slip.
    slips: Option<Direction>,
}

impl<P> Current<P> {
    fn slipping<T: Solver<Place = P>>(solver: &T, place: P, direction: Direction) -> Self {
        let arrival = Arrival::RollingLimit(RollingLimit::Friction(direction));
        let begin = solver.decide(&place, arrival);
        let slips = begin.direction();
        Self {
            place,
            begin,
            limit: None,
            slips,
        }
    }
}

type EventWithImpact = (Event, Option<Box<Impact>>);

/// An event with an impact; the event alone if the state after it is not representable.
type Rebound = Result<EventWithImpact, Event>;

/// Walks from a start, which leaves the plane at `gap_rate`, to the end of the motion or to a
/// limit. `known` is shared data for proofs.
pub(crate) fn walk<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    (start, gap_rate): (State, f64),
    (limits, known): (&Limits, Known<'_>),
    recorder: &mut R,
) -> T::Verdict {
    let place = solver.place(start);
    let begin = match solver.hoop().body() {
        Body::Heavy(body) if gap_rate > 0.0 => rise(solver, &body, &start, gap_rate),
        Body::Heavy(_) | Body::Massless(_) => solver.decide(&place, Arrival::Start),
    };
    let mut proofs = Proofs::new(solver.hoop(), limits, known);
    if let Some(outcome) = proofs.at_start(&start, begin.mode()) {
        return outcome.into();
    }
    let limit = LastSlip::at_start(solver.hoop(), start, begin.direction());
    let mut now = Current {
        place,
        begin,
        limit,
        slips: None,
    };
    let mut pending: Option<Event> = None;
    let (mut count, mut slid) = (0, 0.0);
    let weight = weight_of_slides(solver.hoop());
    loop {
        let left = (
            limits.transitions.saturating_sub(count),
            limits.slides as f64 - slid,
        );
        let passed = pass_links(solver, &mut now, recorder, &mut proofs, left);
        (count, slid) = (count + passed.0, slid + passed.1);
        let (begins, mode) = (T::state(&now.place), now.begin.mode());
        let mut range = None;
        let (event, impact) = match follow(solver, &mut now, (recorder, &mut pending), &mut range) {
            Ok(happening) => happening,
            Err(verdict) => return verdict,
        };
        let event = Event {
            to: now.begin.mode(),
            ..event
        };
        let direction = now.begin.direction();
        if event.to == Some(Mode::Gliding) {
            // The direction of a glide from rest follows from its solution.
            pending = Some(event);
        } else {
            recorder.transition(&event, impact.as_deref(), direction);
        }
        count += 1;
        if mode == Some(Mode::Sliding) {
            slid += weight * length_of_slide(&begins, &event.state);
        }
        let state = T::state(&now.place);
        let stopped = proofs
            .at_event(&event, (&state, direction), range)
            .or_else(|| {
                let limit = if count >= limits.transitions {
                    Outcome::TransitionLimit {
                        state,
                        transitions: limits.transitions,
                    }
                } else if slid > limits.slides as f64 {
                    Outcome::StepLimit {
                        state,
                        limit: SlideLimit::All {
                            slides: limits.slides,
                        },
                    }
                } else {
                    return None;
                };
                event.to.is_some().then(|| proofs.at_limit(limit, event.to))
            });
        if let Some(outcome) = stopped {
            flush(recorder, &mut pending, direction);
            return outcome.into();
        }
    }
}

/// Skips links of a chain of slips after a slip out of rolling, within a number of transitions and
/// a length of slides. Returns the number of transitions and the length of slides skipped.
#[inline(always)]
fn pass_links<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    now: &mut Current<T::Place>,
    recorder: &mut R,
    proofs: &mut Proofs<'_>,
    (most, longest): (usize, f64),
) -> (usize, f64) {
    let (mut passed, mut slid) = (0, 0.0);
    while let (Some(direction), PhaseDetail::Modes | PhaseDetail::Number, true) =
        (now.slips, recorder.detail(), proofs.may_pass_links())
    {
        let open = |state: &State| !proofs.ends_motion(state);
        let budget = ChainBudget {
            transitions: u32::try_from(most - passed)
                .unwrap_or(u32::MAX)
                .saturating_sub(1),
            slides: longest - slid,
            record_phases: recorder.detail() == PhaseDetail::Modes,
            open: proofs.examines_each_state().then_some(&open),
        };
        let Some(segment) = solver.pass_links(&now.place, direction, &budget) else {
            break;
        };
        let ChainSegment {
            place,
            direction,
            transitions,
            slid: length,
            phases,
        } = segment;
        recorder.links(transitions, phases);
        (passed, slid) = (passed + transitions as usize, slid + length);
        proofs.skipped_to(&T::state(&place));
        *now = Current::slipping(solver, place, direction);
    }
    (passed, slid)
}

/// The next slip out of rolling, its direction, and the length of the slides before it. None if
/// another mode or an impact comes first, or a phase that `accepts` refuses.
pub(crate) fn next_slip<T: Solver>(
    solver: &T,
    slip: T::Place,
    direction: Direction,
    accepts: impl FnMut(Mode, Option<Direction>) -> bool,
) -> Option<(State, Direction, f64)> {
    let mut checker = ModeChecker {
        accepts,
        accepted: true,
        slid: 0.0,
    };
    let mut now = Current::slipping(solver, slip, direction);
    loop {
        let (_, impact) = follow(solver, &mut now, (&mut checker, &mut None), &mut None).ok()?;
        if impact.is_some() || !checker.accepted {
            return None;
        }
        if let Some(direction) = now.slips {
            let slid = weight_of_slides(solver.hoop()) * checker.slid;
            return Some((T::state(&now.place), direction, slid));
        }
    }
}

/// Checks the modes of phases, and sums the length of slides.
struct ModeChecker<F> {
    accepts: F,
    accepted: bool,
    slid: f64,
}

impl<S, F: FnMut(Mode, Option<Direction>) -> bool> Recorder<S> for ModeChecker<F> {
    fn phase(&mut self, phase: PhaseRecord, _: S) {
        let touches = matches!(phase.mode, Mode::Rolling | Mode::Sliding);
        self.accepted &= touches && (self.accepts)(phase.mode, phase.direction);
        if let (Mode::Sliding, Some(end)) = (phase.mode, &phase.end) {
            self.slid += length_of_slide(&phase.start, end);
        }
    }

    fn transition(&mut self, _: &Event, _: Option<&Impact>, _: Option<Direction>) {}
}

/// Solves and records the phase that begins now, up to the event that ends it; or returns the
/// outcome if the motion ends. Stores the range of the angle of a slide in `range`, if it is known.
#[inline(always)]
fn follow<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    now: &mut Current<T::Place>,
    (recorder, pending): (&mut R, &mut Option<Event>),
    range: &mut Option<(f64, f64)>,
) -> Result<EventWithImpact, T::Verdict> {
    now.slips = None;
    let place = &now.place;
    let state = T::state(place);
    let (mode, solved) = match &now.begin {
        NextMotion::Roll { on_limit } => (Mode::Rolling, solver.roll(place, *on_limit)),
        NextMotion::Slide {
            body,
            direction,
            entry,
        } => (Mode::Sliding, solver.slide(place, body, *direction, *entry)),
        NextMotion::Fly { body, take_off } => (Mode::Flight, solver.fly(place, body, *take_off)),
        NextMotion::Glide { body, entry } => (Mode::Gliding, solver.glide(place, body, *entry)),
        NextMotion::Settle { body, settling } => {
            (Mode::Flight, solver.settle(place, body, settling))
        }
        NextMotion::None(candidates) => {
            flush(recorder, pending, None);
            let inconsistent = Outcome::Inconsistent {
                state,
                candidates: **candidates,
            };
            return leads_on(
                recorder,
                jam(solver, now, None, state),
                (None, inconsistent),
            );
        }
        NextMotion::Several(candidates) => {
            flush(recorder, pending, None);
            return Err(Outcome::Ambiguous {
                state,
                candidates: **candidates,
            }
            .into());
        }
    };
    let Solved {
        solution,
        direction,
        mut ending,
    } = solved;
    flush(recorder, pending, direction);
    *range = solution.theta_range();
    if let Ending::Event {
        place,
        cause: Cause::Stick,
        arrival,
    } = &mut ending
    {
        correct_rest(solver, now, place, arrival);
    }
    recorder.phase(
        PhaseRecord {
            mode,
            direction,
            start: state,
            end: ending.state(T::state),
        },
        solution,
    );
    match ending {
        Ending::Event {
            place: reached,
            cause,
            arrival,
        } => Ok((
            continues(solver, now, (mode, direction), reached, (cause, arrival)),
            None,
        )),
        Ending::Motion {
            event,
            end: _,
            verdict,
        } => {
            if let Some((cause, before)) = event {
                recorder.transition(&Event::new(before, mode, cause), None, None);
            }
            Err(verdict)
        }
        Ending::Settled {
            state: end,
            settling,
        } => Ok(settles(solver, now, end, &settling)),
        Ending::Landing { state, gap_rate } => {
            let last = (
                Some(Event::new(state, mode, Cause::Landing)),
                Outcome::Landing { state, gap_rate },
            );
            leads_on(recorder, lands(solver, now, state, gap_rate), last)
        }
        Ending::Singular { state, solvability } => {
            let event = Event::new(state, mode, Cause::Singularity);
            let last = (Some(event), Outcome::Singular { state, solvability });
            leads_on(recorder, jam(solver, now, Some(mode), state), last)
        }
    }
}

/// The event of an impact. The motion ends before the impact if the state after it is not
/// representable, and ends with `outcome` if there is no impact; records the event that ends it.
#[inline(always)]
fn leads_on<S, V: From<Outcome>>(
    recorder: &mut impl Recorder<S>,
    rebound: Option<Rebound>,
    (last, outcome): (Option<Event>, Outcome),
) -> Result<EventWithImpact, V> {
    let (last, outcome) = match rebound {
        Some(Ok(happening)) => return Ok(happening),
        Some(Err(event)) => (Some(event), Outcome::Unresolved { state: event.state }),
        None => (last, outcome),
    };
    if let Some(event) = last {
        recorder.transition(&event, None, None);
    }
    Err(outcome.into())
}

/// Corrects the place at which a slide comes to rest, and its arrival, by the conserved quantities.
#[inline(always)]
fn correct_rest<T: Solver>(
    solver: &T,
    now: &Current<T::Place>,
    place: &mut T::Place,
    arrival: &mut Arrival,
) {
    let (Arrival::InContact, Some(limit), Body::Heavy(body)) =
        (*arrival, &now.limit, solver.hoop().body())
    else {
        return;
    };
    let slide = T::state(&now.place).time..=solver.until();
    *arrival = match limit.correct_rest(&body, &T::state(place)) {
        Some((state, arrival)) => {
            // The uncorrected end lies within the time limit, and rounding must not move it
            // outside.
            if slide.contains(&state.time) {
                *place = solver.place(state);
            }
            arrival
        }
        None => Arrival::InContact,
    };
}

/// Sets the motion after an event without an impact.
#[inline(always)]
fn continues<T: Solver>(
    solver: &T,
    now: &mut Current<T::Place>,
    (mode, direction): (Mode, Option<Direction>),
    place: T::Place,
    (cause, arrival): (Cause, Arrival),
) -> Event {
    now.place = place;
    let state = T::state(&now.place);
    now.begin = solver.decide(&now.place, arrival);
    let begin = &now.begin;
    // Only a slide begins with a known direction.
    (now.limit, now.slips) = match (arrival, begin.direction()) {
        (Arrival::RollingLimit(RollingLimit::Friction(out)), Some(direction)) => (
            LastSlip::out_of_rolling(solver.hoop(), state, out),
            Some(direction),
        ),
        (_, Some(_)) => (now.limit, None),
        (_, None) => (None, None),
    };
    // The next motion distinguishes stick, graze, reversal and lift-off.
    let cause = match (cause, begin.mode()) {
        (Cause::Stick, Some(Mode::Sliding | Mode::Gliding)) => {
            let same = begin.direction().is_some() && begin.direction() == direction;
            if same { Cause::Graze } else { Cause::Reversal }
        }
        // The normal force vanishes at the same instant.
        (Cause::Stick, Some(Mode::Flight)) => Cause::LiftOff,
        (cause, Some(Mode::Rolling | Mode::Sliding | Mode::Gliding | Mode::Flight) | None) => cause,
    };
    Event::new(state, mode, cause)
}

/// Sets the motion after a landing of a hoop with restitution.
fn lands<T: Solver>(
    solver: &T,
    now: &mut Current<T::Place>,
    state: State,
    gap_rate: f64,
) -> Option<Rebound> {
    let hoop = solver.hoop();
    let (Body::Heavy(body), Some(restitution)) = (hoop.body(), hoop.restitution()) else {
        return None;
    };
    let event = Event::new(state, Mode::Flight, Cause::Landing);
    let coordinates = [
        (Quantity::Time, state.time),
        (Quantity::Theta, state.theta),
        (Quantity::X, state.x),
    ];
    if coordinates
        .into_iter()
        .any(|(quantity, value)| quantity.check(value).is_err())
    {
        // After a flight of many turns the angle may exceed the bound of a start.
        return Some(Err(event));
    }
    // At a touch without crossing the rate may round to a positive number.
    let before = ContactVelocities::of(&state, gap_rate.min(0.0));
    let impact = Contact::new(hoop, &body, state.theta).impact(before, restitution);
    Some(rebounds(solver, now, &body, (event, impact)))
}

/// Sets the motion after P ≤ 0 with η′ ≠ 0, for a hoop with restitution.
fn jam<T: Solver>(
    solver: &T,
    now: &mut Current<T::Place>,
    from: Option<Mode>,
    state: State,
) -> Option<Rebound> {
    let Body::Heavy(body) = solver.hoop().body() else {
        return None;
    };
    let impact = solver.hoop().jam(&state)?;
    Some(rebounds(
        solver,
        now,
        &body,
        (
            Event {
                state,
                from,
                to: None,
                cause: Cause::Jam,
            },
            impact,
        ),
    ))
}

/// Sets the motion after the end of infinitely many bounces.
fn settles<T: Solver>(
    solver: &T,
    now: &mut Current<T::Place>,
    state: State,
    settling: &Settling,
) -> EventWithImpact {
    // The sum of the bounces assumes a fixed angle. The small rotation of the flight changes the
    // last digits of the slip.
    let before = ContactVelocities::of(&state, settling.impact.before.gap_rate);
    let impact = Impact {
        before,
        ..settling.impact
    };
    now.place = solver.place(impact.state_after(&state));
    now.begin = solver.decide(&now.place, Arrival::InContact);
    (
        Event::new(state, Mode::Flight, Cause::Settle),
        Some(Box::new(impact)),
    )
}

/// Sets the motion after an impact: a flight if the gap opens. An error if a velocity overflows,
/// which occurs for very small inertia.
fn rebounds<T: Solver>(
    solver: &T,
    now: &mut Current<T::Place>,
    body: &Heavy,
    (event, impact): (Event, Impact),
) -> Rebound {
    let after = impact.state_after(&event.state);
    let ContactVelocities {
        theta_rate,
        slip,
        gap_rate,
    } = impact.after;
    if !(theta_rate + slip + gap_rate).is_finite() {
        return Err(event);
    }
    now.place = solver.place(after);
    now.begin = if impact.after.gap_rate > 0.0 {
        rise(solver, body, &after, impact.after.gap_rate)
    } else {
        solver.decide(&now.place, Arrival::InContact)
    };
    Ok((event, Some(Box::new(impact))))
}

/// The motion with an opening gap: settling bounces if they are short enough, otherwise a flight.
fn rise<T: Solver>(solver: &T, body: &Heavy, state: &State, gap_rate: f64) -> NextMotion {
    let hoop = solver.hoop();
    let settling = hoop
        .restitution()
        .and_then(|restitution| hoop.short_settling(body, state, gap_rate, restitution));
    match settling {
        Some(settling) => NextMotion::Settle {
            body: *body,
            settling: Box::new(settling),
        },
        None => NextMotion::Fly {
            body: *body,
            take_off: TakeOff::Rising { gap_rate },
        },
    }
}

#[inline]
fn flush<S>(
    recorder: &mut impl Recorder<S>,
    pending: &mut Option<Event>,
    direction: Option<Direction>,
) {
    if let Some(event) = pending.take() {
        recorder.transition(&event, None, direction);
    }
}
