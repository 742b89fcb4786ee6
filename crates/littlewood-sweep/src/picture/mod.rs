//! A map as a picture: two axes, a colour for every point, a legend.

mod frame;
mod names;
mod palette;
mod pen;
mod scale;

pub use frame::Size;

use littlewood::Limits;
use plotters::backend::BitMapBackend;
use plotters::drawing::IntoDrawingArea as _;

use self::frame::{FINE, Frame, SIDES, encode, reduce};
use self::palette::{NOTHING, of_class};
use self::pen::Pen;
use self::scale::Scale;
use crate::axis::Coordinate;
use crate::chunk::Chunk;
use crate::columns::{Columns, Real};
use crate::compute::Workers;
use crate::error::{PictureError, SweepError};
use crate::grid::Grid;
use crate::outcome::Class;
use crate::run::Options;
use crate::sweep::sweep_grid;
use crate::tally::Tally;
use crate::zarr::ZarrStore;
use littlewood_style::ticks::minus;

/// What the colours show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shade {
    /// The class of the outcome.
    Class,
    /// A real column, on a scale; where it has no value, grey.
    Column(Real),
}

/// A map of a grid with two axes: the first runs to the right, the second upwards.
///
/// It holds a value for each pixel, not for each point: a grid that is finer than the picture is thinned, and its size
/// does not matter. The shares in the legend are those of all points.
#[derive(Clone, Debug)]
pub struct Picture {
    grid: Grid,
    limits: Limits,
    shade: Shade,
    size: Size,
    frame: Frame,
    /// Cells to the right and upwards.
    counts: [usize; 2],
    cells: Cells,
    /// Points that have been added.
    tally: Tally,
}

#[derive(Clone, Debug)]
enum Cells {
    Class(Vec<Class>),
    /// None where it is not computed.
    Real(Vec<Option<f64>>),
}

impl Picture {
    /// An empty picture of a grid.
    ///
    /// # Errors
    /// If the grid has not two axes, or the picture no room.
    pub fn new(grid: &Grid, limits: Limits, shade: Shade, size: Size) -> Result<Self, PictureError> {
        let [x, y] = grid.axes() else {
            return Err(PictureError::NotTwoAxes { found: grid.axes().len() });
        };
        let [least, most] = SIDES;
        if [size.width, size.height].iter().any(|side| !(least..=most).contains(side)) {
            return Err(PictureError::Size { width: size.width, height: size.height, least, most });
        }
        let frame = Frame::new(size);
        let pixels = |length: i32| usize::try_from(length).unwrap_or(1).max(1);
        let counts = [x.count().min(pixels(frame.width)), y.count().min(pixels(frame.height))];
        let cells = match shade {
            Shade::Class => Cells::Class(vec![Class::NotComputed; counts[0] * counts[1]]),
            Shade::Column(_) => Cells::Real(vec![None; counts[0] * counts[1]]),
        };
        let tally = Tally::default();
        Ok(Self { grid: grid.clone(), limits, shade, size, frame, counts, cells, tally })
    }

    /// Computes a grid and draws it; nothing is kept but the picture. A cancelled picture is white where it is not
    /// computed.
    ///
    /// # Errors
    /// As [`Picture::new`] and [`Workers::compute`].
    pub fn of_grid(
        grid: &Grid,
        limits: Limits,
        shade: Shade,
        size: Size,
        workers: &Workers,
        options: &Options<'_>,
    ) -> Result<Self, SweepError> {
        let mut picture = Self::new(grid, limits, shade, size)?;
        let mut add = |chunk: &Chunk, columns: &Columns| picture.add(chunk, columns);
        sweep_grid(grid, limits, &[], Some(&mut add), workers, options)?;
        Ok(picture)
    }

    /// Draws a store.
    ///
    /// # Errors
    /// As [`Picture::new`]; a chunk that cannot be read.
    pub fn of_store(store: &ZarrStore, shade: Shade, size: Size) -> Result<Self, SweepError> {
        let mut picture = Self::new(store.grid(), store.limits(), shade, size)?;
        for number in 0..store.chunks().count() {
            if let Some(columns) = store.columns(number)? {
                picture.add(&store.chunks().chunk(number), &columns);
            }
        }
        Ok(picture)
    }

