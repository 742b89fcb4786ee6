//! Proofs at an event about the rest of the motion, which end the simulation of an endless motion.
//!
//! - Without kinetic friction, and for a massless hoop, energy is conserved in contact. A motion
//!   then has finitely many distinct slips, sticks and reversals, and repeats once it returns to
//!   one.
//! - With μs = μk > 0 slips shrink towards the orbit that grazes the limit of static friction
//!   ([`GrazingOrbit`]).
//! - In contact the energy never increases, its part outside the horizontal velocity has an upper
//!   bound, and a lift-off requires a minimum of this part ([`Hoop::never_lifts_off`]).

use core::f64::consts::TAU;

use crate::mechanics::{ContactProof, RollingLaw};
use crate::model::{Body, Hoop, Limits, Mode, Proof, SlipDirection, State, length_of_slide};
use crate::modes::{Levels, Recurrence};
use crate::walk::{Cause, Event, Outcome, PhaseSequence};

/// Two reversals count as the same if their distance is at most this fraction of the distance to a
/// reversal of the other direction.
const MAX_REVERSAL_DISTANCE_RATIO: f64 = 0.25;

/// Largest difference of equal values, relative to one plus their size: rounding of some thousand
/// steps is far below.
const EQUALITY_TOLERANCE: f64 = 1e-9;

/// The same where periods are skipped: they add up what the period is wrong by. Events that are
/// less well told, next to each other, are not where a motion repeats itself.
const PERIOD_TOLERANCE: f64 = 1e-13;

/// Most events of a period that is looked for: ordinary ones have four.
const MAX_EVENTS: usize = 16;

/// Whether two values are equal within rounding.
pub(crate) fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= EQUALITY_TOLERANCE * (1.0 + a.abs())
}

/// Whether two angles are equal up to whole turns and rounding; the first may have many turns.
pub(crate) fn is_same_direction(a: f64, b: f64) -> bool {
    angle_between(a, b) <= EQUALITY_TOLERANCE * (1.0 + a.abs())
}

/// The angle between two directions, from 0 to π.
fn angle_between(a: f64, b: f64) -> f64 {
    let turns = ((a - b) / TAU).round();
    (a - b - turns * TAU).abs()
}

#[derive(Debug)]
pub(crate) struct Proofs<'a> {
    hoop: &'a Hoop,
    proof: Proof,
    /// Proof data shared between motions of the hoop.
    shared: Option<&'a ContactProof>,
    /// Proof data of this motion, if none is shared.
    own: ContactProof,
    kind: Kind<'a>,
}

/// Data of a hoop for proofs, shared between motions.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct SharedProofData<'a> {
    pub(crate) levels: Option<&'a Levels>,
    pub(crate) contact: Option<&'a ContactProof>,
}

/// The property of a motion that its events may prove.
#[derive(Debug)]
enum Kind<'a> {
    None,
    /// The motion repeats.
    Conservative(Vec<Visit>),
    /// The same with a time limit, up to which periods are skipped.
    Periodic(Vec<Visit>),
    /// The motion slips for ever.
    Grazing(Box<Slips<'a>>),
}

/// An event of a motion that conserves its energy.
#[derive(Clone, Copy, Debug)]
struct Visit {
    state: State,
    cause: Cause,
    direction: Option<SlipDirection>,
    /// The mode that it ends, and the range of the angle of a slide, where it is data.
    from: Option<Mode>,
    theta_range: Option<(f64, f64)>,
}

impl Visit {
    fn new(event: &Event, direction: Option<SlipDirection>) -> Self {
        Self {
            state: event.state,
            cause: event.cause,
            direction,
            from: event.from,
            theta_range: None,
        }
    }

    fn slid(&self) -> bool {
        self.from == Some(Mode::Sliding)
    }
}

/// What a motion that repeats itself gains in a period.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Period {
    pub(crate) time: f64,
    pub(crate) theta: f64,
    pub(crate) x: f64,
    pub(crate) transitions: usize,
    pub(crate) slide_length: f64,
    pub(crate) phases: PhaseSequence,
}

