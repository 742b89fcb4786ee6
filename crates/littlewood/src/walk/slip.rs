//! The last slip out of rolling, to which slides without kinetic friction return.
//!
//! Such a slide conserves energy and horizontal momentum: θ′² and η′ are fixed functions of cos θ,
//! also through reversals and turning points. A slip has |F| = μs N and η′ = 0. So η′ vanishes
//! again where the hoop returns to that angle or to its mirror image. There |F| = μs N holds
//! exactly, and rounding would decide arbitrarily. For small N, η″ is small, too, and the angle is
//! more accurate than the zero of η′. So the slide ends at the angle.
//!
//! Symmetry decides the next motion: |F|/N of rolling is equal at the four states (±θ, ±θ′). It
//! increases at two of them, where the hoop slips, and decreases at the other two, where static
//! friction holds.
//!
//! A motion may also start with η′ = 0 and |F| > μs N. It then has the same excess at the four
//! states, and slips at each. With |F| = μs N it starts as it slips out of rolling.

use core::f64::consts::TAU;

use crate::math::trig::{Angle, sincos};
use crate::mechanics::{FrictionlessIntegrals, SlidingLaw, converge};
use crate::model::{Body, Heavy, Hoop, SlipDirection, State};
use crate::modes::{Entry, Onset, PhasePoint, RollingOrbit, Stiction};
use crate::walk::{Arrival, NextMotion, is_same};

/// Least distance, in cos θ, of two zeros of η′ after a start at rest. A closer pair is a
/// near-tangent zero, which is left to the numerical slide. On the limit of static friction η″ does
/// not vanish.
const MIN_STANDSTILL_DISTANCE: f64 = 1e-6;

/// The beginning of a slip without kinetic friction, at η′ = 0.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LastSlip {
    state: State,
    direction: SlipDirection,
    /// Whether the slip began with |F| = μs N, as where it ended rolling.
    is_on_limit: bool,
    /// The order of the first derivative of η′ that does not vanish there.
    order: usize,
}

/// The state in which a slide comes to rest, with the arrival there.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rest {
    pub(crate) state: State,
    pub(crate) arrival: Arrival,
}

/// The angle and its rate at a rest.
#[derive(Clone, Copy, Debug)]
struct RestPoint {
    theta: f64,
    theta_rate: f64,
    arrival: Arrival,
}

impl LastSlip {
    /// A slip that ended rolling; none where its slide does not conserve energy and momentum.
    pub(crate) fn out_of_rolling(
        hoop: &Hoop,
        state: State,
        direction: SlipDirection,
    ) -> Option<Self> {
        is_conservative(hoop).then_some(Self {
            state,
            direction,
            is_on_limit: true,
            order: 1,
        })
    }

    /// The start of a motion, if it slides from η′ = 0: there |F| of rolling is at least μs N.
    pub(crate) fn at_start(hoop: &Hoop, state: State, next: &NextMotion) -> Option<Self> {
        let NextMotion::Slide {
            direction,
            entry: Entry::FromRest { slip_acceleration },
            ..
        } = next
        else {
            return None;
        };
        if !is_conservative(hoop) {
            return None;
        }
        // What selects the slide has seen whether η″ vanishes.
        let order = if *slip_acceleration == 0.0 {
            order_at_start(hoop, &state)
        } else {
            1
        };
        Some(Self {
            state,
            direction: *direction,
            is_on_limit: starts_on_limit(hoop, &state),
            order,
        })
    }

    pub(crate) const fn order(&self) -> usize {
        self.order
    }

    /// Corrects a state in which a slide after this slip comes to rest, by the conserved
    /// quantities. None if they are not conserved, or if the state is not told from others.
    pub(crate) fn correct_rest(&self, body: &Heavy, state: &State) -> Option<Rest> {
        let [integrals, here] = [&self.state, state]
            .map(|state| FrictionlessIntegrals::new(body, state, Angle::of(state.theta)));
        if !is_same(integrals.energy, here.energy) || !is_same(integrals.momentum, here.momentum) {
            return None;
        }
        let RestPoint {
            theta,
            theta_rate,
            arrival,
        } = self.rest_point(body, &integrals, state)?;
        let law = SlidingLaw::of_body(*body, 0.0, self.direction);
        // The angle fixes the time if it changes faster than the slip.
        let by_angle = theta_rate.abs() > law.accelerations(theta, theta_rate).slip.abs();
        let late = if by_angle {
            (theta - state.theta) / theta_rate
        } else {
            0.0
        };
        let state = State {
            time: state.time + late,
            theta,
            theta_rate,
            slip: 0.0,
            // Near η′ = 0 the hoop moves as in rolling.
            x: state.x - theta_rate * late,
        };
        Some(Rest { state, arrival })
    }

