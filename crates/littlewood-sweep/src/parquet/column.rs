//! The columns of a table: what a file says of them, and their values to a file and back.

use std::collections::HashMap;
use std::io::Write;

use arrow_schema::{DataType as Arrow, Field};
use littlewood::OutcomeKind;
use littlewood::tables::{ColumnType, PhaseSequence, Quantity, SummaryValue};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::{
    BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int32Type, Int64Type,
};
use parquet::errors::Result;
use parquet::file::writer::SerializedRowGroupWriter;
use serde_json::Value;

use crate::attributes::{Attributes, of_axis, of_column, of_words};
use crate::columns::{Column as Results, ColumnValues};

/// A column as Arrow describes it, with its attributes. Real numbers can be null; nothing else can.
fn field(name: &str, data_type: Arrow, attributes: Attributes) -> Field {
    let text = |value| match value {
        Value::String(text) => text,
        other => other.to_string(),
    };
    let attributes = attributes
        .into_iter()
        .map(|(name, value)| (name, text(value)))
        .collect();
    let is_real = data_type == Arrow::Float64;
    Field::new(name, data_type, is_real).with_metadata(attributes)
}

pub(super) fn of_quantity(quantity: Quantity) -> Field {
    field(quantity.name(), Arrow::Float64, of_axis(quantity.into()))
}

/// Those of a column of results: a code has its words before it.
pub(super) fn of_results(column: Results) -> Vec<Field> {
    let data_type = match column.column_type() {
        ColumnType::Outcome => Arrow::UInt8,
        ColumnType::Sequence => Arrow::UInt64,
        ColumnType::Count => Arrow::UInt32,
        ColumnType::Flag => Arrow::Boolean,
        ColumnType::Real => Arrow::Float64,
    };
    let numbers = field(&name_of_numbers(column), data_type, of_column(column));
    let words = match (column, column.column_type()) {
        (Results::Summary(column), ColumnType::Outcome | ColumnType::Sequence) => {
            let data_type = Arrow::Dictionary(Box::new(Arrow::Int32), Box::new(Arrow::Utf8));
            Some(field(column.name(), data_type, of_words(column)))
        }
        (
            Results::Summary(_) | Results::Derivative(_),
            ColumnType::Outcome
            | ColumnType::Sequence
            | ColumnType::Count
            | ColumnType::Flag
            | ColumnType::Real,
        ) => None,
    };
    words.into_iter().chain([numbers]).collect()
}

/// The name under which a table has the numbers of a column.
pub(super) fn name_of_numbers(column: Results) -> String {
    match column.column_type() {
        ColumnType::Outcome | ColumnType::Sequence => format!("{column}_code"),
        ColumnType::Count | ColumnType::Flag | ColumnType::Real => column.to_string(),
    }
}

pub(super) struct Writer<'a, 'b, W: Write>(pub(super) &'a mut SerializedRowGroupWriter<'b, W>);

impl<W: Write + Send> Writer<'_, '_, W> {
    /// Real numbers; NaN, which stands for what does not happen, is null: engines that sort NaN
    /// above all numbers would count it as late.
    pub(super) fn reals(&mut self, values: &[f64]) -> Result<()> {
        let levels = each(values, |value| if value.is_nan() { NULL } else { PRESENT });
        let present: Vec<f64> = values
            .iter()
            .copied()
            .filter(|value| !value.is_nan())
            .collect();
        self.write::<DoubleType>(&present, Some(&levels))
    }

    /// A column of results: all that [`of_results`] has of it.
    pub(super) fn results(&mut self, column: Results, values: &ColumnValues) -> Result<()> {
        match (column.column_type(), values) {
            (ColumnType::Outcome, ColumnValues::U8(codes)) => {
                let name = |code: u8| match OutcomeKind::try_from(code) {
                    Ok(kind) => kind.to_string(),
                    Err(unknown) => unknown.to_string(),
                };
                self.words(codes, name)?;
            }
            (ColumnType::Sequence, ColumnValues::U64(codes)) => {
                self.words(codes, |bits| PhaseSequence::from_bits(bits).to_string())?;
            }
            (ColumnType::Flag, ColumnValues::U8(flags)) => {
                return self.write::<BoolType>(&each(flags, |flag| flag != 0), None);
            }
            (
                _,
                ColumnValues::U8(_)
                | ColumnValues::U32(_)
                | ColumnValues::U64(_)
                | ColumnValues::F64(_),
            ) => {}
        }
        // The file has the bits of a number, and its type says that they have no sign.
        match values {
            ColumnValues::U8(values) => self.write::<Int32Type>(&each(values, i32::from), None),
            ColumnValues::U32(values) => {
                self.write::<Int32Type>(&each(values, u32::cast_signed), None)
            }
            ColumnValues::U64(values) => {
                self.write::<Int64Type>(&each(values, u64::cast_signed), None)
            }
            ColumnValues::F64(values) => self.reals(values),
        }
    }

