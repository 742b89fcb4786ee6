//! Leaps: many turns, or periods, of a slide in one step, whose sums and proofs
//! docs/theory/many-turns.md derives.
//!
//! A polynomial p(x), x = 2 k/M − 1, through the times of M turns at Chebyshev nodes has the sum
//!
//! ```text
//! Σ p = D(x) − D(−1),      D(x + 1/M) − D(x − 1/M) = p(x),      D = (M/2) Σ_j c_j M^(−2j) d^(2j−1)p/dx^(2j−1),
//! ```
//!
//! with c_j the coefficients of z/sinh z (Euler and Maclaurin).

use core::f64::consts::{PI, TAU};

use crate::math::bernstein::Bernstein;
use crate::math::bracket::last_of;
use crate::math::series::{DEGREE, Series, crossing, root, value};
use crate::mechanics::SlidingLaw;

use super::series::{PhasePoint, SlideSeries};
use super::turn::{Turn, section};

/// Least number of turns, or periods, of a leap; fewer are integrated step by step.
pub(super) const MIN_LEAP_TURNS: f64 = 16.0;

/// Largest number of turns, or periods, of a leap: the angle after so many has an error of 1e-6 of
/// a turn.
const MAX_LEAP_TURNS: f64 = 1e9;

/// Largest number of turns whose times are summed one by one: half the nodes of a polynomial.
const MAX_SINGLY_SUMMED: usize = 8;

const NODES: usize = 16;

/// Largest ratio of min u between the turns of a stretch. The zero of u is then five half widths
/// from the middle, and the interpolation error through 16 nodes is (5 + √24)^−16 = 9.9^−16.
const MAX_ENERGY_RATIO: f64 = 1.5;

/// Largest |κ| times the number of turns of a stretch: ε_k is then nearly quadratic in k.
const MAX_GROWTH: f64 = 0.5;

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
    pub(super) drag: f64,
    /// Time left until the time limit, or infinity.
    pub(super) allowed: f64,
}

impl LeapLimits {
    /// Time to the time limit, or to η′ = 0 if the oscillating part of σ η′ is `lowest`.
    pub(super) fn longest(&self, lowest: f64) -> f64 {
        let left = self.slip + lowest;
        let sticks = if self.drag > 0.0 {
            left / self.drag
        } else if left > 0.0 {
            f64::INFINITY
        } else {
            0.0
        };
        sticks.min(self.allowed)
    }

    /// Whether σ η′ > 0, and the time is left, up to this time, if the oscillating part of σ η′ is
    /// at least `lowest`.
    fn holds(&self, time: f64, lowest: f64) -> bool {
        // A slip that grows on average is least at the beginning.
        let lost = (self.drag * time).max(0.0);
        let margin = PROOF_MARGIN * (self.slip.abs() + lost + lowest.abs());
        time <= self.allowed && self.slip - lost + lowest - margin > 0.0
    }
}

/// A turn, or a swing from a turning point to the next, in Taylor steps.
struct Probe {
    time: f64,
    /// Minimum and maximum of θ′ (1 + h c + f h s).
    range: (f64, f64),
}

impl Probe {
    /// The turn from a start with θ′ ≠ 0, or the swing from one with θ′ = 0; none if an event comes
    /// first.
    fn new(law: &SlidingLaw, start: PhasePoint) -> Option<Self> {
        let travel = start.rate.signum();
        let end = start.theta + TAU.copysign(travel);
        let mut probe = Self {
            time: 0.0,
            range: (f64::INFINITY, f64::NEG_INFINITY),
        };
        let mut here = start;
        for _ in 0..MAX_STEPS_PER_TURN {
            let (sin, cos) = libm::sincos(here.theta);
            let mut series =
                SlideSeries::new(law, here, here.rate * law.slip_coefficient(sin, cos));
            series.slip[1] += law.mean_slip_loss();
            let width = series.reach(f64::INFINITY);
            if !(width > 0.0 && width.is_finite())
                || crossing(&series.contact, width).is_some()
                || crossing(&series.solvability, width).is_some()
            {
                return None;
            }
            probe.widen(&series.slip, width);
            let next = series.point(width);
            let last = if start.rate == 0.0 {
                (here.rate * next.rate < 0.0)
                    .then(|| root(&series.theta_rate, 0.0, here.rate.signum(), width))
            } else {
                (travel * (next.theta - end) >= 0.0)
                    .then(|| root(&series.theta, end, -travel, width))
            };
            probe.time += last.unwrap_or(width);
            if last.is_some() {
                return Some(probe);
            }
            here = next;
        }
        None
    }

