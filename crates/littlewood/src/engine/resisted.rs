//! Phases with rolling resistance (docs/theory/rolling-resistance.md).
//!
//! What follows a state is told by the rules of the simulation, with the error of the state. Slides
//! are followed as without resistance, up to θ′ = 0; skids and rest are those of the simulation.

use crate::math::trig::Angle;
use crate::mechanics::{ResistedRollingLaw, RollingLaw};
use crate::model::{Heavy, RotationDirection, SlipDirection, State};
use crate::modes::{Entry, RollingLimit};
use crate::walk::{
    Arrival, Cause, Exact, Held, NextMotion, PhaseEnd, PhaseResult, ResistedMotion, Solver as _,
    next_motion_near,
};

use super::error_bound::{TurningPointError, is_out_of_range};
use super::fallback::Fallback;
use super::half_swings::HalfSwing;
use super::roll::RollSlip;
use super::slide::{ResistedRollEnd, RollStop, SlideEvent};
use super::solver::{Ended, FastSolver, SlidePhase};
use super::state::EngineState;

impl<'a> FastSolver<'a> {
    /// The motion that begins at a state, where that is certain.
    #[inline(never)]
    pub(super) fn next_resisted(&self, place: &EngineState, arrival: Arrival) -> NextMotion {
        let (state, body) = (place.state, self.model.body);
        let error = self.error.get();
        if let Some(motion) = self.clear_motion(place, arrival) {
            return NextMotion::Resisted { body, motion };
        }
        // What was in doubt for that is asked anew, with bounds of each rounding.
        self.error.set(error);
        let exact = || NextMotion::at(self.hoop, &state, arrival);
        let Some(difference) = error.difference() else {
            return exact();
        };
        if !self.has_clear_signs(place) {
            return exact();
        }
        if let Arrival::RollingLimit(RollingLimit::Friction(direction)) = arrival {
            // Only P decides there; where it is in doubt the motion begins anew.
            self.is_solvable(place, direction, Some(place.heading()));
            return exact();
        }
        let next = next_motion_near(self.hoop, &body, &state, arrival, difference);
        // What is not decided by more than the error the simulation may have decided.
        self.is_certain(|_| !matches!(next, NextMotion::Undecided(_)));
        next
    }

    /// Whether w and the velocities that are not zero certainly have their signs.
    fn has_clear_signs(&self, place: &EngineState) -> bool {
        let (w, h) = (self.contact_margin(place), self.model.body.h);
        let has_sign = |rate: f64| rate == 0.0 || self.sign_is_certain(rate, 1.0 + rate.abs());
        self.sign_is_certain(w, 1.0 + h * place.u())
            && has_sign(place.state.theta_rate)
            && has_sign(place.state.slip)
    }

    /// The motion where no condition of its mode is next to its limit, which most decisions are about:
    /// a slide that goes on, rolling that holds, and what follows a stop on a level plane. The proofs
    /// that it is the only one are those of docs/theory/rolling-resistance.md.
    fn clear_motion(&self, place: &EngineState, arrival: Arrival) -> Option<ResistedMotion> {
        let rises = self.contact_margin(place) <= 0.0;
        let is_limit = match arrival {
            Arrival::RollingLimit(_) | Arrival::GlideAtRest { .. } | Arrival::BackOnLimit(_) => {
                true
            }
            Arrival::Start | Arrival::InContact | Arrival::Held(_) | Arrival::LiftOff => false,
        };
        if is_limit || rises || !self.has_clear_signs(place) {
            return None;
        }
        let State {
            theta_rate, slip, ..
        } = place.state;
        let rotation = RotationDirection::of_sign(theta_rate);
        match (SlipDirection::of_sign(slip), rotation) {
            (Some(direction), Some(rotation)) => {
                let is_pressed = self.is_solvable(place, direction, Some(rotation.sign()));
                is_pressed.then_some(ResistedMotion::Slide {
                    direction,
                    rotation,
                    entry: Entry::Moving,
                })
            }
            (None, Some(rotation)) => self.clear_roll(place, rotation),
            (None, None) => self.clear_stop(place),
            (Some(_), None) => None,
        }
    }

