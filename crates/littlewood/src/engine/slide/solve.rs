//! A slide, followed piece by piece to its event (docs/engine.md), in the frame of motion, ϑ
//! growing.
//!
//! 1 − h cos ϑ u falls through zero only where sin ϑ < 0: its sign at the end of a piece, or at the
//! top, tells whether it has. The signs of η″ tell whether η′ is monotone, or has one extremum. In
//! a libration, and without kinetic friction, θ′² is periodic in time: periods without an event are
//! passed at once.

use core::f64::consts::{PI, TAU};

use crate::engine::fallback::Fallback;
use crate::mechanics::{SlidingLaw, contact};

use super::regular::{RegularSegment, rotated};
use super::segment::{SIGN_TOLERANCE, SegmentContext, SlidePoint, SlideSegment, slip_scale};
use super::series::{Expansion, SignPattern};
use super::table::{AngleInterval, HALVINGS, INTERVALS, SlideTables, edge_angle_near};
use super::turning::TurningSegment;
use super::{SlideEnd, SlideEvent};

/// Most pieces: a slide over more than some 16 turns is left to the exact solver, which sums whole
/// turns.
const MAX_SEGMENTS: usize = 512;

/// A slide over more turns than this is left to the exact solver.
const MAX_TURNS: f64 = 16.0;

/// So is a libration over more periods: the rounding of its period would be multiplied by as many.
const MAX_PERIODS: f64 = 64.0;

/// Fewer periods are followed one by one.
const MIN_PERIODS_TO_SKIP: f64 = 3.0;

/// A place is the same after a period if its angle is the same to this.
const PERIOD_TOLERANCE: f64 = 1e-12;

/// A turning point nearer than this part of the width on which u has converged is the centre of the
/// next piece.
const MAX_TURN_DISTANCE: f64 = 0.7;

/// A turning point behind is the centre of the next piece if it is nearer than this part of the
/// piece.
const MAX_PART_BEHIND_TURN: f64 = 0.5;

/// A tile holds no slide whose u changes by more than itself over this z, its halves none for which
/// that is half as much, and so on.
const MIN_DOUBLING_DISTANCE: f64 = 0.25;

/// How a slide is seen: perhaps mirrored.
#[derive(Clone, Copy, Debug)]
pub(in crate::engine) struct MotionFrame<'a> {
    /// The laws for σ = −1 and σ = +1, as they are and mirrored.
    pub(in crate::engine) laws: &'a [[SlidingLaw; 2]; 2],
    /// −1 where the frame is mirrored.
    pub(in crate::engine) sign: f64,
    pub(in crate::engine) theta: f64,
    /// Sign of η′.
    pub(in crate::engine) sigma: f64,
    pub(in crate::engine) integral: f64,
}

impl MotionFrame<'_> {
    fn mirrored(self) -> Self {
        let Self {
            laws,
            sign,
            theta,
            sigma,
            integral,
        } = self;
        Self {
            laws,
            sign: -sign,
            theta: -theta,
            sigma: -sigma,
            integral: -integral,
        }
    }

    const fn law(&self) -> &SlidingLaw {
        &self.laws[if self.sign < 0.0 { 1 } else { 0 }][if self.sigma > 0.0 { 1 } else { 0 }]
    }

    /// What η′ loses in a time, but for what it has back after a period.
    fn loss(&self, elapsed: f64) -> f64 {
        self.sigma * self.law().drag() * elapsed
    }

    const fn way<'b, P: SlideSegment>(&'b self, piece: &'b P) -> SegmentContext<'b, P> {
        SegmentContext {
            law: self.law(),
            piece,
            sigma: self.sigma,
            integral: self.integral,
        }
    }
}

