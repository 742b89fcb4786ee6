//! Phases from [`Laws`] where these resolve them to rounding, and solved exactly elsewhere.

use core::cell::Cell;

use crate::ablation::{Part, is_on};
use crate::mechanics::{FrictionlessIntegrals, Settling, contact};
use crate::model::{Direction, Heavy, Hoop, Limits, Massless, State};
use crate::modes::{Entry, Flight, GlideEntry, RollingLimit, Stiction, TakeOff};
use crate::walk::candidates::{ModeInputs, RestInputs, SlipInputs, may_wedge, select_mode};
use crate::walk::follow::{ChainBudget, ChainSegment, next_slip};
use crate::walk::{
    Arrival, Cause, Ending, Exact, NextMotion, Outcome, OutcomeKind, PhaseSequence, Solution,
    Solved, SolvedBy, Solver, next_motion,
};

use super::chain::{Chains, Follow, Passage, SlipPoint};
use super::doubt::Doubt;
use super::drift::Drift;
use super::jump;
use super::laws::Laws;
use super::orbit::Reached;
use super::place::Place;
use super::roll::{RollEnd, direction_of};
use super::slide::SlideEnd;

/// Phases that are computed before cells are kept for a hoop that is not prepared: few motions have
/// more, and those go on for long.
const PHASES_WITHOUT_CELLS: u32 = 4;

/// A slide from the static limit with equal coefficients, where η″ vanishes, too.
const ON_LIMIT: Entry = Entry::FromRest {
    slip_acceleration: 0.0,
};

#[derive(Clone, Debug)]
pub(super) struct FastSolver<'a> {
    hoop: &'a Hoop,
    laws: &'a Laws,
    /// Chains of slips, if they are passed by whole links.
    chains: Option<&'a [Chains]>,
    exact: Exact<'a>,
    /// Phases that are computed before what is kept is used.
    phases_without: Cell<u32>,
    drift: Drift,
}

/// Equilibria of a slide without kinetic friction are nearer than this part of its energy.
const EQUILIBRIUM_TOLERANCE: f64 = 1e-9;

/// The same on a slope, where such a slide ends: the time over the top is known to ε over this
/// part. On a level plane it repeats itself.
const EQUILIBRIUM_TOLERANCE_ON_SLOPES: f64 = 1e-3;

/// Whether a slide without kinetic friction comes so close to the top, at so low a rate, or stays
/// so close to rest at the bottom, that rounding tells whether it passes, or which way it goes.
fn is_next_to_equilibrium(body: &Heavy, place: &Place) -> bool {
    let energy = FrictionlessIntegrals::new(body, &place.state, place.direction).energy;
    let over_bottom = energy + 2.0 * body.offset;
    let tolerance = if body.tilt == 0.0 {
        EQUILIBRIUM_TOLERANCE
    } else {
        EQUILIBRIUM_TOLERANCE_ON_SLOPES
    };
    over_bottom <= 8.0 * f64::EPSILON * body.offset
        || (energy - 2.0 * body.offset).abs() <= tolerance * energy.abs()
}

/// How a motion ended, as far as a summary tells.
#[derive(Clone, Copy, Debug)]
pub(super) struct Verdict {
    pub(super) kind: OutcomeKind,
    pub(super) state: State,
}

impl From<Outcome> for Verdict {
    fn from(outcome: Outcome) -> Self {
        Self {
            kind: outcome.kind(),
            state: outcome.state(),
        }
    }
}

impl Solution for Option<Flight> {
    fn flight(&self) -> Option<&Flight> {
        self.as_ref()
    }
}

type Ended = Ending<Place, Verdict>;

impl<'a> FastSolver<'a> {
    pub(super) fn new(hoop: &'a Hoop, laws: &'a Laws, limits: &Limits) -> Self {
        let (exact, drift) = (
            Exact::new(hoop, limits),
            Drift::new(&laws.body, hoop.mu_s()),
        );
        Self {
            hoop,
            laws,
            chains: None,
            exact,
            phases_without: Cell::new(0),
            drift,
        }
    }

    /// The solver of an engine for few starts: a motion uses what is kept if it is long. This
    /// depends on the motion alone, so that it has the same bits wherever it is computed.
    pub(super) fn for_few_starts(self) -> Self {
        Self {
            phases_without: Cell::new(PHASES_WITHOUT_CELLS),
            ..self
        }
    }

