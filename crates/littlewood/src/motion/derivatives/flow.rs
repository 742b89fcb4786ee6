//! The flow of each mode over numbers that carry derivatives.
//!
//! Rolling and sliding follow Taylor series of their equations, the derivatives along with the
//! state; the slip and the position of a slide follow from its first integrals. Glides and flights
//! are in closed form.

use crate::math::number::{Dual, Number, WIDTH};
use crate::math::series::root;
use crate::math::series::{DEGREE, Series, convolve, value};
use crate::math::trig::{Angle, TruncatedSeries};
use crate::mechanics::{
    Accelerations, ContactMotion, HeldLaw, Loads, ResistedRollingLaw, SlidingLaw,
};
use crate::model::{Friction, Heavy, RotationDirection, SlipDirection, State};
use crate::modes::{PhasePoint, SlideSeries, TRUNCATION_TOLERANCE, gliding};

use super::{Derivative, NoDerivative};

/// Longest step: the series of a body at rest has no time scale.
const MAX_STEP: f64 = 1.0;

const MAX_STEPS: usize = 20_000;

/// Number of coefficients of which one is the scale of a series.
const LEADING: usize = 5;

#[derive(Clone, Copy, Debug)]
pub(super) struct Point<T> {
    pub(super) theta: T,
    pub(super) rate: T,
    pub(super) slip: T,
    pub(super) x: T,
}

impl<T: Number> Point<T> {
    /// Applies a function to each number, with that of another point.
    pub(super) fn zip<A: Copy, B>(self, other: Point<A>, f: impl Fn(T, A) -> B) -> Point<B> {
        Point {
            theta: f(self.theta, other.theta),
            rate: f(self.rate, other.rate),
            slip: f(self.slip, other.slip),
            x: f(self.x, other.x),
        }
    }
}

impl From<&State> for Point<f64> {
    fn from(state: &State) -> Self {
        Self {
            theta: state.theta,
            rate: state.theta_rate,
            slip: state.slip,
            x: state.x,
        }
    }
}

/// A mode with its directions, or with the start of a flight. The direction of rotation is given
/// only with rolling resistance: without it θ′ may change its sign within a phase.
#[derive(Clone, Copy, Debug)]
pub(super) enum Motion<T> {
    Rolls(Option<RotationDirection>),
    Slides(SlipDirection, Option<RotationDirection>),
    Skids(SlipDirection),
    Rests,
    Glides,
    Flies(FlightStart<T>),
}

/// The start of a flight.
#[derive(Clone, Copy, Debug)]
pub(super) struct FlightStart<T> {
    pub(super) point: Point<T>,
    /// The rate of the gap; zero at a lift-off.
    pub(super) gap_rate: T,
    /// Whether the gap opens with the third power of the time.
    pub(super) lifts_off: bool,
}

/// A point of a phase, and the time since the start of the phase, the same for all motions.
#[derive(Clone, Copy, Debug)]
pub(super) struct PhaseInstant<T> {
    pub(super) point: Point<T>,
    pub(super) elapsed: f64,
}

/// A body on a plane with friction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Plane<T> {
    pub(super) body: Heavy<T>,
    pub(super) friction: Friction<T>,
}

impl<T: Number> Plane<T> {
    /// Applies a function to each number.
    pub(super) fn map<B>(self, f: impl Fn(T) -> B) -> Plane<B> {
        let Heavy {
            mass,
            h,
            offset,
            inertia,
            tilt,
        } = self.body;
        Plane {
            body: Heavy {
                mass: f(mass),
                h: f(h),
                offset: f(offset),
                inertia: f(inertia),
                tilt: f(tilt),
            },
            friction: Friction {
                mu_s: f(self.friction.mu_s),
                mu_k: f(self.friction.mu_k),
                rolling_resistance: f(self.friction.rolling_resistance),
            },
        }
    }

    /// ς χ; 0 without a direction, and never −0.
    fn resistance(&self, rotation: Option<RotationDirection>) -> T {
        let (zero, chi) = (T::constant(0.0), self.friction.rolling_resistance);
        match rotation {
            Some(RotationDirection::Positive) => chi,
            Some(RotationDirection::Negative) => zero - chi,
            None => zero,
        }
    }

    fn sliding(
        &self,
        direction: SlipDirection,
        rotation: Option<RotationDirection>,
    ) -> SlidingLaw<T> {
        SlidingLaw {
            resistance: self.resistance(rotation),
            ..SlidingLaw::of_body(self.body, self.friction.mu_k, direction)
        }
    }

    pub(super) fn rolling(&self, rotation: Option<RotationDirection>) -> ResistedRollingLaw<T> {
        ResistedRollingLaw::of_body(&self.body, self.resistance(rotation))
    }

