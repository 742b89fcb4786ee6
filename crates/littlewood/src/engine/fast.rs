//! The walk of a motion along the automaton, by tables where they are sure and by the exact solvers where not.

use crate::candidates::{Arrival, Next, next_motion};
use crate::flight::Flight;
use crate::hoop::Hoop;
use crate::mode::{Direction, Mode};
use crate::outcome::OutcomeKind;
use crate::rolling::{Rolling, RollingLimit};
use crate::sequence::PhaseSequence;
use crate::simulate::Limits;
use crate::sliding::{Entry, Sliding, SlidingEnd};
use crate::state::{State, energy};
use crate::summary::Summary;
use crate::trig::sincos;

use super::Tables;
use super::jump;
use super::roll::RollEnd;
use super::slide::SlideStart;
use super::slip::{Ahead, SlipPoint};

/// Forces within this part of the friction limit, or of lift-off, are decided by the exact rules.
const DOUBT: f64 = 1e-9;

pub(super) struct Walk<'a> {
    hoop: &'a Hoop,
    tables: &'a Tables,
    limits: Limits,
    until: f64,
}

/// A state with the sine and cosine of its angle.
#[derive(Clone, Copy, Debug)]
struct Here {
    state: State,
    direction: (f64, f64),
    /// Where it is the end of rolling by the table.
    slip: Option<SlipPoint>,
    /// What is known of the phase that begins here.
    ahead: Ahead,
}

impl Here {
    fn new(state: State) -> Self {
        Self { state, direction: sincos(state.theta), slip: None, ahead: Ahead::Open }
    }
}

/// How a phase ends.
enum Step {
    /// In an event; the state there and what follows, if that is known already.
    Event { here: Here, slip: bool, next: Option<Next>, arrival: Arrival },
    /// In the outcome of the motion.
    End { outcome: OutcomeKind, state: State },
}

impl<'a> Walk<'a> {
    pub(super) fn new(hoop: &'a Hoop, tables: &'a Tables, limits: Limits) -> Self {
        Self { hoop, tables, limits, until: limits.until.unwrap_or(f64::INFINITY) }
    }

    pub(super) fn summary(&self, start: State) -> Summary {
        let mut summary = Summary {
            outcome: OutcomeKind::TimeLimit,
            sequence: PhaseSequence::default(),
            transitions: 0,
            end: start,
            energy: f64::NAN,
            first_slip_time: f64::NAN,
            lift_off_time: f64::NAN,
            jump_length: f64::NAN,
            jump_height: f64::NAN,
            painleve: false,
        };
        let mut here = Here::new(start);
        let mut next = self.decide(&here, Arrival::Open);
        loop {
            let step = match next {
                Next::None(_) | Next::Several(_) => {
                    summary.painleve = true;
                    summary.outcome = if matches!(next, Next::None(_)) {
                        OutcomeKind::Inconsistent
                    } else {
                        OutcomeKind::Ambiguous
                    };
                    summary.end = here.state;
                    if !summary.sequence.is_empty() {
                        summary.energy = energy(self.hoop, &here.state, 0.0, 0.0);
                    }
                    return summary;
                }
                Next::Roll => {
                    summary.sequence.push(Mode::Rolling, None);
                    self.roll(&here)
                }
                Next::Slide { direction, slip_acceleration, .. } => {
                    summary.sequence.push(Mode::Sliding, Some(direction));
                    self.slide(&here, direction, slip_acceleration)
                }
                Next::Fly { grazing, .. } => {
                    summary.sequence.push(Mode::Flight, None);
                    self.fly(&here, grazing, &mut summary);
                    return summary;
                }
                Next::Glide { .. } => {
                    // Only a massless hoop glides, and it has no tables.
                    summary.outcome = OutcomeKind::Inconsistent;
                    return summary;
                }
            };
            match step {
                Step::End { outcome, state } => {
                    summary.outcome = outcome;
                    summary.end = state;
                    summary.energy = energy(self.hoop, &state, 0.0, 0.0);
                    summary.painleve = outcome == OutcomeKind::Singular;
                    if summary.painleve {
                        summary.transitions += 1;
                    }
                    return summary;
                }
                Step::Event { here: end, slip, next: known, arrival } => {
                    if slip && summary.first_slip_time.is_nan() {
                        summary.first_slip_time = end.state.time;
                    }
                    summary.transitions += 1;
                    here = end;
                    next = known.unwrap_or_else(|| self.decide(&here, arrival));
                    let ends = matches!(next, Next::None(_) | Next::Several(_));
                    if summary.transitions as usize >= self.limits.transitions && !ends {
                        summary.outcome = OutcomeKind::TransitionLimit;
                        summary.end = here.state;
                        summary.energy = energy(self.hoop, &here.state, 0.0, 0.0);
                        return summary;
                    }
                }
            }
        }
    }

