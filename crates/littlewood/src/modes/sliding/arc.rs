//! A phase of sliding: Taylor steps, each searched for events, and leaps over whole turns.

use core::f64::consts::TAU;
use core::ops::ControlFlow;

use crate::ablation::{Part, is_on};
use crate::math::number::Number;
use crate::math::panel::Rule;
use crate::math::series::{DEGREE, Series, crossing, root, value};
use crate::math::trig::{Angle, WholeTurns, split_turns};
use crate::mechanics::{Clearance, ContactMotion, SlidePath, SlidingLaw};
use crate::model::{Heavy, Hoop, MAX_TIME, Mode, RotationDirection, SlipDirection, State};
use crate::modes::turn_times::MIN_LEAP_TURNS;
use crate::modes::{Instant, Margin, Recurrence, Sample, Undecided, couple_of_turning};

use super::leap::{LeapLimits, ProvedTurns, section_of};
use super::onset::Onset;
use super::series::{INITIAL_MAX_STEP, PhasePoint, SlideSeries};
use super::singular::{Approach, SingularEnd, SingularFate};

/// Least step relative to the time. A shorter step means a singularity of the equations.
pub(in crate::modes) const MIN_RELATIVE_STEP: f64 = 4.0 * f64::EPSILON;

/// Number of steps, a time of at most 1024, after which the maximum step doubles with each step.
const STEPS_BEFORE_DOUBLING: usize = 64;

/// Cost of an attempted leap, in steps.
const LEAP_COST_IN_STEPS: usize = 100;

/// Least distance from P = 0 for the leading-order terms, if the slide offers one: a few √ε, so
/// that distance and terms keep half of the digits.
const DISTANCE_FOR_EXPANSION: f64 = 1e-7;

/// Distance from the section below which an angle counts as on it; the leap then begins one turn
/// delta_time.
const SECTION_TOLERANCE: f64 = 1e-9;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Entry {
    /// With η′ ≠ 0.
    Moving,
    /// With η′ = 0 and this acceleration η″. It has the sign of the direction of slip, or vanishes,
    /// but for rounding, and the [`Onset`] decides: on the static limit with μs = μk, and without
    /// friction. The zero of η′ at the start is no event.
    FromRest { slip_acceleration: f64 },
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum SlidingEnd {
    /// η′ = 0.
    Rest(State),
    /// w = 0: the normal force vanishes.
    LiftOff(State),
    /// θ′ = 0, where rolling resistance changes its sign.
    TurningPoint(State),
    /// P = 0 with η′ ≠ 0 and unbounded N: sliding has no solution beyond.
    Singular(State),
    /// The time scale falls below double precision: away from P = 0, or next to P = 0 where
    /// rounding decides the outcome.
    Unresolved { state: State, undecided: Undecided },
    /// The limit of steps or of turns; with an estimate of the time until η′ = 0.
    StepLimit { state: State, time_left: f64 },
    /// The time limit.
    TimeLimit(State),
    /// No end: the slip does not decrease on average, and θ and θ′ repeat after a whole period
    /// without an event, or the hoop is balanced.
    Endless(Recurrence),
}

/// A phase of sliding; Taylor polynomials give the state at any time.
#[derive(Clone, Debug)]
pub struct Sliding {
    law: SlidingLaw,
    direction: SlipDirection,
    /// The start without its whole turns: with them, each step would round the angle to the last
    /// digit of all turns.
    start: State,
    /// Whole turns of the start, which restore its angle exactly.
    turns: WholeTurns,
    path: SlidePath,
    /// Whether w may fall below zero: a computed zero may be rounding.
    may_lift_off: bool,
    steps: Vec<TaylorStep>,
    leaps: Vec<TurnSkip>,
    attempts: usize,
    /// Time and angle of the turning points; recorded only while the slip does not decrease on
    /// average.
    turnings: Vec<(f64, f64)>,
    cycle: Option<Cycle>,
}

#[derive(Clone, Copy, Debug)]
struct Cycle {
    /// Start of a period that the steps cover.
    from: f64,
    period: f64,
    advance: f64,
}

/// A leap over turns, or periods, between two steps.
#[derive(Clone, Debug)]
struct TurnSkip {
    /// Time since the start of the phase.
    begin: f64,
    /// θ minus the angle of [`ProvedTurns`]: the whole turns before the leap.
    turned: f64,
    passed: ProvedTurns,
}

#[derive(Clone, Copy, Debug)]
struct TaylorStep {
    /// Time since the start of the phase.
    begin: f64,
    /// θ minus its series: whole turns.
    turned: f64,
    theta: Series,
    theta_rate: Series,
    slip: Series,
}

impl TaylorStep {
    fn new(from: &SlidePoint, series: &SlideSeries) -> Self {
        Self {
            begin: from.elapsed,
            turned: from.turned,
            theta: series.theta,
            theta_rate: series.theta_rate,
            slip: series.slip,
        }
    }

    /// Straight lines between two points; constants at the second if no time passes.
    fn straight(from: &SlidePoint, to: &SlidePoint, time: f64) -> Self {
        let line = |from: f64, to: f64| {
            let mut series: Series = [0.0; DEGREE + 1];
            if time > 0.0 {
                (series[0], series[1]) = (from, (to - from) / time);
            } else {
                series[0] = to;
            }
            series
        };
        Self {
            begin: from.elapsed,
            turned: from.turned,
            theta: line(from.place.theta, to.place.theta),
            theta_rate: line(from.place.rate, to.place.rate),
            slip: line(from.slip, to.slip),
        }
    }

    /// The point of the slide at a time since the beginning of the step.
    fn at(&self, time: f64) -> SlidePoint {
        let place = PhasePoint {
            theta: value(&self.theta, time),
            rate: value(&self.theta_rate, time),
        };
        let (elapsed, turned) = (self.begin + time, self.turned);
        SlidePoint {
            elapsed,
            turned,
            place,
            slip: value(&self.slip, time),
        }
    }
}

#[derive(Clone, Copy, Debug)]
struct SlidePoint {
    elapsed: f64,
    /// Whole turns to be added to θ; a negative zero leaves every sum unchanged.
    turned: f64,
    place: PhasePoint,
    slip: f64,
}

/// The ends of a step.
#[derive(Clone, Copy, Debug)]
struct StepEnds {
    here: SlidePoint,
    next: SlidePoint,
}

impl StepEnds {
    fn turns_back(&self) -> bool {
        let [here, next] = [self.here.place.rate, self.next.place.rate];
        // The product of the two may underflow.
        (here < 0.0 && next > 0.0) || (here > 0.0 && next < 0.0)
    }
}

/// The limits of a slide.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SlideBudget {
    pub(crate) time_left: Option<f64>,
    pub(crate) steps: usize,
}