    fn skidding(&self, direction: SlipDirection) -> HeldLaw<T> {
        HeldLaw {
            body: self.body,
            friction: self.friction.mu_k * direction.sign(),
        }
    }

    pub(super) fn rates(&self, motion: &Motion<T>, at: &Point<T>) -> Point<T> {
        let angle = at.theta.angle();
        let Point { rate, slip, .. } = *at;
        let Heavy { h, .. } = self.body;
        let zero = T::constant(0.0);
        let turns = |rotation: &Option<RotationDirection>| {
            rotation.or_else(|| RotationDirection::of_sign(rate.value()))
        };
        let accelerations = match motion {
            Motion::Rolls(rotation) => Accelerations {
                theta: self
                    .rolling(turns(rotation))
                    .acceleration(angle, rate * rate),
                slip: zero,
            },
            Motion::Slides(direction, rotation) => self
                .sliding(*direction, turns(rotation))
                .accelerations_at(angle, rate),
            Motion::Skids(direction) => Accelerations {
                theta: zero,
                slip: self.skidding(*direction).slip_acceleration(),
            },
            Motion::Rests => Accelerations {
                theta: zero,
                slip: zero,
            },
            Motion::Glides => {
                gliding::accelerations(h, self.body.pull(), Loads::of(rate * rate), angle)
            }
            Motion::Flies(_) => Accelerations {
                theta: zero,
                slip: -(h * angle.sin * rate * rate) - self.body.pull(),
            },
        };
        Point {
            theta: rate,
            rate: accelerations.theta,
            slip: accelerations.slip,
            x: slip - rate,
        }
    }

    /// The gap of a flight after a time, and its rate.
    pub(super) fn gap(&self, flight: &FlightStart<T>, elapsed: T) -> (T, T) {
        let FlightStart {
            point: from,
            gap_rate: rise,
            lifts_off,
        } = *flight;
        let Heavy { h, .. } = self.body;
        // The mirror image that turns forwards has the same gap.
        let Angle { sin, cos } = from.theta.angle();
        let rate = from.rate.abs();
        let sin = if from.rate.value() < 0.0 { -sin } else { sin };
        let turned = rate * elapsed;
        let phi = turned.value();
        let TruncatedSeries {
            sine,
            versine,
            odd,
            even,
        } = TruncatedSeries::new(phi);
        let [sine_of, versine_of, odd_of, even_of] = [
            turned.map(sine, 1.0 - versine),
            turned.map(versine, sine),
            turned.map(odd, versine),
            turned.map(even, odd),
        ];
        if phi <= 1.0 {
            // Without the difference of h cos θ θ′² and 1, which vanishes at a lift-off along with
            // its derivatives.
            let opening = if lifts_off {
                T::constant(0.0)
            } else {
                h * cos * rate * rate - T::constant(1.0)
            };
            let gap =
                elapsed * (rise + opening * elapsed * 0.5) - h * (cos * even_of + sin * odd_of);
            (
                gap,
                rise + opening * elapsed - h * rate * (cos * odd_of + sin * versine_of),
            )
        } else {
            let gap = elapsed * (rise - elapsed * 0.5) + h * (cos * versine_of - sin * odd_of);
            (
                gap,
                rise - elapsed + h * rate * (cos * sine_of - sin * versine_of),
            )
        }
    }
}

impl Plane<Dual> {
    /// The state after a time that is the same for all motions.
    pub(super) fn evolve(
        &self,
        motion: &Motion<Dual>,
        from: &Point<Dual>,
        elapsed: f64,
    ) -> Derivative<Point<Dual>> {
        let last = self.evolve_to(motion, from, &[elapsed]).pop();
        last.unwrap_or(Err(NoDerivative::Singular))
    }

    /// The states after times that are the same for all motions, and do not decrease.
    pub(super) fn evolve_to(
        &self,
        motion: &Motion<Dual>,
        from: &Point<Dual>,
        times: &[f64],
    ) -> Vec<Derivative<Point<Dual>>> {
        match motion {
            Motion::Rolls(rotation) => self
                .in_steps(*rotation, from, times, |place, rotation| {
                    roll_series(&self.rolling(rotation), place)
                })
                .map(|place| {
                    let PhasePoint { theta, rate } = place?;
                    Ok(Point {
                        theta,
                        rate,
                        slip: Dual::constant(0.0),
                        x: from.x - (theta - from.theta),
                    })
                })
                .collect(),
            Motion::Slides(direction, rotation) => {
                self.slide_to(*direction, *rotation, from, times)
            }
            Motion::Skids(direction) => {
                let law = self.skidding(*direction);
                let after = |elapsed: &f64| {
                    let gained = law.slip_acceleration() * *elapsed;
                    Ok(Point {
                        slip: from.slip + gained,
                        x: from.x + (from.slip + gained * 0.5) * *elapsed,
                        ..*from
                    })
                };
                times.iter().map(after).collect()
            }
            Motion::Rests => times.iter().map(|_| Ok(*from)).collect(),
            Motion::Glides => times
                .iter()
                .map(|elapsed| self.glide(from, *elapsed))
                .collect(),
            Motion::Flies(_) => times
                .iter()
                .map(|elapsed| Ok(self.fly(from, *elapsed)))
                .collect(),
        }
    }

