//! The walk of a slide through the cells, to its event.

use crate::equations::contact;

use super::cell::{Cell, Polynomial, value};
use super::{SlideEvent, SlideStart, SlideTable};

/// Ratio of the ends of u up to which the Gauss sum of 1/√u is exact to rounding.
const SMOOTH: f64 = 1.5;

/// A slower end of slip is left to the Taylor series: η′ comes from the first integral to ε (1 + |θ′|), so that below this
/// part of 1 + |θ′| in η″ the time of η′ = 0 is not known to 2e-13.
const MIN_SLIP_ACCELERATION: f64 = 2e-3;

/// A point on the way through a cell.
#[derive(Clone, Copy, Debug)]
struct Waypoint {
    z: f64,
    u: f64,
    elapsed: f64,
    slip: f64,
    slip_acceleration: f64,
    /// sin ϑ and cos ϑ, where the way may end.
    direction: (f64, f64),
}

impl SlideTable {
    /// Follows a slide to its event. None where the shape of η′ is in doubt, θ′ comes close to zero, or the slide takes
    /// longer than a few turns: the caller then follows it by Taylor series.
    pub(in crate::engine) fn follow(&self, start: SlideStart) -> Option<SlideEvent> {
        let travel = if start.theta_rate > 0.0 {
            1.0
        } else if start.theta_rate < 0.0 {
            -1.0
        } else {
            return None;
        };
        let (mut index, mut offset) = self.entrance(&start);
        let first = &self.cells[index];
        let z = ((start.theta - offset - first.centre) / first.half).clamp(-1.0, 1.0);
        let (sin, cos) = start.direction;
        let (alpha, beta) = self.law.slip_acceleration(sin, cos);
        let u = start.theta_rate * start.theta_rate;
        let lever = self.law.lever(sin, cos);
        let integral = start.slip - start.theta_rate * lever;
        let slip_acceleration = alpha + beta * u;
        let mut here =
            Waypoint { z, u, elapsed: 0.0, slip: start.slip, slip_acceleration, direction: (sin, cos) };
        let mut whole = false;
        for _ in 0..4 * self.cells.len() {
            let cell = &self.cells[index];
            let level = if whole {
                let entry = &cell.edges[usize::from(travel < 0.0)];
                (here.u - entry.p) / entry.h
            } else {
                cell.level(here.u, here.z)
            };
            let exit = &cell.edges[usize::from(travel > 0.0)];
            let exit_u = exit.p + level * exit.h;
            let lifts_off = contact(1.0, self.law.body.h, exit.cos * exit_u) < 0.0;
            let there = if lifts_off {
                self.lift_off(cell, &cell.motion(level), &here, (travel, integral))?
            } else {
                let ratio = exit_u / here.u;
                if !(ratio > 1.0 / SMOOTH && ratio < SMOOTH) {
                    return None;
                }
                let time = if whole {
                    cell.whole_time(level)
                } else {
                    cell.time(&cell.motion(level), here.z.min(travel), here.z.max(travel))
                };
                let elapsed = here.elapsed + time;
                let rate = travel * exit_u.sqrt();
                Waypoint {
                    z: travel,
                    u: exit_u,
                    elapsed,
                    slip: integral + rate * exit.lever - self.law.friction * elapsed,
                    slip_acceleration: exit.alpha + exit.beta * exit_u,
                    direction: (0.0, exit.cos),
                }
            };
            if there.slip <= 0.0 {
                let rest = self.rest(cell, &cell.motion(level), &here, &there, (travel, integral))?;
                return Some(Self::event(cell, offset, &rest, travel, false));
            }
            if here.slip_acceleration <= 0.0 && there.slip_acceleration >= 0.0 && here.slip > 0.0 {
                // η′ may have a minimum inside; it may also touch zero there.
                return None;
            }
            if lifts_off {
                return Some(Self::event(cell, offset, &there, travel, true));
            }
            here = Waypoint { z: -travel, ..there };
            whole = true;
            (index, offset) = self.neighbour(index, offset, travel > 0.0);
        }
        None
    }

    fn event(cell: &Cell, offset: f64, at: &Waypoint, travel: f64, lifts_off: bool) -> SlideEvent {
        SlideEvent {
            elapsed: at.elapsed,
            theta: offset + (cell.centre + cell.half * at.z),
            theta_rate: travel * at.u.sqrt(),
            slip: if lifts_off { at.slip } else { 0.0 },
            direction: at.direction,
            lifts_off,
        }
    }

