//! Lists of starts, read from CSV or Parquet a chunk at a time.

use std::fs::File;
use std::io::{BufRead as _, BufReader, Read as _};
use std::path::{Path, PathBuf};

use arrow_array::cast::AsArray as _;
use arrow_array::types::Float64Type;
use arrow_array::{Array as _, Float64Array, RecordBatch};
use arrow_schema::DataType;
use littlewood::{ParameterError, Quantity};
use parquet::arrow::ProjectionMask;
use parquet::arrow::arrow_reader::{ParquetRecordBatchReader, ParquetRecordBatchReaderBuilder};
use serde_json::{Value, json};

use crate::axis::Coordinate;
use crate::compute::Refused;
use crate::error::{ListError, SweepError};
use crate::grid::{alone, plain};
use crate::point::Point;
use crate::run::Source;

/// Longest line of a CSV file, in bytes. Eight numbers need less than two hundred.
const LINE: u64 = 65_536;

/// Rows that are decoded at once from Parquet.
const BATCH: usize = 8192;

/// A list of starts in a file. Its columns are named as [`Coordinate::name`]s, or `x` and `time`, where and when the start
/// is; what has no column is taken from a base point.
///
/// Opening reads the file once, so that every bad cell is found before the first motion is computed.
#[derive(Clone, Debug)]
pub struct StartList {
    path: PathBuf,
    kind: Kind,
    base: Point,
    columns: Vec<Quantity>,
    rows: u64,
    /// Length and CRC-32 of the file.
    content: (u64, u32),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Csv,
    Parquet,
}

impl StartList {
    /// Opens a `.csv` or `.parquet` file and checks every cell.
    ///
    /// # Errors
    /// Says what is wrong, and in which line and column. The first line of a CSV file, its header, is line 1; the first
    /// row of a Parquet file is row 1.
    pub fn open(path: &Path, base: Point) -> Result<Self, ListError> {
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or("");
        let kind = match extension.to_ascii_lowercase().as_str() {
            "csv" => Kind::Csv,
            "parquet" => Kind::Parquet,
            _ => return Err(ListError::UnknownFormat { path: path.to_owned() }),
        };
        let content = checksum(path)?;
        let mut list = Self { path: path.to_owned(), kind, base, columns: Vec::new(), rows: 0, content };
        let mut rows = list.read()?;
        list.columns = rows.columns.clone();
        if list.columns.is_empty() {
            return Err(ListError::Empty { path: list.path });
        }
        for coordinate in Coordinate::ALL {
            let column = coordinate.quantity();
            if !list.columns.contains(&column) {
                let checked = alone(coordinate, coordinate.of_point(&base));
                checked.map_err(|source| ListError::Fixed { column, source })?;
            }
        }
        while let Some((line, point)) = rows.next_row()? {
            list.check(line, &point)?;
            list.rows += 1;
        }
        if list.rows == 0 {
            return Err(ListError::Empty { path: list.path });
        }
        Ok(list)
    }

    /// Number of starts.
    #[must_use]
    pub const fn rows(&self) -> u64 {
        self.rows
    }

    /// The quantities that the file has, in its order.
    #[must_use]
    pub fn columns(&self) -> &[Quantity] {
        &self.columns
    }

    /// The point that the others are taken from.
    #[must_use]
    pub const fn base(&self) -> &Point {
        &self.base
    }

    /// The points in order, each with its line in the file.
    ///
    /// # Errors
    /// If the file cannot be read, or is no longer what it was.
    pub fn points(&self) -> Result<impl Iterator<Item = Result<(u64, Point), ListError>> + use<>, ListError> {
        let mut rows = self.read()?;
        Ok(core::iter::from_fn(move || rows.next_row().transpose()))
    }

    pub(crate) fn fingerprint(&self) -> Value {
        json!({ "bytes": self.content.0, "crc32": format!("{:08x}", self.content.1), "rows": self.rows })
    }

    pub(crate) const fn source(&self, chunk: usize) -> ListSource<'_> {
        ListSource { list: self, chunk, rows: None, next: 0, lines: Vec::new() }
    }

    fn read(&self) -> Result<Rows, ListError> {
        Rows::open(&self.path, self.kind, self.base)
    }

    fn check(&self, line: u64, point: &Point) -> Result<(), ListError> {
        for &column in &self.columns {
            let checked = match Coordinate::of(column) {
                Some(coordinate) => alone(coordinate, coordinate.of_point(point)),
                None => plain(point.start),
            };
            checked.map_err(|source| ListError::BadValue {
                path: self.path.clone(),
                line,
                column,
                source,
            })?;
        }
        Ok(())
    }
}

/// Quantities that a list may have columns of.
pub(crate) fn known_columns() -> impl Iterator<Item = Quantity> {
    Coordinate::ALL.into_iter().map(Coordinate::quantity).chain([Quantity::X, Quantity::Time])
}

fn set(column: Quantity, point: &mut Point, value: f64) {
    match (Coordinate::of(column), column) {
        (Some(coordinate), _) => coordinate.set(point, value),
        (None, Quantity::X) => point.start.x = value,
        (None, _) => point.start.time = value,
    }
}