/// The series of a step. The first `known_roots` coefficients of η′ are zero.
struct Expansion {
    series: SlideSeries,
    known_roots: usize,
}

/// The width of a step, and whether it reaches the time limit.
#[derive(Clone, Copy, Debug)]
struct StepWidth {
    width: f64,
    is_last: bool,
}

/// Where a leap can begin, and the turns that it passes, if they are proved free of events.
struct LeapStart {
    begin: f64,
    turned: f64,
    passed: Option<ProvedTurns>,
}

#[derive(Clone, Copy, Debug, Default)]
struct LeapSearch {
    /// Time of the last turning point.
    turning: Option<f64>,
    /// Of the oscillating part of σ η′ at the steps since then.
    slip_extremes: Option<SlipExtremes>,
    /// Number of steps before the next attempt.
    next_attempt: usize,
}

#[derive(Clone, Copy, Debug)]
struct SlipExtremes {
    min: f64,
    max: f64,
}

impl LeapSearch {
    fn include(&mut self, slip: f64) {
        let SlipExtremes { min, max } = self.slip_extremes.unwrap_or(SlipExtremes {
            min: slip,
            max: slip,
        });
        self.slip_extremes = Some(SlipExtremes {
            min: min.min(slip),
            max: max.max(slip),
        });
    }
}

#[derive(Clone, Copy, Debug)]
enum Event {
    Rest,
    LiftOff,
    TurningPoint,
    Singular,
}

impl Sliding {
    /// Integrates the slide to its end, or to a limit.
    pub(crate) fn run(
        law: SlidingLaw,
        start: State,
        direction: SlipDirection,
        entry: Entry,
        may_lift_off: bool,
        budget: SlideBudget,
    ) -> (Self, SlidingEnd) {
        let mut slide = Self {
            may_lift_off,
            ..Self::new(law, start, direction)
        };
        let end = if law.is_singular(slide.start.theta) {
            slide.unresolved_start()
        } else {
            slide.integrate(entry, budget, LeapSearch::default())
        };
        (slide, end)
    }

    fn new(law: SlidingLaw, start: State, direction: SlipDirection) -> Self {
        let (theta, turns) = split_turns(start.theta);
        Self {
            law,
            direction,
            start: State { theta, ..start },
            turns,
            path: law.path(ContactMotion::of(&start), start.theta.angle()),
            may_lift_off: true,
            steps: Vec::new(),
            leaps: Vec::new(),
            attempts: 0,
            turnings: Vec::new(),
            cycle: None,
        }
    }

    fn first_point(&self) -> SlidePoint {
        SlidePoint {
            elapsed: 0.0,
            turned: -0.0,
            place: PhasePoint {
                theta: self.start.theta,
                rate: self.start.theta_rate,
            },
            slip: self.start.slip,
        }
    }

    /// The end of a slide that starts at P = 0.
    fn unresolved_start(&mut self) -> SlidingEnd {
        let here = self.first_point();
        self.steps.push(TaylorStep::straight(&here, &here, 0.0));
        self.unresolved(here, self.painleve_at(here))
    }

    fn unresolved(&self, here: SlidePoint, undecided: Undecided) -> SlidingEnd {
        let state = self.state_from(here);
        SlidingEnd::Unresolved { state, undecided }
    }

    fn painleve_at(&self, here: SlidePoint) -> Undecided {
        let theta = here.place.theta;
        Undecided::Rounding {
            margin: Margin::Painleve,
            value: self.law.painleve(theta),
            bound: self.law.painleve_rounding(theta),
        }
    }

