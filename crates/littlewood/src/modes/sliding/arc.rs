//! A phase of sliding: Taylor steps, each searched for events, and leaps over whole turns.

use core::f64::consts::TAU;

use crate::ablation::{Part, is_on};
use crate::mechanics::{SlidePath, SlidingLaw};
use crate::model::{Direction, Hoop, Mode, State};
use crate::modes::{Instant, Recurrence, Sample};

use super::leap::{LeapLimits, MAX_LEAP_TURNS, MIN_LEAP_TURNS, PhasePoint, Skipped, section_of};
use super::series::{DEGREE, INITIAL_MAX_STEP, Series, SlideSeries, crossing, root, value};
use super::singular::{Approach, Fate};

/// Least step relative to the time. A shorter step means a singularity of the equations.
const MIN_RELATIVE_STEP: f64 = 4.0 * f64::EPSILON;

/// Number of steps, a time of at most 1024, after which the maximum step doubles with each step.
const STEPS_BEFORE_DOUBLING: usize = 64;

/// Cost of an attempted leap, in steps.
const LEAP_COST_IN_STEPS: usize = 100;

/// Least distance from P = 0 for the leading-order terms, if the slide offers one: a few √ε, so that distance and terms keep half of
/// the digits.
const DISTANCE_FOR_EXPANSION: f64 = 1e-7;

/// Distance from the section below which an angle counts as on it; the leap then begins one turn later.
const SECTION_TOLERANCE: f64 = 1e-9;

/// How a slide begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Entry {
    /// With η′ ≠ 0.
    Moving,
    /// With η′ = 0 and this acceleration η″. It has the sign of the direction of slip, or vanishes on the static
    /// limit with μs = μk, where η‴ decides. The zero of η′ at the start is no event.
    FromRest { slip_acceleration: f64 },
}

/// How a slide ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum SlidingEnd {
    /// η′ = 0.
    Rest(State),
    /// w = 0: the normal force vanishes.
    LiftOff(State),
    /// P = 0 with η′ ≠ 0 and unbounded N: sliding has no solution beyond.
    Singular(State),
    /// The time scale falls below double precision: away from P = 0, or next to P = 0 where rounding decides the outcome.
    Unresolved(State),
    /// The limit of steps or of turns; with an estimate of the time until η′ = 0.
    StepLimit { state: State, time_left: f64 },
    /// The time limit.
    TimeLimit(State),
    /// No end: without kinetic friction, energy and horizontal momentum are conserved, and a slide
    /// without an event in a whole period repeats.
    Endless(Recurrence),
}

/// A phase of sliding; Taylor polynomials give the state at any time.
#[derive(Clone, Debug)]
pub struct Sliding {
    law: SlidingLaw,
    direction: Direction,
    start: State,
    path: SlidePath,
    steps: Vec<Step>,
    leaps: Vec<Leap>,
    attempts: usize,
    /// Time and angle of the turning points; recorded only without kinetic friction.
    turnings: Vec<(f64, f64)>,
    cycle: Option<Cycle>,
}

/// The period of a slide that repeats.
#[derive(Clone, Copy, Debug)]
struct Cycle {
    /// Start of a period that the steps cover.
    from: f64,
    period: f64,
    /// Change of θ in a period.
    advance: f64,
}

/// A leap over turns, or periods, between two steps.
#[derive(Clone, Debug)]
struct Leap {
    /// Time since the start of the phase.
    begin: f64,
    /// θ minus the angle of [`Skipped`]: the whole turns before the leap.
    turned: f64,
    passed: Skipped,
}

#[derive(Clone, Copy, Debug)]
struct Step {
    /// Time since the start of the phase.
    begin: f64,
    /// θ minus its series: whole turns.
    turned: f64,
    theta: Series,
    theta_rate: Series,
    slip: Series,
}

/// A point of the slide.
#[derive(Clone, Copy, Debug)]
struct SlidePoint {
    elapsed: f64,
    /// Whole turns to be added to `theta`; a negative zero leaves every sum unchanged.
    turned: f64,
    theta: f64,
    theta_rate: f64,
    slip: f64,
}

