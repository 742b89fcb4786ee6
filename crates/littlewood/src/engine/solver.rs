//! Phases from [`HoopModel`] where these resolve them to rounding, and solved exactly elsewhere.

use core::cell::Cell;
use std::sync::OnceLock;

use crate::ablation::{Part, is_on};
use crate::math::trig::Angle;
use crate::mechanics::{
    ContactMotion, FrictionlessIntegrals, Loads, MarginAtTop, Settling, contact,
};
use crate::model::{Heavy, Hoop, Limits, Massless, SlipDirection, State};
use crate::modes::{
    Entry, Flight, ForceRounding, GlideEntry, PhasePoint, RollingLimit, Stiction, TakeOff,
};
use crate::walk::candidates::{
    ContactMargin, ModeInputs, RestInputs, SlipInputs, may_wedge, select_mode,
};
use crate::walk::follow::{NextSlip, next_slip};
use crate::walk::solver::{SkipBudget, SkippedLinks};
use crate::walk::{
    Arrival, Cause, Exact, NextMotion, Outcome, OutcomeKind, PhaseEnd, PhaseResult, PhaseSequence,
    ResistedMotion, Solution, Solver,
};

use super::chain::{LinkSolver, SlipMapValue, SlipMaps, SlipPoint};
use super::error_bound::{DecisiveNumber, ErrorBound, is_out_of_range};
use super::fallback::Fallback;
use super::jump;
use super::model::{HoopModel, SlideStart};
use super::orbit::OrbitPoint;
use super::roll::{RollEnd, RollSlip, mirrored_slip};
use super::slide::{SlideEnd, SlideEvent};
use super::state::{EngineState, mirrored_by};

/// Phases that are computed before cells are kept for a hoop that is not prepared: few motions have
/// more, and those go on for long.
const PHASES_BEFORE_CACHING: u32 = 4;

/// A slide from the static limit with equal coefficients, where η″ vanishes, too.
const ON_LIMIT: Entry = Entry::FromRest {
    slip_acceleration: 0.0,
};

/// A slide to be followed.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlidePhase {
    pub(super) direction: SlipDirection,
    pub(super) entry: Entry,
    pub(super) may_lift_off: bool,
    /// The direction of rotation, with rolling resistance.
    pub(super) towards: Option<f64>,
}

#[derive(Clone, Debug)]
pub(super) struct FastSolver<'a> {
    pub(super) hoop: &'a Hoop,
    pub(super) model: &'a HoopModel,
    /// SlipMaps of slips, if they are passed by whole links.
    slip_maps: Option<&'a OnceLock<Vec<SlipMaps>>>,
    pub(super) exact: Exact<'a>,
    /// Phases of a motion before its slips are.
    phases_before_links: u32,
    /// Phases before tables are used.
    phases_before_caching: u32,
    /// Phases in contact so far.
    phases: Cell<u32>,
    /// In a cell, since [`Solver`] has no state but this, the count of phases, and the next.
    pub(super) error: Cell<ErrorBound>,
    pub(super) interpolates_slides: bool,
    /// Whether the last phase was rolling that has slipped.
    pub(super) has_slipped: Cell<bool>,
    /// Whether a flight has landed.
    has_landed: Cell<bool>,
}

/// Equilibria of a slide without kinetic friction are nearer than this part of its energy.
const EQUILIBRIUM_TOLERANCE: f64 = 1e-9;

/// The same on a slope, where such a slide ends: the time over the top is known to ε over this
/// part. On a level plane it repeats itself.
const EQUILIBRIUM_TOLERANCE_ON_SLOPES: f64 = 1e-3;

