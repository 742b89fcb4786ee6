//! The slides out of rolling of one body: a family with one parameter.
//!
//! Rolling slips on a curve of the phase plane, |F| = μs N, with η′ = 0. What follows, up to the next event, is therefore
//! a function of the angle of the slip alone: where the slide ends, when, and how fast the hoop turns there. On pieces
//! of the curve these functions are polynomials, interpolated at Chebyshev nodes through slides that the
//! [`SlideTable`] has followed.
//!
//! That a piece has no other event between its nodes is proved by order. Slides in the (ϑ, u) plane do not cross, so
//! that on a piece along which they leave the curve to one side everything linear in u has its extremes, at every
//! angle, on the first and the last slide of the piece. If these two agree on the signs at the ends of all cells (η″ falls
//! through zero but once, and 1 − h cos ϑ u stays positive), every slide between them does. What is not proved is left
//! out, and such slides are followed one by one.

use core::f64::consts::{PI, TAU};

use crate::hoop::Heavy;
use crate::state::Direction;
use crate::trig::sincos;

use super::roll::RollTable;
use super::slide::{SlideEvent, SlideStart, SlideTable};

/// Number of nodes and of coefficients.
const NODES: usize = 14;

/// A piece has converged when its last coefficients are below this part of the largest.
const CONVERGED: f64 = 2e-15;

/// Pieces are not halved below this width.
const NARROWEST: f64 = 1.0 / 256.0;

/// A slide that may be with or without lift-off, within this of both, is followed on its own.
const DOUBT: f64 = 1e-9;

/// Number of slots of a turn, to find a piece.
const SLOTS: usize = 256;

/// Where rolling has slipped, in the frame of motion: on which side, and the angle reduced to a turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlipPoint {
    pub(super) side: usize,
    pub(super) angle: f64,
}

/// Angle passed, time and rate at the end, of one slide.
type End = [f64; 3];

#[derive(Clone, Debug)]
struct Piece {
    left: f64,
    right: f64,
    centre: f64,
    /// 1 over half the width.
    scale: f64,
    lifts_off: bool,
    /// Coefficients in z, the highest power first.
    series: [End; NODES],
}

#[derive(Clone, Debug, Default)]
struct Family {
    pieces: Vec<Piece>,
    /// Index of the first piece that ends behind the left end of each slot.
    slots: Vec<u16>,
}

/// The slides out of rolling, by the side towards which they slip.
#[derive(Clone, Debug)]
pub(super) struct SlipTable {
    h: f64,
    mu: f64,
    families: [Family; 2],
}

/// What a piece is made from.
struct Builder<'a> {
    body: &'a Heavy,
    mu_s: f64,
    mu_k: f64,
    roll: &'a RollTable,
    slide: &'a SlideTable,
    side: usize,
}

impl SlipTable {
    /// Prepares the families of a body with these coefficients of friction.
    pub(super) fn new(body: &Heavy, (mu_s, mu_k): (f64, f64), roll: &RollTable, slide: &SlideTable) -> Self {
        let families = [0, 1].map(|side| {
            let builder = Builder { body, mu_s, mu_k, roll, slide, side };
            let mut pieces = Vec::new();
            for (from, to) in roll.slips(side) {
                let mut left = from;
                for bound in slide.bounds(side_of(side)).into_iter().chain([to]) {
                    if bound > left && bound <= to {
                        builder.fill(left, bound, &mut pieces);
                        left = bound;
                    }
                }
            }
            Family::new(pieces)
        });
        Self { h: body.h, mu: mu_k, families }
    }

    /// The end of the slide from a point of the curve with this sine, cosine and rate, in the frame of the slide; `theta`
    /// is the angle in the frame of motion, with its turns. None where it has to be followed.
    pub(super) fn follow(
        &self,
        point: SlipPoint,
        theta: f64,
        theta_rate: f64,
        (sin, cos): (f64, f64),
    ) -> Option<SlideEvent> {
        let piece = self.families[point.side].find(point.angle)?;
        let z = (point.angle - piece.centre) * piece.scale;
        let mut end = piece.series[0];
        for c in &piece.series[1..] {
            for k in 0..3 {
                end[k] = end[k] * z + c[k];
            }
        }
        let [turned, elapsed, rate] = end;
        let sigma = side_of(point.side).sign();
        let theta = theta + turned;
        let (end_sin, end_cos) = sincos(theta);
        let w = 1.0 - self.h * end_cos * (rate * rate);
        let slip = if piece.lifts_off {
            let lever = |sin: f64, cos: f64| 1.0 + self.h * (cos + self.mu * sigma * sin);
            sigma * (rate * lever(end_sin, end_cos) - theta_rate * lever(sin, cos)) - self.mu * elapsed
        } else {
            0.0
        };
        let sure = if piece.lifts_off { slip > DOUBT } else { w > DOUBT };
        sure.then_some(SlideEvent {
            elapsed,
            theta: sigma * theta,
            theta_rate: sigma * rate,
            slip,
            direction: (sigma * end_sin, end_cos),
            lifts_off: piece.lifts_off,
        })
    }

    /// Number of pieces.
    pub(super) fn pieces(&self) -> usize {
        self.families.iter().map(|family| family.pieces.len()).sum()
    }
}

/// The direction of the slip through a margin.
const fn side_of(side: usize) -> Direction {
    if side == 0 { Direction::Negative } else { Direction::Positive }
}

impl Family {
    fn new(pieces: Vec<Piece>) -> Self {
        let slots = (0..SLOTS)
            .map(|slot| {
                let angle = TAU * slot as f64 / SLOTS as f64;
                u16::try_from(pieces.partition_point(|piece| piece.right < angle)).unwrap_or(u16::MAX)
            })
            .collect();
        Self { pieces, slots }
    }

