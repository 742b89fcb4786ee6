//! The walk of a motion along the automaton: a [`Solver`] solves each phase, and a [`Recorder`]
//! records it.
//!
//! Exact and tabulated phases, trajectories and summaries share one loop and one decision on the
//! next motion. So the engine can differ from the simulation only in the solution of a phase.

use crate::math::trig::Angle;
use crate::mechanics::{Contact, ContactVelocities, Impact, MarginAtTop, Settling};
use crate::model::{
    Body, Heavy, Limits, MAX_COORDINATE, Mode, Quantity, SlipDirection, State, length_of_slide,
};
use crate::modes::{Margin, RollingLimit, SlideLimit, TakeOff, Undecided};
use crate::walk::proofs::Period;
use crate::walk::solver::SkipBudget;
use crate::walk::{
    Arrival, Cause, Event, LastSlip, NextMotion, Outcome, PhaseDetail, PhaseEnd, PhaseRecord,
    PhaseResult, Proofs, Recorder, RelativeStart, SharedProofData, Solution, Solver,
};

/// Most periods that are skipped at once: the rounding of the period is multiplied by their number.
const MAX_SKIPPED_PERIODS: f64 = 64.0;

/// By how much of a period the last skipped one ends before the limits.
const PERIOD_MARGIN: f64 = 1e-3;

/// Limits of a motion, relative to its start, and the data that its proofs share with others.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WalkSettings<'a> {
    pub(crate) limits: &'a Limits,
    pub(crate) shared: SharedProofData<'a>,
}

/// Where a motion is, and the motion that begins there.
struct Cursor<P> {
    point: P,
    next: NextMotion,
    /// The last slip, while the slides after it conserve energy and horizontal momentum.
    last_slip: Option<LastSlip>,
    /// The direction of slip, if rolling has just ended in this slip.
    slip_out_of_rolling: Option<SlipDirection>,
    /// Whether the motion slides without kinetic friction, on an orbit that does not leave the
    /// plane. Rounding of later states must not decide otherwise.
    stays_in_contact: bool,
}

impl<P> Cursor<P> {
    /// At the start of a motion, which leaves the plane if the gap opens.
    fn at_start<T: Solver<Point = P>>(solver: &T, start: RelativeStart) -> Self {
        let RelativeStart { state, gap_rate } = start;
        let point = solver.point(state);
        let next = match solver.hoop().body() {
            Body::Heavy(body) if gap_rate > 0.0 => begin_flight(solver, &body, &state, gap_rate),
            Body::Heavy(_) | Body::Massless(_) => solver.next_motion(&point, Arrival::Start),
        };
        let last_slip = LastSlip::at_start(solver.hoop(), state, &next);
        Self {
            point,
            next,
            last_slip,
            slip_out_of_rolling: None,
            stays_in_contact: false,
        }
    }

    /// At a slip out of rolling.
    fn at_slip<T: Solver<Point = P>>(solver: &T, point: P, direction: SlipDirection) -> Self {
        let arrival = Arrival::RollingLimit(RollingLimit::Friction(direction));
        let next = solver.next_motion(&point, arrival);
        let slip_out_of_rolling = next.direction();
        Self {
            point,
            next,
            last_slip: None,
            slip_out_of_rolling,
            stays_in_contact: false,
        }
    }

    /// Whether a slide from here may lift off.
    fn may_lift_off<T: Solver<Point = P>>(&mut self, solver: &T) -> bool {
        let (NextMotion::Slide { body, .. }, true) = (&self.next, solver.hoop().mu_k() == 0.0)
        else {
            self.stays_in_contact = false;
            return true;
        };
        let state = T::state(&self.point);
        let at_top = || MarginAtTop::new(body, state, Angle::of(state.theta));
        self.stays_in_contact = self.stays_in_contact || !at_top().leaves_plane();
        !self.stays_in_contact
    }
}

/// A recorder with the event that it gets later.
///
/// The direction of a glide from rest follows from its solution, so the event that leads to a glide
/// waits until the glide is solved.
struct EventLog<'a, R> {
    recorder: &'a mut R,
    pending: Option<Event>,
}

