//! Where rolling has given way, as slides without kinetic friction come back to it.
//!
//! Such a slide conserves the energy and the horizontal momentum: θ′² and η′ are the same functions of cos θ as long as it slides,
//! through reversals and turning points. At a slip |F| = μs N and η′ = 0. So η′ vanishes again just where the hoop is back at that angle, or at
//! its mirror image, and |F| = μs N holds there exactly, which rounding would decide either way. What follows is known by
//! symmetry: the friction force that rolling needs, over the normal force, is the same in size at all four places (±θ, ±θ′), and grows at two of them, where
//! the hoop slips, and falls at the other two, where static friction holds from there on.

use crate::candidates::Arrival;
use crate::mode::Direction;
use crate::same::{is_same, is_same_direction};
use crate::state::State;

/// A slip out of rolling without kinetic friction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LastSlip {
    pub(crate) state: State,
    /// Direction in which the slip began.
    pub(crate) direction: Direction,
}

impl LastSlip {
    /// How a state at which η′ has vanished again is reached, if it is one of the four.
    pub(crate) fn arrival(&self, state: &State) -> Option<Arrival> {
        let same_angle = is_same_direction(state.theta, self.state.theta);
        let mirrored = is_same_direction(state.theta, -self.state.theta);
        let (rate, at_slip) = (state.theta_rate, self.state.theta_rate);
        let same_rate = is_same(at_slip.abs(), rate.abs());
        if !same_rate || same_angle == mirrored {
            return None;
        }
        let slips = same_angle == (rate * at_slip > 0.0);
        let direction = if same_angle { self.direction } else { self.direction.reversed() };
        Some(Arrival::BackOnLimit(slips.then_some(direction)))
    }
}
