//! The slides out of rolling of one body: a family with one parameter.
//!
//! Rolling slips on a curve of the phase plane, |F| = μs N, with η′ = 0. What follows, up to the next event, is therefore
//! a function of the angle of the slip alone: where the slide ends, when, and how fast the hoop turns there. On pieces
//! of the curve these functions are polynomials, interpolated at Chebyshev nodes through slides that the
//! [`SlideTable`] has followed.
//!
//! That a piece has no other event between its nodes follows from the order of slides, compared from each node to the next. Slides in the (ϑ, u) plane do not cross, so
//! that on a piece along which they leave the curve to one side everything linear in u has its extremes, at every
//! angle, on the first and the last slide of the piece. If these two agree on the signs at the ends of all cells (η″ falls
//! through zero but once, and 1 − h cos ϑ u stays positive), every slide between them does. What is not proved is left
//! out, and such slides are followed one by one.

use core::f64::consts::TAU;

use crate::math::trig::sincos;
use crate::mechanics::equations::{RollingLaw, SlidingLaw, contact};
use crate::model::hoop::Heavy;
use crate::model::mode::Direction;

use super::interpolant::{Basis, Interpolant, NODES, Slots, Tolerance};
use super::roll::{RollAhead, RollEnd, RollTable, SlipPiece, SlipPoint, direction_of};
use super::slide::{SlideEvent, SlideStart, SlideTable};

/// Pieces are not halved below this width.
const NARROWEST: f64 = 1.0 / 128.0;

/// A slide that may be with or without lift-off, within this part of the terms of both, is followed on its own.
const UNCERTAIN_END: f64 = 1e-9;

/// End of a slide out of rolling.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlipEnd {
    /// The end of the slide.
    pub(super) event: SlideEvent,
    /// Precomputed data of the phase behind it.
    pub(super) ahead: Ahead,
}

/// Precomputed data of the phase that follows.
#[derive(Clone, Copy, Debug)]
pub(super) enum Ahead {
    /// Nothing.
    Open,
    /// If the hoop rolls, and slips where the others of the family do.
    Roll(RollAhead),
}

/// A piece of the curve from which all slides end alike.
#[derive(Clone, Debug)]
struct Slides {
    lifts_off: bool,
    /// Angle and time of the slide, and the rate at its end.
    ends: Interpolant<3>,
}

/// A piece of the curve from which all slides come to rest and, if the hoop then rolls, slip before the same stop.
#[derive(Clone, Debug)]
struct Rolls {
    stop: usize,
    side: usize,
    /// Angle and time of the roll.
    ends: Interpolant<2>,
}

/// Pieces of the curve, in order.
#[derive(Clone, Debug)]
struct Pieces<T> {
    pieces: Vec<T>,
    slots: Slots,
}

#[derive(Clone, Debug)]
struct Family {
    slides: Pieces<Slides>,
    rolls: Pieces<Rolls>,
}