fn mirrored((sin, cos): (f64, f64)) -> (f64, f64) {
    (-sin, cos)
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum End {
    /// The slide goes on.
    Open,
    /// η′ = 0.
    Rest,
    /// w = 0.
    LiftOff,
    /// By a limit of time.
    Cut,
}

#[derive(Clone, Copy, Debug)]
struct SegmentResult {
    end: End,
    at: SlidePoint,
    /// The least η′ behind the beginning.
    least: f64,
}

impl SegmentResult {
    const fn to(end: End, at: SlidePoint) -> Self {
        Self {
            end,
            at,
            least: at.slip,
        }
    }
}

/// A place to which periodic slides come back.
#[derive(Clone, Copy, Debug)]
struct PeriodStart {
    sign: f64,
    theta: f64,
    elapsed: f64,
    /// Turning points before it.
    turns: f64,
    /// Number of the piece that ended there.
    piece: usize,
}

struct Slide<'a> {
    frame: MotionFrame<'a>,
    here: SlidePoint,
    /// The edge of tiles at which it is.
    edge: Option<usize>,
    is_behind_turn: bool,
    /// Turning points so far.
    turns: f64,
    mark: Option<PeriodStart>,
    /// The least η′ since the mark.
    least: f64,
    pieces: usize,
    allowed: f64,
    cells: Option<&'a SlideTables>,
}

/// Follows a slide from a place to its event, or to where it is after the time that is `allowed`;
/// `from_limit` where η′ = η″ = 0 at the place. `cells` are those that are kept.
pub(in crate::engine) fn follow(
    frame: MotionFrame<'_>,
    here: SlidePoint,
    from_limit: bool,
    allowed: f64,
    cells: Option<&SlideTables>,
) -> Result<SlideEnd, Fallback> {
    let mut slide = Slide {
        frame,
        here,
        edge: None,
        is_behind_turn: false,
        turns: 0.0,
        mark: None,
        least: here.slip,
        pieces: 0,
        allowed,
        cells,
    };
    if from_limit {
        // Its signs are known, however short a turning point makes the step.
        let expansion =
            Expansion::new(slide.frame.law(), slide.frame.sigma, here.direction, here.u);
        if let Some(end) = slide.own_step(&expansion, true)? {
            return Ok(end);
        }
    }
    while slide.pieces < MAX_SEGMENTS {
        slide.pieces += 1;
        if let Some(end) = slide.pass_piece()? {
            return Ok(end);
        }
    }
    Err(Fallback::TooLong)
}

impl<'a> Slide<'a> {
    /// Passes the next piece: a step in a cell, a turn, or a step by a new series.
    fn pass_piece(&mut self) -> Result<Option<SlideEnd>, Fallback> {
        if let Some(cells) = self.cells {
            if let Some(end) = self.cross_tiles(cells)? {
                return Ok(Some(end));
            }
            if let Some(end) = self.in_cell(cells) {
                return end;
            }
        }
        let Self { frame, here, .. } = *self;
        let expansion = Expansion::new(frame.law(), frame.sigma, here.direction, here.u);
        // The turn that is behind has led as far as it does.
        let is_done = self.is_behind_turn && expansion.u[1] > 0.0;
        let turn = if is_done {
            None
        } else {
            turn_about(&frame, &here, &expansion)
        };
        match turn {
            Some((before, place, turn)) => self.pass_turn(before, &place, &turn),
            None => self.own_step(&expansion, false),
        }
    }

    /// Passes a step in a cell. None where no cell has one.
    fn in_cell(&mut self, cells: &'a SlideTables) -> Option<Result<Option<SlideEnd>, Fallback>> {
        let Self { frame, here, .. } = *self;
        let ((sin, cos), law) = (here.direction, frame.law());
        // du/dz: where u is steep tiles must be narrow, or there is none.
        let slope = 2.0 * law.drive(sin, cos) * contact(1.0, law.body.h, cos * here.u);
        let halvings = (0..=HALVINGS)
            .find(|k| MIN_DOUBLING_DISTANCE * slope.abs() <= here.u * (1_u32 << k) as f64)?;
        let mut tiles =
            (halvings..=HALVINGS).flat_map(|halvings| AngleInterval::about(frame.theta, halvings));
        let (tile, (place, step)) =
            tiles.find_map(|tile| Some((tile, cells.get(law, frame.sigma, tile)?.step(&here)?)))?;
        let edge = step.exit.is_some().then(|| tile.exit());
        Some(self.pass_step(&place, &step, edge))
    }

