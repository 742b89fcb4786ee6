//! Leaps: many turns, or periods, of a slide in one step, whose sums and proofs
//! docs/theory/many-turns.md derives.

use core::f64::consts::TAU;

use crate::math::bernstein::Bernstein;
use crate::math::bracket::last_of;
use crate::math::series::{DEGREE, Series, crossing, root, value};
use crate::mechanics::SlidingLaw;
use crate::modes::turn_times::{
    MAX_ENERGY_RATIO, MAX_GROWTH, MAX_LEAP_TURNS, MAX_SINGLY_SUMMED, MIN_LEAP_TURNS, Times,
    TurnBlock,
};

use super::return_map::{EnergyRange, ReturnMap, section};
use super::series::{PhasePoint, SlideSeries};

/// Relative margin of a proof, for some tens of roundings.
const PROOF_MARGIN: f64 = 64.0 * f64::EPSILON;

/// Largest relative difference between the times of a turn by quadrature and by series.
const MAX_TIME_MISMATCH: f64 = 1e-11;

/// Largest number of attempts to prove a number of turns free of events.
const MAX_PROOFS: usize = 8;

/// Largest number of steps of a turn, or of half a period.
const MAX_STEPS_PER_TURN: usize = 2_000;

/// The limits of a leap: the remaining slip and the remaining time.
#[derive(Clone, Copy, Debug)]
pub(super) struct LeapLimits {
    /// σ η′ − σ θ′ (1 + h c + f h s) at the beginning.
    pub(super) slip: f64,
    /// μk + σ tan α, the rate at which σ η′ decreases on average.
    pub(super) mean_slip_loss: f64,
    /// Time left until the time limit, or infinity.
    pub(super) time_left: f64,
}

impl LeapLimits {
    /// Time to the time limit, or to η′ = 0 if the oscillating part of σ η′ is `min_slip`.
    pub(super) fn time_until_event(&self, min_slip: f64) -> f64 {
        let left = self.slip + min_slip;
        let sticks = if self.mean_slip_loss > 0.0 {
            left / self.mean_slip_loss
        } else if left > 0.0 {
            f64::INFINITY
        } else {
            0.0
        };
        sticks.min(self.time_left)
    }

    /// Whether σ η′ > 0, and the time is left, up to this time, if the oscillating part of σ η′ is
    /// at least `min_slip`.
    fn holds(&self, time: f64, min_slip: f64) -> bool {
        // A slip that grows on average is least at the beginning.
        let lost = (self.mean_slip_loss * time).max(0.0);
        let margin = PROOF_MARGIN * (self.slip.abs() + lost + min_slip.abs());
        time <= self.time_left && self.slip - lost + min_slip - margin > 0.0
    }
}

/// A turn, or a swing from a turning point to the next, in Taylor steps.
struct TurnCheck {
    time: f64,
    /// Minimum and maximum of θ′ (1 + h c + f h s).
    slip_range: (f64, f64),
}

impl TurnCheck {
    /// The turn from a start with θ′ ≠ 0, or the swing from one with θ′ = 0; none if an event comes
    /// first.
    fn new(law: &SlidingLaw, start: PhasePoint) -> Option<Self> {
        let heading = start.rate.signum();
        let end = start.theta + TAU.copysign(heading);
        let mut check = Self {
            time: 0.0,
            slip_range: (f64::INFINITY, f64::NEG_INFINITY),
        };
        let mut point = start;
        for _ in 0..MAX_STEPS_PER_TURN {
            let (sin, cos) = libm::sincos(point.theta);
            let mut series =
                SlideSeries::new(law, point, point.rate * law.slip_coefficient(sin, cos));
            series.slip[1] += law.mean_slip_loss();
            let width = series.convergence_radius(law, f64::INFINITY);
            if !(width > 0.0 && width.is_finite())
                || crossing(&series.contact, width).is_some()
                || crossing(&series.painleve, width).is_some()
            {
                return None;
            }
            check.widen(&series.slip, width);
            let next = series.point(width);
            let last = if start.rate == 0.0 {
                (point.rate * next.rate < 0.0)
                    .then(|| root(&series.theta_rate, 0.0, point.rate.signum(), width))
            } else {
                (heading * (next.theta - end) >= 0.0)
                    .then(|| root(&series.theta, end, -heading, width))
            };
            check.time += last.unwrap_or(width);
            if last.is_some() {
                return Some(check);
            }
            point = next;
        }
        None
    }