    pub(super) fn with_chains(self, chains: Option<&'a [Chains]>) -> Self {
        Self { chains, ..self }
    }

    /// With a phase that begins: whether it uses what is kept.
    fn is_long(&self) -> bool {
        let left = self.phases_without.get();
        self.phases_without.set(left.saturating_sub(1));
        left == 0 && is_on(Part::KeptCells)
    }

    /// Whether rounding may have decided on what follows otherwise than in the simulation.
    pub(super) const fn has_drifted(&self) -> bool {
        self.drift.is_told()
    }

    fn is_in_time(&self, state: &State, elapsed: f64) -> bool {
        elapsed <= self.until() - state.time
    }

    /// Converts a phase that was solved exactly.
    fn take(solved: SolvedBy<Exact<'_>>) -> SolvedBy<Self> {
        let ending = match solved.ending {
            Ending::Event {
                place,
                cause,
                arrival,
            } => Ending::Event {
                place: Place::new(place),
                cause,
                arrival,
            },
            Ending::Landing { state, gap_rate } => Ending::Landing { state, gap_rate },
            Ending::Settled { state, settling } => Ending::Settled { state, settling },
            Ending::Singular { state, solvability } => Ending::Singular { state, solvability },
            Ending::Motion {
                event,
                end,
                verdict,
            } => Ending::Motion {
                event,
                end,
                verdict: verdict.into(),
            },
        };
        Solved {
            solution: solved.solution.flight().copied(),
            direction: solved.direction,
            ending,
        }
    }

    fn contact(&self, place: &Place) -> f64 {
        contact(1.0, self.laws.body.h, place.direction.1 * place.u())
    }

    /// What selects the mode, from the forces, where it is clear on which side of every limit they
    /// are. A sign that is not may be another one in the simulation, too, unless the state is that
    /// of the simulation to the last bit.
    #[inline(always)]
    fn clear_inputs(&self, place: &Place, arrival: Arrival) -> Option<ModeInputs> {
        let Place {
            state,
            direction: (sin, cos),
            ..
        } = *place;
        let w = self.contact(place);
        let Heavy {
            mass, h, inertia, ..
        } = self.laws.body;
        let drift = &self.drift;
        if !drift.is_clear(w, 1.0 + h * place.u()) {
            return None;
        }
        let slip = match Direction::of_sign(state.slip) {
            Some(direction) => SlipInputs::Moving(direction),
            None if !drift.is_known(w, 1.0 + h * place.u()) => return None,
            None => SlipInputs::AtRest(self.clear_rest(place, w, arrival)?),
        };
        let painleve = Direction::ALL.map(|direction| {
            let law = self.laws.sliding(direction);
            law.p(sin, law.q(1.0, sin, cos))
        });
        if !self.laws.is_solvable {
            let size = inertia + mass * h * (1.0 + self.hoop.mu_k());
            let [negative, positive] = painleve;
            if !(drift.is_clear(negative, size)
                && drift.is_clear(positive, size)
                && negative.min(positive) > 0.0)
            {
                return None;
            }
        }
        Some(ModeInputs {
            contact_margin: w,
            lifts_off: w < 0.0,
            slip,
            painleve,
            keeps_contact: arrival != Arrival::Start,
            on_limit: false,
        })
    }

    /// The same at η′ = 0.
    #[inline(always)]
    fn clear_rest(&self, place: &Place, w: f64, arrival: Arrival) -> Option<RestInputs> {
        let law = &self.laws.rolling;
        let u = place.u();
        let effective_inertia = law.denominator_of(place.direction);
        let forces = law.forces_at(place.direction, [1.0, u], effective_inertia);
        let excess = forces.friction.abs() - self.hoop.mu_s() * forces.normal;
        let size = law.mass * (1.0 + u + law.tilt.abs()) * (1.0 + self.hoop.mu_s());
        let stiction = match arrival {
            Arrival::Start | Arrival::InContact | Arrival::RollingLimit(_)
                if w < 0.0 && !may_wedge(&self.laws.body, place.direction.0, u) =>
            {
                Stiction::NoNormalForce
            }
            Arrival::RollingLimit(RollingLimit::Friction(direction)) => Stiction::Slips {
                direction,
                excess: 0.0,
            },
            Arrival::Start | Arrival::InContact
                if self.drift.is_clear(excess, size) && place.state.theta_rate != 0.0 =>
            {
                if excess < 0.0 {
                    Stiction::Holds
                } else {
                    Stiction::Slips {
                        direction: Direction::of_sign(-forces.friction)?,
                        excess,
                    }
                }
            }
            // Known by how it was reached, or from rest.
            Arrival::BackOnLimit(_)
            | Arrival::RollingLimit(RollingLimit::NormalForce)
            | Arrival::GlideAtRest { .. }
            | Arrival::LiftOff
            | Arrival::Start
            | Arrival::InContact => return None,
        };
        if let Stiction::Slips { excess, .. } = stiction {
            // With equal coefficients the acceleration of the slip vanishes on the limit.
            let drive = excess + (self.hoop.mu_s() - self.hoop.mu_k()) * forces.normal;
            if drive <= 0.0 {
                return None;
            }
        }
        Some(RestInputs {
            stiction,
            rolling_forces: forces,
            effective_inertia,
        })
    }

