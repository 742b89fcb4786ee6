//! Many turns, or periods, of a slide at once.
//!
//! A slide through n turns takes Σ T(ε_k), k = 0 … n − 1, with T the time of a turn and ε_k the linear map of
//! [`super::turn`]. T is analytic where u > 0 in the turn, and ε_k analytic in k. On a stretch of turns T is a polynomial p of k
//! through Chebyshev nodes, and the sum is exact: with x = 2 k/M − 1 on a stretch of M turns,
//!
//! ```text
//! Σ p = D(x) − D(−1),      D(x + 1/M) − D(x − 1/M) = p(x),      D = (M/2) Σ_j c_j M^(−2j) d^(2j−1)p/dx^(2j−1),
//! ```
//!
//! c_j the coefficients of z/sinh z (Euler and Maclaurin).
//!
//! *No event is passed over.* At each angle u is monotone in the number of the turn. So where P > 0 and w > 0 in the last turn
//! of a leap and at the top of the first, they are in all: w = 1 − h c u is linear in u, and at w = 0 it has the slope h s θ′³,
//! so that it falls through zero before a top and rises behind it. σ η′ = σ C − μk τ + σ θ′ (1 + h c + f h s) is, in every turn
//! but the last, at least σ C − μk (time at the end of the last) + the least value of the last term in the last turn (or in the
//! first, where its lever has the other sign). Both are proved with the Taylor series of the last turn.
//!
//! *Libration.* θ′ = 0 does not change σ: the slide retraces u(θ), and (θ, θ′) is periodic for ever while η′ falls by μk times
//! the period.

use core::f64::consts::{PI, TAU};

use crate::math::bernstein::Bernstein;
use crate::mechanics::SlidingLaw;

use super::series::{DEGREE, Series, SlideSeries, crossing, root, value};
use super::turn::{Turn, section};

/// Fewer turns, or periods, are followed one by one.
pub(super) const FEWEST: f64 = 16.0;

/// More are not: the angle at their end is known to 1e-6 of a turn only.
pub(super) const MOST: f64 = 1e9;

/// Turns of a stretch that are summed one by one.
const FEW: usize = 8;

/// Degree of the polynomial of a stretch, plus one.
const NODES: usize = 16;

/// Largest ratio of the least u of the turns of a stretch: the zero of u is five half widths from its middle, so that the
/// polynomial through 16 nodes has the relative error 9.9^−16.
const RATIO: f64 = 1.5;

/// Largest |κ| of the turns of a stretch, in which ε_k is then nearly a parabola.
const GROWTH: f64 = 0.5;

/// Relative margin of what is proved.
const MARGIN: f64 = 64.0 * f64::EPSILON;

/// Largest relative difference of the time of a turn by quadrature and by series.
const SAME_TIME: f64 = 1e-11;

/// Steps in which a turn, or half a period, must be done.
const MOST_STEPS: usize = 2_000;

/// What ends a leap before its turns end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bounds {
    /// σ η′ − σ θ′ (1 + h c + f h s) at the beginning.
    pub(super) slip: f64,
    /// μk.
    pub(super) friction: f64,
    /// Time left; infinite without a limit.
    pub(super) allowed: f64,
}

impl Bounds {
    /// Time until the limit, or η′ = 0 if the part that comes and goes is `lowest`.
    pub(super) fn longest(&self, lowest: f64) -> f64 {
        ((self.slip + lowest) / self.friction).min(self.allowed)
    }

    /// What is left of σ η′ after a time, if the part that comes and goes with the turns is `lowest`.
    fn left(&self, time: f64, lowest: f64) -> f64 {
        self.slip - self.friction * time + lowest
            - MARGIN * (self.slip.abs() + self.friction * time + lowest.abs())
    }

    fn holds(&self, time: f64, lowest: f64) -> bool {
        time <= self.allowed && self.left(time, lowest) > 0.0
    }
}

/// One turn, or half a period, by series.
struct Probe {
    time: f64,
    /// Least and largest value of θ′ (1 + h c + f h s).
    range: (f64, f64),
}

/// A place in the plane of (θ, θ′).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Place {
    pub(super) theta: f64,
    pub(super) rate: f64,
}

impl Probe {
    /// Follows the slide from a place until `done` says at which time of a step it is; none if it meets an event before.
    fn new(
        law: &SlidingLaw,
        start: Place,
        done: impl Fn(&SlideSeries, f64, Place) -> Option<f64>,
    ) -> Option<Self> {
        let mut probe = Self { time: 0.0, range: (f64::INFINITY, f64::NEG_INFINITY) };
        let mut here = start;
        for _ in 0..MOST_STEPS {
            let (sin, cos) = libm::sincos(here.theta);
            let mut series = SlideSeries::new(law, here.theta, here.rate, here.rate * law.lever(sin, cos));
            series.slip[1] += law.friction;
            let width = series.reach(f64::INFINITY);
            if !(width > 0.0 && width.is_finite())
                || crossing(&series.contact, width).is_some()
                || crossing(&series.solvability, width).is_some()
            {
                return None;
            }
            probe.widen(&series.slip, width);
            if let Some(at) = done(&series, width, here) {
                probe.time += at;
                return Some(probe);
            }
            probe.time += width;
            here = Place { theta: value(&series.theta, width), rate: value(&series.theta_rate, width) };
            if here.rate * start.rate < 0.0 {
                return None;
            }
        }
        None
    }

