//! The rows of a Parquet file.

use std::fs::File;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;

use half::f16;
use littlewood::tables::{Quantity, Setup};
use parquet::basic::{ConvertedType, LogicalType, Repetition, Type as Physical};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::DataType;
use parquet::errors::Result as Decoded;
use parquet::file::reader::FileReader as _;
use parquet::file::serialized_reader::SerializedFileReader;
use parquet::schema::types::Type;

use super::error::ListError;
use super::header::columns_of;
use crate::parquet::open_reader;

/// Rows that are decoded at once.
const BATCH: usize = 8192;

/// The rows of a Parquet file, decoded batch by batch.
pub(super) struct ParquetRows {
    file: SerializedFileReader<File>,
    /// The row group that is read next.
    group: usize,
    /// The columns of the row group that is read.
    readers: Vec<Numbers>,
    batch: Vec<Vec<Option<f64>>>,
    /// The next row of the batch.
    next: usize,
    /// Number of the row that was read last, from 1.
    row: u64,
}

impl ParquetRows {
    /// Reads the names and the types of the columns.
    pub(super) fn open(path: &Path, file: File) -> Result<(Vec<Quantity>, Self), ListError> {
        let file = open_reader(file).map_err(|error| bad_parquet(path, &error))?;
        let schema = file.metadata().file_metadata().schema_descr().root_schema_ptr();
        let columns = columns_of(path, schema.get_fields().iter().map(|field| field.name()))?;
        for (&column, field) in columns.iter().zip(schema.get_fields()) {
            if let Some(found) = other_than_numbers(field) {
                return Err(ListError::NotNumbers { path: path.to_owned(), column, found });
            }
        }
        let rows = Self { file, group: 0, readers: Vec::new(), batch: Vec::new(), next: 0, row: 0 };
        Ok((columns, rows))
    }

    /// The next row with its number, its values set in a base setup.
    pub(super) fn next_row(
        &mut self,
        path: &Path,
        base: Setup,
        columns: &[Quantity],
    ) -> Result<Option<(u64, Setup)>, ListError> {
        while self.batch.first().is_none_or(|values| self.next >= values.len()) {
            // The decoder panics at some damaged pages.
            let more = catch_unwind(AssertUnwindSafe(|| self.next_batch()))
                .unwrap_or_else(|_| Err("one of its pages is damaged".to_owned()));
            if !more.map_err(|error| bad_parquet(path, &error))? {
                return Ok(None);
            }
        }
        self.row += 1;
        let mut point = base;
        for (&column, values) in columns.iter().zip(&self.batch) {
            let bad =
                |cell: String| ListError::BadCell { path: path.to_owned(), line: self.row, column, cell };
            match values[self.next] {
                None => return Err(bad("null".to_owned())),
                Some(value) if !value.is_finite() => return Err(bad(value.to_string())),
                Some(value) => point.set(column, value),
            }
        }
        self.next += 1;
        Ok(Some((self.row, point)))
    }

    /// Decodes more rows, of this row group or of the next; false at the end. There may be none in a batch.
    fn next_batch(&mut self) -> Result<bool, String> {
        let failed = |error: parquet::errors::ParquetError| error.to_string();
        (self.next, self.batch) = (0, Vec::new());
        let batch: Decoded<Vec<_>> = self.readers.iter_mut().map(Numbers::read).collect();
        let batch = batch.map_err(failed)?;
        let rows = batch.first().map_or(0, Vec::len);
        if batch.iter().any(|values| values.len() != rows) {
            return Err("its columns are not of the same length".to_owned());
        }
        self.batch = batch;
        if rows > 0 {
            return Ok(true);
        }
        if self.group >= self.file.num_row_groups() {
            return Ok(false);
        }
        let group = self.file.get_row_group(self.group).map_err(failed)?;
        let fields = group.metadata().schema_descr().columns();
        let readers = fields.iter().enumerate().map(|(i, field)| {
            Ok(Numbers { reader: group.get_column_reader(i)?, has_sign: has_sign(field.self_type()) })
        });
        self.readers = readers.collect::<Decoded<_>>().map_err(failed)?;
        self.group += 1;
        Ok(true)
    }
}

