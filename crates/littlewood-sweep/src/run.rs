//! The driver: computes chunk after chunk, writes each as a whole, and goes on where it was stopped.

use core::sync::atomic::{AtomicBool, Ordering};
use std::path::{Path, PathBuf};

use littlewood::Limits;
use rayon::prelude::*;
use serde_json::Value;

use crate::columns::Columns;
use crate::compute::{Refused, Workers};
use crate::description::Description;
use crate::destination::{Destination, Place};
use crate::disk::{Disk, FileSystem};
use crate::error::{StoreError, SweepError};
use crate::outcome::Class;
use crate::point::Point;
use crate::tally::Tally;

/// Points of a chunk, unless another number is asked for.
pub const CHUNK_POINTS: usize = 65_536;

/// Chunks that are computed while those before them are written.
const BATCH: usize = 2;

/// How to run.
pub struct Options<'a> {
    /// Go on with a store that is there, if the parameters are the same.
    pub resume: bool,
    /// Largest number of points of a chunk.
    pub chunk_points: usize,
    /// When it becomes true the chunks in work are finished, and the run ends with a partial store.
    pub cancel: Option<&'a AtomicBool>,
    /// Told of every step forward.
    pub progress: Option<&'a (dyn Fn(Progress) + Sync)>,
    /// Where files go.
    pub disk: &'a dyn Disk,
}

impl Default for Options<'_> {
    fn default() -> Self {
        Self { resume: false, chunk_points: CHUNK_POINTS, cancel: None, progress: None, disk: &FileSystem }
    }
}

impl core::fmt::Debug for Options<'_> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        f.debug_struct("Options")
            .field("resume", &self.resume)
            .field("chunk_points", &self.chunk_points)
            .finish_non_exhaustive()
    }
}

/// How far a run is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Progress {
    /// Points whose chunks are on disk, those of an earlier run among them.
    pub done: u64,
    /// Points of them that an earlier run has computed.
    pub reused: u64,
    /// All points.
    pub total: u64,
}

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Report {
    /// All points.
    pub points: u64,
    /// Points that this run has computed.
    pub computed: u64,
    /// Points that an earlier run had computed.
    pub reused: u64,
    /// Chunks of an earlier run that were damaged or missing, and are computed again.
    pub damaged_chunks: usize,
    /// Whether all chunks are there. If not, the run was cancelled.
    pub complete: bool,
    /// Points of each class, those of an earlier run among them.
    pub tally: Tally,
}

/// A file of a store: its path within the store, and its bytes.
pub(crate) type StoreFile = (PathBuf, Vec<u8>);

/// Is shown the results of every chunk, in no particular order.
pub(crate) type View<'a> = &'a mut dyn FnMut(usize, &Columns);

/// Points in chunks.
pub(crate) trait Source {
    /// Number of points.
    fn total(&self) -> u64;
    /// Number of chunks.
    fn count(&self) -> usize;
    /// Number of points of a chunk.
    fn points_of(&self, chunk: usize) -> u64;
    /// The points of a chunk; chunks are asked for in rising order, some left out.
    fn points(&mut self, chunk: usize) -> Result<Vec<Point>, SweepError>;
    /// Turns the refusal of a point of a chunk into an error that says where it stands.
    fn refused(&self, chunk: usize, refused: Refused) -> SweepError;
}

/// A format of stores.
pub(crate) trait Format: Sync {
    /// What the run computes.
    fn description(&self) -> &Description;
    /// The file that describes the run and says whether it is complete.
    fn header_path(&self) -> &'static str;
    /// The list of finished chunks.
    fn manifest_path(&self) -> &'static str;
    /// An empty file that is locked while a run writes.
    fn lock_path(&self) -> &'static str;
    /// The header as a file.
    fn header(&self, complete: bool) -> Result<Vec<u8>, StoreError>;
    /// What it says: the description, and whether the store is complete.
    fn read_header(&self, header: &Value) -> Option<(Value, bool)>;
    /// Files that are there from the start.
    fn prelude(&self) -> Result<Vec<StoreFile>, StoreError>;
    /// Paths of the files of a chunk.
    fn paths(&self, chunk: usize) -> Vec<PathBuf>;
    /// The files of a chunk, in the order of [`Format::paths`].
    fn encode(&self, chunk: usize, points: &[Point], columns: &Columns)
    -> Result<Vec<StoreFile>, StoreError>;
    /// The results of a chunk again, from the store at a path; none if a file of it is missing.
    fn read(&self, root: &Path, chunk: usize) -> Result<Option<Columns>, StoreError>;
}

/// A chunk that is computed, and encoded for every place that has it not.
pub(crate) struct Finished {
    pub(crate) number: usize,
    pub(crate) points: u64,
    pub(crate) tally: Tally,
    /// One entry a place; none where the chunk is already.
    pub(crate) files: Vec<Option<Vec<StoreFile>>>,
}