/// State of the search for leaps.
#[derive(Clone, Copy, Debug, Default)]
struct LeapSearch {
    turning: Option<f64>,
    /// Minimum and maximum of the oscillating part of σ η′ at the steps since then.
    range: Option<(f64, f64)>,
    /// Number of steps before the next attempt.
    next_attempt: usize,
    /// Whether a leap reached [`MAX_LEAP_TURNS`].
    has_reached_max: bool,
}

#[derive(Clone, Copy, Debug)]
enum Event {
    Rest,
    LiftOff,
    Singular,
}

impl Sliding {
    /// Integrates the slide to its end, for at most the time `allowed` and `most` steps.
    pub(crate) fn run(
        law: SlidingLaw,
        start: State,
        direction: Direction,
        entry: Entry,
        (allowed, most): (Option<f64>, usize),
    ) -> (Self, SlidingEnd) {
        let mut slide = Self::new(law, start, direction);
        let end = slide.follow(entry, (allowed, most), LeapSearch::default());
        (slide, end)
    }

    fn new(law: SlidingLaw, start: State, direction: Direction) -> Self {
        Self {
            law,
            direction,
            start,
            path: law.path(&start, libm::sincos(start.theta)),
            steps: Vec::new(),
            leaps: Vec::new(),
            attempts: 0,
            turnings: Vec::new(),
            cycle: None,
        }
    }

    fn follow(
        &mut self,
        entry: Entry,
        (allowed, most): (Option<f64>, usize),
        mut search: LeapSearch,
    ) -> SlidingEnd {
        let sign = self.direction.sign();
        let start = self.start;
        let integral = self.integral();
        let mut here = SlidePoint {
            elapsed: 0.0,
            turned: -0.0,
            theta: start.theta,
            theta_rate: start.theta_rate,
            slip: start.slip,
        };
        loop {
            let mut series = SlideSeries::new(&self.law, here.theta, here.theta_rate, here.slip);
            let mut known_roots = 0;
            if let (Entry::FromRest { slip_acceleration }, true) = (entry, self.steps.is_empty()) {
                series.slip[0] = 0.0;
                series.slip[1] = slip_acceleration;
                known_roots = if slip_acceleration == 0.0 { 2 } else { 1 };
            }
            // P ≥ Î except where it tends to zero.
            let is_near_zero = series.solvability[0] < 0.5 * self.law.body.inertia;
            let reach = if self.law.body.h == 0.0 {
                series.straight_reach()
            } else {
                series.reach(max_step(self.steps.len()))
            };
            if self.work() >= most || search.has_reached_max {
                let state = self.state_from(here);
                return SlidingEnd::StepLimit { state, time_left: self.time_left(&here) };
            }
            if reach <= MIN_RELATIVE_STEP * (start.time + here.elapsed).abs().max(1.0) {
                return if is_near_zero {
                    self.singular_end(here)
                } else {
                    SlidingEnd::Unresolved(self.state_from(here))
                };
            }
            let last = allowed.is_some_and(|allowed| here.elapsed + reach >= allowed);
            if !last && !reach.is_finite() {
                // With very small friction the slip of a balanced hoop ends at a time that overflows.
                return SlidingEnd::StepLimit { state: self.state_from(here), time_left: f64::INFINITY };
            }
            let width = match allowed {
                Some(allowed) if last => allowed - here.elapsed,
                _ => reach,
            };
            self.steps.push(Step {
                begin: here.elapsed,
                turned: here.turned,
                theta: series.theta,
                theta_rate: series.theta_rate,
                slip: series.slip,
            });
            if let Some((at, event)) = first_event(&series, sign, known_roots, width) {
                let found = SlidePoint {
                    elapsed: here.elapsed + at,
                    turned: here.turned,
                    theta: value(&series.theta, at),
                    theta_rate: value(&series.theta_rate, at),
                    slip: value(&series.slip, at),
                };
                return match event {
                    Event::Rest => SlidingEnd::Rest(State { slip: 0.0, ..self.state_from(found) }),
                    Event::LiftOff => SlidingEnd::LiftOff(self.state_from(found)),
                    Event::Singular => self.singular_end(found),
                };
            }
            let theta_rate = value(&series.theta_rate, width);
            let theta = value(&series.theta, width);
            let elapsed = here.elapsed + width;
            let (sin, cos) = libm::sincos(theta);
            let next = SlidePoint {
                elapsed,
                turned: here.turned,
                theta,
                theta_rate,
                slip: integral + theta_rate * self.law.lever(sin, cos) - self.law.friction * elapsed,
            };
            if self.law.friction == 0.0 {
                if next.theta_rate * here.theta_rate < 0.0 {
                    let at = root(&series.theta_rate, 0.0, here.theta_rate.signum(), width);
                    self.turnings.push((here.elapsed + at, value(&series.theta, at)));
                }
                if let Some(recurrence) = self.recurrence(&series, &here, &next) {
                    return SlidingEnd::Endless(recurrence);
                }
            }
            if last {
                return SlidingEnd::TimeLimit(self.state_from(next));
            }
            here = self.leap(&mut search, &series, (here, next), allowed).unwrap_or(next);
        }
    }

