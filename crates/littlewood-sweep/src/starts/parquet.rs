//! The rows of a Parquet file.

use std::fs::File;
use std::path::Path;

use arrow_array::cast::AsArray as _;
use arrow_array::types::Float64Type;
use arrow_array::{Array as _, ArrayRef, Float64Array, RecordBatch};
use arrow_schema::DataType;
use littlewood::{Quantity, Setup};
use parquet::arrow::ProjectionMask;
use parquet::arrow::arrow_reader::ParquetRecordBatchReader;

use super::error::ListError;
use super::header::columns_of;
use crate::parquet::open_reader;

/// Rows that are decoded at once.
const BATCH: usize = 8192;

/// The rows of a Parquet file, decoded batch by batch.
pub(super) struct ParquetRows {
    reader: ParquetRecordBatchReader,
    batch: Vec<Float64Array>,
    /// The next row of the batch.
    next: usize,
    /// Number of the row that was read last, from 1.
    row: u64,
}

impl ParquetRows {
    /// Reads the names and the types of the columns.
    pub(super) fn open(path: &Path, file: File) -> Result<(Vec<Quantity>, Self), ListError> {
        let builder = open_reader(file).map_err(|error| bad_parquet(path, &error))?;
        let schema = builder.schema();
        let columns = columns_of(path, schema.fields().iter().map(|field| field.name().as_str()))?;
        for (&column, field) in columns.iter().zip(schema.fields()) {
            let found = field.data_type();
            let is_real = matches!(found, DataType::Float16 | DataType::Float32 | DataType::Float64);
            if !(found.is_integer() || is_real) {
                return Err(ListError::NotNumbers {
                    path: path.to_owned(),
                    column,
                    found: found.to_string(),
                });
            }
        }
        let reader = builder
            .with_batch_size(BATCH)
            .with_projection(ProjectionMask::all())
            .build()
            .map_err(|error| bad_parquet(path, &error))?;
        Ok((columns, Self { reader, batch: Vec::new(), next: 0, row: 0 }))
    }

    /// The next row with its number, its values set in a base setup.
    pub(super) fn next_row(
        &mut self,
        path: &Path,
        base: Setup,
        columns: &[Quantity],
    ) -> Result<Option<(u64, Setup)>, ListError> {
        while self.batch.first().is_none_or(|values| self.next >= values.len()) {
            let Some(batch) = self.reader.next() else { return Ok(None) };
            self.batch = numbers(path, &batch.map_err(|error| bad_parquet(path, &error))?)?;
            self.next = 0;
        }
        self.row += 1;
        let mut point = base;
        for (&column, values) in columns.iter().zip(&self.batch) {
            let bad =
                |cell: String| ListError::BadCell { path: path.to_owned(), line: self.row, column, cell };
            if values.is_null(self.next) {
                return Err(bad("null".to_owned()));
            }
            let value = values.value(self.next);
            if !value.is_finite() {
                return Err(bad(value.to_string()));
            }
            point.set(column, value);
        }
        self.next += 1;
        Ok(Some((self.row, point)))
    }
}

fn bad_parquet(path: &Path, error: &dyn core::fmt::Display) -> ListError {
    ListError::BadParquet { path: path.to_owned(), reason: error.to_string() }
}

fn numbers(path: &Path, batch: &RecordBatch) -> Result<Vec<Float64Array>, ListError> {
    let double = |values: &ArrayRef| {
        arrow_cast::cast(values, &DataType::Float64)
            .map(|values| values.as_primitive::<Float64Type>().clone())
            .map_err(|error| bad_parquet(path, &error))
    };
    batch.columns().iter().map(double).collect()
}