/// Computes what is missing at any of the destinations, once for all of them.
pub(crate) fn run(
    source: &mut dyn Source,
    destinations: &[Destination],
    mut view: Option<View<'_>>,
    limits: Limits,
    workers: &Workers,
    options: &Options<'_>,
) -> Result<Report, SweepError> {
    // Nothing is written anywhere before all are known to be good.
    for destination in destinations {
        destination.inspect(options.resume)?;
    }
    let mut places = destinations
        .iter()
        .map(|destination| destination.open(source.count(), options, workers))
        .collect::<Result<Vec<Place<'_>>, StoreError>>()?;
    let (there, pending): (Vec<usize>, Vec<usize>) = (0..source.count())
        .partition(|&number| !places.is_empty() && places.iter().all(|place| place.has(number)));
    if let (Some(view), Some(place)) = (&mut view, places.first()) {
        for &number in &there {
            view(number, &place.read(number)?);
        }
    }
    // A file that is complete knows all its points, but not which are in which chunk; a store beside it does.
    let mut tally = places.iter().find_map(|place| place.tally(&there)).unwrap_or_default();
    let reused: u64 = there.iter().map(|&number| source.points_of(number)).sum();
    let mut progress = Progress { done: reused, reused, total: source.total() };
    let tell = |progress: Progress| {
        if let Some(callback) = options.progress {
            callback(progress);
        }
    };
    tell(progress);

    let cancelled = || options.cancel.is_some_and(|flag| flag.load(Ordering::Relaxed));
    let mut batches = pending.chunks(BATCH);
    let mut finished: Vec<Finished> = Vec::new();
    loop {
        // While one batch is written the next is computed. A cancelled run writes what it has computed.
        let batch = if cancelled() { &[][..] } else { batches.next().unwrap_or_default() };
        if batch.is_empty() && finished.is_empty() {
            break;
        }
        let inputs = batch
            .iter()
            .map(|&number| {
                let wanted = places.iter().map(|place| !place.has(number)).collect();
                Ok(Input { number, points: source.points(number)?, wanted })
            })
            .collect::<Result<Vec<_>, SweepError>>();
        let (inputs, source_error) = match inputs {
            Ok(inputs) => (inputs, None),
            Err(error) => (Vec::new(), Some(error)),
        };
        let (written, computed) = workers.install(|| {
            rayon::join(
                || {
                    finished.iter().try_for_each(|chunk| {
                        for (place, files) in places.iter_mut().zip(&chunk.files) {
                            if let Some(files) = files {
                                place.add(chunk, files)?;
                            }
                        }
                        tally += chunk.tally;
                        progress.done += chunk.points;
                        tell(progress);
                        Ok(())
                    })
                },
                || {
                    inputs
                        .into_par_iter()
                        .map(|input| compute(input, destinations, limits, workers))
                        .collect::<Vec<_>>()
                },
            )
        });
        written.map_err(|error: StoreError| error.with_finished(progress.done))?;
        if let Some(error) = source_error {
            return Err(error);
        }
        finished = Vec::new();
        for chunk in computed {
            let (chunk, columns) = chunk.map_err(|failure| match failure {
                Failure::Point { chunk, refused } => source.refused(chunk, refused),
                Failure::Store(error) => error.into(),
            })?;
            if let Some(view) = &mut view {
                view(chunk.number, &columns);
            }
            finished.push(chunk);
        }
    }

    let complete = progress.done == progress.total;
    let damaged_chunks = places.iter().map(Place::damaged_chunks).sum();
    if complete {
        for place in places {
            place.complete(tally).map_err(|error| error.with_finished(progress.done))?;
        }
    }
    tally.add(Class::NotComputed, progress.total - progress.done);
    let computed = progress.done - reused;
    Ok(Report { points: progress.total, computed, reused, damaged_chunks, complete, tally })
}

struct Input {
    number: usize,
    points: Vec<Point>,
    /// Which places want it.
    wanted: Vec<bool>,
}

enum Failure {
    Point { chunk: usize, refused: Refused },
    Store(StoreError),
}

fn compute(
    input: Input,
    destinations: &[Destination],
    limits: Limits,
    workers: &Workers,
) -> Result<(Finished, Columns), Failure> {
    let Input { number, points, wanted } = input;
    let columns = workers
        .compute_points(&points, limits)
        .map_err(|refused| Failure::Point { chunk: number, refused })?;
    let files = destinations
        .iter()
        .zip(wanted)
        .map(|(destination, wanted)| {
            wanted.then(|| destination.format().encode(number, &points, &columns)).transpose()
        })
        .collect::<Result<_, _>>()
        .map_err(Failure::Store)?;
    let tally = Tally::of_columns(&columns);
    Ok((Finished { number, points: points.len() as u64, tally, files }, columns))
}