    /// Crosses whole tiles up to the first with an event, or up to a place where no tile can be
    /// crossed.
    fn cross_tiles(&mut self, cells: &'a SlideTables) -> Result<Option<SlideEnd>, Fallback> {
        let Self { frame, allowed, .. } = *self;
        let law = frame.law();
        let mut halvings = 0;
        while let Some(edge) = self.edge
            && self.pieces < MAX_SEGMENTS
            && let Some((tile, cell, level, u)) =
                cells.crossing((law, frame.sigma), (edge, halvings), self.here.u)
        {
            halvings = tile.halvings.saturating_sub(1);
            let here = &self.here;
            let time = cell.time(level);
            let elapsed = here.elapsed + time;
            let exit = cell.law_at_exit();
            let at = SlidePoint {
                z: 1.0,
                u,
                elapsed,
                slip: frame.sigma * (frame.integral + u.sqrt() * exit.lever - law.drag() * elapsed),
                slip_acceleration: frame.sigma * (exit.alpha + exit.beta * u),
                direction: exit.direction,
            };
            let h = law.body.h;
            // The top is an edge.
            let stays = contact(1.0, h, exit.direction.1 * u) > SIGN_TOLERANCE * (1.0 + h * u);
            let slips = |slip: f64, u: f64| slip > SIGN_TOLERANCE * slip_scale(u, frame.integral);
            let at_ends = here.slip.min(at.slip);
            let (signs, doubt) = cell.signs(level);
            // η′ is monotone, has a maximum, or a minimum that is no less.
            let least = match signs {
                SignPattern::Positive | SignPattern::Negative => Some(at_ends),
                SignPattern::Falling => (at.slip > doubt * time).then_some(at_ends),
                SignPattern::Rising if here.slip_acceleration > doubt => Some(at_ends),
                SignPattern::Rising => {
                    let least = here.slip + time * cell.least_slip_acceleration(level);
                    // On a tile that is crossed u is less than twice that in its middle.
                    slips(least, 2.0 * level).then_some(least.min(at_ends))
                }
                SignPattern::Unknown => None,
            };
            let next = Some(tile.exit());
            let end = if let Some(least) = least
                && stays
                && slips(at.slip, u)
                && elapsed <= allowed
            {
                self.frame.theta += tile.angle();
                (self.edge, self.here) = (next, at);
                self.go_on(least, true)?
            } else {
                let Some((place, step)) = cell.whole_step(here, level, time) else {
                    break;
                };
                self.pass_step(&place, &step, next)?
            };
            if end.is_some() {
                return Ok(end);
            }
            self.pieces += 1;
        }
        Ok(None)
    }

    /// A step until its series ends.
    fn own_step(
        &mut self,
        expansion: &Expansion,
        from_limit: bool,
    ) -> Result<Option<SlideEnd>, Fallback> {
        let step = RegularSegment::new(
            expansion,
            self.here.direction,
            expansion.reach(0),
            from_limit,
        )?;
        self.pass_step(
            &SlidePoint {
                z: 0.0,
                ..self.here
            },
            &step,
            None,
        )
    }

    /// Passes a step from a place in it, at whose end the slide is at an edge, or not.
    fn pass_step(
        &mut self,
        place: &SlidePoint,
        step: &RegularSegment,
        edge: Option<usize>,
    ) -> Result<Option<SlideEnd>, Fallback> {
        let frame = self.frame;
        let way = frame.way(step);
        let passed = self.cut(&way, place, over_step(&way, place, step)?);
        let at = passed.at;
        if passed.end == End::Open {
            (self.edge, self.here, self.is_behind_turn) = (edge, at, false);
            self.frame.theta = match edge {
                Some(edge) => edge_angle_near(edge, frame.theta),
                None => frame.theta + step.turned(place.z, at.z),
            };
            return self.go_on(passed.least, edge.is_some());
        }
        self.frame.theta += step.turned(place.z, at.z);
        Ok(Some(self.ended(&passed, step.rate(at.z, at.u))))
    }

