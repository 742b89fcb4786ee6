//! A slide, followed piece by piece to its event.
//!
//! Everything is seen in the frame of motion, ϑ growing. On a piece
//!
//! - 1 − h cos ϑ u can fall through zero only where sin ϑ < 0, since there its derivative is h sin ϑ θ′³: where sin ϑ keeps its sign,
//!   or turns from positive to negative, its sign at the end tells whether it has; over the top its sign there tells;
//! - the signs of η″ tell whether η′ is monotone, or has one extremum: its values there and at the end tell whether it has
//!   vanished.

use crate::mechanics::equations::{SlidingLaw, contact};

use super::super::piece::{End, Piece, UNCERTAIN, Way, Waypoint};
use super::super::slide::{SlideEnd, SlideEvent, Turns};
use super::cell::Cell;
use super::expansion::{Expansion, Signs};
use super::memory::{Contents, Memory};
use super::step::{Step, rotated};
use super::turn::Turn;

/// Most pieces: a slide over more than a few turns is left to the exact solver.
const MOST_PIECES: usize = 512;

/// A turning point nearer than this part of the width on which u has converged is the centre of the next piece.
const NEAR: f64 = 0.7;

/// A turning point behind is the centre of the next piece if it is nearer than this part of the piece.
const BEHIND: f64 = 0.5;

/// No cell holds a slide whose u changes by more than itself over this z.
const STEEP: f64 = 0.25;

/// How a slide is seen: perhaps mirrored.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame<'a> {
    /// The laws for σ = −1 and σ = +1.
    pub(super) laws: &'a [SlidingLaw; 2],
    /// −1 where the frame is mirrored.
    pub(super) sign: f64,
    /// The angle at which the slide is.
    pub(super) theta: f64,
    /// Sign of η′.
    pub(super) sigma: f64,
    /// The constant of the first integral.
    pub(super) integral: f64,
}

impl Frame<'_> {
    fn mirrored(self) -> Self {
        let Self { laws, sign, theta, sigma, integral } = self;
        Self { laws, sign: -sign, theta: -theta, sigma: -sigma, integral: -integral }
    }

    const fn law(&self) -> &SlidingLaw {
        &self.laws[if self.sigma > 0.0 { 1 } else { 0 }]
    }

    const fn way<'b, P: Piece>(&'b self, piece: &'b P) -> Way<'b, P> {
        Way { law: self.law(), piece, forward: 1.0, sigma: self.sigma, integral: self.integral }
    }
}

fn mirrored((sin, cos): (f64, f64)) -> (f64, f64) {
    (-sin, cos)
}

/// Follows a slide from a place to its event, or to where it is after the time that is `allowed`; `from_limit` where η′ = η″ = 0 at
/// the place. None where a sign is in doubt, P comes close to zero, or the slide takes more pieces.
pub(super) fn follow(
    mut frame: Frame<'_>,
    mut here: Waypoint,
    from_limit: bool,
    allowed: f64,
    memory: &Memory,
) -> Option<SlideEnd> {
    let known = memory.recall();
    let mut turns = None;
    for piece in 0..MOST_PIECES {
        let (end, mut at, rate);
        let is_cut;
        match Ahead::of(&frame, &here, from_limit && piece == 0, known)? {
            Ahead::Turn { before, place, turn } => {
                // Towards larger angles, and back.
                let [from, middle, to] = [place.z, 0.0, 1.0].map(|y| turn.direction(y).0);
                if (place.z < 0.0 && passes_top(from, middle)) || passes_top(-middle, -to) {
                    return None;
                }
                let way = before.way(&turn);
                (end, at) = pass_turn(&way, &place)?;
                is_cut = at.elapsed > allowed;
                if is_cut {
                    at = way.at_time(&place, &at, allowed)?;
                }
                rate = turn.rate(at.z, at.u);
                if place.z < 0.0 && at.z > 0.0 {
                    turns = Some(Turns::another(turns, before.sign * before.theta));
                }
                frame = Frame { theta: before.theta + turn.turned_by(at.z), ..before };
                if end == End::Open && !is_cut {
                    frame = frame.mirrored();
                    here = Waypoint { direction: mirrored(at.direction), ..at };
                }
            }
            Ahead::Step { place, step } => {
                (end, at) = pass_step(&frame, &place, &step)?;
                let way = frame.way(&step);
                is_cut = at.elapsed > allowed;
                if is_cut {
                    at = way.at_time(&place, &at, allowed)?;
                }
                rate = step.rate(at.z, at.u);
                frame.theta += step.turned_by(at.z) - step.turned_by(place.z);
                here = at;
            }
        }
        if end == End::Open && !is_cut {
            continue;
        }
        let lifts_off = end == End::LiftOff && !is_cut;
        let event = SlideEvent {
            elapsed: at.elapsed,
            theta: frame.theta,
            theta_rate: rate,
            slip: if lifts_off || is_cut { frame.sigma * at.slip } else { 0.0 },
            direction: at.direction,
            lifts_off,
            turns: None,
        };
        let event = SlideEvent { turns, ..event.mirrored(frame.sign) };
        return Some(if is_cut { SlideEnd::Cut(event) } else { SlideEnd::Event(event) });
    }
    None
}