impl<'a, R> EventLog<'a, R> {
    const fn new(recorder: &'a mut R) -> Self {
        Self {
            recorder,
            pending: None,
        }
    }

    /// Records the event that ended a phase, or keeps it if a glide begins.
    #[inline(always)]
    fn add<S>(&mut self, event: &Event, impact: Option<&Impact>, direction: Option<SlipDirection>)
    where
        R: Recorder<S>,
    {
        if event.to == Some(Mode::Gliding) {
            self.pending = Some(*event);
        } else {
            self.recorder.transition(event, impact, direction);
        }
    }

    /// Records the event that waits, with the direction of the motion that it begins.
    #[inline]
    fn flush<S>(&mut self, direction: Option<SlipDirection>)
    where
        R: Recorder<S>,
    {
        if let Some(event) = self.pending.take() {
            self.recorder.transition(&event, None, direction);
        }
    }
}

/// The end of a phase by an event, and the range of the angle if it was a slide whose solution keeps
/// it.
struct PhaseStep {
    from: Option<Mode>,
    cause: Cause,
    impact: Option<Box<ImpactAt>>,
    theta_range: Option<(f64, f64)>,
}

/// An impact, and the state just before it.
struct ImpactAt {
    before: State,
    impact: Impact,
}

/// A phase that ended without an impact.
struct EndedPhase<P> {
    mode: Mode,
    direction: Option<SlipDirection>,
    point: P,
    /// None at rest, where the motion that follows names the event.
    cause: Option<Cause>,
    arrival: Arrival,
}

/// What an impact leads to.
enum Rebound {
    /// The motion goes on after it.
    Continues { event: Event, impact: Impact },
    /// The state after it is not representable, so the motion ends before it.
    Unresolved { event: Event, undecided: Undecided },
    /// No rebound: the hoop has no coefficient of restitution, or does not slip where P ≤ 0.
    None,
}

/// The end of a motion, and the event that ends it, if any.
struct MotionEnd {
    event: Option<Event>,
    outcome: Outcome,
}

/// The limits of a motion, and what it has used of them.
struct Budget<'a> {
    limits: &'a Limits,
    slide_weight: f64,
    transitions: usize,
    slide_cost: f64,
}

impl<'a> Budget<'a> {
    const fn new(slide_weight: f64, limits: &'a Limits) -> Self {
        Self {
            limits,
            slide_weight,
            transitions: 0,
            slide_cost: 0.0,
        }
    }

    /// Adds a transition, and the phase before it.
    fn add(&mut self, mode: Option<Mode>, start: &State, end: &State) {
        self.transitions += 1;
        if mode == Some(Mode::Sliding) {
            self.slide_cost += self.slide_weight * length_of_slide(start, end);
        }
    }

    /// The outcome at a state if a limit is reached there.
    const fn outcome(&self, state: State) -> Option<Outcome> {
        if self.transitions >= self.limits.transitions {
            let transitions = self.limits.transitions;
            Some(Outcome::TransitionLimit { state, transitions })
        } else if self.slide_cost > self.limits.slides as f64 {
            let slides = self.limits.slides;
            let limit = SlideLimit::All { slides };
            Some(Outcome::StepLimit { state, limit })
        } else {
            None
        }
    }
}

