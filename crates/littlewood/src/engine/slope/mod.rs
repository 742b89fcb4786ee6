//! Rolling on a slope, to its slip, by tiles of a turn (docs/engine.md).
//!
//! In the direction of motion, at the distance φ from the beginning of a tile, G = D ϑ′² is g +
//! γ(φ), with a function γ of the body and the slope, and one number g of the orbit. The first to
//! vanish of the two margins of static friction ([`Limits`]) and G decides what happens.

mod table;

use core::f64::consts::TAU;
use std::sync::OnceLock;

use crate::math::bernstein::{Bernstein, value_and_slope};
use crate::math::series::{shifted, value};
use crate::math::trig::without_turns;
use crate::mechanics::RollingLaw;
use crate::model::Hoop;
use crate::modes::rolling::Limits;

use super::fallback::Fallback;
use super::orbit::Reached;
use super::roll::{MIN_RATE, RollEnd, breaks};
use super::state::EngineState;
use table::{
    LocalExpansion, MAX_BEND, RollTable, TABLES, WIDTH, rotated, separatrix_distance, swing,
};

/// An orbit of more turns is left to the exact solver, which finds the turn of a slip by bisection.
const MAX_TURNS: usize = 32;

/// A turning point nearer than this part of the distance on which time is such a sum is where a leg
/// begins.
const MAX_PART_BESIDE_TURN: f64 = 0.1;

const MAX_HALVINGS: u32 = 24;

/// Newton's method for the place at a time ends with a shorter step: its error is of the second
/// order.
const MAX_LAST_STEP: f64 = 1e-9;
const MAX_STEPS: u32 = 12;

/// Rolling in one direction of motion: what is kept of it, made where orbits come, and the same
/// whichever orbit that is.
#[derive(Clone, Debug)]
pub(super) struct SlopeTables {
    limits: Limits,
    tiles: [OnceLock<Box<RollTable>>; TABLES],
}

impl SlopeTables {
    /// In the direction `travel`.
    pub(super) fn new(hoop: &Hoop, travel: f64) -> Self {
        Self {
            limits: Limits::new(hoop, travel),
            tiles: [const { OnceLock::new() }; TABLES],
        }
    }

    fn law(&self) -> &RollingLaw {
        &self.limits.law
    }

    fn tile(&self, number: usize) -> &RollTable {
        let number = number % TABLES;
        self.tiles[number].get_or_init(|| Box::new(RollTable::new(&self.limits, number)))
    }
}

/// A part of an orbit in one direction of motion.
struct Leg<'a> {
    ramp: &'a SlopeTables,
    /// −1 where the motion began the other way, and the angle at the beginning in the frame of this
    /// one.
    sign: f64,
    theta: f64,
    /// The tile at its beginning, the place there, and g of the tile.
    tile: usize,
    from: f64,
    level: f64,
    /// How far behind its beginning a turning point is, if it is next to it.
    past_turn: Option<f64>,
    /// G about the beginning, or that turning point: next to it G is less than the last digits of
    /// `level`.
    origin: LocalExpansion,
}

#[derive(Clone, Copy)]
struct TablePoint {
    /// So many tiles behind the first.
    tiles: usize,
    at: f64,
    /// g of its tile.
    level: f64,
}

enum LegEnd {
    Slip { spot: TablePoint, side: usize },
    Turn(TablePoint),
}

