//! A slide, followed segment by segment to its event (docs/engine.md), in the frame of motion, ϑ
//! growing.
//!
//! 1 − h cos ϑ u falls through zero only where sin ϑ < 0: its sign at the end of a segment, or at
//! the top, decides whether it has. The signs of η″ decide whether η′ is monotone, or has one
//! extremum. In a libration, and without kinetic friction, θ′² is periodic in time: periods without
//! an event are skipped.

use core::f64::consts::{PI, TAU};

use crate::engine::fallback::Fallback;
use crate::math::trig::Angle;
use crate::mechanics::{SlidingLaw, contact};

use super::regular::{RegularSegment, Span};
use super::segment::{SIGN_TOLERANCE, SegmentContext, SlidePoint, SlideSegment, slip_scale};
use super::series::{Expansion, SignPattern, SlipSigns};
use super::table::{
    AngleInterval, Crossing, Edge, HALVINGS, INTERVALS, SlideTables, coarsest, edge_angle_near,
};
use super::turning::{TurningSegment, turning_near};
use super::{SlideEnd, SlideEvent, Stop};

/// Most segments: a slide over more than some 16 turns is left to the exact solver, which sums
/// whole turns.
const MAX_SEGMENTS: usize = 512;

/// A slide over more turns than this is left to the exact solver.
const MAX_TURNS: f64 = 16.0;

/// So is a libration over more periods: the rounding of its period would be multiplied by as many.
const MAX_PERIODS: f64 = 64.0;

/// Fewer periods are followed one by one.
const MIN_PERIODS_TO_SKIP: f64 = 2.0;

/// A point is the same after a period if its angle is the same to this.
const PERIOD_TOLERANCE: f64 = 1e-12;

/// The frame in which the angle of a slide grows, perhaps mirrored.
#[derive(Clone, Copy, Debug)]
pub(in crate::engine) struct MotionFrame<'a> {
    pub(in crate::engine) laws: &'a SlideLaws,
    /// −1 where the frame is mirrored.
    pub(in crate::engine) mirror: f64,
    /// Whether the slide turns against the frame, the angle falling. Only rolling resistance tells.
    pub(in crate::engine) is_against: bool,
    pub(in crate::engine) theta: f64,
    /// Sign of η′.
    pub(in crate::engine) sigma: f64,
    pub(in crate::engine) integral: f64,
}

/// The equations of slides with the frame and against it; of each for σ = −1 and σ = +1, as they are
/// and mirrored.
pub(in crate::engine) type SlideLaws = [[[SlidingLaw; 2]; 2]; 2];

impl MotionFrame<'_> {
    /// The same slide in the frame that is the mirror image.
    fn mirrored(self) -> Self {
        Self {
            laws: self.laws,
            is_against: !self.is_against,
            mirror: -self.mirror,
            theta: -self.theta,
            sigma: -self.sigma,
            integral: -self.integral,
        }
    }

    const fn law(&self) -> &SlidingLaw {
        let laws = &self.laws[self.is_against as usize];
        &laws[if self.mirror < 0.0 { 1 } else { 0 }][if self.sigma > 0.0 { 1 } else { 0 }]
    }

    /// By how much σ η′ is smaller at the same angle after this time.
    fn slip_loss(&self, elapsed: f64) -> f64 {
        self.sigma * self.law().mean_slip_loss() * elapsed
    }

    const fn context<'b, S: SlideSegment>(&'b self, segment: &'b S) -> SegmentContext<'b, S> {
        SegmentContext {
            law: self.law(),
            segment,
            sigma: self.sigma,
            integral: self.integral,
        }
    }
}

/// One slide.
#[derive(Clone, Copy, Debug)]
pub(in crate::engine) struct SlideProblem<'a> {
    pub(in crate::engine) frame: MotionFrame<'a>,
    pub(in crate::engine) start: SlidePoint,
    /// Whether η′ = η″ = 0 at the start.
    pub(in crate::engine) from_limit: bool,
    pub(in crate::engine) time_left: f64,
    /// The tables of the hoop, if they are used.
    pub(in crate::engine) tables: Option<&'a SlideTables>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum SegmentEnd {
    /// The slide continues.
    Open,
    /// η′ = 0.
    Rest,
    /// w = 0.
    LiftOff,
    /// θ′ = 0, where rolling resistance changes its sign.
    Turn,
    /// By the time limit.
    Cut,
}

