//! The derivatives of a motion, from phase to phase.

use core::f64::consts::TAU;

use crate::math::number::{Dual, Number, WIDTH};
use crate::mechanics::{
    BounceConditions, Bounces, Clearance, Contact, ContactMotion, ContactVelocities, Impact,
    RollingLaw, contact, energy_of,
};
use crate::model::{Body, Composition, Friction, Heavy, Mode, Quantity, Restitution, State};
use crate::modes::{PhaseSolution, Recurrence};
use crate::motion::trajectory::{Phase, Trajectory};
use crate::walk::{Cause, Outcome, Transition};

use super::event::{Event, GRAZING};
use super::flow::{FlightStart, Motion, PhaseInstant, Plane, Point};
use super::{Derivative, NoDerivative, period};

/// A state with the time since the start of the motion, in the units of the solvers.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instant {
    pub(super) elapsed: Dual,
    pub(super) point: Point<Dual>,
}

/// An instant of a phase, and the gap there.
#[derive(Clone, Copy, Debug)]
pub(super) struct InstantOfPhase {
    pub(super) at: Instant,
    pub(super) gap: Dual,
}

/// The start of a phase, and the rate at which the gap opens there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Begun {
    pub(super) at: Instant,
    pub(super) gap_rate: Dual,
}

/// The states before and after an event, and the work of its impacts.
#[derive(Clone, Copy, Debug)]
pub(super) struct EventJump {
    pub(super) before: Instant,
    pub(super) after: Instant,
    pub(super) work: Dual,
}

/// The derivatives of a motion with respect to some quantities, while its phases are passed.
pub(super) struct Tangents<'a> {
    /// At most [`WIDTH`].
    quantities: Vec<Quantity>,
    pub(super) motion: &'a Trajectory,
    pub(super) plane: Plane<Dual>,
    restitution: Option<Restitution<Dual>>,
    /// √cos α, the unit of velocity.
    pace: Dual,
    /// Time and x of the start.
    origin: [Dual; 2],
    now: Instant,
    /// Rate of the gap after the last impact or at the start.
    pub(super) gap_rate: Dual,
    pub(super) begun: Vec<Begun>,
    /// Time of the first jam without a motion before it: it ends no phase, and is not
    /// differentiated.
    jam: Option<f64>,
}

impl<'a> Tangents<'a> {
    pub(super) fn new(motion: &'a Trajectory, quantities: &[Quantity]) -> Self {
        let seed = |quantity: Quantity, value: f64| Dual {
            value,
            parts: core::array::from_fn(|k| {
                let is_this = quantities.get(k) == Some(&quantity);
                f64::from(u8::from(is_this))
            }),
        };
        let parameters = motion.hoop.parameters();
        let slope = seed(Quantity::Slope, parameters.slope);
        let body = Heavy::of(
            Composition {
                mass_ratio: seed(Quantity::MassRatio, parameters.mass_ratio),
                offset: seed(Quantity::Offset, parameters.offset),
                inertia: seed(Quantity::Inertia, parameters.inertia),
            },
            slope,
        );
        let pace = slope.angle().cos.sqrt();
        let start = motion.start;
        let point = Point {
            theta: seed(Quantity::Theta, motion.relative.theta),
            rate: seed(Quantity::ThetaRate, start.theta_rate) / pace,
            slip: seed(Quantity::Slip, start.slip) / pace,
            x: Dual::constant(0.0),
        };
        let rise = motion.phases.first().map_or(0.0, Phase::take_off_rate);
        Self {
            quantities: quantities.to_vec(),
            motion,
            plane: Plane {
                body,
                friction: Friction {
                    mu_s: seed(Quantity::MuS, parameters.mu_s),
                    mu_k: seed(Quantity::MuK, parameters.mu_k),
                    rolling_resistance: seed(
                        Quantity::RollingResistance,
                        parameters.rolling_resistance,
                    ),
                },
            },
            restitution: motion.hoop.restitution().map(|it| Restitution {
                coefficient: seed(Quantity::Restitution, it.coefficient()),
                law: it.law(),
            }),
            pace,
            origin: [seed(Quantity::Time, start.time), seed(Quantity::X, start.x)],
            now: Instant {
                elapsed: Dual::constant(0.0),
                point,
            },
            gap_rate: seed(Quantity::GapRate, rise) / pace,
            begun: Vec::new(),
            jam: motion
                .transitions
                .iter()
                .find(|it| it.from.is_none())
                .map(Transition::time),
        }
    }