    /// A whole turn.
    fn turn(law: &SlidingLaw, start: Place) -> Option<Self> {
        let travel = start.rate.signum();
        Self::new(law, start, |series, width, _| {
            let level = start.theta + TAU.copysign(travel);
            let beyond = travel * (value(&series.theta, width) - level);
            (beyond >= 0.0).then(|| root(&series.theta, level, -travel, width))
        })
    }

    /// From a turning point to the next.
    fn swing(law: &SlidingLaw, theta: f64) -> Option<Self> {
        Self::new(law, Place { theta, rate: 0.0 }, |series, width, here| {
            let then = value(&series.theta_rate, width);
            (here.rate * then < 0.0).then(|| root(&series.theta_rate, 0.0, here.rate.signum(), width))
        })
    }

    /// Takes the values of a series on [0, width] in.
    fn widen(&mut self, series: &Series, width: f64) {
        let mut swing = 0.0;
        let mut slope = [0.0; DEGREE];
        let mut order = DEGREE as f64;
        for (slope, c) in slope.iter_mut().zip(&series[1..]).rev() {
            swing = (swing + c.abs()) * width;
            *slope = order * c;
            order -= 1.0;
        }
        let mut take = |value: f64| self.range = (self.range.0.min(value), self.range.1.max(value));
        take(series[0]);
        take(value(series, width));
        if series[0] - swing < self.range.0 || series[0] + swing > self.range.1 {
            for at in Bernstein::from_taylor(&slope, width).sign_changes() {
                self.range.0 = self.range.0.min(value(series, at * width));
                self.range.1 = self.range.1.max(value(series, at * width));
            }
        }
    }
}

/// Times of the turns of a stretch.
#[derive(Clone, Debug)]
enum Times {
    /// At the end of each.
    Each(Vec<f64>),
    /// D(x) − D(−1), by powers of x.
    Smooth([f64; NODES + 1]),
}

/// Turns whose times are summed together.
#[derive(Clone, Debug)]
struct Stretch {
    /// Number of the first.
    first: f64,
    turns: f64,
    /// Time at its beginning.
    begin: f64,
    times: Times,
}

impl Stretch {
    /// Time at the beginning of turn `n` of the leap, which is one of the stretch or the next.
    fn time(&self, n: f64) -> f64 {
        let within = n - self.first;
        let passed = match &self.times {
            Times::Each(ends) => match within as usize {
                0 => 0.0,
                many => ends.get(many - 1).copied().unwrap_or(f64::NAN),
            },
            Times::Smooth(powers) => {
                let x = 2.0 * within / self.turns - 1.0;
                powers.iter().rev().fold(0.0, |sum, c| sum * x + c)
            }
        };
        self.begin + passed
    }

    fn end(&self) -> f64 {
        self.time(self.first + self.turns)
    }
}

