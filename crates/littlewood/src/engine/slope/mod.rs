//! Rolling on a slope, to its slip, by tables of a sixteenth of a turn (docs/engine.md).
//!
//! In the direction of motion, at the distance φ from the beginning of a table, G = D ϑ′² is g +
//! γ(φ), with a function γ of the body and the slope, and one number g of the orbit. The first to
//! vanish of the two margins of static friction ([`MarginSeries`]) and G decides what happens.

mod table;

use core::f64::consts::TAU;
use std::sync::OnceLock;

use crate::math::bernstein::{Bernstein, value_and_slope};
use crate::math::series::{shifted, value};
use crate::math::trig::{Angle, without_turns};
use crate::mechanics::RollingLaw;
use crate::model::{Hoop, MAX_COORDINATE, SlipDirection};
use crate::modes::rolling::MarginSeries;

use super::fallback::Fallback;
use super::orbit::OrbitPoint;
use super::roll::{MIN_RATE, OrbitRange, RollEnd, RollSlip, RoundedNumber, mirrored_slip};
use super::state::EngineState;
use table::{
    LocalExpansion, MAX_BEND, RollTable, TABLES, WIDTH, energy_variation, rotated,
    separatrix_distance,
};

/// An orbit is followed for so many turns. The slip of a longer one is left to the exact solver,
/// which finds its turn by bisection.
const MAX_TURNS: usize = 32;

/// A turning point nearer than this part of the distance on which time is a sum in the square root
/// of the distance is where a leg begins.
const MAX_PART_BESIDE_TURN: f64 = 0.1;

const MAX_HALVINGS: u32 = 24;

/// Newton's method for the point at a time ends with a shorter step: its error is of the second
/// order.
const MAX_LAST_STEP: f64 = 1e-9;
const MAX_STEPS: u32 = 12;

/// Rolling in one direction of motion: tables that are made when an orbit first needs them, and are
/// the same whichever orbit that is.
#[derive(Clone, Debug)]
pub(super) struct SlopeTables {
    limits: MarginSeries,
    tables: [OnceLock<Box<RollTable>>; TABLES],
    turn: OnceLock<WholeTurn>,
}

/// A whole turn, from the beginning of the first table.
#[derive(Clone, Debug)]
struct WholeTurn {
    /// What G gains over each table.
    gains: [f64; TABLES],
    /// The g of orbits that certainly pass all tables.
    g_range: OrbitRange,
}

impl SlopeTables {
    pub(super) fn new(hoop: &Hoop, heading: f64) -> Self {
        Self {
            limits: MarginSeries::new(hoop, heading),
            tables: [const { OnceLock::new() }; TABLES],
            turn: OnceLock::new(),
        }
    }

    fn law(&self) -> &RollingLaw {
        &self.limits.law
    }

    fn table(&self, number: usize) -> &RollTable {
        let number = number % TABLES;
        self.tables[number].get_or_init(|| Box::new(RollTable::new(&self.limits, number)))
    }

    fn turn(&self) -> &WholeTurn {
        self.turn.get_or_init(|| WholeTurn::new(self))
    }
}

impl WholeTurn {
    fn new(tables: &SlopeTables) -> Self {
        let gains = core::array::from_fn(|number| tables.table(number).gain);
        let (mut gained, mut g_range) = (0.0, OrbitRange::ALL);
        for (number, gain) in gains.iter().enumerate() {
            let from_first = tables.table(number).g_range.shifted(-gained);
            g_range = g_range.intersection(from_first);
            gained += gain;
        }
        // g of an orbit, which adds gain to gain, has as many roundings as there are tables, and so
        // have the shifts.
        let gained: f64 = gains.iter().map(|gain| gain.abs()).sum();
        let part = 2.0 * TABLES as f64 * f64::EPSILON;
        Self {
            gains,
            g_range: g_range.narrowed(part, gained),
        }
    }
}