    /// Extends the range by the values of a series on [0, width].
    fn widen(&mut self, series: &Series, width: f64) {
        let slope: [f64; DEGREE] = core::array::from_fn(|n| (n + 1) as f64 * series[n + 1]);
        let extrema = Bernstein::from_taylor(&slope, width).sign_changes();
        for at in extrema.into_iter().map(|at| at * width).chain([0.0, width]) {
            let value = value(series, at);
            self.slip_range = (self.slip_range.0.min(value), self.slip_range.1.max(value));
        }
    }
}

fn along_heading(law: &SlidingLaw, heading: f64) -> SlidingLaw {
    SlidingLaw {
        friction: heading * law.friction,
        ..*law
    }
}

/// Angle of the section at which a leap can begin, up to whole turns.
pub(super) fn section_of(law: &SlidingLaw, heading: f64) -> f64 {
    heading * section(&along_heading(law, heading))
}

/// The turns, or periods, that a leap passes.
#[derive(Clone, Debug)]
pub(super) struct ProvedTurns {
    /// The sign of θ′; zero for the periods of a libration.
    heading: f64,
    /// Angle at the beginning of a turn, without whole turns.
    theta: f64,
    map: ReturnMap,
    /// ε at the beginning.
    energy: f64,
    /// Upper bound of the number of turns whose times can be summed.
    max_turns: f64,
    blocks: Vec<TurnBlock>,
    /// Number of turns that are proved free of events.
    pub(super) count: f64,
}

impl ProvedTurns {
    /// The turns from the section with the rate θ′ that are proved free of events; none if fewer
    /// than [`MIN_LEAP_TURNS`].
    pub(super) fn new(law: &SlidingLaw, rate: f64, bounds: LeapLimits) -> Option<Self> {
        let heading = rate.signum();
        let ahead = along_heading(law, heading);
        let coarse = ReturnMap::new(&ahead, None)?;
        let energy = coarse.energy(rate);
        let max_turns = max_summable_turns(&ahead, &coarse, energy, bounds)?;
        let last = coarse.after(energy, max_turns - 1.0);
        let map = ReturnMap::new(
            &ahead,
            Some(EnergyRange {
                low: energy.min(last),
                high: energy.max(last),
            }),
        )?;
        let theta = section_of(law, heading);
        let mut turns = Self {
            heading,
            theta,
            map,
            energy,
            max_turns,
            blocks: Vec::new(),
            count: 0.0,
        };
        turns.count = turns.proved(law, bounds)?;
        Some(turns)
    }

    /// The periods from a turning point that are proved free of events. The preceding swing had no
    /// event.
    pub(super) fn periods(law: &SlidingLaw, theta: f64, bounds: LeapLimits) -> Option<Self> {
        let swing = TurnCheck::new(law, PhasePoint { theta, rate: 0.0 })?;
        let period = 2.0 * swing.time;
        // θ′ changes sign on the way back.
        let min_slip = swing.slip_range.0.min(-swing.slip_range.1);
        let max_turns =
            ((bounds.time_until_event(min_slip) / period).min(MAX_LEAP_TURNS) - 1.0).floor();
        let is_proved = |count: &f64| {
            *count >= MIN_LEAP_TURNS && bounds.holds((count + 1.0) * period, min_slip)
        };
        let count = [max_turns, max_turns - 1.0].into_iter().find(is_proved)?;
        let times = Times::Equal {
            before: 0.0,
            each: period,
        };
        let blocks = vec![TurnBlock {
            first: 0.0,
            turns: count,
            begin: 0.0,
            times,
        }];
        Some(Self {
            heading: 0.0,
            theta,
            map: ReturnMap::identity(1.0),
            energy: 0.0,
            max_turns,
            blocks,
            count,
        })
    }