    /// Extends the range by the values of a series on [0, width].
    fn widen(&mut self, series: &Series, width: f64) {
        let slope: [f64; DEGREE] = core::array::from_fn(|n| (n + 1) as f64 * series[n + 1]);
        let extrema = Bernstein::from_taylor(&slope, width).sign_changes();
        for at in extrema.into_iter().map(|at| at * width).chain([0.0, width]) {
            let value = value(series, at);
            self.range = (self.range.0.min(value), self.range.1.max(value));
        }
    }
}

#[derive(Clone, Debug)]
enum Times {
    /// Each takes the same time, after a time before.
    Equal { before: f64, each: f64 },
    /// Coefficients of D(x) − D(−1) in powers of x.
    Smooth([f64; NODES + 1]),
}

/// Consecutive turns whose times are summed together.
#[derive(Clone, Debug)]
struct Stretch {
    first: f64,
    turns: f64,
    begin: f64,
    times: Times,
}

impl Stretch {
    /// Time at the beginning of turn `n` of the leap, a turn of the stretch or the next turn.
    fn time(&self, n: f64) -> f64 {
        let within = n - self.first;
        let passed = match &self.times {
            Times::Equal { before, each } => before + within * each,
            Times::Smooth(powers) => {
                let x = 2.0 * within / self.turns - 1.0;
                powers.iter().rev().fold(0.0, |sum, c| sum * x + c)
            }
        };
        self.begin + passed
    }
}

/// Coefficients of D(x) − D(−1) from the values of p at the Chebyshev nodes of a stretch of `turns`
/// turns.
fn sum_of_turns(values: &[f64; NODES], turns: f64) -> [f64; NODES + 1] {
    // Coefficients of p in powers of x, by the recurrence of the Chebyshev polynomials.
    let mut powers = [0.0; NODES];
    let (mut before, mut this) = ([0.0; NODES], [0.0; NODES]);
    this[0] = 1.0;
    for j in 0..NODES {
        let mut coefficient = 0.0;
        for (k, value) in values.iter().enumerate() {
            coefficient += value * libm::cos(PI * (j * (2 * k + 1)) as f64 / (2 * NODES) as f64);
        }
        coefficient *= if j == 0 { 1.0 } else { 2.0 } / NODES as f64;
        for (power, c) in powers.iter_mut().zip(this) {
            *power += coefficient * c;
        }
        let mut next = [0.0; NODES];
        for k in 0..NODES {
            let raised = if k == 0 { 0.0 } else { this[k - 1] };
            next[k] = if j == 0 {
                raised
            } else {
                2.0 * raised - before[k]
            };
        }
        (before, this) = (this, next);
    }
    // z/sinh z, from its product with sinh z/z = Σ z^(2i)/(2i + 1)!.
    let mut series = [0.0; NODES / 2 + 1];
    series[0] = 1.0;
    for j in 1..series.len() {
        let mut factorial = 1.0;
        for i in 1..=j {
            factorial *= (2 * i * (2 * i + 1)) as f64;
            series[j] -= series[j - i] / factorial;
        }
    }
    let mut sum = [0.0; NODES + 1];
    for (k, power) in powers.iter().enumerate() {
        // The integral of x^k, then its odd derivatives.
        let mut factor = 0.5 * turns * power / (k + 1) as f64;
        let mut degree = k + 1;
        for c in series {
            sum[degree] += c * factor;
            if degree < 2 {
                break;
            }
            factor *= (degree * (degree - 1)) as f64 / (turns * turns);
            degree -= 2;
        }
    }
    sum[0] = 0.0;
    sum[0] = -sum.iter().rev().fold(0.0, |sum, c| c - sum);
    sum
}

fn in_travel_direction(law: &SlidingLaw, travel: f64) -> SlidingLaw {
    SlidingLaw {
        friction: travel * law.friction,
        ..*law
    }
}

/// Angle of the section at which a leap can begin, up to whole turns.
pub(super) fn section_of(law: &SlidingLaw, travel: f64) -> f64 {
    travel * section(&in_travel_direction(law, travel))
}

/// The turns, or periods, that a leap passes.
#[derive(Clone, Debug)]
pub(super) struct Turns {
    /// The sign of θ′; zero for the periods of a libration.
    travel: f64,
    /// Angle at the beginning of a turn, without whole turns.
    theta: f64,
    turn: Turn,
    /// ε at the beginning.
    energy: f64,
    /// Upper bound of the number of turns whose times can be summed.
    most: f64,
    stretches: Vec<Stretch>,
    /// Number of turns that are proved free of events.
    pub(super) count: f64,
}

