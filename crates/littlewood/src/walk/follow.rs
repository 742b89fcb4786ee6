//! The walk of a motion along the automaton: one phase after the other, each solved by a [`Solver`], told to a
//! [`Recorder`].
//!
//! There is one loop and one decision on what follows, whether the phases are solved exactly or looked up in tables, and
//! whether a trajectory is kept or a summary. What the engine does can therefore differ from what the simulation does
//! only where a solver of a phase differs.

use crate::mechanics::{Contact, ContactVelocities, Impact, Settling};
use crate::model::{
    Body, Direction, Heavy, Hoop, Limits, Massless, Mode, Quantity, State, length_of_slide, weight_of_slides,
};
use crate::modes::{Flight, GlideEntry, RollingLimit, SlideLimit, TakeOff};
use crate::walk::{Arrival, Cause, Event, Known, LastSlip, Next, Outcome, PhaseSequence, Proofs};

/// Solves phases of motion, each from the place where it begins to the event that ends it, or to the time limit.
pub(crate) trait Solver {
    /// A state, with what the solver has computed for it.
    type Place;
    /// The solution of a phase.
    type Solution: Solution;
    /// How the motion ended.
    type Verdict: From<Outcome>;

    fn hoop(&self) -> &Hoop;
    /// The time limit of the motion; infinite, if there is none.
    fn until(&self) -> f64;
    fn place(&self, state: State) -> Self::Place;
    fn state(place: &Self::Place) -> State;
    /// Which motion follows.
    fn decide(&self, place: &Self::Place, arrival: Arrival) -> Next;
    /// `on_limit` where |F| = μs N at the start, and static friction holds from there on.
    fn roll(&self, place: &Self::Place, on_limit: bool) -> SolvedBy<Self>;
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
    fn glide(&self, place: &Self::Place, body: &Massless, entry: GlideEntry) -> SolvedBy<Self>;
    /// Links of a chain of slips at once, from a slip out of rolling in a direction, none of which leads to a grazing orbit for sure: none
    /// where phases are to be followed.
    fn pass_links(&self, _: &Self::Place, _: Direction, _: &Room<'_>) -> Option<Linked<Self::Place>> {
        None
    }
}

/// What a motion has room for before something else may end it.
pub(crate) struct Room<'a> {
    /// Most transitions.
    pub(crate) transitions: u32,
    /// Largest length of slides.
    pub(crate) slides: f64,
    /// Whether its phases are told: no more of them than a sequence holds.
    pub(crate) are_told: bool,
    /// Whether nothing that would end the motion is known in a state, where that is asked at each event; what is known in a state is known
    /// in all that follow.
    pub(crate) open: Option<&'a dyn Fn(&State) -> bool>,
}

/// Links from a slip out of rolling to a later one.
pub(crate) struct Linked<P> {
    pub(crate) place: P,
    /// Of the slip there.
    pub(crate) direction: Direction,
    pub(crate) transitions: u32,
    /// Length of the slides.
    pub(crate) slid: f64,
    /// If they are told.
    pub(crate) phases: PhaseSequence,
}

/// A phase that may be a flight.
pub(crate) trait MaybeFlight {
    /// The flight, if it is one.
    fn flight(&self) -> Option<&Flight>;
}

/// Properties of a solved phase, exact or tabulated.
pub(crate) trait Solution: MaybeFlight {
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
    Landing { state: State, gap_rate: f64 },
    /// By the end of bounces.
    Settled { state: State, settling: Box<Settling> },
    /// By P = 0 in a slide, with P there.
    Singular { state: State, solvability: f64 },
    /// With the motion: `event` is its last transition, if there is one, `end` the state at the end of the phase, if
    /// it has one.
    Motion { event: Option<(Cause, State)>, end: Option<State>, verdict: V },
}

impl<P, V> Ending<P, V> {
    /// The state at the end of the phase, if it has one.
    pub(crate) fn state(&self, of: impl Fn(&P) -> State) -> Option<State> {
        match self {
            Self::Event { place, .. } => Some(of(place)),
            Self::Landing { state, .. } | Self::Settled { state, .. } | Self::Singular { state, .. } => {
                Some(*state)
            }
            Self::Motion { end, .. } => *end,
        }
    }
}