    /// The parts of a number, or of several, for each quantity, if the motion does not differ on the
    /// two sides of its value.
    pub(super) fn by_quantity<D: Copy, P>(
        &self,
        derivative: Derivative<D>,
        part: impl Fn(D, usize) -> P,
    ) -> Vec<Derivative<P>> {
        let quantities = self.quantities.iter().enumerate();
        quantities
            .map(|(k, quantity)| {
                if self.one_sided(*quantity) {
                    Err(NoDerivative::OneSided)
                } else {
                    Ok(part(derivative?, k))
                }
            })
            .collect()
    }

    /// Derivatives of the end of the motion, for each quantity. No motion without rolling resistance
    /// that goes on for ever is the limit of those with it.
    pub(super) fn at_end<P>(&self, derivatives: Vec<Derivative<P>>) -> Vec<Derivative<P>> {
        let is_endless = matches!(
            self.motion.outcome,
            Outcome::RollsForever { .. }
                | Outcome::SlidesForever { .. }
                | Outcome::SlipsForever { .. }
                | Outcome::RepeatsForever { .. }
        );
        let begins = is_endless && self.motion.hoop.rolling_resistance() == 0.0;
        let all = derivatives.into_iter().zip(&self.quantities);
        all.map(|(derivative, quantity)| {
            if begins && *quantity == Quantity::RollingResistance {
                Err(NoDerivative::OneSided)
            } else {
                derivative
            }
        })
        .collect()
    }

    fn one_sided(&self, quantity: Quantity) -> bool {
        let flies = self.motion.phases.first().map(Phase::mode) == Some(Mode::Flight);
        // With inertia it is another body.
        let is_massless = matches!(self.motion.hoop.body(), Body::Massless(_));
        let resists = self.motion.hoop.rolling_resistance() > 0.0;
        (quantity == Quantity::Slip && self.motion.start.slip == 0.0 && !flies)
            || (quantity == Quantity::ThetaRate
                && self.motion.start.theta_rate == 0.0
                && resists
                && !flies)
            || (quantity == Quantity::GapRate && !flies)
            || (is_massless && [Quantity::MassRatio, Quantity::Inertia].contains(&quantity))
    }

    /// A time in the units of the results.
    pub(super) fn time(&self, at: &Instant) -> Dual {
        self.origin[0] + at.elapsed / self.pace
    }

    /// A difference of energies in the units of the results.
    pub(super) fn difference(&self, energy: Dual) -> Dual {
        energy * self.pace * self.pace
    }

    /// The energy in the units of the results.
    pub(super) fn energy(&self, at: &Point<Dual>, gap_rate: Dual) -> Dual {
        let Heavy { mass, tilt, .. } = self.plane.body;
        let energy = energy_of(
            &self.plane.body,
            ContactMotion {
                theta_rate: at.rate,
                slip: at.slip,
                x: at.x,
            },
            at.theta.angle(),
            Clearance {
                gap: Dual::constant(0.0),
                gap_rate,
            },
        );
        self.difference(energy + mass * tilt * self.origin[1])
    }

    /// The numbers of a state in the units of the results, in the order of [`State::COLUMNS`].
    pub(super) fn numbers(&self, at: &Instant) -> [Dual; 5] {
        [
            self.time(at),
            at.point.theta,
            at.point.rate * self.pace,
            at.point.slip * self.pace,
            self.origin[1] + at.point.x,
        ]
    }

    /// The derivative of a state in the units of the results.
    pub(super) fn state(&self, at: &Instant, k: usize) -> State {
        let [time, theta, theta_rate, slip, x] = self.numbers(at).map(|number| number.parts[k]);
        State {
            time,
            theta,
            theta_rate,
            slip,
            x,
        }
    }