    /// Takes note of a phase that was computed here, to a state.
    #[inline(always)]
    fn computed(&self, end: &State) {
        self.drift.add_phase(end.theta);
    }

    /// A phase that is cut at a state by the limit of time.
    const fn cut(end: State) -> Ended {
        let verdict = Verdict {
            kind: OutcomeKind::TimeLimit,
            state: end,
        };
        Ending::Motion {
            event: None,
            end: Some(end),
            verdict,
        }
    }

    /// Where rolling from a place has led at the limit of time.
    fn rolled(&self, place: &Place) -> Option<State> {
        let (state, travel) = (place.state, place.travel());
        let Reached { theta, theta_rate } = self.laws.rolled(place, self.until() - state.time)?;
        let theta = travel * theta;
        let x = state.x - (theta - state.theta);
        Some(State {
            time: self.until(),
            theta,
            theta_rate: travel * theta_rate,
            slip: 0.0,
            x,
        })
    }
}

/// A state in a frame that is mirrored for −1.
fn seen(state: &State, frame: f64) -> State {
    let State {
        time,
        theta,
        theta_rate,
        slip,
        x,
    } = *state;
    if frame < 0.0 {
        State {
            time,
            theta: -theta,
            theta_rate: -theta_rate,
            slip: -slip,
            x: -x,
        }
    } else {
        *state
    }
}

/// A direction in such a frame.
const fn seen_direction(direction: Direction, frame: f64) -> Direction {
    if frame < 0.0 {
        direction.reversed()
    } else {
        direction
    }
}

impl Follow for FastSolver<'_> {
    fn link(
        &self,
        chains: &Chains,
        slip: SlipPoint,
        theta_rate: f64,
    ) -> Option<(State, Direction, f64, PhaseSequence)> {
        let solver = Self::new(self.hoop, self.laws, &Limits::default());
        let frame = chains.frame();
        let state = seen(
            &State {
                time: 0.0,
                theta: slip.angle,
                theta_rate,
                slip: 0.0,
                x: 0.0,
            },
            frame,
        );
        let place = Place::new(state);
        let mut phases = PhaseSequence::default();
        let tell = |mode, direction| {
            phases.push(mode, direction);
            !phases.is_truncated()
        };
        let (end, direction, slid) =
            next_slip(&solver, place, direction_of(slip.side, frame), tell)?;
        if solver.has_drifted() {
            return None;
        }
        if chains.is_last(self.hoop, &state, &end, phases) {
            return None;
        }
        let phases = if frame < 0.0 {
            phases.mirrored()
        } else {
            phases
        };
        Some((
            seen(&end, frame),
            seen_direction(direction, frame),
            slid,
            phases,
        ))
    }
}