impl<'a> Leg<'a> {
    /// From an angle with this sine and cosine, at which G is `kinetic`, or a turning point is so
    /// far behind.
    fn enter(
        (ramp, sign): (&'a SlopeTables, f64),
        (theta, direction): (f64, (f64, f64)),
        kinetic: f64,
        past_turn: Option<f64>,
    ) -> Self {
        let rest = without_turns(theta);
        let rest = if rest < 0.0 { rest + TAU } else { rest };
        let tile = ((rest / WIDTH) as usize).min(TABLES - 1);
        let from = (rest - WIDTH * tile as f64).clamp(0.0, WIDTH);
        let (g, past) = past_turn.map_or((kinetic, 0.0), |distance| (0.0, distance));
        let origin = LocalExpansion::new(ramp.law(), rotated(direction, -past), g);
        let level = g - ramp.tile(tile).about.gain(from - past);
        Self {
            ramp,
            sign,
            theta,
            tile,
            from,
            level,
            past_turn,
            origin,
        }
    }

    /// From the end of this one at a turning point, the other way.
    fn back<'b>(&self, spot: TablePoint, ramp: &'b SlopeTables) -> Leg<'b> {
        let tile = TABLES - 1 - (self.tile + spot.tiles) % TABLES;
        let (from, first) = (WIDTH - spot.at, ramp.tile(tile));
        let origin = LocalExpansion::new(ramp.law(), rotated(first.direction, from), 0.0);
        let (sign, theta) = (-self.sign, -self.angle(&spot));
        let (level, past_turn) = (-first.about.gain(from), Some(0.0));
        Leg {
            ramp,
            sign,
            theta,
            tile,
            from,
            level,
            past_turn,
            origin,
        }
    }

    fn angle(&self, spot: &TablePoint) -> f64 {
        self.theta + self.distance(spot)
    }

    fn tile_of(&self, spot: &TablePoint) -> &'a RollTable {
        self.ramp.tile(self.tile + spot.tiles)
    }

    fn beginning(&self) -> TablePoint {
        TablePoint {
            tiles: 0,
            at: self.from,
            level: self.level,
        }
    }

    fn about(&self, spot: &TablePoint) -> LocalExpansion {
        self.about_on(self.tile_of(spot), spot, spot.at)
    }

    /// G and D about a place on the tile of a spot.
    fn about_on(&self, tile: &RollTable, spot: &TablePoint, at: f64) -> LocalExpansion {
        let distance = WIDTH * spot.tiles as f64 + (at - self.from) + self.past_turn.unwrap_or(0.0);
        let g = if distance <= MAX_BEND {
            self.origin.g + self.origin.gain(distance)
        } else {
            spot.level + tile.about.gain(at)
        };
        LocalExpansion::new(self.ramp.law(), rotated(tile.direction, at), g)
    }

    /// The time between two places on the tile of a spot, or over the whole; none where it comes
    /// too close to a turning point.
    fn time_on(&self, tile: &RollTable, spot: &TablePoint, [from, to]: [f64; 2]) -> Option<f64> {
        let is_whole = from == 0.0 && to == WIDTH && spot.level > tile.smooth;
        if is_whole {
            Some(tile.time(spot.level))
        } else {
            self.time_of_parts(tile, spot, [from, to], MAX_HALVINGS)
        }
    }

    fn time_of_parts(
        &self,
        tile: &RollTable,
        spot: &TablePoint,
        [from, to]: [f64; 2],
        halvings: u32,
    ) -> Option<f64> {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let about = self.about_on(tile, spot, middle);
        if about.is_smooth(half) {
            return Some(about.time(half));
        }
        let halvings = halvings.checked_sub(1)?;
        let first = self.time_of_parts(tile, spot, [from, middle], halvings)?;
        Some(first + self.time_of_parts(tile, spot, [middle, to], halvings)?)
    }

    fn distance(&self, spot: &TablePoint) -> f64 {
        WIDTH * spot.tiles as f64 + (spot.at - self.from)
    }

    /// Whether it may turn at a spot: on neither side of the separatrix by rounding.
    fn turns_clearly(&self, spot: &TablePoint) -> bool {
        let slope = self.about(spot).slope;
        let law = self.ramp.law();
        slope * slope > swing(law) * separatrix_distance(law)
    }

    fn holds(&self, spot: &TablePoint) -> bool {
        let here = self.tile_of(spot).margins.each_ref().map(|margin| {
            let size = margin.size(spot.level);
            (value(&margin.on_orbit(spot.level), spot.at), size)
        });
        breaks(&here) == Some(None)
    }

    fn end(&self) -> Result<LegEnd, Fallback> {
        let beginning = self.beginning();
        if !self.holds(&beginning) {
            return Err(Fallback::FrictionLimit);
        }
        if self.past_turn.is_some() && !self.turns_clearly(&beginning) {
            return Err(Fallback::Separatrix);
        }
        let mut spot = beginning;
        while spot.tiles <= MAX_TURNS * TABLES {
            let tile = self.tile_of(&spot);
            let starts_at_zero = self.past_turn.is_some() && spot.tiles == 0;
            let passes =
                !starts_at_zero && spot.level > tile.levels.0 && spot.level < tile.levels.1;
            if !passes && let Some(end) = self.end_on(tile, spot, starts_at_zero)? {
                return Ok(end);
            }
            spot = TablePoint {
                tiles: spot.tiles + 1,
                at: 0.0,
                level: spot.level + tile.gain,
            };
        }
        Err(Fallback::TooLong)
    }

    fn end_on(
        &self,
        tile: &RollTable,
        spot: TablePoint,
        starts_at_zero: bool,
    ) -> Result<Option<LegEnd>, Fallback> {
        let level = spot.level;
        let turn = tile.kinetic.crossing(level, (spot.at, starts_at_zero));
        let [negative, positive] = tile
            .margins
            .each_ref()
            .map(|margin| margin.crossing(level, (spot.at, false)));
        let slip = match (negative, positive) {
            (Some(negative), Some(positive)) if positive < negative => Some((positive, 1)),
            (Some(negative), _) => Some((negative, 0)),
            (None, positive) => positive.map(|positive| (positive, 1)),
        };
        if let Some((at, side)) = slip
            && turn.is_none_or(|turn| at < turn)
        {
            self.check_top(tile, &spot, at, starts_at_zero)?;
            return Ok(Some(LegEnd::Slip {
                spot: TablePoint { at, ..spot },
                side,
            }));
        }
        if let Some(at) = turn {
            let spot = TablePoint { at, ..spot };
            if !self.turns_clearly(&spot) {
                return Err(Fallback::Separatrix);
            }
            // Where it slips just so, or not, next to the turning point.
            return if self.holds(&spot) {
                Ok(Some(LegEnd::Turn(spot)))
            } else {
                Err(Fallback::FrictionLimit)
            };
        }
        self.check_top(tile, &spot, WIDTH, starts_at_zero)?;
        Ok(None)
    }

    /// Whether it clearly passes the top, if that is on a tile between a place and another.
    fn check_top(
        &self,
        tile: &RollTable,
        spot: &TablePoint,
        to: f64,
        starts_at_zero: bool,
    ) -> Result<(), Fallback> {
        let rises = |at: f64| value_and_slope(&tile.kinetic.taylor[0], at).1 > 0.0;
        if starts_at_zero || rises(spot.at) || !rises(to) {
            return Ok(());
        }
        let ahead = shifted(tile.kinetic.on_orbit(spot.level), spot.at);
        let ahead = Bernstein::from_taylor(&ahead, to - spot.at);
        let least = ahead
            .coefficients()
            .iter()
            .fold(f64::INFINITY, |least, c| least.min(*c));
        if least > separatrix_distance(self.ramp.law()) {
            Ok(())
        } else {
            Err(Fallback::Separatrix)
        }
    }

    /// The time to a spot, perhaps a turning point. None where it takes too many nodes.
    fn time(&self, spot: &TablePoint, is_turn: bool) -> Option<f64> {
        let mut sum = 0.0;
        self.pieces(spot, is_turn, |piece| {
            sum += piece.time?;
            Some(false)
        })?;
        Some(sum)
    }

    /// Passes its pieces up to a spot, until one is the last that is wanted.
    fn pieces(
        &self,
        spot: &TablePoint,
        is_turn: bool,
        mut pass: impl FnMut(TimedSegment) -> Option<bool>,
    ) -> Option<()> {
        // Distances from a turning point behind the beginning.
        let past = self.past_turn.unwrap_or(0.0);
        let length = past + self.distance(spot);
        let behind = TablePoint {
            at: self.from - past,
            ..self.beginning()
        };
        let turns = [
            (self.past_turn.is_some(), behind, 1.0),
            (is_turn, *spot, -1.0),
        ];
        let turns = turns.map(|(turns, spot, side)| turns.then(|| (self.about(&spot), side)));
        let reach =
            turns.map(|turn| turn.map_or(0.0, |(about, _)| about.reach_of_turn().min(WIDTH)));
        let all = reach[0] + reach[1];
        let reach = if all > length {
            reach.map(|reach| reach * (length / all))
        } else {
            reach
        };
        let reach = [reach[0].max(past), reach[1].min(length - past)];
        let time_of = |turn: Option<(LocalExpansion, f64)>, [from, to]: [f64; 2]| {
            turn.map(|(about, side)| {
                let time = about.time_from_turn(to, side) - about.time_from_turn(from, side);
                TimedSegment {
                    time: Some(time),
                    on: None,
                }
            })
        };
        if let Some(piece) = time_of(turns[0], [past, reach[0]])
            && pass(piece)?
        {
            return Some(());
        }
        let mut here = self.beginning();
        while here.tiles <= spot.tiles {
            let tile = self.tile_of(&here);
            let behind = WIDTH * here.tiles as f64;
            let from = (self.from + (reach[0] - past) - behind).max(0.0);
            let to = (spot.at - reach[1] + WIDTH * (spot.tiles - here.tiles) as f64).min(WIDTH);
            if from < to {
                let time = self.time_on(tile, &here, [from, to]);
                if pass(TimedSegment {
                    time,
                    on: Some((here, [from, to])),
                })? {
                    return Some(());
                }
            }
            here = TablePoint {
                tiles: here.tiles + 1,
                at: 0.0,
                level: here.level + tile.gain,
            };
        }
        if let Some(piece) = time_of(turns[1], [0.0, reach[1]]) {
            pass(piece)?;
        }
        Some(())
    }

    /// What is at a spot, in the frame in which the motion began: θ, θ′, and sine and cosine of θ.
    fn at(&self, spot: &TablePoint) -> (Reached, (f64, f64)) {
        let about = self.about(spot);
        let rate = (about.g.max(0.0) / about.d).sqrt();
        let (sin, cos) = rotated(self.tile_of(spot).direction, spot.at);
        let reached = Reached {
            theta: self.sign * self.angle(spot),
            theta_rate: self.sign * rate,
        };
        (reached, (self.sign * sin, cos))
    }

    /// The slip at a spot, so long after the motion began as the leg does.
    fn slip(&self, (spot, side): (&TablePoint, usize), before: f64) -> Result<RollEnd, Fallback> {
        let (Reached { theta, theta_rate }, direction) = self.at(spot);
        if theta_rate.abs() < MIN_RATE {
            return Err(Fallback::Standstill);
        }
        let elapsed = before + self.time(spot, false).ok_or(Fallback::Separatrix)?;
        let side = if self.sign < 0.0 { 1 - side } else { side };
        Ok(RollEnd::Slip {
            elapsed,
            theta,
            theta_rate,
            side,
            direction,
        })
    }

    /// Where it is after a time, on the way to a spot.
    fn after(&self, time: f64, spot: &TablePoint, is_turn: bool) -> Option<TablePoint> {
        let (mut left, mut found) = (time, None);
        self.pieces(spot, is_turn, |piece| {
            let here = piece.time?;
            if here < left {
                left -= here;
                return Some(false);
            }
            found = piece.on;
            Some(true)
        })?;
        let (spot, [from, to]) = found?;
        let tile = self.tile_of(&spot);
        let mut at = from + (to - from) * 0.5;
        for _ in 0..MAX_STEPS {
            let about = self.about_on(tile, &spot, at);
            let step = (left - self.time_on(tile, &spot, [from, at])?) / about.slowness(0.0)[0];
            at = (at + step).clamp(from, to);
            if step.abs() < MAX_LAST_STEP {
                return Some(TablePoint { at, ..spot });
            }
        }
        None
    }
}

