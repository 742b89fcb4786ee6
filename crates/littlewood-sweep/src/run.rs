//! The driver: computes chunk after chunk, writes each as a whole, and goes on where it was stopped.

use core::sync::atomic::{AtomicBool, Ordering};
use std::collections::BTreeSet;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use littlewood::Limits;
use rayon::prelude::*;
use serde_json::Value;

use crate::columns::Columns;
use crate::compute::{Refused, Workers};
use crate::description::Description;
use crate::disk::{Disk, FileSystem, UNFINISHED};
use crate::error::{StoreError, SweepError};
use crate::manifest::{Manifest, Seal};
use crate::point::Point;

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
    /// Whether the store has all its chunks. If not, the run was cancelled.
    pub complete: bool,
}

/// A file of a store: its path within the store, and its bytes.
pub(crate) type StoreFile = (PathBuf, Vec<u8>);

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
    /// The file that describes the run and says whether it is complete.
    fn header_path(&self) -> &'static str;
    /// The list of finished chunks.
    fn manifest_path(&self) -> &'static str;
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
}

/// A chunk that is computed and encoded.
struct Finished {
    number: usize,
    points: u64,
    files: Vec<StoreFile>,
}

pub(crate) fn run(
    source: &mut dyn Source,
    format: &dyn Format,
    description: &Description,
    limits: Limits,
    root: &Path,
    workers: &Workers,
    options: &Options<'_>,
) -> Result<Report, SweepError> {
    let store = Store { root, format, disk: options.disk };
    let (mut manifest, claimed) = store.open(source.count(), description, options.resume, workers)?;

    let pending: Vec<usize> =
        (0..source.count()).filter(|number| !manifest.chunks.contains_key(number)).collect();
    let reused: u64 = manifest.chunks.keys().map(|&number| source.points_of(number)).sum();
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
            .map(|&number| Ok((number, source.points(number)?)))
            .collect::<Result<Vec<_>, SweepError>>();
        let (inputs, source_error) = match inputs {
            Ok(inputs) => (inputs, None),
            Err(error) => (Vec::new(), Some(error)),
        };
        let (written, computed) = workers.install(|| {
            rayon::join(
                || {
                    finished.iter().try_for_each(|chunk| {
                        store.add(chunk, &mut manifest)?;
                        progress.done += chunk.points;
                        tell(progress);
                        Ok(())
                    })
                },
                || {
                    inputs
                        .into_par_iter()
                        .map(|(number, points)| compute(number, &points, format, limits, workers))
                        .collect::<Vec<_>>()
                },
            )
        });
        written.map_err(SweepError::Store)?;
        if let Some(error) = source_error {
            return Err(error);
        }
        finished = computed
            .into_iter()
            .map(|chunk| {
                chunk.map_err(|failure| match failure {
                    Failure::Point { chunk, refused } => source.refused(chunk, refused),
                    Failure::Store(error) => error.into(),
                })
            })
            .collect::<Result<_, _>>()?;
    }

    let complete = manifest.chunks.len() == source.count();
    if complete {
        store.complete(&manifest)?;
    }
    Ok(Report {
        points: source.total(),
        computed: progress.done - reused,
        reused,
        damaged_chunks: claimed - manifest_reused(&pending, source.count()),
        complete,
    })
}

/// Number of chunks that were there and intact.
fn manifest_reused(pending: &[usize], count: usize) -> usize {
    count - pending.len()
}

enum Failure {
    Point { chunk: usize, refused: Refused },
    Store(StoreError),
}

fn compute(
    number: usize,
    points: &[Point],
    format: &dyn Format,
    limits: Limits,
    workers: &Workers,
) -> Result<Finished, Failure> {
    let columns = workers
        .compute_points(points, limits)
        .map_err(|refused| Failure::Point { chunk: number, refused })?;
    let files = format.encode(number, points, &columns).map_err(Failure::Store)?;
    Ok(Finished { number, points: points.len() as u64, files })
}

/// A store on disk.
struct Store<'a> {
    root: &'a Path,
    format: &'a dyn Format,
    disk: &'a dyn Disk,
}

