//! Lines of constant value over a map.

use super::cells::Cell;
use super::map::Picture;
use super::names::unit_of;
use super::scale::Scale;
use crate::regions::Place;

impl Picture {
    /// Lines along which the number of the shade is that of a tick of the scale.
    pub(super) fn contours(&self, scale: &Scale) -> Vec<Vec<Place>> {
        let [nx, ny] = self.counts;
        if !self.has_contours || nx < 2 || ny < 2 {
            return Vec::new();
        }
        let place = |i: usize, j: usize| -> Place {
            let point = [i as f64 / (nx - 1) as f64, j as f64 / (ny - 1) as f64];
            self.upright(point)
        };
        let mut lines = Vec::new();
        let unit = unit_of(self.shade, self.units.as_ref());
        let levels: Vec<f64> = scale
            .ticks(unit, 10)
            .into_iter()
            .map(|tick| tick.value)
            .collect();
        for j in 0..ny - 1 {
            for i in 0..nx - 1 {
                let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                let cells: [Cell; 4] = corners.map(|(i, j)| self.cells[j * nx + i]);
                if !cells
                    .iter()
                    .all(|cell| cell.key == cells[0].key && cell.number.is_finite())
                {
                    continue;
                }
                let numbers = cells.map(|cell| cell.number);
                let (low, high) = numbers
                    .iter()
                    .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &value| {
                        (f64::min(low, value), f64::max(high, value))
                    });
                // A line through values that are equal to rounding would follow noise.
                let noise = NOISE * (scale.high - scale.low);
                let is_crossed = |level: &f64| low + noise < *level && *level < high - noise;
                let crossed: Vec<f64> = levels.iter().copied().filter(is_crossed).collect();
                // A jump, along which all lines would run.
                if crossed.len() > MOST_LEVELS {
                    continue;
                }
                for level in crossed {
                    let mut crossings: Vec<Place> = Vec::new();
                    for (a, b) in [(0, 1), (1, 2), (2, 3), (3, 0)] {
                        let (va, vb) = (cells[a].number - level, cells[b].number - level);
                        if (va < 0.0) != (vb < 0.0) {
                            let t = va / (va - vb);
                            let (pa, pb) = (
                                place(corners[a].0, corners[a].1),
                                place(corners[b].0, corners[b].1),
                            );
                            crossings.push([0, 1].map(|k| pa[k] + t * (pb[k] - pa[k])));
                        }
                    }
                    lines.extend(crossings.chunks_exact(2).map(<[Place]>::to_vec));
                }
            }
        }
        lines
    }
}

/// Lines through a cell, at most.
const MOST_LEVELS: usize = 2;

/// Differences in a cell that mean something, in parts of the scale.
const NOISE: f64 = 1e-9;

#[cfg(test)]
mod tests {
    use littlewood::tables::{Quantity, Setup};
    use littlewood::{HoopParameters, Limits, Start};

    use super::*;
    use crate::axis::Axis;
    use crate::grid::Grid;
    use crate::picture::scale::Kind;
    use crate::picture::{PictureSize, Shade};

    #[test]
    fn no_line_follows_rounding() {
        let axis = |quantity| Axis::new(quantity, -1.0, 1.0, 3).expect("an axis");
        let axes = vec![axis(Quantity::Theta), axis(Quantity::ThetaRate)];
        let hoop = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
        let grid = Grid::new(Setup::new(hoop, Start::at(0.0, 0.0)), axes).expect("a grid");
        let picture = Picture::new(
            &grid,
            Limits::default(),
            Shade::EnergyLost,
            PictureSize::default(),
        );
        let mut picture = picture.and_then(Picture::with_contours).expect("a picture");
        picture.counts = [3, 3];
        let scale = Scale {
            kind: Kind::Linear,
            low: 0.0,
            high: 1.0,
            beyond: [false; 2],
        };
        let mut lines = |numbers: [f64; 9]| {
            picture.cells = numbers.map(|number| Cell { key: 0, number }).to_vec();
            picture.contours(&scale).len()
        };
        // Motions that lose nothing, beside some that lose a little: zero is a tick, and their sign
        // is rounding.
        let e = 1e-16;
        assert_eq!(lines([e, -e, 0.0, -e, e, -e, 0.0, 0.01, -e]), 0);
        // The tick 0.1 in two cells, and 0.2 and 0.3 in the two others.
        assert_eq!(
            lines([0.0, 0.0, 0.0, 0.15, 0.15, 0.15, 0.32, 0.32, 0.32]),
            2 + 4
        );
    }
}
