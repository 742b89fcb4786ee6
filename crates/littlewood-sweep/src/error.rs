//! What stops a sweep.

use std::path::PathBuf;

use littlewood::ParameterError;
use thiserror::Error;

use crate::axis::{AxisError, Varies};
use crate::compute::ThreadsError;
use crate::options::MOST_CHUNKS;
use crate::picture::PictureError;
use crate::starts::ListError;
use crate::store::StoreError;

/// What stops a sweep.
#[derive(Debug, Error)]
#[expect(missing_docs, reason = "the message of each says what its fields are")]
pub enum SweepError {
    /// The axes.
    #[error(transparent)]
    Axis(#[from] AxisError),
    /// A start or a limit.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    /// The list of starts.
    #[error(transparent)]
    List(#[from] ListError),
    /// The files.
    #[error(transparent)]
    Store(#[from] StoreError),
    /// The picture.
    #[error(transparent)]
    Picture(#[from] PictureError),
    /// More chunks than [`MOST_CHUNKS`].
    #[error(
        "{points} starts in chunks of {chunk} at most are {chunks} chunks; a run has at most {MOST_CHUNKS}"
    )]
    TooManyChunks { points: u64, chunk: usize, chunks: usize },
    /// More values than the coordinates of a Zarr store can have.
    #[error(
        "axis {axis}: {count} points; an axis of a Zarr store has at most {most}, for its coordinates are one chunk"
    )]
    LongAxis { axis: Varies, count: usize, most: usize },
    /// A list has no place in a Zarr store, whose points stand on axes.
    #[error("{}: a list of starts does not fit a Zarr store", path.display())]
    ListAsZarr { path: PathBuf },
    /// The format of a target is not in this build.
    #[error("{}: this program was built without the feature `{feature}`", path.display())]
    NotBuilt { path: PathBuf, feature: &'static str },
    /// The threads.
    #[error(transparent)]
    Threads(#[from] ThreadsError),
}