    fn integrate(
        &mut self,
        entry: Entry,
        budget: SlideBudget,
        mut search: LeapSearch,
    ) -> SlidingEnd {
        let mut here = self.first_point();
        loop {
            here = match self.advance(here, entry, budget, &mut search) {
                ControlFlow::Continue(next) => next,
                ControlFlow::Break(end) => return end,
            };
        }
    }

    /// One Taylor step from a point, and the leap that follows it, if any.
    fn advance(
        &mut self,
        here: SlidePoint,
        entry: Entry,
        budget: SlideBudget,
        search: &mut LeapSearch,
    ) -> ControlFlow<SlidingEnd, SlidePoint> {
        let Expansion {
            mut series,
            known_roots,
        } = self.expansion(&here, entry);
        let StepWidth { width, is_last } = self.step_width(&mut series, here, budget)?;
        let step = TaylorStep::new(&here, &series);
        self.steps.push(step);
        if let Some((at, event)) = self.first_event(&series, known_roots, width) {
            return ControlFlow::Break(self.end_at(event, step.at(at)));
        }
        let reached = self.with_energy(series.point(width));
        let next = self.here(here.elapsed + width, here.turned, reached);
        if let Some(recurrence) = self.endless(&series, StepEnds { here, next }, width) {
            return ControlFlow::Break(SlidingEnd::Endless(recurrence));
        }
        if is_last {
            return ControlFlow::Break(SlidingEnd::TimeLimit(self.state_from(next)));
        }
        let leap = self.leap(search, &series, StepEnds { here, next }, budget.time_left);
        ControlFlow::Continue(leap.unwrap_or(next))
    }

    /// The series about a point. At a start from rest, coefficients of η′ that vanish, but for
    /// rounding, are set to zero: they must not give an event there.
    fn expansion(&self, here: &SlidePoint, entry: Entry) -> Expansion {
        let mut series = SlideSeries::new(&self.law, here.place, here.slip);
        if self.steps.is_empty() {
            // A slide begins where the plane presses: at w = 0, but for rounding, just after.
            let vanishing = series.contact.iter_mut().take_while(|c| **c <= 0.0);
            vanishing.for_each(|c| *c = 0.0);
        }
        let Entry::FromRest { slip_acceleration } = entry else {
            return Expansion {
                series,
                known_roots: 0,
            };
        };
        if !self.steps.is_empty() {
            return Expansion {
                series,
                known_roots: 0,
            };
        }
        let computed = series.slip;
        series.slip[0] = 0.0;
        series.slip[1] = slip_acceleration;
        let known_roots = if slip_acceleration == 0.0 {
            // A derivative against the slip that begins is rounding, too.
            Onset::beyond_acceleration(&self.law, here.place, &series.slip)
                .filter(|onset| onset.direction == self.direction)
                .map_or(2, |onset| onset.order)
        } else {
            1
        };
        for (n, rounding) in computed.iter().enumerate().take(known_roots).skip(1) {
            self.take_from_slip(&mut series, n, *rounding);
        }
        Expansion {
            series,
            known_roots,
        }
    }

    /// Sets coefficient n of η′ at the start, which is rounding, to zero. It comes from that of θ′,
    /// in a light hoop from the last digit of the angle times m h/Î, so that as much is taken from
    /// θ′: otherwise η′ − θ′ (1 + h c + μk σ h s) would change throughout the first step.
    fn take_from_slip(&self, series: &mut SlideSeries, n: usize, rounding: f64) {
        series.slip[n] = 0.0;
        let Angle { sin, cos } = self.start.theta.angle();
        let h = self.law.body.h;
        let coefficient = self.law.slip_coefficient(sin, cos);
        let terms = 1.0 + h * (cos.abs() + (self.law.friction * sin).abs());
        // Where the terms of the coefficient cancel, the rounding may be theirs.
        if coefficient.abs() < 0.5 * terms {
            return;
        }
        let excess = rounding / coefficient;
        series.theta_rate[n] -= excess;
        series.theta[n + 1] -= excess / (n + 1) as f64;
    }

    /// The width of the step from a point, or the end of a slide that no step continues.
    fn step_width(
        &mut self,
        series: &mut SlideSeries,
        here: SlidePoint,
        budget: SlideBudget,
    ) -> ControlFlow<SlidingEnd, StepWidth> {
        let is_balanced = self.law.body.h == 0.0;
        let reach = if is_balanced {
            series.straight_step()
        } else {
            series.convergence_radius(&self.law, max_step(self.steps.len()))
        };
        let is_limited = self
            .leaps
            .last()
            .is_some_and(|leap| leap.passed.is_limited());
        if self.work() >= budget.steps || is_limited {
            return ControlFlow::Break(SlidingEnd::StepLimit {
                state: self.state_from(here),
                time_left: self.time_left(&here),
            });
        }
        let resolution = MIN_RELATIVE_STEP * (self.start.time + here.elapsed).abs().max(1.0);
        if reach <= resolution {
            let undecided = Undecided::Rounding {
                margin: Margin::TimeScale,
                value: reach,
                bound: resolution,
            };
            return ControlFlow::Break(if series.is_near_singularity(&self.law) {
                self.singular_end(here, undecided)
            } else {
                self.unresolved(here, undecided)
            });
        }
        if let Some(time_left) = budget.time_left
            && here.elapsed + reach >= time_left
        {
            return ControlFlow::Continue(StepWidth {
                width: time_left - here.elapsed,
                is_last: true,
            });
        }
        let time_left = series.time_to_zero(self.law.resistance);
        if is_balanced && series.slip[1] != 0.0 && time_left > MAX_TIME {
            // The slip of a balanced hoop, with very small friction.
            return ControlFlow::Break(SlidingEnd::StepLimit {
                state: self.state_from(here),
                time_left,
            });
        }
        ControlFlow::Continue(StepWidth {
            width: reach,
            is_last: false,
        })
    }

