//! Arrays of a store: their metadata, and chunks to bytes and back.

use littlewood::tables::SummaryValue;
use serde_json::{Value, json};
use zstd::bulk::{Compressor, Decompressor};

use crate::attributes::Attributes;
use crate::store::StoreError;

/// Level of the compression: the numbers of motions hardly repeat, and level 3 takes a third longer to save 3 %. With the
/// checksum every reader notices a damaged chunk.
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
            Err(format!("{} bytes of values instead of {size}", values.len()))
        }
    }
}