impl Solver for FastSolver<'_> {
    type Place = Place;
    type Solution = Option<Flight>;
    type Verdict = Verdict;

    fn hoop(&self) -> &Hoop {
        self.hoop
    }

    fn until(&self) -> f64 {
        self.exact.until()
    }

    fn place(&self, state: State) -> Place {
        Place::new(state)
    }

    fn state(place: &Place) -> State {
        place.state
    }

    #[inline(always)]
    fn decide(&self, place: &Place, arrival: Arrival) -> NextMotion {
        if arrival == Arrival::LiftOff {
            // What the slide has found is not computed again.
            return next_motion(self.hoop, &place.state, arrival);
        }
        match self.clear_inputs(place, arrival) {
            Some(inputs) => select_mode(self.hoop, &self.laws.body, &place.state, &inputs),
            None => next_motion(self.hoop, &place.state, arrival),
        }
    }

    #[inline(always)]
    fn roll(&self, place: &Place, on_limit: bool) -> SolvedBy<Self> {
        let state = place.state;
        let travel = place.travel();
        let left_to_the_simulation = |doubt: Doubt| {
            self.laws.tally.add(doubt);
            Self::take(self.exact.roll(&state, on_limit))
        };
        if self.drift.is_far(state.theta) {
            return left_to_the_simulation(Doubt::Far);
        }
        let is_long = self.is_long();
        if self.laws.leaves_rolling(is_long) {
            return Self::take(self.exact.roll(&state, on_limit));
        }
        let ending: Ended = match self.laws.roll(place, on_limit, is_long) {
            Ok(RollEnd::Never) => Ending::Motion {
                event: None,
                end: None,
                verdict: Verdict {
                    kind: OutcomeKind::RollsForever,
                    state,
                },
            },
            Ok(RollEnd::Slip {
                elapsed,
                theta,
                theta_rate,
                side,
                direction: (sin, cos),
            }) if self.is_in_time(&state, elapsed) => {
                let theta = travel * theta;
                let towards = direction_of(side, travel);
                let end = State {
                    time: state.time + elapsed,
                    theta,
                    theta_rate: travel * theta_rate,
                    slip: 0.0,
                    x: state.x - (theta - state.theta),
                };
                let limit = RollingLimit::Friction(towards);
                self.computed(&end);
                Ending::Event {
                    place: Place {
                        state: end,
                        direction: (travel * sin, cos),
                    },
                    cause: limit.cause(),
                    arrival: Arrival::RollingLimit(limit),
                }
            }
            Ok(RollEnd::Slip { .. }) => match self.rolled(place) {
                Some(end) => Self::cut(end),
                None => return left_to_the_simulation(Doubt::Separatrix),
            },
            Err(doubt) => return left_to_the_simulation(doubt),
        };
        Solved {
            solution: None,
            direction: None,
            ending,
        }
    }

    #[inline(always)]
    fn slide(
        &self,
        place: &Place,
        body: &Heavy,
        direction: Direction,
        entry: Entry,
    ) -> SolvedBy<Self> {
        let state = place.state;
        let is_conservative = self.hoop.mu_k() == 0.0;
        let for_ever = Verdict {
            kind: OutcomeKind::SlidesForever,
            state,
        };
        let never = || {
            let ending = Ending::Motion {
                event: None,
                end: None,
                verdict: for_ever,
            };
            Solved {
                solution: None,
                direction: Some(direction),
                ending,
            }
        };
        let left_to_the_simulation = |doubt: Doubt| {
            self.laws.tally.add(doubt);
            // As the simulation has it, but for the last digits of an acceleration from which it
            // begins.
            let solved = self.exact.slide(&state, body, direction, entry);
            if entry != Entry::Moving && entry != ON_LIMIT {
                self.drift.add_phase(state.theta);
            }
            Self::take(solved)
        };
        if self.drift.is_far(state.theta) {
            return left_to_the_simulation(Doubt::Far);
        }
        if entry != Entry::Moving
            && !self
                .drift
                .is_known(self.contact(place), 1.0 + body.h * place.u())
        {
            return left_to_the_simulation(Doubt::Cancelled);
        }
        if is_conservative && is_next_to_equilibrium(body, place) {
            return left_to_the_simulation(Doubt::Separatrix);
        }
        let allowed = self.until() - state.time;
        let from_limit = entry == ON_LIMIT;
        let (event, is_cut) =
            match self
                .laws
                .slide(place, direction, from_limit, allowed, self.is_long())
            {
                Ok(SlideEnd::Event(event)) => (event, false),
                Ok(SlideEnd::Cut(event)) => (event, true),
                Ok(SlideEnd::Never) => return never(),
                Err(doubt) => return left_to_the_simulation(doubt),
            };
        let law = self.laws.sliding(direction);
        let here = event.direction;
        let end = State {
            time: if is_cut {
                self.until()
            } else {
                state.time + event.elapsed
            },
            theta: event.theta,
            theta_rate: event.theta_rate,
            slip: event.slip,
            x: law
                .path([state.theta_rate, state.slip, state.x], place.direction)
                .x(event.elapsed, here),
        };
        self.computed(&end);
        if is_cut {
            let goes_on = direction.sign() * law.drag() <= 0.0;
            let repeats = goes_on && event.is_behind_a_period(state.theta, is_conservative);
            let ending = if repeats {
                Ending::Motion {
                    event: None,
                    end: Some(end),
                    verdict: for_ever,
                }
            } else {
                Self::cut(end)
            };
            return Solved {
                solution: None,
                direction: Some(direction),
                ending,
            };
        }
        let (cause, arrival) = if event.lifts_off {
            (Cause::LiftOff, Arrival::LiftOff)
        } else {
            (Cause::Stick, Arrival::InContact)
        };
        let place = Place {
            state: end,
            direction: here,
        };
        Solved {
            solution: None,
            direction: Some(direction),
            ending: Ending::Event {
                place,
                cause,
                arrival,
            },
        }
    }

    #[inline(always)]
    fn fly(&self, place: &Place, body: &Heavy, take_off: TakeOff) -> SolvedBy<Self> {
        let state = place.state;
        // Whatever follows from a state of the simulation goes on as there.
        if self.drift.is_none() && self.hoop.restitution().is_some() {
            return Self::take(self.exact.fly(&state, body, take_off));
        }
        let flight = match take_off {
            TakeOff::Grazing => {
                let (travel, (sin, cos)) = (place.travel(), place.direction);
                match jump::angles(
                    travel * state.theta,
                    (travel * sin, cos),
                    -self.contact(place),
                ) {
                    Some(angles) => {
                        Flight::with_angles(body, state, take_off, place.direction, angles)
                    }
                    None => Flight::from_direction(body, state, take_off, place.direction),
                }
            }
            // So close to w = 0 the exact rules have decided, with their own cosine.
            TakeOff::Unloaded
                if !self
                    .drift
                    .is_clear(self.contact(place), 1.0 + body.h * place.u()) =>
            {
                Flight::new(body, state, take_off)
            }
            TakeOff::Unloaded | TakeOff::Rising { .. } => {
                Flight::from_direction(body, state, take_off, place.direction)
            }
        };
        let duration = flight.duration();
        if let Some(restitution) = self.hoop.restitution() {
            self.drift
                .add_flight(&flight, &state, place.direction, restitution.coefficient());
        }
        let ending = if self.is_in_time(&state, duration) {
            Ending::Landing {
                state: flight.state(duration),
                gap_rate: flight.landing_rate(),
            }
        } else {
            Self::cut(State {
                time: self.until(),
                ..flight.state(self.until() - state.time)
            })
        };
        Solved {
            solution: Some(flight),
            direction: None,
            ending,
        }
    }

    fn settle(&self, place: &Place, body: &Heavy, settling: &Settling) -> SolvedBy<Self> {
        Self::take(self.exact.settle(&place.state, body, settling))
    }

    fn glide(&self, place: &Place, body: &Massless, entry: GlideEntry) -> SolvedBy<Self> {
        Self::take(self.exact.glide(&place.state, body, entry))
    }

    fn pass_links(
        &self,
        place: &Place,
        direction: Direction,
        room: &ChainBudget<'_>,
    ) -> Option<ChainSegment<Place>> {
        let (state, travel) = (place.state, place.travel());
        let chains = if travel < 0.0 {
            self.chains?.last()
        } else {
            self.chains?.first()
        }?;
        let frame = chains.frame();
        let start = seen(&state, frame);
        let point = chains.point(&start, seen_direction(direction, frame))?;
        let after = |passage: &Passage| {
            let (slip, rate) = chains.slip(passage.end)?;
            Some((
                slip,
                seen(&passage.state_after(&start, (slip.angle, rate)), frame),
            ))
        };
        let has_room = |passage: &Passage| {
            passage.route.transitions <= room.transitions
                && passage.slid <= room.slides
                && self.is_in_time(&state, passage.elapsed)
                && room
                    .open
                    .is_none_or(|open| after(passage).is_some_and(|(_, state)| open(&state)))
        };
        let (passage, phases) = if room.record_phases {
            chains.links(point, self, has_room)?
        } else {
            (
                chains.pass(point, self, has_room)?,
                PhaseSequence::default(),
            )
        };
        let (slip, end) = after(&passage)?;
        let place = Place::new(end);
        let towards = direction_of(slip.side, place.travel());
        self.computed(&end);
        Some(ChainSegment {
            place,
            direction: towards,
            transitions: passage.route.transitions,
            slid: passage.slid,
            phases: if travel < 0.0 {
                phases.mirrored()
            } else {
                phases
            },
        })
    }
}