    /// The first of the three events within a step, if any.
    fn first_event(
        &self,
        series: &SlideSeries,
        known_roots: usize,
        width: f64,
    ) -> Option<(f64, Event)> {
        let sign = self.direction.sign();
        let mut slip = [0.0; DEGREE + 1];
        for (deflated, c) in slip.iter_mut().zip(&series.slip[known_roots..]) {
            *deflated = sign * c;
        }
        let rest = crossing(&slip, width).map(|at| (at, Event::Rest));
        let lift_off = crossing(&series.contact, width)
            .filter(|_| self.may_lift_off)
            .map(|at| (at, Event::LiftOff));
        let singular = crossing(&series.painleve, width).map(|at| (at, Event::Singular));
        let turning = self.turning_point(series, width);
        let turning = turning.map(|at| (at, Event::TurningPoint));
        [rest, lift_off, singular, turning]
            .into_iter()
            .flatten()
            .min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Where θ′ vanishes within a step, if rolling resistance makes that an event.
    fn turning_point(&self, series: &SlideSeries, width: f64) -> Option<f64> {
        let heading = RotationDirection::of_sign(self.law.resistance)?.sign();
        let mut ahead = series.theta_rate.map(|c| heading * c);
        if self.steps.len() == 1 {
            // The slide begins to turn in this direction: at θ′ = 0, but for rounding, just after.
            let vanishing = ahead.iter_mut().take_while(|c| **c <= 0.0);
            vanishing.for_each(|c| *c = 0.0);
        }
        crossing(&ahead, width)
    }

    fn end_at(&mut self, event: Event, point: SlidePoint) -> SlidingEnd {
        match event {
            Event::Rest => SlidingEnd::Rest(State {
                slip: 0.0,
                ..self.state_from(point)
            }),
            Event::LiftOff => SlidingEnd::LiftOff(self.state_from(point)),
            Event::TurningPoint => SlidingEnd::TurningPoint(State {
                theta_rate: 0.0,
                ..self.state_from(point)
            }),
            Event::Singular => self.singular_end(point, self.painleve_at(point)),
        }
    }

    /// The recurrence of a slide that is known to last for ever, after a step without an event.
    fn endless(&mut self, series: &SlideSeries, ends: StepEnds, width: f64) -> Option<Recurrence> {
        let StepEnds { here, next } = ends;
        let sign = self.direction.sign();
        // Rolling resistance takes energy from a slide that turns, and ends one that turns slower.
        let resistance = self.law.resistance;
        if resistance != 0.0 && (self.law.body.h > 0.0 || resistance * series.theta_rate[1] < 0.0) {
            return None;
        }
        if self.law.body.h == 0.0 && self.law.body.tilt != 0.0 && sign * series.slip[1] >= 0.0 {
            // The pull of the slope along the plane is at least the friction force, at all times.
            let acceleration = series.slip[1] - series.theta_rate[1];
            return Some(Recurrence::Downhill { acceleration });
        }
        // On a level plane, and against the pull of a slope, only a slide without kinetic friction
        // can last for ever.
        if sign * self.law.mean_slip_loss() > 0.0 {
            return None;
        }
        if ends.turns_back() {
            let at = root(&series.theta_rate, 0.0, here.place.rate.signum(), width);
            self.turnings
                .push((here.elapsed + at, value(&series.theta, at)));
        }
        self.recurrence(series, &here, &next)
    }

    /// The end next to P = 0, with the limits of θ′ and η′ at fixed angle and time; `otherwise` says
    /// why it is unresolved where P = 0 is not the cause.
    fn singular_end(&mut self, here: SlidePoint, otherwise: Undecided) -> SlidingEnd {
        let approach = self.approach(&here);
        let SingularEnd {
            fate,
            rate,
            delta_theta,
            delta_time,
        } = match approach.end(self.point_before(&here)) {
            Ok(end) => end,
            Err(undecided) => return self.unresolved(here, undecided.unwrap_or(otherwise)),
        };
        let theta = here.place.theta + delta_theta;
        let (sin, cos) = libm::sincos(theta);
        let slip = match fate {
            SingularFate::Sticks => 0.0,
            SingularFate::Jams | SingularFate::LiftsOff | SingularFate::Stops => {
                approach.integral + rate * self.law.slip_coefficient(sin, cos)
            }
        };
        let end = SlidePoint {
            elapsed: here.elapsed + delta_time,
            place: PhasePoint { theta, rate },
            slip,
            ..here
        };
        // The steps before do not reach the end.
        self.steps
            .push(TaylorStep::straight(&here, &end, delta_time));
        let state = self.state_from(end);
        match fate {
            SingularFate::Jams => SlidingEnd::Singular(state),
            SingularFate::LiftsOff => SlidingEnd::LiftOff(state),
            SingularFate::Sticks => SlidingEnd::Rest(state),
            SingularFate::Stops => SlidingEnd::TurningPoint(state),
        }
    }

    /// The state next to P = 0, with the first integral there and its error bound.
    fn approach(&self, here: &SlidePoint) -> Approach<'_> {
        let loss = self.law.mean_slip_loss() * here.elapsed;
        let (sin, cos) = libm::sincos(self.start.theta);
        let terms = self.start.slip.abs()
            + self.start.theta_rate.abs()
                * (1.0 + self.law.body.h * (cos.abs() + (self.law.friction * sin).abs()));
        let steps = self.steps.len() as f64;
        Approach {
            law: &self.law,
            place: here.place,
            integral: self.integral() - loss,
            error: f64::EPSILON * (8.0 * terms + (8.0 + steps) * loss.abs()),
        }
    }