/// A piece of a leg, on a tile or next to a turning point.
struct TimedSegment {
    time: Option<f64>,
    on: Option<(TablePoint, [f64; 2])>,
}

/// The legs of an orbit from a place, of which the first may be none, seen in the frame of motion.
struct Orbit<'a> {
    first: Leg<'a>,
    /// Of the second leg.
    back: &'a SlopeTables,
    /// The distance from the place to the first leg, and the time, both small.
    before: (f64, f64),
}

impl<'a> Orbit<'a> {
    fn enter(ramps: &'a [SlopeTables; 2], place: &EngineState) -> Self {
        let (travel, u) = (place.travel(), place.u());
        let [ahead, back] = if travel < 0.0 {
            [&ramps[1], &ramps[0]]
        } else {
            [&ramps[0], &ramps[1]]
        };
        let theta = travel * place.state.theta;
        let direction = (travel * place.direction.0, place.direction.1);
        let kinetic = ahead.law().denominator_of(direction) * u;
        let about = LocalExpansion::new(ahead.law(), direction, 0.0);
        // Next to a turning point the distance from it has all digits.
        let side = if about.slope < 0.0 { 1.0 } else { -1.0 };
        let reach = MAX_PART_BESIDE_TURN * about.reach_of_turn();
        let turn = about
            .distance_of_turn(kinetic, side)
            .filter(|distance| *distance <= reach);
        let Some(distance) = turn.filter(|_| side > 0.0) else {
            let first = Leg::enter((ahead, 1.0), (theta, direction), kinetic, turn);
            return Self {
                first,
                back,
                before: (0.0, 0.0),
            };
        };
        let (theta, (sin, cos)) = (theta + distance, rotated(direction, distance));
        let first = Leg::enter((back, -1.0), (-theta, (-sin, cos)), 0.0, Some(0.0));
        let turn = first.about(&first.beginning());
        let before = (distance, turn.time_from_turn(distance, 1.0));
        Self {
            first,
            back: ahead,
            before,
        }
    }
}