    /// The end next to P = 0, with the limits of θ′ and η′ at fixed angle and time.
    fn singular_end(&mut self, here: SlidePoint) -> SlidingEnd {
        let State { theta, theta_rate, slip, .. } = self.start;
        let loss = self.law.friction * here.elapsed;
        let (sin, cos) = libm::sincos(theta);
        let terms = slip.abs()
            + theta_rate.abs() * (1.0 + self.law.body.h * (cos.abs() + (self.law.friction * sin).abs()));
        let steps = self.steps.len() as f64;
        let approach = Approach {
            law: &self.law,
            theta: here.theta,
            theta_rate: here.theta_rate,
            rest: self.integral() - loss,
            error: f64::EPSILON * (8.0 * terms + (8.0 + steps) * loss.abs()),
        };
        let is_earlier = |step: &&Step| (step.theta[0] - here.theta).abs() >= DISTANCE_FOR_EXPANSION;
        let earlier =
            self.steps.iter().rev().take_while(|step| step.turned.to_bits() == here.turned.to_bits());
        let earlier = earlier.clone().find(is_earlier).or(earlier.last());
        let earlier =
            earlier.map_or((here.theta, here.theta_rate), |step| (step.theta[0], step.theta_rate[0]));
        let Some((fate, theta_rate)) = approach.fate(earlier) else {
            return SlidingEnd::Unresolved(self.state_from(here));
        };
        let (sin, cos) = libm::sincos(here.theta);
        let slip = match fate {
            Fate::Sticks => 0.0,
            Fate::Jams | Fate::LiftsOff => approach.rest + theta_rate * self.law.lever(sin, cos),
        };
        let end = SlidePoint { theta_rate, slip, ..here };
        let constant = |value: f64| core::array::from_fn(|n| if n == 0 { value } else { 0.0 });
        self.steps.push(Step {
            begin: here.elapsed,
            turned: here.turned,
            theta: constant(end.theta),
            theta_rate: constant(theta_rate),
            slip: constant(slip),
        });
        let state = self.state_from(end);
        match fate {
            Fate::Jams => SlidingEnd::Singular(state),
            Fate::LiftsOff => SlidingEnd::LiftOff(state),
            Fate::Sticks => SlidingEnd::Rest(state),
        }
    }