    /// The point at which η′ vanishes next to a state: where the hoop is back at the angle of the
    /// slip, or another zero of η′ as a function of cos θ.
    fn rest_point(
        &self,
        body: &Heavy,
        integrals: &FrictionlessIntegrals,
        state: &State,
    ) -> Option<RestPoint> {
        let [at_slip, now] = [self.state.theta, state.theta].map(|angle| sincos(angle).1);
        let away = now - at_slip;
        let others = integrals.other_standstills(body, at_slip);
        // A zero of a higher order is that of the start itself, whose rounding moves the others.
        let is_multiple = self.order > 1;
        if !self.is_on_limit
            && !is_multiple
            && others
                .iter()
                .any(|other| other.abs() < MIN_STANDSTILL_DISTANCE)
        {
            return None;
        }
        let real = others.into_iter().filter(|other| {
            !(other.is_nan() || is_multiple && other.abs() < MIN_STANDSTILL_DISTANCE)
        });
        let nearest = real.min_by(|a, b| (a - away).abs().total_cmp(&(b - away).abs()));
        // The zero at the slip itself is at distance 0 in cos θ. Another one counts only if it is
        // nearer to the state.
        let Some(other) = nearest.filter(|other| (other - away).abs() < away.abs()) else {
            return self.back_on_limit(state);
        };
        let (theta, theta_rate) = if integrals.deflation_is_better(body, at_slip, other) {
            let theta = self.at_cosine(other, state.theta)?;
            (theta, integrals.rate_at_rest(body, Angle::of(theta)))
        } else {
            integrals.standstill_near(body, state.theta)?
        };
        Some(RestPoint {
            theta,
            theta_rate,
            arrival: Arrival::InContact,
        })
    }

    /// The nearer of the states (±θ, θ′) of the slip, with the arrival there.
    fn back_on_limit(&self, state: &State) -> Option<RestPoint> {
        let [turned, mirrored] = [self.state.theta, -self.state.theta]
            .map(|angle| same_direction_near(angle, state.theta));
        let [from_turned, from_mirrored] =
            [turned, mirrored].map(|angle| (angle - state.theta).abs());
        // After a zero of even order the slip has the direction that it had before, at both.
        let keeps = self.order.is_multiple_of(2);
        if from_turned == from_mirrored && !keeps {
            return None;
        }
        let is_turned = from_turned <= from_mirrored;
        // By the momentum −θ′ (1 + h cos θ) of η′ = 0 it turns as at the slip. With |F| > μs N it slips
        // at all four states. Zero has no sign.
        let theta_rate = self.state.theta_rate + 0.0;
        let slips = !self.is_on_limit || is_turned || theta_rate == 0.0;
        let direction = if is_turned || keeps {
            self.direction
        } else {
            self.direction.reversed()
        };
        Some(RestPoint {
            theta: if is_turned { turned } else { mirrored },
            theta_rate,
            arrival: Arrival::BackOnLimit(slips.then_some(direction)),
        })
    }

    /// The angle near `near` with cos θ = cos θ₀ + `more`, by Newton's method on the product 2 sin
    /// ½(θ + θ₀) sin ½(θ₀ − θ), which does not cancel. None if the iteration does not converge to
    /// it, as near cos θ = ±1.
    fn at_cosine(&self, more: f64, near: f64) -> Option<f64> {
        let from = self.state.theta;
        converge(near, |theta| {
            let [(sum, _), (difference, _)] =
                [theta + from, from - theta].map(|angle| sincos(0.5 * angle));
            (more - 2.0 * sum * difference) / sincos(theta).0
        })
    }
}

/// Whether slides conserve energy and horizontal momentum: kinetic friction and rolling resistance
/// dissipate energy, and a slope changes the momentum.
fn is_conservative(hoop: &Hoop) -> bool {
    hoop.mu_k() == 0.0 && hoop.rolling_resistance() == 0.0 && hoop.slope() == 0.0
}

/// Whether a start that slides has |F| = μs N, and not more by the last digit: on the limit the
/// next derivative lets it slip.
fn starts_on_limit(hoop: &Hoop, state: &State) -> bool {
    if hoop.mu_s() == 0.0 {
        return false;
    }
    match RollingOrbit::of(hoop, state.theta, state.theta_rate).stiction() {
        Stiction::Holds => true,
        Stiction::Slips { excess, .. } => excess <= 0.0,
        Stiction::NoNormalForce => false,
    }
}

/// The order of the zero of η′ at a start: 1 where |F| > μs N > 0.
fn order_at_start(hoop: &Hoop, state: &State) -> usize {
    let Body::Heavy(body) = hoop.body() else {
        return 1;
    };
    let law = SlidingLaw::of_body(body, 0.0, SlipDirection::Positive);
    let place = PhasePoint {
        theta: state.theta,
        rate: state.theta_rate,
    };
    Onset::of(&law, place).map_or(1, |onset| onset.order)
}

/// The angle equal to `direction` up to whole turns that is nearest to `to`.
fn same_direction_near(direction: f64, to: f64) -> f64 {
    direction + TAU * ((to - direction) / TAU).round()
}