    /// Passes a turn, in the frame before the turning point, from a place in it.
    fn pass_turn(
        &mut self,
        before: MotionFrame<'a>,
        place: &SlidePoint,
        turn: &TurningSegment,
    ) -> Result<Option<SlideEnd>, Fallback> {
        // Towards larger angles, and back.
        let [from, middle, to] = [place.z, 0.0, 1.0].map(|y| turn.direction(y).0);
        let passes_top = (place.z < 0.0 && passes_top(from, middle)) || passes_top(-middle, -to);
        // Behind its linear term u changes by less than half over the turn: w ≥ 1 − h u.
        let held = 2.0 * before.law().body.h * turn.u(1.0) < 1.0;
        if passes_top && !held {
            return Err(Fallback::TurningPoint);
        }
        let way = before.way(turn);
        let passed = self.cut(&way, place, over_turn(&way, place, held)?);
        let at = passed.at;
        if place.z < 0.0 && at.z > 0.0 {
            self.turns += 1.0;
        }
        self.frame = MotionFrame {
            theta: before.theta + turn.turned_by(at.z),
            ..before
        };
        if passed.end == End::Open {
            self.frame = self.frame.mirrored();
            (self.edge, self.is_behind_turn) = (None, true);
            self.here = SlidePoint {
                direction: mirrored(at.direction),
                ..at
            };
            return self.go_on(passed.least, true);
        }
        Ok(Some(self.ended(&passed, turn.rate(at.z, at.u))))
    }

    /// What was passed from a place on, cut at the limit of time.
    fn cut<P: SlideSegment>(
        &self,
        way: &SegmentContext<'_, P>,
        place: &SlidePoint,
        passed: SegmentResult,
    ) -> SegmentResult {
        if passed.at.elapsed <= self.allowed {
            return passed;
        }
        SegmentResult::to(End::Cut, way.at_time(place, &passed.at, self.allowed))
    }

    fn ended(&self, passed: &SegmentResult, rate: f64) -> SlideEnd {
        let SegmentResult { end, at, .. } = passed;
        let event = SlideEvent {
            elapsed: at.elapsed,
            theta: self.frame.theta,
            theta_rate: rate,
            slip: if *end == End::Rest {
                0.0
            } else {
                self.frame.sigma * at.slip
            },
            direction: at.direction,
            lifts_off: *end == End::LiftOff,
            turns: self.turns,
        };
        let event = event.mirrored(self.frame.sign);
        if *end == End::Cut {
            SlideEnd::Cut(event)
        } else {
            SlideEnd::Event(event)
        }
    }

    /// Goes on behind a piece on which η′ was at least this, and passes whole periods where it is
    /// at a place to which it comes back.
    fn go_on(&mut self, least: f64, comes_back: bool) -> Result<Option<SlideEnd>, Fallback> {
        self.least = self.least.min(least);
        if !comes_back {
            return Ok(None);
        }
        let MotionFrame { sign, theta, .. } = self.frame;
        let here = PeriodStart {
            sign,
            theta,
            elapsed: self.here.elapsed,
            turns: self.turns,
            piece: self.pieces,
        };
        let set = |slide: &mut Self, mark: PeriodStart| {
            (slide.mark, slide.least) = (Some(mark), slide.here.slip);
        };
        let Some(mark) = self.mark else {
            set(self, here);
            return Ok(None);
        };
        let turned = theta - mark.theta;
        let turns = if turned.abs() < PI {
            0.0
        } else {
            (turned / TAU).round()
        };
        let is_same = sign == mark.sign
            && (turned - TAU * turns).abs() <= PERIOD_TOLERANCE * (1.0 + theta.abs());
        if !(is_same && (turns != 0.0 || self.turns >= mark.turns + 2.0)) {
            // Where the first piece began the slide may never be again.
            if here.piece > 2 * mark.piece + INTERVALS {
                set(self, here);
            }
            return Ok(None);
        }
        let period = here.elapsed - mark.elapsed;
        let law = self.frame.law();
        let loss = self.frame.loss(period);
        let allowed = (self.allowed - here.elapsed) / period;
        // In the frame in which η′ < 0 they are followed one by one.
        let periods = if self.frame.sigma > 0.0 {
            (self.least / loss).min(allowed)
        } else {
            0.0
        };
        if loss <= 0.0 && (turns == 0.0 || law.friction == 0.0) {
            if allowed == f64::INFINITY {
                return Ok(Some(SlideEnd::Never));
            }
            if allowed > MAX_PERIODS {
                return Err(Fallback::TooLong);
            }
            // What is left is no less than nothing, whatever rounding does.
            let whole = allowed.floor();
            let late = here.elapsed + whole * period > self.allowed;
            self.pass_periods(if late { whole - 1.0 } else { whole }, period, TAU * turns);
        } else if turns != 0.0 {
            // With friction turns differ, and one without loss tells nothing of the next.
            if periods > MAX_TURNS {
                return Err(Fallback::TooLong);
            }
        } else if periods > MAX_PERIODS {
            return Err(Fallback::TooLong);
        } else if periods > MIN_PERIODS_TO_SKIP {
            // The last ones, in which rounding might tell, are followed.
            self.pass_periods(periods.floor() - 2.0, period, 0.0);
        }
        let mark = PeriodStart {
            elapsed: self.here.elapsed,
            theta: self.frame.theta,
            turns: self.turns,
            ..here
        };
        set(self, mark);
        Ok(None)
    }