/// Walks from a start to the end of the motion or to a limit.
pub(crate) fn walk<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    start: RelativeStart,
    settings: WalkSettings<'_>,
    recorder: &mut R,
) -> T::Outcome {
    let WalkSettings { limits, shared } = settings;
    let mut cursor = Cursor::at_start(solver, start);
    // Rounding decides each time anew whether a slip that touches zero at the start does so again.
    let touches = |slip: &LastSlip| slip.order() > 1;
    let skips_periods = T::SKIPS_PERIODS && !cursor.last_slip.as_ref().is_some_and(touches);
    let mut proofs = Proofs::new(solver.hoop(), limits, shared, skips_periods);
    if let Some(outcome) = proofs.at_start(&start.state, cursor.next.mode()) {
        return outcome.into();
    }
    let mut log = EventLog::new(recorder);
    let mut budget = Budget::new(solver.slide_weight(), limits);
    loop {
        skip_links(solver, &mut cursor, log.recorder, &mut proofs, &mut budget);
        let (phase_start, mode) = (*T::state(&cursor.point), cursor.next.mode());
        let step = match advance_phase(solver, &mut cursor, &mut log) {
            Ok(step) => step,
            Err(outcome) => return outcome,
        };
        let after = T::state(&cursor.point);
        let impact = step.impact.as_deref();
        let event = Event {
            state: *impact.map_or(after, |impact| &impact.before),
            from: step.from,
            to: cursor.next.mode(),
            cause: step.cause,
        };
        let direction = cursor.next.direction();
        log.add(&event, impact.map(|it| &it.impact), direction);
        budget.add(mode, &phase_start, &event.state);
        // A proof is a final outcome, so it precedes a limit that is reached at the same event.
        let outcome = proofs
            .at_event(&event, after, direction, step.theta_range)
            .or_else(|| {
                let limit = budget.outcome(*after)?;
                // Without a next motion the next turn of the loop ends the motion.
                event.to.is_some().then(|| proofs.at_limit(limit, event.to))
            });
        if let Some(outcome) = outcome {
            log.flush(direction);
            return outcome.into();
        }
        if let Some(period) = proofs.period(&event, direction) {
            skip_periods(solver, &mut cursor, log.recorder, &period, &mut budget);
        }
    }
}

/// Skips periods of a motion that repeats itself, as many as end before all limits.
#[inline(never)]
fn skip_periods<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    cursor: &mut Cursor<T::Point>,
    recorder: &mut R,
    period: &Period,
    budget: &mut Budget<'_>,
) {
    if recorder.detail() == PhaseDetail::Solutions {
        return;
    }
    let state = *T::state(&cursor.point);
    let transitions_left = budget.limits.transitions.saturating_sub(budget.transitions);
    let slide_cost = budget.slide_weight * period.slide_length;
    let slide_cost_left = budget.limits.slides as f64 - budget.slide_cost;
    // Whatever ends the motion lies behind what is skipped, by more than rounding.
    let times = [
        (solver.until() - state.time) / period.time,
        transitions_left as f64 / period.transitions as f64,
        slide_cost_left / slide_cost,
        MAX_SKIPPED_PERIODS,
    ]
    .into_iter()
    .fold(f64::INFINITY, f64::min);
    let times = (times - PERIOD_MARGIN).floor();
    if times < 1.0 {
        return;
    }
    let end = State {
        time: state.time + times * period.time,
        theta: state.theta + times * period.theta,
        x: state.x + times * period.x,
        ..state
    };
    let Some(point) = solver.skip_to(end) else {
        return;
    };
    let mut phases = period.phases;
    for _ in 1..times as usize {
        phases.append(period.phases);
    }
    let transitions = times as usize * period.transitions;
    recorder.links(u32::try_from(transitions).unwrap_or(u32::MAX), phases);
    budget.transitions += transitions;
    budget.slide_cost += times * slide_cost;
    cursor.point = point;
}

/// Skips links of a chain of slips after a slip out of rolling, as long as the solver can and the
/// budget lasts.
#[inline(always)]
fn skip_links<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    cursor: &mut Cursor<T::Point>,
    recorder: &mut R,
    proofs: &mut Proofs<'_>,
    budget: &mut Budget<'_>,
) {
    // What is left is computed once, and the sums of the skipped links are added at the end: the
    // order of these sums decides the last bits of the cost.
    let transitions_left = budget.limits.transitions.saturating_sub(budget.transitions);
    let slide_cost_left = budget.limits.slides as f64 - budget.slide_cost;
    let (mut transitions, mut slide_cost) = (0, 0.0);
    while let (Some(direction), PhaseDetail::Modes | PhaseDetail::Number, true) = (
        cursor.slip_out_of_rolling,
        recorder.detail(),
        proofs.may_skip_links(),
    ) {
        let open = |state: &State| !proofs.ends_motion(state);
        let skip_budget = SkipBudget {
            // The last transition is left to the loop, which ends the motion at the limit.
            transitions: u32::try_from(transitions_left - transitions)
                .unwrap_or(u32::MAX)
                .saturating_sub(1),
            slide_cost: slide_cost_left - slide_cost,
            record_phases: recorder.detail() == PhaseDetail::Modes,
            open: proofs.examines_each_state().then_some(&open),
        };
        let Some(links) = solver.skip_links(&cursor.point, direction, &skip_budget) else {
            break;
        };
        recorder.links(links.transitions, links.phases);
        transitions += links.transitions as usize;
        slide_cost += links.slide_cost;
        proofs.skipped_to(T::state(&links.point));
        *cursor = Cursor::at_slip(solver, links.point, links.direction);
    }
    budget.transitions += transitions;
    budget.slide_cost += slide_cost;
}

