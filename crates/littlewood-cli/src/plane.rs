//! A plane as text: what has become of each of its starts, as CSV.

use std::fmt::Display;
use std::io::{self, Write};
use std::path::Path;

use littlewood::OutcomeKind;
use littlewood::tables::{ColumnType, PhaseSequence, SummaryValue};
use littlewood_sweep::{Axis, Chunk, Column, Columns, Grid};

use crate::error::Error;

/// Starts that are written as text at most: they are all held, and text is read whole.
const MOST: u64 = 1 << 20;

/// The results of a grid, in the order of its points, the last axis fastest.
pub(crate) struct Plane<'a> {
    axes: &'a [Axis],
    results: Columns,
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
        Ok(Self {
            axes: grid.axes(),
            results: Columns::not_computed(len, grid.derivatives()),
        })
    }

    pub(crate) fn add(&mut self, chunk: &Chunk, results: &Columns) {
        let counts: Vec<usize> = self.axes.iter().map(Axis::count).collect();
        let places = chunk.places_in(&counts);
        self.results.spread(places.iter().copied(), results);
    }

    /// One row a start: its place on the axes, then the columns. What has no value is an empty
    /// cell.
    pub(crate) fn csv(&self, writer: &mut dyn Write) -> io::Result<()> {
        let is_derivative = |column| matches!(column, Column::Derivative(_));
        let (derivatives, columns): (Vec<_>, Vec<_>) = self
            .results
            .columns()
            .partition(|(column, _)| is_derivative(*column));
        let axes = self.axes.iter().map(|axis| axis.varies().name().to_owned());
        // The classes that pictures show: by the first lift-off. With restitution `outcome`, the
        // end, comes later.
        let class = ["class".to_owned()];
        let name = |(column, _): &(Column, _)| column.to_string();
        let names: Vec<String> = axes
            .chain(columns.iter().map(name))
            .chain(class)
            .chain(derivatives.iter().map(name))
            .collect();
        writeln!(writer, "{}", names.join(","))?;
        let mut row = Row::default();
        for (place, class) in self.results.classes().iter().enumerate() {
            for (k, axis) in self.axes.iter().enumerate() {
                let stride: usize = self.axes[k + 1..].iter().map(Axis::count).product();
                row.real(axis.value(place / stride % axis.count()));
            }
            for (column, values) in &columns {
                row.value(column.column_type(), values.get(place))?;
            }
            row.word(class.name());
            for (column, values) in &derivatives {
                row.value(column.column_type(), values.get(place))?;
            }
            row.write(writer)?;
        }
        Ok(())
    }
}

/// A row of cells, each with a comma behind it. Numbers have the digits that give them back, which
/// the formatter of the standard library takes five times as long to find.
#[derive(Default)]
struct Row {
    text: Vec<u8>,
    digits: zmij::Buffer,
}

impl Row {
    /// A value of a column, codes as words.
    fn value(&mut self, column: ColumnType, value: SummaryValue) -> io::Result<()> {
        match (column, value) {
            (ColumnType::Outcome, SummaryValue::U8(code)) => match OutcomeKind::try_from(code) {
                Ok(outcome) => self.word(outcome.name()),
                Err(unknown) => return self.display(unknown),
            },
            (ColumnType::Sequence, SummaryValue::U64(bits)) => {
                return self.display(PhaseSequence::from_bits(bits));
            }
            (ColumnType::Flag, SummaryValue::U8(0)) => self.word("false"),
            (ColumnType::Flag, SummaryValue::U8(_)) => self.word("true"),
            (_, SummaryValue::U8(count)) => return self.display(count),
            (_, SummaryValue::U32(count)) => return self.display(count),
            (_, SummaryValue::U64(count)) => return self.display(count),
            (_, SummaryValue::F64(value)) => self.real(value),
        }
        Ok(())
    }

    /// A number, which is an empty cell where it has no value.
    fn real(&mut self, value: f64) {
        if !value.is_nan() {
            let digits = self.digits.format(value);
            self.text.extend_from_slice(digits.as_bytes());
        }
        self.text.push(b',');
    }

    fn word(&mut self, word: &str) {
        self.text.extend_from_slice(word.as_bytes());
        self.text.push(b',');
    }

    fn display(&mut self, value: impl Display) -> io::Result<()> {
        write!(self.text, "{value},")
    }

    /// Writes the row, without the last comma, and empties it.
    fn write(&mut self, writer: &mut dyn Write) -> io::Result<()> {
        self.text.pop();
        self.text.push(b'\n');
        writer.write_all(&self.text)?;
        self.text.clear();
        Ok(())
    }
}
