//! What links do: from a slip to a later one.

use core::f64::consts::TAU;

use crate::model::State;
use crate::walk::PhaseSequence;

use super::curve::CurvePoint;

/// From a slip, travelling to positive angles, to a later one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::engine) struct SlipMapValue {
    /// The slip at the end, in the frame of motion there.
    pub(in crate::engine) end: CurvePoint,
    pub(in crate::engine) elapsed: f64,
    /// What is added to x.
    pub(in crate::engine) moved: f64,
    pub(in crate::engine) slid: f64,
    pub(in crate::engine) route: Itinerary,
}

/// What is the same for all links of a piece.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::engine) struct Itinerary {
    /// CurvePart of the curves on which the slip at the end is.
    part: usize,
    /// −1 if the hoop travels back at the end.
    pub(super) heading: f64,
    /// Turns: the angle at the end is heading (angle + 2π turns).
    turns: f64,
    pub(in crate::engine) transitions: u32,
    /// Digest of the phases: those of one link themselves.
    digest: u64,
}

/// A digest of two numbers, in order.
const fn mixed(first: u64, second: u64) -> u64 {
    // The multipliers are odd, so that nothing is lost.
    let sum = first
        .wrapping_mul(0x9e37_79b9_7f4a_7c15)
        .wrapping_add(second)
        .wrapping_add(1);
    (sum ^ (sum >> 29)).wrapping_mul(0xbf58_476d_1ce4_e5b9)
}

impl SlipMapValue {
    /// The link that led to a state at a slip, travelling to positive angles from x = 0 at τ = 0.
    pub(super) fn to(state: &State, end: CurvePoint, slid: f64, phases: PhaseSequence) -> Self {
        let heading = if state.theta_rate < 0.0 { -1.0 } else { 1.0 };
        let turns = (heading * state.theta / TAU).floor();
        let route = Itinerary {
            part: end.part,
            heading,
            turns,
            transitions: phases.len(),
            digest: phases.bits(),
        };
        Self {
            end,
            elapsed: state.time,
            moved: state.x,
            slid,
            route,
        }
    }

    /// The numbers that are interpolated.
    pub(super) const fn numbers(&self) -> [f64; 4] {
        [self.end.at, self.elapsed, self.moved, self.slid]
    }

    pub(super) const fn with_numbers(
        route: Itinerary,
        [at, elapsed, moved, slid]: [f64; 4],
    ) -> Self {
        Self {
            end: CurvePoint {
                part: route.part,
                at,
            },
            elapsed,
            moved,
            slid,
            route,
        }
    }

    pub(super) fn is_back(&self) -> bool {
        self.route.heading < 0.0
    }

    pub(super) fn then(&self, next: &Self) -> Self {
        let (first, second) = (&self.route, &next.route);
        Self {
            end: next.end,
            elapsed: self.elapsed + next.elapsed,
            moved: self.moved + first.heading * next.moved,
            slid: self.slid + next.slid,
            route: Itinerary {
                part: second.part,
                heading: first.heading * second.heading,
                turns: second.turns + second.heading * first.turns,
                transitions: first.transitions.saturating_add(second.transitions),
                digest: mixed(first.digest, second.digest),
            },
        }
    }

    /// The state at the end of a passage from a slip at a state, with the angle, reduced to a turn
    /// in the frame of motion, and |θ′| there.
    pub(in crate::engine) fn state_after(&self, start: &State, angle: f64, rate: f64) -> State {
        let sign = if start.theta_rate < 0.0 { -1.0 } else { 1.0 };
        let turns = (sign * start.theta / TAU).floor();
        let Itinerary {
            heading,
            turns: gained,
            ..
        } = self.route;
        State {
            time: start.time + self.elapsed,
            theta: sign * (heading * (angle + TAU * gained) + TAU * turns),
            theta_rate: sign * heading * rate,
            slip: 0.0,
            x: start.x + sign * self.moved,
        }
    }
}