/// A slip out of rolling, and the cost of the slides since the one before it.
pub(crate) struct NextSlip {
    pub(crate) state: State,
    pub(crate) direction: SlipDirection,
    pub(crate) slide_cost: f64,
}

/// The next slip out of rolling. None if another mode or an impact comes first, or a phase that
/// `accepts` refuses.
pub(crate) fn next_slip<T: Solver>(
    solver: &T,
    slip: T::Point,
    direction: SlipDirection,
    accepts: impl FnMut(Mode, Option<SlipDirection>) -> bool,
) -> Option<NextSlip> {
    let mut checker = ModeChecker {
        accepts,
        accepted: true,
        slide_length: 0.0,
    };
    let mut log = EventLog::new(&mut checker);
    let mut cursor = Cursor::at_slip(solver, slip, direction);
    loop {
        let step = advance_phase(solver, &mut cursor, &mut log).ok()?;
        if step.impact.is_some() || !log.recorder.accepted {
            return None;
        }
        if let Some(direction) = cursor.slip_out_of_rolling {
            return Some(NextSlip {
                state: *T::state(&cursor.point),
                direction,
                slide_cost: solver.slide_weight() * log.recorder.slide_length,
            });
        }
    }
}

/// Checks the modes of phases, and sums the length of slides.
struct ModeChecker<F> {
    accepts: F,
    accepted: bool,
    slide_length: f64,
}

impl<S, F: FnMut(Mode, Option<SlipDirection>) -> bool> Recorder<S> for ModeChecker<F> {
    fn phase(&mut self, phase: PhaseRecord, _: S) {
        let touches = matches!(phase.mode, Mode::Rolling | Mode::Sliding);
        self.accepted &= touches && (self.accepts)(phase.mode, phase.direction);
        if let (Mode::Sliding, Some(end)) = (phase.mode, &phase.end) {
            self.slide_length += length_of_slide(&phase.start, end);
        }
    }

    fn transition(&mut self, _: &Event, _: Option<&Impact>, _: Option<SlipDirection>) {}
}

/// Solves and records the phase that begins at the cursor, and moves the cursor past the event that
/// ends it; or returns the outcome if the motion ends.
#[inline(always)]
fn advance_phase<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    cursor: &mut Cursor<T::Point>,
    log: &mut EventLog<'_, R>,
) -> Result<PhaseStep, T::Outcome> {
    cursor.slip_out_of_rolling = None;
    let may_lift_off = cursor.may_lift_off(solver);
    let point = &cursor.point;
    let (mode, result) = match &cursor.next {
        NextMotion::Roll { on_limit } => (Mode::Rolling, solver.roll(point, *on_limit)),
        NextMotion::Slide {
            body,
            direction,
            entry,
        } => (
            Mode::Sliding,
            solver.slide(point, body, *direction, *entry, may_lift_off),
        ),
        NextMotion::Fly { body, take_off } => (Mode::Flight, solver.fly(point, body, *take_off)),
        NextMotion::Glide { body, entry } => (Mode::Gliding, solver.glide(point, body, *entry)),
        NextMotion::Resisted { body, motion } => (
            motion.mode(),
            solver.resisted(point, body, *motion, log.recorder.half_swings()),
        ),
        NextMotion::Settle { body, settling } => {
            (Mode::Flight, solver.settle(point, body, settling))
        }
        NextMotion::None(candidates) => {
            log.flush(None);
            let end = MotionEnd {
                event: None,
                outcome: Outcome::Inconsistent {
                    state: *T::state(point),
                    candidates: **candidates,
                },
            };
            let state = *T::state(point);
            let rebound = jam(solver, cursor, None, state);
            return rebound_or_end(log.recorder, rebound, end);
        }
        NextMotion::Undecided(undecided) => {
            log.flush(None);
            let outcome = Outcome::Unresolved {
                state: *T::state(point),
                undecided: *undecided,
            };
            return Err(outcome.into());
        }
        NextMotion::Several(candidates) => {
            log.flush(None);
            let outcome = Outcome::Ambiguous {
                state: *T::state(point),
                candidates: **candidates,
            };
            return Err(outcome.into());
        }
    };
    finish_phase(solver, cursor, log, mode, result)
}

