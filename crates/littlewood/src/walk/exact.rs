//! The exact solver: closed forms, elliptic integrals and converged Taylor series.

use core::cell::Cell;

use crate::mechanics::{Settling, SlidingLaw};
use crate::model::{
    Heavy, Hoop, Limits, MAX_COORDINATE, MAX_TIME, Massless, Proof, Quantity, RotationDirection,
    SlipDirection, State,
};
use crate::modes::{
    Entry, Flight, GlideEntry, Gliding, GlidingEnd, PhaseSolution, Recurrence, ResistedBudget,
    ResistedEnd, ResistedRolling, Rest, Rolling, Skidding, SlideBudget, SlideLimit, Sliding,
    SlidingEnd, TakeOff, Undecided,
};
use crate::walk::{
    Arrival, Cause, Held, NextMotion, Outcome, PhaseEnd, PhaseResult, ResistedMotion, Solution,
    Solver,
};

#[derive(Clone, Debug)]
pub(crate) struct Exact<'a> {
    hoop: &'a Hoop,
    until: Option<f64>,
    proof: Proof,
    /// Remaining steps of hard slides.
    steps: Cell<usize>,
    /// Remaining steps of long rolling with rolling resistance.
    rolling_steps: Cell<usize>,
}

/// Largest number of steps of all hard slides of a motion: a quarter of a second, and 60 MB. The
/// length of a slide does not bound its steps: a hoop of Î = 1e-12 m that comes to rest near a
/// graze takes 43,000 steps for a length of 4e-4.
const MAX_STEPS_OF_HARD_SLIDES: usize = 100_000;

/// Largest number of steps of a slide that is not hard; the total length limits such slides. Other
/// solvers delegate hard slides to this one, so that the count is the same.
const MAX_STEPS_OF_EASY_SLIDE: usize = 2_000;

/// Largest number of steps of all long phases of rolling with rolling resistance.
const MAX_STEPS_OF_LONG_ROLLING: usize = 500_000;

/// Largest number of steps of a phase that is not long: a half swing takes a few dozen.
const MAX_STEPS_OF_SHORT_ROLLING: usize = 256;

type ExactEnd = PhaseEnd<State, Outcome>;

impl<'a> Exact<'a> {
    pub(crate) const fn new(hoop: &'a Hoop, limits: &Limits) -> Self {
        Self {
            hoop,
            until: limits.until,
            proof: limits.proof(),
            steps: Cell::new(MAX_STEPS_OF_HARD_SLIDES),
            rolling_steps: Cell::new(MAX_STEPS_OF_LONG_ROLLING),
        }
    }

    fn allowed(&self, state: &State) -> Option<f64> {
        self.until.map(|until| until - state.time)
    }

    /// A phase cut at the time limit, with the exact time of the limit.
    fn stopped(&self, state: State) -> ExactEnd {
        let state = State {
            time: self.until.unwrap_or(state.time),
            ..state
        };
        Self::without_event(state, Outcome::TimeLimit { state })
    }

    const fn without_event(state: State, outcome: Outcome) -> ExactEnd {
        PhaseEnd::Motion {
            event: None,
            end: Some(state),
            outcome,
        }
    }

    const fn unresolved(state: State, undecided: Undecided) -> ExactEnd {
        Self::without_event(state, Outcome::Unresolved { state, undecided })
    }

    const fn ended(cause: Cause, state: State, outcome: Outcome) -> ExactEnd {
        PhaseEnd::Motion {
            event: Some((cause, state)),
            end: Some(state),
            outcome,
        }
    }

    /// A flight that ends by `ends`, or at the time limit if that comes first.
    fn flown(
        &self,
        flight: Flight,
        start: &State,
        ends: impl Fn(State) -> ExactEnd,
    ) -> PhaseResult<Self> {
        let duration = flight.duration();
        let end = match self.allowed(start) {
            Some(allowed) if allowed < duration => self.stopped(flight.state(allowed)),
            Some(_) | None => ends(flight.state(duration)),
        };
        PhaseResult {
            solution: PhaseSolution::Flight(flight),
            direction: None,
            end,
        }
    }

    /// A phase without end; it is cut at the time limit, if any.
    fn endless(&self, start: &State, at: impl Fn(f64) -> State, outcome: Outcome) -> ExactEnd {
        let end = self.allowed(start).map(|allowed| {
            let state = at(allowed);
            State {
                time: self.until.unwrap_or(state.time),
                ..state
            }
        });
        PhaseEnd::Motion {
            event: None,
            end,
            outcome,
        }
    }

