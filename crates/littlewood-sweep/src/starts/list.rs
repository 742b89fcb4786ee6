//! A list of starts in a file.

use std::fs::File;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use littlewood::tables::{DerivativeColumn, Quantity, Setup};
use serde_json::{Value, json};

use super::error::{ListError, unreadable};
use super::rows::{ListFormat, Rows};
use crate::setup::quantities;

/// A list of starts in a file. Its columns are named as the quantities of a hoop and a start are
/// ([`Quantity::name`]); what has no column is taken from a base setup.
///
/// Opening reads the file once, so that every bad cell is found before the first motion is computed.
#[derive(Clone, Debug)]
pub struct StartList {
    path: PathBuf,
    format: ListFormat,
    base: Setup,
    columns: Vec<Quantity>,
    rows: u64,
    /// Length and CRC-32 of the file.
    content: (u64, u32),
    derivatives: Vec<DerivativeColumn>,
}

impl StartList {
    /// Opens a `.csv` or `.parquet` file and checks every cell.
    ///
    /// # Errors
    /// Says what is wrong, and in which line and column. The first line of a CSV file, its header, is line 1; the first
    /// row of a Parquet file is row 1.
    pub fn open(path: &Path, base: Setup) -> Result<Self, ListError> {
        let extension = path.extension().and_then(|extension| extension.to_str()).unwrap_or("");
        let format = match extension.to_ascii_lowercase().as_str() {
            "csv" => ListFormat::Csv,
            #[cfg(feature = "parquet")]
            "parquet" => ListFormat::Parquet,
            #[cfg(not(feature = "parquet"))]
            "parquet" => return Err(ListError::NotBuilt { path: path.to_owned() }),
            _ => return Err(ListError::UnknownFormat { path: path.to_owned() }),
        };
        let content = checksum(path)?;
        let mut rows = Rows::open(path, format, base)?;
        let columns = rows.columns().to_vec();
        let mut list =
            Self { path: path.to_owned(), format, base, columns, rows: 0, content, derivatives: Vec::new() };
        if list.columns.is_empty() {
            return Err(ListError::Empty { path: list.path });
        }
        for column in quantities() {
            if !list.columns.contains(&column)
                && let Some(value) = base.get(column)
            {
                column.check(value).map_err(|source| ListError::Fixed { column, source })?;
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

    /// With derivatives of numbers of the summary, which are NaN where they do not exist.
    #[must_use]
    pub fn with_derivatives(mut self, derivatives: Vec<DerivativeColumn>) -> Self {
        self.derivatives = derivatives;
        self
    }

    /// The derivatives that are computed.
    #[must_use]
    pub fn derivatives(&self) -> &[DerivativeColumn] {
        &self.derivatives
    }

    /// The file.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
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

    /// The setup from which quantities without a column are taken.
    #[must_use]
    pub const fn base(&self) -> &Setup {
        &self.base
    }

    /// The points in order, each with its line in the file.
    ///
    /// # Errors
    /// If the file cannot be read, or is not the one that was opened.
    pub fn points(&self) -> Result<impl Iterator<Item = Result<(u64, Setup), ListError>> + use<>, ListError> {
        let mut rows = self.read()?;
        Ok(core::iter::from_fn(move || rows.next_row().transpose()))
    }

    /// Length and checksum of the file, for descriptions of runs.
    pub(crate) fn fingerprint(&self) -> Value {
        json!({ "bytes": self.content.0, "crc32": format!("{:08x}", self.content.1), "rows": self.rows })
    }

    /// The rows from the first one on.
    pub(crate) fn read(&self) -> Result<Rows, ListError> {
        let rows = Rows::open(&self.path, self.format, self.base)?;
        if rows.columns() == self.columns { Ok(rows) } else { Err(self.changed()) }
    }

    /// The error that the file is not the one that was opened.
    pub(crate) fn changed(&self) -> ListError {
        ListError::Changed { path: self.path.clone() }
    }

    fn check(&self, line: u64, point: &Setup) -> Result<(), ListError> {
        for &column in &self.columns {
            if let Some(value) = point.get(column) {
                column.check(value).map_err(|source| ListError::BadValue {
                    path: self.path.clone(),
                    line,
                    column,
                    source,
                })?;
            }
        }
        Ok(())
    }
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