    /// Rolling, where Dχ, N and the margins of static friction are clearly positive.
    fn clear_roll(
        &self,
        place: &EngineState,
        rotation: RotationDirection,
    ) -> Option<ResistedMotion> {
        let (chi, mu_s) = (self.hoop.rolling_resistance(), self.hoop.mu_s());
        let law = ResistedRollingLaw::of_body(&self.model.body, rotation.sign() * chi);
        let denominator = law.denominator_of(place.angle);
        let forces = law.forces(place.angle, place.u());
        let RollingLaw {
            mass, offset, top, ..
        } = law.rolling;
        let terms = mass * (1.0 + place.u()) * (1.0 + chi + law.rolling.tilt.abs());
        let amplified = terms * (top + chi * offset) / denominator;
        let margin = mu_s * forces.normal - forces.friction.abs();
        let holds = self.sign_is_certain(denominator, top + chi * offset)
            && denominator > 0.0
            && self.sign_is_certain(forces.normal, amplified)
            && forces.normal > 0.0
            && self.sign_is_certain(margin, (1.0 + mu_s) * amplified)
            && margin > 0.0;
        holds.then_some(ResistedMotion::Roll(rotation))
    }

    /// What follows complete rest on a level plane: rest if |a| ≤ χ, and otherwise rolling if m d
    /// (|a| − χ) ≤ μs J.
    fn clear_stop(&self, place: &EngineState) -> Option<ResistedMotion> {
        let Heavy {
            mass,
            h,
            inertia,
            tilt,
            ..
        } = self.model.body;
        let chi = self.hoop.rolling_resistance();
        let Angle { sin, cos } = place.angle;
        let excess = h * sin.abs() - chi;
        if tilt != 0.0 || !self.sign_is_certain(excess, h + chi) {
            return None;
        }
        if excess < 0.0 {
            return Some(ResistedMotion::Rest);
        }
        let d = 1.0 + h * cos;
        let margin = self.hoop.mu_s() * (inertia + mass * d * d) - mass * d * excess;
        let terms = (1.0 + self.hoop.mu_s()) * self.model.rolling.top;
        let rolls = self.sign_is_certain(margin, terms) && margin > 0.0;
        let rotation = RotationDirection::of_sign(sin)?;
        rolls.then_some(ResistedMotion::Roll(rotation))
    }

    /// Follows a phase.
    #[inline(never)]
    pub(super) fn follow_resisted(
        &self,
        place: &EngineState,
        body: &Heavy,
        motion: ResistedMotion,
        half_swings: usize,
    ) -> PhaseResult<Self> {
        let state = place.state;
        match motion {
            ResistedMotion::Slide {
                direction,
                rotation,
                entry,
            } => {
                let slide = SlidePhase {
                    direction,
                    entry,
                    may_lift_off: true,
                    towards: Some(rotation.sign()),
                };
                self.follow_slide(place, body, slide, |exact| {
                    exact.resisted(&state, body, motion, half_swings)
                })
            }
            ResistedMotion::Roll(rotation) => {
                self.has_slipped.set(false);
                let exact = |exact: &Exact<'a>| exact.resisted(&state, body, motion, half_swings);
                if let Some(result) = self.not_computed(state, exact) {
                    return result;
                }
                match self.rolled_with_resistance(place, rotation.sign()) {
                    Ok(end) => PhaseResult {
                        solution: None,
                        direction: None,
                        end,
                    },
                    Err(reason) => {
                        self.model.fallbacks.add(reason);
                        self.solved(exact(&self.exact))
                    }
                }
            }
            ResistedMotion::Skid(_) | ResistedMotion::Rest => {
                self.has_slipped.set(false);
                let exact = |exact: &Exact<'a>| exact.resisted(&state, body, motion, half_swings);
                let simulated = self.not_computed(state, exact);
                simulated.unwrap_or_else(|| self.solved(exact(&self.exact)))
            }
        }
    }