    /// The beginning of the last step in the same turn that is far enough from P = 0 for the
    /// leading-order terms, or else of the first.
    fn point_before(&self, here: &SlidePoint) -> PhasePoint {
        let theta = here.place.theta;
        let is_far = |step: &&TaylorStep| (step.theta[0] - theta).abs() >= DISTANCE_FOR_EXPANSION;
        let same_turn = |step: &&TaylorStep| step.turned.to_bits() == here.turned.to_bits();
        let earlier = self.steps.iter().rev().take_while(same_turn);
        let earlier = earlier.clone().find(is_far).or(earlier.last());
        earlier.map_or(here.place, |step| step.at(0.0).place)
    }

    /// Leaps from a point between the ends of a step, if turns or periods can be skipped there;
    /// returns the point after the leap.
    fn leap(
        &mut self,
        search: &mut LeapSearch,
        series: &SlideSeries,
        ends: StepEnds,
        time_left: Option<f64>,
    ) -> Option<SlidePoint> {
        let (friction, resistance, h) = (self.law.friction, self.law.resistance, self.law.body.h);
        if friction == 0.0 || resistance != 0.0 || h == 0.0 || !is_on(Part::WholeTurns) {
            return None;
        }
        search.include(self.oscillating_slip(&ends.here));
        let LeapStart {
            begin,
            turned,
            passed,
        } = if ends.turns_back() {
            self.leap_over_periods(search, series, ends, time_left)
        } else {
            self.leap_over_turns(search, series, ends, time_left)
        }?;
        self.attempts += 1;
        let Some(passed) = passed else {
            search.next_attempt = 2 * self.steps.len();
            return None;
        };
        *search = LeapSearch::default();
        let (duration, place, advance) = passed.begin(passed.count);
        self.leaps.push(TurnSkip {
            begin,
            turned,
            passed,
        });
        Some(self.here(begin + duration, turned + advance, place))
    }

    /// A leap over the periods of a libration, from a turning point.
    fn leap_over_periods(
        &self,
        search: &mut LeapSearch,
        series: &SlideSeries,
        StepEnds { here, next }: StepEnds,
        time_left: Option<f64>,
    ) -> Option<LeapStart> {
        let width = next.elapsed - here.elapsed;
        let at = root(&series.theta_rate, 0.0, here.place.rate.signum(), width);
        let begin = here.elapsed + at;
        let extremes = search.slip_extremes.take()?;
        let swing = begin - search.turning.replace(begin)?;
        // The third turning point proves that a slide without loss has no end.
        if self.direction.sign() * self.law.mean_slip_loss() <= 0.0 {
            return None;
        }
        let limits = self.leap_limits(begin, time_left);
        // θ′ changes sign on the way back.
        let min_slip = extremes.min.min(-extremes.max);
        if self.steps.len() < search.next_attempt
            || limits.time_until_event(min_slip) < 2.0 * MIN_LEAP_TURNS * swing
        {
            return None;
        }
        let theta = value(&series.theta, at);
        Some(LeapStart {
            begin,
            turned: here.turned,
            passed: ProvedTurns::periods(&self.law, theta, limits),
        })
    }

    /// A leap over the turns of a rotation, from the section, if the step crosses it.
    fn leap_over_turns(
        &self,
        search: &LeapSearch,
        series: &SlideSeries,
        StepEnds { here, next }: StepEnds,
        time_left: Option<f64>,
    ) -> Option<LeapStart> {
        let heading = here.place.rate.signum();
        let rate = here.place.rate.abs().max(next.place.rate.abs());
        let limits = self.leap_limits(here.elapsed, time_left);
        if self.steps.len() < search.next_attempt
            || limits.time_until_event(search.slip_extremes?.min) * rate < MIN_LEAP_TURNS * TAU
        {
            return None;
        }
        let section = section_of(&self.law, heading);
        let (sin, cos) = libm::sincos(here.place.theta);
        let mut ahead = (heading * (section - libm::atan2(sin, cos))).rem_euclid(TAU);
        if ahead < SECTION_TOLERANCE {
            ahead += TAU;
        }
        let width = next.elapsed - here.elapsed;
        let mut gain = series.theta;
        gain[0] = 0.0;
        if heading * value(&gain, width) < ahead {
            return None;
        }
        let at = root(&gain, heading * ahead, -heading, width);
        let begin = here.elapsed + at;
        Some(LeapStart {
            begin,
            turned: here.turned + here.place.theta + heading * ahead - section,
            passed: ProvedTurns::new(
                &self.law,
                value(&series.theta_rate, at),
                self.leap_limits(begin, time_left),
            ),
        })
    }

