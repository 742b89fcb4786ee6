//! A plane as text: what has become of each of its starts, as CSV.

use std::io::{self, Write};
use std::path::Path;

use littlewood::Summary;
use littlewood::tables::{Class, ColumnType, DerivativeColumn, SummaryColumn, SummaryValue};
use littlewood_sweep::{Axis, Chunk, Columns, Grid};

use crate::error::Error;

/// Starts that are written as text at most: they are all held, and text is read whole.
const MOST: u64 = 1 << 20;

/// The results of a grid, in the order of its points, the last axis fastest.
pub(crate) struct Plane<'a> {
    axes: &'a [Axis],
    summaries: Vec<Summary>,
    derivatives: Vec<(DerivativeColumn, Vec<f64>)>,
}

impl<'a> Plane<'a> {
    /// Without results; refused if the grid is too large for the text at `path`.
    pub(crate) fn new(grid: &'a Grid, path: &Path) -> Result<Self, Error> {
        let len = usize::try_from(grid.len())
            .ok()
            .filter(|_| grid.len() <= MOST);
        let len = len.ok_or_else(|| Error::Out {
            path: path.to_owned(),
            reason: format!(
                "{} starts are too many for a text, which may have {MOST}",
                grid.len()
            ),
            hint: "give fewer points, or a name that ends in .parquet or .zarr (feature `sweep`)"
                .to_owned(),
        })?;
        let derivatives = grid
            .derivatives()
            .iter()
            .map(|column| (*column, vec![f64::NAN; len]))
            .collect();
        Ok(Self {
            axes: grid.axes(),
            summaries: vec![Summary::NOT_COMPUTED; len],
            derivatives,
        })
    }

    pub(crate) fn add(&mut self, chunk: &Chunk, columns: &Columns) {
        for (row, (indices, summary)) in chunk.indices().zip(columns.summaries()).enumerate() {
            let place = indices
                .iter()
                .zip(self.axes)
                .fold(0, |place, (i, axis)| place * axis.count() + i);
            self.summaries[place] = summary;
            for (column, values) in &mut self.derivatives {
                values[place] = columns
                    .derivative(*column)
                    .map_or(f64::NAN, |values| values[row]);
            }
        }
    }

    /// One row a start: its place on the axes, then the columns. What has no value is an empty
    /// cell.
    pub(crate) fn csv(&self, writer: &mut dyn Write) -> io::Result<()> {
        let axes = self.axes.iter().map(|axis| axis.varies().name().to_owned());
        let columns = SummaryColumn::ALL.iter().map(SummaryColumn::to_string);
        let derivatives = self
            .derivatives
            .iter()
            .map(|(column, _)| column.to_string());
        // The classes that pictures show: by the first lift-off. With restitution `outcome`, the
        // end, comes later.
        let class = ["class".to_owned()];
        let names: Vec<String> = axes
            .chain(columns)
            .chain(class)
            .chain(derivatives)
            .collect();
        writeln!(writer, "{}", names.join(","))?;
        for (place, summary) in self.summaries.iter().enumerate() {
            for (k, axis) in self.axes.iter().enumerate() {
                let stride: usize = self.axes[k + 1..].iter().map(Axis::count).product();
                write!(writer, "{},", axis.value(place / stride % axis.count()))?;
            }
            for column in SummaryColumn::ALL {
                write_cell(writer, column, summary)?;
                writer.write_all(b",")?;
            }
            write!(writer, "{}", Class::of(summary))?;
            for (_, values) in &self.derivatives {
                writer.write_all(b",")?;
                write_real(writer, values[place])?;
            }
            writeln!(writer)?;
        }
        Ok(())
    }
}

/// A value of a summary, codes as words.
fn write_cell(writer: &mut dyn Write, column: SummaryColumn, summary: &Summary) -> io::Result<()> {
    match (column.column_type(), column.of(summary)) {
        (ColumnType::Outcome, _) => write!(writer, "{}", summary.outcome),
        (ColumnType::Sequence, _) => write!(writer, "{}", summary.sequence),
        (ColumnType::Flag, SummaryValue::U8(flag)) => write!(writer, "{}", flag != 0),
        (_, SummaryValue::U8(count)) => write!(writer, "{count}"),
        (_, SummaryValue::U32(count)) => write!(writer, "{count}"),
        (_, SummaryValue::U64(count)) => write!(writer, "{count}"),
        (_, SummaryValue::F64(value)) => write_real(writer, value),
    }
}

/// A number, which is an empty cell where it has no value.
fn write_real(writer: &mut dyn Write, value: f64) -> io::Result<()> {
    if value.is_nan() {
        return Ok(());
    }
    write!(writer, "{value}")
}
