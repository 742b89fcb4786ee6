//! A state on the way of a motion.

use crate::math::trig::Angle;
use crate::model::State;

/// A state with sine and cosine of its angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct EngineState {
    pub(super) state: State,
    pub(super) angle: Angle,
}

impl EngineState {
    pub(super) fn new(state: State) -> Self {
        Self {
            state,
            angle: Angle::of(state.theta),
        }
    }

    /// Sign of θ′.
    pub(super) fn heading(&self) -> f64 {
        heading(&self.state)
    }

    /// u = θ′².
    pub(super) fn u(&self) -> f64 {
        self.state.theta_rate * self.state.theta_rate
    }
}

/// Sign of θ′, 1 at rest.
pub(super) const fn heading(state: &State) -> f64 {
    if state.theta_rate < 0.0 { -1.0 } else { 1.0 }
}

/// A state in a frame that is mirrored for −1.
pub(super) const fn mirrored_by(state: &State, mirror: f64) -> State {
    State {
        time: state.time,
        theta: mirror * state.theta,
        theta_rate: mirror * state.theta_rate,
        slip: mirror * state.slip,
        x: mirror * state.x,
    }
}