/// The slides out of rolling, by the side towards which they slip.
#[derive(Clone, Debug)]
pub(super) struct SlipTable {
    /// Of slides towards either side.
    laws: [SlidingLaw; 2],
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
            let mut slides = Vec::new();
            for SlipPiece { left: from, right: to, .. } in roll.slips(side) {
                let mut left = from;
                for bound in slide.bounds(slips_to(side)).into_iter().chain([to]) {
                    if bound > left && bound <= to {
                        builder.slides(left, bound, &mut slides);
                        left = bound;
                    }
                }
            }
            let mut rolls = Vec::new();
            for piece in slides.iter().filter(|piece| !piece.lifts_off) {
                builder.rolls(&piece.ends, (piece.ends.left, piece.ends.right), &mut rolls);
            }
            Family {
                slides: Pieces::new(slides, |piece| piece.ends.right),
                rolls: Pieces::new(rolls, |piece| piece.ends.right),
            }
        });
        Self { laws: Direction::ALL.map(|side| SlidingLaw::of_body(*body, mu_k, side)), families }
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
        let family = &self.families[point.side];
        let Slides { lifts_off, ends } =
            family.slides.find(point.angle, |piece| (piece.ends.left, piece.ends.right))?;
        let [turned, elapsed, rate] = ends.at(point.angle);
        let lifts_off = *lifts_off;
        let sigma = slips_to(point.side).sign();
        let theta = theta + turned;
        let (end_sin, end_cos) = sincos(theta);
        let law = &self.laws[point.side];
        let w = contact(1.0, law.body.h, end_cos * (rate * rate));
        let slip = if lifts_off {
            let turned = rate * law.lever(end_sin, end_cos) - theta_rate * law.lever(sin, cos);
            sigma * turned - sigma * law.friction * elapsed
        } else {
            0.0
        };
        let (u, most) = (rate * rate, rate.abs().max(theta_rate.abs()));
        let sure = if lifts_off {
            slip > UNCERTAIN_END * (1.0 + most)
        } else {
            w > UNCERTAIN_END * (1.0 + law.body.h * u)
        };
        let rolls = family.rolls.find(point.angle, |piece| (piece.ends.left, piece.ends.right));
        let ahead = rolls.filter(|_| !lifts_off).map_or(Ahead::Open, |piece| {
            let [turned, elapsed] = piece.ends.at(point.angle);
            Ahead::Roll(RollAhead { stop: piece.stop, side: piece.side, turned, elapsed })
        });
        sure.then_some(SlipEnd {
            event: SlideEvent {
                elapsed,
                theta: sigma * theta,
                theta_rate: sigma * rate,
                slip,
                direction: (sigma * end_sin, end_cos),
                lifts_off,
                turns: None,
            },
            ahead,
        })
    }

    /// Number of pieces.
    pub(super) fn pieces(&self) -> usize {
        self.families.iter().map(|family| family.slides.pieces.len() + family.rolls.pieces.len()).sum()
    }
}

/// The direction of the slip through a margin, in the frame of motion.
fn slips_to(side: usize) -> Direction {
    direction_of(side, 1.0)
}

impl<T> Pieces<T> {
    fn new(pieces: Vec<T>, end: impl Fn(&T) -> f64) -> Self {
        let ends: Vec<f64> = pieces.iter().map(end).collect();
        Self { pieces, slots: Slots::new(0.0, TAU, &ends) }
    }

    #[inline]
    fn find(&self, angle: f64, bounds: impl Fn(&T) -> (f64, f64)) -> Option<&T> {
        let index = self.slots.find(angle, |index| Some(bounds(self.pieces.get(index)?).1))?;
        self.pieces.get(index).filter(|piece| angle >= bounds(piece).0)
    }
}

/// Result for an interval.
enum Fit<T> {
    Found(T),
    /// Its halves may do better.
    Divide,
    /// No slide here can be interpolated.
    Nothing,
}

