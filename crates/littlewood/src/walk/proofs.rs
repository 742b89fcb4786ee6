//! What can be proved at an event about all that follows it, so that a motion need not be followed for ever.
//!
//! - Without kinetic friction, and for a massless hoop, energy is conserved in contact: every slip, stick and reversal of a
//!   motion is one of finitely many, and a motion that comes back to one repeats itself.
//! - With μs = μk > 0 slips shrink towards the orbit that grazes the limit of static friction ([`GrazingOrbit`]).
//! - The energy in contact never grows, what of it is not in the horizontal velocity grows within bounds only, and a lift-off needs at
//!   least a certain part of it ([`Hoop::never_lifts_off`]).

use core::f64::consts::TAU;

use crate::mechanics::{ContactProof, RollingLaw};
use crate::model::{Body, Direction, Hoop, Limits, Mode, Proof, State};
use crate::modes::{Levels, Recurrence};
use crate::walk::{Cause, Event, Outcome};

/// Two reversals are the same if this part of the distance to one of the other direction is between them.
const SAME_REVERSAL: f64 = 0.25;

/// What rounding may have moved a number by, relative to one plus its size.
const ROUNDING: f64 = 1e-9;

/// Whether two rates are the same.
pub(crate) fn is_same(a: f64, b: f64) -> bool {
    (a - b).abs() <= ROUNDING * (1.0 + a.abs())
}

/// Whether two angles, of which the first may be the larger by many turns, are the same direction.
pub(crate) fn is_same_direction(a: f64, b: f64) -> bool {
    angle_between(a, b) <= ROUNDING * (1.0 + a.abs())
}

/// The angle between two directions, from 0 to π.
fn angle_between(a: f64, b: f64) -> f64 {
    let turns = ((a - b) / TAU).round();
    (a - b - turns * TAU).abs()
}

/// What has been seen of a motion, as far as proofs need it.
#[derive(Debug)]
pub(crate) struct Proofs<'a> {
    hoop: &'a Hoop,
    proof: Proof,
    /// What others have found for the proof that the hoop never lifts off.
    shared: Option<&'a ContactProof>,
    /// Where none is shared.
    own: ContactProof,
    kind: Kind<'a>,
}

/// What proofs need of a hoop, as far as it has been found for other motions.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Known<'a> {
    pub(crate) levels: Option<&'a Levels>,
    pub(crate) contact: Option<&'a ContactProof>,
}

/// What may be proved of a motion by its events.
#[derive(Debug)]
enum Kind<'a> {
    /// Nothing.
    None,
    /// That it repeats itself.
    Conservative(Vec<Visit>),
    /// That it slips for ever.
    Grazing(Box<Slips<'a>>),
}

/// An event of a motion that conserves its energy.
#[derive(Clone, Copy, Debug)]
struct Visit {
    state: State,
    cause: Cause,
    direction: Option<Direction>,
    /// Angles of the slide that it ends.
    range: Option<(f64, f64)>,
}

/// A slip out of rolling.
#[derive(Clone, Copy, Debug)]
struct Slip {
    energy: f64,
    /// Whether the particle moves away from the upward vertical.
    ahead: bool,
}

/// Slips with μs = μk.
#[derive(Debug)]
struct Slips<'a> {
    law: RollingLaw,
    /// The last slip, if none but complete slips have followed it.
    slip: Option<Slip>,
    /// The slip before it, if it was one towards the grazing orbit.
    confirmed: Option<Slip>,
    /// Levels that others have prepared.
    shared: Option<&'a Levels>,
    /// Where none are shared, once they are needed.
    own: Option<Option<Levels>>,
}

impl<'a> Proofs<'a> {
    pub(crate) fn new(hoop: &'a Hoop, limits: &Limits, known: Known<'a>) -> Self {
        let proof = limits.proof();
        let kind = match hoop.body() {
            Body::Heavy(_) | Body::Massless(_) if proof == Proof::None => Kind::None,
            Body::Massless(_) => Kind::Conservative(Vec::new()),
            Body::Heavy(_) if hoop.mu_k() == 0.0 => Kind::Conservative(Vec::new()),
            Body::Heavy(body) if hoop.mu_s() == hoop.mu_k() && body.h > 0.0 => {
                Kind::Grazing(Box::new(Slips {
                    law: RollingLaw::new(hoop),
                    slip: None,
                    confirmed: None,
                    shared: known.levels,
                    own: None,
                }))
            }
            Body::Heavy(_) => Kind::None,
        };
        Self { hoop, proof, shared: known.contact, own: ContactProof::default(), kind }
    }

    /// Whether the range of the angle of slides is needed.
    pub(crate) const fn wants_range(&self) -> bool {
        matches!(self.kind, Kind::Conservative(_))
    }

    /// What is known where a motion in this mode begins, if that is to end it.
    pub(crate) fn at_start(&self, state: &State, mode: Option<Mode>) -> Option<Outcome> {
        (touches(mode) && self.ends_motion(state)).then_some(Outcome::StaysInContact { state: *state })
    }

    /// What an event proves, with the direction of slip and the state after it, and the range of the angle of a slide that it ends.
    pub(crate) fn at_event(
        &mut self,
        event: &Event,
        (after, direction): (&State, Option<Direction>),
        range: Option<(f64, f64)>,
    ) -> Option<Outcome> {
        let endless = match &mut self.kind {
            Kind::None => None,
            Kind::Conservative(visits) => repeats(visits, event, (direction, self.hoop.mu_s() == 0.0), range),
            Kind::Grazing(slips) => slips.add(self.hoop, event),
        };
        endless.or_else(|| self.at_start(after, event.to))
    }

