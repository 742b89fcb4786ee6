//! A state on the way of a motion.

use crate::math::trig::sincos;
use crate::model::State;

/// A state with the sine and cosine of its angle.
#[derive(Clone, Copy, Debug)]
pub(super) struct EngineState {
    pub(super) state: State,
    pub(super) direction: (f64, f64),
}

impl EngineState {
    pub(super) fn new(state: State) -> Self {
        Self {
            state,
            direction: sincos(state.theta),
        }
    }

    /// Sign of θ′.
    pub(super) fn travel(&self) -> f64 {
        if self.state.theta_rate < 0.0 {
            -1.0
        } else {
            1.0
        }
    }

    /// u = θ′².
    pub(super) fn u(&self) -> f64 {
        self.state.theta_rate * self.state.theta_rate
    }
}