impl Builder<'_> {
    /// Adds the slides from an interval of the curve.
    fn slides(&self, left: f64, right: f64, pieces: &mut Vec<Slides>) {
        match self.fit_slides(left, right) {
            Fit::Found(piece) => pieces.push(piece),
            Fit::Divide if right - left > 2.0 * NARROWEST => {
                let middle = 0.5 * (left + right);
                self.slides(left, middle, pieces);
                self.slides(middle, right, pieces);
            }
            Fit::Divide | Fit::Nothing => {}
        }
    }

    /// Adds the rolls behind the slides of a piece.
    fn rolls(&self, slides: &Interpolant<3>, (left, right): (f64, f64), pieces: &mut Vec<Rolls>) {
        match self.fit_rolls(slides, left, right) {
            Fit::Found(piece) => pieces.push(piece),
            Fit::Divide if right - left > 2.0 * NARROWEST => {
                let middle = 0.5 * (left + right);
                self.rolls(slides, (left, middle), pieces);
                self.rolls(slides, (middle, right), pieces);
            }
            Fit::Divide | Fit::Nothing => {}
        }
    }

    fn fit_slides(&self, left: f64, right: f64) -> Fit<Slides> {
        let nodes = self.basis.nodes(left, right);
        let probes = [nodes[0], nodes[NODES / 2], nodes[NODES - 1]];
        let ends = probes.map(|angle| self.slide.follow_one_way(self.start(angle)?));
        match ends.map(|end| end.map(|end| end.lifts_off)) {
            [None, None, None] => return Fit::Nothing,
            [Some(first), Some(middle), Some(last)] if first == middle && middle == last => {}
            _ => return Fit::Divide,
        }
        self.same_slides(left, right, &nodes).map_or(Fit::Divide, Fit::Found)
    }

    /// The slides between two angles, if they can be shown to end alike.
    fn same_slides(&self, left: f64, right: f64, nodes: &[f64; NODES]) -> Option<Slides> {
        let mut ends = [[0.0; 3]; NODES];
        let mut levels = [0.0; NODES];
        let mut lifts_off = None;
        for ((angle, end), level) in nodes.iter().zip(&mut ends).zip(&mut levels) {
            let start = self.start(*angle)?;
            let event = self.slide.follow_one_way(start)?;
            if *lifts_off.get_or_insert(event.lifts_off) != event.lifts_off {
                return None;
            }
            *end = [(event.theta - start.theta).abs(), event.elapsed, event.theta_rate.abs()];
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
        let [first, last] = [self.start(left)?, self.start(right)?];
        let [first_passings, last_passings] = [first, last].map(|start| self.slide.passings(&start, reach));
        let passings = [first_passings?, last_passings?];
        // A slide from the end of a cell does not pass through that cell.
        let common = passings[0][0].angle.max(passings[1][0].angle);
        let common =
            if first.theta_rate > 0.0 { common } else { passings[0][0].angle.min(passings[1][0].angle) };
        let [first, last] =
            passings.each_ref().map(|passings| passings.iter().skip_while(|passing| passing.angle != common));
        let mut falling = false;
        for (a, b) in first.zip(last) {
            let rising = a.slip_acceleration >= 0.0 || b.slip_acceleration >= 0.0;
            if falling && rising {
                return None;
            }
            falling = a.slip_acceleration <= 0.0 || b.slip_acceleration <= 0.0;
            let passed = a.turned.max(b.turned) < longest;
            if passed && (a.contact <= 0.0 || b.contact <= 0.0) {
                return None;
            }
        }
        Some(Slides {
            lifts_off: lifts_off?,
            ends: self.basis.through(left, right, &ends, &[Tolerance::ROUNDING; 3])?,
        })
    }

    fn fit_rolls(&self, slides: &Interpolant<3>, left: f64, right: f64) -> Fit<Rolls> {
        let roll = |angle: f64| {
            let [turned, _, rate] = slides.at(angle);
            let theta = angle + turned;
            match self.roll.follow((theta, rate), sincos(theta).1, false, None)? {
                RollEnd::Slip { elapsed, theta: end, point, stop, .. } => {
                    Some(((stop, point.side), [end - theta, elapsed]))
                }
                RollEnd::Never => None,
            }
        };
        let nodes = self.basis.nodes(left, right);
        let probes =
            [nodes[0], nodes[NODES / 2], nodes[NODES - 1]].map(|angle| roll(angle).map(|(end, _)| end));
        let (stop, side) = match probes {
            [None, None, None] => return Fit::Nothing,
            [Some(first), Some(middle), Some(last)] if first == middle && middle == last => first,
            _ => return Fit::Divide,
        };
        let mut ends = [[0.0; 2]; NODES];
        for (angle, numbers) in nodes.into_iter().zip(&mut ends) {
            match roll(angle) {
                Some((end, found)) if end == (stop, side) => *numbers = found,
                _ => return Fit::Divide,
            }
        }
        match self.basis.through(left, right, &ends, &[Tolerance::ROUNDING; 2]) {
            Some(ends) => Fit::Found(Rolls { stop, side, ends }),
            None => Fit::Divide,
        }
    }

    /// The slide that begins at this angle of the curve, in its own frame.
    fn start(&self, angle: f64) -> Option<SlideStart> {
        let (sin, cos) = sincos(angle);
        let u = self.roll.limit(self.side, angle)?;
        if !(u > 0.0 && contact(1.0, self.body.h, cos * u) > UNCERTAIN_END * (1.0 + self.body.h * u)) {
            return None;
        }
        let law: &RollingLaw = self.roll.law();
        let normal = law.forces_at((sin, cos), [1.0, u], law.denominator_at(cos)).normal;
        if (self.mu_s - self.mu_k) * normal <= UNCERTAIN_END {
            return None;
        }
        let sigma = slips_to(self.side).sign();
        Some(SlideStart {
            theta: sigma * angle,
            theta_rate: sigma * u.sqrt(),
            slip: 0.0,
            direction: (sigma * sin, cos),
        })
    }
}