fn unreadable(path: &Path) -> impl Fn(std::io::Error) -> ListError + '_ {
    |source| ListError::Unreadable { path: path.to_owned(), source }
}

fn checksum(path: &Path) -> Result<(u64, u32), ListError> {
    let mut file = File::open(path).map_err(unreadable(path))?;
    let mut buffer = vec![0; 1 << 16];
    let mut hasher = crc32fast::Hasher::new();
    let mut length = 0;
    loop {
        match file.read(&mut buffer).map_err(unreadable(path))? {
            0 => return Ok((length, hasher.finalize())),
            n => {
                hasher.update(&buffer[..n]);
                length += n as u64;
            }
        }
    }
}

/// The rows of a file, one after the other.
struct Rows {
    path: PathBuf,
    base: Point,
    columns: Vec<Quantity>,
    cells: Cells,
}

enum Cells {
    Csv(Lines),
    Parquet { reader: ParquetRecordBatchReader, batch: Vec<Float64Array>, place: usize, row: u64 },
}

impl Rows {
    fn open(path: &Path, kind: Kind, base: Point) -> Result<Self, ListError> {
        let file = File::open(path).map_err(unreadable(path))?;
        let (columns, cells) = match kind {
            Kind::Csv => {
                let mut lines = Lines { reader: BufReader::new(file), text: Vec::new(), number: 0 };
                let columns = match lines.next_line(path)? {
                    Some(header) => columns_of(path, cells_of(header))?,
                    None => Vec::new(),
                };
                (columns, Cells::Csv(lines))
            }
            Kind::Parquet => parquet_cells(path, file)?,
        };
        Ok(Self { path: path.to_owned(), base, columns, cells })
    }

    fn next_row(&mut self) -> Result<Option<(u64, Point)>, ListError> {
        let Self { path, base, columns, cells } = self;
        let mut point = *base;
        match cells {
            Cells::Csv(lines) => {
                let Some(text) = lines.next_line(path)? else { return Ok(None) };
                let mut found = 0;
                let mut bad = None;
                for cell in cells_of(text) {
                    if let Some(&column) = columns.get(found) {
                        match cell.parse().ok().filter(|value: &f64| value.is_finite()) {
                            Some(value) => set(column, &mut point, value),
                            None => bad = bad.or_else(|| Some((column, cell.to_owned()))),
                        }
                    }
                    found += 1;
                }
                let (path, line) = (path.clone(), lines.number);
                if found != columns.len() {
                    let reason = format!("{found} cells where the header has {}", columns.len());
                    return Err(ListError::BadLine { path, line, reason });
                }
                match bad {
                    Some((column, cell)) => Err(ListError::BadCell { path, line, column, cell }),
                    None => Ok(Some((line, point))),
                }
            }
            Cells::Parquet { reader, batch, place, row } => {
                while batch.first().is_none_or(|values| *place >= values.len()) {
                    let Some(next) = reader.next() else { return Ok(None) };
                    let next = next.map_err(|error| bad_parquet(path, &error))?;
                    *batch = numbers(path, columns, &next)?;
                    *place = 0;
                }
                *row += 1;
                for (&column, values) in columns.iter().zip(batch.iter()) {
                    let bad =
                        |cell: String| ListError::BadCell { path: path.clone(), line: *row, column, cell };
                    if values.is_null(*place) {
                        return Err(bad("null".to_owned()));
                    }
                    let value = values.value(*place);
                    if !value.is_finite() {
                        return Err(bad(value.to_string()));
                    }
                    set(column, &mut point, value);
                }
                *place += 1;
                Ok(Some((*row, point)))
            }
        }
    }
}

fn columns_of<'a>(path: &Path, names: impl Iterator<Item = &'a str>) -> Result<Vec<Quantity>, ListError> {
    let mut columns = Vec::new();
    for name in names {
        let name = name.trim_start_matches('\u{feff}').trim_matches('"');
        let column = known_columns()
            .find(|column| column.name() == name)
            .ok_or_else(|| ListError::UnknownColumn { path: path.to_owned(), column: name.to_owned() })?;
        if columns.contains(&column) {
            return Err(ListError::DuplicateColumn { path: path.to_owned(), column });
        }
        columns.push(column);
    }
    Ok(columns)
}

/// The lines of a CSV file. Numbers and their names hold neither commas nor ends of lines, so cells need no quotes; they
/// may have them.
struct Lines {
    reader: BufReader<File>,
    text: Vec<u8>,
    /// Number of the line that was read last, from 1.
    number: u64,
}