/// How far a segment was followed.
#[derive(Clone, Copy, Debug)]
struct SegmentResult {
    end: SegmentEnd,
    point: SlidePoint,
    /// The least η′ behind the start.
    min_slip: f64,
}

impl SegmentResult {
    const fn to(end: SegmentEnd, point: SlidePoint) -> Self {
        Self {
            end,
            point,
            min_slip: point.slip,
        }
    }
}

/// A point to which periodic slides come back.
#[derive(Clone, Copy, Debug)]
struct PeriodStart {
    mirror: f64,
    /// The edge of the grid at which it is.
    edge: Option<usize>,
    theta: f64,
    elapsed: f64,
    /// Turning points before it.
    turning_points: f64,
    /// Number of the segment that ended there.
    segment: usize,
}

impl PeriodStart {
    /// Up to which segment the slide may come back: where the first began it may never be again.
    const fn last_segment(&self) -> usize {
        2 * self.segment + INTERVALS
    }
}

/// A period of a slide.
struct Period {
    duration: f64,
    /// 2π times the turns of a rotation; 0 of a libration.
    delta_theta: f64,
}

/// A segment about a turning point, the frame before it, whose angle is that of the turning point,
/// and the point in it at which the slide is.
struct TurningEntry<'a> {
    frame: MotionFrame<'a>,
    start: SlidePoint,
    segment: TurningSegment,
    /// Whether the slide comes to the turning point. The coordinate does not tell: it is 0 where
    /// θ′² underflows.
    is_ahead: bool,
}

struct Slide<'a> {
    frame: MotionFrame<'a>,
    point: SlidePoint,
    /// The edge of the grid at which it is.
    edge: Option<usize>,
    is_behind_turn: bool,
    /// Turning points so far.
    turning_points: f64,
    period_start: Option<PeriodStart>,
    /// The least η′ since the start of the period.
    min_slip: f64,
    segments: usize,
    time_left: f64,
    tables: Option<&'a SlideTables>,
}

/// Whether a slide goes on.
type Advance = Result<(), Stop<SlideEnd>>;

/// Follows a slide to its event, or to the time limit.
pub(in crate::engine) fn solve_slide(problem: SlideProblem<'_>) -> Result<SlideEnd, Fallback> {
    let SlideProblem {
        frame,
        start,
        from_limit,
        time_left,
        tables,
    } = problem;
    let mut slide = Slide {
        frame,
        point: start,
        edge: None,
        is_behind_turn: false,
        turning_points: 0.0,
        period_start: None,
        min_slip: start.slip,
        segments: 0,
        time_left,
        tables,
    };
    match slide.follow(from_limit) {
        Ok(()) => Err(Fallback::TooLong),
        Err(stop) => stop.into_result(),
    }
}

impl<'a> Slide<'a> {
    /// Follows as many segments as it may.
    fn follow(&mut self, from_limit: bool) -> Advance {
        if from_limit {
            // At η′ = η″ = 0 a table cannot tell whether η′ rises; a series about this point can,
            // since the factor z of η″ divides out.
            let Self { frame, point, .. } = self;
            let expansion = Expansion::new(frame.law(), frame.sigma, point.angle, point.u);
            self.advance_by_series(&expansion, true)?;
        }
        while self.segments < MAX_SEGMENTS {
            self.segments += 1;
            self.advance()?;
        }
        Ok(())
    }

    /// Follows the next segment: by tables where there are any, about a turning point next to one,
    /// and by a new series elsewhere.
    fn advance(&mut self) -> Advance {
        if let Some(tables) = self.tables {
            self.skip_intervals(tables)?;
            if let Some(advance) = self.advance_in_table(tables) {
                return advance;
            }
        }
        let Self { frame, point, .. } = *self;
        let expansion = Expansion::new(frame.law(), frame.sigma, point.angle, point.u);
        // The segment about the turning point behind has led as far as it does.
        let is_done = self.is_behind_turn && expansion.u[1] > 0.0;
        let turning = if is_done {
            None
        } else {
            turning_segment_near(&frame, &point, &expansion)
        };
        match turning {
            Some(entry) => self.follow_turning(&entry),
            None => self.advance_by_series(&expansion, false),
        }
    }

