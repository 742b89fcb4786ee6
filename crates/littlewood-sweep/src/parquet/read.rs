//! Reading the results of a Parquet file.

use std::fs::File;
use std::io::ErrorKind;
use std::path::Path;

use littlewood::tables::DerivativeColumn;
use parquet::file::reader::FileReader as _;

use super::column::{name_of_numbers, read as read_column};
use super::open::open_reader;
use crate::columns::{Column, Columns};
use crate::store::StoreError;

/// The results of a file with one chunk; none if it is not there.
pub(super) fn read_part(
    path: &Path,
    derivatives: &[DerivativeColumn],
) -> Result<Option<Columns>, StoreError> {
    match read_row_group(path, 0, derivatives) {
        Ok(columns) => Ok(Some(columns)),
        Err(StoreError::Unreadable { source, .. }) if source.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error),
    }
}

/// The results of a row group, which is a chunk.
pub(super) fn read_row_group(
    path: &Path,
    number: usize,
    derivatives: &[DerivativeColumn],
) -> Result<Columns, StoreError> {
    let file = File::open(path).map_err(|source| StoreError::unreadable(path, source))?;
    let damaged = |reason: String| StoreError::DamagedChunk { path: path.to_owned(), reason };
    let reader = open_reader(file).map_err(damaged)?;
    if number >= reader.num_row_groups() {
        return Err(damaged(format!("it has no row group {number}")));
    }
    let group = reader.get_row_group(number).map_err(|error| damaged(error.to_string()))?;
    let schema = group.metadata().schema_descr_ptr();
    let values = Column::all(derivatives).map(|column| {
        let name = name_of_numbers(column);
        let place = schema.columns().iter().position(|field| field.path().parts() == [name.as_str()]);
        let place = place.ok_or_else(|| format!("column {name} is missing"))?;
        let reader = group.get_column_reader(place).map_err(|error| error.to_string())?;
        read_column(column, reader)
    });
    let values = values.collect::<Result<Vec<_>, String>>().map_err(damaged)?;
    Columns::from_values(values, derivatives).map_err(damaged)
}