/// A part of an orbit in one direction of motion.
struct Leg<'a> {
    tables: &'a SlopeTables,
    /// −1 where the motion began the other way.
    mirror: f64,
    /// At the beginning, in the frame of this leg.
    theta: f64,
    /// The table at its beginning, the distance there, and g of the table.
    table: usize,
    from: f64,
    g: f64,
    /// How far behind its beginning a turning point is, if it is next to it.
    past_turn: Option<f64>,
    /// G about the beginning, or that turning point: next to it G is less than the last digits of
    /// `g`.
    origin: LocalExpansion,
}

/// The start of a leg, perhaps just past a turning point.
struct LegStart {
    theta: f64,
    angle: Angle,
    /// G there.
    twice_kinetic: f64,
    past_turn: Option<f64>,
}

#[derive(Clone, Copy)]
struct TablePoint {
    /// So many tables behind the first.
    tables: usize,
    at: f64,
    /// g of its table.
    g: f64,
}

enum LegEnd {
    Slip {
        point: TablePoint,
        slip: SlipDirection,
    },
    Turn(TablePoint),
    /// Neither up to there.
    Open(TablePoint),
}

/// Distances on a table.
#[derive(Clone, Copy)]
struct TableSpan {
    from: f64,
    to: f64,
}

/// A part of a leg on a table, or next to a turning point, with its time.
struct TimedSegment {
    /// None where the sum would take too many nodes.
    time: Option<f64>,
    /// None next to a turning point.
    on: Option<(TablePoint, TableSpan)>,
}

/// The part of a leg next to a turning point.
struct TurnPart {
    expansion: LocalExpansion,
    /// 1 behind the turning point, −1 before it.
    side: f64,
    /// Its length.
    reach: f64,
}

impl TurnPart {
    fn new(expansion: LocalExpansion, side: f64) -> Self {
        Self {
            expansion,
            side,
            reach: expansion.turning_radius().min(WIDTH),
        }
    }

    fn segment(&self, from: f64, to: f64) -> TimedSegment {
        let time = |distance| self.expansion.time_from_turn(distance, self.side);
        TimedSegment {
            time: Some(time(to) - time(from)),
            on: None,
        }
    }
}

impl<'a> Leg<'a> {
    fn enter(tables: &'a SlopeTables, mirror: f64, start: LegStart) -> Self {
        let LegStart {
            theta,
            angle,
            twice_kinetic,
            past_turn,
        } = start;
        let rest = without_turns(theta);
        let rest = if rest < 0.0 { rest + TAU } else { rest };
        let table = ((rest / WIDTH) as usize).min(TABLES - 1);
        let from = (rest - WIDTH * table as f64).clamp(0.0, WIDTH);
        let (g, past) = past_turn.map_or((twice_kinetic, 0.0), |distance| (0.0, distance));
        let origin = LocalExpansion::new(tables.law(), rotated(angle, -past), g);
        let g = g - tables.table(table).expansion.gain(from - past);
        Self {
            tables,
            mirror,
            theta,
            table,
            from,
            g,
            past_turn,
            origin,
        }
    }