    /// Adds the results of a chunk of the grid.
    pub fn add(&mut self, chunk: &Chunk, columns: &Columns) {
        let axes = [self.grid.axes()[0].count(), self.grid.axes()[1].count()];
        for (i, indices) in chunk.indices().enumerate() {
            let row = columns.row(i);
            let class = Class::of(&row);
            self.tally.add(class, 1);
            let [Some(x), Some(y)] = [0, 1].map(|k| cell(indices[k], axes[k], self.counts[k])) else {
                continue;
            };
            let place = y * self.counts[0] + x;
            match (&mut self.cells, self.shade) {
                (Cells::Class(cells), _) => cells[place] = class,
                (Cells::Real(cells), Shade::Column(column)) => cells[place] = Some(column.of(&row)),
                (Cells::Real(_), Shade::Class) => {}
            }
        }
    }

    /// Number of points of a class.
    #[must_use]
    pub fn count(&self, class: Class) -> u64 {
        let missing = if class == Class::NotComputed { self.grid.len() - self.tally.total() } else { 0 };
        self.tally.of(class) + missing
    }

    /// Whether every point of the grid has been added.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.count(Class::NotComputed) == 0
    }

    /// The picture as a PNG file.
    ///
    /// # Errors
    /// None is known.
    pub fn png(&self) -> Result<Vec<u8>, PictureError> {
        // Letters are set on whole pixels, which shows in their distances: so all is drawn larger, then reduced.
        let size = Size { width: FINE * self.size.width, height: FINE * self.size.height };
        let frame = self.frame.enlarged(FINE);
        let mut pixels = vec![0xff; size.width as usize * size.height as usize * 3];
        let scale = Scale::of(&self.cells);
        self.paint(&mut pixels, size, frame, scale.as_ref());
        {
            let area = BitMapBackend::with_buffer(&mut pixels, (size.width, size.height)).into_drawing_area();
            Pen { area, frame }.draw(self, scale.as_ref())?;
        }
        encode(&reduce(&pixels, self.size), self.size.width, self.size.height)
    }

    fn paint(&self, pixels: &mut [u8], size: Size, frame: Frame, scale: Option<&Scale>) {
        let Frame { left, top, width, height, .. } = frame;
        let [nx, ny] = self.counts;
        let flipped = [0, 1].map(|k| {
            let axis = &self.grid.axes()[k];
            axis.from() > axis.to()
        });
        let stride = size.width as usize * 3;
        let (left, top, width, height) = (left as usize, top as usize, width as usize, height as usize);
        for py in 0..height {
            let y = (height - 1 - py) * ny / height;
            let y = if flipped[1] { ny - 1 - y } else { y };
            for px in 0..width {
                let x = px * nx / width;
                let x = if flipped[0] { nx - 1 - x } else { x };
                let place = y * nx + x;
                let colour = match &self.cells {
                    Cells::Class(cells) => of_class(cells[place]),
                    Cells::Real(cells) => match (cells[place], scale) {
                        (None, _) => of_class(Class::NotComputed),
                        (Some(value), Some(scale)) => scale.colour(value),
                        (Some(_), None) => NOTHING,
                    },
                };
                let offset = (top + py) * stride + (left + px) * 3;
                pixels[offset..offset + 3].copy_from_slice(&colour);
            }
        }
    }

    /// What is fixed, in words.
    fn fixed(&self) -> String {
        let mut parts: Vec<String> = Coordinate::ALL
            .into_iter()
            .filter(|&coordinate| self.grid.axes().iter().all(|axis| axis.coordinate() != coordinate))
            .map(|coordinate| {
                let value = coordinate.of_point(self.grid.base());
                let rounded = libm::round(value * 1e6) / 1e6;
                format!("{} {} {rounded}", coordinate.symbol(), if rounded == value { '=' } else { '≈' })
            })
            .collect();
        if let Some(until) = self.limits.until {
            parts.push(format!("τ ≤ {until}"));
        }
        minus(&parts.join(",  "))
    }
}

/// The cell of a place on an axis, if the axis has not been thinned there.
fn cell(index: usize, count: usize, cells: usize) -> Option<usize> {
    // Cell j shows the place in the middle of its share of the axis. Where cells are hardly wider than places, that place
    // may begin in the share before.
    let shown = |j: usize| (2 * j + 1) * count / (2 * cells);
    let share = index * cells / count;
    [share, share + 1].into_iter().find(|&j| j < cells && shown(j) == index)
}

fn drawing<E: core::fmt::Display>(error: E) -> PictureError {
    PictureError::Drawing(error.to_string())
}

#[cfg(test)]
mod tests {
    use super::cell;

    #[test]
    fn every_cell_shows_one_place_in_order() {
        for count in (1..900).step_by(7) {
            for cells in (1..=count).step_by(3).chain([count]) {
                let shown: Vec<usize> = (0..count).filter_map(|index| cell(index, count, cells)).collect();
                assert_eq!(shown, (0..cells).collect::<Vec<usize>>(), "{count} places in {cells} cells");
            }
        }
    }
}
