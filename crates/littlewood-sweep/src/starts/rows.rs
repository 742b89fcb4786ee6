//! The rows of a list, whatever its format.

use std::fs::File;
use std::path::{Path, PathBuf};

use littlewood::tables::{Quantity, Setup};

use super::csv::CsvRows;
use super::error::{ListError, unreadable};
#[cfg(feature = "parquet")]
use super::parquet::ParquetRows;

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
    /// The rows of a `.csv` or `.parquet` file.
    pub(super) fn open(path: &Path, base: Setup) -> Result<Self, ListError> {
        let open = || File::open(path).map_err(unreadable(path));
        let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
        let (columns, cells) = match ending.to_ascii_lowercase().as_str() {
            "csv" => {
                let (columns, rows) = CsvRows::open(path, open()?)?;
                (columns, Cells::Csv(rows))
            }
            #[cfg(feature = "parquet")]
            "parquet" => {
                let (columns, rows) = ParquetRows::open(path, open()?)?;
                (columns, Cells::Parquet(rows))
            }
            #[cfg(not(feature = "parquet"))]
            "parquet" => return Err(ListError::NotBuilt { path: path.to_owned() }),
            _ => return Err(ListError::UnknownFormat { path: path.to_owned() }),
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