    /// From the end of this one at a turning point, the other way.
    fn back<'b>(&self, point: TablePoint, tables: &'b SlopeTables) -> Leg<'b> {
        let table = TABLES - 1 - (self.table + point.tables) % TABLES;
        let (from, first) = (WIDTH - point.at, tables.table(table));
        Leg {
            tables,
            mirror: -self.mirror,
            theta: -self.theta_at(&point),
            table,
            from,
            g: -first.expansion.gain(from),
            past_turn: Some(0.0),
            origin: LocalExpansion::new(tables.law(), rotated(first.angle, from), 0.0),
        }
    }

    fn theta_at(&self, point: &TablePoint) -> f64 {
        self.theta + self.distance(point)
    }

    fn table_of(&self, point: &TablePoint) -> &'a RollTable {
        self.tables.table(self.table + point.tables)
    }

    fn beginning(&self) -> TablePoint {
        TablePoint {
            tables: 0,
            at: self.from,
            g: self.g,
        }
    }

    /// The beginning of the next turn, if the orbit is at the beginning of one that it certainly
    /// passes.
    fn next_turn(&self, point: &TablePoint) -> Option<TablePoint> {
        let tables = point.tables + TABLES;
        let is_beginning = (self.table + point.tables).is_multiple_of(TABLES);
        // All tables are there behind the first turn.
        let may_pass = is_beginning && point.tables >= TABLES && tables <= MAX_TURNS * TABLES;
        let turn = may_pass.then(|| self.tables.turn())?;
        turn.g_range.contains(point.g).then(|| TablePoint {
            tables,
            at: 0.0,
            g: turn.gains.iter().fold(point.g, |g, gain| g + gain),
        })
    }

    /// The beginning of the next table.
    fn next(point: &TablePoint, table: &RollTable) -> TablePoint {
        TablePoint {
            tables: point.tables + 1,
            at: 0.0,
            g: point.g + table.gain,
        }
    }

    fn expansion(&self, point: &TablePoint) -> LocalExpansion {
        self.expansion_on(self.table_of(point), point, point.at)
    }

    /// G and D about a distance on the table of a point.
    fn expansion_on(&self, table: &RollTable, point: &TablePoint, at: f64) -> LocalExpansion {
        let distance =
            WIDTH * point.tables as f64 + (at - self.from) + self.past_turn.unwrap_or(0.0);
        let g = if distance <= MAX_BEND {
            self.origin.g + self.origin.gain(distance)
        } else {
            point.g + table.expansion.gain(at)
        };
        LocalExpansion::new(self.tables.law(), rotated(table.angle, at), g)
    }

    /// The time over a part of the table of a point, or the whole; none where it comes too close to
    /// a turning point.
    fn time_on(&self, table: &RollTable, point: &TablePoint, span: TableSpan) -> Option<f64> {
        let is_whole = span.from == 0.0 && span.to == WIDTH && point.g > table.smooth;
        if is_whole {
            Some(table.time(point.g))
        } else {
            self.time_by_halves(table, point, span, MAX_HALVINGS)
        }
    }

    fn time_by_halves(
        &self,
        table: &RollTable,
        point: &TablePoint,
        span: TableSpan,
        halvings: u32,
    ) -> Option<f64> {
        let TableSpan { from, to } = span;
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let expansion = self.expansion_on(table, point, middle);
        if expansion.is_smooth(half) {
            return Some(expansion.time(half));
        }
        let halvings = halvings.checked_sub(1)?;
        let [first, second] = [
            TableSpan { from, to: middle },
            TableSpan { from: middle, to },
        ];
        let first = self.time_by_halves(table, point, first, halvings)?;
        Some(first + self.time_by_halves(table, point, second, halvings)?)
    }

    fn distance(&self, point: &TablePoint) -> f64 {
        WIDTH * point.tables as f64 + (point.at - self.from)
    }

    /// Whether it may turn at a point: on neither side of the separatrix by rounding.
    fn turns_clearly(&self, point: &TablePoint) -> bool {
        let slope = self.expansion(point).slope;
        let law = self.tables.law();
        slope * slope > energy_variation(law) * separatrix_distance(law)
    }

    fn holds(&self, point: &TablePoint) -> bool {
        self.table_of(point).margins.iter().all(|margin| {
            let margin = RoundedNumber {
                value: value(&margin.on_orbit(point.g), point.at),
                scale: margin.size(point.g),
            };
            margin.is_clearly_positive()
        })
    }

    fn end(&self) -> Result<LegEnd, Fallback> {
        let beginning = self.beginning();
        if !self.holds(&beginning) {
            return Err(Fallback::FrictionLimit);
        }
        if self.past_turn.is_some() && !self.turns_clearly(&beginning) {
            return Err(Fallback::Separatrix);
        }
        let mut point = beginning;
        while point.tables <= MAX_TURNS * TABLES {
            if let Some(next) = self.next_turn(&point) {
                point = next;
                continue;
            }
            let table = self.table_of(&point);
            let starts_at_zero = self.past_turn.is_some() && point.tables == 0;
            // Most orbits certainly roll over a table.
            let passes = !starts_at_zero && table.g_range.contains(point.g);
            if !passes && let Some(end) = self.end_on(table, point, starts_at_zero)? {
                return Ok(end);
            }
            point = Self::next(&point, table);
        }
        if self.ends_within_bounds(&point) {
            Ok(LegEnd::Open(point))
        } else {
            Err(Fallback::TooLong)
        }
    }

    /// Whether an orbit certainly ends before it leaves the bounds of θ: of one that does not the
    /// simulation tells nothing, whatever the limit of time. Uphill G falls to zero; downhill the
    /// normal force vanishes at the top at the latest, where G is D/h.
    fn ends_within_bounds(&self, point: &TablePoint) -> bool {
        let law = self.tables.law();
        let top = law.denominator_of(Angle { sin: 0.0, cos: 1.0 });
        let most = point.g.abs() + energy_variation(law) + top * law.mass / law.offset;
        // G gains twice as much over the distance to the bounds.
        law.mass * law.tilt.abs() * MAX_COORDINATE > most
    }

    fn end_on(
        &self,
        table: &RollTable,
        point: TablePoint,
        starts_at_zero: bool,
    ) -> Result<Option<LegEnd>, Fallback> {
        let turn = table
            .twice_kinetic
            .crossing(point.g, point.at, starts_at_zero);
        let [negative, positive] = table
            .margins
            .each_ref()
            .map(|margin| margin.crossing(point.g, point.at, false));
        let slip = match (negative, positive) {
            (Some(negative), Some(positive)) if positive < negative => {
                Some((positive, SlipDirection::Positive))
            }
            (Some(negative), _) => Some((negative, SlipDirection::Negative)),
            (None, positive) => positive.map(|positive| (positive, SlipDirection::Positive)),
        };
        if let Some((at, slip)) = slip
            && turn.is_none_or(|turn| at < turn)
        {
            self.check_top(table, &point, at, starts_at_zero)?;
            return Ok(Some(LegEnd::Slip {
                point: TablePoint { at, ..point },
                slip,
            }));
        }
        if let Some(at) = turn {
            let point = TablePoint { at, ..point };
            if !self.turns_clearly(&point) {
                return Err(Fallback::Separatrix);
            }
            // Where it slips just so, or not, next to the turning point.
            return if self.holds(&point) {
                Ok(Some(LegEnd::Turn(point)))
            } else {
                Err(Fallback::FrictionLimit)
            };
        }
        self.check_top(table, &point, WIDTH, starts_at_zero)?;
        Ok(None)
    }

    /// Whether it clearly passes the top, if that is on a table between a point and a distance.
    fn check_top(
        &self,
        table: &RollTable,
        point: &TablePoint,
        to: f64,
        starts_at_zero: bool,
    ) -> Result<(), Fallback> {
        let rises = |at: f64| value_and_slope(&table.twice_kinetic.taylor[0], at).1 > 0.0;
        if starts_at_zero || rises(point.at) || !rises(to) {
            return Ok(());
        }
        // G has a minimum there: its Bernstein coefficients bound it.
        let ahead = shifted(table.twice_kinetic.on_orbit(point.g), point.at);
        let ahead = Bernstein::from_taylor(&ahead, to - point.at);
        let min = ahead
            .coefficients()
            .iter()
            .fold(f64::INFINITY, |min, c| min.min(*c));
        if min > separatrix_distance(self.tables.law()) {
            Ok(())
        } else {
            Err(Fallback::Separatrix)
        }
    }

    /// The time to a point, perhaps a turning point. None where it takes too many nodes.
    fn time(&self, point: &TablePoint, is_turn: bool) -> Option<f64> {
        let mut sum = 0.0;
        self.for_each_segment(point, is_turn, |segment| {
            sum += segment.time?;
            Some(false)
        })?;
        Some(sum)
    }

    /// Calls `visit` with the segments up to a point, perhaps a turning point, until it returns
    /// true.
    fn for_each_segment(
        &self,
        end: &TablePoint,
        is_turn: bool,
        mut visit: impl FnMut(TimedSegment) -> Option<bool>,
    ) -> Option<()> {
        // Distances from a turning point behind the beginning.
        let past = self.past_turn.unwrap_or(0.0);
        let length = past + self.distance(end);
        let behind = TablePoint {
            at: self.from - past,
            ..self.beginning()
        };
        let first = self.past_turn.is_some();
        let first = first.then(|| TurnPart::new(self.expansion(&behind), 1.0));
        let last = is_turn.then(|| TurnPart::new(self.expansion(end), -1.0));
        let [reach, last_reach] =
            [&first, &last].map(|part| part.as_ref().map_or(0.0, |part| part.reach));
        // Between two turning points close to each other each has its share.
        let all = reach + last_reach;
        let [reach, last_reach] = if all > length {
            [reach, last_reach].map(|reach| reach * (length / all))
        } else {
            [reach, last_reach]
        };
        let (reach, last_reach) = (reach.max(past), last_reach.min(length - past));
        if let Some(part) = &first
            && visit(part.segment(past, reach))?
        {
            return Some(());
        }
        let mut point = self.beginning();
        while point.tables <= end.tables {
            let table = self.table_of(&point);
            let behind = WIDTH * point.tables as f64;
            let from = (self.from + (reach - past) - behind).max(0.0);
            let to = (end.at - last_reach + WIDTH * (end.tables - point.tables) as f64).min(WIDTH);
            if from < to {
                let span = TableSpan { from, to };
                let time = self.time_on(table, &point, span);
                let on = Some((point, span));
                if visit(TimedSegment { time, on })? {
                    return Some(());
                }
            }
            point = Self::next(&point, table);
        }
        if let Some(part) = &last {
            visit(part.segment(0.0, last_reach))?;
        }
        Some(())
    }

    /// The angle at a point, in the frame in which the motion began.
    fn angle_at(&self, point: &TablePoint) -> Angle {
        rotated(self.table_of(point).angle, point.at).mirrored_by(self.mirror)
    }

    /// What is at a point, in the frame in which the motion began.
    fn orbit_point(&self, point: &TablePoint) -> OrbitPoint {
        let expansion = self.expansion(point);
        let rate = (expansion.g.max(0.0) / expansion.d).sqrt();
        OrbitPoint {
            theta: self.mirror * self.theta_at(point),
            theta_rate: self.mirror * rate,
        }
    }

    /// The slip at a point, of a leg that begins at the time `before`.
    fn slip(
        &self,
        point: &TablePoint,
        slip: SlipDirection,
        before: f64,
    ) -> Result<RollEnd, Fallback> {
        let OrbitPoint { theta, theta_rate } = self.orbit_point(point);
        if theta_rate.abs() < MIN_RATE {
            return Err(Fallback::Standstill);
        }
        let elapsed = before + self.time(point, false).ok_or(Fallback::Separatrix)?;
        Ok(RollEnd::Slip(RollSlip {
            elapsed,
            theta,
            theta_rate,
            slip: mirrored_slip(slip, self.mirror),
            angle: self.angle_at(point),
        }))
    }

    /// Where it is after a time, on the way to a point.
    fn after(&self, time: f64, end: &TablePoint, is_turn: bool) -> Option<TablePoint> {
        let (mut time_left, mut found) = (time, None);
        self.for_each_segment(end, is_turn, |segment| {
            let time = segment.time?;
            if time < time_left {
                time_left -= time;
                return Some(false);
            }
            found = segment.on;
            Some(true)
        })?;
        let (point, TableSpan { from, to }) = found?;
        let table = self.table_of(&point);
        let mut at = from + (to - from) * 0.5;
        for _ in 0..MAX_STEPS {
            let expansion = self.expansion_on(table, &point, at);
            let passed = self.time_on(table, &point, TableSpan { from, to: at })?;
            let step = (time_left - passed) / expansion.slowness(0.0)[0];
            at = (at + step).clamp(from, to);
            if step.abs() < MAX_LAST_STEP {
                return Some(TablePoint { at, ..point });
            }
        }
        None
    }
}

