//! The values of a column of a store as bytes.

use littlewood::tables::SummaryValue;

use crate::columns::{Column, ColumnValues};

/// The values of a chunk in a box of the full chunk size, little-endian, with the fill value where there are none.
pub(super) fn to_bytes(column: Column, values: &ColumnValues, places: &[usize], size: usize) -> Vec<u8> {
    if values.len() == size {
        return bytes(values);
    }
    let mut full = ColumnValues::repeat(column.not_computed(), size);
    full.spread(places.iter().copied(), values);
    bytes(&full)
}

fn bytes(values: &ColumnValues) -> Vec<u8> {
    match values {
        ColumnValues::U8(values) => values.clone(),
        ColumnValues::U32(values) => joined(values, u32::to_le_bytes),
        ColumnValues::U64(values) => joined(values, u64::to_le_bytes),
        ColumnValues::F64(values) => joined(values, f64::to_le_bytes),
    }
}

/// The bytes of values one after the other. Byte by byte they would take as long as the motions of a map.
fn joined<T: Copy, const N: usize>(values: &[T], bytes: impl Fn(T) -> [u8; N]) -> Vec<u8> {
    let mut all = vec![0; N * values.len()];
    for (place, value) in all.as_chunks_mut().0.iter_mut().zip(values) {
        *place = bytes(*value);
    }
    all
}

/// The values of a chunk from a box of the full chunk size.
pub(super) fn from_bytes(column: Column, bytes: &[u8], places: &[usize]) -> ColumnValues {
    fn words<const N: usize>(bytes: &[u8], places: &[usize]) -> impl Iterator<Item = [u8; N]> {
        places.iter().map(|place| core::array::from_fn(|i| bytes[place * N + i]))
    }
    match column.not_computed() {
        SummaryValue::U8(_) => ColumnValues::U8(places.iter().map(|&place| bytes[place]).collect()),
        SummaryValue::U32(_) => ColumnValues::U32(words(bytes, places).map(u32::from_le_bytes).collect()),
        SummaryValue::U64(_) => ColumnValues::U64(words(bytes, places).map(u64::from_le_bytes).collect()),
        SummaryValue::F64(_) => ColumnValues::F64(words(bytes, places).map(f64::from_le_bytes).collect()),
    }
}
