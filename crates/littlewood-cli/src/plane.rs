//! A plane as text: what has become of each of its starts, as CSV or JSON.

use std::io::{self, Write};
use std::path::Path;

use littlewood::tables::{Class, ColumnType, DerivativeColumn, PhaseSequence, SummaryColumn, SummaryValue};
use littlewood::{OutcomeKind, Summary};
use littlewood_sweep::{Axis, Chunk, Columns, Grid};
use serde::Serialize;
use serde::ser::{SerializeMap as _, Serializer};

use crate::error::Error;

/// Starts that are written as text at most: they are all held, and text is read whole.
const MOST: u64 = 1 << 20;

/// The column of the classes that pictures show and the summary of a run counts: by the first lift-off, where there is one. `outcome` is the
/// end of the motion, which with restitution comes later.
const CLASS: &str = "class";

/// The results of a grid, in the order of its points, the last axis fastest.
pub(crate) struct Plane<'a> {
    axes: &'a [Axis],
    summaries: Vec<Summary>,
    derivatives: Vec<(DerivativeColumn, Vec<f64>)>,
}

impl<'a> Plane<'a> {
    /// Without results; refused if the grid is too large for the text at `path`.
    pub(crate) fn new(grid: &'a Grid, path: &Path) -> Result<Self, Error> {
        let len = usize::try_from(grid.len()).ok().filter(|_| grid.len() <= MOST);
        let len = len.ok_or_else(|| Error::Out {
            path: path.to_owned(),
            reason: format!("{} starts are too many for a text, which may have {MOST}", grid.len()),
            hint: "give fewer points, or a name that ends in .parquet or .zarr (feature `sweep`)".to_owned(),
        })?;
        let derivatives = grid.derivatives().iter().map(|column| (*column, vec![f64::NAN; len])).collect();
        Ok(Self { axes: grid.axes(), summaries: vec![Summary::NOT_COMPUTED; len], derivatives })
    }

    /// Adds the results of a chunk.
    pub(crate) fn add(&mut self, chunk: &Chunk, columns: &Columns) {
        for (row, (indices, summary)) in chunk.indices().zip(columns.summaries()).enumerate() {
            let place = indices.iter().zip(self.axes).fold(0, |place, (i, axis)| place * axis.count() + i);
            self.summaries[place] = summary;
            for (column, values) in &mut self.derivatives {
                values[place] = columns.derivative(*column).map_or(f64::NAN, |values| values[row]);
            }
        }
    }

    /// One row a start: its place on the axes, then the columns. What has no value is an empty cell.
    pub(crate) fn csv(&self, writer: &mut dyn Write) -> io::Result<()> {
        let axes = self.axes.iter().map(|axis| axis.varies().name().to_owned());
        let columns = SummaryColumn::ALL.iter().map(SummaryColumn::to_string);
        let derivatives = self.derivatives.iter().map(|(column, _)| column.to_string());
        let names: Vec<String> = axes.chain(columns).chain([CLASS.to_owned()]).chain(derivatives).collect();
        writeln!(writer, "{}", names.join(","))?;
        for (place, summary) in self.summaries.iter().enumerate() {
            let mut cells: Vec<String> = vec![String::new(); self.axes.len()];
            let mut rest = place;
            for (cell, axis) in cells.iter_mut().zip(self.axes).rev() {
                *cell = axis.value(rest % axis.count()).to_string();
                rest /= axis.count();
            }
            cells.extend(SummaryColumn::ALL.into_iter().map(|column| Cell::of(column, summary).text()));
            cells.push(Class::of(summary).to_string());
            cells.extend(self.derivatives.iter().map(|(_, values)| Cell::Real(values[place]).text()));
            writeln!(writer, "{}", cells.join(","))?;
        }
        Ok(())
    }

    /// The axes, and each column as a list in the order of the points. What has no value is `null`.
    pub(crate) fn json(&self, writer: &mut dyn Write) -> io::Result<()> {
        serde_json::to_writer(&mut *writer, self)?;
        writeln!(writer)
    }
}

impl Serialize for Plane<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        let axes: Vec<Values> = self
            .axes
            .iter()
            .map(|axis| Values { name: axis.varies().name(), values: axis.values().collect() })
            .collect();
        map.serialize_entry("axes", &axes)?;
        map.serialize_entry("columns", &Lists(self))?;
        map.end()
    }
}

#[derive(Serialize)]
struct Values {
    name: &'static str,
    values: Vec<f64>,
}

/// The columns of a plane by their names.
struct Lists<'a>(&'a Plane<'a>);

impl Serialize for Lists<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let Plane { summaries, derivatives, .. } = self.0;
        let columns = SummaryColumn::ALL.into_iter().map(|column| {
            let cells: Vec<Cell> = summaries.iter().map(|summary| Cell::of(column, summary)).collect();
            (column.to_string(), cells)
        });
        let classes = summaries.iter().map(|summary| Cell::Word(Class::of(summary).to_string())).collect();
        let derivatives = derivatives.iter().map(|(column, values)| {
            let cells = values.iter().copied().map(Cell::Real).collect();
            (column.to_string(), cells)
        });
        serializer.collect_map(columns.chain([(CLASS.to_owned(), classes)]).chain(derivatives))
    }
}

/// A value of a summary, codes as words.
#[derive(Serialize)]
#[serde(untagged)]
enum Cell {
    Word(String),
    Flag(bool),
    Count(u64),
    Real(f64),
}

impl Cell {
    fn of(column: SummaryColumn, summary: &Summary) -> Self {
        match (column.column_type(), column.of(summary)) {
            (ColumnType::Outcome, SummaryValue::U8(code)) => Self::Word(
                OutcomeKind::try_from(code)
                    .map_or_else(|unknown| unknown.to_string(), |kind| kind.to_string()),
            ),
            (ColumnType::Sequence, SummaryValue::U64(bits)) => {
                Self::Word(PhaseSequence::from_bits(bits).to_string())
            }
            (ColumnType::Flag, SummaryValue::U8(flag)) => Self::Flag(flag != 0),
            (_, SummaryValue::U8(count)) => Self::Count(count.into()),
            (_, SummaryValue::U32(count)) => Self::Count(count.into()),
            (_, SummaryValue::U64(count)) => Self::Count(count),
            (_, SummaryValue::F64(value)) => Self::Real(value),
        }
    }

    fn text(&self) -> String {
        match self {
            Self::Word(word) => word.clone(),
            Self::Flag(flag) => flag.to_string(),
            Self::Count(count) => count.to_string(),
            Self::Real(value) if value.is_nan() => String::new(),
            Self::Real(value) => value.to_string(),
        }
    }
}
