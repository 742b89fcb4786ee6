//! The map of a grid with two axes.

use littlewood::{Class, Limits, Quantity, SummaryColumn, SummaryValue};
use littlewood_style::ticks::minus;

use super::cells::{Cells, cell};
use super::error::PictureError;
use super::frame::{Frame, PictureSize, SIDES};
use crate::chunk::Chunk;
use crate::columns::Columns;
use crate::grid::Grid;
use crate::tally::Tally;

/// What the colours show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shade {
    /// The class of the outcome.
    Class,
    /// A column of real numbers, on a scale; grey where it has no value.
    Column(SummaryColumn),
}

/// A map of a grid with two axes: the first runs to the right, the second upwards.
///
/// It holds a value for each pixel, not for each point: a grid that is finer than the picture is thinned, and its size
/// does not matter. The shares in the legend are those of all points.
#[derive(Clone, Debug)]
pub struct Picture {
    pub(super) grid: Grid,
    limits: Limits,
    pub(super) shade: Shade,
    pub(super) size: PictureSize,
    pub(super) frame: Frame,
    /// Cells to the right and upwards.
    pub(super) counts: [usize; 2],
    pub(super) cells: Cells,
    /// Points that have been added.
    tally: Tally,
}

/// A value as a number; none for a code.
fn number(value: SummaryValue) -> Option<f64> {
    match value {
        SummaryValue::F64(value) => Some(value),
        SummaryValue::U32(count) => Some(f64::from(count)),
        SummaryValue::U8(_) | SummaryValue::U64(_) => None,
    }
}

impl Picture {
    /// An empty picture of a grid.
    ///
    /// # Errors
    /// If the grid has not two axes, the column is not one of numbers, or the picture is too small or too large.
    pub fn new(grid: &Grid, limits: Limits, shade: Shade, size: PictureSize) -> Result<Self, PictureError> {
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
            Shade::Column(column) if SummaryColumn::numbers().any(|other| other == column) => {
                Cells::Real(vec![None; counts[0] * counts[1]])
            }
            Shade::Column(column) => return Err(PictureError::NoNumber { column }),
        };
        let tally = Tally::default();
        Ok(Self { grid: grid.clone(), limits, shade, size, frame, counts, cells, tally })
    }

    /// Adds the results of a chunk of the grid.
    pub fn add(&mut self, chunk: &Chunk, columns: &Columns) {
        let axes = [self.grid.axes()[0].count(), self.grid.axes()[1].count()];
        let values = match self.shade {
            Shade::Class => None,
            Shade::Column(column) => Some(columns.column(column)),
        };
        for ((i, indices), &class) in chunk.indices().enumerate().zip(columns.classes()) {
            self.tally.add(class, 1);
            let [Some(x), Some(y)] = [0, 1].map(|k| cell(indices[k], axes[k], self.counts[k])) else {
                continue;
            };
            let place = y * self.counts[0] + x;
            match &mut self.cells {
                Cells::Class(cells) => cells[place] = class,
                Cells::Real(cells) => cells[place] = values.and_then(|values| number(values.get(i))),
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

    /// What is fixed, in signs.
    pub(super) fn fixed(&self) -> String {
        let mut parts: Vec<String> = self
            .grid
            .fixed()
            // A start that does not leave the plane is the rule.
            .filter(|&(quantity, value)| quantity != Quantity::GapRate || value != 0.0)
            .map(|(quantity, value)| {
                let rounded = libm::round(value * 1e6) / 1e6;
                format!("{} {} {rounded}", quantity.sign(), if rounded == value { '=' } else { '≈' })
            })
            .collect();
        if let Some(law) = self.grid.base().hoop.restitution_law {
            parts.push(format!("restitution of {}", law.label()));
        }
        if let Some(until) = self.limits.until {
            parts.push(format!("{} ≤ {until}", Quantity::Until.sign()));
        }
        minus(&parts.join(",  "))
    }
}