    fn leap_limits(&self, elapsed: f64, time_left: Option<f64>) -> LeapLimits {
        let (mean_slip_loss, sign) = (self.law.mean_slip_loss(), self.direction.sign());
        LeapLimits {
            slip: sign * (self.integral() - mean_slip_loss * elapsed),
            mean_slip_loss: sign * mean_slip_loss,
            time_left: time_left.map_or(f64::INFINITY, |time_left| time_left - elapsed),
        }
    }

    /// The oscillating part of σ η′ at a point.
    fn oscillating_slip(&self, here: &SlidePoint) -> f64 {
        self.direction.sign()
            * (here.slip - self.integral() + self.law.mean_slip_loss() * here.elapsed)
    }

    /// η′ − θ′ (1 + h c + μk σ h s) + (μk σ + tan α) τ at the start.
    fn integral(&self) -> f64 {
        self.law.momentum_integral(&State {
            time: 0.0,
            ..self.start
        })
    }

    /// A place of a slide without kinetic friction with the rate from the energy D θ′²/2 + m h cos
    /// θ, D = Î + m h² sin²θ, where its terms hardly cancel and the rounding of θ hardly changes
    /// them. The rate of a light hoop at the top is otherwise known to the rounding of its energy
    /// at the bottom.
    fn with_energy(&self, place: PhasePoint) -> PhasePoint {
        let (
            Heavy {
                mass, h, inertia, ..
            },
            from,
        ) = (self.law.body, self.start);
        if self.law.friction != 0.0 || self.law.resistance != 0.0 {
            return place;
        }
        let [before, now] = [from.theta, place.theta].map(|theta| {
            let arm = h * libm::sin(theta);
            inertia + mass * arm * arm
        });
        let kinetic = 0.5 * before * from.theta_rate * from.theta_rate;
        let [mean, half] =
            [place.theta + from.theta, place.theta - from.theta].map(|sum| libm::sin(0.5 * sum));
        let fallen = 2.0 * mass * h * mean * half;
        let energy = kinetic + fallen;
        // The angle is rounded by ε|θ|/2, and the rate from the energy E by ε/4 times this over E:
        // less than its own rounding where 4 E is larger.
        let of_angle = mass * h * (libm::sin(place.theta) * place.theta).abs();
        if energy < 0.5 * (kinetic + fallen.abs()) || 4.0 * energy < of_angle {
            return place;
        }
        PhasePoint {
            rate: (2.0 * energy / now).sqrt().copysign(place.rate),
            ..place
        }
    }

    /// A point of the slide, with η′ from the first integral.
    fn here(&self, elapsed: f64, turned: f64, place: PhasePoint) -> SlidePoint {
        let (sin, cos) = libm::sincos(place.theta);
        let slip = self.integral() + place.rate * self.law.slip_coefficient(sin, cos)
            - self.law.mean_slip_loss() * elapsed;
        SlidePoint {
            elapsed,
            turned,
            place,
            slip,
        }
    }

    /// Time until η′ = 0, extrapolated from the mean loss of η′ without its oscillating part.
    fn time_left(&self, here: &SlidePoint) -> f64 {
        let steady = |theta: f64, theta_rate: f64, slip: f64| {
            let (sin, cos) = libm::sincos(theta);
            self.direction.sign()
                * (slip - theta_rate * (self.law.slip_coefficient(sin, cos) - 1.0))
        };
        let State {
            theta,
            theta_rate,
            slip,
            ..
        } = self.start;
        let now = steady(here.place.theta, here.place.rate, here.slip);
        let lost = steady(theta, theta_rate, slip) - now;
        if lost > 0.0 {
            now.max(0.0) / lost * here.elapsed
        } else {
            f64::INFINITY
        }
    }

    /// The recurrence of a slide whose slip does not decrease, once a whole period has passed.
    /// Kinetic friction changes u from turn to turn, but a slide that turns back retraces u(θ).
    fn recurrence(
        &mut self,
        series: &SlideSeries,
        here: &SlidePoint,
        next: &SlidePoint,
    ) -> Option<Recurrence> {
        if series.theta_rate.iter().all(|c| *c == 0.0) {
            return Some(Recurrence::Rest);
        }
        let gained = next.place.theta - self.start.theta;
        if self.law.friction == 0.0 && gained.abs() >= TAU {
            let advance = TAU.copysign(gained);
            let width = next.elapsed - here.elapsed;
            let period = here.elapsed
                + root(
                    &series.theta,
                    self.start.theta + advance,
                    -gained.signum(),
                    width,
                );
            self.cycle = Some(Cycle {
                from: 0.0,
                period,
                advance,
            });
            return Some(Recurrence::Rotation { period });
        }
        // The period is the time from the first to the third turning point; the start precedes them
        // on the same orbit.
        let &[(first, theta_first), (_, theta_second), (third, _)] = &self.turnings[..] else {
            return None;
        };
        self.cycle = Some(Cycle {
            from: first,
            period: third - first,
            advance: 0.0,
        });
        Some(Recurrence::Libration {
            period: third - first,
            theta_min: self.with_turns(theta_first.min(theta_second)),
            theta_max: self.with_turns(theta_first.max(theta_second)),
        })
    }

