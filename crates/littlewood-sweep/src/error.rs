//! What can be wrong with a sweep: its axes, its list of starts, its files.

use std::io;
use std::path::{Path, PathBuf};

use littlewood::{ParameterError, Quantity};
use thiserror::Error;

use crate::axis::Coordinate;
use crate::starts::known_columns;

/// What is wrong with the axes of a grid.
#[derive(Clone, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum AxisError {
    /// An end is NaN or infinite, or the ends are farther apart than a double can say.
    #[error("axis {coordinate}: {value} is not a finite number")]
    NotFinite {
        /// The coordinate.
        coordinate: Coordinate,
        /// The end, or the distance of the ends.
        value: f64,
    },
    /// No points.
    #[error("axis {coordinate}: 0 points; at least 1 is needed")]
    Empty {
        /// The coordinate.
        coordinate: Coordinate,
    },
    /// One point cannot have two ends.
    #[error("axis {coordinate}: 1 point cannot include both ends, {from} and {to}")]
    OnePointTwoEnds {
        /// The coordinate.
        coordinate: Coordinate,
        /// First value.
        from: f64,
        /// Last value.
        to: f64,
    },
    /// Many points at one value.
    #[error("axis {coordinate}: {count} points from {from} to {from} are all the same")]
    NoExtent {
        /// The coordinate.
        coordinate: Coordinate,
        /// The value.
        from: f64,
        /// Number of points.
        count: usize,
    },
    /// No axis at all.
    #[error("a grid needs at least one axis")]
    None,
    /// Two axes of the same coordinate.
    #[error("axis {coordinate} is given twice")]
    Twice {
        /// The coordinate.
        coordinate: Coordinate,
    },
    /// More points than 2⁶³.
    #[error("the grid has more points than can be counted")]
    TooMany,
    /// A value on an axis has no physical meaning, whatever the other axes say.
    #[error("axis {coordinate}: at {value}: {source}")]
    Value {
        /// The coordinate.
        coordinate: Coordinate,
        /// The value on the axis.
        value: f64,
        /// The bound it breaks.
        source: ParameterError,
    },
    /// A fixed value has no physical meaning.
    #[error("{0}")]
    Fixed(#[from] ParameterError),
}

/// What is wrong with a list of starts.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum ListError {
    /// The file cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// Neither `.csv` nor `.parquet`.
    #[error("{}: a list of starts ends in .csv or .parquet", path.display())]
    UnknownFormat {
        /// The file.
        path: PathBuf,
    },
    /// A header that is not a coordinate.
    #[error("{}: there is no quantity {column:?}; columns are {}", path.display(), known())]
    UnknownColumn {
        /// The file.
        path: PathBuf,
        /// The header.
        column: String,
    },
    /// A header that is there twice.
    #[error("{}: column {column} is there twice", path.display())]
    DuplicateColumn {
        /// The file.
        path: PathBuf,
        /// The header.
        column: Quantity,
    },
    /// No columns, or no rows.
    #[error("{}: no starts in it", path.display())]
    Empty {
        /// The file.
        path: PathBuf,
    },
    /// A row with too many or too few cells, or bytes that are not text.
    #[error("{}, line {line}: {reason}", path.display())]
    BadLine {
        /// The file.
        path: PathBuf,
        /// Line, from 1.
        line: u64,
        /// What is wrong with it.
        reason: String,
    },
    /// A cell that is not a finite number.
    #[error("{}, line {line}, column {column}: {cell:?} is not a finite number", path.display())]
    BadCell {
        /// The file.
        path: PathBuf,
        /// Line from 1 (CSV), or row from 1 (Parquet).
        line: u64,
        /// Column.
        column: Quantity,
        /// What it says.
        cell: String,
    },
    /// A cell whose value has no physical meaning.
    #[error("{}, line {line}, column {column}: {source}", path.display())]
    BadValue {
        /// The file.
        path: PathBuf,
        /// Line from 1 (CSV), or row from 1 (Parquet).
        line: u64,
        /// Column.
        column: Quantity,
        /// The bound it breaks.
        source: ParameterError,
    },
    /// A value that the list has no column for has no physical meaning.
    #[error("fixed {column}: {source}")]
    Fixed {
        /// The quantity.
        column: Quantity,
        /// The bound it breaks.
        source: ParameterError,
    },
    /// A Parquet column that does not hold numbers.
    #[error("{}: column {column} holds {found}, not numbers", path.display())]
    NotNumbers {
        /// The file.
        path: PathBuf,
        /// Column.
        column: Quantity,
        /// Type of the column.
        found: String,
    },
    /// Not a Parquet file, or a damaged one.
    #[error("{}: {reason}", path.display())]
    BadParquet {
        /// The file.
        path: PathBuf,
        /// What the reader says.
        reason: String,
    },
    /// The file has become another one since it was opened.
    #[error("{} has changed while it was read", path.display())]
    Changed {
        /// The file.
        path: PathBuf,
    },
}