/// The part of a slide that lies ahead.
enum Ahead<'a> {
    /// A turn about a turning point, in the frame before it, whose angle is that of the turning point, with the place in it.
    Turn { before: Frame<'a>, place: Waypoint, turn: Turn },
    /// A step, with the place in it.
    Step { place: Waypoint, step: Step },
}

impl<'a> Ahead<'a> {
    /// What lies ahead of a place. None where P is not known to be positive.
    fn of(frame: &Frame<'a>, here: &Waypoint, from_limit: bool, known: Option<&Contents>) -> Option<Self> {
        if from_limit {
            // It knows its signs, however short a turning point makes it.
            let expansion = Expansion::new(frame.law(), frame.sigma, here.direction, here.u);
            return Self::own_step(&expansion, here, true);
        }
        if let Some(step) = known.and_then(|known| Self::through_cell(frame, here, known)) {
            return Some(step);
        }
        let expansion = Expansion::new(frame.law(), frame.sigma, here.direction, here.u);
        match turn_about(frame, here, &expansion) {
            Some((before, place, turn)) => Some(Self::Turn { before, place, turn }),
            None => Self::own_step(&expansion, here, false),
        }
    }

    /// To the end of a cell.
    fn through_cell(frame: &Frame<'a>, here: &Waypoint, known: &Contents) -> Option<Self> {
        let ((sin, cos), law) = (here.direction, frame.law());
        // du/dz: where u is steep it is not known to stay away from zero, and this is known soonest.
        let slope = 2.0 * law.drive(sin, cos) * contact(1.0, law.body.h, cos * here.u);
        if STEEP * slope.abs() > here.u {
            return None;
        }
        Cell::about(frame.theta).into_iter().find_map(|number| {
            let cell = known.cell(law, frame.sigma, number)?;
            let place = Waypoint { z: cell.place(here.direction), ..*here };
            Some(Self::Step { step: cell.step(&place)?, place })
        })
    }

    /// Until its series ends.
    fn own_step(expansion: &Expansion, here: &Waypoint, from_limit: bool) -> Option<Self> {
        let step = Step::new(expansion, here.direction, expansion.reach(0), from_limit)?;
        Some(Self::Step { place: Waypoint { z: 0.0, ..*here }, step })
    }
}

/// The first step of a slide out of η′ = η″ = 0, if no event ends it: the frame and the place behind it, and θ′ there in this frame.
pub(super) fn leave_limit<'a>(frame: Frame<'a>, here: &Waypoint) -> Option<(Frame<'a>, Waypoint, f64)> {
    let expansion = Expansion::new(frame.law(), frame.sigma, here.direction, here.u);
    let step = Step::new(&expansion, here.direction, expansion.reach(0), true)?;
    let (end, at) = pass_step(&frame, here, &step)?;
    let behind = Frame { theta: frame.theta + step.turned_by(at.z), ..frame };
    (end == End::Open).then(|| (behind, at, step.rate(at.z, at.u)))
}

/// Passes a step to its end, or to the event before.
fn pass_step(frame: &Frame<'_>, here: &Waypoint, step: &Step) -> Option<(End, Waypoint)> {
    let way = frame.way(step);
    let signs = (step.signs, step.doubt);
    if !passes_top(here.direction.0, step.direction(1.0).0) {
        return pass(&way, (here, 1.0), false, signs);
    }
    let (sin, cos) = step.direction;
    let top = (-sin / ((1.0 + cos) * step.width)).clamp(here.z, 1.0);
    let (h, u) = (frame.law().body.h, step.u(top));
    let w = contact(1.0, h, u);
    if w.abs() < UNCERTAIN * (1.0 + h * u) {
        return None;
    }
    if w < 0.0 { pass(&way, (here, top), false, signs) } else { pass(&way, (here, 1.0), true, signs) }
}

/// Whether a slide that turns towards larger angles, from a place with this sin ϑ to another less than half a turn ahead, passes the
/// top.
fn passes_top(from: f64, to: f64) -> bool {
    from < 0.0 && to >= 0.0
}

