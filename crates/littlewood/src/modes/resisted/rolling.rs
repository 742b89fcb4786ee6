//! A phase of rolling that rolling resistance slows down: Taylor steps, each searched for events.

use core::f64::consts::{PI, TAU};

use crate::math::number::Number;
use crate::math::panel::Rule;
use crate::math::series::{DEGREE, Series, crossing, root, value};
use crate::math::trig::{Angle, WholeTurns, less_a_turn, split_turns, with_turns};
use crate::mechanics::{Accelerations, Clearance, ResistedRollingLaw, RollingLaw};
use crate::model::{Heavy, Hoop, MAX_TIME, Mode, RotationDirection, SlipDirection, State};
use crate::modes::sliding::{MIN_RELATIVE_STEP, max_step};
use crate::modes::{
    Instant, Margin, PhasePoint, Recurrence, RollingLimit, Sample, Undecided, couple_of_turning,
};

use super::leap::{
    LEAP_COST_IN_STEPS, LeapBounds, MIN_ROLLING_LEAP_TURNS, Turn, TurnLeap, TurnMap,
};
use super::series::RollingSeries;

/// By which part of the distance between two turns the periodic rotation is enclosed from the other
/// side.
const ENCLOSURE: f64 = 1e-3;

/// Largest number of steps of a turn.
const MAX_STEPS_PER_TURN: usize = 2_000;

/// The limits of a phase of rolling.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ResistedBudget {
    pub(crate) time_left: Option<f64>,
    pub(crate) steps: usize,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ResistedEnd {
    /// θ′ = 0.
    TurningPoint(State),
    /// |F| = μs N.
    Limit { state: State, limit: RollingLimit },
    /// The time limit.
    TimeLimit(State),
    /// The limit of steps.
    StepLimit(State),
    /// The time scale falls below double precision.
    Unresolved { state: State, undecided: Undecided },
    /// No end.
    Endless(Recurrence),
}

/// A phase of rolling in one direction with rolling resistance; Taylor polynomials give the state
/// at any time.
#[derive(Clone, Debug)]
pub struct ResistedRolling {
    law: ResistedRollingLaw,
    mu_s: f64,
    direction: RotationDirection,
    /// The start without its whole turns.
    start: State,
    turns: WholeTurns,
    steps: Vec<Step>,
    leap: Option<TurnLeap>,
    cycle: Option<Cycle>,
}

/// The last turn of a rotation that goes on for ever: all later ones repeat it, but for rounding.
#[derive(Clone, Copy, Debug)]
struct Cycle {
    from: f64,
    period: f64,
}

#[derive(Clone, Copy, Debug)]
struct Step {
    /// Time since the start of the phase, and whole turns to be added to θ.
    begin: f64,
    turned: f64,
    theta: Series,
    theta_rate: Series,
}