    /// How a slide from `start` ends the phase, or the motion.
    fn slide_end(
        &self,
        start: &State,
        slide: &Sliding,
        law: &SlidingLaw,
        end: SlidingEnd,
    ) -> ExactEnd {
        match end {
            SlidingEnd::Rest(point) => PhaseEnd::Rest {
                point,
                arrival: Arrival::InContact,
            },
            SlidingEnd::LiftOff(point) => PhaseEnd::Event {
                point,
                cause: Cause::LiftOff,
                arrival: Arrival::LiftOff,
            },
            SlidingEnd::TurningPoint(point) => PhaseEnd::Event {
                point,
                cause: Cause::TurningPoint,
                arrival: Arrival::Held(Held::NOTHING),
            },
            SlidingEnd::Singular(state) => PhaseEnd::Singular {
                state,
                solvability: law.painleve(state.theta),
            },
            SlidingEnd::Unresolved { state, undecided } => Self::unresolved(state, undecided),
            SlidingEnd::StepLimit { state, .. }
                if self.proof != Proof::None && self.hoop.never_lifts_off(&state) =>
            {
                Self::without_event(state, Outcome::StaysInContact { state })
            }
            SlidingEnd::StepLimit { state, time_left } => {
                let limit = SlideLimit::One {
                    steps: slide.work(),
                    time_left,
                };
                Self::without_event(state, Outcome::StepLimit { state, limit })
            }
            SlidingEnd::TimeLimit(state) => self.stopped(state),
            SlidingEnd::Endless(recurrence) => {
                let outcome = Outcome::SlidesForever {
                    since: *start,
                    recurrence,
                };
                self.endless(start, |allowed| slide.state(allowed), outcome)
            }
        }
    }

    /// A slide by a law, with rolling resistance or without.
    fn slide_by(
        &self,
        law: SlidingLaw,
        state: &State,
        direction: SlipDirection,
        entry: Entry,
        may_lift_off: bool,
    ) -> PhaseResult<Self> {
        let budget = SlideBudget {
            time_left: self.allowed(state),
            steps: self.steps.get().max(MAX_STEPS_OF_EASY_SLIDE),
        };
        let (slide, end) = Sliding::run(law, *state, direction, entry, may_lift_off, budget);
        if slide.work() > MAX_STEPS_OF_EASY_SLIDE {
            self.steps
                .set(self.steps.get().saturating_sub(slide.work()));
        }
        let end = self.slide_end(state, &slide, &law, end);
        let solution = PhaseSolution::Sliding(Box::new(slide));
        PhaseResult {
            solution,
            direction: Some(direction),
            end,
        }
    }

    /// Rolling in one direction with rolling resistance.
    fn roll_resisted(
        &self,
        state: &State,
        body: &Heavy,
        direction: RotationDirection,
    ) -> PhaseResult<Self> {
        let budget = ResistedBudget {
            time_left: self.allowed(state),
            steps: (self.rolling_steps.get())
                .clamp(MAX_STEPS_OF_SHORT_ROLLING, MAX_STEPS_OF_HARD_SLIDES),
        };
        let (rolling, end) = ResistedRolling::run(self.hoop, body, *state, direction, budget);
        if rolling.work() > MAX_STEPS_OF_SHORT_ROLLING {
            let left = self.rolling_steps.get().saturating_sub(rolling.work());
            self.rolling_steps.set(left);
        }
        let held = Held {
            slip: true,
            turn: false,
        };
        let end = match end {
            ResistedEnd::TurningPoint(point) => PhaseEnd::Event {
                point,
                cause: Cause::TurningPoint,
                arrival: Arrival::Held(held),
            },
            ResistedEnd::Limit {
                state: point,
                limit,
            } => match self.hoop.undecided_place(point.theta) {
                None => PhaseEnd::Event {
                    point,
                    cause: limit.cause(),
                    arrival: Arrival::RollingLimit(limit),
                },
                Some(undecided) => Self::unresolved(*state, undecided),
            },
            ResistedEnd::TimeLimit(state) => self.stopped(state),
            ResistedEnd::StepLimit(state) => {
                let limit = SlideLimit::One {
                    steps: rolling.steps(),
                    time_left: f64::INFINITY,
                };
                Self::without_event(state, Outcome::StepLimit { state, limit })
            }
            ResistedEnd::Unresolved { state, undecided } => Self::unresolved(state, undecided),
            ResistedEnd::Endless(recurrence) => {
                let outcome = Outcome::RollsForever {
                    since: *state,
                    recurrence,
                };
                self.endless(state, |allowed| rolling.state(allowed), outcome)
            }
        };
        PhaseResult {
            solution: PhaseSolution::ResistedRolling(Box::new(rolling)),
            direction: None,
            end,
        }
    }

