//! The columns of a table: what a file says of them, and their values to a file and back.

use std::collections::HashMap;
use std::io::Write;
use std::sync::Arc;

use littlewood::OutcomeKind;
use littlewood::tables::{ColumnType, PhaseSequence, Quantity, SummaryValue};
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::column::reader::{ColumnReader, ColumnReaderImpl};
use parquet::data_type::{
    BoolType, ByteArray, ByteArrayType, DataType, DoubleType, Int32Type, Int64Type,
};
use parquet::errors::Result;
use parquet::file::writer::SerializedRowGroupWriter;
use parquet::schema::types::{Type, TypePtr};
use serde_json::Value;

use crate::attributes::{Attributes, of_axis, of_column, of_words};
use crate::columns::{Column as Results, ColumnValues};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Words,
    Flag,
    U8,
    U32,
    U64,
    F64,
}

pub(super) struct Column {
    pub(super) name: String,
    pub(super) kind: Kind,
    pub(super) attributes: Vec<(String, String)>,
}

impl Column {
    fn new(name: &str, kind: Kind, attributes: Attributes) -> Self {
        let text = |value| match value {
            Value::String(text) => text,
            other => other.to_string(),
        };
        let attributes = attributes
            .into_iter()
            .map(|(name, value)| (name, text(value)))
            .collect();
        Self {
            name: name.to_owned(),
            kind,
            attributes,
        }
    }

    pub(super) fn of_quantity(quantity: Quantity) -> Self {
        Self::new(quantity.name(), Kind::F64, of_axis(quantity.into()))
    }

    /// Those of a column of results: a code has its words before it.
    pub(super) fn of_results(column: Results) -> Vec<Self> {
        let kind = match column.column_type() {
            ColumnType::Outcome => Kind::U8,
            ColumnType::Sequence => Kind::U64,
            ColumnType::Count => Kind::U32,
            ColumnType::Flag => Kind::Flag,
            ColumnType::Real => Kind::F64,
        };
        let numbers = Self::new(&name_of_numbers(column), kind, of_column(column));
        let words = match (column, column.column_type()) {
            (Results::Summary(column), ColumnType::Outcome | ColumnType::Sequence) => {
                Some(Self::new(column.name(), Kind::Words, of_words(column)))
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

    pub(super) fn field(&self) -> Result<TypePtr> {
        let (physical, logical) = match self.kind {
            Kind::Words => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
            Kind::Flag => (Physical::BOOLEAN, None),
            Kind::U8 => (Physical::INT32, Some(LogicalType::integer(8, false))),
            Kind::U32 => (Physical::INT32, Some(LogicalType::integer(32, false))),
            Kind::U64 => (Physical::INT64, Some(LogicalType::integer(64, false))),
            Kind::F64 => (Physical::DOUBLE, None),
        };
        Type::primitive_type_builder(&self.name, physical)
            .with_repetition(Repetition::REQUIRED)
            .with_logical_type(logical)
            .build()
            .map(Arc::new)
    }
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
    pub(super) fn reals(&mut self, values: &[f64]) -> Result<()> {
        self.write::<DoubleType>(values)
    }

    /// A column of results: all that [`Column::of_results`] has of it.
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
                return self.write::<BoolType>(&each(flags, |flag| flag != 0));
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
            ColumnValues::U8(values) => self.write::<Int32Type>(&each(values, i32::from)),
            ColumnValues::U32(values) => self.write::<Int32Type>(&each(values, u32::cast_signed)),
            ColumnValues::U64(values) => self.write::<Int64Type>(&each(values, u64::cast_signed)),
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
        self.write::<ByteArrayType>(&each(codes, word))
    }

    fn write<T: DataType>(&mut self, values: &[T::T]) -> Result<()> {
        if let Some(mut column) = self.0.next_column()? {
            column.typed::<T>().write_batch(values, None, None)?;
            column.close()?;
        }
        Ok(())
    }
}

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
            Ok(ColumnValues::F64(all(reader)?))
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