/// Passes a turn from a place to y = 1, or to the event before.
fn pass_turn(way: &Way<'_, Turn>, here: &Waypoint) -> Option<(End, Waypoint)> {
    let Turn { signs, doubt, .. } = *way.piece;
    match signs {
        // Towards the turning point, where u = 0, the signs come in the opposite order.
        Signs::Rising | Signs::Falling if here.z < 0.0 => {
            match pass(way, (here, 0.0), true, (signs.reversed(), doubt))? {
                (End::Open, middle) => pass(way, (&middle, 1.0), false, (signs, doubt)),
                ended => Some(ended),
            }
        }
        Signs::Rising | Signs::Falling | Signs::Positive | Signs::Negative | Signs::Unknown => {
            pass(way, (here, 1.0), false, (signs, doubt))
        }
    }
}

/// Passes a piece from a place to another, or to the event before. `held` says that the normal force cannot vanish. None where it
/// is in doubt.
fn pass<P: Piece>(
    way: &Way<'_, P>,
    (here, to): (&Waypoint, f64),
    held: bool,
    (signs, doubt): (Signs, f64),
) -> Option<(End, Waypoint)> {
    let (h, u) = (way.law.body.h, way.piece.u(to));
    let w = if held { 1.0 } else { contact(1.0, h, way.piece.direction(to).1 * u) };
    if !held && w.abs() < UNCERTAIN * (1.0 + h * u) {
        return None;
    }
    let lifts_off = w < 0.0;
    let there = if lifts_off { way.lift_off(here, to)? } else { way.at(here, to)? };
    // Where the piece ends just at a zero of η′, which may be a touch, rounding would decide.
    if there.slip.abs() <= UNCERTAIN * way.size_of_slip(&there) {
        return None;
    }
    let from_rest = here.slip <= 0.0;
    // The change may lie behind.
    let signs = match signs {
        Signs::Rising if here.slip_acceleration > doubt => Signs::Positive,
        Signs::Falling if here.slip_acceleration < -doubt => Signs::Negative,
        signs => signs,
    };
    match signs {
        Signs::Unknown => return None,
        // η′ must rise from zero.
        Signs::Negative | Signs::Rising if from_rest => return None,
        Signs::Falling if from_rest && here.slip_acceleration < 0.0 => return None,
        Signs::Positive | Signs::Negative | Signs::Falling | Signs::Rising => {}
    }
    if there.slip <= 0.0 {
        return Some((End::Rest, way.rest(here, &there)?));
    }
    match signs {
        Signs::Positive | Signs::Negative => {}
        // Where η″ is next to zero it is not known how it changes its sign; η′ changes there by no more than this.
        Signs::Falling => {
            if there.slip <= doubt * (there.elapsed - here.elapsed) {
                return None;
            }
        }
        Signs::Rising => {
            if let Some(least) = way.least(here, &there)? {
                // Where it hardly vanishes, or hardly does not, rounding would decide.
                let uncertain = doubt * (there.elapsed - here.elapsed) + UNCERTAIN * way.size_of_slip(&least);
                if least.slip.abs() <= uncertain {
                    return None;
                }
                if least.slip < 0.0 {
                    return Some((End::Rest, way.rest(here, &least)?));
                }
            }
        }
        Signs::Unknown => return None,
    }
    Some((if lifts_off { End::LiftOff } else { End::Open }, there))
}

/// The turn about the turning point next to the centre of an expansion, ahead or behind, if it is near; with the frame before it,
/// whose angle is that of the turning point, and the place in it.
fn turn_about<'a>(
    frame: &Frame<'a>,
    here: &Waypoint,
    expansion: &Expansion,
) -> Option<(Frame<'a>, Waypoint, Turn)> {
    let reach = expansion.reach(0);
    if here.u > NEAR * reach * expansion.u[1].abs() {
        return None;
    }
    let z = expansion.zero(reach)?;
    let before = if expansion.u[1] < 0.0 { *frame } else { frame.mirrored() };
    let is_ahead = before.sign == frame.sign;
    let direction = if is_ahead { here.direction } else { mirrored(here.direction) };
    let distance = z.abs();
    let there = mirrored(rotated(direction, distance));
    let behind = before.mirrored();
    let turn = Turn::new(&Expansion::new(behind.law(), behind.sigma, there, 0.0), there)?;
    let part = distance / turn.width;
    let y = if is_ahead { -part.sqrt() } else { part.sqrt() };
    let before = Frame { theta: before.theta + 2.0 * libm::atan(distance), ..before };
    // Behind, a step leads farther than the rest of the turn.
    let farthest = if is_ahead { 1.0 } else { BEHIND };
    (part < farthest).then_some((before, Waypoint { z: y, direction, ..*here }, turn))
}