    /// w = 1 − h cos θ θ′².
    fn contact(&self, here: &Here) -> f64 {
        let rate = here.state.theta_rate;
        1.0 - self.tables.body.h * (here.direction.1 * (rate * rate))
    }

    /// Which motion follows, where the answer is clear at a glance.
    fn decide(&self, here: &Here, arrival: Arrival) -> Next {
        let body = self.tables.body;
        let Here { state, direction: (sin, cos), .. } = here;
        let u = state.theta_rate * state.theta_rate;
        let w = self.contact(here);
        if w.abs() > DOUBT {
            if w < 0.0 {
                return Next::Fly { body, grazing: false };
            }
            if let Some(direction) = Direction::of_sign(state.slip) {
                return Next::Slide { body, direction, slip_acceleration: None };
            }
            let m = body.mass;
            let denominator = body.inertia + m * (1.0 + body.h * (body.h + 2.0 * cos));
            let acceleration = body.offset * sin * (1.0 + u) / denominator;
            let normal = m - body.offset * (sin * acceleration + cos * u);
            let friction = body.offset * sin * u - (m + body.offset * cos) * acceleration;
            let excess = friction.abs() - self.hoop.mu_s() * normal;
            let clear = excess.abs() > DOUBT * (m + friction.abs() + u);
            // At the limit of rolling the slip acceleration follows from the difference of the coefficients.
            let (direction, excess) = match arrival {
                Arrival::RollingLimit(RollingLimit::Friction(direction)) => (Some(direction), 0.0),
                _ => (Direction::of_sign(-friction), excess),
            };
            if arrival == Arrival::Open && clear && excess < 0.0 && state.theta_rate != 0.0 {
                return Next::Roll;
            }
            if arrival != Arrival::Open || (clear && excess > 0.0) {
                let drive = excess + (self.hoop.mu_s() - self.hoop.mu_k()) * normal;
                if let Some(direction) = direction.filter(|_| drive > DOUBT) {
                    let q = body.h * sin - self.hoop.mu_k() * direction.sign() * (1.0 + body.h * cos);
                    let p = body.inertia + m * body.h * sin * q;
                    let slip_acceleration = Some(direction.sign() * denominator * drive / (m * p));
                    return Next::Slide { body, direction, slip_acceleration };
                }
            }
        }
        next_motion(self.hoop, state, arrival)
    }

    fn roll(&self, here: &Here) -> Step {
        let state = here.state;
        let travel = if state.theta_rate < 0.0 { -1.0 } else { 1.0 };
        let table = &self.tables.roll;
        let known = if state.theta_rate == 0.0 {
            None
        } else {
            let ahead = if let Ahead::Roll(ahead) = &here.ahead { Some(ahead) } else { None };
            table.follow(travel * state.theta, travel * state.theta_rate, here.direction.1, ahead)
        };
        match known {
            Some(RollEnd::Never) => Step::End { outcome: OutcomeKind::RollsForever, state },
            Some(RollEnd::Slip { elapsed, theta, theta_rate, point, direction: (sin, cos), .. })
                if state.time + elapsed <= self.until =>
            {
                let theta = travel * theta;
                let towards = if (point.side == 0) == (travel < 0.0) {
                    Direction::Positive
                } else {
                    Direction::Negative
                };
                let end = State {
                    time: state.time + elapsed,
                    theta,
                    theta_rate: travel * theta_rate,
                    slip: 0.0,
                    x: state.x - (theta - state.theta),
                };
                let here = Here {
                    state: end,
                    direction: (travel * sin, cos),
                    slip: Some(point),
                    ahead: Ahead::Open,
                };
                let arrival = Arrival::RollingLimit(RollingLimit::Friction(towards));
                Step::Event { here, slip: true, next: None, arrival }
            }
            _ => self.roll_exactly(state),
        }
    }

    fn roll_exactly(&self, state: State) -> Step {
        let rolling = Rolling::new(self.hoop, state);
        match rolling.orbit().end() {
            None => Step::End { outcome: OutcomeKind::RollsForever, state },
            Some(end) if end.elapsed <= self.until - state.time => Step::Event {
                here: Here::new(rolling.state_at(end.theta, end.theta_rate, end.elapsed)),
                slip: true,
                next: None,
                arrival: Arrival::RollingLimit(end.limit),
            },
            Some(_) => self.stopped(rolling.state(self.until - state.time)),
        }
    }

    fn stopped(&self, state: State) -> Step {
        Step::End { outcome: OutcomeKind::TimeLimit, state: State { time: self.until, ..state } }
    }