    fn motion_of(&self, phase: &Phase) -> Motion<Dual> {
        match &phase.solution {
            PhaseSolution::Rolling(_) => Motion::Rolls(None),
            PhaseSolution::ResistedRolling(rolling) => Motion::Rolls(Some(rolling.direction())),
            PhaseSolution::Sliding(slide) => Motion::Slides(slide.direction(), slide.rotation()),
            PhaseSolution::Skidding(skid) => Motion::Skids(skid.direction()),
            PhaseSolution::Rest(_) => Motion::Rests,
            PhaseSolution::Gliding(_) => Motion::Glides,
            PhaseSolution::Flight(flight) => Motion::Flies(FlightStart {
                point: self.now.point,
                gap_rate: self.gap_rate.at(flight.take_off_rate()),
                lifts_off: flight.lifts_off(),
            }),
        }
    }

    /// The state at the start of a phase, with its derivatives, as exact as the phase has it.
    fn begin(&mut self, phase: &Phase) -> Derivative<()> {
        if self.jam.is_some_and(|time| phase.start().time >= time) {
            return Err(NoDerivative::Singular);
        }
        let known = Point::from(&phase.start);
        self.now.point = self.now.point.zip(known, Dual::at);
        self.now.elapsed = self.now.elapsed.at(phase.start.time);
        Ok(())
    }

    /// Moves a state to the instant at which a condition with these derivatives vanishes.
    fn to_event(&self, motion: &Motion<Dual>, at: &Point<Dual>, by: [f64; WIDTH]) -> Point<Dual> {
        let rates = self.plane.rates(motion, at);
        at.zip(rates, |number, rate| Dual {
            value: number.value,
            parts: core::array::from_fn(|k| number.parts[k] + rate.value * by[k]),
        })
    }

    /// The states of a phase after times that are the same for all motions, and do not decrease.
    fn propagate(
        &self,
        phase: &Phase,
        motion: &Motion<Dual>,
        times: &[f64],
    ) -> Vec<Derivative<Point<Dual>>> {
        let from = &self.now.point;
        let longest = times.last().copied().unwrap_or(0.0);
        // Resistance changes the motion from period to period.
        let repeats = !self.plane.begins_to_resist();
        let recurrence = repeats.then(|| self.recurrence(phase, longest)).flatten();
        let Some(period) = recurrence.and_then(|it| it.period()) else {
            return self.plane.evolve_to(motion, from, times);
        };
        let turn = if matches!(recurrence, Some(Recurrence::Rotation { .. })) {
            TAU.copysign(from.rate.value)
        } else {
            0.0
        };
        let periods_of = |time: &f64| (time / period.value).floor();
        let mut found = Vec::with_capacity(times.len());
        // After whole periods the state is that of a time which differs from motion to motion.
        for within in times.chunk_by(|a, b| periods_of(a) == periods_of(b)) {
            let periods = periods_of(&within[0]);
            let rest: Vec<f64> = within
                .iter()
                .map(|time| (time - periods * period.value).max(0.0))
                .collect();
            let later = period.parts.map(|part| -periods * part);
            let points = self.plane.evolve_to(motion, from, &rest).into_iter();
            found.extend(points.map(|point| {
                let moved = self.to_event(motion, &point?, later);
                Ok(Point {
                    theta: moved.theta + periods * turn,
                    x: moved.x - periods * turn,
                    ..moved
                })
            }));
        }
        found
    }

    /// Passes a phase and the event that ends it.
    pub(super) fn pass_phase(&mut self, phase: &Phase) -> Derivative<Option<EventJump>> {
        self.begin(phase)?;
        self.begun.push(Begun {
            at: self.now,
            gap_rate: self.gap_rate,
        });
        let (Some(end), Some(number)) = (phase.end, phase.ended_by) else {
            return Ok(None);
        };
        let motion = self.motion_of(phase);
        let transition = &self.motion.transitions[number];
        let jump = if transition.cause == Cause::Settle {
            self.settle(&motion, &end)?
        } else {
            self.pass_event(phase, &motion, &end, transition)?
        };
        self.now = jump.after;
        Ok(Some(jump))
    }