fn bad_parquet(path: &Path, error: &dyn core::fmt::Display) -> ListError {
    ListError::BadParquet { path: path.to_owned(), reason: error.to_string() }
}

/// The type of a column in words, if its values are no numbers.
fn other_than_numbers(field: &Type) -> Option<String> {
    let info = field.get_basic_info();
    if field.is_group() || (info.has_repetition() && info.repetition() == Repetition::REPEATED) {
        return Some("several values a row".to_owned());
    }
    let physical = field.get_physical_type();
    let is_number = match (physical, info.logical_type_ref()) {
        (Physical::INT32 | Physical::INT64, None) => is_integer(info.converted_type()),
        (Physical::INT32 | Physical::INT64, Some(LogicalType::Integer(_)))
        | (Physical::FLOAT | Physical::DOUBLE, None)
        | (Physical::FIXED_LEN_BYTE_ARRAY, Some(LogicalType::Float16)) => true,
        (_, _) => false,
    };
    let described = |logical: &LogicalType| format!("{physical} as {logical:?}");
    (!is_number).then(|| info.logical_type_ref().map_or_else(|| physical.to_string(), described))
}

/// Whether a type in the words of older files is an integer.
const fn is_integer(converted: ConvertedType) -> bool {
    matches!(
        converted,
        ConvertedType::NONE
            | ConvertedType::INT_8
            | ConvertedType::INT_16
            | ConvertedType::INT_32
            | ConvertedType::INT_64
            | ConvertedType::UINT_8
            | ConvertedType::UINT_16
            | ConvertedType::UINT_32
            | ConvertedType::UINT_64
    )
}

/// Whether the integers of a column have a sign.
fn has_sign(field: &Type) -> bool {
    let info = field.get_basic_info();
    match info.logical_type_ref() {
        Some(LogicalType::Integer(integer)) => integer.is_signed,
        _ => !matches!(
            info.converted_type(),
            ConvertedType::UINT_8 | ConvertedType::UINT_16 | ConvertedType::UINT_32 | ConvertedType::UINT_64
        ),
    }
}

/// A column of numbers of one row group.
struct Numbers {
    reader: ColumnReader,
    has_sign: bool,
}

impl Numbers {
    /// The next values; none of them at the end.
    fn read(&mut self) -> Decoded<Vec<Option<f64>>> {
        let has_sign = self.has_sign;
        match &mut self.reader {
            ColumnReader::Int32ColumnReader(reader) => {
                read(
                    reader,
                    |&value| {
                        if has_sign { f64::from(value) } else { f64::from(value.cast_unsigned()) }
                    },
                )
            }
            ColumnReader::Int64ColumnReader(reader) => {
                read(reader, |&value| if has_sign { value as f64 } else { value.cast_unsigned() as f64 })
            }
            ColumnReader::FloatColumnReader(reader) => read(reader, |&value| f64::from(value)),
            ColumnReader::DoubleColumnReader(reader) => read(reader, |&value| value),
            ColumnReader::FixedLenByteArrayColumnReader(reader) => read(reader, |value| {
                value.data().try_into().map_or(f64::NAN, |bytes| f16::from_le_bytes(bytes).to_f64())
            }),
            ColumnReader::BoolColumnReader(_)
            | ColumnReader::Int96ColumnReader(_)
            | ColumnReader::ByteArrayColumnReader(_) => Ok(Vec::new()),
        }
    }
}

fn read<T: DataType>(
    reader: &mut ColumnReaderImpl<T>,
    number: impl Fn(&T::T) -> f64,
) -> Decoded<Vec<Option<f64>>> {
    let (mut levels, mut values) = (Vec::new(), Vec::new());
    let (_, found, _) = reader.read_records(BATCH, Some(&mut levels), None, &mut values)?;
    let mut numbers = values[..found].iter().map(number);
    // A column without nulls has no levels.
    if levels.is_empty() {
        return Ok(numbers.map(Some).collect());
    }
    Ok(levels.iter().map(|&level| if level > 0 { numbers.next() } else { None }).collect())
}