fn known() -> String {
    known_columns().map(Quantity::name).collect::<Vec<_>>().join(", ")
}

/// What is wrong with a store, or with writing to it.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum StoreError {
    /// A file or folder cannot be written: a full disk, a folder without permission, a name that is taken.
    #[error("cannot write {}: {source}{}", path.display(), stay_readable(*finished))]
    Unwritable {
        /// The file or folder.
        path: PathBuf,
        /// Why.
        source: io::Error,
        /// Points whose chunks are on disk and stay readable.
        finished: u64,
    },
    /// A file of a store cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// There is something at the path that is not a store of this program.
    #[error("{} exists and is not the result of a sweep; it is left as it is", path.display())]
    NotAStore {
        /// The path.
        path: PathBuf,
    },
    /// There is a store of the same run, and nothing was said of resuming it.
    #[error("{} exists ({}); resume it, or choose another name", path.display(), if *complete { "complete" } else { "partial" })]
    Exists {
        /// The path.
        path: PathBuf,
        /// Whether all of its chunks are there.
        complete: bool,
    },
    /// There is a store of another run.
    #[error("{} was made by other parameters ({}); it is left as it is", path.display(), differences.join("; "))]
    OtherParameters {
        /// The path.
        path: PathBuf,
        /// What differs, as `name: there / here`.
        differences: Vec<String>,
    },
    /// Another process is writing to the store.
    #[error("another process is writing to {}", path.display())]
    Locked {
        /// The path.
        path: PathBuf,
    },
    /// The list of finished chunks cannot be understood.
    #[error("{}, line {line}: the list of finished chunks is damaged; remove the store and run again", path.display())]
    DamagedManifest {
        /// The file.
        path: PathBuf,
        /// Line, from 1.
        line: usize,
    },
    /// Metadata of a store cannot be understood.
    #[error("{}: damaged metadata: {reason}", path.display())]
    DamagedMetadata {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// A chunk cannot be decoded.
    #[error("{}: damaged chunk: {reason}", path.display())]
    DamagedChunk {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// Data cannot be put into the format. No input is known that does this.
    #[error("cannot encode {what}: {reason}")]
    Encoding {
        /// What was encoded.
        what: String,
        /// What the encoder says.
        reason: String,
    },
}

impl StoreError {
    pub(crate) fn unwritable(path: &Path, source: io::Error) -> Self {
        Self::Unwritable { path: path.to_owned(), source, finished: 0 }
    }

    /// Says how much of the run there is, where that is a comfort.
    pub(crate) fn with_finished(self, finished: u64) -> Self {
        match self {
            Self::Unwritable { path, source, .. } => Self::Unwritable { path, source, finished },
            other => other,
        }
    }
}

fn stay_readable(finished: u64) -> String {
    match finished {
        0 => String::new(),
        1 => "; the point that is finished stays readable".to_owned(),
        _ => format!("; the {finished} points that are finished stay readable"),
    }
}

/// What is wrong with a picture.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum PictureError {
    /// A map needs two axes.
    #[error("a map has 2 axes, this grid has {found}")]
    NotTwoAxes {
        /// Number of axes.
        found: usize,
    },
    /// Too small to draw in, or too large to hold.
    #[error("a picture of {width} x {height} pixels: each side must be from {least} to {most}")]
    Size {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// Smallest side.
        least: u32,
        /// Largest side.
        most: u32,
    },
    /// The drawing library refuses. No input is known that does this.
    #[error("cannot draw: {0}")]
    Drawing(String),
}

/// What stops a sweep.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SweepError {
    /// The axes.
    #[error(transparent)]
    Axis(#[from] AxisError),
    /// A start or a limit.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// The list of starts.
    #[error(transparent)]
    List(#[from] ListError),
    /// The files.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// The picture.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// A list has no place in a Zarr store, whose points stand on axes.
    #[error("{}: a list of starts does not fit a Zarr store", path.display())]
    ListAsZarr {
        /// The target.
        path: PathBuf,
    },
    /// The operating system gives no threads.
    #[error("cannot start {threads} threads: {reason}")]
    Threads {
        /// How many were asked for.
        threads: usize,
        /// What the system says.
        reason: String,
    },
}
