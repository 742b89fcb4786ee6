//! What is wrong with a list of starts.

use std::io;
use std::path::{Path, PathBuf};

use littlewood::ParameterError;
use littlewood::tables::Quantity;
use thiserror::Error;

use crate::axis::names;
use crate::setup::quantities;

/// What is wrong with a list of starts. Lines are counted from 1.
#[derive(Debug, Error)]
#[expect(
    missing_docs,
    reason = "the message of each says what it and its fields are"
)]
pub enum ListError {
    #[error("cannot read {}: {source}", path.display())]
    Unreadable { path: PathBuf, source: io::Error },
    #[error("{}: a list of starts ends in .csv", path.display())]
    UnknownFormat { path: PathBuf },
    #[error("{}: there is no quantity {column:?}; columns are {}", path.display(), names(&quantities().collect::<Vec<_>>()))]
    UnknownColumn { path: PathBuf, column: String },
    #[error("{}: column {column} is there twice", path.display())]
    DuplicateColumn { path: PathBuf, column: Quantity },
    #[error("{}: no starts in it", path.display())]
    Empty { path: PathBuf },
    #[error("{}, line {line}: {reason}", path.display())]
    BadLine {
        path: PathBuf,
        line: u64,
        reason: String,
    },
    #[error("{}, line {line}, column {column}: {cell:?} is not a finite number", path.display())]
    BadCell {
        path: PathBuf,
        line: u64,
        column: Quantity,
        cell: String,
    },
    #[error("{}, line {line}, column {column}: {source}", path.display())]
    BadValue {
        path: PathBuf,
        line: u64,
        column: Quantity,
        source: ParameterError,
    },
    #[error("fixed {column}: {source}")]
    Fixed {
        column: Quantity,
        source: ParameterError,
    },
    #[error("{} has changed while it was read", path.display())]
    Changed { path: PathBuf },
}

/// An error of the operating system at a path.
pub(super) fn unreadable(path: &Path) -> impl Fn(io::Error) -> ListError + '_ {
    |source| ListError::Unreadable {
        path: path.to_owned(),
        source,
    }
}