    fn slide_to(
        &self,
        direction: SlipDirection,
        rotation: Option<RotationDirection>,
        from: &Point<Dual>,
        times: &[f64],
    ) -> Vec<Derivative<Point<Dual>>> {
        let series = |place, rotation| {
            let law = self.sliding(direction, rotation);
            let series = SlideSeries::new(&law, place, from.slip);
            [series.theta, series.theta_rate]
        };
        // The first integrals have no couple.
        let law = self.sliding(direction, None);
        let coefficient = |Angle { sin, cos }: Angle<Dual>| law.slip_coefficient(sin, cos);
        let start = from.theta.angle();
        let path = law.path(
            ContactMotion {
                theta_rate: from.rate,
                slip: from.slip,
                x: from.x,
            },
            start,
        );
        self.in_steps(rotation, from, times, series)
            .zip(times)
            .map(|(place, elapsed)| {
                let PhasePoint { theta, rate } = place?;
                let (end, time) = (theta.angle(), Dual::constant(*elapsed));
                let slip = from.slip - from.rate * coefficient(start) + rate * coefficient(end)
                    - law.mean_slip_loss() * time;
                Ok(Point {
                    theta,
                    rate,
                    slip,
                    x: path.x(time, end),
                })
            })
            .collect()
    }

    fn fly(&self, from: &Point<Dual>, elapsed: f64) -> Point<Dual> {
        let Heavy { h, .. } = self.body;
        let (start, theta) = (from.theta.angle(), from.theta + from.rate * elapsed);
        let Angle { sin, cos } = theta.angle();
        let vx = from.slip - (h * start.cos + 1.0) * from.rate;
        let pulled = self.body.pull() * elapsed;
        let slip = vx - pulled + (h * cos + 1.0) * from.rate;
        let x = from.x - h * start.sin + (vx - pulled * 0.5) * elapsed + h * sin;
        Point {
            theta,
            rate: from.rate,
            slip,
            x,
        }
    }

    /// The free fall of the particle of a massless hoop.
    fn glide(&self, from: &Point<Dual>, elapsed: f64) -> Derivative<Point<Dual>> {
        let h = self.body.h;
        let Angle { sin, cos } = from.theta.angle();
        let rise = -(h * sin * from.rate);
        let cosine = cos + (rise - 0.5 * elapsed) * elapsed / h;
        let turns = libm::floor(from.theta.value() / core::f64::consts::PI) * core::f64::consts::PI;
        let side = if sin.value() < 0.0 { -1.0 } else { 1.0 };
        let root = ((1.0 - cosine.value()) * (1.0 + cosine.value())).sqrt();
        if root == 0.0 || root.is_nan() {
            return Err(NoDerivative::Singular);
        }
        // The angle on the side of the vertical on which the particle is.
        let angle = libm::acos(cosine.value().clamp(-1.0, 1.0));
        let half_turn = core::f64::consts::PI;
        let theta = if side > 0.0 {
            turns + angle
        } else {
            turns + half_turn - angle
        };
        let theta = cosine.map(theta, -side / root);
        let sine = theta.angle().sin;
        let rate = (-rise + elapsed) / (h * sine);
        let drift = from.slip - from.rate * (h * cos + 1.0);
        let pulled = self.body.pull() * elapsed;
        let slip = drift - pulled + rate * (h * cosine + 1.0);
        let x = from.x - h * sin + (drift - pulled * 0.5) * elapsed + h * sine;
        Ok(Point {
            theta,
            rate,
            slip,
            x,
        })
    }