/// Records a solved phase, and moves the cursor past its end.
#[inline(always)]
fn finish_phase<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    cursor: &mut Cursor<T::Point>,
    log: &mut EventLog<'_, R>,
    mode: Mode,
    mut result: PhaseResult<T>,
) -> Result<PhaseStep, T::Outcome> {
    log.flush(result.direction);
    let theta_range = result.solution.theta_range();
    if let PhaseEnd::Rest { point, arrival } = &mut result.end {
        correct_rest(solver, cursor, point, arrival);
    }
    let record = PhaseRecord {
        mode,
        direction: result.direction,
        start: *T::state(&cursor.point),
        end: result.end.state(T::state),
    };
    log.recorder.phase(record, result.solution);
    let mut step = after_phase(solver, cursor, log.recorder, record, result.end)?;
    step.theta_range = theta_range;
    Ok(step)
}

/// Moves the cursor past the end of a phase; or records the event that ends the motion, and returns
/// the outcome.
#[inline(always)]
fn after_phase<T: Solver, R: Recorder<T::Solution>>(
    solver: &T,
    cursor: &mut Cursor<T::Point>,
    recorder: &mut R,
    phase: PhaseRecord,
    end: PhaseEnd<T::Point, T::Outcome>,
) -> Result<PhaseStep, T::Outcome> {
    let mode = phase.mode;
    let ended = |cause, point, arrival| EndedPhase {
        mode,
        direction: phase.direction,
        point,
        cause,
        arrival,
    };
    match end {
        PhaseEnd::Rest { point, arrival } => {
            Ok(after_event(solver, cursor, ended(None, point, arrival)))
        }
        PhaseEnd::Event {
            point,
            cause,
            arrival,
        } => {
            let ended = ended(Some(cause), point, arrival);
            Ok(after_event(solver, cursor, ended))
        }
        PhaseEnd::Settled { state, settling } => {
            Ok(after_settling(solver, cursor, state, &settling))
        }
        PhaseEnd::Landing { state, gap_rate } => {
            let end = MotionEnd {
                event: Some(Event::new(state, mode, Cause::Landing)),
                outcome: Outcome::Landing { state, gap_rate },
            };
            let rebound = land(solver, cursor, state, gap_rate);
            rebound_or_end(recorder, rebound, end)
        }
        PhaseEnd::Singular { state, solvability } => {
            let end = MotionEnd {
                event: Some(Event::new(state, mode, Cause::Singularity)),
                outcome: Outcome::Singular { state, solvability },
            };
            let rebound = jam(solver, cursor, Some(mode), state);
            rebound_or_end(recorder, rebound, end)
        }
        PhaseEnd::Motion {
            event,
            end: _,
            outcome,
        } => {
            if let Some((cause, before)) = event {
                let event = Event::new(before, mode, cause);
                recorder.transition(&event, None, None);
            }
            Err(outcome)
        }
    }
}

