//! Where rolling has given way, as slides without kinetic friction come back to it.
//!
//! Such a slide conserves the energy and the horizontal momentum: θ′² and η′ are the same functions of cos θ as long as it slides,
//! through reversals and turning points. At a slip |F| = μs N and η′ = 0. So η′ vanishes again just where the hoop is back at that angle, or at
//! its mirror image, and |F| = μs N holds there exactly, which rounding would decide either way. Where N is small η″ is small, too, and
//! the zero of η′ is less well known than the angle is: so the slide ends at the angle. What follows is known by symmetry: the friction force that rolling needs, over the normal force, is the same in size at all four places (±θ, ±θ′), and grows at two of them, where
//! the hoop slips, and falls at the other two, where static friction holds from there on.

use core::f64::consts::TAU;

use crate::candidates::Arrival;
use crate::equations::SlidingLaw;
use crate::hoop::Heavy;
use crate::mode::Direction;
use crate::same::is_same;
use crate::state::State;
use crate::trig::sincos;

/// A slip out of rolling without kinetic friction.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LastSlip {
    pub(crate) state: State,
    /// Direction in which the slip began.
    pub(crate) direction: Direction,
}

impl LastSlip {
    /// A state at which η′ has vanished again, with the digits that the conserved quantities give it, and how it is reached.
    pub(crate) fn comes_to_rest(&self, body: &Heavy, state: &State) -> Option<(State, Arrival)> {
        let at_slip = sincos(self.state.theta);
        let (_, cos) = sincos(state.theta);
        let [from_slip, others @ ..] = self.standstills(body, at_slip).map(|other| other - (cos - at_slip.1));
        let nearest = others.into_iter().fold(from_slip, |a, b| if b.abs() < a.abs() { b } else { a });
        let is_slip = nearest == from_slip;
        let angle = if is_slip { self.state.theta } else { libm::acos(cos + nearest) };
        let [turned, mirrored] = [angle, -angle].map(|angle| same_direction_near(angle, state.theta));
        let [from_turned, from_mirrored] = [turned, mirrored].map(|angle| (angle - state.theta).abs());
        if from_turned == from_mirrored {
            return None;
        }
        let is_turned = from_turned < from_mirrored;
        let theta = if is_turned { turned } else { mirrored };
        let (sin, cos) = sincos(theta);
        let theta_rate = if is_slip {
            self.state.theta_rate.abs().copysign(state.theta_rate)
        } else {
            self.state.theta_rate * (1.0 + body.h * at_slip.1) / (1.0 + body.h * cos)
        };
        let law = SlidingLaw::of_body(*body, 0.0, self.direction);
        let accelerations = law.accelerations(theta, theta_rate);
        // The time is that of the angle where the angle is known better than the slip tells it.
        let by_angle = theta_rate.abs() * if is_slip { 1.0 } else { sin.abs() } > accelerations.slip.abs();
        let late = if by_angle { (theta - state.theta) / theta_rate } else { 0.0 };
        let agrees = is_same(theta, state.theta + theta_rate * late)
            && is_same(theta_rate, state.theta_rate + accelerations.theta * late)
            && is_same(0.0, accelerations.slip * late);
        if !agrees || !(by_angle || is_slip) {
            return None;
        }
        // Next to η′ = 0 the hoop moves on as if it rolled.
        let x = state.x - theta_rate * late;
        let placed = State { time: state.time + late, theta, theta_rate, slip: 0.0, x };
        if !is_slip {
            return Some((placed, Arrival::Open));
        }
        let slips = is_turned == (state.theta_rate * self.state.theta_rate > 0.0);
        let direction = if is_turned { self.direction } else { self.direction.reversed() };
        Some((placed, Arrival::BackOnLimit(slips.then_some(direction))))
    }

    /// The cosines at which η′ vanishes, as distances from the one at the slip, which is the first; none that is not real.
    fn standstills(&self, body: &Heavy, at_slip: (f64, f64)) -> [f64; 3] {
        let integrals = FrictionlessIntegrals::new(body, &self.state, at_slip);
        let [_, slope, square, cube] =
            integrals.standstill(body, at_slip.1).map(|[first, second]| first + second);
        let root = (square * square - 4.0 * cube * slope).sqrt();
        let larger = -0.5 * (square + root.copysign(square));
        [0.0, larger / cube, slope / larger]
    }
}

/// The angle in the direction of one, next to another.
fn same_direction_near(direction: f64, to: f64) -> f64 {
    direction + TAU * ((to - direction) / TAU).round()
}

/// First integrals of a slide without friction. With c = cos ϑ, s = sin ϑ, u = ϑ′² and J = Î + m h² s²,
///
/// ```text
/// J u + 2 m h c = C,    η′ − ϑ′ (1 + h c) = A.
/// ```
pub(crate) struct FrictionlessIntegrals {
    /// C, twice the energy.
    pub(crate) energy: f64,
    /// A, the horizontal momentum.
    pub(crate) momentum: f64,
}

impl FrictionlessIntegrals {
    /// At a state, of whose angle sine and cosine are given.
    pub(crate) fn new(body: &Heavy, state: &State, (sin, cos): (f64, f64)) -> Self {
        let Heavy { mass, h, inertia, offset } = *body;
        let rate = state.theta_rate;
        Self {
            energy: (inertia + mass * (h * sin) * (h * sin)) * rate * rate + 2.0 * offset * cos,
            momentum: state.slip - rate * (1.0 + h * cos),
        }
    }

    /// A² J − (C − 2 m h c) (1 + h c)², which vanishes with η′, in powers of the distance of c from a cosine, each coefficient as the sum of its two
    /// terms.
    pub(crate) fn standstill(&self, body: &Heavy, cos: f64) -> [[f64; 2]; 4] {
        let Heavy { mass, h, inertia, offset } = *body;
        let (square, product) = (self.momentum * self.momentum, mass * h * h);
        let lever = 1.0 + h * cos;
        let [kinetic, slope] = [self.energy - 2.0 * offset * cos, -2.0 * offset];
        [
            [square * (inertia + product * (1.0 - cos) * (1.0 + cos)), -kinetic * lever * lever],
            [-2.0 * square * product * cos, -(kinetic * 2.0 * h + slope * lever) * lever],
            [-square * product, -(kinetic * h + slope * 2.0 * lever) * h],
            [0.0, -slope * h * h],
        ]
    }
}