    /// Direction of slip.
    pub const fn direction(&self) -> SlipDirection {
        self.direction
    }

    /// Direction of rotation; none without rolling resistance, where it may change.
    pub(crate) fn rotation(&self) -> Option<RotationDirection> {
        RotationDirection::of_sign(self.law.resistance)
    }

    /// Smallest and largest angle at the start, at the last step and at the turning points.
    pub(crate) fn theta_range(&self) -> (f64, f64) {
        let last = self
            .steps
            .last()
            .map_or(self.start.theta, |step| step.turned + step.theta[0]);
        let angles = self
            .turnings
            .iter()
            .map(|turning| turning.1)
            .chain([self.start.theta, last]);
        let angles = angles.map(|theta| self.with_turns(theta));
        angles.fold((f64::INFINITY, f64::NEG_INFINITY), |(min, max), theta| {
            (min.min(theta), max.max(theta))
        })
    }

    /// Number of Taylor steps of the phase.
    pub fn steps(&self) -> usize {
        self.steps.len()
    }

    /// Cost of the slide, in steps.
    pub(crate) fn work(&self) -> usize {
        self.steps.len() + LEAP_COST_IN_STEPS * self.attempts
    }

    /// State after the time `elapsed` since the phase began.
    pub fn state(&self, elapsed: f64) -> State {
        let (within, gained) = match self.cycle {
            Some(Cycle {
                from,
                period,
                advance,
            }) if elapsed > from => {
                let later = elapsed - from;
                // Exact, so that the state is on the orbit however many periods have passed.
                let rest = libm::fmod(later, period);
                (from + rest, advance * ((later - rest) / period).round())
            }
            _ => (elapsed, 0.0),
        };
        let after = self.steps.partition_point(|step| step.begin <= within);
        let Some(step) = self.steps.get(after.saturating_sub(1)) else {
            return State {
                theta: self.with_turns(self.start.theta),
                ..self.start
            };
        };
        let leaps = self.leaps.partition_point(|leap| leap.begin <= within);
        if let Some(TurnSkip {
            begin,
            turned,
            passed,
        }) = self.leaps[..leaps].last()
            && *begin >= step.begin
        {
            let (place, advance) = passed.at(&self.law, within - begin);
            return self.state_from(self.here(elapsed, turned + advance, place));
        }
        let mut here = step.at(within - step.begin);
        here.place.theta += gained;
        here.slip -= self.law.mean_slip_loss() * (elapsed - within);
        self.state_from(SlidePoint { elapsed, ..here })
    }

    fn with_turns(&self, theta: f64) -> f64 {
        self.turns.add_to(theta)
    }

    fn state_from(
        &self,
        SlidePoint {
            elapsed,
            turned,
            place,
            slip,
        }: SlidePoint,
    ) -> State {
        State {
            time: self.start.time + elapsed,
            theta: self.with_turns(turned + place.theta),
            theta_rate: place.rate,
            slip,
            x: self.path.x(elapsed, place.theta.angle()),
        }
    }

    /// ∫ N |dθ| from the start of the phase to a time `elapsed` after it, in a slide that rolling
    /// resistance slows. Such a slide makes no leaps, and the series of a step converge well beyond
    /// its end, so that the integral of N |θ′| on a step is exact to rounding.
    pub(crate) fn pressed_turn(&self, elapsed: f64) -> f64 {
        let rule = Rule::get();
        let ends = self.steps.iter().skip(1).map(|step| step.begin);
        let over_step = |(step, end): (&TaylorStep, f64)| {
            let half = 0.5 * (end.min(elapsed) - step.begin).max(0.0);
            let power = rule.nodes.map(|node| {
                let place = step.at(half * (1.0 + node)).place;
                self.law.forces(place.theta, place.rate).normal * place.rate.abs()
            });
            half * rule.integral(&power)
        };
        self.steps
            .iter()
            .zip(ends.chain([elapsed]))
            .map(over_step)
            .sum()
    }

    pub(crate) fn sample(&self, hoop: &Hoop, state: State) -> Sample {
        let forces = self.law.forces(state.theta, state.theta_rate);
        let instant = Instant {
            mode: Mode::Sliding,
            direction: Some(self.direction),
            accelerations: self.law.accelerations(state.theta, state.theta_rate),
            forces,
            couple: couple_of_turning(self.law.resistance, forces.normal),
            clearance: Clearance::NONE,
        };
        instant.sample(hoop, state)
    }
}

