//! Where a slip has begun, as slides without kinetic friction come back to it.
//!
//! Such a slide conserves the energy and the horizontal momentum: θ′² and η′ are the same functions of cos θ as long as it slides,
//! through reversals and turning points. At a slip |F| = μs N and η′ = 0. So η′ vanishes again just where the hoop is back at that angle, or at
//! its mirror image, and |F| = μs N holds there exactly, which rounding would decide either way. Where N is small η″ is small, too, and
//! the zero of η′ is less well known than the angle is: so the slide ends at the angle. What follows is known by symmetry: the friction force that rolling needs, over the normal force, is the same in size at all four places (±θ, ±θ′), and grows at two of them, where
//! the hoop slips, and falls at the other two, where static friction holds from there on.
//!
//! A motion that starts with η′ = 0 where rolling would ask for more than the limit, however little, asks for as much more at all four places, and slips at each.

use core::f64::consts::TAU;

use crate::candidates::Arrival;
use crate::equations::SlidingLaw;
use crate::frictionless::FrictionlessIntegrals;
use crate::hoop::{Heavy, Hoop};
use crate::mode::Direction;
use crate::same::is_same;
use crate::state::State;
use crate::trig::sincos;

/// The beginning of a slip without kinetic friction, at η′ = 0.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LastSlip {
    state: State,
    /// Direction in which the slip began.
    direction: Direction,
    /// Whether it is the end of rolling, where |F| = μs N; where a motion starts |F| is larger.
    is_on_limit: bool,
}

impl LastSlip {
    /// Where rolling has given way; none with kinetic friction, which conserves nothing.
    pub(crate) fn out_of_rolling(hoop: &Hoop, state: State, direction: Direction) -> Option<Self> {
        (hoop.mu_k() == 0.0).then_some(Self { state, direction, is_on_limit: true })
    }

    /// Where a motion starts that slides, if it does: with η′ = 0 rolling asks for more than static friction there is, if there is any.
    pub(crate) fn at_start(hoop: &Hoop, state: State, slides: Option<Direction>) -> Option<Self> {
        let direction = slides.filter(|_| state.slip == 0.0 && hoop.mu_k() == 0.0 && hoop.mu_s() > 0.0)?;
        Some(Self { state, direction, is_on_limit: false })
    }

    /// A state at which η′ has vanished again, with the digits that the conserved quantities give it, and how it is reached.
    pub(crate) fn comes_to_rest(&self, body: &Heavy, state: &State) -> Option<(State, Arrival)> {
        let [integrals, here] =
            [&self.state, state].map(|state| FrictionlessIntegrals::new(body, state, sincos(state.theta)));
        if !is_same(integrals.energy, here.energy) || !is_same(integrals.momentum, here.momentum) {
            return None;
        }
        let (theta, theta_rate, arrival) = if self.is_nearest(body, &integrals, state) {
            self.back_on_limit(state)?
        } else {
            let (theta, theta_rate) = integrals.standstill_near(body, state.theta)?;
            (theta, theta_rate, Arrival::Open)
        };
        let law = SlidingLaw::of_body(*body, 0.0, self.direction);
        // The time is that of the angle where the angle changes faster than the slip.
        let by_angle = theta_rate.abs() > law.accelerations(theta, theta_rate).slip.abs();
        let late = if by_angle { (theta - state.theta) / theta_rate } else { 0.0 };
        // Next to η′ = 0 the hoop moves on as if it rolled.
        let x = state.x - theta_rate * late;
        let placed = State { time: state.time + late, theta, theta_rate, slip: 0.0, x };
        Some((placed, arrival))
    }

    /// The angle and the rate of the one of the four that is the nearest to a state, and how it is reached.
    fn back_on_limit(&self, state: &State) -> Option<(f64, f64, Arrival)> {
        let [turned, mirrored] =
            [self.state.theta, -self.state.theta].map(|angle| same_direction_near(angle, state.theta));
        let [from_turned, from_mirrored] = [turned, mirrored].map(|angle| (angle - state.theta).abs());
        if from_turned == from_mirrored {
            return None;
        }
        let is_turned = from_turned < from_mirrored;
        // Beyond the limit it slips on everywhere.
        let slips = !self.is_on_limit || is_turned == (state.theta_rate * self.state.theta_rate > 0.0);
        let direction = if is_turned { self.direction } else { self.direction.reversed() };
        Some((
            if is_turned { turned } else { mirrored },
            self.state.theta_rate.abs().copysign(state.theta_rate),
            Arrival::BackOnLimit(slips.then_some(direction)),
        ))
    }

    /// Whether the cosine at the slip, of all at which η′ vanishes, is the nearest to that of a state.
    fn is_nearest(&self, body: &Heavy, integrals: &FrictionlessIntegrals, state: &State) -> bool {
        let [at_slip, here] = [self.state.theta, state.theta].map(|angle| sincos(angle).1);
        let [_, slope, square, cube] =
            integrals.standstills(body, at_slip).map(|[first, second]| first + second);
        // The other two, as distances from the one at the slip; not a number where they are not real.
        let root = (square * square - 4.0 * cube * slope).sqrt();
        let larger = -0.5 * (square + root.copysign(square));
        let away = here - at_slip;
        [larger / cube, slope / larger]
            .iter()
            .all(|other| (other - away).abs() >= away.abs() || other.is_nan())
    }
}

/// The angle in the direction of one, next to another.
fn same_direction_near(direction: f64, to: f64) -> f64 {
    direction + TAU * ((to - direction) / TAU).round()
}
