//! How to run: resuming, size of chunks, cancelling, progress, and the disk.

use core::sync::atomic::AtomicBool;

use crate::disk::{Disk, FileSystem};

/// Points of a chunk, unless another number is asked for.
pub const CHUNK_POINTS: usize = 65_536;

/// Largest number of points of a chunk. Two chunks are computed while two are written, at some
/// hundred bytes a point: a gigabyte at most.
pub const MOST_CHUNK_POINTS: usize = 1 << 20;

/// Largest number of chunks of a run. What is known of each is in memory, about 150 bytes: 40 MB at
/// most.
pub const MOST_CHUNKS: usize = 1 << 18;

/// How to run.
#[expect(
    missing_debug_implementations,
    reason = "a disk and functions are among them"
)]
pub struct Options<'a> {
    /// Go on with a store that is there, if the parameters are the same.
    pub resume: bool,
    /// Largest number of points of a chunk, from 1 to [`MOST_CHUNK_POINTS`].
    pub chunk_points: usize,
    /// When it becomes true the run ends after the motions that are being followed, with a partial
    /// store: chunks that are finished are kept, those in work are not.
    pub cancel: Option<&'a AtomicBool>,
    /// Called, from any thread, whenever motions have been followed and whenever a chunk has been
    /// finished.
    pub progress: Option<&'a (dyn Fn(Progress) + Sync)>,
    /// Where files are written.
    pub disk: &'a dyn Disk,
}

/// How far a run is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Points that have been followed, including those of chunks in work.
    pub followed: u64,
    /// Points whose chunks are on disk, including those of an earlier run.
    pub done: u64,
    /// Points of them that an earlier run has computed.
    pub reused: u64,
    /// All points.
    pub total: u64,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self {
            resume: false,
            chunk_points: CHUNK_POINTS,
            cancel: None,
            progress: None,
            disk: &FileSystem,
        }
    }
}
