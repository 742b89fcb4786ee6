//! The walk of a slide through the cells, to its event.

use crate::equations::contact;

use super::super::piece::{Piece, Way, Waypoint};
use super::super::polynomial::value;
use super::cell::{Cell, Polynomial};
use super::{SlideEvent, SlideStart, SlideTable};

/// Ratio of the ends of u up to which the Gauss sum of 1/√u is exact to rounding.
const SMOOTH: f64 = 1.5;

/// Whether u changes so little between two values.
fn is_smooth(from: f64, to: f64) -> bool {
    let ratio = to / from;
    ratio > 1.0 / SMOOTH && ratio < SMOOTH
}

/// One slide through a cell.
#[derive(Clone, Debug)]
struct Crossing<'a> {
    cell: &'a Cell,
    /// u in powers of z.
    motion: Polynomial,
    /// Sign of θ′.
    travel: f64,
}

impl Piece for Crossing<'_> {
    fn u(&self, z: f64) -> f64 {
        value(&self.motion, z)
    }

    fn rate(&self, _: f64, u: f64) -> f64 {
        self.travel * u.sqrt()
    }

    fn direction(&self, z: f64) -> (f64, f64) {
        self.cell.direction(z)
    }

    fn turned(&self, (sin, cos): (f64, f64), _: f64, step: f64) -> (f64, f64) {
        // Over a step this short the direction turns by its derivative.
        let turn = step * self.cell.half;
        (sin + turn * cos - 0.5 * turn * turn * sin, cos - turn * sin - 0.5 * turn * turn * cos)
    }

    fn turning(&self, _: f64) -> f64 {
        self.cell.half
    }

    fn by_coordinate(&self, _: f64, u: f64, by_time: f64) -> f64 {
        by_time / u.sqrt() * self.cell.half * self.travel
    }

    fn time(&self, (from, u): (f64, f64), (to, to_u): (f64, f64)) -> Option<f64> {
        is_smooth(u, to_u).then(|| self.cell.time(&self.motion, from.min(to), from.max(to)))
    }

    fn short_time(&self, z: f64, u: f64, step: f64) -> f64 {
        // The step may go back: the trapezoid is signed.
        let slowness = 0.5 * (1.0 / u.sqrt() + 1.0 / self.u(z + step).sqrt());
        step * self.travel * self.cell.half * slowness
    }
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
            let crossing = || Crossing { cell, motion: cell.motion(level), travel };
            let there = if lifts_off {
                self.way(&crossing(), integral).lift_off(&here, travel)?
            } else {
                if !is_smooth(here.u, exit_u) {
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
                let rest = self.way(&crossing(), integral).rest(&here, &there)?;
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

    fn way<'a>(&'a self, piece: &'a Crossing<'a>, integral: f64) -> Way<'a, Crossing<'a>> {
        Way { law: &self.law, piece, forward: piece.travel, sigma: 1.0, integral }
    }

    fn event(cell: &Cell, offset: f64, at: &Waypoint, travel: f64, lifts_off: bool) -> SlideEvent {
        SlideEvent {
            elapsed: at.elapsed,
            theta: offset + (cell.centre + cell.half * at.z),
            theta_rate: travel * at.u.sqrt(),
            slip: if lifts_off { at.slip } else { 0.0 },
            direction: at.direction,
            lifts_off,
            turns: None,
        }
    }
}
