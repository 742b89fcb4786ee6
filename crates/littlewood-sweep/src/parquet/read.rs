//! Reading the results of a Parquet file.

use std::fs::File;
use std::io::ErrorKind;
use std::path::Path;

use littlewood::tables::DerivativeColumn;
use parquet::file::metadata::{ColumnChunkMetaData, ParquetMetaData};
use parquet::file::reader::FileReader as _;
use parquet::file::serialized_reader::SerializedFileReader;

use super::column::{name_of_numbers, read as read_column};
use crate::columns::{Column, Columns};
use crate::file::open_file;
use crate::store::StoreError;

/// The results of a file with one chunk; none if it is not there.
pub(super) fn read_part(
    path: &Path,
    derivatives: &[DerivativeColumn],
) -> Result<Option<Columns>, StoreError> {
    match read_row_group(path, 0, derivatives) {
        Ok(columns) => Ok(Some(columns)),
        Err(StoreError::Unreadable { source, .. }) if source.kind() == ErrorKind::NotFound => {
            Ok(None)
        }
        Err(error) => Err(error),
    }
}

/// The results of a row group, which is a chunk.
pub(super) fn read_row_group(
    path: &Path,
    number: usize,
    derivatives: &[DerivativeColumn],
) -> Result<Columns, StoreError> {
    let file = open_file(path).map_err(|source| StoreError::unreadable(path, source))?;
    let damaged = |reason: String| StoreError::DamagedChunk {
        path: path.to_owned(),
        reason,
    };
    let reader = open_reader(file).map_err(damaged)?;
    if number >= reader.num_row_groups() {
        return Err(damaged(format!("it has no row group {number}")));
    }
    let group = reader
        .get_row_group(number)
        .map_err(|error| damaged(error.to_string()))?;
    let schema = group.metadata().schema_descr_ptr();
    let values = Column::all(derivatives).map(|column| {
        let name = name_of_numbers(column);
        let place = schema
            .columns()
            .iter()
            .position(|field| field.path().parts() == [name.as_str()]);
        let place = place.ok_or_else(|| format!("column {name} is missing"))?;
        let reader = group
            .get_column_reader(place)
            .map_err(|error| error.to_string())?;
        read_column(column, reader)
    });
    let values = values
        .collect::<Result<Vec<_>, String>>()
        .map_err(damaged)?;
    Columns::from_values(values, derivatives).map_err(damaged)
}

/// A reader of a file whose footer speaks of what there is in it: the library takes that for
/// granted.
fn open_reader(file: File) -> Result<SerializedFileReader<File>, String> {
    let length = file.metadata().map_err(|error| error.to_string())?.len();
    let reader = SerializedFileReader::new(file).map_err(|error| error.to_string())?;
    if is_inside(reader.metadata(), length) {
        Ok(reader)
    } else {
        Err("its footer speaks of columns that are not in it".to_owned())
    }
}

fn is_inside(metadata: &ParquetMetaData, length: u64) -> bool {
    metadata.row_groups().iter().all(|group| {
        group.num_rows() >= 0
            && group
                .columns()
                .iter()
                .all(|column| is_column_inside(column, length))
    })
}

fn is_column_inside(column: &ColumnChunkMetaData, length: u64) -> bool {
    let start = column
        .dictionary_page_offset()
        .unwrap_or_else(|| column.data_page_offset());
    let end = start
        .checked_add(column.compressed_size())
        .and_then(|end| u64::try_from(end).ok());
    start >= 0
        && column.compressed_size() >= 0
        && column.num_values() >= 0
        && end.is_some_and(|end| end <= length)
}