#[derive(Clone, Copy, Debug)]
struct Slip {
    energy: f64,
    /// Whether the particle moves away from the upward vertical.
    ahead: bool,
}

#[derive(Debug)]
struct Slips<'a> {
    law: RollingLaw,
    slip: Option<Slip>,
    /// The slip before it, if its loss proved convergence to a grazing orbit.
    confirmed: Option<Slip>,
    /// Levels shared between motions.
    shared: Option<&'a Levels>,
    /// Levels of this motion if none are shared, computed on demand.
    own: Option<Option<Levels>>,
}

impl<'a> Proofs<'a> {
    /// With `skips_periods` those of a smooth plane are looked for up to a time limit.
    pub(crate) fn new(
        hoop: &'a Hoop,
        limits: &Limits,
        data: SharedProofData<'a>,
        skips_periods: bool,
    ) -> Self {
        let proof = limits.proof();
        let is_smooth = hoop.mu_s() == 0.0 && hoop.slope() == 0.0;
        let kind = match hoop.body() {
            Body::Heavy(_) | Body::Massless(_) if hoop.rolling_resistance() > 0.0 => Kind::None,
            Body::Heavy(_) if limits.until.is_some() && is_smooth && skips_periods => {
                Kind::Periodic(Vec::new())
            }
            Body::Heavy(_) | Body::Massless(_) if proof == Proof::None || hoop.slope() != 0.0 => {
                Kind::None
            }
            Body::Massless(_) => Kind::Conservative(Vec::new()),
            Body::Heavy(_) if hoop.mu_k() == 0.0 => Kind::Conservative(Vec::new()),
            Body::Heavy(body) if hoop.mu_s() == hoop.mu_k() && body.h > 0.0 => {
                Kind::Grazing(Box::new(Slips {
                    law: RollingLaw::of(hoop),
                    slip: None,
                    confirmed: None,
                    shared: data.levels,
                    own: None,
                }))
            }
            Body::Heavy(_) => Kind::None,
        };
        Self {
            hoop,
            proof,
            shared: data.contact,
            own: ContactProof::default(),
            kind,
        }
    }

    /// The outcome if the state proves that the motion never lifts off, and this proof ends it.
    pub(crate) fn at_start(&self, state: &State, mode: Option<Mode>) -> Option<Outcome> {
        (touches(mode) && self.ends_motion(state))
            .then_some(Outcome::StaysInContact { state: *state })
    }

    /// The outcome that an event proves, from the state and the direction of slip after it, and
    /// from the range of the angle of the slide before it.
    pub(crate) fn at_event(
        &mut self,
        event: &Event,
        after: &State,
        direction: Option<SlipDirection>,
        theta_range: Option<(f64, f64)>,
    ) -> Option<Outcome> {
        let endless = match &mut self.kind {
            Kind::None | Kind::Periodic(_) => None,
            Kind::Conservative(visits) => {
                let visit = Visit {
                    theta_range,
                    ..Visit::new(event, direction)
                };
                repeats(visits, visit, self.hoop.mu_s() == 0.0)
            }
            Kind::Grazing(slips) => slips.add(self.hoop, event),
        };
        endless.or_else(|| self.at_start(after, event.to))
    }

    /// Whether links of slips may be skipped, if none of them leads to a grazing orbit.
    pub(crate) const fn may_skip_links(&self) -> bool {
        match self.kind {
            Kind::None | Kind::Grazing(_) => true,
            Kind::Conservative(_) | Kind::Periodic(_) => false,
        }
    }

    /// The period of a motion that is, after an event, where it was after an earlier one.
    #[inline(always)]
    pub(crate) fn period(
        &mut self,
        event: &Event,
        direction: Option<SlipDirection>,
    ) -> Option<Period> {
        match &mut self.kind {
            Kind::None | Kind::Conservative(_) | Kind::Grazing(_) => None,
            Kind::Periodic(visits) => period(visits, Visit::new(event, direction)),
        }
    }

