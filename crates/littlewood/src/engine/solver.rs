//! Phases from [`HoopModel`] where these resolve them to rounding, and solved exactly elsewhere.

use core::cell::Cell;

use crate::ablation::{Part, is_on};
use crate::mechanics::{FrictionlessIntegrals, Settling, contact};
use crate::model::{Direction, Heavy, Hoop, Limits, Massless, State};
use crate::modes::{Entry, Flight, GlideEntry, Hold, RollingLimit, TakeOff};
use crate::walk::candidates::{Evidence, SlipEvidence, weigh};
use crate::walk::follow::{ChainBudget, ChainSegment, next_slip};
use crate::walk::{
    Arrival, Cause, Ending, Exact, Next, Outcome, OutcomeKind, PhaseSequence, Solution, Solved,
    SolvedBy, Solver, next_motion,
};

use super::chain::{LinkSolver, SlipMapValue, SlipMaps, SlipPoint};
use super::error_bound::Drift;
use super::fallback::Fallback;
use super::jump;
use super::model::HoopModel;
use super::orbit::Reached;
use super::roll::{RollEnd, direction_of};
use super::slide::SlideEnd;
use super::state::EngineState;

/// Phases that are computed before cells are kept for a hoop that is not prepared: few motions have
/// more, and those go on for long.
const PHASES_BEFORE_CACHING: u32 = 4;

/// A slide from the static limit with equal coefficients, where η″ vanishes, too.
const ON_LIMIT: Entry = Entry::FromRest {
    slip_acceleration: 0.0,
};

#[derive(Clone, Debug)]
pub(super) struct FastSolver<'a> {
    hoop: &'a Hoop,
    model: &'a HoopModel,
    /// SlipMaps of slips, if they are passed by whole links.
    chains: Option<&'a [SlipMaps]>,
    exact: Exact<'a>,
    /// Phases that are computed before what is kept is used.
    phases_before_caching: Cell<u32>,
    drift: Drift,
}

/// Equilibria of a slide without kinetic friction are nearer than this part of its energy.
const EQUILIBRIUM_TOLERANCE: f64 = 1e-9;

/// The same on a slope, where such a slide ends: the time over the top is known to ε over this
/// part. On a level plane it repeats itself.
const EQUILIBRIUM_TOLERANCE_ON_SLOPES: f64 = 1e-3;