/// The legs of an orbit, seen in the frame of motion at its start.
struct Orbit<'a> {
    first: Leg<'a>,
    /// Of the second leg.
    back: &'a SlopeTables,
    /// From the start to the first leg, which begins at a turning point if that is next.
    distance: f64,
    before: f64,
}

impl<'a> Orbit<'a> {
    fn enter(tables: &'a [SlopeTables; 2], start: &EngineState) -> Self {
        let (heading, u) = (start.heading(), start.u());
        let [ahead, back] = if heading < 0.0 {
            [&tables[1], &tables[0]]
        } else {
            [&tables[0], &tables[1]]
        };
        let theta = heading * start.state.theta;
        let angle = start.angle.mirrored_by(heading);
        let twice_kinetic = ahead.law().denominator_of(angle) * u;
        let expansion = LocalExpansion::new(ahead.law(), angle, 0.0);
        // Next to a turning point the distance from it has all digits.
        let side = if expansion.slope < 0.0 { 1.0 } else { -1.0 };
        let reach = MAX_PART_BESIDE_TURN * expansion.turning_radius();
        let turn = expansion
            .turning_distance(twice_kinetic, side)
            .filter(|distance| *distance <= reach);
        let Some(distance) = turn.filter(|_| side > 0.0) else {
            let start = LegStart {
                theta,
                angle,
                twice_kinetic,
                past_turn: turn,
            };
            return Self {
                first: Leg::enter(ahead, 1.0, start),
                back,
                distance: 0.0,
                before: 0.0,
            };
        };
        let start = LegStart {
            theta: -(theta + distance),
            angle: rotated(angle, distance).mirrored(),
            twice_kinetic: 0.0,
            past_turn: Some(0.0),
        };
        let first = Leg::enter(back, -1.0, start);
        let turn = first.expansion(&first.beginning());
        Self {
            before: turn.time_from_turn(distance, 1.0),
            first,
            back: ahead,
            distance,
        }
    }
}