    /// Adds the slip out of rolling after skipped links.
    pub(crate) fn skipped_to(&mut self, slip: &State) {
        match &mut self.kind {
            Kind::None | Kind::Conservative(_) | Kind::Periodic(_) => {}
            Kind::Grazing(slips) => {
                slips.confirmed = None;
                slips.begins(slip);
            }
        }
    }

    pub(crate) fn examines_each_state(&self) -> bool {
        self.proof == Proof::Contact
    }

    /// Whether a state in contact ends the motion by proof; all later states then do, too.
    pub(crate) fn ends_motion(&self, state: &State) -> bool {
        self.proof == Proof::Contact && self.never_lifts_off(state)
    }

    fn never_lifts_off(&self, state: &State) -> bool {
        self.shared.unwrap_or(&self.own).holds(self.hoop, state)
    }

    /// The outcome at a limit, in the mode that would follow: replaces the limit by a proof, if
    /// there is one.
    pub(crate) fn at_limit(&self, limit: Outcome, mode: Option<Mode>) -> Outcome {
        let state = limit.state();
        if self.proof != Proof::None && touches(mode) && self.never_lifts_off(&state) {
            Outcome::StaysInContact { state }
        } else {
            limit
        }
    }
}

fn touches(mode: Option<Mode>) -> bool {
    mode.is_some_and(Mode::touches_plane)
}

/// Adds an event of a conservative motion; returns the outcome if the motion repeats. On a smooth
/// plane, μs = 0, reversals are compared by their distances.
fn repeats(visits: &mut Vec<Visit>, visit: Visit, is_smooth: bool) -> Option<Outcome> {
    let Visit {
        state,
        cause,
        direction,
        ..
    } = visit;
    if !cause.keeps_contact() {
        // A flight may end in an impact, which changes the energy.
        visits.clear();
        return None;
    }
    let back = visits.iter().rposition(|earlier| {
        let is_same_state = is_same(earlier.state.theta_rate, state.theta_rate)
            && is_same_direction(state.theta, earlier.state.theta);
        cause == earlier.cause
            && direction == earlier.direction
            && (is_same_state || (is_smooth && is_same_reversal(visits, earlier, &state)))
    });
    visits.push(visit);
    let back = back?;
    Some(cycle_outcome(visits[back].state, &visits[back + 1..]))
}

/// Adds an event of a conservative motion; returns the period if the motion is where it was before,
/// and forgets its events.
#[inline(never)]
fn period(visits: &mut Vec<Visit>, visit: Visit) -> Option<Period> {
    if !visit.cause.keeps_contact() {
        // A flight may end in an impact, which changes the energy.
        visits.clear();
        return None;
    }
    let state = visit.state;
    let is_same = |earlier: &Visit| {
        let [now, then] = [&state, &earlier.state];
        let turned = angle_between(now.theta, then.theta);
        earlier.cause == visit.cause
            && earlier.direction == visit.direction
            && (now.theta_rate - then.theta_rate).abs()
                <= PERIOD_TOLERANCE * (1.0 + now.theta_rate.abs())
            && turned <= PERIOD_TOLERANCE * (1.0 + now.theta.abs())
    };
    let recent = visits.len().saturating_sub(MAX_EVENTS);
    let back = visits[recent..].iter().rposition(is_same);
    visits.push(visit);
    let cycle = visits.split_off(recent + back?);
    visits.clear();
    let since = cycle[0].state;
    let (mut phases, mut slide_length) = (PhaseSequence::default(), 0.0);
    for pair in cycle.windows(2) {
        let (before, after) = (&pair[0], &pair[1]);
        phases.push(after.from?, before.direction);
        if after.slid() {
            slide_length += length_of_slide(&before.state, &after.state);
        }
    }
    let time = state.time - since.time;
    (time > EQUALITY_TOLERANCE).then(|| Period {
        time,
        theta: TAU * ((state.theta - since.theta) / TAU).round(),
        x: state.x - since.x,
        transitions: cycle.len() - 1,
        slide_length,
        phases,
    })
}

