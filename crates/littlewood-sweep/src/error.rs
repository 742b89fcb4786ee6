//! What stops a sweep.

use std::path::PathBuf;

use littlewood::ParameterError;
use thiserror::Error;

use crate::axis::AxisError;
use crate::compute::ThreadsError;
use crate::picture::PictureError;
use crate::starts::ListError;
use crate::store::StoreError;

/// What stops a sweep.
#[derive(Debug, Error)]
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
    /// A list has no place in a Zarr store, whose points stand on axes.
    #[error("{}: a list of starts does not fit a Zarr store", path.display())]
    ListAsZarr {
        /// The target.
        path: PathBuf,
    },
    /// The format of a target is not in this build.
    #[error("{}: this program was built without the feature `{feature}`", path.display())]
    NotBuilt {
        /// The target.
        path: PathBuf,
        /// The feature of this crate that has the format.
        feature: &'static str,
    },
    /// The threads.
    #[error(transparent)]
    Threads(#[from] ThreadsError),
}