    /// Passes an event other than settling.
    fn pass_event(
        &mut self,
        phase: &Phase,
        motion: &Motion<Dual>,
        end: &State,
        transition: &Transition,
    ) -> Derivative<EventJump> {
        let elapsed = end.time - phase.start.time;
        // All motions at the time of the event: that of some comes earlier or later.
        let found = self.propagate(phase, motion, &[elapsed]).pop();
        let point = found
            .unwrap_or(Err(NoDerivative::Singular))?
            .zip(Point::from(end), Dual::at);
        if !(point.rate.value.is_finite() && point.slip.value.is_finite()) {
            return Err(NoDerivative::Singular);
        }
        let instant = PhaseInstant { point, elapsed };
        let event = Event::of(transition.cause, end)?;
        let later = self.delay(motion, event, &instant)?;
        let mut time = self.now.elapsed.at(end.time);
        for (part, later) in time.parts.iter_mut().zip(later) {
            *part += later;
        }
        let mut before = Instant {
            elapsed: time,
            point: self.to_event(motion, &point, later),
        };
        // At the event of each motion, whenever it comes.
        match event {
            Event::Rest => before.point.slip = Dual::constant(0.0),
            Event::TurningPoint => before.point.rate = Dual::constant(0.0),
            Event::Slip | Event::Unloaded | Event::LiftOff | Event::Landing => {}
        }
        if let Some(impact) = &transition.impact {
            let gap_rate = self.gap_rate_at(motion, &instant, later);
            return self.impact(
                before,
                gap_rate.at(impact.before.gap_rate / self.pace.value),
            );
        }
        self.gap_rate = Dual::constant(0.0);
        Ok(EventJump {
            before,
            after: before,
            work: Dual::constant(0.0),
        })
    }

    /// The impact of a landing at a gap rate.
    fn impact(&mut self, before: Instant, gap_rate: Dual) -> Derivative<EventJump> {
        let Some(restitution) = self.restitution else {
            return Err(NoDerivative::Singular);
        };
        let at = before.point;
        let contact = Contact::of(&self.plane.body, self.plane.friction, at.theta.angle());
        let velocities = ContactVelocities {
            theta_rate: at.rate,
            slip: at.slip,
            gap_rate,
        };
        Ok(self.jump(before, &contact.impact(velocities, restitution)))
    }

    /// The states about an impact, or about the sum of those by which a hoop settles.
    fn jump(&mut self, before: Instant, impact: &Impact<Dual>) -> EventJump {
        self.gap_rate = impact.after.gap_rate;
        let after = Instant {
            point: Point {
                rate: impact.after.theta_rate,
                slip: impact.after.slip,
                ..before.point
            },
            ..before
        };
        EventJump {
            before,
            after,
            work: -impact.lost(),
        }
    }

    /// The derivatives of the time of an event, from the state at its time.
    fn delay(
        &self,
        motion: &Motion<Dual>,
        event: Event,
        instant: &PhaseInstant<Dual>,
    ) -> Derivative<[f64; WIDTH]> {
        let condition = event.condition(&self.plane, motion, instant);
        let (rate, curvature) = self.rate_of(motion, event, instant);
        // To second order the condition falls below zero by as much: less than the rounding of what
        // it is made of is a graze.
        let depth = rate * rate / (2.0 * curvature);
        let rounding = GRAZING * event.size(&self.plane, motion, instant);
        if depth <= rounding || depth.is_nan() {
            return Err(NoDerivative::Grazing);
        }
        Ok(condition.parts.map(|part| -part / rate))
    }

    /// The rate of a condition along the motion, and the size of its second derivative.
    fn rate_of(
        &self,
        motion: &Motion<Dual>,
        event: Event,
        instant: &PhaseInstant<Dual>,
    ) -> (f64, f64) {
        let at = &instant.point;
        if let Motion::Flies(flight) = motion {
            let (_, slope) = self.plane.gap(flight, Dual::constant(instant.elapsed));
            let u = at.rate.value * at.rate.value;
            return (slope.value, 1.0 + self.plane.body.h.value * u);
        }
        // The rate is the gradient of the condition, over a point whose four numbers vary, times
        // the rates of these numbers.
        let variable = |number: Dual, place: usize| {
            let mut variable = Dual::constant(number.value);
            variable.parts[place] = 1.0;
            variable
        };
        let varied = PhaseInstant {
            point: Point {
                theta: variable(at.theta, 0),
                rate: variable(at.rate, 1),
                slip: variable(at.slip, 2),
                x: variable(at.x, 3),
            },
            elapsed: instant.elapsed,
        };
        let plane = self.plane.map(|number| Dual::constant(number.value));
        let gradient = event.condition(&plane, motion, &varied).parts;
        let rates = self.plane.rates(motion, at);
        let rates = [rates.theta, rates.rate, rates.slip, rates.x].map(Dual::value);
        let terms = gradient
            .into_iter()
            .zip(rates)
            .map(|(slope, rate)| slope * rate);
        let (sum, size) = terms.fold((0.0, 0.0), |(sum, size), term: f64| {
            (sum + term, size + term.abs())
        });
        (sum, size * (rates[0].abs() + rates[1].abs().sqrt()))
    }

