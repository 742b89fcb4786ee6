//! Skidding and rest, in closed form: rolling resistance holds the angle.

use crate::math::number::Number;
use crate::mechanics::{Accelerations, Clearance, ContactForces, HeldLaw};
use crate::model::{Heavy, Hoop, Mode, SlipDirection, State};
use crate::modes::{Instant, Sample};

/// A phase of skidding: η′ changes at a constant rate.
#[derive(Clone, Copy, Debug)]
pub struct Skidding {
    law: HeldLaw,
    direction: SlipDirection,
    start: State,
}

impl Skidding {
    pub(crate) fn new(body: &Heavy, mu_k: f64, direction: SlipDirection, start: State) -> Self {
        Self {
            law: HeldLaw {
                body: *body,
                friction: mu_k * direction.sign(),
            },
            direction,
            start,
        }
    }

    /// Direction of slip.
    pub const fn direction(&self) -> SlipDirection {
        self.direction
    }

    /// η″.
    pub(crate) fn slip_acceleration(&self) -> f64 {
        self.law.slip_acceleration()
    }

    /// Time to η′ = 0; none if the slip does not slow down.
    pub(crate) fn duration(&self) -> Option<f64> {
        let braking = -self.direction.sign() * self.slip_acceleration();
        (braking > 0.0).then(|| self.start.slip.abs() / braking)
    }

    /// The end of a phase of this duration, at η′ = 0.
    pub(crate) fn end(&self, duration: f64) -> State {
        State {
            slip: 0.0,
            ..self.state(duration)
        }
    }

    /// State after the time `elapsed` since the phase began.
    pub fn state(&self, elapsed: f64) -> State {
        let gained = self.slip_acceleration() * elapsed;
        State {
            time: self.start.time + elapsed,
            slip: self.start.slip + gained,
            x: self.start.x + (self.start.slip + 0.5 * gained) * elapsed,
            ..self.start
        }
    }

    pub(crate) fn sample(&self, hoop: &Hoop, state: State) -> Sample {
        let mass = self.law.body.mass;
        let couple = mass * self.law.arm_of_skid(state.theta.angle());
        let instant = Instant {
            mode: Mode::Skidding,
            direction: Some(self.direction),
            accelerations: Accelerations {
                theta: 0.0,
                slip: self.slip_acceleration(),
            },
            forces: ContactForces {
                normal: mass,
                friction: -self.law.friction * mass,
            },
            couple,
            clearance: Clearance::NONE,
        };
        instant.sample(hoop, state)
    }
}

/// A phase of rest, without end.
#[derive(Clone, Copy, Debug)]
pub struct Rest {
    law: HeldLaw,
    start: State,
}

impl Rest {
    pub(crate) const fn new(body: &Heavy, start: State) -> Self {
        let law = HeldLaw {
            body: *body,
            friction: 0.0,
        };
        Self { law, start }
    }

    /// State after the time `elapsed` since the phase began.
    pub fn state(&self, elapsed: f64) -> State {
        State {
            time: self.start.time + elapsed,
            ..self.start
        }
    }

    pub(crate) fn sample(&self, hoop: &Hoop, state: State) -> Sample {
        let body = &self.law.body;
        let couple = body.mass * self.law.arm_of_rest(state.theta.angle());
        let instant = Instant {
            mode: Mode::Rest,
            direction: None,
            accelerations: Accelerations {
                theta: 0.0,
                slip: 0.0,
            },
            forces: ContactForces {
                normal: body.mass,
                friction: body.mass * body.pull(),
            },
            couple,
            clearance: Clearance::NONE,
        };
        instant.sample(hoop, state)
    }
}