/// Records the phases and transitions of a motion.
pub(crate) trait Recorder<S> {
    /// A phase in a mode, from a state to a state, or without end.
    fn phase(&mut self, phase: PhaseSeen, solution: S);
    /// An event, which ends the last phase if it has a mode that ends; its impact, and the direction of slip of the motion
    /// that begins.
    fn transition(&mut self, event: &Event, impact: Option<&Impact>, direction: Option<Direction>);
    /// Which phases are to be told.
    fn wants(&self) -> Wants {
        Wants::Solutions
    }
    /// Phases and transitions from a slip out of rolling to a later one, the first phases that are wanted among them.
    fn links(&mut self, _transitions: u32, _phases: PhaseSequence) {}
}

/// What a recorder keeps of the phases that follow.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Wants {
    /// Their solutions.
    Solutions,
    /// Their modes.
    Modes,
    /// Their number.
    Number,
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

/// Where a motion is: the place, and what begins there.
struct Now<P> {
    place: P,
    begin: Begin,
    /// Where rolling has given way, while the slides that follow conserve the energy and the horizontal momentum.
    limit: Option<LastSlip>,
    /// The direction of slip, where rolling has just given way to it.
    slips: Option<Direction>,
}

impl<P> Now<P> {
    /// At a slip out of rolling.
    fn slipping<T: Solver<Place = P>>(solver: &T, place: P, direction: Direction) -> Self {
        let arrival = Arrival::RollingLimit(RollingLimit::Friction(direction));
        let begin = Begin::Motion(solver.decide(&place, arrival));
        let slips = begin.direction();
        Self { place, begin, limit: None, slips }
    }
}

/// An event, and the impact that it is, if it is one.
type Happening = (Event, Option<Box<Impact>>);

/// The same of an impact; or the event alone, where its end is no state to go on from.
type Rebound = Result<Happening, Event>;