impl Turns {
    /// The turns from the section with the rate θ′ that are proved free of events; none if fewer
    /// than [`MIN_LEAP_TURNS`].
    pub(super) fn new(law: &SlidingLaw, rate: f64, bounds: LeapLimits) -> Option<Self> {
        let travel = rate.signum();
        let ahead = in_travel_direction(law, travel);
        let coarse = Turn::new(&ahead, None)?;
        let energy = coarse.energy(rate);
        let most = most_turns(&ahead, &coarse, energy, bounds)?;
        let last = coarse.after(energy, most - 1.0);
        let turn = Turn::new(&ahead, Some((energy.min(last), energy.max(last))))?;
        let theta = section_of(law, travel);
        let mut turns = Self {
            travel,
            theta,
            turn,
            energy,
            most,
            stretches: Vec::new(),
            count: 0.0,
        };
        turns.count = turns.proved(law, bounds)?;
        Some(turns)
    }

    /// The periods from a turning point that are proved free of events. The preceding swing had no
    /// event.
    pub(super) fn periods(law: &SlidingLaw, theta: f64, bounds: LeapLimits) -> Option<Self> {
        let swing = Probe::new(law, PhasePoint { theta, rate: 0.0 })?;
        let period = 2.0 * swing.time;
        // θ′ changes sign on the way back.
        let lowest = swing.range.0.min(-swing.range.1);
        let most = ((bounds.longest(lowest) / period).min(MAX_LEAP_TURNS) - 1.0).floor();
        let is_proved =
            |count: &f64| *count >= MIN_LEAP_TURNS && bounds.holds((count + 1.0) * period, lowest);
        let count = [most, most - 1.0].into_iter().find(is_proved)?;
        let times = Times::Equal {
            before: 0.0,
            each: period,
        };
        let stretches = vec![Stretch {
            first: 0.0,
            turns: count,
            begin: 0.0,
            times,
        }];
        Some(Self {
            travel: 0.0,
            theta,
            turn: Turn::still(1.0),
            energy: 0.0,
            most,
            stretches,
            count,
        })
    }

    /// Number of turns that are proved free of events.
    fn proved(&mut self, law: &SlidingLaw, bounds: LeapLimits) -> Option<f64> {
        let side = law.friction.signum();
        let probe = |turns: &Self, n: f64| {
            let probe = Probe::new(law, turns.point(n))?;
            let quadrature = turns.turn.time(turns.energy_at(n));
            let same = (probe.time - quadrature).abs() <= MAX_TIME_MISMATCH * quadrature;
            same.then_some(if side > 0.0 {
                probe.range.0
            } else {
                -probe.range.1
            })
        };
        // If the lever of θ′ can be negative, the oscillating part of the slip need not decrease
        // from turn to turn.
        let f = law.friction;
        let first = if law.body.h * (1.0 + f * f).sqrt() < 1.0 {
            f64::INFINITY
        } else {
            probe(self, 0.0)?
        };
        // The minimum over the nodes exceeds the true minimum, by nearly the same amount in
        // neighbouring turns.
        let mut excess = 0.0;
        for _ in 0..MAX_PROOFS {
            let n = self.last(bounds, first, excess);
            if n < MIN_LEAP_TURNS {
                return None;
            }
            let Some(lowest) = probe(self, n).map(|lowest| lowest.min(first)) else {
                // A lift-off in this turn.
                self.most = n;
                continue;
            };
            if bounds.holds(self.time(n + 1.0), lowest) {
                return Some(n);
            }
            let found = self.turn.lowest_slip(self.energy_at(n)) - lowest;
            excess = if found > excess { found } else { 2.0 * excess };
        }
        None
    }

    /// The last turn that ends with σ η′ > 0, from the minimum over the nodes less `excess`; −1 if
    /// the first does not.
    fn last(&mut self, bounds: LeapLimits, first: f64, excess: f64) -> f64 {
        let holds = |turns: &Self, n: f64| {
            let lowest = turns.turn.lowest_slip(turns.energy_at(n)) - excess;
            bounds.holds(turns.time(n + 1.0), lowest.min(first))
        };
        loop {
            let summed = self
                .stretches
                .last()
                .map_or(0.0, |last| last.first + last.turns);
            let is_over = summed > 0.0 && !holds(self, summed.min(self.most) - 1.0);
            if is_over || summed >= self.most {
                return last_of(-1.0, summed.min(self.most), |n| holds(self, n));
            }
            self.extend(summed);
        }
    }

