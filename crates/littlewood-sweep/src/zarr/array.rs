//! Arrays of a store: their metadata, and chunks to bytes and back.

use littlewood::tables::SummaryValue;
use serde_json::{Value, json};
use zstd::bulk::{Compressor, Decompressor};

use crate::attributes::Attributes;
use crate::columns::{Column, ColumnValues};
use crate::store::StoreError;

/// Level of the compression: the numbers of motions hardly repeat, and level 3 takes a third longer
/// to save 3 %. With the checksum every reader notices a damaged chunk.
const LEVEL: i32 = 1;

#[derive(Debug)]
pub(super) struct Array {
    pub(super) name: String,
    pub(super) shape: Vec<usize>,
    /// Shape of a chunk, also of one that is cut off at the far end of an axis.
    pub(super) chunk: Vec<usize>,
    /// What stands for a value that is not there, of the type of all.
    pub(super) fill: SummaryValue,
    pub(super) dimensions: Vec<&'static str>,
    pub(super) attributes: Attributes,
}

impl Array {
    /// What `zarr.json` says of it.
    pub(super) fn metadata(&self) -> Value {
        let fill: Value = match self.fill {
            SummaryValue::U8(value) => value.into(),
            SummaryValue::U32(value) => value.into(),
            SummaryValue::U64(value) => value.into(),
            SummaryValue::F64(value) if value.is_nan() => "NaN".into(),
            SummaryValue::F64(value) => value.into(),
        };
        json!({
            "zarr_format": 3,
            "node_type": "array",
            "shape": self.shape,
            "data_type": self.data_type().0,
            "chunk_grid": { "name": "regular", "configuration": { "chunk_shape": self.chunk } },
            "chunk_key_encoding": { "name": "default", "configuration": { "separator": "/" } },
            "fill_value": fill,
            "codecs": [
                { "name": "bytes", "configuration": { "endian": "little" } },
                { "name": "zstd", "configuration": { "level": LEVEL, "checksum": true } },
            ],
            "attributes": self.attributes,
            "dimension_names": self.dimensions,
        })
    }

    /// The name of the type of the values, and the bytes of one.
    const fn data_type(&self) -> (&'static str, usize) {
        match self.fill {
            SummaryValue::U8(_) => ("uint8", 1),
            SummaryValue::U32(_) => ("uint32", 4),
            SummaryValue::U64(_) => ("uint64", 8),
            SummaryValue::F64(_) => ("float64", 8),
        }
    }

    pub(super) fn path(&self, place: &[usize]) -> String {
        let place = place.iter().map(|number| format!("/{number}"));
        format!("{}/c{}", self.name, place.collect::<String>())
    }

    pub(super) fn encode(&self, values: &[u8]) -> Result<Vec<u8>, StoreError> {
        let compress = || {
            let mut compressor = Compressor::new(LEVEL)?;
            compressor.include_checksum(true)?;
            compressor.compress(values)
        };
        compress().map_err(StoreError::encoding(&self.name))
    }

    pub(super) fn decode(&self, file: &[u8]) -> Result<Vec<u8>, String> {
        let size = self.chunk.iter().product::<usize>() * self.data_type().1;
        let decompress = || Decompressor::new()?.decompress(file, size);
        let values = decompress().map_err(|error| error.to_string())?;
        if values.len() == size {
            Ok(values)
        } else {
            Err(format!(
                "{} bytes of values instead of {size}",
                values.len()
            ))
        }
    }
}

/// The values of a chunk as little-endian bytes. A chunk at the edge of the array is padded to the
/// full size with the fill value.
pub(super) fn to_bytes(
    column: Column,
    values: &ColumnValues,
    places: &[usize],
    size: usize,
) -> Vec<u8> {
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

/// The bytes of values one after the other. Byte by byte they would take as long as the motions of
/// a map.
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
        places
            .iter()
            .map(|place| core::array::from_fn(|i| bytes[place * N + i]))
    }
    match column.not_computed() {
        SummaryValue::U8(_) => ColumnValues::U8(places.iter().map(|&place| bytes[place]).collect()),
        SummaryValue::U32(_) => {
            ColumnValues::U32(words(bytes, places).map(u32::from_le_bytes).collect())
        }
        SummaryValue::U64(_) => {
            ColumnValues::U64(words(bytes, places).map(u64::from_le_bytes).collect())
        }
        SummaryValue::F64(_) => {
            ColumnValues::F64(words(bytes, places).map(f64::from_le_bytes).collect())
        }
    }
}