    /// Follows a segment of a table. None where no table has one.
    fn advance_in_table(&mut self, tables: &'a SlideTables) -> Option<Advance> {
        let Self { frame, point, .. } = *self;
        let (Angle { sin, cos }, law) = (point.angle, frame.law());
        // du/dz: where u is steep intervals must be narrow, or there is none.
        let slope = 2.0 * law.u_growth(sin, cos) * contact(1.0, law.body.h, cos * point.u);
        let min_halvings = coarsest(slope, point.u)?;
        for halvings in min_halvings..=HALVINGS {
            for interval in AngleInterval::about(frame.theta, halvings) {
                let Some(table) = tables.get(law, frame.sigma, interval) else {
                    continue;
                };
                if let Some(entrance) = table.enter(&point) {
                    let edge = entrance.is_to_exit.then(|| interval.exit());
                    let start = SlidePoint {
                        z: entrance.z,
                        ..point
                    };
                    let segment = table.segment(entrance);
                    return Some(self.follow_regular(&start, &segment, edge));
                }
            }
        }
        None
    }

    /// Crosses whole intervals up to the first with an event, or up to an edge from which no
    /// interval can be crossed.
    ///
    /// On an interval every slide is u = p + u_c h. u at the entry gives u_c, hence u at the exit;
    /// one Gauss sum gives the time, and the momentum integral the slip.
    fn skip_intervals(&mut self, tables: &'a SlideTables) -> Advance {
        let frame = self.frame;
        let law = frame.law();
        let mut min_halvings = 0;
        while let Some(index) = self.edge
            && self.segments < MAX_SEGMENTS
            && let Some(crossing) = tables.crossing(
                law,
                frame.sigma,
                Edge {
                    index,
                    min_halvings,
                },
                self.point.u,
            )
        {
            let Crossing {
                interval,
                table,
                u_centre,
                ..
            } = crossing;
            // Where an interval was too wide for this slide the next one probably is, too.
            min_halvings = interval.halvings.saturating_sub(1);
            let time = table.solutions.time(u_centre);
            let exit = exit_point(&frame, law, &crossing, self.point.elapsed + time);
            let next = Some(interval.exit());
            let signs = table.signs(u_centre);
            let min_slip = self.min_slip_without_event(law, &crossing, signs, time, &exit);
            if let Some(min_slip) = min_slip {
                self.frame.theta += interval.width();
                (self.edge, self.point) = (next, exit);
                self.skip_if_periodic(min_slip, true)?;
            } else if signs.pattern == SignPattern::Unknown {
                break;
            } else {
                // An event may lie on this interval: it is searched.
                let start = SlidePoint {
                    z: -table.solutions.end,
                    ..self.point
                };
                let segment = table.whole_interval(u_centre, time, signs);
                self.follow_regular(&start, &segment, next)?;
            }
            self.segments += 1;
        }
        Ok(())
    }

    /// A lower bound of η′ on an interval without an event; none where there may be one.
    #[inline(always)]
    fn min_slip_without_event(
        &self,
        law: &SlidingLaw,
        crossing: &Crossing<'_>,
        signs: SlipSigns,
        time: f64,
        exit: &SlidePoint,
    ) -> Option<f64> {
        let Self { frame, point, .. } = self;
        let h = law.body.h;
        // w can cross zero only before the top, which is an edge: its sign at the exit decides.
        let stays = contact(1.0, h, exit.angle.cos * exit.u) > SIGN_TOLERANCE * (1.0 + h * exit.u);
        let slips = |slip: f64, u: f64| slip > SIGN_TOLERANCE * slip_scale(u, frame.integral);
        let at_ends = point.slip.min(exit.slip);
        let SlipSigns {
            pattern,
            sign_uncertainty,
        } = signs;
        // η′ is monotone, has a maximum, or a minimum that is no less.
        let min_slip = match pattern {
            SignPattern::Positive | SignPattern::Negative => at_ends,
            SignPattern::Falling if exit.slip > sign_uncertainty * time => at_ends,
            SignPattern::Rising if point.slip_acceleration > sign_uncertainty => at_ends,
            SignPattern::Rising => {
                let bound =
                    point.slip + time * crossing.table.min_slip_acceleration(crossing.u_centre);
                // On an interval that is crossed u is less than twice that in its middle.
                if !slips(bound, 2.0 * crossing.u_centre) {
                    return None;
                }
                bound.min(at_ends)
            }
            SignPattern::Falling | SignPattern::Unknown => return None,
        };
        let is_free = stays && slips(exit.slip, exit.u) && exit.elapsed <= self.time_left;
        is_free.then_some(min_slip)
    }