    fn slide(&self, here: &Here, direction: Direction, slip_acceleration: Option<f64>) -> Step {
        let state = here.state;
        let sigma = direction.sign();
        let (sin0, cos0) = (sigma * here.direction.0, here.direction.1);
        let starts = slip_acceleration.is_none_or(|acceleration| acceleration != 0.0);
        let travel = if state.theta_rate < 0.0 { -1.0 } else { 1.0 };
        let known = here.slip.and_then(|point| {
            let direction = (travel * here.direction.0, cos0);
            self.tables.slip.follow(point, travel * state.theta, travel * state.theta_rate, direction)
        });
        let ahead = known.map_or(Ahead::Open, |end| end.ahead);
        let followed = if let Some(end) = known {
            Some(end.event)
        } else if starts {
            self.tables.slide.follow(SlideStart {
                theta: sigma * state.theta,
                theta_rate: sigma * state.theta_rate,
                slip: sigma * state.slip,
                direction: (sin0, cos0),
            })
        } else {
            None
        };
        let Some(event) = followed.filter(|event| state.time + event.elapsed <= self.until) else {
            return self.slide_exactly(state, direction, slip_acceleration);
        };
        // Second integral of sliding, x̄ + μk σ (ȳ + τ²/2) − linear = const, in the frame with σ = +1.
        let (h, mu) = (self.tables.body.h, self.hoop.mu_k());
        let (sin, cos) = event.direction;
        let rate = sigma * state.theta_rate;
        let drift = sigma * state.slip - (1.0 + h * cos0) * rate - mu * h * sin0 * rate;
        let moved = drift * event.elapsed - mu * (h * (cos - cos0) + 0.5 * event.elapsed * event.elapsed)
            + h * (sin - sin0);
        let end = State {
            time: state.time + event.elapsed,
            theta: sigma * event.theta,
            theta_rate: sigma * event.theta_rate,
            slip: if event.lifts_off { sigma * event.slip } else { 0.0 },
            x: state.x + sigma * moved,
        };
        let next = event.lifts_off.then_some(Next::Fly { body: self.tables.body, grazing: true });
        let here = Here { state: end, direction: (sigma * sin, cos), slip: None, ahead };
        Step::Event { here, slip: false, next, arrival: Arrival::Open }
    }

    fn slide_exactly(&self, state: State, direction: Direction, slip_acceleration: Option<f64>) -> Step {
        let body = self.tables.body;
        let entry = slip_acceleration
            .map_or(Entry::Moving, |slip_acceleration| Entry::FromRest { slip_acceleration });
        let allowed = self.limits.until.map(|until| until - state.time);
        let (_, end) = Sliding::run(self.hoop, &body, state, direction, entry, allowed);
        match end {
            SlidingEnd::Rest(state) => {
                Step::Event { here: Here::new(state), slip: false, next: None, arrival: Arrival::Open }
            }
            SlidingEnd::LiftOff(state) => Step::Event {
                here: Here::new(state),
                slip: false,
                next: Some(Next::Fly { body, grazing: true }),
                arrival: Arrival::Open,
            },
            SlidingEnd::Singular(state) => Step::End { outcome: OutcomeKind::Singular, state },
            SlidingEnd::Unresolved(state) => Step::End { outcome: OutcomeKind::Unresolved, state },
            SlidingEnd::TimeLimit(state) => self.stopped(state),
            SlidingEnd::Endless(_) => Step::End { outcome: OutcomeKind::SlidesForever, state },
        }
    }

    fn fly(&self, here: &Here, grazing: bool, summary: &mut Summary) {
        let state = here.state;
        let body = &self.tables.body;
        let travel = if state.theta_rate < 0.0 { -1.0 } else { 1.0 };
        let known = if grazing { jump::angles(travel * state.theta) } else { None };
        let flight = match known {
            Some(angles) => Flight::with_angles(body, state, grazing, here.direction, angles),
            // So close to w = 0 the exact rules have decided, with their own cosine.
            None if !grazing && self.contact(here) > -DOUBT => Flight::new(body, state, grazing),
            None => Flight::from_direction(body, state, grazing, here.direction),
        };
        summary.lift_off_time = state.time;
        let duration = flight.duration();
        if duration > self.until - state.time {
            let allowed = self.until - state.time;
            let (gap, gap_rate) = flight.gap(allowed);
            summary.end = State { time: self.until, ..flight.state(allowed) };
            summary.energy = energy(self.hoop, &summary.end, gap, gap_rate);
        } else {
            let (gap, gap_rate) = flight.gap(duration);
            summary.outcome = OutcomeKind::Landing;
            summary.transitions += 1;
            summary.end = flight.state(duration);
            summary.energy = energy(self.hoop, &summary.end, gap, gap_rate);
            summary.jump_length = (summary.end.x - state.x).abs();
            summary.jump_height = flight.apex().1;
        }
    }
}
