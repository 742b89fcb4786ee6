//! The layout of a store: which arrays it has, in which chunks, and what its metadata say.

use std::path::{Path, PathBuf};

use littlewood::tables::{DerivativeColumn, Setup, SummaryValue};
use rayon::prelude::*;
use serde_json::{Value, json};

use super::array::{Array, from_bytes, to_bytes};
use crate::attributes::{Attributes, CONVENTIONS, of_axis, of_column};
use crate::axis::Axis;
use crate::chunk::{Chunk, Chunks};
use crate::columns::{Column, Columns};
use crate::description::{Description, STORE_FORMAT};
use crate::file::read_file;
use crate::grid::Grid;
use crate::store::{Format, Header, Names, StoreError, StoreFile};

pub(super) const METADATA: &str = "zarr.json";

/// The manifest and the lock are in the folder of an array: readers that list the members of the
/// group would complain of files there.
const NAMES: Names = Names {
    header: METADATA,
    manifest: "outcome/_chunks.txt",
    lock: "outcome/_lock",
};

#[derive(Debug)]
pub(crate) struct Layout {
    pub(super) chunks: Chunks,
    description: Description,
    coordinates: Vec<(Axis, Array)>,
    /// In the order of [`Column::all`].
    variables: Vec<(Column, Array)>,
    derivatives: Vec<DerivativeColumn>,
}

impl Layout {
    /// Values of an axis at most: they are one chunk, of 34 MB.
    pub(crate) const MOST_COORDINATES: usize = 1 << 22;

    pub(crate) fn new(grid: &Grid, chunks: Chunks, description: Description) -> Self {
        let names: Vec<&'static str> = grid
            .axes()
            .iter()
            .map(|axis| axis.varies().name())
            .collect();
        let coordinate = |axis: &Axis| Array {
            name: axis.varies().name().to_owned(),
            shape: vec![axis.count()],
            // The whole axis is one chunk: it is read with the metadata, and small beside a column.
            chunk: vec![axis.count()],
            fill: SummaryValue::F64(f64::NAN),
            dimensions: vec![axis.varies().name()],
            attributes: of_axis(axis.varies()),
        };
        let variable = |column: Column| Array {
            name: column.to_string(),
            shape: grid.shape(),
            chunk: chunks.shape().to_vec(),
            fill: column.not_computed(),
            dimensions: names.clone(),
            attributes: of_column(column),
        };
        let coordinates = grid
            .axes()
            .iter()
            .map(|axis| (*axis, coordinate(axis)))
            .collect();
        let derivatives = grid.derivatives().to_vec();
        let variables = Column::all(&derivatives)
            .map(|column| (column, variable(column)))
            .collect();
        Self {
            chunks,
            description,
            coordinates,
            variables,
            derivatives,
        }
    }

    fn arrays(&self) -> impl Iterator<Item = &Array> {
        let coordinates = self.coordinates.iter().map(|(_, array)| array);
        coordinates.chain(self.variables.iter().map(|(_, array)| array))
    }

    /// What the metadata of a group say, if it is a store of this program.
    pub(super) fn header_of(metadata: &Value) -> Option<Header> {
        Header::of_attributes(metadata.get("attributes")?)
    }
}

fn pretty(what: &str, value: &impl serde::Serialize) -> Result<Vec<u8>, StoreError> {
    let mut text = serde_json::to_vec_pretty(value).map_err(StoreError::encoding(what))?;
    text.push(b'\n');
    Ok(text)
}

impl Format for Layout {
    fn description(&self) -> &Description {
        &self.description
    }

    fn names(&self) -> &'static Names {
        &NAMES
    }

    fn header(&self, complete: bool) -> Result<Vec<u8>, StoreError> {
        let arrays: Attributes = self
            .arrays()
            .map(|array| (array.name.clone(), array.metadata()))
            .collect();
        pretty(
            METADATA,
            &json!({
                "zarr_format": 3,
                "node_type": "group",
                "attributes": {
                    "Conventions": CONVENTIONS,
                    "title": "motions of a loaded hoop",
                    "program": Header::PROGRAM,
                    "format": STORE_FORMAT,
                    "status": Header::status(complete),
                    // Text, as other formats (netCDF) have no attributes with parts.
                    "run": self.description.0.to_string(),
                },
                "consolidated_metadata": {
                    "kind": "inline",
                    "must_understand": false,
                    "metadata": arrays,
                },
            }),
        )
    }

    fn read_header(&self, header: &Value) -> Option<Header> {
        Self::header_of(header)
    }

    fn initial_files(&self) -> Result<Vec<StoreFile>, StoreError> {
        let mut files = Vec::new();
        for array in self.arrays() {
            files.push((
                Path::new(&array.name).join(METADATA),
                pretty(&array.name, &array.metadata())?,
            ));
        }
        for (axis, array) in &self.coordinates {
            let values: Vec<u8> = axis.values().flat_map(f64::to_le_bytes).collect();
            files.push((PathBuf::from(array.path(&[0])), array.encode(&values)?));
        }
        Ok(files)
    }

    fn paths(&self, chunk: usize) -> Vec<PathBuf> {
        let place = self.chunks.chunk(chunk).place;
        self.variables
            .iter()
            .map(|(_, array)| PathBuf::from(array.path(&place)))
            .collect()
    }

    fn encode(
        &self,
        chunk: usize,
        _: &[Setup],
        columns: &Columns,
    ) -> Result<Vec<StoreFile>, StoreError> {
        let full = self.chunks.shape();
        let size: usize = full.iter().product();
        let places = places_in_full_chunk(self.chunks.chunk(chunk), full);
        let files: Vec<Result<Vec<u8>, StoreError>> = self
            .variables
            .iter()
            .zip(columns.columns())
            .collect::<Vec<_>>()
            .into_par_iter()
            .map(|((column, array), (_, values))| {
                array.encode(&to_bytes(*column, values, &places, size))
            })
            .collect();
        self.paths(chunk)
            .into_iter()
            .zip(files)
            .map(|(path, bytes)| Ok((path, bytes?)))
            .collect()
    }

    fn read(&self, root: &Path, chunk: usize) -> Result<Option<Columns>, StoreError> {
        let full = self.chunks.shape();
        let places = places_in_full_chunk(self.chunks.chunk(chunk), full);
        let mut columns = Vec::with_capacity(self.variables.len());
        for ((column, array), path) in self.variables.iter().zip(self.paths(chunk)) {
            let path = root.join(path);
            let encoded = match read_file(&path, u64::MAX) {
                Ok(bytes) => bytes,
                Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
                Err(source) => return Err(StoreError::unreadable(&path, source)),
            };
            let bytes = array
                .decode(&encoded)
                .map_err(|reason| StoreError::DamagedChunk {
                    path: path.clone(),
                    reason,
                })?;
            columns.push(from_bytes(*column, &bytes, &places));
        }
        let damaged = |reason| StoreError::DamagedChunk {
            path: root.to_owned(),
            reason,
        };
        Columns::from_values(columns, &self.derivatives)
            .map(Some)
            .map_err(damaged)
    }
}

/// Where the points of a chunk, which may be cut off at the far end of an axis, stand in a chunk of
/// full size.
fn places_in_full_chunk(chunk: Chunk, full: &[usize]) -> Vec<usize> {
    let alone = Chunk {
        origin: vec![0; full.len()],
        ..chunk
    };
    alone.places_in(full)
}