    /// Number of turns that are proved free of events.
    fn proved(&mut self, law: &SlidingLaw, bounds: LeapLimits) -> Option<f64> {
        let side = law.friction.signum();
        let check = |turns: &Self, n: f64| {
            let check = TurnCheck::new(law, turns.point(n))?;
            let quadrature = turns.map.time(turns.energy_at(n));
            let same = (check.time - quadrature).abs() <= MAX_TIME_MISMATCH * quadrature;
            same.then_some(if side > 0.0 {
                check.slip_range.0
            } else {
                -check.slip_range.1
            })
        };
        // If the coefficient L of θ′ can be negative, the oscillating part of the slip need not decrease
        // from turn to turn.
        let f = law.friction;
        let first = if law.body.h * (1.0 + f * f).sqrt() < 1.0 {
            f64::INFINITY
        } else {
            check(self, 0.0)?
        };
        // The count is guessed from minima over the nodes, which exceed the true ones by nearly the
        // same amount in neighbouring turns. Turn n is then integrated for its true minimum. If the
        // slip stays positive until that turn ends, all earlier turns are free of events, too,
        // because the minima fall from turn to turn (`first` covers an L that changes sign).
        // Otherwise the guess is lowered by the error just seen.
        let mut overestimate = 0.0;
        for _ in 0..MAX_PROOFS {
            let n = self.last(bounds, first, overestimate);
            if n < MIN_LEAP_TURNS {
                return None;
            }
            let Some(min_slip) = check(self, n).map(|min_slip| min_slip.min(first)) else {
                // A lift-off in this turn.
                self.max_turns = n;
                continue;
            };
            if bounds.holds(self.time(n + 1.0), min_slip) {
                return Some(n);
            }
            let found = self.map.min_slip(self.energy_at(n)) - min_slip;
            overestimate = if found > overestimate {
                found
            } else {
                2.0 * overestimate
            };
        }
        None
    }

    /// The last turn that ends with σ η′ > 0, from the minimum over the nodes less `overestimate`;
    /// −1 if the first does not.
    fn last(&mut self, bounds: LeapLimits, first: f64, overestimate: f64) -> f64 {
        let holds = |turns: &Self, n: f64| {
            let min_slip = turns.map.min_slip(turns.energy_at(n)) - overestimate;
            bounds.holds(turns.time(n + 1.0), min_slip.min(first))
        };
        loop {
            let summed = self
                .blocks
                .last()
                .map_or(0.0, |last| last.first + last.turns);
            let is_over = summed > 0.0 && !holds(self, summed.min(self.max_turns) - 1.0);
            if is_over || summed >= self.max_turns {
                return last_of(-1.0, summed.min(self.max_turns), |n| holds(self, n));
            }
            self.extend(summed);
        }
    }

    /// Adds a block, or some turns one by one, from turn `first`.
    fn extend(&mut self, first: f64) {
        let begin = self.time(first);
        // The minimum of u lies at the end of a turn if u decreases, and at its beginning if u
        // increases.
        let falls = self.map.beta() < 0.0;
        let least = self.energy_at(if falls { first + 1.0 } else { first });
        let then = if falls {
            least / MAX_ENERGY_RATIO
        } else {
            least * MAX_ENERGY_RATIO
        };
        let smooth = self
            .map
            .turns(least, then)
            .min(MAX_GROWTH / self.map.kappa().abs());
        let turns = smooth.min(self.max_turns - first).floor();
        if turns > MAX_SINGLY_SUMMED as f64 {
            let times = Times::smooth(turns, |n| self.map.time(self.energy_at(first + n)));
            self.blocks.push(TurnBlock {
                first,
                turns,
                begin,
                times,
            });
            return;
        }
        let mut before = 0.0;
        for n in (0..MAX_SINGLY_SUMMED)
            .map(|k| first + k as f64)
            .take_while(|n| *n < self.max_turns)
        {
            let each = self.map.time(self.energy_at(n));
            let times = Times::Equal { before, each };
            self.blocks.push(TurnBlock {
                first: n,
                turns: 1.0,
                begin,
                times,
            });
            before += each;
        }
    }