    /// Leaps from a point between `here` and `next`, if turns or periods can be skipped there; returns the point after the leap.
    fn leap(
        &mut self,
        search: &mut LeapSearch,
        series: &SlideSeries,
        (here, next): (SlidePoint, SlidePoint),
        allowed: Option<f64>,
    ) -> Option<SlidePoint> {
        let SlidingLaw { body, friction } = self.law;
        if friction == 0.0 || body.h == 0.0 || !is_on(Part::WholeTurns) {
            return None;
        }
        let integral = self.integral();
        let bounds = |elapsed: f64| LeapLimits {
            slip: self.direction.sign() * (integral - friction * elapsed),
            friction: friction.abs(),
            allowed: allowed.map_or(f64::INFINITY, |allowed| allowed - elapsed),
        };
        let width = next.elapsed - here.elapsed;
        let swings = self.direction.sign() * (here.slip - integral + friction * here.elapsed);
        let (least, most) = search.range.unwrap_or((swings, swings));
        let (least, most) = (least.min(swings), most.max(swings));
        search.range = Some((least, most));
        let is_ready = self.steps.len() >= search.next_attempt;
        let (begin, turned, passed) = if next.theta_rate * here.theta_rate < 0.0 {
            let at = root(&series.theta_rate, 0.0, here.theta_rate.signum(), width);
            let begin = here.elapsed + at;
            search.range = None;
            let swing = begin - search.turning.replace(begin)?;
            // θ′ changes sign on the way back.
            if !is_ready || bounds(begin).longest(least.min(-most)) < 2.0 * MIN_LEAP_TURNS * swing {
                return None;
            }
            let theta = value(&series.theta, at);
            (begin, here.turned, Skipped::periods(&self.law, theta, bounds(begin)))
        } else {
            let travel = here.theta_rate.signum();
            let rate = here.theta_rate.abs().max(next.theta_rate.abs());
            if !is_ready || bounds(here.elapsed).longest(least) * rate < MIN_LEAP_TURNS * TAU {
                return None;
            }
            let section = section_of(&self.law, travel);
            let (sin, cos) = libm::sincos(here.theta);
            let mut ahead = (travel * (section - libm::atan2(sin, cos))).rem_euclid(TAU);
            if ahead < SECTION_TOLERANCE {
                ahead += TAU;
            }
            let mut gain = series.theta;
            gain[0] = 0.0;
            if travel * value(&gain, width) < ahead {
                return None;
            }
            let at = root(&gain, travel * ahead, -travel, width);
            let begin = here.elapsed + at;
            let turned = here.turned + here.theta + travel * ahead - section;
            let rate = value(&series.theta_rate, at);
            (begin, turned, Skipped::turns(&self.law, rate, bounds(begin)))
        };
        self.attempts += 1;
        let Some(passed) = passed else {
            search.next_attempt = 2 * self.steps.len();
            return None;
        };
        let end = self.here(begin + passed.duration, turned + passed.advance, passed.end);
        *search =
            LeapSearch { has_reached_max: passed.count >= MAX_LEAP_TURNS - 1.0, ..LeapSearch::default() };
        self.leaps.push(Leap { begin, turned, passed });
        Some(end)
    }

    /// η′ − θ′ (1 + h c + μk σ h s) + μk σ τ at the start.
    fn integral(&self) -> f64 {
        self.law.momentum_integral(&State { time: 0.0, ..self.start })
    }

    /// A point of the slide, with η′ from the first integral.
    fn here(&self, elapsed: f64, turned: f64, PhasePoint { theta, rate }: PhasePoint) -> SlidePoint {
        let (sin, cos) = libm::sincos(theta);
        let slip = self.integral() + rate * self.law.lever(sin, cos) - self.law.friction * elapsed;
        SlidePoint { elapsed, turned, theta, theta_rate: rate, slip }
    }

    /// Time until η′ = 0, extrapolated from the mean loss of η′ without its oscillating part.
    fn time_left(&self, here: &SlidePoint) -> f64 {
        let steady = |theta: f64, theta_rate: f64, slip: f64| {
            let (sin, cos) = libm::sincos(theta);
            self.direction.sign() * (slip - theta_rate * (self.law.lever(sin, cos) - 1.0))
        };
        let State { theta, theta_rate, slip, .. } = self.start;
        let now = steady(here.theta, here.theta_rate, here.slip);
        let lost = steady(theta, theta_rate, slip) - now;
        if lost > 0.0 { now.max(0.0) / lost * here.elapsed } else { f64::INFINITY }
    }