/// The event of an impact. The motion ends before the impact if the state after it is not
/// representable, and with `end` if there is no impact; records the event that ends it.
#[inline(always)]
fn rebound_or_end<S, O: From<Outcome>>(
    recorder: &mut impl Recorder<S>,
    rebound: Rebound,
    end: MotionEnd,
) -> Result<PhaseStep, O> {
    let MotionEnd { event, outcome } = match rebound {
        Rebound::Continues { event, impact } => {
            return Ok(PhaseStep {
                from: event.from,
                cause: event.cause,
                impact: Some(Box::new(ImpactAt {
                    before: event.state,
                    impact,
                })),
                theta_range: None,
            });
        }
        Rebound::Unresolved { event, undecided } => MotionEnd {
            event: Some(event),
            outcome: Outcome::Unresolved {
                state: event.state,
                undecided,
            },
        },
        Rebound::None => end,
    };
    if let Some(event) = event {
        recorder.transition(&event, None, None);
    }
    Err(outcome.into())
}

/// Corrects the point at which a slide comes to rest, and its arrival, by the conserved quantities.
#[inline(always)]
fn correct_rest<T: Solver>(
    solver: &T,
    cursor: &Cursor<T::Point>,
    point: &mut T::Point,
    arrival: &mut Arrival,
) {
    let (Arrival::InContact, Some(last_slip), Body::Heavy(body)) =
        (*arrival, &cursor.last_slip, solver.hoop().body())
    else {
        return;
    };
    let slide = T::state(&cursor.point).time..=solver.until();
    *arrival = match last_slip.correct_rest(&body, T::state(point)) {
        Some(corrected) => {
            // The uncorrected end lies within the time limit, and rounding must not move it
            // outside.
            if slide.contains(&corrected.state.time) {
                *point = solver.point(corrected.state);
            }
            corrected.arrival
        }
        None => Arrival::InContact,
    };
}

/// Moves the cursor to the end of a phase, selects the motion that follows, and names the event.
#[inline(always)]
fn after_event<T: Solver>(
    solver: &T,
    cursor: &mut Cursor<T::Point>,
    ended: EndedPhase<T::Point>,
) -> PhaseStep {
    let EndedPhase {
        mode,
        direction,
        point,
        cause,
        arrival,
    } = ended;
    cursor.point = point;
    cursor.next = solver.next_motion(&cursor.point, arrival);
    let next = &cursor.next;
    // Only a slide begins with a known direction.
    cursor.slip_out_of_rolling = None;
    match (arrival, next.direction()) {
        (Arrival::RollingLimit(RollingLimit::Friction(out)), Some(direction)) => {
            let state = *T::state(&cursor.point);
            cursor.last_slip = LastSlip::out_of_rolling(solver.hoop(), state, out);
            cursor.slip_out_of_rolling = Some(direction);
        }
        (_, Some(_)) => {}
        (_, None) => cursor.last_slip = None,
    }
    let cause = cause.unwrap_or_else(|| match next.mode() {
        Some(Mode::Sliding | Mode::Gliding | Mode::Skidding) => {
            let same = next.direction().is_some() && next.direction() == direction;
            if same { Cause::Graze } else { Cause::Reversal }
        }
        // The normal force vanishes at the same instant.
        Some(Mode::Flight) => Cause::LiftOff,
        Some(Mode::Rolling | Mode::Rest) | None => Cause::Stick,
    });
    PhaseStep {
        from: Some(mode),
        cause,
        impact: None,
        theta_range: None,
    }
}

/// Moves the cursor past the impact of a landing.
fn land<T: Solver>(
    solver: &T,
    cursor: &mut Cursor<T::Point>,
    state: State,
    gap_rate: f64,
) -> Rebound {
    let hoop = solver.hoop();
    let (Body::Heavy(body), Some(restitution)) = (hoop.body(), hoop.restitution()) else {
        return Rebound::None;
    };
    let event = Event::new(state, Mode::Flight, Cause::Landing);
    // After a flight of many turns the angle may exceed the bound of a start.
    for (quantity, value) in [
        (Quantity::Time, state.time),
        (Quantity::Theta, state.theta),
        (Quantity::X, state.x),
    ] {
        if quantity.check(value).is_err() {
            let undecided = Undecided::Range {
                quantity,
                value,
                bound: MAX_COORDINATE,
            };
            return Rebound::Unresolved { event, undecided };
        }
    }
    // At a touch without crossing the rate may round to a positive number.
    let before = ContactVelocities::of(&state, gap_rate.min(0.0));
    let contact = Contact::new(hoop, &body, state.theta);
    let impact = contact.impact(before, restitution);
    if let Some(undecided) = contact.undecided(&impact, restitution) {
        return Rebound::Unresolved { event, undecided };
    }
    after_impact(solver, cursor, &body, event, impact)
}

