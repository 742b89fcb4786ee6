//! Reading the results of a Parquet file.

use std::fs::File;
use std::io::ErrorKind;
use std::path::Path;

use super::column::{append, empty};
use super::open::open_reader;
use crate::columns::Columns;
use crate::store::StoreError;

/// The results of a file with one chunk; none if it is not there.
pub(super) fn read_part(path: &Path) -> Result<Option<Columns>, StoreError> {
    match read_row_group(path, 0) {
        Ok(columns) => Ok(Some(columns)),
        Err(StoreError::Unreadable { source, .. }) if source.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// The results of a row group, which is a chunk.
pub(super) fn read_row_group(path: &Path, number: usize) -> Result<Columns, StoreError> {
    let file = File::open(path).map_err(|source| StoreError::unreadable(path, source))?;
    let damaged = |reason: String| StoreError::DamagedChunk { path: path.to_owned(), reason };
    let builder = open_reader(file).map_err(damaged)?;
    if number >= builder.metadata().num_row_groups() {
        return Err(damaged(format!("it has no row group {number}")));
    }
    let reader = builder.with_row_groups(vec![number]).build().map_err(|error| damaged(error.to_string()))?;
    let mut columns = empty();
    for batch in reader {
        let batch = batch.map_err(|error| damaged(error.to_string()))?;
        append(&mut columns, &batch)
            .ok_or_else(|| damaged("a column is missing, or of another type".to_owned()))?;
    }
    Columns::from_values(columns).map_err(damaged)
}
