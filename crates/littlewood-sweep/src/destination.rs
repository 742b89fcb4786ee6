//! Where the results of a run go: a store, or a file that a store becomes once it is complete.

use std::path::{Path, PathBuf};

use crate::columns::Columns;
use crate::compute::Workers;
use crate::disk::{Disk, PARTS, with_ending};
use crate::options::Options;
#[cfg(feature = "parquet")]
use crate::parquet::{OneFile, Table};
use crate::store::{Format, Store, StoreError, StoreFile, WrittenChunk};
use crate::tally::Tally;

/// What the results of a run are written to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Target<'a> {
    /// A Zarr v3 store, for grids.
    Zarr(&'a Path),
    /// One Parquet file. Until the run is complete, finished chunks are in the folder `NAME.parts`
    /// beside it, which is read as [`Target::ParquetFolder`] is.
    Parquet(&'a Path),
    /// A folder with a Parquet file for each chunk, which readers take as one table.
    ParquetFolder(&'a Path),
}

impl Target<'_> {
    /// What can be read: of one file, until it is complete, the folder of its finished chunks.
    pub fn readable(self, complete: bool) -> PathBuf {
        match self {
            Self::Parquet(path) if !complete => with_ending(path, PARTS),
            Self::Zarr(path) | Self::Parquet(path) | Self::ParquetFolder(path) => path.to_owned(),
        }
    }
}

pub(crate) enum Destination {
    Store {
        root: PathBuf,
        format: Box<dyn Format>,
    },
    #[cfg(feature = "parquet")]
    File(OneFile),
}

impl Destination {
    pub(crate) fn store(root: &Path, format: impl Format + 'static) -> Self {
        Self::Store {
            root: root.to_owned(),
            format: Box::new(format),
        }
    }

    #[cfg(feature = "parquet")]
    pub(crate) fn file(path: &Path, table: Table) -> Self {
        Self::File(OneFile::new(path, table))
    }

    pub(crate) fn format(&self) -> &dyn Format {
        match self {
            Self::Store { format, .. } => format.as_ref(),
            #[cfg(feature = "parquet")]
            Self::File(file) => file.table(),
        }
    }

    /// Finds out whether the run may begin or be resumed. Writes nothing.
    pub(crate) fn inspect(&self, resume: bool) -> Result<(), StoreError> {
        match self {
            Self::Store { root, format } => Store::inspect(root, format.as_ref(), resume),
            #[cfg(feature = "parquet")]
            Self::File(file) => match file.inspect()? {
                Some(_) if !resume => Err(StoreError::Exists {
                    path: file.path().to_owned(),
                    complete: true,
                }),
                Some(_) => Ok(()),
                None => Store::inspect(file.parts(), file.table(), resume),
            },
        }
    }

    pub(crate) fn open<'a>(
        &'a self,
        count: usize,
        options: &Options<'a>,
        workers: &Workers,
    ) -> Result<OpenDestination<'a>, StoreError> {
        let disk = options.disk;
        let open = |root| Store::open(root, self.format(), count, options.resume, disk, workers);
        let state = match self {
            Self::Store { root, .. } => State::Open(open(root)?),
            #[cfg(feature = "parquet")]
            Self::File(file) => match file.inspect()? {
                Some(tally) => {
                    // A run may have been killed between its last two steps.
                    file.remove_parts()?;
                    State::Done(tally)
                }
                None => State::Open(open(file.parts())?),
            },
        };
        Ok(OpenDestination {
            destination: self,
            state,
            disk,
            count,
        })
    }
}

pub(crate) struct OpenDestination<'a> {
    destination: &'a Destination,
    state: State<'a>,
    disk: &'a dyn Disk,
    count: usize,
}

enum State<'a> {
    Open(Store<'a>),
    /// An earlier run has completed it.
    Done(Tally),
}

impl OpenDestination<'_> {
    pub(crate) fn has(&self, chunk: usize) -> bool {
        match &self.state {
            State::Open(store) => store.has(chunk),
            State::Done(_) => true,
        }
    }

    pub(crate) fn tally(&self, chunks: &[usize]) -> Option<Tally> {
        match &self.state {
            State::Open(store) => Some(store.tally(chunks)),
            State::Done(tally) => (chunks.len() == self.count).then_some(*tally),
        }
    }

    pub(crate) const fn damaged_chunks(&self) -> usize {
        match &self.state {
            State::Open(store) => store.damaged_chunks(),
            State::Done(_) => 0,
        }
    }

    pub(crate) fn read(&self, chunk: usize) -> Result<Columns, StoreError> {
        let (path, columns) = match (&self.state, self.destination) {
            #[cfg(feature = "parquet")]
            (State::Done(_), Destination::File(file)) => (file.path(), file.read(chunk)?),
            #[cfg(feature = "parquet")]
            (_, Destination::File(file)) => (file.parts(), file.table().read(file.parts(), chunk)?),
            (_, Destination::Store { root, format }) => (root.as_path(), format.read(root, chunk)?),
        };
        columns.ok_or_else(|| StoreError::DamagedChunk {
            path: path.to_owned(),
            reason: format!("chunk {chunk} was removed while it was read"),
        })
    }

    pub(crate) fn add(
        &mut self,
        chunk: WrittenChunk,
        files: &[StoreFile],
    ) -> Result<(), StoreError> {
        match &mut self.state {
            State::Open(store) => store.add(chunk, files),
            State::Done(_) => Ok(()),
        }
    }

    /// Completes it once all chunks are there; `tally` are the points of the run.
    pub(crate) fn complete(self, tally: Tally) -> Result<(), StoreError> {
        let State::Open(store) = self.state else {
            return Ok(());
        };
        store.complete()?;
        #[cfg(feature = "parquet")]
        if let Destination::File(file) = self.destination {
            file.join(self.count, tally, self.disk)?;
            file.remove_parts()?;
        }
        Ok(())
    }
}
