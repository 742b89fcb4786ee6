//! The type of the values of an array, and what stands for a value that is not there.

use littlewood::tables::SummaryValue;
use serde_json::Value;

/// A type with its fill value.
#[derive(Clone, Copy, Debug)]
pub(super) struct DataType(pub(super) SummaryValue);

impl DataType {
    pub(super) const fn name(self) -> &'static str {
        match self.0 {
            SummaryValue::U8(_) => "uint8",
            SummaryValue::U32(_) => "uint32",
            SummaryValue::U64(_) => "uint64",
            SummaryValue::F64(_) => "float64",
        }
    }

    /// Bytes of a value.
    pub(super) const fn size(self) -> usize {
        match self.0 {
            SummaryValue::U8(_) => 1,
            SummaryValue::U32(_) => 4,
            SummaryValue::U64(_) | SummaryValue::F64(_) => 8,
        }
    }

    /// What readers see where a chunk is missing.
    pub(super) fn fill_value(self) -> Value {
        match self.0 {
            SummaryValue::U8(value) => value.into(),
            SummaryValue::U32(value) => value.into(),
            SummaryValue::U64(value) => value.into(),
            SummaryValue::F64(value) if value.is_nan() => "NaN".into(),
            SummaryValue::F64(value) => value.into(),
        }
    }
}
