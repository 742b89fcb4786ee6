//! A store for reading.

use std::path::{Path, PathBuf};

use littlewood::Limits;
use serde_json::Value;

use super::layout::{Layout, METADATA};
use crate::chunk::Chunks;
use crate::columns::Columns;
use crate::description::Description;
use crate::file::read_file;
use crate::getters::getters;
use crate::grid::Grid;
use crate::store::{Format as _, Header, StoreError, broken_chunks};

/// A Zarr store of a grid, for reading.
#[derive(Debug)]
pub struct ZarrStore {
    root: PathBuf,
    grid: Grid,
    limits: Limits,
    complete: bool,
    layout: Layout,
}

getters! {
    ZarrStore:
    /// The grid.
    grid(self) -> &Grid = &self.grid;
    /// The limits of the motions.
    limits(self) -> Limits = self.limits;
    /// Whether all chunks are said to be there.
    is_complete(self) -> bool = self.complete;
    /// How the grid is cut into chunks.
    chunks(self) -> &Chunks = &self.layout.chunks;
}

impl ZarrStore {
    /// Opens a store that [`sweep_grid`](crate::sweep_grid) has made, complete or not.
    ///
    /// # Errors
    /// If there is none, if it is of another version of the format, or if its metadata cannot be
    /// understood.
    pub fn open(path: &Path) -> Result<Self, StoreError> {
        let file = path.join(METADATA);
        let bytes =
            read_file(&file, u64::MAX).map_err(|source| StoreError::unreadable(&file, source))?;
        let metadata: Value =
            serde_json::from_slice(&bytes).map_err(|error| StoreError::DamagedMetadata {
                path: file.clone(),
                reason: error.to_string(),
            })?;
        let header = Layout::header_of(&metadata).ok_or_else(|| StoreError::NotAStore {
            path: path.to_owned(),
        })?;
        header.check_versions(path)?;
        let Header { run, complete, .. } = header;
        let (grid, limits, shape) =
            Description::grid(&run).ok_or_else(|| StoreError::DamagedMetadata {
                path: file,
                reason: "the attribute \"run\" does not describe a grid".to_owned(),
            })?;
        let chunks = Chunks::of_shape(&grid, shape);
        let layout = Layout::new(&grid, chunks, Description(run));
        Ok(Self {
            root: path.to_owned(),
            grid,
            limits,
            complete,
            layout,
        })
    }

    /// The numbers of chunks that are missing, or whose files do not have the checksum that was
    /// noted.
    ///
    /// # Errors
    /// If the list of finished chunks is damaged.
    pub fn broken_chunks(&self) -> Result<Vec<usize>, StoreError> {
        Ok(
            broken_chunks(&self.root, &self.layout, self.layout.chunks.count())?
                .into_iter()
                .collect(),
        )
    }

    /// The results of a chunk, in the order of its points; none if it has not been computed.
    ///
    /// # Errors
    /// If a file of it cannot be read or decoded.
    pub fn columns(&self, number: usize) -> Result<Option<Columns>, StoreError> {
        self.layout.read(&self.root, number)
    }
}
