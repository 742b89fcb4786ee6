//! The way of a slide through a cell on which θ′ keeps its sign, and changes little in parts of it.

use super::super::piece::Piece;
use super::super::polynomial::value;
use super::cell::{Cell, Polynomial};

/// Ratio of the ends of u up to which the Gauss sum of 1/√u with twelve nodes is exact to rounding, also where u is quadratic about an end.
const SMOOTH: f64 = 1.5;

/// The same with eight nodes.
pub(super) const EVEN: f64 = 1.125;

/// A way is halved at most so often.
pub(super) const MOST_HALVINGS: u32 = 6;

/// Whether two values are within a factor.
pub(super) fn is_within(factor: f64, (from, to): (f64, f64)) -> bool {
    from < factor * to && to < factor * from
}

/// Whether a factor under the root changes so little between two values.
pub(super) fn is_smooth(from: f64, to: f64) -> bool {
    is_within(SMOOTH, (from, to))
}

/// The sum over parts of a way on each of which a factor changes so little.
pub(super) fn in_parts(
    factor: &impl Fn(f64) -> f64,
    sum: &impl Fn((f64, f64), (f64, f64)) -> f64,
    (from, first): (f64, f64),
    (to, last): (f64, f64),
    halvings: u32,
) -> Option<f64> {
    if is_smooth(first, last) {
        return Some(sum((from, first), (to, last)));
    }
    let halvings = halvings.checked_sub(1)?;
    let middle = 0.5 * (from + to);
    let between = (middle, factor(middle));
    let begin = in_parts(factor, sum, (from, first), between, halvings)?;
    Some(begin + in_parts(factor, sum, between, (to, last), halvings)?)
}

/// One slide through a cell.
#[derive(Clone, Debug)]
pub(super) struct Crossing<'a> {
    pub(super) cell: &'a Cell,
    /// u in powers of z.
    pub(super) motion: Polynomial,
    /// Sign of θ′.
    pub(super) travel: f64,
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
        let time = |(from, u): (f64, f64), (to, to_u): (f64, f64)| {
            self.cell.time(&self.motion, from.min(to), from.max(to), is_within(EVEN, (u, to_u)))
        };
        in_parts(&|z| self.u(z), &time, (from, u), (to, to_u), MOST_HALVINGS)
    }
}

#[cfg(test)]
mod tests {
    use super::super::SlideTable;
    use super::super::turning::Turning;
    use super::*;
    use crate::engine::piece::check::{finds_places, is_a_slide};
    use crate::model::hoop::{Body, Hoop};

    /// Through all cells at some levels, forth and back, or about a turning point where u vanishes in a cell.
    #[test]
    fn ways_through_cells_are_slides() {
        let Body::Heavy(body) = Hoop::figure_2(0.5, 0.4).unwrap().body() else { unreachable!("it has mass") };
        let table = SlideTable::new(&body, 0.4).unwrap();
        let (mut crossings, mut turnings, mut rests, mut times) = (0, 0, 0, 0);
        for cell in &table.cells {
            for level in [0.05, 0.4, 1.5, 6.0] {
                let motion = cell.motion(level);
                let ends = [-1.0, 1.0].map(|z| value(&motion, z));
                if ends.iter().all(|u| *u > 0.2 * level) {
                    let forth = Crossing { cell, motion, travel: 1.0 };
                    is_a_slide(&forth, &table.law, (-1.0, 1.0));
                    is_a_slide(&forth, &table.law, (-0.3, 0.5));
                    let back = Crossing { cell, motion, travel: -1.0 };
                    is_a_slide(&back, &table.law, (0.9, -0.8));
                    for (piece, ends) in [(forth, (-1.0, 1.0)), (back, (1.0, -1.0))] {
                        let (found, asked) = finds_places(piece, &table.law, ends);
                        (rests, times) = (rests + found, times + asked);
                    }
                    crossings += 1;
                } else if ends[0] * ends[1] < 0.0 {
                    let travel = if ends[0] > 0.0 { 1.0 } else { -1.0 };
                    let [from, to] = if travel > 0.0 { ends } else { [ends[1], ends[0]] };
                    let turning = Turning::new(cell, &motion, (-travel, from), (travel, to)).unwrap();
                    assert!(turning.is_inside() && turning.travel() == travel);
                    let start = turning.coordinate(-travel);
                    assert!((turning.coordinate_of(-travel, from) - start).abs() < 1e-13);
                    is_a_slide(&turning, &table.law, (-start, -0.1 * start));
                    is_a_slide(&turning, &table.law, (0.2 * start, 0.9 * start));
                    turnings += 1;
                }
            }
        }
        assert!(crossings > 60 && turnings > 4, "{crossings} {turnings}");
        // The guess of where a slide comes to rest is good: it takes one step of Newton's method, or two.
        assert!(rests > 100 && times < 2 * rests, "{rests} {times}");
    }
}
