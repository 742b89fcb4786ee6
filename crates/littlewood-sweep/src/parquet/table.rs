//! The columns of a table, and a chunk of it as a Parquet file.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use arrow_array::types::Int32Type;
use arrow_array::{
    ArrayRef, BooleanArray, DictionaryArray, Float64Array, RecordBatch, StringArray, UInt8Array, UInt32Array,
    UInt64Array,
};
use arrow_schema::{DataType, Field, Schema};
use littlewood::{PhaseSequence, Quantity};
use parquet::arrow::ArrowWriter;
use parquet::basic::{Compression, ZstdLevel};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use serde_json::{Value, json};

use super::read::read_part;
use crate::axis::Coordinate;
use crate::columns::{Columns, Real};
use crate::description::Description;
use crate::disk::UNFINISHED;
use crate::error::StoreError;
use crate::outcome;
use crate::point::Point;
use crate::run::{Format, StoreFile};

const HEADER: &str = "_run.json";
const MANIFEST: &str = "_chunks.txt";
const LOCK: &str = "_lock";

/// The description of the run, in the footer.
pub(super) const RUN_KEY: &str = "littlewood_run";

/// The number of the chunk, in the footer of its file.
pub(super) const CHUNK_KEY: &str = "littlewood_chunk";

/// A table in files, one a chunk.
pub(crate) struct Table {
    description: Description,
    schema: Arc<Schema>,
    digits: usize,
    /// Columns of the start besides the coordinates: x or time, if a list has them.
    places: Vec<Quantity>,
}

fn text_type() -> DataType {
    DataType::Dictionary(Box::new(DataType::Int32), Box::new(DataType::Utf8))
}

fn schema(places: &[Quantity]) -> Schema {
    let field = |name: &str, data_type: DataType, long_name: &str, unit: &str| {
        Field::new(name, data_type, false).with_metadata(
            [("long_name", long_name), ("units", unit)]
                .map(|(key, value)| (key.to_owned(), value.to_owned()))
                .into_iter()
                .collect::<std::collections::HashMap<_, _>>(),
        )
    };
    let mut fields: Vec<Field> = Coordinate::ALL
        .into_iter()
        .map(|coordinate| {
            field(coordinate.name(), DataType::Float64, coordinate.long_name(), coordinate.unit())
        })
        .collect();
    fields.extend(places.iter().map(|place| {
        let [long_name, unit] = match place {
            Quantity::X => ["position of the geometric centre at the start", "R"],
            _ => ["time of the start", "sqrt(R/g)"],
        };
        field(place.name(), DataType::Float64, long_name, unit)
    }));
    fields.extend([
        field("outcome", text_type(), "outcome", ""),
        field("outcome_code", DataType::UInt8, "code of the outcome", ""),
        field(
            "sequence",
            text_type(),
            "sequence of phases: R rolling, + and - sliding, g and n and G gliding, F flight",
            "",
        ),
        field(
            "sequence_code",
            DataType::UInt64,
            "sequence of phases, 3 bits a phase, first phase lowest",
            "",
        ),
        field("transitions", DataType::UInt32, "number of transitions", "1"),
        field("painleve", DataType::Boolean, "whether the motion met a Painlevé paradox", ""),
    ]);
    fields.extend(
        Real::ALL
            .into_iter()
            .map(|column| field(column.name(), DataType::Float64, column.long_name(), column.unit())),
    );
    Schema::new(fields)
}

fn text<'a>(values: impl Iterator<Item = String> + 'a) -> ArrayRef {
    let mut words: Vec<String> = Vec::new();
    let mut keys = std::collections::HashMap::new();
    let indices: Vec<i32> = values
        .map(|value| {
            *keys.entry(value).or_insert_with_key(|value| {
                words.push(value.clone());
                i32::try_from(words.len() - 1).unwrap_or(i32::MAX)
            })
        })
        .collect();
    let values = Arc::new(StringArray::from(words));
    Arc::new(DictionaryArray::<Int32Type>::new(indices.into(), values))
}

pub(super) fn encoding<E: core::fmt::Display>(what: &str) -> impl Fn(E) -> StoreError + '_ {
    move |error| StoreError::Encoding { what: what.to_owned(), reason: error.to_string() }
}

impl Table {
    /// A table with columns for these places of starts.
    pub(super) fn new(description: Description, chunks: usize, places: Vec<Quantity>) -> Self {
        let digits = chunks.saturating_sub(1).to_string().len().max(5);
        Self { description, schema: Arc::new(schema(&places)), digits, places }
    }