    /// Passes so many whole periods, each of which lasts so long and takes the angle so far.
    fn pass_periods(&mut self, periods: f64, period: f64, advance: f64) {
        let elapsed = periods * period;
        self.here.elapsed += elapsed;
        self.here.slip -= self.frame.loss(elapsed);
        self.frame.theta += periods * advance;
        // Of a libration; the turns of a rotation have none.
        if self.turns > 0.0 {
            self.turns += 2.0 * periods;
        }
    }
}

/// Passes a step to its end, or to the event before.
fn over_step(
    way: &SegmentContext<'_, RegularSegment>,
    here: &SlidePoint,
    step: &RegularSegment,
) -> Result<SegmentResult, Fallback> {
    let signs = (step.signs, step.doubt);
    let end = step.end;
    if !passes_top(here.direction.0, step.direction(end).0) {
        return pass(way, (here, end), false, signs);
    }
    let top = step.top().clamp(here.z, end);
    let (h, u) = (way.law.body.h, step.u(top));
    let w = contact(1.0, h, u);
    if w.abs() < SIGN_TOLERANCE * (1.0 + h * u) {
        return Err(Fallback::Contact);
    }
    if w < 0.0 {
        pass(way, (here, top), false, signs)
    } else {
        pass(way, (here, end), true, signs)
    }
}

/// Whether a slide that turns towards larger angles, from a place with this sin ϑ to another less
/// than half a turn ahead, passes the top.
fn passes_top(from: f64, to: f64) -> bool {
    from < 0.0 && to >= 0.0
}

/// Passes a turn from a place to y = 1, or to the event before. `held` says that the normal force
/// cannot vanish.
fn over_turn(
    way: &SegmentContext<'_, TurningSegment>,
    here: &SlidePoint,
    held: bool,
) -> Result<SegmentResult, Fallback> {
    let TurningSegment { signs, doubt, .. } = *way.piece;
    match signs {
        // Towards the turning point, where u = 0, the signs come in the opposite order.
        SignPattern::Rising | SignPattern::Falling if here.z < 0.0 => {
            let middle = pass(way, (here, 0.0), true, (signs.reversed(), doubt))?;
            if middle.end != End::Open {
                return Ok(middle);
            }
            let passed = pass(way, (&middle.at, 1.0), held, (signs, doubt))?;
            Ok(SegmentResult {
                least: passed.least.min(middle.least),
                ..passed
            })
        }
        SignPattern::Rising
        | SignPattern::Falling
        | SignPattern::Positive
        | SignPattern::Negative
        | SignPattern::Unknown => pass(way, (here, 1.0), held, (signs, doubt)),
    }
}