    /// Follows a segment until its series ends.
    fn advance_by_series(&mut self, expansion: &Expansion, from_limit: bool) -> Advance {
        let segment = RegularSegment::new(expansion, self.point.angle, from_limit)?;
        let start = SlidePoint {
            z: 0.0,
            ..self.point
        };
        self.follow_regular(&start, &segment, None)
    }

    /// Follows a segment from a point on it; `edge` is the edge at its end, if there is one.
    fn follow_regular(
        &mut self,
        start: &SlidePoint,
        segment: &RegularSegment,
        edge: Option<usize>,
    ) -> Advance {
        let frame = self.frame;
        let context = frame.context(segment);
        let result = self.cut(&context, start, find_event_on_regular(&context, start)?);
        let point = result.point;
        let delta_theta = || {
            segment.delta_theta(Span {
                start: start.z,
                end: point.z,
            })
        };
        if result.end == SegmentEnd::Open {
            (self.edge, self.point, self.is_behind_turn) = (edge, point, false);
            self.frame.theta = match edge {
                Some(edge) => edge_angle_near(edge, frame.theta),
                None => frame.theta + delta_theta(),
            };
            return self.skip_if_periodic(result.min_slip, edge.is_some());
        }
        self.frame.theta += delta_theta();
        self.end(&result, segment.theta_rate(point.z, point.u))
    }

    /// Follows a segment about a turning point.
    fn follow_turning(&mut self, entry: &TurningEntry<'a>) -> Advance {
        let TurningEntry {
            frame,
            start,
            segment,
            is_ahead,
        } = entry;
        // The top may lie on the way towards the turning point, or on the way back.
        let sine = |y: f64| segment.angle(y).sin;
        let (from, middle, to) = (sine(start.z), sine(0.0), sine(1.0));
        let passes_top = (start.z < 0.0 && passes_top(from, middle)) || passes_top(-middle, -to);
        // Behind its linear term u changes by less than half over the segment: w ≥ 1 − h u.
        let stays = 2.0 * frame.law().body.h * segment.u(1.0) < 1.0;
        if passes_top && !stays {
            return Err(Fallback::TurningPoint.into());
        }
        let context = frame.context(segment);
        let found = if frame.law().resistance == 0.0 {
            find_event_on_turning(&context, start, stays)?
        } else {
            find_event_with_resistance(&context, start, *is_ahead, stays)?
        };
        let result = self.cut(&context, start, found);
        let point = result.point;
        if *is_ahead && point.z > 0.0 {
            self.turning_points += 1.0;
        }
        self.frame = MotionFrame {
            theta: frame.theta + segment.delta_theta(point.z),
            ..*frame
        };
        if result.end == SegmentEnd::Open {
            self.frame = self.frame.mirrored();
            (self.edge, self.is_behind_turn) = (None, true);
            self.point = SlidePoint {
                angle: point.angle.mirrored(),
                ..point
            };
            return self.skip_if_periodic(result.min_slip, true);
        }
        self.end(&result, segment.theta_rate(point.z, point.u))
    }

    /// A result, cut at the time limit.
    fn cut<S: SlideSegment>(
        &self,
        context: &SegmentContext<'_, S>,
        start: &SlidePoint,
        result: SegmentResult,
    ) -> SegmentResult {
        if result.point.elapsed <= self.time_left {
            return result;
        }
        let point = context.at_time(start, &result.point, self.time_left);
        SegmentResult::to(SegmentEnd::Cut, point)
    }

    /// θ at an end. Over many segments it adds up rounding, which the sine and cosine do not; and the
    /// jump out of a slide depends on the distance of the lift-off from the top.
    fn theta_at(&self, end: SegmentEnd, angle: Angle) -> f64 {
        let theta = self.frame.theta;
        if end == SegmentEnd::LiftOff && self.segments > INTERVALS {
            theta + angle.minus(Angle::of(theta)).sin
        } else {
            theta
        }
    }

