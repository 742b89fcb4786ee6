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

use crate::math::trig::sincos;
use crate::mechanics::{FrictionlessIntegrals, SlidingLaw, converge};
use crate::model::{Direction, Heavy, Hoop, State};
use crate::walk::{Arrival, is_same};

/// Where a motion starts and two zeros of η′ are closer than this in their cosines, it hardly vanishes, or hardly does not: the slide as it is followed tells. On the limit
/// of static friction η″ does not vanish.
const GRAZES: f64 = 1e-6;

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
        let direction = slides.filter(|_| state.slip == 0.0 && hoop.mu_k() == 0.0)?;
        Some(Self { state, direction, is_on_limit: false })
    }

    /// A state at which η′ has vanished again, with the digits that the conserved quantities give it, and how it is reached.
    pub(crate) fn comes_to_rest(&self, body: &Heavy, state: &State) -> Option<(State, Arrival)> {
        let [integrals, here] =
            [&self.state, state].map(|state| FrictionlessIntegrals::new(body, state, sincos(state.theta)));
        if !is_same(integrals.energy, here.energy) || !is_same(integrals.momentum, here.momentum) {
            return None;
        }
        let [at_slip, now] = [self.state.theta, state.theta].map(|angle| sincos(angle).1);
        let away = now - at_slip;
        let others = integrals.other_standstills(body, at_slip);
        if !self.is_on_limit && others.iter().any(|other| other.abs() < GRAZES) {
            return None;
        }
        let real = others.into_iter().filter(|other| !other.is_nan());
        let nearest = real.min_by(|a, b| (a - away).abs().total_cmp(&(b - away).abs()));
        let (theta, theta_rate, arrival) = match nearest.filter(|other| (other - away).abs() < away.abs()) {
            None => self.back_on_limit(state)?,
            Some(other) if integrals.deflation_is_better(body, at_slip, other) => {
                let theta = self.at_cosine(other, state.theta)?;
                (theta, integrals.rate_at_rest(body, sincos(theta)), Arrival::Open)
            }
            Some(_) => {
                let (theta, theta_rate) = integrals.standstill_near(body, state.theta)?;
                (theta, theta_rate, Arrival::Open)
            }
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

    /// The angle next to one whose cosine is that at the slip and so much more: Newton's method for the product 2 sin ½(θ + θ₀) sin ½(θ₀ − θ), which
    /// does not cancel. None where it leads elsewhere, as next to a cosine of ±1.
    fn at_cosine(&self, more: f64, near: f64) -> Option<f64> {
        let from = self.state.theta;
        converge(near, |theta| {
            let [(sum, _), (difference, _)] = [theta + from, from - theta].map(|angle| sincos(0.5 * angle));
            (more - 2.0 * sum * difference) / sincos(theta).0
        })
    }
}

/// The angle in the direction of one, next to another.
fn same_direction_near(direction: f64, to: f64) -> f64 {
    direction + TAU * ((to - direction) / TAU).round()
}