/// The outcome of a motion that repeats the events of a cycle: one endless slide, if all of them
/// are reversals of slides, and another cycle of phases otherwise.
fn cycle_outcome(since: State, cycle: &[Visit]) -> Outcome {
    let state = cycle.last().map_or(since, |visit| visit.state);
    let (period, theta_gained) = (state.time - since.time, state.theta - since.theta);
    let transitions = cycle.len();
    if !cycle
        .iter()
        .all(|visit| visit.slid() && visit.cause == Cause::Reversal)
    {
        return Outcome::RepeatsForever {
            since,
            period,
            theta_gained,
            transitions,
        };
    }
    let recurrence = if theta_gained.abs() > 1.0 {
        Recurrence::Rotation { period }
    } else {
        let ranges = cycle.iter().filter_map(|visit| visit.theta_range);
        let (theta_min, theta_max) = ranges
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), range| {
                (low.min(range.0), high.max(range.1))
            });
        Recurrence::Libration {
            period,
            theta_min,
            theta_max,
        }
    };
    Outcome::SlidesForever { since, recurrence }
}

/// Whether a reversal on a smooth plane is the same as an earlier one of the same direction. There
/// |θ′| is a function of θ, and reversals of the two directions alternate along the path: between
/// two different ones of one direction lies one of the other. The error of a close pair is
/// inversely proportional to its distance, so this distance sets the tolerance.
fn is_same_reversal(visits: &[Visit], earlier: &Visit, state: &State) -> bool {
    let away = |visit: &Visit| angle_between(visit.state.theta, state.theta);
    let others = visits
        .iter()
        .filter(|visit| visit.direction != earlier.direction)
        .map(away);
    let nearest = others.fold(f64::INFINITY, f64::min);
    earlier.cause == Cause::Reversal
        && earlier.state.theta_rate * state.theta_rate > 0.0
        && nearest.is_finite()
        && away(earlier) <= MAX_REVERSAL_DISTANCE_RATIO * nearest
}

impl Slips<'_> {
    fn levels(&mut self, hoop: &Hoop) -> Option<&Levels> {
        let own = &mut self.own;
        self.shared
            .or_else(|| own.get_or_insert_with(|| Levels::new(hoop)).as_ref())
    }

    /// Adds the beginning of a slip out of rolling.
    fn begins(&mut self, state: &State) {
        let energy = self.law.energy(state.theta, state.theta_rate);
        let ahead = libm::sin(state.theta) * state.theta_rate > 0.0;
        self.slip = Some(Slip { energy, ahead });
    }

    /// Adds an event; returns the outcome if the motion slips for ever.
    fn add(&mut self, hoop: &Hoop, event: &Event) -> Option<Outcome> {
        let Event {
            state, cause, to, ..
        } = *event;
        if (cause, to) == (Cause::Slip, Some(Mode::Sliding)) {
            self.begins(&state);
            return None;
        }
        let slip = self
            .slip
            .take()
            .filter(|_| (cause, to) == (Cause::Stick, Some(Mode::Rolling)));
        let before = self.confirmed.take();
        let slip = slip?;
        let energy = self.law.energy(state.theta, state.theta_rate);
        let orbit = self.levels(hoop)?.attracting(hoop, slip.energy, energy)?;
        self.confirmed = Some(slip);
        // An orbit that grazes the limit away from its turning points does so on both sides of the
        // vertical. The losses there differ except in the limit, so a slip on each side is
        // required.
        let is_known =
            orbit.theta_rate == 0.0 || before.is_some_and(|before| before.ahead != slip.ahead);
        let slips_to_halve = 1.0 / (orbit.loss * (energy - orbit.energy));
        is_known.then_some(Outcome::SlipsForever {
            state,
            orbit,
            slips_to_halve,
        })
    }
}
