//! What is wrong with a store, or with writing to it.

use std::io;
use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::description::ForeignVersion;

/// What is wrong with a store, or with writing to it.
#[derive(Debug, Error)]
#[expect(
    missing_docs,
    reason = "the message of each says what it and its fields are"
)]
pub enum StoreError {
    /// A file or folder cannot be written: a full disk, a folder without permission, a name that is
    /// taken. The chunks of `finished` points are on disk, and stay readable.
    #[error("cannot write {}: {source}{}", path.display(), stay_readable(*finished))]
    Unwritable {
        path: PathBuf,
        source: io::Error,
        finished: u64,
    },
    #[error("cannot read {}: {source}", path.display())]
    Unreadable { path: PathBuf, source: io::Error },
    #[error("{} exists and is not the result of a sweep; it is left as it is", path.display())]
    NotAStore { path: PathBuf },
    #[error(
        "{} has {} {}{}, this program reads and writes {}; it is left as it is: choose another name and compute it \
         again, or read it with the program that made it",
        path.display(), version.what, version.found, made_by(version), version.needed
    )]
    OtherFormat {
        path: PathBuf,
        version: ForeignVersion,
    },
    #[error("{} exists ({}); resume it, or choose another name", path.display(), if *complete { "complete" } else { "partial" })]
    Exists { path: PathBuf, complete: bool },
    #[error("{} was made by other parameters ({}); it is left as it is", path.display(), differences.join("; "))]
    OtherParameters {
        path: PathBuf,
        differences: Vec<String>,
    },
    #[error("another process is writing to {}", path.display())]
    Locked { path: PathBuf },
    #[error("{}, line {line}: the list of finished chunks is damaged; remove the store and run again", path.display())]
    DamagedManifest { path: PathBuf, line: usize },
    #[error("{}: damaged metadata: {reason}", path.display())]
    DamagedMetadata { path: PathBuf, reason: String },
    #[error("{}: damaged chunk: {reason}", path.display())]
    DamagedChunk { path: PathBuf, reason: String },
    /// Data cannot be put into the format. No input is known that does this.
    #[error("cannot encode {what}: {reason}")]
    Encoding { what: String, reason: String },
}

impl StoreError {
    pub(crate) fn unwritable(path: &Path, source: io::Error) -> Self {
        Self::Unwritable {
            path: path.to_owned(),
            source,
            finished: 0,
        }
    }

    pub(crate) fn unreadable(path: &Path, source: io::Error) -> Self {
        Self::Unreadable {
            path: path.to_owned(),
            source,
        }
    }

    pub(crate) fn encoding<E: core::fmt::Display>(what: &str) -> impl Fn(E) -> Self + '_ {
        move |error| Self::Encoding {
            what: what.to_owned(),
            reason: error.to_string(),
        }
    }

    /// The same error, which says how many points stay readable.
    pub(crate) fn with_finished(self, finished: u64) -> Self {
        match self {
            Self::Unwritable { path, source, .. } => Self::Unwritable {
                path,
                source,
                finished,
            },
            other => other,
        }
    }
}

fn stay_readable(finished: u64) -> String {
    match finished {
        0 => String::new(),
        1 => "; the point that is finished stays readable".to_owned(),
        _ => format!("; the {finished} points that are finished stay readable"),
    }
}

fn made_by(version: &ForeignVersion) -> String {
    version
        .program
        .as_ref()
        .map_or_else(String::new, |program| {
            format!(" (of littlewood-sweep {program})")
        })
}