    /// Everything at z, from the way since `here`.
    fn at(
        &self,
        cell: &Cell,
        motion: &Polynomial,
        here: &Waypoint,
        z: f64,
        (travel, integral): (f64, f64),
    ) -> Option<Waypoint> {
        let u = value(motion, z);
        let ratio = u / here.u;
        if !(ratio > 1.0 / SMOOTH && ratio < SMOOTH) {
            return None;
        }
        let elapsed = here.elapsed + cell.time(motion, here.z.min(z), here.z.max(z));
        let (sin, cos) = cell.direction(z);
        let (alpha, beta) = self.law.slip_acceleration(sin, cos);
        let lever = self.law.lever(sin, cos);
        Some(Waypoint {
            z,
            u,
            elapsed,
            slip: integral + travel * u.sqrt() * lever - self.law.friction * elapsed,
            slip_acceleration: alpha + beta * u,
            direction: (sin, cos),
        })
    }

    /// Where 1 − h cos ϑ u falls through zero on the way to the end of the cell: Newton's method in a bracket.
    fn lift_off(
        &self,
        cell: &Cell,
        motion: &Polynomial,
        here: &Waypoint,
        (travel, integral): (f64, f64),
    ) -> Option<Waypoint> {
        let h = self.law.body.h;
        let (mut low, mut high) = (here.z, travel);
        let mut z = 0.5 * (low + high);
        for _ in 0..60 {
            let (sin, cos) = cell.direction(z);
            let u = value(motion, z);
            let w = contact(1.0, h, cos * u);
            if w > 0.0 {
                low = z;
            } else {
                high = z;
            }
            let slope = cell.half * (h * sin * u - h * cos * self.law.drive(sin, cos) * w);
            let newton = z - w / slope;
            let inside = (newton - low) * travel > 0.0 && (high - newton) * travel > 0.0;
            let next = if inside { newton } else { 0.5 * (low + high) };
            let step = (next - z).abs();
            z = next;
            if step < 1e-9 && inside {
                return self.at(cell, motion, here, z, (travel, integral));
            }
            if (high - low).abs() < 1e-15 {
                return self.at(cell, motion, here, z, (travel, integral));
            }
        }
        None
    }

    /// Where η′ falls through zero between two waypoints: a cubic for a guess, then Newton's method with the exact time.
    fn rest(
        &self,
        cell: &Cell,
        motion: &Polynomial,
        here: &Waypoint,
        there: &Waypoint,
        (travel, integral): (f64, f64),
    ) -> Option<Waypoint> {
        let span = there.z - here.z;
        // dη′/ds with s from 0 at `here` to 1 at `there`.
        let slope = |at: &Waypoint| at.slip_acceleration / at.u.sqrt() * cell.half * span.abs();
        let guess = cubic_root(here.slip, slope(here), there.slip, slope(there));
        let mut z = here.z + guess * span;
        for _ in 0..6 {
            let at = self.at(cell, motion, here, z, (travel, integral))?;
            if at.slip_acceleration.abs() < MIN_SLIP_ACCELERATION * (1.0 + at.u.sqrt()) {
                return None;
            }
            let rate = at.slip_acceleration / at.u.sqrt() * cell.half * travel;
            let step = -at.slip / rate;
            let next = z + step;
            if !((next - here.z) * travel > 0.0 && (there.z - next) * travel >= 0.0) || rate * travel >= 0.0 {
                return None;
            }
            if step.abs() < 1e-7 {
                let u = value(motion, next);
                // Over a step this short the direction turns by its derivative.
                let (sin, cos) = at.direction;
                let turn = step * cell.half;
                let direction =
                    (sin + turn * cos - 0.5 * turn * turn * sin, cos - turn * sin - 0.5 * turn * turn * cos);
                // The step may go back: the trapezoid is signed.
                let slowness = 0.5 * (1.0 / at.u.sqrt() + 1.0 / u.sqrt());
                let elapsed = at.elapsed + step * travel * cell.half * slowness;
                return Some(Waypoint {
                    z: next,
                    u,
                    elapsed,
                    slip: 0.0,
                    slip_acceleration: at.slip_acceleration,
                    direction,
                });
            }
            z = next;
        }
        None
    }
}

/// Root in (0, 1] of the cubic with these values and slopes at 0 and 1, the value at 1 not positive.
fn cubic_root(start: f64, start_slope: f64, end: f64, end_slope: f64) -> f64 {
    let c2 = 3.0 * (end - start) - 2.0 * start_slope - end_slope;
    let c3 = 2.0 * (start - end) + start_slope + end_slope;
    let mut s = 1.0;
    for _ in 0..8 {
        let value = start + s * (start_slope + s * (c2 + s * c3));
        let slope = start_slope + s * (2.0 * c2 + 3.0 * s * c3);
        if slope >= 0.0 {
            break;
        }
        let next: f64 = s - value / slope;
        if !(next > 0.0 && next <= 1.0) {
            break;
        }
        if (next - s).abs() < 1e-6 {
            return next;
        }
        s = next;
    }
    s
}
