//! Boundaries between the colours of a map, followed to the pixel.

use std::collections::{BTreeMap, BTreeSet};

use littlewood::Limits;

use super::cells::Cell;
use super::layout::Layout;
use super::map::Picture;
use crate::compute::{Halt, Workers};
use crate::error::SweepError;
use crate::options::Options;
use crate::watch::Ledger;

/// Motions that a picture follows besides those of its grid, at most. Boundaries take some ten thousand; where starts next
/// to each other behave differently everywhere no number would do.
const MOST: usize = 400_000;

/// A rectangle of pixels, corners included: left, bottom, right, top.
pub(super) type Block = [usize; 4];

/// What is known of a map besides its cells, on a lattice of pixels that begins at the lower left.
#[derive(Clone, Debug, Default)]
pub(super) struct Refined {
    /// Parts of cells that lie on one side of a boundary, the later above the earlier.
    pub(super) blocks: Vec<(Block, [Cell; 4])>,
    /// Pixels next to a boundary.
    pub(super) pixels: BTreeMap<(usize, usize), Cell>,
}

/// The pixel of cell `j` of `cells` among `size` pixels.
pub(super) const fn pixel(j: usize, cells: usize, size: usize) -> usize {
    if cells < 2 { 0 } else { (2 * j * (size - 1) + cells - 1) / (2 * (cells - 1)) }
}

impl Picture {
    /// Follows the boundaries between colours to the pixels of the picture: where two neighbours of the grid differ, the
    /// motions between them are computed. The result does not depend on the number of threads. Cancelled, it returns false
    /// and leaves the picture as it is.
    ///
    /// # Errors
    /// As [`Workers::compute`].
    pub fn refine(
        &mut self,
        limits: Limits,
        workers: &Workers,
        options: &Options<'_>,
    ) -> Result<bool, SweepError> {
        let [nx, ny] = self.counts;
        let frame = Layout::new(self).frame;
        let size = [frame.width, frame.height].map(|side| usize::try_from(side).unwrap_or(1).max(1));
        let [width, height] = size;
        if nx < 2 || ny < 2 || !self.is_complete() {
            return Ok(true);
        }
        let quiet = Options { cancel: options.cancel, ..Options::default() };
        let ledger = Ledger::new(&quiet, 0, 0);
        let mut refined = Refined::default();
        let columns: Vec<usize> = (0..nx).map(|i| pixel(i, nx, width)).collect();
        let rows: Vec<usize> = (0..ny).map(|j| pixel(j, ny, height)).collect();
        let mut blocks: Vec<Block> = Vec::new();
        for j in 0..ny - 1 {
            for i in 0..nx - 1 {
                let corners = [(i, j), (i + 1, j), (i, j + 1), (i + 1, j + 1)];
                let cells = corners.map(|(i, j)| self.cells[j * nx + i]);
                if !self.is_uniform(&cells) {
                    for ((i, j), cell) in corners.into_iter().zip(cells) {
                        refined.pixels.insert((columns[i], rows[j]), cell);
                    }
                    blocks.push([columns[i], rows[j], columns[i + 1], rows[j + 1]]);
                }
            }
        }
        while !blocks.is_empty() {
            let halves: Vec<Block> = blocks.iter().copied().filter(|block| !is_smallest(block)).collect();
            let wanted: BTreeSet<(usize, usize)> = halves
                .iter()
                .flat_map(parts)
                .flat_map(corners)
                .filter(|pixel| !refined.pixels.contains_key(pixel))
                .collect();
            if refined.pixels.len() + wanted.len() > MOST {
                break;
            }
            let wanted: Vec<(usize, usize)> = wanted.into_iter().collect();
            let points: Vec<_> = wanted.iter().map(|&pixel| self.point_of(pixel, size)).collect();
            let found = match workers.compute_points(&points, None, limits, &ledger.watch()) {
                Ok(columns) => columns,
                Err(Halt::Cancelled) => return Ok(false),
                Err(Halt::Refused(refused)) => return Err(refused.error.into()),
            };
            for ((pixel, point), (summary, class)) in
                wanted.into_iter().zip(&points).zip(found.summaries().zip(found.classes()))
            {
                refined.pixels.insert(pixel, self.cell_of(point, &summary, *class));
            }
            blocks = Vec::new();
            for part in halves.iter().flat_map(parts) {
                let cells = corners(part).map(|pixel| refined.pixels[&pixel]);
                if self.is_uniform(&cells) {
                    refined.blocks.push((part, cells));
                } else {
                    blocks.push(part);
                }
            }
        }
        self.refined = refined;
        Ok(true)
    }

    /// The point that a pixel shows.
    fn point_of(&self, (x, y): (usize, usize), size: [usize; 2]) -> littlewood::tables::Setup {
        let mut point = *self.grid.base();
        for (axis, (pixel, size)) in self.grid.axes().iter().zip([x, y].into_iter().zip(size)) {
            axis.varies().set(&mut point, axis.between(pixel as f64 / (size - 1).max(1) as f64));
        }
        point
    }

    fn is_uniform(&self, cells: &[Cell; 4]) -> bool {
        cells.iter().all(|cell| self.colours_alike(cells[0], *cell))
    }
}

const fn is_smallest([left, bottom, right, top]: &Block) -> bool {
    *right <= *left + 1 && *top <= *bottom + 1
}

const fn corners([left, bottom, right, top]: Block) -> [(usize, usize); 4] {
    [(left, bottom), (right, bottom), (left, top), (right, top)]
}

/// A block cut at its middle, along the sides that have one.
fn parts(&[left, bottom, right, top]: &Block) -> impl Iterator<Item = Block> {
    let cut = |a: usize, b: usize| {
        if b > a + 1 { vec![(a, usize::midpoint(a, b)), (usize::midpoint(a, b), b)] } else { vec![(a, b)] }
    };
    let across = cut(left, right);
    cut(bottom, top).into_iter().flat_map(move |(bottom, top)| {
        across.clone().into_iter().map(move |(left, right)| [left, bottom, right, top])
    })
}