impl Step {
    fn at(&self, elapsed: f64) -> RollingPoint {
        let within = elapsed - self.begin;
        RollingPoint {
            elapsed,
            turned: self.turned,
            place: PhasePoint {
                theta: value(&self.theta, within),
                rate: value(&self.theta_rate, within),
            },
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct RollingPoint {
    elapsed: f64,
    /// Whole turns to be added to θ, which would lose digits with them.
    turned: f64,
    place: PhasePoint,
}

#[derive(Clone, Copy, Debug)]
enum Event {
    TurningPoint,
    Limit(RollingLimit),
}

/// What a step leads to.
enum Advance {
    /// Its end; the last one is that at the time limit.
    To {
        next: RollingPoint,
        is_last: bool,
    },
    Event(RollingPoint, Event),
    /// The series converge on less than the last digit of the time.
    Unresolved(Undecided),
}

/// The end of a whole turn from the start.
#[derive(Clone, Copy, Debug)]
struct TurnEnd {
    elapsed: f64,
    /// θ′².
    u: f64,
}

/// The turns of a rotation so far.
struct Turns {
    count: f64,
    last: TurnEnd,
    /// Steps up to the last.
    steps: usize,
    /// Whether no event ever comes.
    go_on: bool,
    /// The number of turns before the next attempt to pass many at once.
    next_attempt: f64,
}

impl Turns {
    fn at(start: &RollingPoint) -> Self {
        Self {
            count: 0.0,
            last: TurnEnd {
                elapsed: 0.0,
                u: start.place.rate * start.place.rate,
            },
            steps: 0,
            go_on: false,
            next_attempt: 1.0,
        }
    }
}

impl ResistedRolling {
    /// Integrates the phase to its end, or to a limit.
    pub(crate) fn run(
        hoop: &Hoop,
        body: &Heavy,
        start: State,
        direction: RotationDirection,
        budget: ResistedBudget,
    ) -> (Self, ResistedEnd) {
        let resistance = direction.sign() * hoop.rolling_resistance();
        let (theta, turns) = split_turns(start.theta);
        let mut rolling = Self {
            law: ResistedRollingLaw::of_body(body, resistance),
            mu_s: hoop.mu_s(),
            direction,
            start: State {
                theta,
                slip: 0.0,
                ..start
            },
            turns,
            steps: Vec::new(),
            leap: None,
            cycle: None,
        };
        let end = rolling.integrate(budget);
        (rolling, end)
    }

    /// Direction of rotation.
    pub const fn direction(&self) -> RotationDirection {
        self.direction
    }

    /// Number of Taylor steps of the phase. Many turns may be passed at once.
    pub fn steps(&self) -> usize {
        self.steps.len()
    }

    /// The steps, and those that a leap is worth.
    pub(crate) fn work(&self) -> usize {
        let leaps = usize::from(self.leap.is_some());
        self.steps.len() + LEAP_COST_IN_STEPS * leaps
    }

    fn first_point(&self) -> RollingPoint {
        RollingPoint {
            elapsed: 0.0,
            turned: 0.0,
            place: PhasePoint {
                theta: self.start.theta,
                rate: self.start.theta_rate,
            },
        }
    }

    fn integrate(&mut self, budget: ResistedBudget) -> ResistedEnd {
        if self.law.rolling.offset == 0.0
            && let Some(recurrence) = self.endless_disc()
        {
            return ResistedEnd::Endless(recurrence);
        }
        let mut here = self.first_point();
        let mut turns = Turns::at(&here);
        loop {
            if self.steps.len() >= budget.steps
                || self.leap.as_ref().is_some_and(TurnLeap::is_limited)
            {
                return ResistedEnd::StepLimit(self.state_from(here));
            }
            let time_left = budget
                .time_left
                .map_or(f64::INFINITY, |time_left| time_left - here.elapsed);
            here = match self.advance(here, time_left) {
                Advance::To {
                    next,
                    is_last: false,
                } => next,
                Advance::To { next, .. } => return ResistedEnd::TimeLimit(self.state_from(next)),
                // A disc that all but keeps its rate.
                Advance::Event(point, _) if point.elapsed > MAX_TIME => {
                    return ResistedEnd::StepLimit(self.state_from(here));
                }
                Advance::Event(point, event) => return self.end_at(point, event),
                Advance::Unresolved(undecided) => {
                    let state = self.state_from(here);
                    return ResistedEnd::Unresolved { state, undecided };
                }
            };
            if let Some(turn) = self.turn_end(here, turns.count + 1.0) {
                if let Some(recurrence) = self.recurrence(&mut turns, turn, budget.time_left) {
                    return ResistedEnd::Endless(recurrence);
                }
                here = self.leap(&mut turns, budget.time_left).unwrap_or(here);
            }
        }
    }

    /// What recurs after a turn that ends here, if it repeats the one before, but for rounding.
    fn recurrence(
        &mut self,
        turns: &mut Turns,
        turn: TurnEnd,
        time_left: Option<f64>,
    ) -> Option<Recurrence> {
        let last = turns.last;
        if turns.count == 0.0 {
            // With a time limit all states up to it are required.
            turns.go_on = time_left.is_none() && self.goes_on(last.u, turn.u);
        }
        let rounding = f64::EPSILON * turn.u * (self.steps.len() - turns.steps) as f64;
        (turns.count, turns.last, turns.steps) = (turns.count + 1.0, turn, self.steps.len());
        if !turns.go_on || (turn.u - last.u).abs() > rounding {
            return None;
        }
        self.cycle = Some(Cycle {
            from: last.elapsed,
            period: turn.elapsed - last.elapsed,
        });
        // From its own start a turn does not round the time of all turns before.
        let period = self
            .turn_from(turn.u)
            .map_or(turn.elapsed - last.elapsed, |turn| turn.elapsed);
        Some(Recurrence::Rotation { period })
    }

    /// Passes many turns from the end of one, if no event comes in them; returns the point behind.
    fn leap(&mut self, turns: &mut Turns, time_left: Option<f64>) -> Option<RollingPoint> {
        let heading = self.direction.sign();
        let TurnEnd { elapsed, u } = turns.last;
        let time_left = time_left.map_or(f64::INFINITY, |time_left| time_left - elapsed);
        if self.leap.is_some() || turns.count < turns.next_attempt {
            return None;
        }
        turns.next_attempt = 2.0 * turns.count;
        let first = self.turn_of(u)?;
        if time_left < MIN_ROLLING_LEAP_TURNS * first.elapsed {
            return None;
        }
        let RollingLaw { mass, tilt, .. } = self.law.rolling;
        // What gravity gives, and resistance takes, in a turn.
        let work = heading * TAU * mass * tilt - self.law.resistance.abs() * first.press;
        let inertia = self.law.rolling.denominator_of(self.start.theta.angle());
        let map = TurnMap {
            log_contraction: self.log_contraction()?,
            u,
            gain: 2.0 * work / inertia,
        };
        let bounds = LeapBounds {
            time_left,
            turns: if turns.go_on {
                map.turns_to_repeat()
            } else {
                f64::INFINITY
            },
            is_free: |n| turns.go_on || self.turn_from(map.after(n)).is_some(),
        };
        let time = |u| self.turn_of(u).map_or(f64::NAN, |turn| turn.elapsed);
        let mut leap = TurnLeap::new(map, first, bounds, time)?;
        if !leap.duration().is_finite() {
            return None;
        }
        let begun = turns.count;
        let point = RollingPoint {
            elapsed: elapsed + leap.duration(),
            turned: heading * (begun + leap.count),
            place: self.section_place(&leap, leap.count),
        };
        turns.count += leap.count;
        turns.last = TurnEnd {
            elapsed: point.elapsed,
            u: map.after(leap.count),
        };
        (leap.begin, leap.turned) = (elapsed, begun);
        self.leap = Some(leap);
        Some(point)
    }

    fn section_place(&self, leap: &TurnLeap, n: f64) -> PhasePoint {
        PhasePoint {
            theta: self.start.theta,
            rate: self.direction.sign() * leap.map.after(n).sqrt(),
        }
    }

    /// The turn from the angle of the start, whatever ends it.
    fn turn_of(&self, u: f64) -> Option<Turn> {
        let (rule, heading) = (Rule::get(), self.direction.sign());
        let end = self.start.theta + heading * TAU;
        let mut place = PhasePoint {
            theta: self.start.theta,
            rate: heading * u.sqrt(),
        };
        let inertia = self.law.denominator_of(self.start.theta.angle());
        let mut turn = Turn {
            elapsed: 0.0,
            press: 0.0,
            reserve: u,
        };
        for _ in 0..MAX_STEPS_PER_TURN {
            let mut series = RollingSeries::new(&self.law, place, DEGREE);
            let mut reach = series.convergence_radius(MAX_TIME);
            let mut next = series.point(reach);
            let turns_back = heading * next.rate <= 0.0;
            if turns_back {
                // Perhaps behind the end of the turn: next to no offset the series converge for long.
                reach = crossing(&series.theta_rate.map(|c| heading * c), reach)?;
                next = series.point(reach);
            }
            let is_last = heading * (next.theta - end) >= 0.0;
            if next.rate.is_nan() || turns_back && !is_last {
                return None;
            }
            let width = if is_last {
                root(&series.theta, end, -heading, reach)
            } else {
                reach
            };
            let press = rule.nodes.map(|x| {
                let at = 0.5 * width * (1.0 + x);
                let rate = value(&series.theta_rate, at);
                let reserve = rate * rate * value(&series.denominator, at) / inertia;
                turn.reserve = turn.reserve.min(reserve);
                value(&series.normal, at) * rate.abs()
            });
            turn.press += 0.5 * width * rule.integral(&press);
            turn.elapsed += width;
            if is_last {
                return Some(turn);
            }
            place = next;
        }
        None
    }

    /// The point after a time within a leap.
    fn point_in_leap(&self, leap: &TurnLeap, elapsed: f64) -> RollingPoint {
        let n = leap.turn_at(elapsed - leap.begin);
        let (mut place, mut left) = (
            self.section_place(leap, n),
            elapsed - leap.begin - leap.time(n),
        );
        for _ in 0..MAX_STEPS_PER_TURN {
            let mut series = RollingSeries::new(&self.law, place, DEGREE);
            let width = series.convergence_radius(f64::INFINITY).min(left);
            place = series.point(width);
            left -= width;
            if left <= 0.0 {
                break;
            }
        }
        RollingPoint {
            elapsed,
            turned: self.direction.sign() * (leap.turned + n),
            place,
        }
    }

    /// One Taylor step from a point, of at most this time.
    fn advance(&mut self, here: RollingPoint, time_left: f64) -> Advance {
        let (series, reach) = self.series(here);
        let resolution = MIN_RELATIVE_STEP * (self.start.time + here.elapsed).abs().max(1.0);
        if reach <= resolution {
            return Advance::Unresolved(Undecided::Rounding {
                margin: Margin::TimeScale,
                value: reach,
                bound: resolution,
            });
        }
        let step = Step {
            begin: here.elapsed,
            turned: here.turned,
            theta: series.theta,
            theta_rate: series.theta_rate,
        };
        let is_first = self.steps.is_empty();
        self.steps.push(step);
        let is_last = reach >= time_left;
        let width = if is_last { time_left } else { reach };
        if let Some((at, event)) = self.first_event(&series, is_first, width) {
            return Advance::Event(step.at(here.elapsed + at), event);
        }
        let mut next = RollingPoint {
            elapsed: here.elapsed + width,
            turned: here.turned,
            place: series.point(width),
        };
        if self.direction.sign() * next.place.theta > PI {
            next.place.theta = less_a_turn(next.place.theta);
            next.turned += self.direction.sign();
        }
        Advance::To { next, is_last }
    }

    /// The series about a point, and the time on which they converge.
    fn series(&self, here: RollingPoint) -> (RollingSeries, f64) {
        let mut series = RollingSeries::new(&self.law, here.place, DEGREE);
        if self.law.rolling.offset == 0.0 {
            // θ″ is constant and the series finite, so that one step leads to θ′ = 0.
            let [rate, acceleration] = [series.theta_rate[0], series.theta_rate[1]];
            return (series, 1.5 * (rate / acceleration).abs());
        }
        let reach = series.convergence_radius(max_step(self.steps.len()));
        (series, reach)
    }

    /// The first of the events within a step, if any.
    fn first_event(
        &self,
        series: &RollingSeries,
        is_first: bool,
        width: f64,
    ) -> Option<(f64, Event)> {
        let slip = |direction: SlipDirection| {
            let margin = series.margin(self.mu_s, direction.sign());
            (margin, Event::Limit(RollingLimit::Friction(direction)))
        };
        // Of two at once the first counts, in the frame of the motion.
        let [back, forth] = match self.direction {
            RotationDirection::Positive => SlipDirection::ALL,
            RotationDirection::Negative => SlipDirection::ALL.map(SlipDirection::reversed),
        }
        .map(slip);
        // Otherwise friction gives way before N vanishes.
        let unloads = self.law.is_massless();
        let unloaded = unloads.then_some((series.normal, Event::Limit(RollingLimit::NormalForce)));
        let ahead = series.theta_rate.map(|c| self.direction.sign() * c);
        let crossings = [back, forth, (ahead, Event::TurningPoint)]
            .into_iter()
            .chain(unloaded)
            .filter_map(|(mut margin, event)| {
                if is_first {
                    // Rolling begins where friction holds, and θ′ does not vanish: on a limit, but
                    // for rounding, just after.
                    let vanishing = margin.iter_mut().take_while(|c| **c <= 0.0);
                    vanishing.for_each(|c| *c = 0.0);
                }
                crossing(&margin, width).map(|at| (at, event))
            });
        crossings.min_by(|a, b| a.0.total_cmp(&b.0))
    }

    fn end_at(&self, point: RollingPoint, event: Event) -> ResistedEnd {
        let state = self.state_from(point);
        match event {
            Event::TurningPoint => ResistedEnd::TurningPoint(State {
                theta_rate: 0.0,
                ..state
            }),
            Event::Limit(limit) => ResistedEnd::Limit { state, limit },
        }
    }

    /// The recurrence of a disc that does not slow down: its θ″ and its forces are constant.
    fn endless_disc(&mut self) -> Option<Recurrence> {
        let here = self.first_point();
        let (series, _) = self.series(here);
        let acceleration = series.theta_rate[1];
        if self.direction.sign() * acceleration < 0.0 {
            return None;
        }
        self.steps.push(Step {
            begin: 0.0,
            turned: 0.0,
            theta: series.theta,
            theta_rate: series.theta_rate,
        });
        Some(if acceleration == 0.0 {
            Recurrence::Rotation {
                period: TAU / self.start.theta_rate.abs(),
            }
        } else {
            Recurrence::Downhill {
                acceleration: -acceleration,
            }
        })
    }

    /// The end of a whole turn, if the last step, which leads to `here`, passes it.
    fn turn_end(&self, here: RollingPoint, count: f64) -> Option<TurnEnd> {
        let (last, heading) = (self.steps.last()?, self.direction.sign());
        let end = |turned: f64| with_turns(self.start.theta, heading * count - turned);
        if heading * (here.place.theta - end(here.turned)) < 0.0 {
            return None;
        }
        let end = end(last.turned);
        let at = root(&last.theta, end, -heading, here.elapsed - last.begin);
        let rate = value(&last.theta_rate, at);
        Some(TurnEnd {
            elapsed: last.begin + at,
            u: rate * rate,
        })
    }

    /// Whether the rotation goes on for ever, from u at the beginning and at the end of its first
    /// turn. Turns are one linear family u ↦ λ u + const with λ < 1, and margins are linear in u at
    /// each angle. So it does if a turn from the other side of the periodic rotation, which returns
    /// towards it, is without an event, too: each later turn lies between the two.
    fn goes_on(&self, first: f64, second: f64) -> bool {
        let Some(lambda) = self.log_contraction().map(libm::exp) else {
            return false;
        };
        let periodic = second + (second - first) * lambda / (1.0 - lambda);
        // What rounding of the turns leaves open of the periodic rotation.
        let rounding = f64::EPSILON * periodic * self.steps.len() as f64 / (1.0 - lambda);
        let distance = ENCLOSURE * (periodic - first).abs() + 16.0 * rounding;
        let beyond = periodic + distance.copysign(periodic - first);
        let returns = |end: TurnEnd| (end.u - beyond) * (first - beyond) > 0.0;
        beyond > 0.0 && self.turn_from(beyond).is_some_and(returns)
    }

    /// log λ, by which a turn shrinks differences of u; none where Dχ is not positive at all angles.
    fn log_contraction(&self) -> Option<f64> {
        let rolling = &self.law.rolling;
        let (mean, chi) = (rolling.mean_denominator(), self.law.resistance.abs());
        let varying = rolling.offset * rolling.offset * (4.0 + chi * chi);
        let square = mean * mean - varying;
        // A/Δ − 1 without cancellation.
        let rate = varying / (square.sqrt() * (mean + square.sqrt()));
        (square > 0.0).then_some(-2.0 * TAU * chi / (4.0 + chi * chi) * rate)
    }

    /// The end of a turn from the angle of the start; none if an event ends it before.
    fn turn_from(&self, u: f64) -> Option<TurnEnd> {
        let mut turn = Self {
            start: State {
                theta_rate: self.direction.sign() * u.sqrt(),
                ..self.start
            },
            steps: Vec::new(),
            leap: None,
            ..*self
        };
        let mut here = turn.first_point();
        while let Advance::To { next, .. } = turn.advance(here, f64::INFINITY) {
            here = next;
            if let Some(end) = turn.turn_end(here, 1.0) {
                return Some(end);
            }
        }
        None
    }

    /// State after the time `elapsed` since the phase began.
    pub fn state(&self, elapsed: f64) -> State {
        let (within, turns) = match self.cycle {
            Some(Cycle { from, period }) if elapsed > from => {
                // Exact, so that the state is on the orbit however many periods have passed.
                let rest = libm::fmod(elapsed - from, period);
                (from + rest, ((elapsed - from - rest) / period).round())
            }
            Some(_) | None => (elapsed, 0.0),
        };
        let in_leap = self
            .leap
            .as_ref()
            .filter(|leap| leap.begin <= within && within < leap.begin + leap.duration());
        let after = self.steps.partition_point(|step| step.begin <= within);
        let mut point = match (in_leap, self.steps.get(after.saturating_sub(1))) {
            (Some(leap), _) => self.point_in_leap(leap, within),
            (None, Some(step)) => step.at(within),
            (None, None) => self.first_point(),
        };
        point.elapsed = elapsed;
        point.turned += turns * self.direction.sign();
        self.state_from(point)
    }

    fn state_from(
        &self,
        RollingPoint {
            elapsed,
            turned,
            place,
        }: RollingPoint,
    ) -> State {
        let theta = with_turns(place.theta, turned);
        State {
            time: self.start.time + elapsed,
            theta: self.turns.add_to(theta),
            theta_rate: place.rate,
            slip: 0.0,
            x: self.start.x - (theta - self.start.theta),
        }
    }

    pub(crate) fn sample(&self, hoop: &Hoop, state: State) -> Sample {
        let (angle, u) = (Angle::of(state.theta), state.theta_rate * state.theta_rate);
        let forces = self.law.forces(angle, u);
        let instant = Instant {
            mode: Mode::Rolling,
            direction: None,
            accelerations: Accelerations {
                theta: self.law.acceleration(angle, u),
                slip: 0.0,
            },
            forces,
            couple: couple_of_turning(self.law.resistance, forces.normal),
            clearance: Clearance::NONE,
        };
        instant.sample(hoop, state)
    }
}
