//! The walk of a slide through the cells, to its event.

use crate::mechanics::equations::contact;

use super::super::piece::{End, Piece, UNCERTAIN, Way, Waypoint, may_rise};
use super::super::solver::MIN_RATE;
use super::cell::Cell;
use super::crossing::{Crossing, EVEN, is_smooth, is_within};
use super::turning::Turning;
use super::{SlideEnd, SlideEvent, SlideStart, SlideTable, Turns, Unknown};

/// Ratio of the ends of u from which a turning point is looked for.
const UNEVEN: f64 = 2.0;

/// A slide over more turns than this is followed otherwise.
const MOST_TURNS: usize = 16;

/// So is a libration over more periods: rounding in its period would tell as often.
const MOST_PERIODS: f64 = 64.0;

/// The rate at the entrance must be that of the way about a turning point to this: as small an error in η′.
const RATE_ERROR: f64 = 1e-15;

/// Where a way has led.
#[derive(Clone, Copy, Debug)]
struct Passed {
    end: End,
    at: Waypoint,
    /// The least η′ behind the beginning.
    least: f64,
}

impl Passed {
    const fn to(end: End, at: Waypoint) -> Self {
        Self { end, at, least: at.slip }
    }
}

/// Whether η′ may have a minimum between two waypoints, between which η″ changes its sign at most once.
fn may_be_least_between(here: &Waypoint, there: &Waypoint) -> bool {
    here.slip > 0.0 && may_rise(here.slip_acceleration, there.slip_acceleration, here.u.max(there.u))
}

/// Whether η′ is so close to zero that rounding tells its sign.
fn is_doubtful<P: Piece>(way: &Way<'_, P>, at: &Waypoint) -> bool {
    at.slip.abs() <= UNCERTAIN * way.size_of_slip(at)
}

/// The end of a way on which η″ changes its sign at most once, from a place to another, at which contact ends or not.
fn pass<P: Piece>(way: &Way<'_, P>, here: &Waypoint, there: Waypoint, lifts_off: bool) -> Option<Passed> {
    // Where η′ hardly vanishes before contact ends, or hardly does not, rounding would decide.
    if lifts_off && is_doubtful(way, &there) {
        return None;
    }
    // From η′ = 0 a slip that is lost in rounding has not ended: with coefficients next to each other it hardly grows.
    if here.slip <= 0.0 && is_doubtful(way, &there) {
        return None;
    }
    if there.slip <= 0.0 {
        return Some(Passed::to(End::Rest, way.rest(here, &there)?));
    }
    let passed = Passed::to(if lifts_off { End::LiftOff } else { End::Open }, there);
    if !may_be_least_between(here, &there) {
        return Some(passed);
    }
    let Some(least) = way.least(here, &there)? else {
        return (!is_doubtful(way, here) && !is_doubtful(way, &there)).then_some(passed);
    };
    if is_doubtful(way, &least) {
        return None;
    }
    if least.slip < 0.0 {
        return Some(Passed::to(End::Rest, way.rest(here, &least)?));
    }
    Some(Passed { least: least.slip, ..passed })
}

/// The same up to a coordinate.
fn pass_to<P: Piece>(way: &Way<'_, P>, here: &Waypoint, to: f64) -> Option<Passed> {
    let (_, cos) = way.piece.direction(to);
    let lifts_off = contact(1.0, way.law.body.h, cos * way.piece.u(to)) < 0.0;
    let there = if lifts_off { way.lift_off(here, to)? } else { way.at(here, to)? };
    pass(way, here, there, lifts_off)
}

/// Whether the time is known from the angle.
fn is_fast(at: &Waypoint) -> bool {
    at.u >= MIN_RATE * MIN_RATE
}

/// A passage of the bottom.
#[derive(Clone, Copy, Debug)]
struct Passage {
    elapsed: f64,
    /// The multiple of a turn.
    offset: f64,
    /// Sign of θ′.
    travel: f64,
}