    /// Whether links of slips may be passed without their events, if none of these is a slip that leads to a grazing orbit.
    pub(crate) const fn may_pass_links(&self) -> bool {
        match self.kind {
            Kind::None | Kind::Grazing(_) => true,
            Kind::Conservative(_) => false,
        }
    }

    /// Takes note of a slip out of rolling at the end of links that were passed.
    pub(crate) fn passed_to(&mut self, slip: &State) {
        match &mut self.kind {
            Kind::None | Kind::Conservative(_) => {}
            Kind::Grazing(slips) => {
                slips.confirmed = None;
                slips.begins(slip);
            }
        }
    }

    /// Whether each state may end the motion.
    pub(crate) fn asks_each_state(&self) -> bool {
        self.proof == Proof::Contact
    }

    /// Whether a state in contact, and all that follow it, ends the motion.
    pub(crate) fn ends_motion(&self, state: &State) -> bool {
        self.proof == Proof::Contact && self.never_lifts_off(state)
    }

    fn never_lifts_off(&self, state: &State) -> bool {
        self.shared.unwrap_or(&self.own).holds(self.hoop, state)
    }

    /// What is known where a limit of transitions stops a motion that goes on in this mode.
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

/// Adds an event to those of a conservative motion; whether the motion repeats itself.
fn repeats(
    visits: &mut Vec<Visit>,
    event: &Event,
    (direction, is_smooth): (Option<Direction>, bool),
    range: Option<(f64, f64)>,
) -> Option<Outcome> {
    let Event { state, cause, .. } = *event;
    if !cause.keeps_contact() {
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
    visits.push(Visit { state, cause, direction, range });
    let back = back?;
    let since = visits[back].state;
    let cycle = &visits[back + 1..];
    let (period, theta_gained) = (state.time - since.time, state.theta - since.theta);
    let transitions = cycle.len();
    let ranges: Option<Vec<(f64, f64)>> =
        cycle.iter().map(|visit| visit.range.filter(|_| visit.cause == Cause::Reversal)).collect();
    let Some(ranges) = ranges else {
        return Some(Outcome::RepeatsForever { since, period, theta_gained, transitions });
    };
    let recurrence = if theta_gained.abs() > 1.0 {
        Recurrence::Rotation { period }
    } else {
        let (theta_min, theta_max) =
            ranges.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), range| {
                (low.min(range.0), high.max(range.1))
            });
        Recurrence::Libration { period, theta_min, theta_max }
    };
    Some(Outcome::SlidesForever { since, recurrence })
}

/// Whether a reversal on a smooth plane is an earlier one of the same direction. There θ′ depends on θ and its sign alone, and reversals to the two
/// sides follow each other: between two of one direction, in one way through the angles, lies one of the other. Two of them next to
/// each other are known to rounding times the inverse of their distance, so that it is this distance that tells.
fn is_same_reversal(visits: &[Visit], earlier: &Visit, state: &State) -> bool {
    let away = |visit: &Visit| angle_between(visit.state.theta, state.theta);
    let others = visits.iter().filter(|visit| visit.direction != earlier.direction).map(away);
    let nearest = others.fold(f64::INFINITY, f64::min);
    earlier.cause == Cause::Reversal
        && earlier.state.theta_rate * state.theta_rate > 0.0
        && nearest.is_finite()
        && away(earlier) <= SAME_REVERSAL * nearest
}

impl Slips<'_> {
    /// The levels of the orbits; none of a hoop that has none.
    fn levels(&mut self, hoop: &Hoop) -> Option<&Levels> {
        let own = &mut self.own;
        self.shared.or_else(|| own.get_or_insert_with(|| Levels::new(hoop)).as_ref())
    }

    /// A slip out of rolling begins.
    fn begins(&mut self, state: &State) {
        let energy = self.law.energy(state.theta, state.theta_rate);
        let ahead = libm::sin(state.theta) * state.theta_rate > 0.0;
        self.slip = Some(Slip { energy, ahead });
    }

    /// Adds an event; whether the motion slips for ever.
    fn add(&mut self, hoop: &Hoop, event: &Event) -> Option<Outcome> {
        let Event { state, cause, to, .. } = *event;
        if (cause, to) == (Cause::Slip, Some(Mode::Sliding)) {
            self.begins(&state);
            return None;
        }
        let slip = self.slip.take();
        let before = self.confirmed.take();
        let slip = slip.filter(|_| (cause, to) == (Cause::Stick, Some(Mode::Rolling)))?;
        let energy = self.law.energy(state.theta, state.theta_rate);
        let orbit = self.levels(hoop)?.attracting(hoop, slip.energy, energy)?;
        self.confirmed = Some(slip);
        // An orbit that grazes the limit away from its turning points does so before and behind the vertical, and slips
        // there differ but for the limit.
        let is_known = orbit.theta_rate == 0.0 || before.is_some_and(|before| before.ahead != slip.ahead);
        let slips_to_halve = 1.0 / (orbit.loss * (energy - orbit.energy));
        is_known.then_some(Outcome::SlipsForever { state, orbit, slips_to_halve })
    }
}
