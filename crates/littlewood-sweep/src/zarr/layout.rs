//! The layout of a store: which arrays it has, in which chunks, and what its metadata say.

use std::path::{Path, PathBuf};

use littlewood::{Setup, SummaryColumn};
use rayon::prelude::*;
use serde_json::{Value, json};
use zarrs::array::data_type;

use super::array::{MemoryArray, array, decode, encode, metadata, widths};
use super::variable;
use crate::attributes::{Attributes, CONVENTIONS, of_column, of_quantity};
use crate::axis::Axis;
use crate::chunk::{Chunk, Chunks};
use crate::columns::Columns;
use crate::description::{Description, STORE_FORMAT};
use crate::grid::Grid;
use crate::store::{Format, Header, StoreError, StoreFile};

pub(super) const METADATA: &str = "zarr.json";

/// The arrays of a store.
pub(crate) struct Layout {
    pub(super) chunks: Chunks,
    description: Description,
    coordinates: Vec<(Axis, MemoryArray)>,
    /// In the order of [`SummaryColumn::ALL`].
    variables: Vec<(SummaryColumn, MemoryArray)>,
}

impl core::fmt::Debug for Layout {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Layout").field("chunks", &self.chunks).finish_non_exhaustive()
    }
}

impl Layout {
    pub(crate) fn new(grid: &Grid, chunks: Chunks, description: Description) -> Result<Self, StoreError> {
        let names: Vec<&str> = grid.axes().iter().map(|axis| axis.quantity().name()).collect();
        let coordinates = grid
            .axes()
            .iter()
            .map(|axis| {
                let name = axis.quantity().name();
                let attributes = of_quantity(axis.quantity());
                let shape = [axis.count()];
                // The whole axis is one chunk: it is read with the metadata, and small beside a column.
                array(name, &shape, &shape, data_type::float64(), f64::NAN.into(), &[name], attributes)
                    .map(|array| (*axis, array))
            })
            .collect::<Result<_, _>>()?;
        let shape = grid.shape();
        let variables = SummaryColumn::ALL
            .into_iter()
            .map(|column| {
                array(
                    column.name(),
                    &shape,
                    chunks.shape(),
                    variable::data_type(column),
                    variable::fill_value(column),
                    &names,
                    of_column(column),
                )
                .map(|array| (column, array))
            })
            .collect::<Result<_, _>>()?;
        Ok(Self { chunks, description, coordinates, variables })
    }

    fn arrays(&self) -> impl Iterator<Item = (&'static str, &MemoryArray)> {
        let coordinates = self.coordinates.iter().map(|(axis, array)| (axis.quantity().name(), array));
        coordinates.chain(self.variables.iter().map(|(column, array)| (column.name(), array)))
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

    fn header_path(&self) -> &'static str {
        METADATA
    }

    // The manifest and the lock are in the folder of an array: readers that list the members of the group would
    // complain of files there.
    fn manifest_path(&self) -> &'static str {
        "outcome/_chunks.txt"
    }

    fn lock_path(&self) -> &'static str {
        "outcome/_lock"
    }

    fn header(&self, complete: bool) -> Result<Vec<u8>, StoreError> {
        let arrays = self
            .arrays()
            .map(|(name, array)| {
                Ok((
                    name.to_owned(),
                    serde_json::to_value(metadata(array)).map_err(StoreError::encoding(name))?,
                ))
            })
            .collect::<Result<Attributes, StoreError>>()?;
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
                    "run": self.description.0,
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
        for (name, array) in self.arrays() {
            files.push((Path::new(name).join(METADATA), pretty(name, &metadata(array))?));
        }
        for (axis, array) in &self.coordinates {
            let name = axis.quantity().name();
            let bytes = axis.values().flat_map(f64::to_le_bytes).collect();
            files.push((
                PathBuf::from(array.chunk_key(&[0]).as_str()),
                encode(name, array, &[axis.count()], bytes)?,
            ));
        }
        Ok(files)
    }

    fn paths(&self, chunk: usize) -> Vec<PathBuf> {
        let place = widths(&self.chunks.chunk(chunk).place);
        self.variables.iter().map(|(_, array)| PathBuf::from(array.chunk_key(&place).as_str())).collect()
    }

    fn encode(&self, chunk: usize, _: &[Setup], columns: &Columns) -> Result<Vec<StoreFile>, StoreError> {
        let full = self.chunks.shape();
        let size: usize = full.iter().product();
        let places = places_in_full_chunk(&self.chunks.chunk(chunk), full);
        let files: Vec<Result<Vec<u8>, StoreError>> = self
            .variables
            .par_iter()
            .map(|(column, array)| {
                let bytes = variable::to_bytes(*column, columns.column(*column), &places, size);
                encode(column.name(), array, full, bytes)
            })
            .collect();
        self.paths(chunk).into_iter().zip(files).map(|(path, bytes)| Ok((path, bytes?))).collect()
    }

    fn read(&self, root: &Path, chunk: usize) -> Result<Option<Columns>, StoreError> {
        let full = self.chunks.shape();
        let places = places_in_full_chunk(&self.chunks.chunk(chunk), full);
        let mut columns = Vec::with_capacity(self.variables.len());
        for ((column, array), path) in self.variables.iter().zip(self.paths(chunk)) {
            let path = root.join(path);
            let encoded = match std::fs::read(&path) {
                Ok(bytes) => bytes,
                Err(error) if error.kind() == std::io::ErrorKind::NotFound => return Ok(None),
                Err(source) => return Err(StoreError::unreadable(&path, source)),
            };
            let bytes = decode(array, full, encoded)
                .map_err(|reason| StoreError::DamagedChunk { path: path.clone(), reason })?;
            columns.push(variable::from_bytes(*column, &bytes, &places));
        }
        let damaged = |reason| StoreError::DamagedChunk { path: root.to_owned(), reason };
        Columns::from_values(columns).map(Some).map_err(damaged)
    }
}

/// Where the points of a chunk, which may be cut off at the far end of an axis, stand in a chunk of full size.
fn places_in_full_chunk(chunk: &Chunk, full: &[usize]) -> Vec<usize> {
    (0..chunk.len())
        .map(|number| {
            let (mut rest, mut place, mut stride) = (number, 0, 1);
            for (size, full) in chunk.shape.iter().zip(full).rev() {
                place += rest % size * stride;
                rest /= size;
                stride *= full;
            }
            place
        })
        .collect()
}