/// A slide on its way through the cells.
#[derive(Clone, Copy, Debug)]
struct Follower<'a> {
    table: &'a SlideTable,
    /// The time that it may take.
    allowed: f64,
    /// The constant of the first integral.
    integral: f64,
    /// The cell, and the multiple of a turn that its angles stand for.
    index: usize,
    offset: f64,
    /// Sign of θ′.
    travel: f64,
    here: Waypoint,
    /// Whether the way through the cell begins at its end.
    whole: bool,
    turns: Option<Turns>,
    /// The first passage of the bottom, and then each in the same direction.
    last: Option<Passage>,
    /// The least η′ since then, or since the start.
    least: f64,
    /// What is known of its end, if it is far.
    far: Option<Far>,
}

/// An end that is not looked for.
#[derive(Clone, Copy, Debug)]
enum Far {
    /// Behind too many turns.
    Long,
    /// Never.
    Never,
}

impl SlideTable {
    /// Follows a slide to its event, or to where it is after the time that is `allowed`.
    pub(in crate::engine) fn follow(&self, start: SlideStart, allowed: f64) -> Result<SlideEnd, Unknown> {
        let mut follower = Follower::new(self, &start, allowed).ok_or(Unknown::Doubt)?;
        let mut left = 2 * MOST_TURNS * self.cells.len();
        while left > 0 {
            left -= follower.cross_cells(left);
            if left > 0 && follower.far.is_none() {
                left -= 1;
                match follower.pass_cell() {
                    None => return Err(Unknown::Doubt),
                    Some(Some(end)) => return Ok(end),
                    Some(None) => {}
                }
            }
            match follower.far {
                None => {}
                Some(Far::Never) => return Ok(SlideEnd::Never),
                Some(Far::Long) => break,
            }
        }
        Err(Unknown::Long)
    }

    /// To its event, if θ′ keeps its sign.
    pub(in crate::engine) fn follow_one_way(&self, start: SlideStart) -> Option<SlideEvent> {
        match self.follow(start, f64::INFINITY) {
            Ok(SlideEnd::Event(event)) if event.turns.is_none() => Some(event),
            Ok(SlideEnd::Event(_) | SlideEnd::Cut(_) | SlideEnd::Never) | Err(_) => None,
        }
    }
}

impl<'a> Follower<'a> {
    fn new(table: &'a SlideTable, start: &SlideStart, allowed: f64) -> Option<Self> {
        if start.theta_rate == 0.0 || start.theta_rate.is_nan() {
            return None;
        }
        let (index, offset) = table.entrance(start);
        let cell = &table.cells[index];
        if cell.is_gap {
            return None;
        }
        let z = ((start.theta - offset - cell.centre) / cell.half).clamp(-1.0, 1.0);
        let (sin, cos) = start.direction;
        let (alpha, beta) = table.law.slip_acceleration(sin, cos);
        let u = start.theta_rate * start.theta_rate;
        let slip_acceleration = alpha + beta * u;
        Some(Self {
            table,
            allowed,
            integral: start.slip - start.theta_rate * table.law.lever(sin, cos),
            index,
            offset,
            travel: start.theta_rate.signum(),
            here: Waypoint { z, u, elapsed: 0.0, slip: start.slip, slip_acceleration, direction: (sin, cos) },
            whole: false,
            turns: None,
            least: start.slip,
            last: None,
            far: None,
        })
    }