    fn find(&self, angle: f64) -> Option<&Piece> {
        let slot = (angle / TAU * SLOTS as f64) as usize;
        let first = usize::from(self.slots[slot.min(SLOTS - 1)]);
        let piece = self.pieces.get(first..)?.iter().find(|piece| angle <= piece.right)?;
        (angle >= piece.left).then_some(piece)
    }
}

impl Builder<'_> {
    fn fill(&self, left: f64, right: f64, pieces: &mut Vec<Piece>) {
        if let Some(piece) = self.piece(left, right) {
            pieces.push(piece);
        } else if right - left > 2.0 * NARROWEST {
            let middle = 0.5 * (left + right);
            self.fill(left, middle, pieces);
            self.fill(middle, right, pieces);
        }
    }

    fn piece(&self, left: f64, right: f64) -> Option<Piece> {
        let (centre, half) = (0.5 * (left + right), 0.5 * (right - left));
        let mut ends = [[0.0; 3]; NODES];
        let mut levels = [0.0; NODES];
        let mut lifts_off = None;
        let mut furthest: f64 = 0.0;
        for (k, (end, level)) in ends.iter_mut().zip(&mut levels).enumerate() {
            let z = -libm::cos(PI * (k as f64 + 0.5) / NODES as f64);
            let start = self.start(centre + half * z)?;
            let event = self.slide.follow(start)?;
            if *lifts_off.get_or_insert(event.lifts_off) != event.lifts_off {
                return None;
            }
            *end = [(event.theta - start.theta).abs(), event.elapsed, event.theta_rate.abs()];
            *level = self.slide.level(&start);
            furthest = furthest.max(start.theta.abs().max(event.theta.abs()));
        }
        // The slides leave the curve to one side, ...
        let rises = levels[1] > levels[0];
        if !levels.windows(2).all(|pair| if rises { pair[1] > pair[0] } else { pair[1] < pair[0] }) {
            return None;
        }
        // ... and the first and the last agree on what happens.
        let longest = ends.iter().fold(0.0_f64, |longest, end| longest.max(end[0]));
        let reach = longest + (right - left);
        let passings = [left, right].map(|angle| Some(self.slide.passings(&self.start(angle)?, reach)));
        let [Some(first), Some(last)] = passings else { return None };
        let mut falling = false;
        for (a, b) in first.iter().zip(&last) {
            let rising = a.slip_acceleration >= 0.0 || b.slip_acceleration >= 0.0;
            if falling && rising {
                return None;
            }
            falling = a.slip_acceleration <= 0.0 || b.slip_acceleration <= 0.0;
        }
        let passed = first.iter().zip(&last).filter(|(a, b)| a.turned.max(b.turned) < longest);
        if passed.into_iter().any(|(a, b)| a.contact <= 0.0 || b.contact <= 0.0) {
            return None;
        }
        let series = interpolate(&ends)?;
        Some(Piece { left, right, centre, scale: 1.0 / half, lifts_off: lifts_off?, series })
    }

    /// The slide that begins at this angle of the curve, in its own frame.
    fn start(&self, angle: f64) -> Option<SlideStart> {
        let (sin, cos) = sincos(angle);
        let u = self.roll.limit(self.side, angle)?;
        let Heavy { mass, offset, inertia, h } = *self.body;
        if !(u > 0.0 && 1.0 - h * cos * u > DOUBT) {
            return None;
        }
        let denominator = inertia + mass * (1.0 + h * (h + 2.0 * cos));
        let acceleration = offset * sin * (1.0 + u) / denominator;
        let normal = mass - offset * (sin * acceleration + cos * u);
        if (self.mu_s - self.mu_k) * normal <= DOUBT {
            return None;
        }
        let sigma = side_of(self.side).sign();
        Some(SlideStart {
            theta: sigma * angle,
            theta_rate: sigma * u.sqrt(),
            slip: 0.0,
            direction: (sigma * sin, cos),
        })
    }
}

/// Polynomials through values at the Chebyshev nodes of [−1, 1], if they have converged.
fn interpolate(values: &[End; NODES]) -> Option<[End; NODES]> {
    let count = NODES as f64;
    let mut chebyshev = [[0.0; 3]; NODES];
    for (j, coefficient) in chebyshev.iter_mut().enumerate() {
        let weight = if j == 0 { 1.0 / count } else { 2.0 / count };
        for (k, value) in values.iter().enumerate() {
            let sign = if j % 2 == 0 { 1.0 } else { -1.0 };
            let factor = sign * weight * libm::cos(PI * j as f64 * (k as f64 + 0.5) / count);
            for i in 0..3 {
                coefficient[i] += factor * value[i];
            }
        }
    }
    for i in 0..3 {
        let largest = values.iter().fold(0.0_f64, |largest, value| largest.max(value[i].abs()));
        if chebyshev[NODES - 2..].iter().any(|c| !(c[i].abs() <= CONVERGED * largest)) {
            return None;
        }
    }
    // To powers of z, the highest first: T_j = 2z T_{j−1} − T_{j−2}.
    let mut series = [[0.0; 3]; NODES];
    let (mut before, mut this) = ([0.0; NODES], [0.0; NODES]);
    this[0] = 1.0;
    for (j, coefficient) in chebyshev.iter().enumerate() {
        for k in 0..=j {
            for i in 0..3 {
                series[NODES - 1 - k][i] += coefficient[i] * this[k];
            }
        }
        let mut next = [0.0; NODES];
        for k in 0..NODES - 1 {
            next[k + 1] += if j == 0 { this[k] } else { 2.0 * this[k] };
            next[k] -= before[k];
        }
        (before, this) = (this, next);
    }
    Some(series)
}
