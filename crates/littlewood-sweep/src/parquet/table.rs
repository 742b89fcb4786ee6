//! A table in files: its schema, and a chunk of it as a Parquet file.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use arrow_schema::{Field, Schema};
use littlewood::tables::{ColumnType, DerivativeColumn, Quantity, Setup};
use parquet::arrow::{ARROW_SCHEMA_META_KEY, ArrowSchemaConverter, encode_arrow_schema};
use parquet::basic::{Compression, ZstdLevel};
use parquet::errors::Result as Encoded;
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::ColumnPath;
use serde_json::{Value, json};

use super::column::{Writer, of_quantity, of_results};
use super::read::read_part;
use crate::columns::{Column as Results, Columns};
use crate::description::{Description, STORE_FORMAT};
use crate::disk::UNFINISHED;
use crate::grid::Grid;
use crate::setup::places;
use crate::starts::StartList;
use crate::store::{Format, Header, Names, StoreError, StoreFile};

const NAMES: Names = Names {
    header: "_run.json",
    manifest: "_chunks.txt",
    lock: "_lock",
};

pub(super) const RUN_KEY: &str = "littlewood_run";

pub(super) const CHUNK_KEY: &str = "littlewood_chunk";

pub(crate) struct Table {
    description: Description,
    /// The columns as Arrow describes them. Parquet has no place for their attributes: Arrow's
    /// readers find this description in the footer.
    schema: Schema,
    digits: usize,
    quantities: Vec<Quantity>,
    pub(super) derivatives: Vec<DerivativeColumn>,
}

impl Table {
    /// The table of a grid. The rows stand chunk by chunk (see [`crate::Chunks`]), each with the
    /// quantities of its point.
    pub(crate) fn of_grid(description: &Description, chunks: usize, grid: &Grid) -> Self {
        let quantities = of_points(grid.base(), |quantity| grid.axis(quantity).is_some());
        Self::new(
            description.clone(),
            chunks,
            quantities,
            grid.derivatives().to_vec(),
        )
    }

    /// The table of a list, one row a start in the order of the list. Where and when the start is
    /// has a column if the list has one.
    pub(crate) fn of_list(description: &Description, chunks: usize, list: &StartList) -> Self {
        let has_column = |quantity| list.columns().contains(&quantity);
        let places = places().filter(|place| has_column(*place));
        let quantities = of_points(list.base(), has_column)
            .into_iter()
            .chain(places)
            .collect();
        Self::new(
            description.clone(),
            chunks,
            quantities,
            list.derivatives().to_vec(),
        )
    }

    fn new(
        description: Description,
        chunks: usize,
        quantities: Vec<Quantity>,
        derivatives: Vec<DerivativeColumn>,
    ) -> Self {
        let digits = chunks.saturating_sub(1).to_string().len().max(5);
        let of_points = quantities.iter().copied().map(of_quantity);
        let results = Results::all(&derivatives).flat_map(of_results);
        let schema = Schema::new(of_points.chain(results).collect::<Vec<Field>>());
        Self {
            description,
            schema,
            digits,
            quantities,
            derivatives,
        }
    }

    fn file(&self, chunk: usize, points: &[Setup], columns: &Columns) -> Encoded<Vec<u8>> {
        let entry = |key: &str, value: String| KeyValue::new(key.to_owned(), value);
        let mut properties = WriterProperties::builder()
            .set_compression(Compression::ZSTD(ZstdLevel::try_new(3)?))
            .set_created_by(concat!("littlewood-sweep ", env!("CARGO_PKG_VERSION")).to_owned())
            .set_key_value_metadata(Some(vec![
                entry(RUN_KEY, self.description.0.to_string()),
                entry(CHUNK_KEY, chunk.to_string()),
                entry(ARROW_SCHEMA_META_KEY, encode_arrow_schema(&self.schema)),
            ]));
        for column in Results::all(&self.derivatives) {
            if column.column_type() == ColumnType::Real {
                // The numbers of motions hardly repeat: a dictionary of them is made for nothing.
                let path = ColumnPath::from(column.to_string());
                properties = properties.set_column_dictionary_enabled(path, false);
            }
        }
        let schema = ArrowSchemaConverter::new().convert(&self.schema)?;
        let root = schema.root_schema_ptr();
        let mut file = SerializedFileWriter::new(Vec::new(), root, Arc::new(properties.build()))?;
        let mut group = file.next_row_group()?;
        let mut writer = Writer(&mut group);
        for &quantity in &self.quantities {
            let values: Vec<f64> = points
                .iter()
                .map(|point| point.get(quantity).unwrap_or(f64::NAN))
                .collect();
            writer.reals(&values)?;
        }
        for (column, values) in columns.columns() {
            writer.results(column, values)?;
        }
        group.close()?;
        file.into_inner()
    }

    pub(super) fn path(&self, chunk: usize) -> PathBuf {
        PathBuf::from(format!(
            "part-{chunk:0digits$}.parquet",
            digits = self.digits
        ))
    }

    /// Whether a run makes a file of this name in the folder of a table.
    pub(super) fn makes_file(&self, name: &str) -> bool {
        let name = name.strip_suffix(UNFINISHED).unwrap_or(name);
        let part = |name: &str| -> Option<bool> {
            let digits = name.strip_prefix("part-")?.strip_suffix(".parquet")?;
            Some(digits.len() == self.digits && digits.bytes().all(|byte| byte.is_ascii_digit()))
        };
        [NAMES.header, NAMES.manifest, NAMES.lock].contains(&name) || part(name) == Some(true)
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

    fn names(&self) -> &'static Names {
        &NAMES
    }

    fn header(&self, complete: bool) -> Result<Vec<u8>, StoreError> {
        let mut text = serde_json::to_vec_pretty(&json!({
            "program": Header::PROGRAM,
            "format": STORE_FORMAT,
            "status": Header::status(complete),
            "run": self.description.0,
        }))
        .map_err(StoreError::encoding(NAMES.header))?;
        text.push(b'\n');
        Ok(text)
    }

    fn read_header(&self, header: &Value) -> Option<Header> {
        Header::of_attributes(header)
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
        let bytes = self
            .file(chunk, points, columns)
            .map_err(StoreError::encoding(&name))?;
        Ok(vec![(path, bytes)])
    }

    fn read(&self, root: &Path, chunk: usize) -> Result<Option<Columns>, StoreError> {
        read_part(&root.join(self.path(chunk)), &self.derivatives)
    }
}
