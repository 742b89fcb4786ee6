//! What a format of stores has to provide.

use std::path::{Path, PathBuf};

use littlewood::tables::Setup;
use serde_json::Value;

use super::error::StoreError;
use crate::columns::Columns;
use crate::description::{Description, ForeignVersion};

/// A file of a store: its path within the store, and its bytes.
pub(crate) type StoreFile = (PathBuf, Vec<u8>);

/// Content of the header of a store.
pub(crate) struct Header {
    /// The version of the format, if the header has one.
    pub(crate) format: Option<Value>,
    pub(crate) run: Value,
    pub(crate) complete: bool,
}

impl Header {
    pub(crate) const PROGRAM: &'static str = "littlewood-sweep";

    /// From the attributes in which a store describes itself; none if they are not of this program.
    pub(crate) fn of_attributes(attributes: &Value) -> Option<Self> {
        if attributes.get("program")?.as_str()? != Self::PROGRAM {
            return None;
        }
        let complete = attributes.get("status")?.as_str()? == Self::status(true);
        let run = match attributes.get("run")? {
            Value::String(text) => serde_json::from_str(text).ok()?,
            run => run.clone(),
        };
        Some(Self {
            format: attributes.get("format").cloned(),
            run,
            complete,
        })
    }

    pub(crate) const fn status(complete: bool) -> &'static str {
        if complete { "complete" } else { "partial" }
    }

    pub(crate) fn check_versions(&self, path: &Path) -> Result<(), StoreError> {
        match ForeignVersion::find(self.format.as_ref(), &self.run) {
            None => Ok(()),
            Some(version) => Err(StoreError::OtherFormat {
                path: path.to_owned(),
                version,
            }),
        }
    }
}

/// Files that a store has beside its chunks.
pub(crate) struct Names {
    /// Describes the run and says whether it is complete.
    pub(crate) header: &'static str,
    /// The list of finished chunks.
    pub(crate) manifest: &'static str,
    /// Empty; locked while a run writes.
    pub(crate) lock: &'static str,
}

pub(crate) trait Format: Sync {
    fn description(&self) -> &Description;
    fn names(&self) -> &'static Names;
    fn header(&self, complete: bool) -> Result<Vec<u8>, StoreError>;
    /// Its content; none if this program has not written it.
    fn read_header(&self, header: &Value) -> Option<Header>;
    /// Files that are written before the first chunk.
    fn initial_files(&self) -> Result<Vec<StoreFile>, StoreError> {
        Ok(Vec::new())
    }
    fn paths(&self, chunk: usize) -> Vec<PathBuf>;
    /// The files of a chunk, in the order of [`Format::paths`].
    fn encode(
        &self,
        chunk: usize,
        points: &[Setup],
        columns: &Columns,
    ) -> Result<Vec<StoreFile>, StoreError>;
    /// The results of a chunk again, from the store at a path; none if a file of it is missing.
    fn read(&self, root: &Path, chunk: usize) -> Result<Option<Columns>, StoreError>;
}