/// Follows the rolling that begins at a state, and holds there.
pub(super) fn solve_roll(
    tables: &[SlopeTables; 2],
    start: &EngineState,
) -> Result<RollEnd, Fallback> {
    let Orbit {
        first,
        back,
        distance,
        before,
    } = Orbit::enter(tables, start);
    let turn = match first.end()? {
        // It would have slipped on the way to the turning point.
        LegEnd::Slip { point, .. } if distance > 0.0 && first.distance(&point) <= distance => {
            return Err(Fallback::Standstill);
        }
        LegEnd::Slip { point, slip } => return first.slip(&point, slip, before),
        LegEnd::Open(_) => return Ok(RollEnd::Open),
        LegEnd::Turn(point) => point,
    };
    let back = first.back(turn, back);
    match back.end()? {
        LegEnd::Slip { point, slip } => {
            let outward = first.time(&turn, true).ok_or(Fallback::Separatrix)?;
            back.slip(&point, slip, before + outward)
        }
        LegEnd::Open(_) => Ok(RollEnd::Open),
        LegEnd::Turn(_) => Ok(RollEnd::Never),
    }
}

/// Where rolling from a state is after a time, before its slip. None where it is not followed so
/// long.
pub(super) fn after(
    tables: &[SlopeTables; 2],
    start: &EngineState,
    time: f64,
) -> Option<OrbitPoint> {
    let Orbit {
        first,
        back,
        before,
        ..
    } = Orbit::enter(tables, start);
    let time = time - before;
    if time < 0.0 {
        return None;
    }
    let turn = match first.end().ok()? {
        LegEnd::Slip { point, .. } | LegEnd::Open(point) => {
            return Some(first.orbit_point(&first.after(time, &point, false)?));
        }
        LegEnd::Turn(point) => point,
    };
    let outward = first.time(&turn, true)?;
    if time <= outward {
        return Some(first.orbit_point(&first.after(time, &turn, true)?));
    }
    let back = first.back(turn, back);
    let (LegEnd::Slip { point, .. } | LegEnd::Open(point)) = back.end().ok()? else {
        return None;
    };
    Some(back.orbit_point(&back.after(time - outward, &point, false)?))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::model::{HoopParameters, State};
    use crate::modes::{Rolling, RollingLimit};

    fn tables(hoop: &Hoop) -> [SlopeTables; 2] {
        [1.0, -1.0].map(|heading| SlopeTables::new(hoop, heading))
    }

    fn at(theta: f64, theta_rate: f64) -> State {
        State {
            time: 0.0,
            theta,
            theta_rate,
            slip: 0.0,
            x: 0.0,
        }
    }

    fn figure_2(slope: f64) -> Hoop {
        Hoop::new(
            HoopParameters::thin(1.0)
                .with_friction(0.5, 0.4)
                .with_slope(slope),
        )
        .unwrap()
    }

    /// An orbit that passes a whole turn passes each of its tables, also at the ends of the range.
    #[test]
    fn a_whole_turn_is_passed_table_by_table() {
        let mut passed = 0;
        for slope in [0.001, -0.003, 0.02] {
            let tables = SlopeTables::new(&figure_2(slope), 1.0);
            let WholeTurn { gains, g_range } = tables.turn();
            let between = (0..400).map(|k| 0.1 * f64::from(k));
            for start in between.chain([g_range.min.next_up(), g_range.max.next_down()]) {
                if !g_range.contains(start) {
                    continue;
                }
                let mut g = start;
                for (number, gain) in gains.iter().enumerate() {
                    let table = tables.table(number);
                    assert!(table.g_range.contains(g), "{slope} {start}: {number}");
                    assert_eq!(table.gain, *gain);
                    g += gain;
                }
                passed += 1;
            }
        }
        assert!(passed > 100, "{passed}");
    }

    /// Compares with the solver of the simulation, before the slip and at it.
    fn slips_and_is_where_rolling_is(
        hoop: &Hoop,
        state: State,
        part: f64,
    ) -> Result<(), TestCaseError> {
        let (tables, start) = (tables(hoop), EngineState::new(state));
        let Ok(RollEnd::Slip(RollSlip {
            elapsed,
            theta,
            theta_rate,
            slip,
            angle: Angle { sin, cos },
        })) = solve_roll(&tables, &start)
        else {
            return Ok(());
        };
        let rolling = Rolling::new(hoop, start.state);
        let end = rolling.orbit().end().expect("it slips");
        let heading = start.heading();
        prop_assert_eq!(
            end.limit,
            RollingLimit::Friction(mirrored_slip(slip, heading))
        );
        // What the rounding of an angle, or of a margin, changes of a slip whose margin falls
        // slowly.
        let tolerance = 1e-11 * (1.0 + elapsed);
        let differences = [
            end.theta - heading * theta,
            end.theta_rate - heading * theta_rate,
            end.elapsed - elapsed,
        ];
        for difference in differences {
            prop_assert!(difference.abs() < tolerance, "{end:?} {theta} {elapsed}");
        }
        // The direction is that of a tile, and the angle a sum of distances: its last digit is that
        // of the farthest angle on the way, which is at the turning point of an orbit that comes
        // back. Each leg rounds a product and three sums, and has the rounding of π in the width of
        // a tile, over at most twice that angle: 5 ε of it.
        let first = Orbit::enter(&tables, &start).first;
        let turn = match first.end() {
            Ok(LegEnd::Turn(spot)) => first.theta_at(&spot),
            Ok(LegEnd::Slip { .. } | LegEnd::Open(_)) | Err(_) => 0.0,
        };
        let farthest = state.theta.abs().max(turn.abs()).max(theta.abs());
        let rounding = 5.0 * f64::EPSILON * (TAU + farthest);
        let expected = libm::sincos(theta);
        prop_assert!(
            (sin - expected.0).abs() < rounding && (cos - expected.1).abs() < rounding,
            "{theta} {turn}: {} {} of {rounding}",
            sin - expected.0,
            cos - expected.1
        );
        let Some(found) = after(&tables, &start, part * elapsed) else {
            return Ok(());
        };
        let expected = rolling.state(part * elapsed);
        for (found, expected) in [
            (found.theta, expected.theta),
            (found.theta_rate, expected.theta_rate),
        ] {
            prop_assert!(
                (heading * found - expected).abs() < tolerance,
                "{found} {expected}"
            );
        }
        Ok(())
    }

    /// Rolls uphill for some turns, and slips on its way back near the angle of its start.
    #[test]
    fn the_angle_of_a_slip_after_a_turning_point_has_the_digits_of_the_turning_point() {
        let hoop = HoopParameters::thin(0.0)
            .with_offset(0.188_286_281_099_344_23)
            .with_inertia(1.122_189_506_955_056)
            .with_friction(0.784_080_345_085_936_9, 0.784_080_345_085_936_9)
            .with_slope(-0.042_621_970_910_048_75);
        let start = at(-0.330_178_489_793_628_57, 2.106_320_236_618_518);
        let found = slips_and_is_where_rolling_is(&Hoop::new(hoop).unwrap(), start, 0.5);
        assert!(found.is_ok(), "{found:?}");
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4_000))]

        #[test]
        fn an_orbit_slips_and_is_where_rolling_is(
            mass_ratio in prop_oneof![0.03..3.0_f64, Just(0.0)],
            offset in 0.05..1.0_f64,
            inertia in 0.01..2.0_f64,
            mu_s in 0.05..2.0_f64,
            slope in -1.2..1.2_f64,
            theta in -7.0..7.0_f64,
            theta_rate in prop_oneof![3 => -4.0..4.0_f64, 1 => -0.01..0.01_f64, 1 => Just(0.0)],
            part in 0.0..1.0_f64,
        ) {
            let hoop = HoopParameters::thin(mass_ratio).with_offset(offset).with_inertia(inertia);
            let hoop = Hoop::new(hoop.with_friction(mu_s, mu_s).with_slope(slope)).unwrap();
            slips_and_is_where_rolling_is(&hoop, at(theta, theta_rate), part)?;
        }
    }

    /// On a gentle slope most orbits slip after hundreds of turns, and after the limit of time.
    #[test]
    fn orbits_of_many_turns_are_followed_to_the_limit_of_time() {
        let until = 50.0;
        let mut open = 0;
        for (slope, k) in [0.001, -0.001]
            .into_iter()
            .flat_map(|it| (0..60).map(move |k| (it, k)))
        {
            let (hoop, heading) = (figure_2(slope), f64::signum(slope));
            let state = at(0.1 * f64::from(k), heading * (1.2 + 0.02 * f64::from(k)));
            let (tables, start) = (tables(&hoop), EngineState::new(state));
            let Ok(RollEnd::Open) = solve_roll(&tables, &start) else {
                continue;
            };
            open += 1;
            let rolling = Rolling::new(&hoop, state);
            let end = rolling.orbit().end().expect("it slips");
            assert!(end.elapsed > until, "{state:?}");
            let (found, expected) = (after(&tables, &start, until), rolling.state(until));
            let OrbitPoint { theta, theta_rate } = found.expect("it is followed");
            let tolerance = 1e-11 * (1.0 + until);
            assert!(
                (heading * theta - expected.theta).abs() < tolerance,
                "{state:?} {theta}"
            );
            assert!(
                (heading * theta_rate - expected.theta_rate).abs() < tolerance,
                "{state:?}"
            );
        }
        assert!(open > 30, "{open}");
    }

    /// What is not found is computed for much longer, which no test of answers would notice.
    #[test]
    fn nearly_all_orbits_are_followed() {
        for slope in [0.03, 0.1, -0.5, 1.0] {
            let tables = tables(&figure_2(slope));
            let (mut all, mut slips, mut found, mut left) = (0, 0, 0, 0);
            for (i, j) in (0..40).flat_map(|i| (0..40).map(move |j| (i, j))) {
                let start =
                    EngineState::new(at(0.16 * f64::from(i) - 3.1, 0.1 * f64::from(j) - 2.0));
                match solve_roll(&tables, &start) {
                    Ok(RollEnd::Slip(RollSlip { elapsed, .. })) => {
                        slips += 1;
                        found += usize::from(after(&tables, &start, 0.5 * elapsed).is_some());
                    }
                    Ok(RollEnd::Never | RollEnd::Open) => {}
                    // Where it does not roll.
                    Err(Fallback::FrictionLimit) => continue,
                    Err(_) => left += 1,
                }
                all += 1;
            }
            assert!(all > 200 && 20 * left < all, "{slope}: {left} of {all}");
            assert!(
                slips > 100 && 3 * found > 2 * slips,
                "{slope}: {found} of {slips}"
            );
        }
    }
}