    /// Crosses whole cells in which nothing happens and θ′ changes little, at most so many: how many.
    fn cross_cells(&mut self, most: usize) -> usize {
        if !(self.whole && is_fast(&self.here)) {
            return 0;
        }
        let Self { table, allowed, integral, travel, .. } = *self;
        let law = &table.law;
        let forward = travel > 0.0;
        let bottom = self.bottom();
        let Waypoint { mut u, mut elapsed, mut slip, mut slip_acceleration, mut direction, .. } = self.here;
        let (mut index, mut offset, mut least) = (self.index, self.offset, self.least);
        let mut crossed = 0;
        while crossed < most {
            let cell = &table.cells[index];
            if cell.is_gap {
                break;
            }
            let (entry, exit) = (&cell.edges[usize::from(!forward)], &cell.edges[usize::from(forward)]);
            let level = (u - entry.p) / entry.h;
            let exit_u = exit.p + level * exit.h;
            let stays = contact(1.0, law.body.h, exit.cos * exit_u) >= 0.0;
            if !(is_smooth(u, exit_u) && stays && exit_u >= MIN_RATE * MIN_RATE) {
                break;
            }
            let exit_acceleration = exit.alpha + exit.beta * exit_u;
            if may_rise(slip_acceleration, exit_acceleration, exit_u) && slip > 0.0 {
                break;
            }
            let later = elapsed + cell.whole_time(level, is_within(EVEN, (u, exit_u)));
            let exit_slip = integral + travel * exit_u.sqrt() * exit.lever - law.friction * later;
            if exit_slip <= 0.0 || later > allowed {
                break;
            }
            (u, elapsed, slip, slip_acceleration) = (exit_u, later, exit_slip, exit_acceleration);
            direction = (0.0, exit.cos);
            least = least.min(slip);
            (index, offset) = table.neighbour(index, offset, forward);
            crossed += 1;
            if index == bottom {
                break;
            }
        }
        if crossed > 0 {
            self.here = Waypoint { z: -travel, u, elapsed, slip, slip_acceleration, direction };
            (self.index, self.offset, self.least) = (index, offset, least);
            if index == bottom {
                self.pass_bottom();
            }
        }
        crossed
    }

    /// The cell behind the bottom on the way.
    fn bottom(&self) -> usize {
        if self.travel > 0.0 { self.table.bottom } else { self.table.bottom - 1 }
    }

    /// Passes a cell, or leads to the end in it.
    fn pass_cell(&mut self) -> Option<Option<SlideEnd>> {
        let Self { table, index, travel, here, .. } = *self;
        let cell = &table.cells[index];
        if cell.is_gap {
            return None;
        }
        let level = if self.whole {
            let entry = &cell.edges[usize::from(travel < 0.0)];
            (here.u - entry.p) / entry.h
        } else {
            cell.level(here.u, here.z)
        };
        let exit = &cell.edges[usize::from(travel > 0.0)];
        let exit_u = exit.p + level * exit.h;
        if !is_smooth(here.u, exit_u) {
            return self.pass_unevenly(cell, level, exit_u);
        }
        let lifts_off = contact(1.0, table.law.body.h, exit.cos * exit_u) < 0.0;
        let crossing = || Crossing { cell, motion: cell.motion(level), travel };
        let there = if lifts_off {
            self.way(&crossing(), travel).lift_off(&here, travel)?
        } else {
            let is_even = is_within(EVEN, (here.u, exit_u));
            let time = if self.whole {
                cell.whole_time(level, is_even)
            } else {
                cell.time(&cell.motion(level), here.z.min(travel), here.z.max(travel), is_even)
            };
            let elapsed = here.elapsed + time;
            let rate = travel * exit_u.sqrt();
            Waypoint {
                z: travel,
                u: exit_u,
                elapsed,
                slip: self.integral + rate * exit.lever - table.law.friction * elapsed,
                slip_acceleration: exit.alpha + exit.beta * exit_u,
                direction: (0.0, exit.cos),
            }
        };
        let passed = if lifts_off || there.slip <= 0.0 || may_be_least_between(&here, &there) {
            pass(&self.way(&crossing(), travel), &here, there, lifts_off)?
        } else {
            Passed::to(End::Open, there)
        };
        if passed.at.elapsed > self.allowed {
            let cut = self.cut(&self.way(&crossing(), travel), &here, passed)?;
            return self.cross(&cut);
        }
        self.cross(&passed)
    }

    /// What was passed from a place on, cut at the limit of time.
    fn cut<P: Piece>(&self, way: &Way<'_, P>, here: &Waypoint, passed: Passed) -> Option<Passed> {
        if passed.at.elapsed <= self.allowed {
            return Some(passed);
        }
        way.at_time(here, &passed.at, self.allowed).map(|at| Passed::to(End::Cut, at))
    }