/// Maximum step; doubles with each step after [`STEPS_BEFORE_DOUBLING`], so that slow slides end.
pub(in crate::modes) fn max_step(steps: usize) -> f64 {
    let doublings = steps.saturating_sub(STEPS_BEFORE_DOUBLING).min(60);
    (0..doublings).fold(INITIAL_MAX_STEP, |longest, _| 2.0 * longest)
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use proptest::prelude::*;

    use super::*;
    use crate::model::HoopParameters;

    /// The slide with and without leaps.
    fn both(law: SlidingLaw, start: State, allowed: Option<f64>) -> [(Sliding, SlidingEnd); 2] {
        let direction = SlipDirection::of_sign(start.slip).unwrap();
        [0, usize::MAX].map(|next_attempt| {
            let mut slide = Sliding::new(law, start, direction);
            let search = LeapSearch {
                next_attempt,
                ..LeapSearch::default()
            };
            let end = slide.integrate(
                Entry::Moving,
                SlideBudget {
                    time_left: allowed,
                    steps: 200_000,
                },
                search,
            );
            (slide, end)
        })
    }

    fn end_state(end: &SlidingEnd) -> Option<(u8, State)> {
        match *end {
            SlidingEnd::Rest(state) => Some((0, state)),
            SlidingEnd::LiftOff(state) => Some((1, state)),
            SlidingEnd::Singular(state) => Some((2, state)),
            SlidingEnd::TimeLimit(state) => Some((3, state)),
            SlidingEnd::TurningPoint(state) => Some((4, state)),
            SlidingEnd::Unresolved { .. }
            | SlidingEnd::StepLimit { .. }
            | SlidingEnd::Endless(_) => None,
        }
    }

    /// Largest relative difference of two states.
    fn difference(a: &State, b: &State) -> f64 {
        let turned = [0.0, 0.0, 0.0, 0.0, a.theta.abs()];
        let parts = a.numbers().into_iter().zip(b.numbers()).zip(turned);
        parts
            .map(|((a, b), turned)| (a - b).abs() / (1.0 + a.abs() + turned))
            .fold(0.0, f64::max)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(96))]

        /// Each step has a relative error ε of the energy and of the rate. After n steps the error
        /// of the angle is up to n ε times the total rotation. The states agree next to the
        /// beginnings and the ends of leaps, too.
        #[test]
        fn leaps_agree_with_steps(
            mass_ratio in 0.0..3.0_f64, offset in 0.02..1.0_f64, own in 0.05..3.0_f64,
            exponent in -3.7..-2.0_f64, slip in 0.05..1.5_f64, positive in any::<bool>(),
            theta in -PI..PI, rate in -1.5..1.5_f64, limited in any::<bool>(), part in 0.0..1.0_f64,
        ) {
            let direction = if positive { SlipDirection::Positive } else { SlipDirection::Negative };
            let mu = libm::pow(10.0, exponent);
            let hoop = HoopParameters::thin(mass_ratio).with_offset(offset).with_inertia(own).with_friction(mu, mu);
            let law = SlidingLaw::new(&Hoop::new(hoop).unwrap(), direction, RotationDirection::Positive).unwrap();
            // About half of the cases rotate; none lifts off at once.
            let rate = rate / law.body.h.sqrt();
            prop_assume!(law.contact(theta, rate) > 0.0);
            let start = State { time: 0.0, theta, theta_rate: rate, slip: direction.sign() * slip, x: 0.0 };
            let allowed = limited.then(|| part * slip / law.friction.abs());
            let [(by_leaps, leapt), (by_steps, stepped)] = both(law, start, allowed);
            let (Some((kind, end)), Some((expected_kind, expected))) = (end_state(&leapt), end_state(&stepped))
            else { return Ok(()) };
            prop_assert_eq!(kind, expected_kind, "{:?} {:?}", leapt, stepped);
            prop_assert!(by_leaps.steps() <= by_steps.steps());
            let steps = by_steps.steps() as f64;
            let fastest = by_steps.steps.iter().fold(0.0_f64, |most, step| most.max(step.theta_rate[0].abs()));
            let tolerance = f64::EPSILON * steps * (1.0 + fastest * end.time);
            // Near the separatrix the period is sensitive to the energy; the tolerance allows for
            // it by a perturbed start.
            let shaken = State { theta_rate: rate * (1.0 + f64::EPSILON * steps), ..start };
            let [(by_shaken, shaken), _] = both(law, shaken, allowed);
            let Some((_, shaken)) = end_state(&shaken) else { return Ok(()) };
            let allowed = tolerance + difference(&end, &shaken);
            prop_assert!(difference(&end, &expected) < allowed, "{end:?} {expected:?}");
            let last = end.time.min(expected.time).min(shaken.time);
            let seams = by_leaps.leaps.iter().flat_map(|TurnSkip { begin, passed, .. }| {
                [0.0, 1.0, 7.0, passed.count - 1.0, passed.count].map(|n| begin + passed.begin(n).0)
            });
            let seams = seams.flat_map(|time| [-1e-9, 0.0, 1e-9].map(|shift| (time + shift).clamp(0.0, last)));
            for time in (0..40).map(|k| last * f64::from(k) / 40.0).chain(seams) {
                let (ours, theirs) = (by_leaps.state(time), by_steps.state(time));
                let allowed = tolerance + difference(&ours, &by_shaken.state(time));
                prop_assert!(difference(&ours, &theirs) < allowed, "{time}: {ours:?} {theirs:?}");
            }
        }
    }
}
