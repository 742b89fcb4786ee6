//! The rows of a list, whatever its format.

use std::fs::File;
use std::path::{Path, PathBuf};

use littlewood::tables::{Quantity, Setup};

use super::csv::CsvRows;
use super::error::{ListError, unreadable};
#[cfg(feature = "parquet")]
use super::parquet::ParquetRows;

/// Format of a list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ListFormat {
    Csv,
    #[cfg(feature = "parquet")]
    Parquet,
}

/// The rows of a file, one after the other.
pub(crate) struct Rows {
    path: PathBuf,
    base: Setup,
    columns: Vec<Quantity>,
    cells: Cells,
}

enum Cells {
    Csv(CsvRows),
    #[cfg(feature = "parquet")]
    Parquet(ParquetRows),
}

impl Rows {
    pub(super) fn open(path: &Path, format: ListFormat, base: Setup) -> Result<Self, ListError> {
        let file = File::open(path).map_err(unreadable(path))?;
        let (columns, cells) = match format {
            ListFormat::Csv => {
                let (columns, rows) = CsvRows::open(path, file)?;
                (columns, Cells::Csv(rows))
            }
            #[cfg(feature = "parquet")]
            ListFormat::Parquet => {
                let (columns, rows) = ParquetRows::open(path, file)?;
                (columns, Cells::Parquet(rows))
            }
        };
        Ok(Self { path: path.to_owned(), base, columns, cells })
    }

    /// The quantities that the file has, in its order.
    pub(crate) fn columns(&self) -> &[Quantity] {
        &self.columns
    }

    /// The next row with its line.
    pub(crate) fn next_row(&mut self) -> Result<Option<(u64, Setup)>, ListError> {
        let Self { path, base, columns, cells } = self;
        match cells {
            Cells::Csv(rows) => rows.next_row(path, *base, columns),
            #[cfg(feature = "parquet")]
            Cells::Parquet(rows) => rows.next_row(path, *base, columns),
        }
    }
}
