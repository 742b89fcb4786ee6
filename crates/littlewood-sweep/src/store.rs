//! A store on disk: a folder with a header, a list of finished chunks, and their files.

use std::collections::BTreeSet;
use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind};
use std::path::Path;

use rayon::prelude::*;
use serde_json::Value;

use crate::compute::Workers;
use crate::disk::{Disk, UNFINISHED};
use crate::error::StoreError;
use crate::manifest::{Entry, Manifest, Seal};
use crate::run::{Finished, Format, StoreFile};
use crate::tally::Tally;

/// A store that is open for writing. No other process has it open at the same time.
pub(crate) struct Store<'a> {
    root: &'a Path,
    format: &'a dyn Format,
    disk: &'a dyn Disk,
    /// Chunks that are there and intact.
    manifest: Manifest,
    /// Number of chunks that were said to be there when it was opened, but are damaged or missing.
    damaged: usize,
    /// Held, not read: the lock ends with it. None on file systems without locks.
    _lock: Option<File>,
}

/// What the header of a store says.
struct Header {
    complete: bool,
}

impl<'a> Store<'a> {
    /// Finds out whether the store may be begun or gone on with. Writes nothing.
    pub(crate) fn inspect(root: &Path, format: &dyn Format, resume: bool) -> Result<(), StoreError> {
        check(root, format, resume).map(drop)
    }

    /// Opens or begins the store of a run with so many chunks.
    pub(crate) fn open(
        root: &'a Path,
        format: &'a dyn Format,
        count: usize,
        resume: bool,
        disk: &'a dyn Disk,
        workers: &Workers,
    ) -> Result<Self, StoreError> {
        // Whoever had the store may have finished it, or begun another one, until the lock was ours.
        let before = check(root, format, resume)?;
        let lock = lock(root, format, disk, before.is_some_and(|header| header.complete))?;
        let header = check(root, format, resume)?;
        let manifest = Manifest::new(format.description().crc());
        let mut store = Self { root, format, disk, manifest, damaged: 0, _lock: lock };
        match header {
            None => store.begin()?,
            Some(Header { complete }) => store.go_on(count, complete, workers)?,
        }
        Ok(store)
    }

    fn begin(&self) -> Result<(), StoreError> {
        self.put(Path::new(self.format.header_path()), &self.format.header(false)?)?;
        for (path, bytes) in self.format.prelude()? {
            self.put(&path, &bytes)?;
        }
        self.put(Path::new(self.format.manifest_path()), self.manifest.head().as_bytes())
    }

    fn go_on(&mut self, count: usize, complete: bool, workers: &Workers) -> Result<(), StoreError> {
        let path = self.root.join(self.format.manifest_path());
        let claimed = match fs::read(&path) {
            Ok(text) => Manifest::parse(&text, self.manifest.run, count)
                .map_err(|line| StoreError::DamagedManifest { path: path.clone(), line })?,
            Err(error) if error.kind() == ErrorKind::NotFound => Manifest::new(self.manifest.run),
            Err(source) => return Err(StoreError::Unreadable { path, source }),
        };
        self.manifest.chunks = workers.install(|| {
            claimed
                .chunks
                .par_iter()
                .filter(|&(&number, entry)| is_intact(self.root, self.format, number, entry.seal))
                .map(|(&number, &entry)| (number, entry))
                .collect()
        });
        let intact = self.manifest.chunks.len();
        self.damaged = if complete { count } else { claimed.chunks.len() } - intact;
        if intact < count {
            // From here on the store is partial, whatever it was, until its last chunk is there.
            self.put(Path::new(self.format.header_path()), &self.format.header(false)?)?;
            for (path, bytes) in self.format.prelude()? {
                self.put(&path, &bytes)?;
            }
            self.put(Path::new(self.format.manifest_path()), self.manifest.text().as_bytes())?;
        }
        Ok(())
    }

    pub(crate) fn has(&self, chunk: usize) -> bool {
        self.manifest.chunks.contains_key(&chunk)
    }

    /// Points of some chunks, class by class.
    pub(crate) fn tally(&self, chunks: &[usize]) -> Tally {
        let mut tally = Tally::default();
        for entry in chunks.iter().filter_map(|number| self.manifest.chunks.get(number)) {
            tally += entry.tally;
        }
        tally
    }

    pub(crate) const fn damaged_chunks(&self) -> usize {
        self.damaged
    }

    /// Writes the files of a chunk, then its line in the manifest.
    pub(crate) fn add(&mut self, chunk: &Finished, files: &[StoreFile]) -> Result<(), StoreError> {
        for (path, bytes) in files {
            self.put(path, bytes)?;
        }
        let seal = Seal::of(files.iter().map(|(_, bytes)| bytes.as_slice()));
        let entry = Entry { seal, tally: chunk.tally };
        let path = self.root.join(self.format.manifest_path());
        self.disk
            .append(&path, Manifest::line(chunk.number, &entry).as_bytes())
            .map_err(|source| StoreError::unwritable(&path, source))?;
        self.manifest.chunks.insert(chunk.number, entry);
        Ok(())
    }

    /// The manifest in order, and the header that says so.
    pub(crate) fn complete(&self) -> Result<(), StoreError> {
        for (path, bytes) in [
            (Path::new(self.format.manifest_path()), self.manifest.text().into_bytes()),
            (Path::new(self.format.header_path()), self.format.header(true)?),
        ] {
            if fs::read(self.root.join(path)).ok().as_deref() != Some(&bytes) {
                self.put(path, &bytes)?;
            }
        }
        Ok(())
    }