impl Store<'_> {
    /// Opens or begins the store. Returns the chunks that are there and intact, and the number of those that the
    /// manifest (or the header, if it says that the store is complete) claims.
    fn open(
        &self,
        count: usize,
        description: &Description,
        resume: bool,
        workers: &Workers,
    ) -> Result<(Manifest, usize), StoreError> {
        let new = Manifest::new(description.crc());
        let Some((there, complete)) = self.read_header()? else {
            self.begin(&new)?;
            return Ok((new, 0));
        };
        let differences = description.differences(&there);
        if !differences.is_empty() {
            return Err(StoreError::OtherParameters { path: self.root.to_owned(), differences });
        }
        if !resume {
            return Err(StoreError::Exists { path: self.root.to_owned(), complete });
        }
        let path = self.root.join(self.format.manifest_path());
        let claimed = match fs::read(&path) {
            Ok(text) => Manifest::parse(&text, new.run, count)
                .map_err(|line| StoreError::DamagedManifest { path: path.clone(), line })?,
            Err(error) if error.kind() == io::ErrorKind::NotFound => new,
            Err(source) => return Err(StoreError::Unreadable { path, source }),
        };
        let mut manifest = Manifest::new(claimed.run);
        manifest.chunks = workers.install(|| {
            claimed
                .chunks
                .par_iter()
                .filter(|&(&number, &seal)| self.is_intact(number, seal))
                .map(|(&number, &seal)| (number, seal))
                .collect()
        });
        if manifest.chunks.len() < count {
            // From here on the store is partial, whatever it was, until its last chunk is there.
            self.put(Path::new(self.format.header_path()), &self.format.header(false)?)?;
            for (path, bytes) in self.format.prelude()? {
                self.put(&path, &bytes)?;
            }
            self.put(Path::new(self.format.manifest_path()), manifest.text().as_bytes())?;
        }
        let claimed = if complete { count } else { claimed.chunks.len() };
        Ok((manifest, claimed))
    }

    /// The description and the state of a store that is there; none if there is nothing.
    fn read_header(&self) -> Result<Option<(Value, bool)>, StoreError> {
        let not_a_store = || StoreError::NotAStore { path: self.root.to_owned() };
        let unreadable = |path: &Path, source| StoreError::Unreadable { path: path.to_owned(), source };
        match fs::metadata(self.root) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
            Err(source) => return Err(unreadable(self.root, source)),
            Ok(metadata) if !metadata.is_dir() => return Err(not_a_store()),
            Ok(_) => {}
        }
        let path = self.root.join(self.format.header_path());
        match fs::read(&path) {
            Ok(bytes) => {
                let header = serde_json::from_slice(&bytes).map_err(|error| StoreError::DamagedMetadata {
                    path: path.clone(),
                    reason: error.to_string(),
                })?;
                self.format.read_header(&header).map(Some).ok_or_else(not_a_store)
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                // A folder with nothing in it, or with what a kill has left of the first file.
                let torn = format!("{}{UNFINISHED}", self.format.header_path());
                for entry in fs::read_dir(self.root).map_err(|source| unreadable(self.root, source))? {
                    let entry = entry.map_err(|source| unreadable(self.root, source))?;
                    if entry.file_name().to_str() != Some(&torn) {
                        return Err(not_a_store());
                    }
                }
                Ok(None)
            }
            Err(source) => Err(unreadable(&path, source)),
        }
    }

    fn begin(&self, manifest: &Manifest) -> Result<(), StoreError> {
        self.folder(self.root)?;
        self.put(Path::new(self.format.header_path()), &self.format.header(false)?)?;
        for (path, bytes) in self.format.prelude()? {
            self.put(&path, &bytes)?;
        }
        self.put(Path::new(self.format.manifest_path()), manifest.head().as_bytes())
    }

    fn is_intact(&self, number: usize, seal: Seal) -> bool {
        let files: Result<Vec<Vec<u8>>, io::Error> =
            self.format.paths(number).iter().map(|path| fs::read(self.root.join(path))).collect();
        files.is_ok_and(|files| Seal::of(files.iter().map(Vec::as_slice)) == seal)
    }

    /// Writes the files of a chunk, then its line in the manifest.
    fn add(&self, chunk: &Finished, manifest: &mut Manifest) -> Result<(), StoreError> {
        for (path, bytes) in &chunk.files {
            self.put(path, bytes)?;
        }
        let seal = Seal::of(chunk.files.iter().map(|(_, bytes)| bytes.as_slice()));
        let path = self.root.join(self.format.manifest_path());
        self.disk
            .append(&path, Manifest::line(chunk.number, seal).as_bytes())
            .map_err(|source| StoreError::Unwritable { path, source })?;
        manifest.chunks.insert(chunk.number, seal);
        Ok(())
    }

    /// The manifest in order, and the header that says so.
    fn complete(&self, manifest: &Manifest) -> Result<(), StoreError> {
        for (path, bytes) in [
            (Path::new(self.format.manifest_path()), manifest.text().into_bytes()),
            (Path::new(self.format.header_path()), self.format.header(true)?),
        ] {
            if fs::read(self.root.join(path)).ok().as_deref() != Some(&bytes) {
                self.put(path, &bytes)?;
            }
        }
        Ok(())
    }

    fn folder(&self, path: &Path) -> Result<(), StoreError> {
        self.disk
            .create_folder(path)
            .map_err(|source| StoreError::Unwritable { path: path.to_owned(), source })
    }

    fn put(&self, path: &Path, bytes: &[u8]) -> Result<(), StoreError> {
        let path = self.root.join(path);
        if let Some(folder) = path.parent() {
            self.folder(folder)?;
        }
        self.disk.write(&path, bytes).map_err(|source| StoreError::Unwritable { path, source })
    }
}

/// The numbers of chunks of a store that its manifest does not have, or whose files do not match it.
///
/// # Errors
/// If the manifest is damaged or cannot be read.
pub(crate) fn broken_chunks(
    root: &Path,
    format: &dyn Format,
    count: usize,
    description: &Description,
) -> Result<BTreeSet<usize>, StoreError> {
    let store = Store { root, format, disk: &FileSystem };
    let path = root.join(format.manifest_path());
    let text = fs::read(&path).map_err(|source| StoreError::Unreadable { path: path.clone(), source })?;
    let manifest = Manifest::parse(&text, description.crc(), count)
        .map_err(|line| StoreError::DamagedManifest { path, line })?;
    Ok((0..count)
        .into_par_iter()
        .filter(|number| manifest.chunks.get(number).is_none_or(|&seal| !store.is_intact(*number, seal)))
        .collect())
}
