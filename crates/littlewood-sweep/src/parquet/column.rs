//! The columns of a table: the fields of a column of results, and its values as arrays and back.

use std::collections::HashMap;
use std::sync::Arc;

use arrow_array::cast::AsArray as _;
use arrow_array::types::{Float64Type, Int32Type, UInt8Type, UInt32Type, UInt64Type};
use arrow_array::{
    ArrayRef, BooleanArray, DictionaryArray, Float64Array, RecordBatch, StringArray, UInt8Array, UInt32Array,
    UInt64Array,
};
use arrow_schema::{DataType, Field};
use littlewood::{ColumnType, OutcomeKind, PhaseSequence, Quantity, SummaryColumn};
use serde_json::Value;

use crate::attributes::{Attributes, of_column, of_quantity, of_words};
use crate::columns::{ColumnValues, not_computed};

/// The field of a quantity.
pub(super) fn field_of_quantity(quantity: Quantity) -> Field {
    field(quantity.name(), DataType::Float64, of_quantity(quantity))
}

/// The fields of a column of results: a code has its words before it.
pub(super) fn fields(column: SummaryColumn) -> Vec<Field> {
    let words = || {
        let text = DataType::Dictionary(Box::new(DataType::Int32), Box::new(DataType::Utf8));
        field(column.name(), text, of_words(column))
    };
    let numbers = |data_type| field(&name_of_numbers(column), data_type, of_column(column));
    match column.column_type() {
        ColumnType::Outcome => vec![words(), numbers(DataType::UInt8)],
        ColumnType::Sequence => vec![words(), numbers(DataType::UInt64)],
        ColumnType::Count => vec![numbers(DataType::UInt32)],
        ColumnType::Flag => vec![numbers(DataType::Boolean)],
        ColumnType::Real => vec![numbers(DataType::Float64)],
    }
}

/// The name under which a table has the numbers of a column.
fn name_of_numbers(column: SummaryColumn) -> String {
    match column.column_type() {
        ColumnType::Outcome | ColumnType::Sequence => format!("{column}_code"),
        ColumnType::Count | ColumnType::Flag | ColumnType::Real => column.to_string(),
    }
}

fn field(name: &str, data_type: DataType, attributes: Attributes) -> Field {
    let text = |value| match value {
        Value::String(text) => text,
        other => other.to_string(),
    };
    let metadata: HashMap<String, String> =
        attributes.into_iter().map(|(name, value)| (name, text(value))).collect();
    Field::new(name, data_type, false).with_metadata(metadata)
}

/// The arrays of a column of results, one for each of its [`fields`].
pub(super) fn arrays(column: SummaryColumn, values: &ColumnValues) -> Vec<ArrayRef> {
    match (column.column_type(), values) {
        (ColumnType::Outcome, ColumnValues::U8(codes)) => {
            let name = |code: u8| match OutcomeKind::try_from(code) {
                Ok(kind) => kind.to_string(),
                Err(unknown) => unknown.to_string(),
            };
            vec![words(codes, name), Arc::new(UInt8Array::from(codes.clone()))]
        }
        (ColumnType::Sequence, ColumnValues::U64(codes)) => {
            let text = |bits| PhaseSequence::from_bits(bits).to_string();
            vec![words(codes, text), Arc::new(UInt64Array::from(codes.clone()))]
        }
        (ColumnType::Flag, ColumnValues::U8(flags)) => {
            vec![Arc::new(flags.iter().map(|&flag| Some(flag != 0)).collect::<BooleanArray>())]
        }
        (_, ColumnValues::U8(values)) => vec![Arc::new(UInt8Array::from(values.clone()))],
        (_, ColumnValues::U32(values)) => vec![Arc::new(UInt32Array::from(values.clone()))],
        (_, ColumnValues::U64(values)) => vec![Arc::new(UInt64Array::from(values.clone()))],
        (_, ColumnValues::F64(values)) => vec![Arc::new(Float64Array::from(values.clone()))],
    }
}

/// The words of some codes, each distinct one written once.
fn words<T: Copy + Eq + core::hash::Hash>(codes: &[T], text: impl Fn(T) -> String) -> ArrayRef {
    let mut words: Vec<String> = Vec::new();
    let mut places = HashMap::new();
    let indices: Vec<i32> = codes
        .iter()
        .map(|&code| {
            *places.entry(code).or_insert_with(|| {
                words.push(text(code));
                i32::try_from(words.len() - 1).unwrap_or(i32::MAX)
            })
        })
        .collect();
    let words = Arc::new(StringArray::from(words));
    Arc::new(DictionaryArray::<Int32Type>::new(indices.into(), words))
}

/// No values of each column of results.
pub(super) fn empty() -> Vec<ColumnValues> {
    SummaryColumn::ALL.into_iter().map(|column| ColumnValues::repeat(not_computed(column), 0)).collect()
}

/// Appends the rows of a batch to the values of each column; none if the batch lacks a column, or has it of another
/// type.
pub(super) fn append(columns: &mut [ColumnValues], batch: &RecordBatch) -> Option<()> {
    for (column, values) in SummaryColumn::ALL.into_iter().zip(columns) {
        let array = batch.column_by_name(&name_of_numbers(column))?;
        match values {
            ColumnValues::U8(values) if column.column_type() == ColumnType::Flag => {
                values.extend(array.as_boolean_opt()?.values().iter().map(u8::from));
            }
            ColumnValues::U8(values) => values.extend(array.as_primitive_opt::<UInt8Type>()?.values()),
            ColumnValues::U32(values) => values.extend(array.as_primitive_opt::<UInt32Type>()?.values()),
            ColumnValues::U64(values) => values.extend(array.as_primitive_opt::<UInt64Type>()?.values()),
            ColumnValues::F64(values) => values.extend(array.as_primitive_opt::<Float64Type>()?.values()),
        }
    }
    Some(())
}