    /// Follows series of θ and θ′ to times that do not decrease.
    fn in_steps(
        &self,
        rotation: Option<RotationDirection>,
        from: &Point<Dual>,
        times: &[f64],
        series: impl Fn(PhasePoint<Dual>, Option<RotationDirection>) -> [Series<Dual>; 2],
    ) -> impl Iterator<Item = Derivative<PhasePoint<Dual>>> {
        let mut found = Vec::with_capacity(times.len());
        let mut place = PhasePoint {
            theta: from.theta,
            rate: from.rate,
        };
        let mut passed = 0.0;
        found.extend(
            times
                .iter()
                .take_while(|elapsed| **elapsed <= 0.0)
                .map(|_| Ok(place)),
        );
        let mut failed = NoDerivative::TooLong;
        let begins_to_resist = self.begins_to_resist();
        for _ in 0..MAX_STEPS {
            if found.len() == times.len() {
                break;
            }
            let rotation = if begins_to_resist {
                let sign = |rate: Dual| RotationDirection::of_sign(rate.value);
                sign(place.rate).or_else(|| sign(series(place, None)[1][1]))
            } else {
                rotation
            };
            let [theta, rate] = series(place, rotation);
            let mut reach = reach(&rate);
            if reach == 0.0 || reach.is_nan() {
                failed = NoDerivative::Singular;
                break;
            }
            let turns = begins_to_resist.then(|| turning_point(&rate, reach));
            let turns = turns.flatten();
            reach = turns.unwrap_or(reach);
            let at = |width| PhasePoint {
                theta: value(&theta, width),
                rate: value(&rate, width),
            };
            let within = times[found.len()..].iter().map(|elapsed| elapsed - passed);
            found.extend(
                within
                    .take_while(|width| *width <= reach)
                    .map(|width| Ok(at(width))),
            );
            place = at(reach);
            if turns.is_some() {
                place.rate = place.rate.at(0.0);
            }
            passed += reach;
        }
        found.resize(times.len(), Err(failed));
        found.into_iter()
    }

    /// Whether χ = 0, and motions are differentiated by it: to first order the couple then acts
    /// along the motion that it has not yet changed, whose rotation may reverse within a phase.
    pub(super) fn begins_to_resist(&self) -> bool {
        let chi = self.friction.rolling_resistance;
        chi.value == 0.0 && !chi.vanishes()
    }
}

/// Where θ′ reverses within a step.
fn turning_point(rate: &Series<Dual>, width: f64) -> Option<f64> {
    let rate = rate.map(|c| c.value);
    let (first, last) = (rate[0], value(&rate, width));
    (first * last < 0.0).then(|| root(&rate, 0.0, first.signum(), width))
}

/// The Taylor series of rolling about an angle and a rate: those of θ and θ′.
fn roll_series<T: Number>(
    law: &ResistedRollingLaw<T>,
    PhasePoint { theta, rate }: PhasePoint<T>,
) -> [Series<T>; 2] {
    let zero = [T::constant(0.0); DEGREE + 1];
    let (mut angle, mut spin) = (zero, zero);
    let (mut sin, mut cos, mut u, mut increment) = (zero, zero, zero, zero);
    let (mut denominator, mut acceleration) = (zero, zero);
    let offset = law.rolling.offset;
    (angle[0], spin[0]) = (theta, rate);
    let start = theta.angle();
    (sin[0], cos[0]) = (start.sin, start.cos);
    let mut order = 0.0;
    for n in 0..=DEGREE {
        if n > 0 {
            spin[n] = acceleration[n - 1] / order;
            angle[n] = spin[n - 1] / order;
            increment[n] = angle[n] * order;
            let [forth, back] = convolve([(&increment, &cos), (&increment, &sin)], n);
            (sin[n], cos[n]) = (forth / order, -back / order);
        }
        let [square] = convolve([(&spin, &spin)], n);
        u[n] = square;
        let [sin_u, cos_u] = convolve([(&sin, &u), (&cos, &u)], n);
        denominator[n] = if n == 0 {
            law.denominator_of(start)
        } else {
            offset * (cos[n] * 2.0 - law.resistance * sin[n])
        };
        let one = if n == 0 { 1.0 } else { 0.0 };
        let mut remainder = law.driving_moment(one, cos[n], sin[n] + sin_u, cos_u);
        for j in 1..=n {
            remainder = remainder - denominator[j] * acceleration[n - j];
        }
        acceleration[n] = remainder / denominator[0];
        order += 1.0;
    }
    [angle, spin]
}

/// The step on which a series and its derivatives converge to rounding, by the rule of
/// [`SlideSeries::reach`].
fn reach(rate: &Series<Dual>) -> f64 {
    let all = (0..=WIDTH)
        .map(|k| -> Series { rate.map(|c| if k == WIDTH { c.value } else { c.parts[k] }) });
    all.map(|series| {
        if !series[DEGREE].is_finite() {
            return 0.0;
        }
        let of = |order: usize| {
            // What is zero at first grows with the first coefficients that are not.
            let by = |from: usize| {
                let ratio = TRUNCATION_TOLERANCE * (series[from] / series[order]).abs();
                let reach = libm::pow(ratio, 1.0 / (order - from) as f64);
                if from == 0 { reach } else { reach.min(1.0) }
            };
            if series[order] == 0.0 {
                MAX_STEP
            } else {
                (0..LEADING).map(by).fold(0.0, f64::max)
            }
        };
        of(DEGREE - 1).min(of(DEGREE))
    })
    .fold(MAX_STEP, f64::min)
}
