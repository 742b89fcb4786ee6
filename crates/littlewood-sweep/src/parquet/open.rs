//! Opening a Parquet file that may be damaged.

use std::fs::File;

use parquet::file::metadata::{ColumnChunkMetaData, ParquetMetaData};
use parquet::file::reader::FileReader as _;
use parquet::file::serialized_reader::SerializedFileReader;

/// A reader of a file whose footer speaks of what there is in it: the library takes that for granted.
///
/// # Errors
/// What is wrong with the file.
pub(crate) fn open_reader(file: File) -> Result<SerializedFileReader<File>, String> {
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
        group.num_rows() >= 0 && group.columns().iter().all(|column| is_column_inside(column, length))
    })
}

fn is_column_inside(column: &ColumnChunkMetaData, length: u64) -> bool {
    let start = column.dictionary_page_offset().unwrap_or_else(|| column.data_page_offset());
    let end = start.checked_add(column.compressed_size()).and_then(|end| u64::try_from(end).ok());
    start >= 0
        && column.compressed_size() >= 0
        && column.num_values() >= 0
        && end.is_some_and(|end| end <= length)
}