/// From values of a polynomial at the Chebyshev nodes of a stretch of `turns` turns to the powers of D(x) − D(−1).
fn sum_of_turns(values: &[f64; NODES], turns: f64) -> [f64; NODES + 1] {
    // Powers of x, by way of Chebyshev polynomials: the last two of these, and the next.
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
            next[k] = if j == 0 { raised } else { 2.0 * raised - before[k] };
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

/// Whole turns that are passed at once.
#[derive(Clone, Debug)]
struct Turns {
    /// +1 or −1, the sign of θ′.
    travel: f64,
    /// The section, in the direction of travel.
    section: f64,
    turn: Turn,
    /// ε at the beginning.
    energy: f64,
    /// Largest number of turns whose times can be summed.
    most: f64,
    stretches: Vec<Stretch>,
    /// Turns that are passed.
    count: f64,
}

/// The law as it is seen in the direction of travel.
fn seen(law: &SlidingLaw, travel: f64) -> SlidingLaw {
    SlidingLaw { friction: travel * law.friction, ..*law }
}

/// The section at which turns in a direction are counted, and so the angle at which a leap can begin, up to whole turns.
pub(super) fn section_of(law: &SlidingLaw, travel: f64) -> f64 {
    travel * section(&seen(law, travel))
}

impl Turns {
    /// [`Passed::turns`].
    fn new(law: &SlidingLaw, rate: f64, bounds: Bounds) -> Option<Self> {
        let travel = rate.signum();
        let ahead = seen(law, travel);
        let coarse = Turn::new(&ahead, None)?;
        let energy = coarse.energy(rate);
        let most = most_turns(&ahead, &coarse, energy, bounds)?;
        let last = coarse.after(energy, most - 1.0);
        let turn = Turn::new(&ahead, Some((energy.min(last), energy.max(last))))?;
        let mut turns =
            Self { travel, section: section(&ahead), turn, energy, most, stretches: Vec::new(), count: 0.0 };
        turns.count = turns.proved(law, bounds)?;
        turns.stretches.retain(|stretch| stretch.first < turns.count);
        Some(turns)
    }

    /// Number of turns that are proved to be without event.
    fn proved(&mut self, law: &SlidingLaw, bounds: Bounds) -> Option<f64> {
        let side = law.friction.signum();
        let probe = |turns: &Self, n: f64| {
            let probe = Probe::turn(law, turns.place(n))?;
            let quadrature = turns.turn.time(turns.energy_at(n));
            let same = (probe.time - quadrature).abs() <= SAME_TIME * quadrature;
            same.then_some(if side > 0.0 { probe.range.0 } else { -probe.range.1 })
        };
        // Where the lever of θ′ can be negative, this part of the slip need not fall from turn to turn.
        let f = law.friction;
        let first = if law.body.h * (1.0 + f * f).sqrt() < 1.0 { f64::INFINITY } else { probe(self, 0.0)? };
        // The nodes miss the least value by a little, about the same in turns close to each other.
        let mut excess = 0.0;
        for _ in 0..8 {
            let n = self.last(bounds, first, excess)?;
            if n < FEWEST {
                return None;
            }
            let lowest = probe(self, n).map(|lowest| lowest.min(first));
            let Some(lowest) = lowest else {
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

    /// The last turn in which the slip is left, by the nodes less an excess; none if it is not even in the first.
    fn last(&mut self, bounds: Bounds, first: f64, excess: f64) -> Option<f64> {
        let left = |turns: &Self, stretch: &Stretch, n: f64| {
            let lowest = turns.turn.lowest_slip(turns.energy_at(n)) - excess;
            bounds.holds(stretch.time(n + 1.0), lowest.min(first))
        };
        let mut index = 0;
        loop {
            if index == self.stretches.len() && !self.extend() {
                break;
            }
            let stretch = &self.stretches[index];
            let end = (stretch.first + stretch.turns).min(self.most) - 1.0;
            if end < stretch.first {
                break;
            }
            if !left(self, stretch, end) {
                let last = last_of(stretch.first - 1.0, end, |n| left(self, stretch, n));
                return (last >= 0.0).then_some(last);
            }
            index += 1;
        }
        (self.most >= 1.0).then_some(self.most - 1.0)
    }

    /// Adds a stretch; false where there are no more turns.
    fn extend(&mut self) -> bool {
        let (first, begin) =
            self.stretches.last().map_or((0.0, 0.0), |last| (last.first + last.turns, last.end()));
        let left = self.most - first;
        if left < 1.0 {
            return false;
        }
        // u is least at the end of a turn where it falls, at its beginning where it rises.
        let falls = self.turn.beta() < 0.0;
        let least = self.energy_at(if falls { first + 1.0 } else { first });
        let then = if falls { least / RATIO } else { least * RATIO };
        let smooth = self.turn.turns(least, then).min(GROWTH / self.turn.kappa().abs());
        let turns = smooth.min(left).floor();
        let stretch = if turns > FEW as f64 {
            let values = core::array::from_fn(|k| {
                let x = libm::cos(PI * (2 * k + 1) as f64 / (2 * NODES) as f64);
                self.turn.time(self.energy_at(first + 0.5 * ((x + 1.0) * turns - 1.0)))
            });
            Stretch { first, turns, begin, times: Times::Smooth(sum_of_turns(&values, turns)) }
        } else {
            let mut ends = Vec::with_capacity(FEW);
            let mut sum = 0.0;
            let mut n = first;
            while ends.len() < FEW && n < self.most {
                sum += self.turn.time(self.energy_at(n));
                ends.push(sum);
                n += 1.0;
            }
            Stretch { first, turns: n - first, begin, times: Times::Each(ends) }
        };
        self.stretches.push(stretch);
        true
    }

    fn energy_at(&self, n: f64) -> f64 {
        self.turn.after(self.energy, n)
    }

    /// Time at the beginning of turn `n`.
    fn time(&self, n: f64) -> f64 {
        let index = self.stretches.partition_point(|stretch| stretch.first < n).saturating_sub(1);
        self.stretches.get(index).map_or(0.0, |stretch| stretch.time(n))
    }

    /// Where turn `n` begins, with the angle of the section.
    fn place(&self, n: f64) -> Place {
        Place { theta: self.travel * self.section, rate: self.travel * self.turn.rate(self.energy_at(n)) }
    }

    /// The last turn that begins before a time.
    fn turn_at(&self, time: f64) -> f64 {
        let index = self.stretches.partition_point(|stretch| stretch.begin <= time).saturating_sub(1);
        let Some(stretch) = self.stretches.get(index) else { return 0.0 };
        let end = (stretch.first + stretch.turns).min(self.count);
        last_of(stretch.first, end, |n| stretch.time(n) <= time)
    }
}

/// The last of the numbers from `low` to before `high` for which something holds, that holds for the first of them.
fn last_of(mut low: f64, mut high: f64, holds: impl Fn(f64) -> bool) -> f64 {
    while high - low > 1.0 {
        let middle = (0.5 * (low + high)).floor();
        if holds(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Turns whose times can be summed; none if they are too few.
fn most_turns(law: &SlidingLaw, turn: &Turn, energy: f64, bounds: Bounds) -> Option<f64> {
    let Bounds { slip, friction, allowed } = bounds;
    let (h, beta) = (law.body.h, turn.beta());
    // A turn that begins with the rim about to leave the plane is followed.
    if turn.load_at_top(h, energy) >= 1.0 {
        return None;
    }
    let ends = if beta < 0.0 {
        // The first turn is the fastest: none is shorter.
        let shortest = 0.5 * turn.time(energy);
        let most_slip = slip + turn.largest_slip(energy);
        let sticks = most_slip / (friction * shortest) + 1.0;
        turn.turns(energy, -2.0 * beta).min(sticks).min(allowed / shortest + 1.0)
    } else {
        turn.turns(energy, turn.lift_off_energy(h))
    };
    let most = ends.min(MOST).floor();
    (most >= FEWEST).then_some(most)
}

/// Turns or periods that are passed at once.
#[derive(Clone, Debug)]
pub(super) struct Passed {
    pub(super) count: f64,
    /// Time that they take.
    pub(super) duration: f64,
    /// What θ gains.
    pub(super) advance: f64,
    /// The place at the end, with an angle that has been reduced by what θ gains.
    pub(super) end: Place,
    kind: Kind,
}

#[derive(Clone, Debug)]
enum Kind {
    Turns(Box<Turns>),
    /// Of a libration from a turning point, each of this length.
    Periods(f64),
}

impl Passed {
    /// As many turns as can be proved to be without event, from the section on at the rate θ′; none if they are fewer than
    /// [`FEWEST`].
    pub(super) fn turns(law: &SlidingLaw, rate: f64, bounds: Bounds) -> Option<Self> {
        let turns = Turns::new(law, rate, bounds)?;
        let count = turns.count;
        Some(Self {
            count,
            duration: turns.time(count),
            advance: turns.travel * count * TAU,
            end: turns.place(count),
            kind: Kind::Turns(Box::new(turns)),
        })
    }

    /// As many periods, from a turning point on. The swing that has led there was without event.
    pub(super) fn periods(law: &SlidingLaw, theta: f64, bounds: Bounds) -> Option<Self> {
        let swing = Probe::swing(law, theta)?;
        let period = 2.0 * swing.time;
        // On the way back θ′ has the other sign.
        let lowest = swing.range.0.min(-swing.range.1);
        let free = ((bounds.slip + lowest) / bounds.friction).min(bounds.allowed) / period;
        let mut count = (free.min(MOST) - 1.0).floor();
        if count >= FEWEST && !bounds.holds((count + 1.0) * period, lowest) {
            count -= 1.0;
        }
        let proved = count >= FEWEST && bounds.holds((count + 1.0) * period, lowest);
        let end = Place { theta, rate: 0.0 };
        proved.then_some(Self {
            count,
            duration: period * count,
            advance: 0.0,
            end,
            kind: Kind::Periods(period),
        })
    }

    /// The place after a time, and what θ has gained.
    pub(super) fn place(&self, law: &SlidingLaw, time: f64) -> (Place, f64) {
        let (begin, mut here, gained) = match &self.kind {
            Kind::Turns(turns) => {
                let n = turns.turn_at(time);
                (turns.time(n), turns.place(n), turns.travel * n * TAU)
            }
            Kind::Periods(period) => {
                let n = (time / period).floor().min(self.count - 1.0).max(0.0);
                (n * period, self.end, 0.0)
            }
        };
        let mut left = time - begin;
        for _ in 0..MOST_STEPS {
            let series = SlideSeries::new(law, here.theta, here.rate, 0.0);
            let width = series.reach(f64::INFINITY).min(left);
            here = Place { theta: value(&series.theta, width), rate: value(&series.theta_rate, width) };
            left -= width;
            if left <= 0.0 {
                break;
            }
        }
        (here, gained)
    }
}
