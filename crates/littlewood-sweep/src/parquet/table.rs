//! A table in files: its schema, and a chunk of it as a Parquet file.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use arrow_array::{ArrayRef, Float64Array, RecordBatch};
use arrow_schema::{Field, Schema};
use littlewood::{Quantity, Setup, SummaryColumn};
use parquet::arrow::ArrowWriter;
use parquet::basic::{Compression, ZstdLevel};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use serde_json::{Value, json};

use super::column::{arrays, field_of_quantity, fields};
use super::read::read_part;
use crate::columns::Columns;
use crate::description::{Description, STORE_FORMAT};
use crate::disk::UNFINISHED;
use crate::grid::Grid;
use crate::setup::places;
use crate::starts::StartList;
use crate::store::{Format, Header, StoreError, StoreFile};

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
    /// The quantities of the points.
    quantities: Vec<Quantity>,
}

impl Table {
    /// The table of a grid. The rows stand chunk by chunk (see [`crate::Chunks`]), each with the quantities of its
    /// point.
    pub(crate) fn of_grid(description: &Description, chunks: usize, grid: &Grid) -> Self {
        Self::new(
            description.clone(),
            chunks,
            of_points(grid.base(), |quantity| grid.axis(quantity).is_some()),
        )
    }

    /// The table of a list, one row a start in the order of the list. Where and when the start is has a column if the
    /// list has one.
    pub(crate) fn of_list(description: &Description, chunks: usize, list: &StartList) -> Self {
        let has_column = |quantity| list.columns().contains(&quantity);
        let places = places().filter(|place| has_column(*place));
        let quantities = of_points(list.base(), has_column).into_iter().chain(places).collect();
        Self::new(description.clone(), chunks, quantities)
    }

    fn new(description: Description, chunks: usize, quantities: Vec<Quantity>) -> Self {
        let digits = chunks.saturating_sub(1).to_string().len().max(5);
        let of_points = quantities.iter().copied().map(field_of_quantity);
        let schema: Vec<Field> = of_points.chain(SummaryColumn::ALL.into_iter().flat_map(fields)).collect();
        Self { description, schema: Arc::new(Schema::new(schema)), digits, quantities }
    }

    fn batch(&self, points: &[Setup], columns: &Columns) -> Result<RecordBatch, StoreError> {
        let of_points = self.quantities.iter().map(|&quantity| {
            let values = points.iter().map(|point| point.get(quantity).unwrap_or(f64::NAN));
            Arc::new(Float64Array::from_iter_values(values)) as ArrayRef
        });
        let results = columns.columns().flat_map(|(column, values)| arrays(column, values));
        RecordBatch::try_new(Arc::clone(&self.schema), of_points.chain(results).collect())
            .map_err(StoreError::encoding("a table"))
    }

    /// The file of a chunk.
    pub(super) fn path(&self, chunk: usize) -> PathBuf {
        PathBuf::from(format!("part-{chunk:0digits$}.parquet", digits = self.digits))
    }

    /// Whether a run makes a file of this name in the folder of a table.
    pub(super) fn makes_file(&self, name: &str) -> bool {
        let name = name.strip_suffix(UNFINISHED).unwrap_or(name);
        let part = |name: &str| -> Option<bool> {
            let digits = name.strip_prefix("part-")?.strip_suffix(".parquet")?;
            Some(digits.len() == self.digits && digits.bytes().all(|byte| byte.is_ascii_digit()))
        };
        [HEADER, MANIFEST, LOCK].contains(&name) || part(name) == Some(true)
    }
}

/// What a motion depends on, where the base or a column gives it a value.
fn of_points(base: &Setup, has_column: impl Fn(Quantity) -> bool) -> Vec<Quantity> {
    let is_given = |quantity: &Quantity| has_column(*quantity) || base.get(*quantity).is_some();
    Quantity::AXES.into_iter().filter(is_given).collect()
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
            "program": Header::PROGRAM,
            "format": STORE_FORMAT,
            "status": Header::status(complete),
            "run": self.description.0,
        }))
        .map_err(StoreError::encoding(HEADER))?;
        text.push(b'\n');
        Ok(text)
    }

    fn read_header(&self, header: &Value) -> Option<Header> {
        Header::of_attributes(header)
    }

    fn initial_files(&self) -> Result<Vec<StoreFile>, StoreError> {
        Ok(Vec::new())
    }

    fn paths(&self, chunk: usize) -> Vec<PathBuf> {
        vec![self.path(chunk)]
    }

    fn encode(
        &self,
        chunk: usize,
        points: &[Setup],
        columns: &Columns,
    ) -> Result<Vec<StoreFile>, StoreError> {
        let path = self.path(chunk);
        let name = path.to_string_lossy().into_owned();
        let level = ZstdLevel::try_new(3).map_err(StoreError::encoding(&name))?;
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
            .map_err(StoreError::encoding(&name))?;
        writer.write(&self.batch(points, columns)?).map_err(StoreError::encoding(&name))?;
        let bytes = writer.into_inner().map_err(StoreError::encoding(&name))?;
        Ok(vec![(path, bytes)])
    }

    fn read(&self, root: &Path, chunk: usize) -> Result<Option<Columns>, StoreError> {
        read_part(&root.join(self.path(chunk)))
    }
}