    /// A phase that was solved exactly, from a state of the simulation or not.
    fn solved(&self, solved: PhaseResult<Exact<'_>>) -> PhaseResult<Self> {
        let solved = self.taken_over(solved);
        if let (false, Some(end)) = (self.error.get().is_exact(), solved.end.state(Self::state)) {
            self.add_phase_error(&end);
        }
        solved
    }

    /// The end of rolling.
    fn rolled_with_resistance(&self, place: &EngineState, heading: f64) -> Result<Ended, Fallback> {
        let state = place.state;
        if is_out_of_range(state.theta) {
            return Err(Fallback::Far);
        }
        let (time_left, uses_tables) = (self.until() - state.time, self.uses_tables());
        if state.theta_rate == 0.0
            && self.interpolates_slides
            && uses_tables
            && let Some(end) = self.half_swing(place, heading, time_left)
        {
            return Ok(end);
        }
        let end = self
            .model
            .roll_resisted(place, heading, time_left, uses_tables)
            .unwrap_or(Err(Fallback::Standstill))?;
        let ResistedRollEnd {
            stop,
            elapsed,
            theta,
            theta_rate,
            angle,
            max_u,
        } = end;
        Ok(match stop {
            RollStop::Slip(slip) => {
                let slip = RollSlip {
                    elapsed,
                    theta,
                    theta_rate,
                    slip,
                    angle,
                };
                self.slipped(place, &slip, heading)
            }
            RollStop::Turn { u_slope } => {
                let end = Self::state_on_orbit(place, heading * theta, state.time + elapsed);
                let angle = angle.mirrored_by(heading);
                let turn = TurningPointError { u: max_u, u_slope };
                self.swung(EngineState { state: end, angle }, turn)
            }
            RollStop::Cut => {
                let end = Self::state_on_orbit(place, heading * theta, self.until());
                self.add_phase_error(&end);
                Self::cut(State {
                    theta_rate: heading * theta_rate,
                    ..end
                })
            }
        })
    }

    /// The end of a half swing, if it is interpolated and not beyond the limit of time.
    fn half_swing(&self, place: &EngineState, heading: f64, time_left: f64) -> Option<Ended> {
        let HalfSwing { turned, elapsed } = self.model.half_swing(place, heading)?;
        if elapsed > time_left {
            return None;
        }
        let state = place.state;
        let theta = state.theta + heading * turned;
        let end = EngineState::new(Self::state_on_orbit(place, theta, state.time + elapsed));
        let [start, angle] = [place, &end].map(|point| point.angle.mirrored_by(heading));
        Some(self.swung(end, self.model.turning_point_error(start, angle)?))
    }

    /// The state without slip at an angle on the orbit from a place, at rest.
    fn state_on_orbit(place: &EngineState, theta: f64, time: f64) -> State {
        State {
            time,
            theta,
            theta_rate: 0.0,
            slip: 0.0,
            x: place.state.x - (theta - place.state.theta),
        }
    }

    /// The end of rolling at a turning point.
    fn swung(&self, point: EngineState, turn: TurningPointError) -> Ended {
        self.add_phase_error(&point.state);
        self.with_error(|error| error.add_turning_point(turn));
        let held = Held {
            slip: true,
            turn: false,
        };
        PhaseEnd::Event {
            point,
            cause: Cause::TurningPoint,
            arrival: Arrival::Held(held),
        }
    }

    /// The end of a slide from a place at θ′ = 0.
    #[inline(never)]
    pub(super) fn turned(
        &self,
        place: &EngineState,
        direction: SlipDirection,
        heading: f64,
        event: &SlideEvent,
    ) -> Ended {
        let end = State {
            theta_rate: 0.0,
            ..self.slide_end(place, direction, event, false)
        };
        let Angle { sin, cos } = event.angle;
        let law = self.model.sliding_towards(direction, heading);
        self.with_error(|error| {
            error.add_turning_point(TurningPointError {
                u: 1.0 + place.u(),
                u_slope: law.u_growth(sin, cos),
            });
        });
        PhaseEnd::Event {
            point: EngineState {
                state: end,
                angle: event.angle,
            },
            cause: Cause::TurningPoint,
            arrival: Arrival::Held(Held::NOTHING),
        }
    }
}