    /// The words of some codes, each distinct one made once.
    fn words<T: Copy + Eq + core::hash::Hash>(
        &mut self,
        codes: &[T],
        text: impl Fn(T) -> String,
    ) -> Result<()> {
        let mut words = HashMap::new();
        let word = |code| {
            words
                .entry(code)
                .or_insert_with(|| ByteArray::from(text(code).into_bytes()))
                .clone()
        };
        self.write::<ByteArrayType>(&each(codes, word), None)
    }

    /// The values that are not null; `levels` say of each row of a column that can be null whether
    /// it is.
    fn write<T: DataType>(&mut self, values: &[T::T], levels: Option<&[i16]>) -> Result<()> {
        if let Some(mut column) = self.0.next_column()? {
            column.typed::<T>().write_batch(values, levels, None)?;
            column.close()?;
        }
        Ok(())
    }
}

/// Definition levels of a row.
const NULL: i16 = 0;
const PRESENT: i16 = 1;

fn each<T: Copy, U>(values: &[T], to: impl FnMut(T) -> U) -> Vec<U> {
    values.iter().copied().map(to).collect()
}

/// Records that are read at once: what a damaged footer says of their number makes no memory be
/// taken.
const BATCH: usize = 1 << 16;

pub(super) fn read(
    column: Results,
    reader: ColumnReader,
) -> core::result::Result<ColumnValues, String> {
    let no_code = |_| format!("column {column} has a number that is no code");
    match (column.not_computed(), reader) {
        (SummaryValue::U8(_), ColumnReader::BoolColumnReader(reader)) => {
            Ok(ColumnValues::U8(each(&all(reader)?, u8::from)))
        }
        (SummaryValue::U8(_), ColumnReader::Int32ColumnReader(reader)) => {
            let codes: core::result::Result<_, _> =
                all(reader)?.into_iter().map(u8::try_from).collect();
            codes.map(ColumnValues::U8).map_err(no_code)
        }
        (SummaryValue::U32(_), ColumnReader::Int32ColumnReader(reader)) => {
            Ok(ColumnValues::U32(each(&all(reader)?, i32::cast_unsigned)))
        }
        (SummaryValue::U64(_), ColumnReader::Int64ColumnReader(reader)) => {
            Ok(ColumnValues::U64(each(&all(reader)?, i64::cast_unsigned)))
        }
        (SummaryValue::F64(_), ColumnReader::DoubleColumnReader(reader)) => {
            reals(reader).map(ColumnValues::F64)
        }
        (
            SummaryValue::U8(_)
            | SummaryValue::U32(_)
            | SummaryValue::U64(_)
            | SummaryValue::F64(_),
            _,
        ) => Err(format!("column {column} is of another type")),
    }
}

/// All values of a column that is never null.
fn all<T: DataType>(mut reader: ColumnReaderImpl<T>) -> core::result::Result<Vec<T::T>, String> {
    let mut values = Vec::new();
    loop {
        let (records, _, _) = reader
            .read_records(BATCH, None, None, &mut values)
            .map_err(|error| error.to_string())?;
        if records == 0 {
            return Ok(values);
        }
    }
}

/// All values of a column of real numbers, NaN where it is null.
fn reals(mut reader: ColumnReaderImpl<DoubleType>) -> core::result::Result<Vec<f64>, String> {
    let (mut levels, mut values) = (Vec::new(), Vec::new());
    loop {
        let (records, _, _) = reader
            .read_records(BATCH, Some(&mut levels), None, &mut values)
            .map_err(|error| error.to_string())?;
        if records == 0 {
            break;
        }
    }
    let mut present = values.into_iter();
    let value = |level| match level {
        PRESENT => present.next().ok_or("a value is missing"),
        _ => Ok(f64::NAN),
    };
    let rows: core::result::Result<_, _> = levels.into_iter().map(value).collect();
    rows.map_err(str::to_owned)
}