/// Passes a piece from a place to another, or to the event before. `held` says that the normal
/// force cannot vanish.
fn pass<P: SlideSegment>(
    way: &SegmentContext<'_, P>,
    (here, to): (&SlidePoint, f64),
    held: bool,
    (signs, doubt): (SignPattern, f64),
) -> Result<SegmentResult, Fallback> {
    let (h, u) = (way.law.body.h, way.piece.u(to));
    let w = if held {
        1.0
    } else {
        contact(1.0, h, way.piece.direction(to).1 * u)
    };
    if !held && w.abs() < SIGN_TOLERANCE * (1.0 + h * u) {
        return Err(Fallback::Contact);
    }
    let lifts_off = w < 0.0;
    let there = if lifts_off {
        way.lift_off(here, (to, w))
    } else {
        way.at(here, to)
    };
    // Where the piece ends just at a zero of η′, which may be a touch, rounding would decide.
    if there.slip.abs() <= SIGN_TOLERANCE * way.slip_scale(&there) {
        return Err(Fallback::Slip);
    }
    let from_rest = here.slip <= 0.0;
    // The change may lie behind.
    let signs = match signs {
        SignPattern::Rising if here.slip_acceleration > doubt => SignPattern::Positive,
        SignPattern::Falling if here.slip_acceleration < -doubt => SignPattern::Negative,
        signs => signs,
    };
    let passed = SegmentResult::to(if lifts_off { End::LiftOff } else { End::Open }, there);
    let rest = |before: &SlidePoint| Ok(SegmentResult::to(End::Rest, way.rest(here, before)?));
    match signs {
        SignPattern::Unknown => Err(Fallback::SlipShape),
        // η′ must rise from zero.
        SignPattern::Negative | SignPattern::Rising if from_rest => Err(Fallback::Slip),
        SignPattern::Falling if from_rest && here.slip_acceleration < 0.0 => Err(Fallback::Slip),
        SignPattern::Positive
        | SignPattern::Negative
        | SignPattern::Falling
        | SignPattern::Rising
            if there.slip <= 0.0 =>
        {
            rest(&there)
        }
        // Where η″ is next to zero it is not known how it changes its sign; η′ changes there by no
        // more than this.
        SignPattern::Falling if there.slip <= doubt * (there.elapsed - here.elapsed) => {
            Err(Fallback::SlipShape)
        }
        SignPattern::Positive | SignPattern::Negative | SignPattern::Falling => Ok(passed),
        SignPattern::Rising => {
            let Some(least) = way.least(here, &there) else {
                return Ok(passed);
            };
            let uncertain =
                doubt * (there.elapsed - here.elapsed) + SIGN_TOLERANCE * way.slip_scale(&least);
            // Where it hardly vanishes, or hardly does not, rounding would decide.
            if least.slip.abs() <= uncertain {
                return Err(Fallback::Slip);
            }
            if least.slip < 0.0 {
                rest(&least)
            } else {
                Ok(SegmentResult {
                    least: least.slip,
                    ..passed
                })
            }
        }
    }
}

/// The turn about the turning point next to the centre of an expansion, ahead or behind, if it is
/// near; with the frame before it, whose angle is that of the turning point, and the place in it.
fn turn_about<'a>(
    frame: &MotionFrame<'a>,
    here: &SlidePoint,
    expansion: &Expansion,
) -> Option<(MotionFrame<'a>, SlidePoint, TurningSegment)> {
    let reach = expansion.reach(0);
    if here.u > MAX_TURN_DISTANCE * reach * expansion.u[1].abs() {
        return None;
    }
    let distance = expansion.zero(reach)?.abs();
    let is_ahead = expansion.u[1] < 0.0;
    let (frame, direction) = if is_ahead {
        (*frame, here.direction)
    } else {
        (frame.mirrored(), mirrored(here.direction))
    };
    let (behind, there) = (frame.mirrored(), mirrored(rotated(direction, distance)));
    let turn = TurningSegment::new(
        &Expansion::new(behind.law(), behind.sigma, there, 0.0),
        there,
    )?;
    let part = distance / turn.width;
    // Behind the turning point a step leads farther than the rest of the turn.
    let (z, farthest) = if is_ahead {
        (-part.sqrt(), 1.0)
    } else {
        (part.sqrt(), MAX_PART_BEHIND_TURN)
    };
    let frame = MotionFrame {
        theta: frame.theta + 2.0 * libm::atan(distance),
        ..frame
    };
    (part < farthest).then_some((
        frame,
        SlidePoint {
            z,
            direction,
            ..*here
        },
        turn,
    ))
}