    fn energy_at(&self, n: f64) -> f64 {
        self.map.after(self.energy, n)
    }

    /// Time at the beginning of turn `n`.
    fn time(&self, n: f64) -> f64 {
        let index = self
            .blocks
            .partition_point(|block| block.first <= n)
            .saturating_sub(1);
        self.blocks.get(index).map_or(0.0, |block| block.time(n))
    }

    /// Angle and rate at the beginning of turn `n`, without whole turns.
    fn point(&self, n: f64) -> PhasePoint {
        PhasePoint {
            theta: self.theta,
            rate: self.heading * self.map.rate(self.energy_at(n)),
        }
    }

    /// Time, angle and rate at the beginning of turn `n`, and the change of θ over the whole turns
    /// before.
    pub(super) fn begin(&self, n: f64) -> (f64, PhasePoint, f64) {
        (self.time(n), self.point(n), self.heading * n * TAU)
    }

    /// Whether the leap reaches [`MAX_LEAP_TURNS`].
    pub(super) fn is_limited(&self) -> bool {
        self.count >= MAX_LEAP_TURNS - 1.0
    }

    /// Angle and rate after a time within the leap, and the change of θ over the whole turns
    /// before.
    pub(super) fn at(&self, law: &SlidingLaw, time: f64) -> (PhasePoint, f64) {
        let (begin, mut point, delta_theta) =
            self.begin(last_of(0.0, self.count, |n| self.time(n) <= time));
        let mut left = time - begin;
        for _ in 0..MAX_STEPS_PER_TURN {
            let mut series = SlideSeries::new(law, point, 0.0);
            let width = series.convergence_radius(law, f64::INFINITY).min(left);
            point = series.point(width);
            left -= width;
            if left <= 0.0 {
                break;
            }
        }
        (point, delta_theta)
    }
}

/// Upper bound of the number of turns whose times can be summed; none if it is below
/// [`MIN_LEAP_TURNS`].
fn max_summable_turns(
    law: &SlidingLaw,
    map: &ReturnMap,
    energy: f64,
    bounds: LeapLimits,
) -> Option<f64> {
    let LeapLimits {
        slip,
        mean_slip_loss,
        time_left,
    } = bounds;
    let (h, beta) = (law.body.h, map.beta());
    // The first turn lifts off.
    if map.load_at_top(h, energy) >= 1.0 {
        return None;
    }
    // The turn with the largest energy is the fastest, the first or that of the lift-off; half its
    // time is below the time of any turn. Blocks of more turns than there is time for would round
    // the times of the first by those of all.
    let (ends, largest) = if beta < 0.0 {
        (map.turns(energy, -2.0 * beta), energy)
    } else {
        let lift_off = map.lift_off_energy(h);
        (map.turns(energy, lift_off), lift_off)
    };
    let shortest = 0.5 * map.time(largest);
    let sticks = if mean_slip_loss > 0.0 {
        (slip + map.max_slip(largest)) / (mean_slip_loss * shortest) + 1.0
    } else {
        f64::INFINITY
    };
    let ends = ends.min(sticks).min(time_left / shortest + 1.0);
    let max_turns = ends.min(MAX_LEAP_TURNS).floor();
    (max_turns >= MIN_LEAP_TURNS).then_some(max_turns)
}