    /// Adds a stretch, or some turns one by one, from turn `first`.
    fn extend(&mut self, first: f64) {
        let begin = self.time(first);
        // The minimum of u lies at the end of a turn if u decreases, and at its beginning if u
        // increases.
        let falls = self.turn.beta() < 0.0;
        let least = self.energy_at(if falls { first + 1.0 } else { first });
        let then = if falls {
            least / MAX_ENERGY_RATIO
        } else {
            least * MAX_ENERGY_RATIO
        };
        let smooth = self
            .turn
            .turns(least, then)
            .min(MAX_GROWTH / self.turn.kappa().abs());
        let turns = smooth.min(self.most - first).floor();
        if turns > MAX_SINGLY_SUMMED as f64 {
            let values = core::array::from_fn(|k| {
                let x = libm::cos(PI * (2 * k + 1) as f64 / (2 * NODES) as f64);
                self.turn
                    .time(self.energy_at(first + 0.5 * ((x + 1.0) * turns - 1.0)))
            });
            let times = Times::Smooth(sum_of_turns(&values, turns));
            self.stretches.push(Stretch {
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
            .take_while(|n| *n < self.most)
        {
            let each = self.turn.time(self.energy_at(n));
            let times = Times::Equal { before, each };
            self.stretches.push(Stretch {
                first: n,
                turns: 1.0,
                begin,
                times,
            });
            before += each;
        }
    }

    fn energy_at(&self, n: f64) -> f64 {
        self.turn.after(self.energy, n)
    }

    /// Time at the beginning of turn `n`.
    fn time(&self, n: f64) -> f64 {
        let index = self
            .stretches
            .partition_point(|stretch| stretch.first <= n)
            .saturating_sub(1);
        self.stretches
            .get(index)
            .map_or(0.0, |stretch| stretch.time(n))
    }

    /// Angle and rate at the beginning of turn `n`, without whole turns.
    fn point(&self, n: f64) -> PhasePoint {
        PhasePoint {
            theta: self.theta,
            rate: self.travel * self.turn.rate(self.energy_at(n)),
        }
    }

    /// Time, angle and rate at the beginning of turn `n`, and the change of θ over the whole turns
    /// before.
    pub(super) fn begin(&self, n: f64) -> (f64, PhasePoint, f64) {
        (self.time(n), self.point(n), self.travel * n * TAU)
    }

    /// Whether the leap reaches [`MAX_LEAP_TURNS`].
    pub(super) fn is_longest(&self) -> bool {
        self.count >= MAX_LEAP_TURNS - 1.0
    }

    /// Angle and rate after a time within the leap, and the change of θ over the whole turns
    /// before.
    pub(super) fn at(&self, law: &SlidingLaw, time: f64) -> (PhasePoint, f64) {
        let (begin, mut here, gained) =
            self.begin(last_of(0.0, self.count, |n| self.time(n) <= time));
        let mut left = time - begin;
        for _ in 0..MAX_STEPS_PER_TURN {
            let series = SlideSeries::new(law, here, 0.0);
            let width = series.reach(f64::INFINITY).min(left);
            here = series.point(width);
            left -= width;
            if left <= 0.0 {
                break;
            }
        }
        (here, gained)
    }
}

/// Upper bound of the number of turns whose times can be summed; none if it is below
/// [`MIN_LEAP_TURNS`].
fn most_turns(law: &SlidingLaw, turn: &Turn, energy: f64, bounds: LeapLimits) -> Option<f64> {
    let LeapLimits {
        slip,
        drag,
        allowed,
    } = bounds;
    let (h, beta) = (law.body.h, turn.beta());
    // The first turn lifts off.
    if turn.load_at_top(h, energy) >= 1.0 {
        return None;
    }
    let ends = if beta < 0.0 {
        // The first turn is the fastest; half its time is below the time of any turn.
        let shortest = 0.5 * turn.time(energy);
        let most_slip = slip + turn.largest_slip(energy);
        let sticks = if drag > 0.0 {
            most_slip / (drag * shortest) + 1.0
        } else {
            f64::INFINITY
        };
        turn.turns(energy, -2.0 * beta)
            .min(sticks)
            .min(allowed / shortest + 1.0)
    } else {
        turn.turns(energy, turn.lift_off_energy(h))
    };
    let most = ends.min(MAX_LEAP_TURNS).floor();
    (most >= MIN_LEAP_TURNS).then_some(most)
}