    /// The rate of the gap at an event of a flight; zero in contact.
    fn gap_rate_at(
        &self,
        motion: &Motion<Dual>,
        instant: &PhaseInstant<Dual>,
        later: [f64; WIDTH],
    ) -> Dual {
        let Motion::Flies(flight) = motion else {
            return Dual::constant(0.0);
        };
        let at = &instant.point;
        let (_, mut rate) = self.plane.gap(flight, Dual::constant(instant.elapsed));
        let u = at.rate.value * at.rate.value;
        let fall = contact(1.0, self.plane.body.h.value, libm::cos(at.theta.value) * u);
        for (part, later) in rate.parts.iter_mut().zip(later) {
            *part -= fall * later;
        }
        rate
    }

    fn settle(&mut self, motion: &Motion<Dual>, end: &State) -> Derivative<EventJump> {
        let (Some(restitution), Motion::Flies(flight)) = (self.restitution, motion) else {
            return Err(NoDerivative::Singular);
        };
        let from = self.now.point;
        let conditions = BounceConditions {
            theta: from.theta,
            theta_rate: from.rate,
            friction: self.plane.friction,
            restitution,
            gravity: 1.0,
        };
        let start = ContactVelocities {
            theta_rate: from.rate,
            slip: from.slip,
            gap_rate: flight.gap_rate,
        };
        let sum = Bounces::of(&self.plane.body, conditions)
            .and_then(|bounces| bounces.sum(start, f64::INFINITY));
        let Ok(settling) = sum else {
            return Err(NoDerivative::Singular);
        };
        let elapsed = settling.duration;
        let point = self
            .plane
            .evolve(motion, &from, elapsed.value)?
            .zip(Point::from(end), Dual::at);
        let before = Instant {
            elapsed: (self.now.elapsed + elapsed).at(end.time),
            point: self.to_event(motion, &point, elapsed.parts),
        };
        Ok(self.jump(before, &settling.impact))
    }

    /// The states within a phase at times that are the same for all motions, in the units of the
    /// results, and do not decrease.
    fn at_times(
        &mut self,
        phase: &Phase,
        times: &[f64],
    ) -> Derivative<Vec<Derivative<InstantOfPhase>>> {
        self.begin(phase)?;
        let motion = self.motion_of(phase);
        let within: Vec<f64> = times
            .iter()
            .map(|elapsed| (elapsed - phase.start.time).max(0.0))
            .collect();
        let [start, _] = self.origin;
        let points = self.propagate(phase, &motion, &within).into_iter();
        let instants = points
            .zip(times.iter().zip(&within))
            .map(|(point, (elapsed, within))| {
                // A fixed time of the results is later or earlier in the time of the solvers, and since
                // the start of the phase.
                let fixed = (Dual::constant(start.value) - start) * self.pace
                    + self.pace / self.pace.value * *elapsed;
                let later = core::array::from_fn(|k| fixed.parts[k] - self.now.elapsed.parts[k]);
                let gap = match &motion {
                    Motion::Flies(flight) => {
                        let since = Dual {
                            value: *within,
                            parts: later,
                        };
                        self.plane.gap(flight, since).0
                    }
                    Motion::Rolls(_)
                    | Motion::Slides(..)
                    | Motion::Skids(_)
                    | Motion::Rests
                    | Motion::Glides => Dual::constant(0.0),
                };
                Ok(InstantOfPhase {
                    at: Instant {
                        elapsed: fixed,
                        point: self.to_event(&motion, &point?, later),
                    },
                    gap,
                })
            });
        Ok(instants.collect())
    }