    /// The recurrence of a slide without friction, once a whole period has passed.
    fn recurrence(
        &mut self,
        series: &SlideSeries,
        here: &SlidePoint,
        next: &SlidePoint,
    ) -> Option<Recurrence> {
        if series.theta_rate.iter().all(|c| *c == 0.0) {
            return Some(Recurrence::Rest);
        }
        let gained = next.theta - self.start.theta;
        if gained.abs() >= TAU {
            let advance = TAU.copysign(gained);
            let at = root(
                &series.theta,
                self.start.theta + advance,
                -gained.signum(),
                next.elapsed - here.elapsed,
            );
            let period = here.elapsed + at;
            self.cycle = Some(Cycle { from: 0.0, period, advance });
            return Some(Recurrence::Rotation { period });
        }
        // The period is the time from the first to the third turning point; the start precedes them on the same orbit.
        let &[(first, theta_first), (_, theta_second), (third, _)] = &self.turnings[..] else { return None };
        self.cycle = Some(Cycle { from: first, period: third - first, advance: 0.0 });
        Some(Recurrence::Libration {
            period: third - first,
            theta_min: theta_first.min(theta_second),
            theta_max: theta_first.max(theta_second),
        })
    }

    /// Direction of slip.
    #[must_use]
    pub const fn direction(&self) -> Direction {
        self.direction
    }

    /// Smallest and largest angle at the start, at the last step and at the turning points.
    pub(crate) fn theta_range(&self) -> (f64, f64) {
        let last = self.steps.last().map_or(self.start.theta, |step| step.theta[0]);
        let angles = self.turnings.iter().map(|turning| turning.1).chain([self.start.theta, last]);
        angles.fold((f64::INFINITY, f64::NEG_INFINITY), |(min, max), theta| (min.min(theta), max.max(theta)))
    }

    /// Number of Taylor steps of the phase.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps.len()
    }

    /// Cost of the slide, in steps.
    pub(crate) fn work(&self) -> usize {
        self.steps.len() + LEAP_COST_IN_STEPS * self.attempts
    }

    /// State after the time `elapsed` since the phase began.
    #[must_use]
    pub fn state(&self, elapsed: f64) -> State {
        let (within, gained) = match self.cycle {
            Some(Cycle { from, period, advance }) if elapsed > from => {
                let periods = ((elapsed - from) / period).floor();
                (elapsed - period * periods, advance * periods)
            }
            _ => (elapsed, 0.0),
        };
        let after = self.steps.partition_point(|step| step.begin <= within);
        let Some(step) = self.steps.get(after.saturating_sub(1)) else { return self.start };
        let leaps = self.leaps.partition_point(|leap| leap.begin <= within);
        if let Some(Leap { begin, turned, passed }) = self.leaps[..leaps].last()
            && *begin >= step.begin
        {
            let (place, advance) = passed.place(&self.law, within - begin);
            return self.state_from(self.here(elapsed, turned + advance, place));
        }
        let at = within - step.begin;
        self.state_from(SlidePoint {
            elapsed,
            turned: step.turned,
            theta: gained + value(&step.theta, at),
            theta_rate: value(&step.theta_rate, at),
            slip: value(&step.slip, at),
        })
    }

    fn state_from(&self, here: SlidePoint) -> State {
        State {
            time: self.start.time + here.elapsed,
            theta: here.turned + here.theta,
            theta_rate: here.theta_rate,
            slip: here.slip,
            x: self.path.x(here.elapsed, libm::sincos(here.theta)),
        }
    }

    pub(crate) fn sample(&self, hoop: &Hoop, state: State) -> Sample {
        let forces = self.law.forces(state.theta, state.theta_rate);
        let accelerations = self.law.accelerations(state.theta, state.theta_rate);
        let instant = Instant {
            mode: Mode::Sliding,
            direction: Some(self.direction),
            accelerations: (accelerations.theta, accelerations.slip),
            forces: (forces.normal, forces.friction),
            gap: (0.0, 0.0),
        };
        instant.sample(hoop, state)
    }
}

/// Maximum step; doubles with each step after [`STEPS_BEFORE_DOUBLING`], so that slow slides end.
fn max_step(steps: usize) -> f64 {
    let doublings = steps.saturating_sub(STEPS_BEFORE_DOUBLING).min(60);
    (0..doublings).fold(INITIAL_MAX_STEP, |longest, _| 2.0 * longest)
}