/// Follows the rolling that begins at a place, and holds there.
pub(super) fn follow(ramps: &[SlopeTables; 2], place: &EngineState) -> Result<RollEnd, Fallback> {
    let Orbit {
        first,
        back,
        before: (distance, before),
    } = Orbit::enter(ramps, place);
    let turn = match first.end()? {
        // It would have slipped on the way to the turning point.
        LegEnd::Slip { spot, .. } if distance > 0.0 && first.distance(&spot) <= distance => {
            return Err(Fallback::Standstill);
        }
        LegEnd::Slip { spot, side } => return first.slip((&spot, side), before),
        LegEnd::Turn(spot) => spot,
    };
    let back = first.back(turn, back);
    match back.end()? {
        LegEnd::Slip { spot, side } => {
            let outward = first.time(&turn, true).ok_or(Fallback::Separatrix)?;
            back.slip((&spot, side), before + outward)
        }
        LegEnd::Turn(_) => Ok(RollEnd::Never),
    }
}

/// Where rolling from a place is after a time, before its slip.
pub(super) fn after(ramps: &[SlopeTables; 2], place: &EngineState, time: f64) -> Option<Reached> {
    let Orbit {
        first,
        back,
        before: (_, before),
    } = Orbit::enter(ramps, place);
    let time = time - before;
    if time < 0.0 {
        return None;
    }
    let turn = match first.end().ok()? {
        LegEnd::Slip { spot, .. } => return Some(first.at(&first.after(time, &spot, false)?).0),
        LegEnd::Turn(spot) => spot,
    };
    let outward = first.time(&turn, true)?;
    if time <= outward {
        return Some(first.at(&first.after(time, &turn, true)?).0);
    }
    let back = first.back(turn, back);
    let LegEnd::Slip { spot, .. } = back.end().ok()? else {
        return None;
    };
    Some(back.at(&back.after(time - outward, &spot, false)?).0)
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::engine::roll::direction_of;
    use crate::model::{HoopParameters, State};
    use crate::modes::{Rolling, RollingLimit};

    fn ramps(hoop: &Hoop) -> [SlopeTables; 2] {
        [1.0, -1.0].map(|travel| SlopeTables::new(hoop, travel))
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

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(4_000))]

        /// Against the solver of the simulation, before the slip and at it.
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
            let (ramps, place) = (ramps(&hoop), EngineState::new(at(theta, theta_rate)));
            let Ok(RollEnd::Slip { elapsed, theta, theta_rate, side, direction: (sin, cos) }) = follow(&ramps, &place) else {
                return Ok(());
            };
            let rolling = Rolling::new(&hoop, place.state);
            let end = rolling.orbit().end().expect("it slips");
            let travel = place.travel();
            prop_assert_eq!(end.limit, RollingLimit::Friction(direction_of(side, travel)));
            // What the rounding of an angle, or of a margin, changes of a slip whose margin falls
            // slowly.
            let tolerance = 1e-11 * (1.0 + elapsed);
            prop_assert!((end.theta - travel * theta).abs() < tolerance, "{} {theta}", end.theta);
            prop_assert!((end.theta_rate - travel * theta_rate).abs() < tolerance, "{} {theta_rate}", end.theta_rate);
            prop_assert!((end.elapsed - elapsed).abs() < tolerance, "{} {elapsed}", end.elapsed);
            let expected = libm::sincos(theta);
            let rounding = 8.0 * f64::EPSILON * (TAU + theta.abs());
            prop_assert!((sin - expected.0).abs() < rounding && (cos - expected.1).abs() < rounding, "{theta}");
            let Some(found) = after(&ramps, &place, part * elapsed) else { return Ok(()) };
            let expected = rolling.state(part * elapsed);
            prop_assert!((travel * found.theta - expected.theta).abs() < tolerance, "{found:?} {expected:?}");
            prop_assert!((travel * found.theta_rate - expected.theta_rate).abs() < tolerance, "{found:?} {expected:?}");
        }
    }

    /// What is not found is computed for much longer, which no test of answers would notice.
    #[test]
    fn nearly_all_orbits_are_followed() {
        for slope in [0.03, 0.1, -0.5, 1.0] {
            let ramps = ramps(&figure_2(slope));
            let (mut all, mut slips, mut found, mut left) = (0, 0, 0, 0);
            for (i, j) in (0..40).flat_map(|i| (0..40).map(move |j| (i, j))) {
                let place =
                    EngineState::new(at(0.16 * f64::from(i) - 3.1, 0.1 * f64::from(j) - 2.0));
                match follow(&ramps, &place) {
                    Ok(RollEnd::Slip { elapsed, .. }) => {
                        slips += 1;
                        found += usize::from(after(&ramps, &place, 0.5 * elapsed).is_some());
                    }
                    Ok(RollEnd::Never) => {}
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