    /// The states at times of the results that do not decrease, from the start.
    pub(super) fn instants(&mut self, times: &[f64]) -> Vec<Derivative<InstantOfPhase>> {
        let motion = self.motion;
        let mut found = Vec::with_capacity(times.len());
        for (number, phase) in motion.phases.iter().enumerate() {
            let next = motion.phases.get(number + 1);
            let next = next.map_or(f64::INFINITY, |next| next.start().time);
            let within = times[found.len()..].iter().take_while(|time| **time < next);
            let elapsed: Vec<f64> = within.map(|time| motion.origin.elapsed(*time)).collect();
            let count = found.len() + elapsed.len();
            match self.at_times(phase, &elapsed) {
                Ok(instants) => found.extend(instants),
                Err(reason) => found.resize(count, Err(reason)),
            }
            if count == times.len() {
                break;
            }
            if let Err(reason) = self.pass_phase(phase) {
                found.resize(times.len(), Err(reason));
            }
        }
        found.resize(times.len(), Err(NoDerivative::Singular));
        found
    }

    /// The derivatives of the outcome, after all phases with these events.
    pub(super) fn outcome(
        &mut self,
        passed: &[Option<EventJump>],
    ) -> Derivative<(Instant, Option<Recurrence<Dual>>)> {
        if self.jam.is_some() {
            return Err(NoDerivative::Singular);
        }
        let outcome = self.motion.outcome;
        let last = self.motion.phases.last();
        // The state of these outcomes is that of an event, unless a limit cut a phase.
        let is_cut = last.is_some_and(|phase| phase.end.is_some() && phase.ended_by.is_none());
        let at_event = || {
            if is_cut {
                Err(NoDerivative::TooLong)
            } else {
                Ok((self.now, None))
            }
        };
        match outcome {
            Outcome::TimeLimit { state } => match last {
                Some(phase) => {
                    let at = self.at_times(phase, &[state.time])?.pop();
                    Ok((at.unwrap_or(Err(NoDerivative::Singular))?.at, None))
                }
                None => Ok((self.now, None)),
            },
            Outcome::RollsForever { .. } => {
                let recurrence = last.and_then(|phase| self.recurrence(phase, f64::INFINITY));
                Ok((self.now, recurrence.map(|it| it.at_pace(self.pace))))
            }
            Outcome::RepeatsForever { since, .. } => {
                let events = passed.iter().flatten().map(|passed| passed.after);
                let first = events
                    .into_iter()
                    .find(|event| event.elapsed.value == since.time);
                first.map_or_else(at_event, |event| Ok((event, None)))
            }
            Outcome::SlidesForever { .. }
            | Outcome::Landing { .. }
            | Outcome::SlipsForever { .. }
            | Outcome::StaysInContact { .. }
            | Outcome::Rests { .. }
            | Outcome::TransitionLimit { .. }
            | Outcome::Inconsistent { .. }
            | Outcome::Ambiguous { .. }
            | Outcome::StepLimit { .. } => at_event(),
            Outcome::ParticleAtPlane { .. }
            | Outcome::ParticleAtBottom { .. }
            | Outcome::ParticleAtTop { .. }
            | Outcome::Singular { .. }
            | Outcome::Unresolved { .. } => Err(NoDerivative::Singular),
        }
    }

    /// The numbers of the recurrence of a phase of rolling, in the units of the solvers; none if
    /// its period is longer than `most`.
    fn recurrence(&self, phase: &Phase, most: f64) -> Option<Recurrence<Dual>> {
        let PhaseSolution::Rolling(rolling) = &phase.solution else {
            return None;
        };
        let law = RollingLaw::of_body(&self.plane.body);
        let from = &self.now.point;
        match rolling.orbit().recurrence() {
            Recurrence::Libration {
                period,
                theta_min,
                theta_max,
            } if period <= most => {
                let ends =
                    [theta_min, theta_max].map(|theta| period::turning_point(&law, from, theta));
                let period = period::of_libration(&law, ends).at(period);
                Some(Recurrence::Libration {
                    period,
                    theta_min: ends[0],
                    theta_max: ends[1],
                })
            }
            Recurrence::Rotation { period } if period <= most => Some(Recurrence::Rotation {
                period: period::of_rotation(&law, from).at(period),
            }),
            Recurrence::Libration { .. }
            | Recurrence::Rotation { .. }
            | Recurrence::Rest
            | Recurrence::Asymptotic { .. }
            | Recurrence::Downhill { .. } => None,
        }
    }
}