/// The first of the three events within a step, if any.
fn first_event(series: &SlideSeries, sign: f64, known_roots: usize, width: f64) -> Option<(f64, Event)> {
    let mut slip = [0.0; DEGREE + 1];
    for (deflated, c) in slip.iter_mut().zip(&series.slip[known_roots..]) {
        *deflated = sign * c;
    }
    let rest = crossing(&slip, width).map(|at| (at, Event::Rest));
    let lift_off = crossing(&series.contact, width).map(|at| (at, Event::LiftOff));
    let singular = crossing(&series.solvability, width).map(|at| (at, Event::Singular));
    [rest, lift_off, singular].into_iter().flatten().min_by(|a, b| a.0.total_cmp(&b.0))
}

#[cfg(test)]
mod tests {
    use core::f64::consts::{PI, TAU};

    use proptest::prelude::*;

    use super::*;
    use crate::model::HoopParameters;

    fn law(mass_ratio: f64, offset: f64, inertia: f64, mu_k: f64, direction: Direction) -> SlidingLaw {
        let hoop = HoopParameters::thin(mass_ratio)
            .with_offset(offset)
            .with_inertia(inertia)
            .with_friction(mu_k, mu_k);
        SlidingLaw::new(&Hoop::new(hoop).unwrap(), direction).unwrap()
    }

    /// The slide with and without leaps.
    fn both(law: SlidingLaw, start: State, allowed: Option<f64>) -> [(Sliding, SlidingEnd); 2] {
        let direction = Direction::of_sign(start.slip).unwrap();
        [0, usize::MAX].map(|next_attempt| {
            let mut slide = Sliding::new(law, start, direction);
            let search = LeapSearch { next_attempt, ..LeapSearch::default() };
            let end = slide.follow(Entry::Moving, (allowed, 200_000), search);
            (slide, end)
        })
    }

    fn end_state(end: &SlidingEnd) -> Option<(u8, State)> {
        match *end {
            SlidingEnd::Rest(state) => Some((0, state)),
            SlidingEnd::LiftOff(state) => Some((1, state)),
            SlidingEnd::Singular(state) => Some((2, state)),
            SlidingEnd::TimeLimit(state) => Some((3, state)),
            SlidingEnd::Unresolved(_) | SlidingEnd::StepLimit { .. } | SlidingEnd::Endless(_) => None,
        }
    }