    fn end(&self, result: &SegmentResult, theta_rate: f64) -> Advance {
        let SegmentResult { end, point, .. } = result;
        let event = SlideEvent {
            elapsed: point.elapsed,
            theta: self.theta_at(*end, point.angle),
            theta_rate,
            slip: if *end == SegmentEnd::Rest {
                0.0
            } else {
                self.frame.sigma * point.slip
            },
            angle: point.angle,
            lifts_off: *end == SegmentEnd::LiftOff,
            turning_points: self.turning_points,
        };
        let event = event.mirrored_by(self.frame.mirror);
        Err(Stop::End(match end {
            SegmentEnd::Cut => SlideEnd::Cut(event),
            SegmentEnd::Turn => SlideEnd::Turn(event),
            SegmentEnd::Open | SegmentEnd::Rest | SegmentEnd::LiftOff => SlideEnd::Event(event),
        }))
    }

    /// Skips whole periods behind a segment on which η′ was at least `min_slip`; `comes_back` if it
    /// ends at a point to which a periodic slide comes back.
    ///
    /// In libration (friction retraces u), or without friction, u repeats. At the same angle and
    /// heading one period later only the slip differs, by −drag · T, so that ⌊least slip/loss⌋
    /// periods are free of events. Rotation with friction changes u every turn, and is followed.
    #[inline(always)]
    fn skip_if_periodic(&mut self, min_slip: f64, comes_back: bool) -> Advance {
        self.min_slip = self.min_slip.min(min_slip);
        // Mostly the edge tells that it is elsewhere, which costs less than the turns.
        let is_elsewhere = self.period_start.as_ref().is_some_and(|start| {
            (self.frame.mirror != start.mirror || self.edge != start.edge)
                && self.segments <= start.last_segment()
        });
        if is_elsewhere || !comes_back {
            return Ok(());
        }
        self.skip_where_it_comes_back()
    }

    /// The same where the slide may have come back.
    fn skip_where_it_comes_back(&mut self) -> Advance {
        if let Some(start) = self.period_start {
            if let Some(period) = self.period_since(&start) {
                self.skip(&period)?;
            } else if self.segments <= start.last_segment() {
                return Ok(());
            }
        }
        self.start_period();
        Ok(())
    }

    fn start_period(&mut self) {
        self.period_start = Some(PeriodStart {
            mirror: self.frame.mirror,
            edge: self.edge,
            theta: self.frame.theta,
            elapsed: self.point.elapsed,
            turning_points: self.turning_points,
            segment: self.segments,
        });
        self.min_slip = self.point.slip;
    }

    /// The period that ends here; none if it does not.
    fn period_since(&self, start: &PeriodStart) -> Option<Period> {
        let MotionFrame { mirror, theta, .. } = self.frame;
        if mirror != start.mirror || self.edge != start.edge {
            return None;
        }
        let turned = theta - start.theta;
        let turns = if turned.abs() < PI {
            0.0
        } else {
            (turned / TAU).round()
        };
        let is_same = (turned - TAU * turns).abs() <= PERIOD_TOLERANCE * (1.0 + theta.abs());
        let is_later = turns != 0.0 || self.turning_points >= start.turning_points + 2.0;
        (is_same && is_later).then_some(Period {
            duration: self.point.elapsed - start.elapsed,
            delta_theta: TAU * turns,
        })
    }

    /// Skips as many periods as are certainly free of events.
    fn skip(&mut self, period: &Period) -> Advance {
        let elapsed = self.point.elapsed;
        let law = self.frame.law();
        let loss = self.frame.slip_loss(period.duration);
        let is_rotation = period.delta_theta != 0.0;
        let periods_left = (self.time_left - elapsed) / period.duration;
        let periods = (self.min_slip / loss).min(periods_left);
        let is_conservative = law.friction == 0.0 && law.resistance == 0.0;
        if loss <= 0.0 && (!is_rotation || is_conservative) {
            // η′ is no less after each period: there is no event at all.
            if periods_left == f64::INFINITY {
                return Err(Stop::End(SlideEnd::Never));
            }
            if periods_left > MAX_PERIODS {
                return Err(Fallback::TooLong.into());
            }
            // The time left must not become negative by rounding.
            let whole = periods_left.floor();
            let is_late = elapsed + whole * period.duration > self.time_left;
            self.skip_periods(if is_late { whole - 1.0 } else { whole }, period);
        } else if is_rotation {
            // With friction turns differ, and one without loss says nothing about the next.
            if periods > MAX_TURNS {
                return Err(Fallback::TooLong.into());
            }
        } else if periods > MAX_PERIODS {
            return Err(Fallback::TooLong.into());
        } else if periods > MIN_PERIODS_TO_SKIP {
            // Rounding might decide in the last ones: they are followed.
            self.skip_periods(periods.floor() - 1.0, period);
        }
        Ok(())
    }