/// Walks from a start, which leaves the plane at `gap_rate`, to the end of the motion, or to a limit, with what is known of the hoop for proofs.
pub(crate) fn walk<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    (start, gap_rate): (State, f64),
    (limits, known): (&Limits, Known<'_>),
    recorder: &mut R,
) -> T::Verdict {
    let place = solver.place(start);
    let begin = match solver.hoop().body() {
        Body::Heavy(body) if gap_rate > 0.0 => rise(solver, &body, &start, gap_rate),
        Body::Heavy(_) | Body::Massless(_) => Begin::Motion(solver.decide(&place, Arrival::Open)),
    };
    let mut proofs = Proofs::new(solver.hoop(), limits, known);
    if let Some(outcome) = proofs.at_start(&start, begin.mode()) {
        return outcome.into();
    }
    let limit = LastSlip::at_start(solver.hoop(), start, begin.direction());
    let mut now = Now { place, begin, limit, slips: None };
    let mut pending: Option<Event> = None;
    let (mut count, mut slid) = (0, 0.0);
    let weight = weight_of_slides(solver.hoop());
    loop {
        let left = (limits.transitions.saturating_sub(count), limits.slides as f64 - slid);
        let passed = pass_links(solver, &mut now, recorder, &mut proofs, left);
        (count, slid) = (count + passed.0, slid + passed.1);
        let (begins, mode) = (T::state(&now.place), now.begin.mode());
        let mut range = None;
        let seen = proofs.wants_range().then_some(&mut range);
        let (event, impact) = match follow(solver, &mut now, (recorder, &mut pending), seen) {
            Ok(happening) => happening,
            Err(verdict) => return verdict,
        };
        let event = Event { to: now.begin.mode(), ..event };
        let direction = now.begin.direction();
        if event.to == Some(Mode::Gliding) {
            // The direction of a glide from rest is known only once it is followed.
            pending = Some(event);
        } else {
            recorder.transition(&event, impact.as_deref(), direction);
        }
        count += 1;
        if mode == Some(Mode::Sliding) {
            slid += weight * length_of_slide(&begins, &event.state);
        }
        let state = T::state(&now.place);
        let stopped = proofs.at_event(&event, (&state, direction), range).or_else(|| {
            let limit = if count >= limits.transitions {
                Outcome::TransitionLimit { state, transitions: limits.transitions }
            } else if slid > limits.slides as f64 {
                Outcome::StepLimit { state, limit: SlideLimit::All { slides: limits.slides } }
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

/// Passes links of a chain of slips, if a slip out of rolling has been reached, within a number of transitions and a length of slides: how many, and how long.
#[inline(always)]
fn pass_links<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    now: &mut Now<T::Place>,
    recorder: &mut R,
    proofs: &mut Proofs<'_>,
    (most, longest): (usize, f64),
) -> (usize, f64) {
    let (mut passed, mut slid) = (0, 0.0);
    while let (Some(direction), Wants::Modes | Wants::Number, true) =
        (now.slips, recorder.wants(), proofs.may_pass_links())
    {
        let open = |state: &State| !proofs.ends_motion(state);
        let room = Room {
            transitions: u32::try_from(most - passed).unwrap_or(u32::MAX).saturating_sub(1),
            slides: longest - slid,
            are_told: recorder.wants() == Wants::Modes,
            open: proofs.asks_each_state().then_some(&open),
        };
        let Some(linked) = solver.pass_links(&now.place, direction, &room) else { break };
        let Linked { place, direction, transitions, slid: length, phases } = linked;
        recorder.links(transitions, phases);
        (passed, slid) = (passed + transitions as usize, slid + length);
        proofs.passed_to(&T::state(&place));
        *now = Now::slipping(solver, place, direction);
    }
    (passed, slid)
}

/// The next slip out of rolling after one, its direction, and the length of the slides up to it, if the motion comes to one before anything but slides and rolls, and within the
/// phases that `tell` accepts.
pub(crate) fn next_slip<T: Solver>(
    solver: &T,
    slip: T::Place,
    direction: Direction,
    tell: impl FnMut(Mode, Option<Direction>) -> bool,
) -> Option<(State, Direction, f64)> {
    let mut teller = Teller { tell, goes_on: true, slid: 0.0 };
    let mut now = Now::slipping(solver, slip, direction);
    loop {
        let (_, impact) = follow(solver, &mut now, (&mut teller, &mut None), None).ok()?;
        if impact.is_some() || !teller.goes_on {
            return None;
        }
        if let Some(direction) = now.slips {
            let slid = weight_of_slides(solver.hoop()) * teller.slid;
            return Some((T::state(&now.place), direction, slid));
        }
    }
}

/// Tells the modes of phases, as long as they are accepted.
struct Teller<F> {
    tell: F,
    goes_on: bool,
    /// Length of the slides.
    slid: f64,
}

impl<S, F: FnMut(Mode, Option<Direction>) -> bool> Recorder<S> for Teller<F> {
    fn phase(&mut self, phase: PhaseSeen, _: S) {
        let touches = matches!(phase.mode, Mode::Rolling | Mode::Sliding);
        self.goes_on &= touches && (self.tell)(phase.mode, phase.direction);
        if let (Mode::Sliding, Some(end)) = (phase.mode, &phase.end) {
            self.slid += length_of_slide(&phase.start, end);
        }
    }

    fn transition(&mut self, _: &Event, _: Option<&Impact>, _: Option<Direction>) {}
}

/// Follows the phase that begins now to the event that ends it, and tells the recorder of it; or says how the motion has ended.
/// The range of the angle of a slide is kept where it is asked for.
#[inline(always)]
fn follow<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    now: &mut Now<T::Place>,
    (recorder, pending): (&mut R, &mut Option<Event>),
    range: Option<&mut Option<(f64, f64)>>,
) -> Result<Happening, T::Verdict> {
    follow_phase(solver, now, (recorder, pending), range).map_err(|(last, verdict)| {
        if let Some(event) = last {
            recorder.transition(&event, None, None);
        }
        verdict
    })
}

/// The same, but for the event that ends the motion, if there is one.
#[inline(always)]
fn follow_phase<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    now: &mut Now<T::Place>,
    (recorder, pending): (&mut R, &mut Option<Event>),
    range: Option<&mut Option<(f64, f64)>>,
) -> Result<Happening, (Option<Event>, T::Verdict)> {
    now.slips = None;
    let place = &now.place;
    let state = T::state(place);
    let (mode, solved) = match &now.begin {
        Begin::Motion(Next::Roll { on_limit }) => (Mode::Rolling, solver.roll(place, *on_limit)),
        Begin::Motion(Next::Slide { body, direction, slip_acceleration }) => {
            (Mode::Sliding, solver.slide(place, body, *direction, *slip_acceleration))
        }
        Begin::Motion(Next::Fly { body, take_off }) => (Mode::Flight, solver.fly(place, body, *take_off)),
        Begin::Motion(Next::Glide { body, entry }) => (Mode::Gliding, solver.glide(place, body, *entry)),
        Begin::Settle(body, settling) => (Mode::Flight, solver.settle(place, body, settling)),
        Begin::Motion(Next::None(candidates)) => {
            flush(recorder, pending, None);
            let inconsistent = Outcome::Inconsistent { state, candidates: **candidates };
            return leads_on(jam(solver, now, None, state), (None, inconsistent));
        }
        Begin::Motion(Next::Several(candidates)) => {
            flush(recorder, pending, None);
            return Err((None, Outcome::Ambiguous { state, candidates: **candidates }.into()));
        }
    };
    let Solved { solution, direction, mut ending } = solved;
    flush(recorder, pending, direction);
    if let Some(range) = range {
        *range = solution.theta_range();
    }
    if let Ending::Event { place, cause: Cause::Stick, arrival } = &mut ending {
        comes_to_rest(solver, now, place, arrival);
    }
    recorder.phase(PhaseSeen { mode, direction, start: state, end: ending.state(T::state) }, solution);
    match ending {
        Ending::Event { place: reached, cause, arrival } => {
            Ok((continues(solver, now, (mode, direction), reached, (cause, arrival)), None))
        }
        Ending::Motion { event, end: _, verdict } => {
            Err((event.map(|(cause, before)| Event::new(before, mode, cause)), verdict))
        }
        Ending::Settled { state: end, settling } => Ok(settles(solver, now, end, &settling)),
        Ending::Landing { state, gap_rate } => {
            let last = Event::new(state, mode, Cause::Landing);
            leads_on(lands(solver, now, state, gap_rate), (Some(last), Outcome::Landing { state, gap_rate }))
        }
        Ending::Singular { state, solvability } => {
            let last = Event::new(state, mode, Cause::Singularity);
            leads_on(
                jam(solver, now, Some(mode), state),
                (Some(last), Outcome::Singular { state, solvability }),
            )
        }
    }
}

/// What an impact leads to; where its end is no state to go on from, the motion ends before it, and without an impact in this way.
#[inline(always)]
fn leads_on<V: From<Outcome>>(
    rebound: Option<Rebound>,
    (last, outcome): (Option<Event>, Outcome),
) -> Result<Happening, (Option<Event>, V)> {
    match rebound {
        Some(Ok(happening)) => Ok(happening),
        Some(Err(event)) => Err((Some(event), Outcome::Unresolved { state: event.state }.into())),
        None => Err((last, outcome.into())),
    }
}

/// Moves the place at which a slide comes to rest to where its conserved quantities have it, and tells how it is reached.
#[inline(always)]
fn comes_to_rest<T: Solver>(solver: &T, now: &Now<T::Place>, place: &mut T::Place, arrival: &mut Arrival) {
    let (Arrival::Open, Some(limit), Body::Heavy(body)) = (*arrival, &now.limit, solver.hoop().body()) else {
        return;
    };
    let slide = T::state(&now.place).time..=solver.until();
    *arrival = match limit.comes_to_rest(&body, &T::state(place)) {
        Some((state, arrival)) => {
            // The slide as it was followed ends within the time limit: its last digits do not put its end outside.
            if slide.contains(&state.time) {
                *place = solver.place(state);
            }
            arrival
        }
        None => Arrival::Open,
    };
}

/// What follows an event without an impact.
#[inline(always)]
fn continues<T: Solver>(
    solver: &T,
    now: &mut Now<T::Place>,
    (mode, direction): (Mode, Option<Direction>),
    place: T::Place,
    (cause, arrival): (Cause, Arrival),
) -> Event {
    now.place = place;
    let state = T::state(&now.place);
    now.begin = Begin::Motion(solver.decide(&now.place, arrival));
    let begin = &now.begin;
    now.limit = match (arrival, begin.mode()) {
        (Arrival::RollingLimit(RollingLimit::Friction(direction)), Some(Mode::Sliding)) => {
            LastSlip::out_of_rolling(solver.hoop(), state, direction)
        }
        (_, Some(Mode::Sliding)) => now.limit,
        (_, Some(Mode::Rolling | Mode::Gliding | Mode::Flight) | None) => None,
    };
    now.slips = match arrival {
        Arrival::RollingLimit(RollingLimit::Friction(_)) if begin.mode() == Some(Mode::Sliding) => {
            begin.direction()
        }
        Arrival::RollingLimit(_)
        | Arrival::Open
        | Arrival::GlideAtRest { .. }
        | Arrival::BackOnLimit(_)
        | Arrival::LiftOff => None,
    };
    // Only now is it known what coming to rest leads to.
    let cause = match (cause, begin.mode()) {
        (Cause::Stick, Some(Mode::Sliding | Mode::Gliding)) => {
            let same = begin.direction().is_some() && begin.direction() == direction;
            if same { Cause::Graze } else { Cause::Reversal }
        }
        // The normal force has vanished at the same instant.
        (Cause::Stick, Some(Mode::Flight)) => Cause::LiftOff,
        (cause, Some(Mode::Rolling | Mode::Sliding | Mode::Gliding | Mode::Flight) | None) => cause,
    };
    Event::new(state, mode, cause)
}

/// What follows a landing of a hoop with restitution.
fn lands<T: Solver>(solver: &T, now: &mut Now<T::Place>, state: State, gap_rate: f64) -> Option<Rebound> {
    let hoop = solver.hoop();
    let (Body::Heavy(body), Some(restitution)) = (hoop.body(), hoop.restitution()) else { return None };
    let event = Event::new(state, Mode::Flight, Cause::Landing);
    let coordinates = [(Quantity::Time, state.time), (Quantity::Theta, state.theta), (Quantity::X, state.x)];
    if coordinates.into_iter().any(|(quantity, value)| quantity.check(value).is_err()) {
        // A flight of many turns leads to angles at which no start is accepted either.
        return Some(Err(event));
    }
    // The gap comes from above: where it touches without crossing, its rate may round to a positive number.
    let before = ContactVelocities::of(&state, gap_rate.min(0.0));
    let impact = Contact::new(hoop, &body, state.theta).impact(before, restitution);
    Some(rebounds(solver, now, &body, (event, impact)))
}

/// What follows P ≤ 0 with slip left, for a hoop with restitution.
fn jam<T: Solver>(solver: &T, now: &mut Now<T::Place>, from: Option<Mode>, state: State) -> Option<Rebound> {
    let Body::Heavy(body) = solver.hoop().body() else { return None };
    let impact = solver.hoop().jam(&state)?;
    Some(rebounds(solver, now, &body, (Event { state, from, to: None, cause: Cause::Jam }, impact)))
}

/// What follows the end of bounces.
fn settles<T: Solver>(solver: &T, now: &mut Now<T::Place>, state: State, settling: &Settling) -> Happening {
    // The flight has turned the hoop by so little that the sum took the angle for fixed: the last digits of the slip differ.
    let before = ContactVelocities::of(&state, settling.impact.before.gap_rate);
    let impact = Impact { before, ..settling.impact };
    now.place = solver.place(impact.state_after(&state));
    now.begin = Begin::Motion(solver.decide(&now.place, Arrival::Open));
    (Event::new(state, Mode::Flight, Cause::Settle), Some(Box::new(impact)))
}

/// What follows an impact: a flight, if the gap opens; nothing, where its velocities are no numbers, as those of a body of next to no
/// inertia.
fn rebounds<T: Solver>(
    solver: &T,
    now: &mut Now<T::Place>,
    body: &Heavy,
    (event, impact): (Event, Impact),
) -> Rebound {
    let after = impact.state_after(&event.state);
    let ContactVelocities { theta_rate, slip, gap_rate } = impact.after;
    if !(theta_rate + slip + gap_rate).is_finite() {
        return Err(event);
    }
    now.place = solver.place(after);
    now.begin = if impact.after.gap_rate > 0.0 {
        rise(solver, body, &after, impact.after.gap_rate)
    } else {
        Begin::Motion(solver.decide(&now.place, Arrival::Open))
    };
    Ok((event, Some(Box::new(impact))))
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

/// Passes a pending event to the recorder.
#[inline]
fn flush<S>(recorder: &mut impl Recorder<S>, pending: &mut Option<Event>, direction: Option<Direction>) {
    if let Some(event) = pending.take() {
        recorder.transition(&event, None, direction);
    }
}

impl Begin {
    /// The mode that begins.
    const fn mode(&self) -> Option<Mode> {
        match self {
            Self::Motion(Next::Roll { .. }) => Some(Mode::Rolling),
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
                Next::Roll { .. } | Next::Glide { .. } | Next::Fly { .. } | Next::None(_) | Next::Several(_),
            )
            | Self::Settle(..) => None,
        }
    }
}