    /// Largest relative difference of two states.
    fn difference(a: &State, b: &State) -> f64 {
        let part = |a: f64, b: f64, size: f64| (a - b).abs() / (1.0 + size);
        part(a.time, b.time, a.time)
            .max(part(a.theta, b.theta, a.theta.abs()))
            .max(part(a.theta_rate, b.theta_rate, a.theta_rate.abs()))
            .max(part(a.slip, b.slip, a.slip.abs()))
            .max(part(a.x, b.x, a.x.abs() + a.theta.abs()))
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(96))]

        /// Each step has a relative error ε of the energy and of the rate. After n steps the error of the angle is up to n ε times
        /// the total rotation.
        #[test]
        fn leaps_agree_with_steps(
            mass_ratio in 0.0..3.0_f64, offset in 0.02..1.0_f64, own in 0.05..3.0_f64,
            exponent in -3.7..-2.0_f64, slip in 0.05..1.5_f64, positive in any::<bool>(),
            theta in -PI..PI, rate in -1.5..1.5_f64, limited in any::<bool>(), part in 0.0..1.0_f64,
        ) {
            let direction = if positive { Direction::Positive } else { Direction::Negative };
            let law = law(mass_ratio, offset, own, libm::pow(10.0, exponent), direction);
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
            // Near the separatrix the period is sensitive to the energy; the tolerance allows for it by a perturbed start.
            let shaken = State { theta_rate: rate * (1.0 + f64::EPSILON * steps), ..start };
            let [(by_shaken, shaken), _] = both(law, shaken, allowed);
            let Some((_, shaken)) = end_state(&shaken) else { return Ok(()) };
            let allowed = tolerance + difference(&end, &shaken);
            prop_assert!(difference(&end, &expected) < allowed, "{end:?} {expected:?}");
            for k in 0..40 {
                let time = end.time.min(expected.time).min(shaken.time) * f64::from(k) / 40.0;
                let (ours, theirs) = (by_leaps.state(time), by_steps.state(time));
                let allowed = tolerance + difference(&ours, &by_shaken.state(time));
                prop_assert!(difference(&ours, &theirs) < allowed, "{k}: {ours:?} {theirs:?}");
            }
        }
    }

    /// The state is continuous at the beginning of a leap, between its turns, and at its end.
    #[test]
    fn leaps_leave_no_seam() {
        for (law, rate) in [
            (law(1.0, 1.0, 1.0, 1e-4, Direction::Positive), 1.2),
            (law(1.0, 1.0, 1.0, 1e-4, Direction::Negative), 0.8),
            (law(1.0, 0.3, 0.2, 1e-4, Direction::Positive), -1.7),
            (law(1.0, 1.0, 1.0, 1e-4, Direction::Positive), 0.3),
        ] {
            let slip = 2.5 * law.friction.signum();
            let start = State { time: 0.0, theta: 1.0, theta_rate: rate, slip, x: 0.0 };
            let [(slide, _), _] = both(law, start, None);
            let Some(leap) = slide.leaps.first() else { panic!("no leap at {rate}") };
            let duration = leap.passed.duration;
            let count = leap.passed.count;
            let turn = duration / count;
            for time in [0.0, 0.1 * turn, turn, 7.0 * turn, 0.3 * duration, duration - turn, duration] {
                // The times of turns differ slightly: scan around each instant.
                for shift in 0..200 {
                    let at = (leap.begin + time + turn * (f64::from(shift) / 100.0 - 1.0)).max(0.0);
                    let (before, after) = (slide.state(at), slide.state(at + 1e-9));
                    let moved = after.theta - before.theta - 1e-9 * before.theta_rate;
                    assert!(moved.abs() < 1e-12 * (1.0 + at), "{at}: {moved:e}");
                    assert!((after.slip - before.slip).abs() < 1e-8, "{before:?} {after:?}");
                    assert!((after.x - before.x).abs() < 1e-8);
                }
            }
        }
    }

    /// With a tiny offset a slide is that of a balanced hoop, whose accelerations are constant. For large slip the rate changes sign.
    #[test]
    fn a_nearly_balanced_hoop_slides_as_a_balanced_one() {
        for (inertia, mu_k, rate, slip) in
            [(1.0, 1e-3, 30.0, 5.0), (1e-3, 0.2, 400.0, 2e3), (0.4, 0.1, -2e3, 70.0), (1e6, 1e-4, 3.0, -0.2)]
        {
            let law = law(
                1.0,
                1e-13,
                inertia,
                mu_k,
                if slip > 0.0 { Direction::Positive } else { Direction::Negative },
            );
            let start = State { time: 0.0, theta: 0.7, theta_rate: rate, slip, x: 0.0 };
            let [(slide, end), _] = both(law, start, None);
            let SlidingEnd::Rest(end) = end else { panic!("{end:?}") };
            // η″ = −μk σ (1 + m/Î), θ″ = −μk σ m/Î.
            let spin = law.friction * law.body.mass / law.body.inertia;
            let time = slip / (law.friction + spin);
            assert!((end.time / time - 1.0).abs() < 1e-10, "{} {time}", end.time);
            let angle = 0.7 + rate * time - 0.5 * spin * time * time;
            assert!((end.theta - angle).abs() < 1e-9 * (1.0 + rate.abs() * time), "{} {angle}", end.theta);
            assert!(!slide.leaps.is_empty() && slide.steps() < 2_000, "{}", slide.steps());
            let turns: f64 = slide.leaps.iter().map(|leap| leap.passed.advance.abs()).sum::<f64>() / TAU;
            assert!(turns > 20.0);
        }
    }
}