    /// Goes on behind a cell that was crossed, or says where the slide has ended in it.
    fn cross(&mut self, passed: &Passed) -> Option<Option<SlideEnd>> {
        let at = &passed.at;
        let is_fast = is_fast(&self.here) && is_fast(at);
        is_fast.then(|| self.go_on(passed, at.z, self.travel * at.u.sqrt()))
    }

    /// Passes a cell in which θ′ changes much, or its sign.
    fn pass_unevenly(&mut self, cell: &Cell, level: f64, exit_u: f64) -> Option<Option<SlideEnd>> {
        let (here, travel) = (self.here, self.travel);
        let motion = cell.motion(level);
        let ratio = exit_u / here.u;
        let is_steep = !(ratio > 1.0 / UNEVEN && ratio < UNEVEN);
        let turning =
            is_steep.then(|| Turning::new(cell, &motion, (here.z, here.u), (travel, exit_u))).flatten();
        let Some(turning) = turning else {
            let crossing = Crossing { cell, motion, travel };
            let way = self.way(&crossing, travel);
            let passed = self.cut(&way, &here, pass_to(&way, &here, travel)?)?;
            return self.cross(&passed);
        };
        let way = self.way(&turning, 1.0);
        let is_before = turning.travel() == travel;
        let entrance = turning.coordinate_of(here.z, here.u);
        if (turning.u(entrance) - here.u).abs() > 2.0 * RATE_ERROR * here.u.sqrt() {
            return None;
        }
        let from = Waypoint { z: if is_before { -entrance } else { entrance }, ..here };
        let passed = if is_before && turning.is_inside() {
            match self.cut(&way, &from, pass_to(&way, &from, 0.0)?)? {
                Passed { end: End::Open, at: middle, least } => {
                    self.least = self.least.min(least);
                    let angle = self.offset + (cell.centre + cell.half * turning.place(0.0));
                    self.turns = Some(Turns::another(self.turns, angle));
                    self.travel = -self.travel;
                    let passed = pass_to(&way, &middle, turning.coordinate(self.travel))?;
                    self.cut(&way, &middle, passed)?
                }
                ended => ended,
            }
        } else {
            let exit = turning.coordinate(self.travel);
            self.cut(&way, &from, pass_to(&way, &from, if is_before { -exit } else { exit })?)?
        };
        // About the turning point the time is known from θ′, but the next cell knows the angle.
        let at = &passed.at;
        let is_known = passed.end != End::Open || is_fast(at);
        is_known.then(|| self.go_on(&passed, turning.place(at.z), turning.rate(at.z, at.u)))
    }

    /// Takes note of a passage of the bottom.
    ///
    /// Of a libration, whole periods ahead without an event are passed: friction does not ask for the sign of θ′, so that θ′² is the same
    /// function of the angle in all of them, and η′ falls by μk times the period in each. Without kinetic friction a rotation has periods, too, and no event
    /// follows a whole one without.
    fn pass_bottom(&mut self) {
        let Self { here: Waypoint { elapsed, slip, .. }, offset, travel, .. } = *self;
        let here = Passage { elapsed, offset, travel };
        let Some(last) = self.last else {
            (self.last, self.least) = (Some(here), slip);
            return;
        };
        if last.travel != travel {
            // Back from a turning point: half a period, or the end of a rotation, which goes back.
            if last.offset != offset {
                (self.last, self.least) = (Some(here), slip);
            }
            return;
        }
        let period = elapsed - last.elapsed;
        let allowed = (self.allowed - elapsed) / period;
        if self.table.law.friction == 0.0 {
            self.repeat(period, offset - last.offset, allowed);
            return;
        }
        let loss = self.table.law.friction * period;
        let periods = (self.least / loss).min(allowed);
        if last.offset != offset {
            self.far = (periods > MOST_TURNS as f64).then_some(Far::Long);
        } else if period > 0.0 && periods > MOST_PERIODS {
            self.far = Some(Far::Long);
        } else if period > 0.0 && periods > 3.0 {
            // Where rounding tells, they are followed.
            let free = periods.floor() - 2.0;
            self.here.elapsed += free * period;
            self.here.slip -= free * loss;
        }
        self.last = Some(Passage { elapsed: self.here.elapsed, ..here });
        self.least = self.here.slip;
    }