/// Whether a slide without kinetic friction comes so close to the top, at so low a rate, or stays
/// so close to rest at the bottom, that rounding tells whether it passes, or which way it goes.
fn is_next_to_equilibrium(body: &Heavy, place: &EngineState) -> bool {
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
pub(super) struct FastOutcome {
    pub(super) kind: OutcomeKind,
    pub(super) state: State,
}

impl From<Outcome> for FastOutcome {
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

type Ended = Ending<EngineState, FastOutcome>;

impl<'a> FastSolver<'a> {
    pub(super) fn new(hoop: &'a Hoop, model: &'a HoopModel, limits: &Limits) -> Self {
        let (exact, drift) = (
            Exact::new(hoop, limits),
            Drift::new(&model.body, hoop.mu_s()),
        );
        Self {
            hoop,
            model,
            chains: None,
            exact,
            phases_before_caching: Cell::new(0),
            drift,
        }
    }

    /// The solver of an engine for few starts: a motion uses what is kept if it is long. This
    /// depends on the motion alone, so that it has the same bits wherever it is computed.
    pub(super) fn for_few_starts(self) -> Self {
        Self {
            phases_before_caching: Cell::new(PHASES_BEFORE_CACHING),
            ..self
        }
    }

    pub(super) fn with_chains(self, chains: Option<&'a [SlipMaps]>) -> Self {
        Self { chains, ..self }
    }

    /// With a phase that begins: whether it uses what is kept.
    fn is_long(&self) -> bool {
        let left = self.phases_before_caching.get();
        self.phases_before_caching.set(left.saturating_sub(1));
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
                place: EngineState::new(place),
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

    fn contact(&self, place: &EngineState) -> f64 {
        contact(1.0, self.model.body.h, place.direction.1 * place.u())
    }

    /// The evidence from the forces, where it is clear on which side of every limit they are. A
    /// sign that is not may be another one in the simulation, too, unless the state is that of the
    /// simulation to the last bit.
    #[inline(always)]
    fn clear_evidence(
        &self,
        place: &EngineState,
        arrival: Arrival,
    ) -> Option<Evidence<impl Fn(Direction) -> f64>> {
        let EngineState {
            state,
            direction: (sin, cos),
            ..
        } = *place;
        let w = self.contact(place);
        let Heavy {
            mass, h, inertia, ..
        } = self.model.body;
        let drift = &self.drift;
        if !drift.is_clear(w, 1.0 + h * place.u()) {
            return None;
        }
        let slip = match Direction::of_sign(state.slip) {
            Some(direction) => SlipEvidence::Moving(direction),
            None if !drift.is_known(w, 1.0 + h * place.u()) => return None,
            None => self.clear_rest(place, w, arrival)?,
        };
        let solvability = move |direction| {
            let law = self.model.sliding(direction);
            law.p(sin, law.q(1.0, sin, cos))
        };
        if !self.model.is_solvable {
            let size = inertia + mass * h * (1.0 + self.hoop.mu_k());
            let [negative, positive] = Direction::ALL.map(solvability);
            if !(drift.is_clear(negative, size)
                && drift.is_clear(positive, size)
                && negative.min(positive) > 0.0)
            {
                return None;
            }
        }
        Some(Evidence {
            contact: w,
            leaves: w < 0.0,
            slip,
            solvability,
            is_solvable: true,
            on_limit: false,
        })
    }

    /// The same at η′ = 0.
    #[inline(always)]
    fn clear_rest(&self, place: &EngineState, w: f64, arrival: Arrival) -> Option<SlipEvidence> {
        let law = &self.model.rolling;
        let u = place.u();
        let denominator = law.denominator_of(place.direction);
        let forces = law.forces_at(place.direction, [1.0, u], denominator);
        let excess = forces.friction.abs() - self.hoop.mu_s() * forces.normal;
        let size = law.mass * (1.0 + u + law.tilt.abs()) * (1.0 + self.hoop.mu_s());
        let hold = match arrival {
            Arrival::Open | Arrival::RollingLimit(_) if w < 0.0 => Hold::NoNormalForce,
            Arrival::RollingLimit(RollingLimit::Friction(direction)) => Hold::Slips {
                direction,
                excess: 0.0,
            },
            Arrival::Open if self.drift.is_clear(excess, size) && place.state.theta_rate != 0.0 => {
                if excess < 0.0 {
                    Hold::Holds
                } else {
                    Hold::Slips {
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
            | Arrival::Open => return None,
        };
        if let Hold::Slips { excess, .. } = hold {
            // With equal coefficients the acceleration of the slip vanishes on the limit.
            let drive = excess + (self.hoop.mu_s() - self.hoop.mu_k()) * forces.normal;
            if drive <= 0.0 {
                return None;
            }
        }
        Some(SlipEvidence::AtRest {
            hold,
            rolling_forces: forces,
            denominator,
        })
    }

    /// Takes note of a phase that was computed here, to a state.
    #[inline(always)]
    fn computed(&self, end: &State) {
        self.drift.add_phase(end.theta);
    }

    /// A phase that is cut at a state by the limit of time.
    const fn cut(end: State) -> Ended {
        let verdict = FastOutcome {
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
    fn rolled(&self, place: &EngineState) -> Option<State> {
        let (state, travel) = (place.state, place.travel());
        let Reached { theta, theta_rate } = self.model.rolled(place, self.until() - state.time)?;
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

impl LinkSolver for FastSolver<'_> {
    fn link(
        &self,
        chains: &SlipMaps,
        slip: SlipPoint,
        theta_rate: f64,
    ) -> Option<(State, Direction, f64, PhaseSequence)> {
        let solver = Self::new(self.hoop, self.model, &Limits::default());
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
        let place = EngineState::new(state);
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
    type Place = EngineState;
    type Solution = Option<Flight>;
    type Verdict = FastOutcome;

    fn hoop(&self) -> &Hoop {
        self.hoop
    }

    fn until(&self) -> f64 {
        self.exact.until()
    }

    fn place(&self, state: State) -> EngineState {
        EngineState::new(state)
    }

    fn state(place: &EngineState) -> State {
        place.state
    }

    #[inline(always)]
    fn decide(&self, place: &EngineState, arrival: Arrival) -> Next {
        if arrival == Arrival::LiftOff {
            // What the slide has found is not computed again.
            return next_motion(self.hoop, &place.state, arrival);
        }
        match self.clear_evidence(place, arrival) {
            Some(evidence) => weigh(self.hoop, &self.model.body, &place.state, &evidence),
            None => next_motion(self.hoop, &place.state, arrival),
        }
    }

    #[inline(always)]
    fn roll(&self, place: &EngineState, on_limit: bool) -> SolvedBy<Self> {
        let state = place.state;
        let travel = place.travel();
        let left_to_the_simulation = |doubt: Fallback| {
            self.model.fallbacks.add(doubt);
            Self::take(self.exact.roll(&state, on_limit))
        };
        if self.drift.is_far(state.theta) {
            return left_to_the_simulation(Fallback::Far);
        }
        let is_long = self.is_long();
        if self.model.leaves_rolling(is_long) {
            return Self::take(self.exact.roll(&state, on_limit));
        }
        let ending: Ended = match self.model.roll(place, on_limit, is_long) {
            Ok(RollEnd::Never) => Ending::Motion {
                event: None,
                end: None,
                verdict: FastOutcome {
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
                    place: EngineState {
                        state: end,
                        direction: (travel * sin, cos),
                    },
                    cause: limit.cause(),
                    arrival: Arrival::RollingLimit(limit),
                }
            }
            Ok(RollEnd::Slip { .. }) => match self.rolled(place) {
                Some(end) => Self::cut(end),
                None => return left_to_the_simulation(Fallback::Separatrix),
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
        place: &EngineState,
        body: &Heavy,
        direction: Direction,
        entry: Entry,
    ) -> SolvedBy<Self> {
        let state = place.state;
        let is_conservative = self.hoop.mu_k() == 0.0;
        let for_ever = FastOutcome {
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
        let left_to_the_simulation = |doubt: Fallback| {
            self.model.fallbacks.add(doubt);
            // As the simulation has it, but for the last digits of an acceleration from which it
            // begins.
            let solved = self.exact.slide(&state, body, direction, entry);
            if entry != Entry::Moving && entry != ON_LIMIT {
                self.drift.add_phase(state.theta);
            }
            Self::take(solved)
        };
        if self.drift.is_far(state.theta) {
            return left_to_the_simulation(Fallback::Far);
        }
        if entry != Entry::Moving
            && !self
                .drift
                .is_known(self.contact(place), 1.0 + body.h * place.u())
        {
            return left_to_the_simulation(Fallback::Cancelled);
        }
        if is_conservative && is_next_to_equilibrium(body, place) {
            return left_to_the_simulation(Fallback::Separatrix);
        }
        let allowed = self.until() - state.time;
        let from_limit = entry == ON_LIMIT;
        let (event, is_cut) =
            match self
                .model
                .slide(place, direction, from_limit, allowed, self.is_long())
            {
                Ok(SlideEnd::Event(event)) => (event, false),
                Ok(SlideEnd::Cut(event)) => (event, true),
                Ok(SlideEnd::Never) => return never(),
                Err(doubt) => return left_to_the_simulation(doubt),
            };
        let law = self.model.sliding(direction);
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
            (Cause::Stick, Arrival::Open)
        };
        let place = EngineState {
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
    fn fly(&self, place: &EngineState, body: &Heavy, take_off: TakeOff) -> SolvedBy<Self> {
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

    fn settle(&self, place: &EngineState, body: &Heavy, settling: &Settling) -> SolvedBy<Self> {
        Self::take(self.exact.settle(&place.state, body, settling))
    }

    fn glide(&self, place: &EngineState, body: &Massless, entry: GlideEntry) -> SolvedBy<Self> {
        Self::take(self.exact.glide(&place.state, body, entry))
    }

    fn pass_links(
        &self,
        place: &EngineState,
        direction: Direction,
        room: &ChainBudget<'_>,
    ) -> Option<ChainSegment<EngineState>> {
        let (state, travel) = (place.state, place.travel());
        let chains = if travel < 0.0 {
            self.chains?.last()
        } else {
            self.chains?.first()
        }?;
        let frame = chains.frame();
        let start = seen(&state, frame);
        let point = chains.point(&start, seen_direction(direction, frame))?;
        let after = |passage: &SlipMapValue| {
            let (slip, rate) = chains.slip(passage.end)?;
            Some((
                slip,
                seen(&passage.state_after(&start, (slip.angle, rate)), frame),
            ))
        };
        let has_room = |passage: &SlipMapValue| {
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
        let place = EngineState::new(end);
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