    fn batch(&self, points: &[Point], columns: &Columns) -> Result<RecordBatch, StoreError> {
        let mut arrays: Vec<ArrayRef> = Coordinate::ALL
            .into_iter()
            .map(|coordinate| {
                let values = points.iter().map(|point| coordinate.of_point(point));
                Arc::new(Float64Array::from_iter_values(values)) as ArrayRef
            })
            .collect();
        for place in &self.places {
            let values = points.iter().map(|point| match place {
                Quantity::X => point.start.x,
                _ => point.start.time,
            });
            arrays.push(Arc::new(Float64Array::from_iter_values(values)));
        }
        arrays.push(text(columns.outcome.iter().map(|&code| outcome::name(code).unwrap_or("?").to_owned())));
        arrays.push(Arc::new(UInt8Array::from(columns.outcome.clone())));
        arrays.push(text(columns.sequence.iter().map(|&bits| PhaseSequence::from_bits(bits).to_string())));
        arrays.push(Arc::new(UInt64Array::from(columns.sequence.clone())));
        arrays.push(Arc::new(UInt32Array::from(columns.transitions.clone())));
        arrays.push(Arc::new(columns.painleve.iter().map(|&flag| Some(flag != 0)).collect::<BooleanArray>()));
        for values in &columns.reals {
            arrays.push(Arc::new(Float64Array::from(values.clone())));
        }
        RecordBatch::try_new(Arc::clone(&self.schema), arrays).map_err(encoding("a table"))
    }

    /// The file of a chunk.
    pub(super) fn path(&self, chunk: usize) -> PathBuf {
        PathBuf::from(format!("part-{chunk:0digits$}.parquet", digits = self.digits))
    }

    /// Whether a run makes a file of this name in the folder of a table.
    pub(super) fn is_a_file_of_ours(&self, name: &str) -> bool {
        let name = name.strip_suffix(UNFINISHED).unwrap_or(name);
        let part = |name: &str| -> Option<bool> {
            let digits = name.strip_prefix("part-")?.strip_suffix(".parquet")?;
            Some(digits.len() == self.digits && digits.bytes().all(|byte| byte.is_ascii_digit()))
        };
        [HEADER, MANIFEST, LOCK].contains(&name) || part(name) == Some(true)
    }
}

impl Format for Table {
    fn description(&self) -> &Description {
        &self.description
    }

    fn header_path(&self) -> &'static str {
        HEADER
    }

    fn manifest_path(&self) -> &'static str {
        MANIFEST
    }

    fn lock_path(&self) -> &'static str {
        LOCK
    }

    fn header(&self, complete: bool) -> Result<Vec<u8>, StoreError> {
        let mut text = serde_json::to_vec_pretty(&json!({
            "program": "littlewood-sweep",
            "status": if complete { "complete" } else { "partial" },
            "run": self.description.0,
        }))
        .map_err(encoding(HEADER))?;
        text.push(b'\n');
        Ok(text)
    }

    fn read_header(&self, header: &Value) -> Option<(Value, bool)> {
        if header.get("program")?.as_str()? != "littlewood-sweep" {
            return None;
        }
        Some((header.get("run")?.clone(), header.get("status")?.as_str()? == "complete"))
    }

    fn prelude(&self) -> Result<Vec<StoreFile>, StoreError> {
        Ok(Vec::new())
    }

    fn paths(&self, chunk: usize) -> Vec<PathBuf> {
        vec![self.path(chunk)]
    }

    fn encode(
        &self,
        chunk: usize,
        points: &[Point],
        columns: &Columns,
    ) -> Result<Vec<StoreFile>, StoreError> {
        let path = self.path(chunk);
        let name = path.to_string_lossy().into_owned();
        let level = ZstdLevel::try_new(3).map_err(encoding(&name))?;
        let properties = WriterProperties::builder()
            .set_compression(Compression::ZSTD(level))
            .set_max_row_group_row_count(None)
            .set_created_by(concat!("littlewood-sweep ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_key_value_metadata(Some(vec![
                KeyValue::new(RUN_KEY.to_owned(), self.description.0.to_string()),
                KeyValue::new(CHUNK_KEY.to_owned(), chunk.to_string()),
            ]))
            .build();
        let mut writer = ArrowWriter::try_new(Vec::new(), Arc::clone(&self.schema), Some(properties))
            .map_err(encoding(&name))?;
        writer.write(&self.batch(points, columns)?).map_err(encoding(&name))?;
        let bytes = writer.into_inner().map_err(encoding(&name))?;
        Ok(vec![(path, bytes)])
    }

    fn read(&self, root: &Path, chunk: usize) -> Result<Option<Columns>, StoreError> {
        read_part(&root.join(self.path(chunk)))
    }
}
