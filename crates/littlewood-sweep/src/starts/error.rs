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
#[expect(missing_docs, reason = "the message of each says what its fields are")]
pub enum ListError {
    /// The file cannot be read.
    #[error("cannot read {}: {source}", path.display())]
    Unreadable { path: PathBuf, source: io::Error },
    /// A name that does not end in `.csv`.
    #[error("{}: a list of starts ends in .csv", path.display())]
    UnknownFormat { path: PathBuf },
    /// A header that is not a quantity of a hoop or a start.
    #[error("{}: there is no quantity {column:?}; columns are {}", path.display(), names(&quantities().collect::<Vec<_>>()))]
    UnknownColumn { path: PathBuf, column: String },
    /// A header that is there twice.
    #[error("{}: column {column} is there twice", path.display())]
    DuplicateColumn { path: PathBuf, column: Quantity },
    /// No columns, or no rows.
    #[error("{}: no starts in it", path.display())]
    Empty { path: PathBuf },
    /// A row with too many or too few cells, or bytes that are not text.
    #[error("{}, line {line}: {reason}", path.display())]
    BadLine { path: PathBuf, line: u64, reason: String },
    /// A cell that is not a finite number.
    #[error("{}, line {line}, column {column}: {cell:?} is not a finite number", path.display())]
    BadCell { path: PathBuf, line: u64, column: Quantity, cell: String },
    /// A cell whose value has no physical meaning.
    #[error("{}, line {line}, column {column}: {source}", path.display())]
    BadValue { path: PathBuf, line: u64, column: Quantity, source: ParameterError },
    /// A value that the list has no column for has no physical meaning.
    #[error("fixed {column}: {source}")]
    Fixed { column: Quantity, source: ParameterError },
    /// The file is not the one that was opened.
    #[error("{} has changed while it was read", path.display())]
    Changed { path: PathBuf },
}

/// An error of the operating system at a path.
pub(super) fn unreadable(path: &Path) -> impl Fn(io::Error) -> ListError + '_ {
    |source| ListError::Unreadable { path: path.to_owned(), source }
}
