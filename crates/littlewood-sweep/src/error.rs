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
#[expect(
    missing_docs,
    reason = "the message of each says what it and its fields are"
)]
pub enum SweepError {
    #[error(transparent)]
    Axis(#[from] AxisError),
    #[error(transparent)]
    Parameter(#[from] ParameterError),
    #[error(transparent)]
    List(#[from] ListError),
    #[error(transparent)]
    Store(#[from] StoreError),
    #[error(transparent)]
    Picture(#[from] PictureError),
    #[error(
        "{points} starts in chunks of {chunk} at most are {chunks} chunks; a run has at most {MOST_CHUNKS}"
    )]
    TooManyChunks {
        points: u64,
        chunk: usize,
        chunks: usize,
    },
    #[error(
        "axis {axis}: {count} points; an axis of a Zarr store has at most {most}, for its coordinates are one chunk"
    )]
    LongAxis {
        axis: Varies,
        count: usize,
        most: usize,
    },
    #[error("{}: a list of starts does not fit a Zarr store", path.display())]
    ListAsZarr { path: PathBuf },
    #[error("{}: this program was built without the feature `{feature}`", path.display())]
    NotBuilt {
        path: PathBuf,
        feature: &'static str,
    },
    #[error(transparent)]
    Threads(#[from] ThreadsError),
}