    /// A slip without rotation.
    fn skid(&self, state: &State, body: &Heavy, direction: SlipDirection) -> PhaseResult<Self> {
        let skid = Skidding::new(body, self.hoop.mu_k(), direction, *state);
        let allowed = self.allowed(state);
        let end = match skid.duration() {
            Some(duration) if duration <= allowed.unwrap_or(MAX_TIME) => PhaseEnd::Rest {
                point: skid.end(duration),
                arrival: Arrival::Held(Held {
                    slip: false,
                    turn: true,
                }),
            },
            Some(_) if allowed.is_some() => self.stopped(skid.state(allowed.unwrap_or(0.0))),
            Some(time_left) => {
                let limit = SlideLimit::One {
                    steps: 0,
                    time_left,
                };
                let state = *state;
                Self::without_event(state, Outcome::StepLimit { state, limit })
            }
            None => {
                let acceleration = skid.slip_acceleration();
                let recurrence = if acceleration == 0.0 {
                    Recurrence::Rest
                } else {
                    Recurrence::Downhill { acceleration }
                };
                let outcome = Outcome::SlidesForever {
                    since: *state,
                    recurrence,
                };
                self.endless(state, |allowed| skid.state(allowed), outcome)
            }
        };
        PhaseResult {
            solution: PhaseSolution::Skidding(skid),
            direction: Some(direction),
            end,
        }
    }
}