    fn skip_periods(&mut self, periods: f64, period: &Period) {
        let elapsed = periods * period.duration;
        self.point.elapsed += elapsed;
        self.point.slip -= self.frame.slip_loss(elapsed);
        self.frame.theta += periods * period.delta_theta;
        // A libration has two turning points in each period, a rotation none.
        if self.turning_points > 0.0 {
            self.turning_points += 2.0 * periods;
        }
    }
}

/// The point at the end of an interval.
fn exit_point(
    frame: &MotionFrame<'_>,
    law: &SlidingLaw,
    crossing: &Crossing<'_>,
    elapsed: f64,
) -> SlidePoint {
    let (exit, u) = (crossing.table.exit_coefficients(), crossing.u_exit);
    SlidePoint {
        z: 1.0,
        u,
        elapsed,
        slip: frame.sigma
            * (frame.integral + u.sqrt() * exit.slip_coefficient - law.mean_slip_loss() * elapsed),
        slip_acceleration: frame.sigma * (exit.alpha + exit.beta * u),
        angle: exit.angle,
    }
}

/// The first event on a segment from a point on it, or its end.
fn find_event_on_regular(
    context: &SegmentContext<'_, RegularSegment>,
    start: &SlidePoint,
) -> Result<SegmentResult, Fallback> {
    let segment = context.segment;
    let (signs, end) = (segment.signs, segment.end);
    if !passes_top(start.angle.sin, segment.angle(end).sin) {
        return find_event(context, start, end, false, signs);
    }
    // Behind the top w rises: its sign at the top decides.
    let top = segment.top().clamp(start.z, end);
    let (h, u) = (context.law.body.h, segment.u(top));
    let w = contact(1.0, h, u);
    if w.abs() < SIGN_TOLERANCE * (1.0 + h * u) {
        return Err(Fallback::Contact);
    }
    if w < 0.0 {
        find_event(context, start, top, false, signs)
    } else {
        find_event(context, start, end, true, signs)
    }
}

/// Whether a slide that turns towards larger angles, from a point with this sin ϑ to another less
/// than half a turn ahead, passes the top.
fn passes_top(from: f64, to: f64) -> bool {
    from < 0.0 && to >= 0.0
}

/// The first event on a segment from a point on it, or its end at y = 1. `stays` if the normal
/// force cannot vanish.
fn find_event_on_turning(
    context: &SegmentContext<'_, TurningSegment>,
    start: &SlidePoint,
    stays: bool,
) -> Result<SegmentResult, Fallback> {
    let signs = context.segment.signs;
    match signs.pattern {
        // Towards the turning point, where u = 0, the signs come in the opposite order.
        SignPattern::Rising | SignPattern::Falling if start.z < 0.0 => {
            let reversed = SlipSigns {
                pattern: signs.pattern.reversed(),
                ..signs
            };
            let middle = find_event(context, start, 0.0, true, reversed)?;
            if middle.end != SegmentEnd::Open {
                return Ok(middle);
            }
            let result = find_event(context, &middle.point, 1.0, stays, signs)?;
            Ok(SegmentResult {
                min_slip: result.min_slip.min(middle.min_slip),
                ..result
            })
        }
        SignPattern::Rising
        | SignPattern::Falling
        | SignPattern::Positive
        | SignPattern::Negative
        | SignPattern::Unknown => find_event(context, start, 1.0, stays, signs),
    }
}

/// The same with rolling resistance: the slide ends at a turning point ahead, and begins at one
/// behind.
fn find_event_with_resistance(
    context: &SegmentContext<'_, TurningSegment>,
    start: &SlidePoint,
    is_ahead: bool,
    stays: bool,
) -> Result<SegmentResult, Fallback> {
    let signs = context.segment.signs;
    if !is_ahead {
        return find_event(context, start, 1.0, stays, signs);
    }
    let reversed = SlipSigns {
        pattern: signs.pattern.reversed(),
        ..signs
    };
    let result = find_event(context, start, 0.0, true, reversed)?;
    Ok(match result.end {
        SegmentEnd::Open => SegmentResult {
            end: SegmentEnd::Turn,
            ..result
        },
        SegmentEnd::Rest | SegmentEnd::LiftOff | SegmentEnd::Turn | SegmentEnd::Cut => result,
    })
}

