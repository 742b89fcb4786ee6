//! Results out of a Parquet file again.

use std::fs::File;
use std::io::ErrorKind;
use std::path::Path;

use arrow_array::cast::AsArray as _;
use arrow_array::types::{Float64Type, UInt8Type, UInt32Type, UInt64Type};
use arrow_array::{ArrayRef, RecordBatch};
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;

use crate::columns::{Columns, Real};
use crate::error::StoreError;

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
    let file = File::open(path).map_err(|source| StoreError::Unreadable { path: path.to_owned(), source })?;
    let damaged = |reason: String| StoreError::DamagedChunk { path: path.to_owned(), reason };
    let builder =
        ParquetRecordBatchReaderBuilder::try_new(file).map_err(|error| damaged(error.to_string()))?;
    if number >= builder.metadata().num_row_groups() {
        return Err(damaged(format!("it has no row group {number}")));
    }
    let reader = builder.with_row_groups(vec![number]).build().map_err(|error| damaged(error.to_string()))?;
    let mut columns = Columns::default();
    for batch in reader {
        let batch = batch.map_err(|error| damaged(error.to_string()))?;
        append(&mut columns, &batch)
            .ok_or_else(|| damaged("a column is missing, or of another type".to_owned()))?;
    }
    Ok(columns)
}

fn append(columns: &mut Columns, batch: &RecordBatch) -> Option<()> {
    let column = |name: &str| -> Option<&ArrayRef> { batch.column_by_name(name) };
    columns.outcome.extend(column("outcome_code")?.as_primitive_opt::<UInt8Type>()?.values());
    columns.sequence.extend(column("sequence_code")?.as_primitive_opt::<UInt64Type>()?.values());
    columns.transitions.extend(column("transitions")?.as_primitive_opt::<UInt32Type>()?.values());
    columns.painleve.extend(column("painleve")?.as_boolean_opt()?.values().iter().map(u8::from));
    for (real, values) in Real::ALL.into_iter().zip(&mut columns.reals) {
        values.extend(column(real.name())?.as_primitive_opt::<Float64Type>()?.values());
    }
    Some(())
}