impl Solver for Exact<'_> {
    type Point = State;
    type Solution = PhaseSolution;
    type Outcome = Outcome;

    fn hoop(&self) -> &Hoop {
        self.hoop
    }

    fn until(&self) -> f64 {
        self.until.unwrap_or(f64::INFINITY)
    }

    fn point(&self, state: State) -> State {
        state
    }

    fn state(point: &State) -> &State {
        point
    }

    fn next_motion(&self, state: &State, arrival: Arrival) -> NextMotion {
        NextMotion::at(self.hoop, state, arrival)
    }

    fn roll(&self, state: &State, on_limit: bool) -> PhaseResult<Self> {
        let rolling = Rolling::new(self.hoop, *state);
        let allowed = self.allowed(state);
        let end = if on_limit {
            rolling.orbit().end_from_limit()
        } else {
            rolling.orbit().end()
        };
        let end = match end {
            // A massless hoop whose particle is at the plane, but for rounding.
            Some(end) if !end.theta_rate.is_finite() => {
                let undecided = Undecided::overflow(Quantity::ThetaRate, end.theta_rate);
                Self::unresolved(*state, undecided)
            }
            Some(end) if allowed.is_none_or(|allowed| end.elapsed <= allowed) => {
                match self.hoop.undecided_place(end.theta) {
                    None => PhaseEnd::Event {
                        point: rolling.state_at(end.theta, end.theta_rate, end.elapsed),
                        cause: end.limit.cause(),
                        arrival: Arrival::RollingLimit(end.limit),
                    },
                    Some(undecided) => Self::unresolved(*state, undecided),
                }
            }
            Some(_) => self.stopped(rolling.state(allowed.unwrap_or(0.0))),
            None if rolling.orbit().leaves_bounds() => {
                let undecided = Undecided::Range {
                    quantity: Quantity::Theta,
                    value: f64::INFINITY.copysign(self.hoop.slope()),
                    bound: MAX_COORDINATE,
                };
                let outcome = Outcome::Unresolved {
                    state: *state,
                    undecided,
                };
                self.endless(state, |allowed| rolling.state(allowed), outcome)
            }
            None => {
                let recurrence = rolling.orbit().recurrence();
                let outcome = Outcome::RollsForever {
                    since: *state,
                    recurrence,
                };
                self.endless(state, |allowed| rolling.state(allowed), outcome)
            }
        };
        PhaseResult {
            solution: PhaseSolution::Rolling(Box::new(rolling)),
            direction: None,
            end,
        }
    }

    fn slide(
        &self,
        state: &State,
        body: &Heavy,
        direction: SlipDirection,
        entry: Entry,
        may_lift_off: bool,
    ) -> PhaseResult<Self> {
        let law = SlidingLaw::of_body(*body, self.hoop.mu_k(), direction);
        self.slide_by(law, state, direction, entry, may_lift_off)
    }

    fn fly(&self, state: &State, body: &Heavy, take_off: TakeOff) -> PhaseResult<Self> {
        let flight = Flight::new(body, *state, take_off);
        self.flown(flight, state, |end| match flight.undecided() {
            None => PhaseEnd::Landing {
                state: end,
                gap_rate: flight.landing_rate(),
            },
            Some(undecided) => Self::unresolved(*state, undecided),
        })
    }

    fn settle(&self, state: &State, body: &Heavy, settling: &Settling) -> PhaseResult<Self> {
        let flight = Flight::settling(body, *state, settling.gap_rate, settling.duration);
        self.flown(flight, state, |state| PhaseEnd::Settled {
            state,
            settling: Box::new(*settling),
        })
    }

    fn glide(&self, state: &State, body: &Massless, entry: GlideEntry) -> PhaseResult<Self> {
        let allowed = self.allowed(state);
        let (glide, end) = Gliding::run(body, self.hoop.friction(), *state, entry, allowed);
        let end = match end {
            GlidingEnd::Rest { state, presses } => PhaseEnd::Rest {
                point: state,
                arrival: Arrival::GlideAtRest { presses },
            },
            GlidingEnd::TurningPoint(point) => PhaseEnd::Event {
                point,
                cause: Cause::TurningPoint,
                arrival: Arrival::Held(Held::NOTHING),
            },
            GlidingEnd::Bottom(state) if body.offset < 1.0 => Self::ended(
                Cause::ParticleAtBottom,
                state,
                Outcome::ParticleAtBottom { state },
            ),
            GlidingEnd::Bottom(state) => Self::ended(
                Cause::ParticleAtPlane,
                state,
                Outcome::ParticleAtPlane { state },
            ),
            GlidingEnd::Top(state) => Self::ended(
                Cause::ParticleAtTop,
                state,
                Outcome::ParticleAtTop { state },
            ),
            GlidingEnd::TimeLimit(state) => self.stopped(state),
        };
        PhaseResult {
            solution: PhaseSolution::Gliding(glide),
            direction: glide.direction(),
            end,
        }
    }

    fn resisted(
        &self,
        state: &State,
        body: &Heavy,
        motion: ResistedMotion,
        half_swings: usize,
    ) -> PhaseResult<Self> {
        match motion {
            ResistedMotion::Roll(rotation) => self.roll_resisted(state, body, rotation),
            ResistedMotion::Skid(direction) => self.skid(state, body, direction),
            ResistedMotion::Slide {
                direction,
                rotation,
                entry,
            } => {
                let law = SlidingLaw {
                    resistance: rotation.sign() * self.hoop.rolling_resistance(),
                    ..SlidingLaw::of_body(*body, self.hoop.mu_k(), direction)
                };
                self.slide_by(law, state, direction, entry, true)
            }
            ResistedMotion::Rest => {
                let rest = Rest::new(body, *state);
                let outcome = Outcome::Rests {
                    since: *state,
                    half_swings,
                };
                PhaseResult {
                    solution: PhaseSolution::Rest(rest),
                    direction: None,
                    end: self.endless(state, |allowed| rest.state(allowed), outcome),
                }
            }
        }
    }
}

impl Solution for PhaseSolution {
    fn take_off_rate(&self) -> Option<f64> {
        self.flight().map(Flight::take_off_rate)
    }

    fn height(&self) -> f64 {
        self.flight().map_or(0.0, |flight| flight.apex().1)
    }

    fn theta_range(&self) -> Option<(f64, f64)> {
        match self {
            Self::Sliding(slide) => Some(slide.theta_range()),
            Self::Rolling(_)
            | Self::ResistedRolling(_)
            | Self::Gliding(_)
            | Self::Flight(_)
            | Self::Skidding(_)
            | Self::Rest(_) => None,
        }
    }
}