/// Whether a slide without kinetic friction comes so close to the top, at so low a rate, or stays
/// so close to rest at the bottom, that rounding tells whether it passes, or which way it goes.
fn is_next_to_equilibrium(body: &Heavy, place: &EngineState) -> bool {
    let energy = FrictionlessIntegrals::new(body, &place.state, place.angle).energy;
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

/// What a summary tells of a flight, which itself is six times as large.
#[derive(Clone, Copy, Debug)]
pub(super) struct Jump {
    take_off_rate: f64,
    /// Not computed behind a landing, where nothing tells of it.
    height: f64,
}

impl Solution for Option<Jump> {
    fn take_off_rate(&self) -> Option<f64> {
        self.map(|jump| jump.take_off_rate)
    }

    fn height(&self) -> f64 {
        self.map_or(0.0, |jump| jump.height)
    }
}

pub(super) type Ended = PhaseEnd<EngineState, FastOutcome>;

impl<'a> FastSolver<'a> {
    pub(super) fn new(hoop: &'a Hoop, model: &'a HoopModel, limits: &Limits) -> Self {
        Self {
            hoop,
            model,
            slip_maps: None,
            exact: Exact::new(hoop, limits),
            phases_before_links: 0,
            phases_before_caching: 0,
            phases: Cell::new(0),
            error: Cell::new(ErrorBound::Exact),
            interpolates_slides: false,
            has_slipped: Cell::new(false),
            has_landed: Cell::new(false),
        }
    }

    /// Interpolates slides out of rolling.
    pub(super) fn with_interpolated_slides(self, interpolates_slides: bool) -> Self {
        Self {
            interpolates_slides,
            ..self
        }
    }

    /// The solver of an engine for few starts: a motion uses what is kept if it is long. This
    /// depends on the motion alone, so that it has the same bits wherever it is computed.
    pub(super) fn for_few_starts(self) -> Self {
        Self {
            phases_before_caching: PHASES_BEFORE_CACHING,
            ..self
        }
    }

    /// Its first phases, so many, are those of the simulation.
    pub(super) fn behind_simulated(self, phases: u32) -> Self {
        Self {
            error: Cell::new(ErrorBound::behind_simulated(phases)),
            ..self
        }
    }

    /// Passes slips by whole links, after so many phases.
    pub(super) fn with_slip_maps(
        self,
        slip_maps: Option<&'a OnceLock<Vec<SlipMaps>>>,
        phases_before_links: u32,
    ) -> Self {
        Self {
            slip_maps,
            phases_before_links,
            ..self
        }
    }

    /// Counts a phase; returns whether it uses tables.
    pub(super) fn uses_tables(&self) -> bool {
        let phases = self.phases.get();
        self.phases.set(phases.saturating_add(1));
        phases >= self.phases_before_caching && is_on(Part::KeptCells)
    }

    /// Phases in contact that it has solved.
    #[cfg(test)]
    pub(super) const fn phases(&self) -> u32 {
        self.phases.get()
    }

    /// Whether the simulation may have decided otherwise.
    pub(super) const fn is_lost(&self) -> bool {
        self.error.get().is_lost()
    }

    pub(super) fn with_error<T>(&self, change: impl FnOnce(&mut ErrorBound) -> T) -> T {
        let mut error = self.error.get();
        let result = change(&mut error);
        self.error.set(error);
        result
    }

    pub(super) fn add_phase_error(&self, end: &State) {
        self.with_error(|error| error.add_phase(&self.model.error_model, end.theta));
    }

    /// What the error tells of a decision. Where it does not, the simulation may decide otherwise.
    #[inline(always)]
    pub(super) fn is_certain(&self, told_by: impl FnOnce(&ErrorBound) -> bool) -> bool {
        let error = self.error.get();
        let is_certain = told_by(&error);
        if !is_certain {
            self.error.set(error.behind_doubt());
        }
        is_certain
    }

    /// Whether the sign of a number is certain.
    #[inline(always)]
    pub(super) fn sign_is_certain(&self, value: f64, scale: f64) -> bool {
        self.is_certain(|error| error.sign_is_certain(DecisiveNumber { value, scale }))
    }

    #[inline(always)]
    fn resolves_forces(&self, contact_margin: f64, scale: f64) -> bool {
        let margin = DecisiveNumber {
            value: contact_margin,
            scale,
        };
        self.is_certain(|error| error.resolves_forces(&self.model.error_model, margin))
    }

    pub(super) fn is_in_time(&self, state: &State, elapsed: f64) -> bool {
        elapsed <= self.until() - state.time
    }

    /// What is told of a flight.
    fn jump(&self, flight: &Flight) -> Jump {
        Jump {
            take_off_rate: flight.take_off_rate(),
            height: if self.has_landed.get() {
                f64::NAN
            } else {
                flight.apex().1
            },
        }
    }

    /// A phase that was solved exactly, as one of the engine.
    pub(super) fn taken_over(&self, solved: PhaseResult<Exact<'_>>) -> PhaseResult<Self> {
        let solution = solved.solution.flight().map(|flight| self.jump(flight));
        let end = match solved.end {
            PhaseEnd::Rest { point, arrival } => PhaseEnd::Rest {
                point: EngineState::new(point),
                arrival,
            },
            PhaseEnd::Event {
                point,
                cause,
                arrival,
            } => PhaseEnd::Event {
                point: EngineState::new(point),
                cause,
                arrival,
            },
            PhaseEnd::Landing { state, gap_rate } => {
                self.has_landed.set(true);
                PhaseEnd::Landing { state, gap_rate }
            }
            PhaseEnd::Settled { state, settling } => PhaseEnd::Settled { state, settling },
            PhaseEnd::Singular { state, solvability } => PhaseEnd::Singular { state, solvability },
            PhaseEnd::Motion {
                event,
                end,
                outcome,
            } => PhaseEnd::Motion {
                event,
                end,
                outcome: outcome.into(),
            },
        };
        PhaseResult {
            solution,
            direction: solved.direction,
            end,
        }
    }

    pub(super) fn contact_margin(&self, place: &EngineState) -> f64 {
        contact(1.0, self.model.body.h, place.angle.cos * place.u())
    }

    /// What selects the mode, from the forces, where it is clear on which side of every limit they
    /// are. A sign that is not may be another one in the simulation, too, unless the state is that
    /// of the simulation to the last bit.
    #[inline(always)]
    fn clear_inputs(&self, place: &EngineState, arrival: Arrival) -> Option<ModeInputs> {
        let EngineState {
            state,
            angle: Angle { sin, cos },
        } = *place;
        let w = self.contact_margin(place);
        let h = self.model.body.h;
        if !self.sign_is_certain(w, 1.0 + h * place.u()) {
            return None;
        }
        let slip = match SlipDirection::of_sign(state.slip) {
            Some(direction) => SlipInputs::Moving(direction),
            None if !self.resolves_forces(w, 1.0 + h * place.u()) => return None,
            None => SlipInputs::AtRest(self.clear_rest(place, w, arrival)?),
        };
        if !SlipDirection::ALL
            .into_iter()
            .all(|direction| self.is_solvable(place, direction, None))
        {
            return None;
        }
        let painleve = SlipDirection::ALL.map(|direction| {
            let law = self.model.sliding(direction);
            law.p(sin, law.q(1.0, sin, cos))
        });
        Some(ModeInputs {
            contact: ContactMargin {
                value: w,
                lifts_off: w < 0.0,
                grazes: false,
            },
            slip,
            painleve,
            keeps_contact: arrival != Arrival::Start,
        })
    }

    /// Whether a slide without kinetic friction leaves the plane before the top, where that is
    /// certain.
    fn leaves_plane_at_top(&self, body: &Heavy, place: &EngineState) -> Option<bool> {
        let at_top = MarginAtTop::new(body, &place.state, place.angle);
        self.sign_is_certain(at_top.value, 1.0 + at_top.terms)
            .then_some(at_top.value < 0.0)
    }

    /// Whether P > 0 is certain.
    #[inline(always)]
    pub(super) fn is_solvable(
        &self,
        place: &EngineState,
        direction: SlipDirection,
        towards: Option<f64>,
    ) -> bool {
        if self.model.is_solvable {
            return true;
        }
        let Heavy {
            mass, h, inertia, ..
        } = self.model.body;
        let law = self
            .model
            .sliding_towards(direction, towards.unwrap_or(1.0));
        let Angle { sin, cos } = place.angle;
        let p = law.p(sin, law.q(1.0, sin, cos));
        let arm = 1.0 + self.hoop.mu_k() + self.hoop.rolling_resistance();
        self.sign_is_certain(p, inertia + mass * h * arm) && p > 0.0
    }

    /// The same at η′ = 0.
    #[inline(always)]
    fn clear_rest(&self, place: &EngineState, w: f64, arrival: Arrival) -> Option<RestInputs> {
        let law = &self.model.rolling;
        let u = place.u();
        let effective_inertia = law.denominator_of(place.angle);
        let forces = law.forces_at(place.angle, Loads::of(u), effective_inertia);
        let excess = forces.friction.abs() - self.hoop.mu_s() * forces.normal;
        let size = law.mass * (1.0 + u + law.tilt.abs()) * (1.0 + self.hoop.mu_s());
        let is_off_limit = || {
            let point = PhasePoint {
                theta: place.state.theta,
                rate: place.state.theta_rate,
            };
            let mu_s = self.hoop.mu_s();
            excess.abs() > ForceRounding::bound(law, &point, effective_inertia, mu_s)
                || ForceRounding::new(law, &point, place.angle).clears(&forces, mu_s)
        };
        let stiction = match arrival {
            Arrival::Start | Arrival::InContact | Arrival::RollingLimit(_)
                if w < 0.0 && !may_wedge(&self.model.body, place.angle.sin, u) =>
            {
                Stiction::NoNormalForce
            }
            Arrival::RollingLimit(RollingLimit::Friction(direction)) => Stiction::Slips {
                direction,
                excess: 0.0,
            },
            Arrival::Start | Arrival::InContact
                if self.sign_is_certain(excess, size)
                    && place.state.theta_rate != 0.0
                    && is_off_limit() =>
            {
                if excess < 0.0 {
                    Stiction::Holds
                } else {
                    Stiction::Slips {
                        direction: SlipDirection::of_sign(-forces.friction)?,
                        excess,
                    }
                }
            }
            // Known by how it was reached, or from rest.
            Arrival::BackOnLimit(_)
            | Arrival::Held(_)
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
            on_limit: false,
            may_slip: None,
            rolling_forces: forces,
            effective_inertia,
        })
    }

    /// A phase that is cut at a state by the limit of time.
    pub(super) const fn cut(end: State) -> Ended {
        let outcome = FastOutcome {
            kind: OutcomeKind::TimeLimit,
            state: end,
        };
        PhaseEnd::Motion {
            event: None,
            end: Some(end),
            outcome,
        }
    }

    const fn slides_forever(start: State, end: Option<State>) -> Ended {
        PhaseEnd::Motion {
            event: None,
            end,
            outcome: FastOutcome {
                kind: OutcomeKind::SlidesForever,
                state: start,
            },
        }
    }

    /// The end of a slide from a place by an event.
    fn slide_event(
        &self,
        place: &EngineState,
        direction: SlipDirection,
        event: &SlideEvent,
    ) -> Ended {
        let point = EngineState {
            state: self.slide_end(place, direction, event, false),
            angle: event.angle,
        };
        if event.lifts_off {
            PhaseEnd::Event {
                point,
                cause: Cause::LiftOff,
                arrival: Arrival::LiftOff,
            }
        } else {
            PhaseEnd::Rest {
                point,
                arrival: Arrival::InContact,
            }
        }
    }

    /// The state at an event of a slide from a place, or at the time limit.
    pub(super) fn slide_end(
        &self,
        place: &EngineState,
        direction: SlipDirection,
        event: &SlideEvent,
        is_cut: bool,
    ) -> State {
        let state = place.state;
        let law = self.model.sliding(direction);
        let path = law.path(ContactMotion::of(&state), place.angle);
        let end = State {
            time: if is_cut {
                self.until()
            } else {
                state.time + event.elapsed
            },
            theta: event.theta,
            theta_rate: event.theta_rate,
            slip: event.slip,
            x: path.x(event.elapsed, event.angle),
        };
        self.add_phase_error(&end);
        end
    }

    /// The end of rolling from a place by a slip.
    pub(super) fn slipped(&self, place: &EngineState, slip: &RollSlip, heading: f64) -> Ended {
        let state = place.state;
        let theta = heading * slip.theta;
        let end = State {
            time: state.time + slip.elapsed,
            theta,
            theta_rate: heading * slip.theta_rate,
            slip: 0.0,
            x: state.x - (theta - state.theta),
        };
        let limit = RollingLimit::Friction(mirrored_slip(slip.slip, heading));
        self.add_phase_error(&end);
        self.has_slipped.set(true);
        PhaseEnd::Event {
            point: EngineState {
                state: end,
                angle: slip.angle.mirrored_by(heading),
            },
            cause: limit.cause(),
            arrival: Arrival::RollingLimit(limit),
        }
    }

    /// The result of a phase from a state that is that of the simulation, or of a motion that is
    /// lost: it ends here, and begins anew.
    #[inline(always)]
    pub(super) fn not_computed(
        &self,
        state: State,
        exact: impl FnOnce(&Exact<'a>) -> PhaseResult<Exact<'a>>,
    ) -> Option<PhaseResult<Self>> {
        match self.error.get() {
            ErrorBound::Exact | ErrorBound::Within(_) => None,
            ErrorBound::Simulated(phases) => {
                let error = ErrorBound::behind_simulated(phases.get() - 1);
                self.error.set(error);
                Some(self.taken_over(exact(&self.exact)))
            }
            ErrorBound::Lost => Some(PhaseResult {
                solution: None,
                direction: None,
                end: Self::cut(state),
            }),
        }
    }

    /// Where rolling from a place has led at the limit of time.
    fn rolled(&self, place: &EngineState) -> Option<State> {
        let (state, heading) = (place.state, place.heading());
        let OrbitPoint { theta, theta_rate } =
            self.model.rolled(place, self.until() - state.time)?;
        let theta = heading * theta;
        let x = state.x - (theta - state.theta);
        Some(State {
            time: self.until(),
            theta,
            theta_rate: heading * theta_rate,
            slip: 0.0,
            x,
        })
    }

    /// Follows a slide, or solves it as the simulation does.
    #[inline(always)]
    pub(super) fn follow_slide(
        &self,
        place: &EngineState,
        body: &Heavy,
        slide: SlidePhase,
        exact: impl Fn(&Exact<'a>) -> PhaseResult<Exact<'a>>,
    ) -> PhaseResult<Self> {
        let SlidePhase {
            direction,
            entry,
            may_lift_off,
            towards,
        } = slide;
        let state = place.state;
        let has_slipped = self.has_slipped.take();
        let is_conservative = self.hoop.mu_k() == 0.0 && towards.is_none();
        let left_to_the_simulation = |reason: Fallback| {
            self.model.fallbacks.add(reason);
            // As the simulation has it, but for the last digits of an acceleration from which it
            // begins.
            let solved = exact(&self.exact);
            if entry != Entry::Moving && entry != ON_LIMIT {
                self.add_phase_error(&state);
            }
            self.taken_over(solved)
        };
        if let Some(result) = self.not_computed(state, &exact) {
            return result;
        }
        if is_out_of_range(state.theta) {
            return left_to_the_simulation(Fallback::Far);
        }
        let (w, size) = (self.contact_margin(place), 1.0 + body.h * place.u());
        let is_clear = if entry == Entry::Moving {
            self.sign_is_certain(w, size) && self.is_solvable(place, direction, towards)
        } else {
            self.resolves_forces(w, size)
        };
        if !is_clear {
            return left_to_the_simulation(Fallback::Cancelled);
        }
        if is_conservative && entry == ON_LIMIT {
            // A zero of a higher order, which the simulation divides out.
            return left_to_the_simulation(Fallback::Cancelled);
        }
        if is_conservative && self.leaves_plane_at_top(body, place) != Some(may_lift_off) {
            return left_to_the_simulation(Fallback::Cancelled);
        }
        if is_conservative && is_next_to_equilibrium(body, place) {
            return left_to_the_simulation(Fallback::Separatrix);
        }
        let uses_tables = self.uses_tables();
        let begin = SlideStart {
            slip: direction,
            towards,
            from_limit: entry == ON_LIMIT,
            is_interpolated: has_slipped && self.interpolates_slides && uses_tables,
            time_left: self.until() - state.time,
        };
        let end = match self.model.slide(place, begin, uses_tables) {
            Ok(SlideEnd::Event(event)) => self.slide_event(place, direction, &event),
            Ok(SlideEnd::Turn(event)) => {
                self.turned(place, direction, towards.unwrap_or(1.0), &event)
            }
            Ok(SlideEnd::Cut(event)) => {
                let end = self.slide_end(place, direction, &event, true);
                // η′ has not fallen over a whole period: there is no event at all.
                let never_stops =
                    direction.sign() * self.model.sliding(direction).mean_slip_loss() <= 0.0;
                if never_stops && event.is_behind_a_period(state.theta, is_conservative) {
                    Self::slides_forever(state, Some(end))
                } else {
                    Self::cut(end)
                }
            }
            Ok(SlideEnd::Never) => Self::slides_forever(state, None),
            Err(reason) => return left_to_the_simulation(reason),
        };
        PhaseResult {
            solution: None,
            direction: Some(direction),
            end,
        }
    }
}

impl LinkSolver for FastSolver<'_> {
    fn link(
        &self,
        maps: &SlipMaps,
        slip: SlipPoint,
        theta_rate: f64,
    ) -> Option<(State, SlipDirection, f64, PhaseSequence)> {
        let solver = Self::new(self.hoop, self.model, &Limits::default());
        let mirror = maps.mirror();
        let state = mirrored_by(
            &State {
                time: 0.0,
                theta: slip.angle,
                theta_rate,
                slip: 0.0,
                x: 0.0,
            },
            mirror,
        );
        let place = EngineState::new(state);
        let mut phases = PhaseSequence::default();
        let accept = |mode, direction| {
            phases.push(mode, direction);
            !phases.is_truncated()
        };
        let NextSlip {
            state: end,
            direction,
            slide_cost,
        } = next_slip(&solver, place, mirrored_slip(slip.slip, mirror), accept)?;
        if solver.is_lost() {
            return None;
        }
        if maps.is_last(self.hoop, &state, &end, phases) {
            return None;
        }
        let phases = if mirror < 0.0 {
            phases.mirrored()
        } else {
            phases
        };
        Some((
            mirrored_by(&end, mirror),
            mirrored_slip(direction, mirror),
            slide_cost,
            phases,
        ))
    }
}

impl Solver for FastSolver<'_> {
    type Point = EngineState;
    type Solution = Option<Jump>;
    type Outcome = FastOutcome;

    const SKIPS_PERIODS: bool = true;

    fn hoop(&self) -> &Hoop {
        self.hoop
    }

    fn slide_weight(&self) -> f64 {
        self.model.slide_weight
    }

    fn until(&self) -> f64 {
        self.exact.until()
    }

    fn point(&self, state: State) -> EngineState {
        EngineState::new(state)
    }

    fn state(point: &EngineState) -> &State {
        &point.state
    }

    #[inline(always)]
    fn next_motion(&self, place: &EngineState, arrival: Arrival) -> NextMotion {
        if matches!(arrival, Arrival::LiftOff) {
            // What the slide has found is not computed again.
            return NextMotion::at(self.hoop, &place.state, arrival);
        }
        if self.hoop.rolling_resistance() > 0.0 {
            return self.next_resisted(place, arrival);
        }
        match self.clear_inputs(place, arrival) {
            Some(inputs) => select_mode(self.hoop, &self.model.body, &place.state, &inputs),
            None => NextMotion::at(self.hoop, &place.state, arrival),
        }
    }

    #[inline(always)]
    fn roll(&self, place: &EngineState, on_limit: bool) -> PhaseResult<Self> {
        let state = place.state;
        self.has_slipped.set(false);
        let left_to_the_simulation = |reason: Fallback| {
            self.model.fallbacks.add(reason);
            self.taken_over(self.exact.roll(&state, on_limit))
        };
        if let Some(result) = self.not_computed(state, |exact| exact.roll(&state, on_limit)) {
            return result;
        }
        if is_out_of_range(state.theta) {
            return left_to_the_simulation(Fallback::Far);
        }
        let uses_tables = self.uses_tables();
        if self.model.leaves_rolling(uses_tables) {
            return self.taken_over(self.exact.roll(&state, on_limit));
        }
        let end: Ended = match self.model.roll(place, on_limit, uses_tables) {
            Ok(RollEnd::Never) => PhaseEnd::Motion {
                event: None,
                end: None,
                outcome: FastOutcome {
                    kind: OutcomeKind::RollsForever,
                    state,
                },
            },
            Ok(RollEnd::Slip(slip)) if self.is_in_time(&state, slip.elapsed) => {
                self.slipped(place, &slip, place.heading())
            }
            Ok(RollEnd::Slip(_)) => match self.rolled(place) {
                Some(end) => Self::cut(end),
                None => return left_to_the_simulation(Fallback::Separatrix),
            },
            Ok(RollEnd::Open) => match self.rolled(place) {
                Some(end) => Self::cut(end),
                None => return left_to_the_simulation(Fallback::TooLong),
            },
            Err(reason) => return left_to_the_simulation(reason),
        };
        PhaseResult {
            solution: None,
            direction: None,
            end,
        }
    }

    #[inline(always)]
    fn slide(
        &self,
        place: &EngineState,
        body: &Heavy,
        direction: SlipDirection,
        entry: Entry,
        may_lift_off: bool,
    ) -> PhaseResult<Self> {
        let slide = SlidePhase {
            direction,
            entry,
            may_lift_off,
            towards: None,
        };
        self.follow_slide(place, body, slide, |exact| {
            exact.slide(&place.state, body, direction, entry, may_lift_off)
        })
    }

    #[inline(always)]
    fn fly(&self, place: &EngineState, body: &Heavy, take_off: TakeOff) -> PhaseResult<Self> {
        let state = place.state;
        self.has_slipped.set(false);
        if let Some(result) = self.not_computed(state, |exact| exact.fly(&state, body, take_off)) {
            return result;
        }
        // Whatever follows from a state of the simulation goes on as there.
        if self.error.get().is_exact() && self.hoop.restitution().is_some() {
            return self.taken_over(self.exact.fly(&state, body, take_off));
        }
        let flight = match take_off {
            TakeOff::Grazing => {
                let heading = place.heading();
                match jump::extent(
                    heading * state.theta,
                    place.angle.mirrored_by(heading),
                    -self.contact_margin(place),
                ) {
                    Some(extent) => Flight::with_extent(body, state, take_off, place.angle, extent),
                    None => Flight::at_angle(body, state, take_off, place.angle),
                }
            }
            // So close to w = 0 the exact rules have decided, with their own cosine.
            TakeOff::Unloaded
                if !self.sign_is_certain(self.contact_margin(place), 1.0 + body.h * place.u()) =>
            {
                Flight::new(body, state, take_off)
            }
            TakeOff::Unloaded | TakeOff::Rising { .. } => {
                Flight::at_angle(body, state, take_off, place.angle)
            }
        };
        let duration = flight.duration();
        if let Some(restitution) = self.hoop.restitution() {
            let coefficient = restitution.coefficient();
            self.with_error(|error| {
                error.add_flight(
                    &self.model.error_model,
                    &flight,
                    &state,
                    place.angle,
                    coefficient,
                );
            });
        }
        let jump = self.jump(&flight);
        let end = if self.is_in_time(&state, duration) {
            self.has_landed.set(true);
            PhaseEnd::Landing {
                state: flight.state(duration),
                gap_rate: flight.landing_rate(),
            }
        } else {
            Self::cut(State {
                time: self.until(),
                ..flight.state(self.until() - state.time)
            })
        };
        PhaseResult {
            solution: Some(jump),
            direction: None,
            end,
        }
    }

    fn settle(&self, place: &EngineState, body: &Heavy, settling: &Settling) -> PhaseResult<Self> {
        self.taken_over(self.exact.settle(&place.state, body, settling))
    }

    fn glide(&self, place: &EngineState, body: &Massless, entry: GlideEntry) -> PhaseResult<Self> {
        self.taken_over(self.exact.glide(&place.state, body, entry))
    }

    fn resisted(
        &self,
        place: &EngineState,
        body: &Heavy,
        motion: ResistedMotion,
        half_swings: usize,
    ) -> PhaseResult<Self> {
        self.follow_resisted(place, body, motion, half_swings)
    }

    fn skip_to(&self, end: State) -> Option<EngineState> {
        let error = self.error.get();
        if error.is_simulated() || error.is_lost() {
            return None;
        }
        self.add_phase_error(&end);
        Some(EngineState::new(end))
    }

    fn skip_links(
        &self,
        place: &EngineState,
        direction: SlipDirection,
        budget: &SkipBudget<'_>,
    ) -> Option<SkippedLinks<EngineState>> {
        if self.phases.get() < self.phases_before_links || self.error.get().is_simulated() {
            return None;
        }
        let (state, heading) = (place.state, place.heading());
        let maps = self
            .slip_maps?
            .get_or_init(|| SlipMaps::new(self.hoop, self.model));
        let maps = if heading < 0.0 {
            maps.last()
        } else {
            maps.first()
        }?;
        let mirror = maps.mirror();
        let start = mirrored_by(&state, mirror);
        let point = maps.point(&start, mirrored_slip(direction, mirror))?;
        let after = |passage: &SlipMapValue| {
            let (slip, rate) = maps.slip(passage.end)?;
            Some((
                slip,
                mirrored_by(&passage.state_after(&start, slip.angle, rate), mirror),
            ))
        };
        let fits = |passage: &SlipMapValue| {
            passage.route.transitions <= budget.transitions
                && passage.slid <= budget.slide_cost
                && self.is_in_time(&state, passage.elapsed)
                && budget
                    .open
                    .is_none_or(|open| after(passage).is_some_and(|(_, state)| open(&state)))
        };
        let (passage, phases) = if budget.record_phases {
            maps.links(point, self, fits)?
        } else {
            (maps.pass(point, self, fits)?, PhaseSequence::default())
        };
        let (slip, end) = after(&passage)?;
        let place = EngineState::new(end);
        let towards = mirrored_slip(slip.slip, place.heading());
        self.add_phase_error(&end);
        Some(SkippedLinks {
            point: place,
            direction: towards,
            transitions: passage.route.transitions,
            slide_cost: passage.slid,
            phases: if heading < 0.0 {
                phases.mirrored()
            } else {
                phases
            },
        })
    }
}
