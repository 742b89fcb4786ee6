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

use core::f64::consts::TAU;

use crate::hoop::Heavy;
use crate::state::Direction;
use crate::trig::sincos;

use super::interpolant::{Basis, Interpolant, NODES, Slots};
use super::roll::{RollAhead, RollEnd, RollTable};
use super::slide::{SlideEvent, SlideStart, SlideTable};

/// Pieces are not halved below this width.
const NARROWEST: f64 = 1.0 / 128.0;

/// A slide that may be with or without lift-off, within this of both, is followed on its own.
const DOUBT: f64 = 1e-9;

/// Where rolling has slipped, in the frame of motion: on which side, and the angle reduced to a turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlipPoint {
    pub(super) side: usize,
    pub(super) angle: f64,
}

/// What a slide out of rolling leads to.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlipEnd {
    /// The end of the slide.
    pub(super) event: SlideEvent,
    /// What is known of the phase behind it.
    pub(super) ahead: Ahead,
}

/// What is known of the phase that follows.
#[derive(Clone, Copy, Debug)]
pub(super) enum Ahead {
    /// Nothing.
    Open,
    /// If the hoop rolls, and slips where the others of the family do.
    Roll(RollAhead),
}

/// What the motions of a piece have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// The slide comes to rest, and nothing is known of what follows.
    Rest,
    /// It comes to rest, and rolling slips before this stop, to this side.
    RestAndRoll {
        stop: usize,
        side: usize,
    },
    LiftOff,
}

#[derive(Clone, Debug)]
struct Piece {
    kind: Kind,
    /// Of one motion: angle and time of the slide, rate at its end; then angle and time of the roll behind it.
    ends: Interpolant<5>,
}

#[derive(Clone, Debug, Default)]
struct Family {
    pieces: Vec<Piece>,
    slots: Slots,
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
    basis: Basis,
    side: usize,
}

impl SlipTable {
    /// Prepares the families of a body with these coefficients of friction.
    pub(super) fn new(body: &Heavy, (mu_s, mu_k): (f64, f64), roll: &RollTable, slide: &SlideTable) -> Self {
        let families = [0, 1].map(|side| {
            let builder = Builder { body, mu_s, mu_k, roll, slide, basis: Basis::new(), side };
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
    ) -> Option<SlipEnd> {
        let piece = self.families[point.side].find(point.angle)?;
        let [turned, elapsed, rate, next, last] = piece.ends.at(point.angle);
        let lifts_off = piece.kind == Kind::LiftOff;
        let sigma = side_of(point.side).sign();
        let theta = theta + turned;
        let (end_sin, end_cos) = sincos(theta);
        let w = 1.0 - self.h * end_cos * (rate * rate);
        let slip = if lifts_off {
            let lever = |sin: f64, cos: f64| 1.0 + self.h * (cos + self.mu * sigma * sin);
            sigma * (rate * lever(end_sin, end_cos) - theta_rate * lever(sin, cos)) - self.mu * elapsed
        } else {
            0.0
        };
        let sure = if lifts_off { slip > DOUBT } else { w > DOUBT };
        let ahead = match piece.kind {
            Kind::Rest | Kind::LiftOff => Ahead::Open,
            Kind::RestAndRoll { stop, side } => {
                Ahead::Roll(RollAhead { stop, side, turned: next, elapsed: last })
            }
        };
        sure.then_some(SlipEnd {
            event: SlideEvent {
                elapsed,
                theta: sigma * theta,
                theta_rate: sigma * rate,
                slip,
                direction: (sigma * end_sin, end_cos),
                lifts_off,
            },
            ahead,
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
        let ends: Vec<f64> = pieces.iter().map(|piece| piece.ends.right).collect();
        Self { pieces, slots: Slots::new(0.0, TAU, &ends) }
    }

    fn find(&self, angle: f64) -> Option<&Piece> {
        let index = self.slots.find(angle, |index| self.pieces.get(index).map(|piece| piece.ends.right))?;
        let piece = &self.pieces[index];
        (angle >= piece.ends.left).then_some(piece)
    }
}

impl Builder<'_> {
    fn fill(&self, left: f64, right: f64, pieces: &mut Vec<Piece>) {
        let starts = self.basis.nodes(left, right).map(|angle| self.start(angle));
        if starts.iter().all(Option::is_none) {
            return;
        }
        let piece = |with_next| self.piece(left, right, &starts, with_next);
        if let Some(piece) = piece(true) {
            pieces.push(piece);
        } else if right - left > 2.0 * NARROWEST {
            let middle = 0.5 * (left + right);
            self.fill(left, middle, pieces);
            self.fill(middle, right, pieces);
        } else {
            pieces.extend(piece(false));
        }
    }

    /// The piece between two angles, with what follows the slide or without, if everything on it is the same.
    fn piece(
        &self,
        left: f64,
        right: f64,
        starts: &[Option<SlideStart>; NODES],
        with_next: bool,
    ) -> Option<Piece> {
        let mut ends = [[0.0; 5]; NODES];
        let mut levels = [0.0; NODES];
        let mut kind = None;
        for ((start, end), level) in starts.iter().zip(&mut ends).zip(&mut levels) {
            let start = (*start)?;
            let event = self.slide.follow(start)?;
            let (this, next) = self.next(&event, with_next);
            if *kind.get_or_insert(this) != this {
                return None;
            }
            let turned = (event.theta - start.theta).abs();
            *end = [turned, event.elapsed, event.theta_rate.abs(), next[0], next[1]];
            *level = self.slide.level(&start);
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
        Some(Piece { kind: kind?, ends: self.basis.through(left, right, &ends)? })
    }

    /// The kind of an end, and the numbers of what follows.
    fn next(&self, event: &SlideEvent, with_next: bool) -> (Kind, [f64; 2]) {
        if event.lifts_off {
            return (Kind::LiftOff, [0.0; 2]);
        }
        let sigma = side_of(self.side).sign();
        let (theta, rate) = (sigma * event.theta, sigma * event.theta_rate);
        match self.roll.follow(theta, rate, event.direction.1, None) {
            Some(RollEnd::Slip { elapsed, theta: end, point, stop, .. }) if with_next => {
                (Kind::RestAndRoll { stop, side: point.side }, [end - theta, elapsed])
            }
            _ => (Kind::Rest, [0.0; 2]),
        }
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