impl Lines {
    /// The next line that is not blank.
    fn next_line(&mut self, path: &Path) -> Result<Option<&str>, ListError> {
        loop {
            self.text.clear();
            let limit = LINE + 1;
            let length =
                (&mut self.reader).take(limit).read_until(b'\n', &mut self.text).map_err(unreadable(path))?;
            if length == 0 {
                return Ok(None);
            }
            self.number += 1;
            let bad = |reason: &str| ListError::BadLine {
                path: path.to_owned(),
                line: self.number,
                reason: reason.to_owned(),
            };
            if length as u64 == limit {
                return Err(bad("longer than a line of numbers can be"));
            }
            if self.text.iter().all(u8::is_ascii_whitespace) {
                continue;
            }
            if core::str::from_utf8(&self.text).is_err() {
                return Err(bad("not UTF-8 text"));
            }
            break;
        }
        Ok(core::str::from_utf8(&self.text).ok())
    }
}

fn cells_of(line: &str) -> impl Iterator<Item = &str> {
    line.split(',').map(|cell| {
        let cell = cell.trim();
        cell.strip_prefix('"').and_then(|cell| cell.strip_suffix('"')).unwrap_or(cell).trim()
    })
}

fn bad_parquet(path: &Path, error: &dyn core::fmt::Display) -> ListError {
    ListError::BadParquet { path: path.to_owned(), reason: error.to_string() }
}

fn parquet_cells(path: &Path, file: File) -> Result<(Vec<Quantity>, Cells), ListError> {
    let builder =
        ParquetRecordBatchReaderBuilder::try_new(file).map_err(|error| bad_parquet(path, &error))?;
    let schema = builder.schema();
    let columns = columns_of(path, schema.fields().iter().map(|field| field.name().as_str()))?;
    for (&column, field) in columns.iter().zip(schema.fields()) {
        let found = field.data_type();
        if !(found.is_integer() || matches!(found, DataType::Float16 | DataType::Float32 | DataType::Float64))
        {
            return Err(ListError::NotNumbers { path: path.to_owned(), column, found: found.to_string() });
        }
    }
    let reader = builder
        .with_batch_size(BATCH)
        .with_projection(ProjectionMask::all())
        .build()
        .map_err(|error| bad_parquet(path, &error))?;
    Ok((columns, Cells::Parquet { reader, batch: Vec::new(), place: 0, row: 0 }))
}

fn numbers(path: &Path, columns: &[Quantity], batch: &RecordBatch) -> Result<Vec<Float64Array>, ListError> {
    columns
        .iter()
        .zip(batch.columns())
        .map(|(_, values)| {
            arrow_cast::cast(values, &DataType::Float64)
                .map(|values| values.as_primitive::<Float64Type>().clone())
                .map_err(|error| bad_parquet(path, &error))
        })
        .collect()
}

/// A list, chunk by chunk.
pub(crate) struct ListSource<'a> {
    list: &'a StartList,
    chunk: usize,
    rows: Option<Rows>,
    /// Row that comes next.
    next: u64,
    /// Lines of the first rows of the chunks that were handed out last, by chunk.
    lines: Vec<(usize, Vec<u64>)>,
}

impl ListSource<'_> {
    fn changed(&self) -> ListError {
        ListError::Changed { path: self.list.path.clone() }
    }
}

impl Source for ListSource<'_> {
    fn total(&self) -> u64 {
        self.list.rows
    }

    fn count(&self) -> usize {
        usize::try_from(self.list.rows.div_ceil(self.chunk as u64)).unwrap_or(usize::MAX)
    }

    fn points_of(&self, chunk: usize) -> u64 {
        let first = chunk as u64 * self.chunk as u64;
        (self.list.rows - first).min(self.chunk as u64)
    }

    fn points(&mut self, chunk: usize) -> Result<Vec<Point>, SweepError> {
        let first = chunk as u64 * self.chunk as u64;
        let len = self.points_of(chunk);
        let mut rows = match self.rows.take() {
            Some(rows) => rows,
            None => self.list.read()?,
        };
        if rows.columns != self.list.columns {
            return Err(self.changed().into());
        }
        let mut points = Vec::new();
        let mut lines = Vec::new();
        while self.next < first + len {
            let (line, point) = rows.next_row()?.ok_or_else(|| self.changed())?;
            if self.next >= first {
                points.push(point);
                lines.push(line);
            }
            self.next += 1;
        }
        self.rows = Some(rows);
        // Two chunks are in work at most; their lines are kept for messages.
        if self.lines.len() >= 2 {
            self.lines.remove(0);
        }
        self.lines.push((chunk, lines));
        Ok(points)
    }

    fn refused(&self, chunk: usize, refused: Refused) -> SweepError {
        let line = self
            .lines
            .iter()
            .find(|(number, _)| *number == chunk)
            .and_then(|(_, lines)| lines.get(refused.index).copied());
        let column = match refused.error {
            // The end of the time comes before its start: that is for the start to say, if the list has it.
            ParameterError::OutOfBounds { quantity: Quantity::Until, .. } => Some(Quantity::Time),
            ParameterError::OutOfBounds { quantity, .. } => Some(quantity),
            _ => None,
        };
        match (line, column) {
            (Some(line), Some(column)) if self.list.columns.contains(&column) => {
                ListError::BadValue { path: self.list.path.clone(), line, column, source: refused.error }
                    .into()
            }
            _ => refused.error.into(),
        }
    }
}
