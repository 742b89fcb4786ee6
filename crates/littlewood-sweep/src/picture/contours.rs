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
        let levels: Vec<f64> = scale.ticks(unit, 10).into_iter().map(|tick| tick.value).collect();
        for j in 0..ny - 1 {
            for i in 0..nx - 1 {
                let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                let cells: [Cell; 4] = corners.map(|(i, j)| self.cells[j * nx + i]);
                if !cells.iter().all(|cell| cell.key == cells[0].key && cell.number.is_finite()) {
                    continue;
                }
                let numbers = cells.map(|cell| cell.number);
                let (low, high) =
                    numbers.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &value| {
                        (f64::min(low, value), f64::max(high, value))
                    });
                // The values of this cell are equal to rounding: a contour would follow noise.
                if high - low < NOISE * (scale.high - scale.low) {
                    continue;
                }
                let crossed: Vec<f64> =
                    levels.iter().copied().filter(|level| (low..high).contains(level)).collect();
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
                            let (pa, pb) =
                                (place(corners[a].0, corners[a].1), place(corners[b].0, corners[b].1));
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