/// The first event on a segment from a point to the coordinate `to`, or the point there. `stays` if
/// the normal force cannot vanish.
fn find_event<S: SlideSegment>(
    context: &SegmentContext<'_, S>,
    start: &SlidePoint,
    to: f64,
    stays: bool,
    signs: SlipSigns,
) -> Result<SegmentResult, Fallback> {
    let (h, u) = (context.law.body.h, context.segment.u(to));
    let w = if stays {
        1.0
    } else {
        context.contact_margin(context.segment.angle(to), u)
    };
    if !stays && w.abs() < SIGN_TOLERANCE * (1.0 + h * u) {
        return Err(Fallback::Contact);
    }
    let lifts_off = w < 0.0;
    let end = if lifts_off {
        context.lift_off(start, to, w)
    } else {
        context.point(start, to)
    };
    // Where the segment ends just at a zero of η′, which may be a touch, rounding would decide.
    if end.slip.abs() <= SIGN_TOLERANCE * context.slip_scale(&end) {
        return Err(Fallback::Slip);
    }
    let result = SegmentResult::to(
        if lifts_off {
            SegmentEnd::LiftOff
        } else {
            SegmentEnd::Open
        },
        end,
    );
    find_rest(context, start, signs, result)
}

/// The end of slip before the end of a segment that was found without it, or that end.
fn find_rest<S: SlideSegment>(
    context: &SegmentContext<'_, S>,
    start: &SlidePoint,
    signs: SlipSigns,
    result: SegmentResult,
) -> Result<SegmentResult, Fallback> {
    let end = result.point;
    let rest = |before: &SlidePoint| {
        let point = context.rest(start, before)?;
        Ok(SegmentResult::to(SegmentEnd::Rest, point))
    };
    let from_rest = start.slip <= 0.0;
    let sign_uncertainty = signs.sign_uncertainty;
    match signs.pattern_behind(start.slip_acceleration) {
        SignPattern::Unknown => Err(Fallback::SlipShape),
        // η′ must rise from zero.
        SignPattern::Negative | SignPattern::Rising if from_rest => Err(Fallback::Slip),
        SignPattern::Falling if from_rest && start.slip_acceleration < 0.0 => Err(Fallback::Slip),
        SignPattern::Positive
        | SignPattern::Negative
        | SignPattern::Falling
        | SignPattern::Rising
            if end.slip <= 0.0 =>
        {
            rest(&end)
        }
        // Where η″ is next to zero it is not known how it changes its sign; η′ changes there by no
        // more than this.
        SignPattern::Falling if end.slip <= sign_uncertainty * (end.elapsed - start.elapsed) => {
            Err(Fallback::SlipShape)
        }
        SignPattern::Positive | SignPattern::Negative | SignPattern::Falling => Ok(result),
        SignPattern::Rising => {
            let Some(min) = context.min_slip(start, &end) else {
                return Ok(result);
            };
            let uncertain = sign_uncertainty * (end.elapsed - start.elapsed)
                + SIGN_TOLERANCE * context.slip_scale(&min);
            // At a near-tangent zero rounding would decide.
            if min.slip.abs() <= uncertain {
                return Err(Fallback::Slip);
            }
            if min.slip < 0.0 {
                rest(&min)
            } else {
                Ok(SegmentResult {
                    min_slip: min.slip,
                    ..result
                })
            }
        }
    }
}

/// The segment about the turning point next to the centre of an expansion, ahead or behind, if that
/// is near.
fn turning_segment_near<'a>(
    frame: &MotionFrame<'a>,
    point: &SlidePoint,
    expansion: &Expansion,
) -> Option<TurningEntry<'a>> {
    let is_ahead = expansion.u[1] < 0.0;
    // Behind a turning point, the frame before it is mirrored.
    let frame = if is_ahead { *frame } else { frame.mirrored() };
    let behind = frame.mirrored();
    let place = turning_near(point.angle, expansion, |_, turning_angle| {
        Expansion::new(behind.law(), behind.sigma, turning_angle, 0.0)
    })?;
    let angle = if is_ahead {
        point.angle
    } else {
        point.angle.mirrored()
    };
    Some(TurningEntry {
        frame: MotionFrame {
            theta: frame.theta + 2.0 * libm::atan(place.distance),
            ..frame
        },
        start: SlidePoint {
            z: place.y,
            angle,
            ..*point
        },
        segment: place.segment,
        is_ahead,
    })
}