    /// Passes the whole periods that are left, each of which lasts so long and takes the angle so far, of a slide without kinetic friction.
    fn repeat(&mut self, period: f64, advance: f64, allowed: f64) {
        if allowed == f64::INFINITY {
            self.far = Some(Far::Never);
        } else if allowed > MOST_PERIODS {
            self.far = Some(Far::Long);
        } else {
            // What is left is no less than nothing, whatever rounding does.
            let whole = allowed.floor();
            let periods = if self.here.elapsed + whole * period > self.allowed { whole - 1.0 } else { whole };
            self.here.elapsed += periods * period;
            self.offset += periods * advance;
            self.turns = self.turns.map(|turns| turns.after(periods));
        }
    }

    fn way<'b, P: Piece>(&self, piece: &'b P, forward: f64) -> Way<'b, P>
    where
        'a: 'b,
    {
        Way { law: &self.table.law, piece, forward, sigma: 1.0, integral: self.integral }
    }

    /// Goes on to the next cell, or says where the slide has ended, at z of the cell.
    fn go_on(&mut self, passed: &Passed, z: f64, theta_rate: f64) -> Option<SlideEnd> {
        let at = passed.at;
        match passed.end {
            End::Open => {
                self.least = self.least.min(passed.least);
                (self.index, self.offset) = self.table.neighbour(self.index, self.offset, self.travel > 0.0);
                self.here = Waypoint { z: -self.travel, ..at };
                self.whole = true;
                if self.index == self.bottom() {
                    self.pass_bottom();
                }
                return None;
            }
            End::Rest | End::LiftOff | End::Cut => {}
        }
        let cell = &self.table.cells[self.index];
        let event = SlideEvent {
            elapsed: at.elapsed,
            theta: self.offset + (cell.centre + cell.half * z),
            theta_rate,
            slip: if passed.end == End::Rest { 0.0 } else { at.slip },
            direction: at.direction,
            lifts_off: passed.end == End::LiftOff,
            turns: self.turns,
        };
        Some(if passed.end == End::Cut { SlideEnd::Cut(event) } else { SlideEnd::Event(event) })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::hoop::{Body, Hoop};

    /// Cells are crossed one after the other up to the bottom, or as many as are asked for: to where they are passed one by one.
    #[test]
    fn whole_cells_are_crossed_in_one_go() {
        let Body::Heavy(body) = Hoop::figure_2(0.5, 0.4).unwrap().body() else { unreachable!("it has mass") };
        let table = SlideTable::new(&body, 0.4).unwrap();
        let begins = |theta: f64, theta_rate: f64| {
            let start = SlideStart { theta, theta_rate, slip: 30.0, direction: libm::sincos(theta) };
            let mut follower = Follower::new(&table, &start, f64::INFINITY).unwrap();
            assert_eq!(follower.cross_cells(usize::MAX), 0, "the way does not begin at the end of a cell");
            assert!(matches!(follower.pass_cell(), Some(None)));
            follower
        };
        for (theta, theta_rate) in [(3.5, 1.2), (2.7, -1.2), (-2.5, 1.2), (10.0, 1.3)] {
            let mut all = begins(theta, theta_rate);
            let crossed = all.cross_cells(usize::MAX);
            assert!(crossed >= 3, "{theta} {theta_rate}: {crossed}");
            for most in [0, 1, 3] {
                assert_eq!(begins(theta, theta_rate).cross_cells(most), most);
            }
            let mut single = begins(theta, theta_rate);
            for _ in 0..crossed {
                assert!(matches!(single.pass_cell(), Some(None)));
            }
            assert_eq!((all.index, all.offset, all.least), (single.index, single.offset, single.least));
            assert!((all.here.u - single.here.u).abs() < 1e-14 * all.here.u, "{theta} {theta_rate}");
            assert!((all.here.elapsed - single.here.elapsed).abs() < 1e-14 * all.here.elapsed);
            assert!((all.here.slip - single.here.slip).abs() < 1e-13);
            assert!((all.here.slip_acceleration - single.here.slip_acceleration).abs() < 1e-13);
        }
    }
}
