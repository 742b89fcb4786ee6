//! Leaps: many turns of a rotation with rolling resistance in one step (docs/theory/many-turns.md).
//!
//! u = θ′² at the end of a turn is linear in u at its beginning, and λ < 1. So turns are ordered, and
//! since what ends rolling is linear in u at each angle no event comes between two turns without one.

use crate::math::bracket::last_of;
use crate::modes::turn_times::{
    MAX_ENERGY_RATIO, MAX_GROWTH, MAX_LEAP_TURNS, MAX_SINGLY_SUMMED, Times, TurnBlock,
};

/// A leap up to a time limit has at most so many times the turns of a hoop that keeps its rate.
const MAX_SPEED_UP: f64 = 16.0;

/// Least number of turns of a leap: the proof and the sums take as long as some dozens of turns.
pub(super) const MIN_ROLLING_LEAP_TURNS: f64 = 64.0;

/// Cost of a leap, in steps.
pub(super) const LEAP_COST_IN_STEPS: usize = 2_000;

/// A block has no more turns than all before, or than this: it would round the times of its first
/// turns by that of all.
const MIN_BLOCK: f64 = 256.0;

/// A turn from a section.
#[derive(Clone, Copy, Debug)]
pub(super) struct Turn {
    pub(super) elapsed: f64,
    /// ∮ N |dθ|.
    pub(super) press: f64,
    /// By how much less u at the section may be for the hoop to turn over.
    pub(super) reserve: f64,
}

/// u at the section from turn to turn.
#[derive(Clone, Copy, Debug)]
pub(super) struct TurnMap {
    /// log λ.
    pub(super) log_contraction: f64,
    /// u at the beginning of the first turn, and by how much more it is at its end.
    pub(super) u: f64,
    pub(super) gain: f64,
}

impl TurnMap {
    /// By how much u grows in n turns, which need not be a whole number.
    fn grown(&self, n: f64) -> f64 {
        let rate = libm::expm1(self.log_contraction);
        if rate == 0.0 {
            n * self.gain
        } else {
            libm::expm1(n * self.log_contraction) / rate * self.gain
        }
    }

    pub(super) fn after(&self, n: f64) -> f64 {
        self.u + self.grown(n)
    }

    /// The number of turns after which u has grown by this; infinite if it never does.
    fn turns(&self, grown: f64) -> f64 {
        let (rate, gains) = (libm::expm1(self.log_contraction), grown / self.gain);
        let turns = if rate == 0.0 {
            gains
        } else {
            libm::log1p(rate * gains) / self.log_contraction
        };
        if turns >= 0.0 { turns } else { f64::INFINITY }
    }

    /// The number of turns after which u is that of the periodic rotation, but for rounding.
    pub(super) fn turns_to_repeat(&self) -> f64 {
        let distance = (self.gain / libm::expm1(self.log_contraction)).abs();
        let left = 0.25 * f64::EPSILON * self.u / distance;
        (libm::log(left) / self.log_contraction).max(0.0)
    }
}

/// The turns of a leap, from a section.
#[derive(Clone, Debug)]
pub(super) struct TurnLeap {
    /// Time since the start of the phase, and whole turns before.
    pub(super) begin: f64,
    pub(super) turned: f64,
    pub(super) map: TurnMap,
    blocks: Vec<TurnBlock>,
    pub(super) count: f64,
}

/// What bounds the turns of a leap.
pub(super) struct LeapBounds<P> {
    pub(super) time_left: f64,
    pub(super) turns: f64,
    /// Whether turn n has no event; then none before has.
    pub(super) is_free: P,
}

impl TurnLeap {
    /// The turns that have no event before the time limit, the first of which is known; none if these
    /// are fewer than [`MIN_ROLLING_LEAP_TURNS`]. `time` is that of a turn from u.
    pub(super) fn new(
        map: TurnMap,
        first: Turn,
        bounds: LeapBounds<impl Fn(f64) -> bool>,
        time: impl Fn(f64) -> f64,
    ) -> Option<Self> {
        let stops = map.turns(-first.reserve);
        let max_turns = [
            stops,
            MAX_SPEED_UP * bounds.time_left / first.elapsed,
            bounds.turns,
        ]
        .into_iter()
        .fold(MAX_LEAP_TURNS, f64::min)
        .floor();
        let is_short = |n: f64| max_turns < n || !(bounds.is_free)(n);
        if is_short(0.0) || is_short(MIN_ROLLING_LEAP_TURNS) {
            return None;
        }
        let mut leap = Self {
            begin: 0.0,
            turned: 0.0,
            map,
            blocks: Vec::new(),
            count: last_of(MIN_ROLLING_LEAP_TURNS, max_turns + 1.0, bounds.is_free),
        };
        leap.sum(first, bounds.time_left, time);
        (leap.count >= MIN_ROLLING_LEAP_TURNS).then_some(leap)
    }

    /// Sums the times of the turns, up to the time that is left.
    fn sum(&mut self, first: Turn, time_left: f64, time: impl Fn(f64) -> f64) {
        let mut summed = 0.0;
        while summed < self.count {
            self.extend(summed, first.reserve, &time);
            summed = self
                .blocks
                .last()
                .map_or(self.count, |block| block.first + block.turns);
            if self.time(summed) >= time_left {
                self.count = last_of(0.0, self.count.min(summed) + 1.0, |n| {
                    self.time(n) <= time_left
                });
                return;
            }
        }
    }

    /// Adds a block, or some turns one by one, from turn `first`.
    fn extend(&mut self, first: f64, reserve: f64, time: impl Fn(f64) -> f64) {
        let (begin, map) = (self.time(first), self.map);
        let here = TurnMap {
            u: map.after(first),
            gain: map.gain * libm::exp(first * map.log_contraction),
            ..map
        };
        let falls = here.gain < 0.0;
        let least = reserve + map.grown(if falls { first + 1.0 } else { first });
        let change = if falls {
            least / MAX_ENERGY_RATIO - least
        } else {
            least * (MAX_ENERGY_RATIO - 1.0)
        };
        let turns = here
            .turns(change)
            .min(MAX_GROWTH / map.log_contraction.abs())
            .min(self.count - first)
            .min(first.max(MIN_BLOCK))
            .floor();
        if turns > MAX_SINGLY_SUMMED as f64 {
            let times = Times::smooth(turns, |n| time(map.after(first + n)));
            self.blocks.push(TurnBlock {
                first,
                turns,
                begin,
                times,
            });
            return;
        }
        let mut before = 0.0;
        for n in (0..MAX_SINGLY_SUMMED).map(|k| first + k as f64) {
            if n >= self.count {
                break;
            }
            let each = time(map.after(n));
            self.blocks.push(TurnBlock {
                first: n,
                turns: 1.0,
                begin,
                times: Times::Equal { before, each },
            });
            before += each;
        }
    }

    /// Time at the beginning of turn `n`, from that of the leap.
    pub(super) fn time(&self, n: f64) -> f64 {
        let index = self
            .blocks
            .partition_point(|block| block.first <= n)
            .saturating_sub(1);
        self.blocks.get(index).map_or(0.0, |block| block.time(n))
    }

    pub(super) fn duration(&self) -> f64 {
        self.time(self.count)
    }

    /// The turn at a time within the leap.
    pub(super) fn turn_at(&self, time: f64) -> f64 {
        last_of(0.0, self.count, |n| self.time(n) <= time)
    }

    /// Whether the angle after more turns would be known to less than 1e-6 of one.
    pub(super) fn is_limited(&self) -> bool {
        self.count >= MAX_LEAP_TURNS - 1.0
    }
}