    fn put(&self, path: &Path, bytes: &[u8]) -> Result<(), StoreError> {
        let path = self.root.join(path);
        if let Some(folder) = path.parent() {
            self.disk.create_folder(folder).map_err(|source| StoreError::unwritable(folder, source))?;
        }
        self.disk.write(&path, bytes).map_err(|source| StoreError::unwritable(&path, source))
    }
}

/// Locks the store against other processes. The lock ends with the process, however it ends; the empty file stays, since
/// taking it away could take it from under another process.
fn lock(
    root: &Path,
    format: &dyn Format,
    disk: &dyn Disk,
    complete: bool,
) -> Result<Option<File>, StoreError> {
    let path = root.join(format.lock_path());
    let folder = path.parent().unwrap_or(root);
    disk.create_folder(folder).map_err(|source| StoreError::unwritable(folder, source))?;
    let file = match OpenOptions::new().read(true).append(true).create(true).open(&path) {
        Ok(file) => file,
        // Nothing is written to a store that is complete and intact; if it is not, writing will fail and say so.
        Err(_) if complete => return Ok(None),
        Err(source) => return Err(StoreError::unwritable(&path, source)),
    };
    match file.try_lock() {
        Ok(()) => Ok(Some(file)),
        Err(TryLockError::WouldBlock) => Err(StoreError::Locked { path: root.to_owned() }),
        Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Unsupported => Ok(None),
        Err(TryLockError::Error(source)) => Err(StoreError::unwritable(&path, source)),
    }
}

/// The header of a store that may be gone on with; none where a store may be begun.
fn check(root: &Path, format: &dyn Format, resume: bool) -> Result<Option<Header>, StoreError> {
    let Some((there, complete)) = read_header(root, format)? else { return Ok(None) };
    let differences = format.description().differences(&there);
    if !differences.is_empty() {
        return Err(StoreError::OtherParameters { path: root.to_owned(), differences });
    }
    if !resume {
        return Err(StoreError::Exists { path: root.to_owned(), complete });
    }
    Ok(Some(Header { complete }))
}

/// The description and the state of a store that is there; none if there is nothing.
fn read_header(root: &Path, format: &dyn Format) -> Result<Option<(Value, bool)>, StoreError> {
    let not_a_store = || StoreError::NotAStore { path: root.to_owned() };
    let unreadable = |path: &Path, source| StoreError::Unreadable { path: path.to_owned(), source };
    match fs::metadata(root) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        // A path through a file, or through a folder that is closed to us: nothing can be written there.
        Err(source) => return Err(StoreError::unwritable(root, source)),
        Ok(metadata) if !metadata.is_dir() => return Err(not_a_store()),
        Ok(_) => {}
    }
    let path = root.join(format.header_path());
    match fs::read(&path) {
        Ok(bytes) => {
            let header = serde_json::from_slice(&bytes).map_err(|error| StoreError::DamagedMetadata {
                path: path.clone(),
                reason: error.to_string(),
            })?;
            format.read_header(&header).map(Some).ok_or_else(not_a_store)
        }
        Err(error) if error.kind() == ErrorKind::NotFound => {
            if has_strangers(root, format).map_err(|source| unreadable(root, source))? {
                return Err(not_a_store());
            }
            Ok(None)
        }
        Err(source) => Err(unreadable(&path, source)),
    }
}

/// Whether a folder without a header has anything in it but what a kill leaves of the first steps: the lock, and a torn
/// header.
fn has_strangers(root: &Path, format: &dyn Format) -> io::Result<bool> {
    let torn = format!("{}{UNFINISHED}", format.header_path());
    let lock = Path::new(format.lock_path());
    let lock_folder = lock.parent().filter(|folder| !folder.as_os_str().is_empty());
    for entry in fs::read_dir(root)? {
        let name = entry?.file_name();
        if name.to_str() == Some(&torn) || Path::new(&name) == lock {
            continue;
        }
        if lock_folder != Some(Path::new(&name)) {
            return Ok(true);
        }
        for inner in fs::read_dir(root.join(&name))? {
            if Some(inner?.file_name().as_os_str()) != lock.file_name() {
                return Ok(true);
            }
        }
    }
    Ok(false)
}

fn is_intact(root: &Path, format: &dyn Format, number: usize, seal: Seal) -> bool {
    let files: Result<Vec<Vec<u8>>, io::Error> =
        format.paths(number).iter().map(|path| fs::read(root.join(path))).collect();
    files.is_ok_and(|files| Seal::of(files.iter().map(Vec::as_slice)) == seal)
}

/// The numbers of chunks of a store that its manifest does not have, or whose files do not match it.
///
/// # Errors
/// If the manifest is damaged or cannot be read.
pub(crate) fn broken_chunks(
    root: &Path,
    format: &dyn Format,
    count: usize,
) -> Result<BTreeSet<usize>, StoreError> {
    let path = root.join(format.manifest_path());
    let text = fs::read(&path).map_err(|source| StoreError::Unreadable { path: path.clone(), source })?;
    let manifest = Manifest::parse(&text, format.description().crc(), count)
        .map_err(|line| StoreError::DamagedManifest { path, line })?;
    let is_broken = |number: &usize| {
        manifest.chunks.get(number).is_none_or(|entry| !is_intact(root, format, *number, entry.seal))
    };
    Ok((0..count).into_par_iter().filter(is_broken).collect())
}