/// Moves the cursor past the impact without collision at P ≤ 0, for a hoop with restitution.
fn jam<T: Solver>(
    solver: &T,
    cursor: &mut Cursor<T::Point>,
    from: Option<Mode>,
    state: State,
) -> Rebound {
    let hoop = solver.hoop();
    let (Body::Heavy(body), Some(restitution)) = (hoop.body(), hoop.restitution()) else {
        return Rebound::None;
    };
    let contact = Contact::new(hoop, &body, state.theta);
    let Some(impact) = contact.jam(ContactVelocities::of(&state, 0.0), restitution) else {
        return Rebound::None;
    };
    let event = Event {
        state,
        from,
        to: None,
        cause: Cause::Jam,
    };
    if let Some(undecided) = contact.undecided_jam(&impact, restitution) {
        return Rebound::Unresolved { event, undecided };
    }
    after_impact(solver, cursor, &body, event, impact)
}

/// Moves the cursor past the end of infinitely many bounces.
fn after_settling<T: Solver>(
    solver: &T,
    cursor: &mut Cursor<T::Point>,
    state: State,
    settling: &Settling,
) -> PhaseStep {
    // The sum of the bounces assumes a fixed angle. The small rotation of the flight changes the
    // last digits of the slip.
    let before = ContactVelocities::of(&state, settling.impact.before.gap_rate);
    let impact = Impact {
        before,
        ..settling.impact
    };
    cursor.point = solver.point(impact.state_after(&state));
    cursor.next = solver.next_motion(&cursor.point, Arrival::InContact);
    PhaseStep {
        from: Some(Mode::Flight),
        cause: Cause::Settle,
        impact: Some(Box::new(ImpactAt {
            before: state,
            impact,
        })),
        theta_range: None,
    }
}

/// Moves the cursor past an impact, to a flight if the gap opens. Unresolved if a velocity
/// overflows, which occurs for very small inertia, or the gap rate underflows in bounces that do
/// not settle: rounding would stop those that grow.
fn after_impact<T: Solver>(
    solver: &T,
    cursor: &mut Cursor<T::Point>,
    body: &Heavy,
    event: Event,
    impact: Impact,
) -> Rebound {
    let state = impact.state_after(&event.state);
    let ContactVelocities {
        theta_rate,
        slip,
        gap_rate,
    } = impact.after;
    for (quantity, value) in [
        (Quantity::ThetaRate, theta_rate),
        (Quantity::Slip, slip),
        (Quantity::GapRate, gap_rate),
    ] {
        if !value.is_finite() {
            let undecided = Undecided::overflow(quantity, value);
            return Rebound::Unresolved { event, undecided };
        }
    }
    cursor.point = solver.point(state);
    cursor.next = if gap_rate > 0.0 {
        begin_flight(solver, body, &state, gap_rate)
    } else {
        solver.next_motion(&cursor.point, Arrival::InContact)
    };
    let rebounds = || {
        solver
            .hoop()
            .restitution()
            .is_some_and(|it| it.coefficient() > 0.0)
    };
    let underflows = gap_rate.is_subnormal()
        || (gap_rate == 0.0 && impact.before.gap_rate.is_subnormal() && rebounds());
    if underflows && !matches!(cursor.next, NextMotion::Settle { .. }) {
        let undecided = Undecided::Rounding {
            margin: Margin::GapRate,
            value: gap_rate,
            bound: f64::MIN_POSITIVE,
        };
        return Rebound::Unresolved { event, undecided };
    }
    Rebound::Continues { event, impact }
}

/// The motion with an opening gap: settling bounces if they are short enough, otherwise a flight.
fn begin_flight<T: Solver>(solver: &T, body: &Heavy, state: &State, gap_rate: f64) -> NextMotion {
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
