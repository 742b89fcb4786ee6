//! A list of starts in a file.

use std::io::Read as _;
use std::path::{Path, PathBuf};

use littlewood::tables::{DerivativeColumn, Quantity, Setup};
use serde_json::{Value, json};

use super::error::{ListError, unreadable};
use super::rows::Rows;
use crate::file::open_file;
use crate::getters::getters;
use crate::setup::quantities;

/// A list of starts in a file. Its columns are named as the quantities of a hoop and a start are
/// ([`Quantity::name`]); what has no column is taken from a base setup.
///
/// Opening reads the file once, so that every bad cell is found before the first motion is
/// computed.
#[derive(Clone, Debug)]
pub struct StartList {
    path: PathBuf,
    base: Setup,
    columns: Vec<Quantity>,
    rows: u64,
    /// Length and CRC-32 of the file.
    content: (u64, u32),
    derivatives: Vec<DerivativeColumn>,
}

getters! {
    StartList:
    /// The derivatives that are computed.
    derivatives(self) -> &[DerivativeColumn] = self.derivatives.as_slice();
    /// Number of starts.
    rows(self) -> u64 = self.rows;
    /// The quantities that the file has, in its order.
    columns(self) -> &[Quantity] = self.columns.as_slice();
    /// The setup from which quantities without a column are taken.
    base(self) -> &Setup = &self.base;
}

impl StartList {
    /// Opens a `.csv` file and checks every cell.
    ///
    /// # Errors
    /// Says what is wrong, and in which line and column. The header is line 1.
    pub fn open(path: &Path, base: Setup) -> Result<Self, ListError> {
        let mut rows = Rows::open(path, base)?;
        let content = checksum(path)?;
        let columns = rows.columns.clone();
        let mut list = Self {
            path: path.to_owned(),
            base,
            columns,
            rows: 0,
            content,
            derivatives: Vec::new(),
        };
        if list.columns.is_empty() {
            return Err(ListError::Empty { path: list.path });
        }
        for column in quantities() {
            if !list.columns.contains(&column)
                && let Some(value) = base.get(column)
            {
                column
                    .check(value)
                    .map_err(|source| ListError::Fixed { column, source })?;
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

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The points in order, each with its line in the file.
    ///
    /// # Errors
    /// If the file cannot be read, or is not the one that was opened.
    pub fn points(
        &self,
    ) -> Result<impl Iterator<Item = Result<(u64, Setup), ListError>> + use<>, ListError> {
        let mut rows = self.read()?;
        Ok(core::iter::from_fn(move || rows.next_row().transpose()))
    }

    /// Length and checksum of the file, for descriptions of runs.
    pub(crate) fn fingerprint(&self) -> Value {
        json!({ "bytes": self.content.0, "crc32": format!("{:08x}", self.content.1), "rows": self.rows })
    }

    pub(crate) fn read(&self) -> Result<Rows, ListError> {
        let rows = Rows::open(&self.path, self.base)?;
        if rows.columns == self.columns {
            Ok(rows)
        } else {
            Err(self.changed())
        }
    }

    pub(crate) fn changed(&self) -> ListError {
        ListError::Changed {
            path: self.path.clone(),
        }
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
    let mut file = open_file(path).map_err(unreadable(path))?;
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
