//! Writing a store: it begins or is resumed, chunks are added, it is completed.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::ErrorKind;
use std::path::Path;

use rayon::prelude::*;

use super::error::StoreError;
use super::format::{Format, Header, StoreFile};
use super::manifest::{Checksum, Manifest, ManifestChunk};
use super::open::{check, is_intact};
use crate::compute::Workers;
use crate::disk::Disk;
use crate::file::read_file;
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

/// A chunk that is written, by its number, with its points class by class.
#[derive(Clone, Copy, Debug)]
pub(crate) struct WrittenChunk {
    pub(crate) number: usize,
    pub(crate) tally: Tally,
}

impl<'a> Store<'a> {
    /// Finds out whether the store may be begun or resumed. Writes nothing.
    pub(crate) fn inspect(
        root: &Path,
        format: &dyn Format,
        resume: bool,
    ) -> Result<(), StoreError> {
        check(root, format, resume).map(drop)
    }

    pub(crate) fn open(
        root: &'a Path,
        format: &'a dyn Format,
        count: usize,
        resume: bool,
        disk: &'a dyn Disk,
        workers: &Workers,
    ) -> Result<Self, StoreError> {
        // Until the lock is held another process may finish the store, or begin another one:
        // checked again after it.
        let before = check(root, format, resume)?;
        let lock = lock(
            root,
            format,
            disk,
            before.is_some_and(|header| header.complete),
        )?;
        let header = check(root, format, resume)?;
        let manifest = Manifest::new(format.description().crc());
        let mut store = Self {
            root,
            format,
            disk,
            manifest,
            damaged: 0,
            _lock: lock,
        };
        match header {
            None => store.begin()?,
            Some(Header { complete, .. }) => store.resume(count, complete, workers)?,
        }
        Ok(store)
    }

    /// Writes what describes the store, as a partial one.
    fn begin(&self) -> Result<(), StoreError> {
        self.write(
            Path::new(self.format.names().header),
            &self.format.header(false)?,
        )?;
        for (path, bytes) in self.format.initial_files()? {
            self.write(&path, &bytes)?;
        }
        self.write(
            Path::new(self.format.names().manifest),
            self.manifest.text().as_bytes(),
        )
    }

    fn resume(
        &mut self,
        count: usize,
        complete: bool,
        workers: &Workers,
    ) -> Result<(), StoreError> {
        let path = self.root.join(self.format.names().manifest);
        let claimed = match read_file(&path, u64::MAX) {
            Ok(text) => Manifest::parse(&text, self.manifest.run, count).map_err(|line| {
                StoreError::DamagedManifest {
                    path: path.clone(),
                    line,
                }
            })?,
            Err(error) if error.kind() == ErrorKind::NotFound => Manifest::new(self.manifest.run),
            Err(source) => return Err(StoreError::unreadable(&path, source)),
        };
        self.manifest.chunks = workers.install(|| {
            claimed
                .chunks
                .par_iter()
                .filter(|&(&number, entry)| {
                    is_intact(self.root, self.format, number, entry.checksum)
                })
                .map(|(&number, &entry)| (number, entry))
                .collect()
        });
        let intact = self.manifest.chunks.len();
        self.damaged = if complete {
            count
        } else {
            claimed.chunks.len()
        } - intact;
        if intact < count {
            // A store that was complete is partial from here on, until its last chunk is there.
            self.begin()?;
        }
        Ok(())
    }

    pub(crate) fn has(&self, chunk: usize) -> bool {
        self.manifest.chunks.contains_key(&chunk)
    }

    pub(crate) fn tally(&self, chunks: &[usize]) -> Tally {
        let mut tally = Tally::default();
        for entry in chunks
            .iter()
            .filter_map(|number| self.manifest.chunks.get(number))
        {
            tally += entry.tally;
        }
        tally
    }

    pub(crate) const fn damaged_chunks(&self) -> usize {
        self.damaged
    }

    /// Writes the files of a chunk, then its line in the manifest.
    pub(crate) fn add(
        &mut self,
        chunk: WrittenChunk,
        files: &[StoreFile],
    ) -> Result<(), StoreError> {
        for (path, bytes) in files {
            self.write(path, bytes)?;
        }
        let checksum = Checksum::of(files.iter().map(|(_, bytes)| bytes.as_slice()));
        let entry = ManifestChunk {
            checksum,
            tally: chunk.tally,
        };
        let path = self.root.join(self.format.names().manifest);
        self.disk
            .append(&path, Manifest::line(chunk.number, &entry).as_bytes())
            .map_err(|source| StoreError::unwritable(&path, source))?;
        self.manifest.chunks.insert(chunk.number, entry);
        Ok(())
    }

    /// Writes the manifest in the order of the chunks, and the header that says that the store is
    /// complete. What describes the store is written again where it has been damaged since it was
    /// begun.
    pub(crate) fn complete(&self) -> Result<(), StoreError> {
        let mut files = self.format.initial_files()?;
        files.push((
            self.format.names().manifest.into(),
            self.manifest.text().into_bytes(),
        ));
        files.push((self.format.names().header.into(), self.format.header(true)?));
        for (path, bytes) in files {
            if read_file(&self.root.join(&path), u64::MAX).ok().as_deref() != Some(&bytes) {
                self.write(&path, &bytes)?;
            }
        }
        Ok(())
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> Result<(), StoreError> {
        let path = self.root.join(path);
        if let Some(folder) = path.parent() {
            self.disk
                .create_folder(folder)
                .map_err(|source| StoreError::unwritable(folder, source))?;
        }
        self.disk
            .write(&path, bytes)
            .map_err(|source| StoreError::unwritable(&path, source))
    }
}

/// Locks the store against other processes; none on file systems without locks. The lock ends with
/// the process, however it ends; the empty file stays, since another process may have it open.
fn lock(
    root: &Path,
    format: &dyn Format,
    disk: &dyn Disk,
    complete: bool,
) -> Result<Option<File>, StoreError> {
    let path = root.join(format.names().lock);
    let folder = path.parent().unwrap_or(root);
    disk.create_folder(folder)
        .map_err(|source| StoreError::unwritable(folder, source))?;
    let file = match OpenOptions::new()
        .read(true)
        .append(true)
        .create(true)
        .open(&path)
    {
        Ok(file) => file,
        // Nothing is written to a store that is complete and intact; if it is not, writing will
        // fail and say so.
        Err(_) if complete => return Ok(None),
        Err(source) => return Err(StoreError::unwritable(&path, source)),
    };
    match file.try_lock() {
        Ok(()) => Ok(Some(file)),
        Err(TryLockError::WouldBlock) => Err(StoreError::Locked {
            path: root.to_owned(),
        }),
        Err(TryLockError::Error(error)) if error.kind() == ErrorKind::Unsupported => Ok(None),
        Err(TryLockError::Error(source)) => Err(StoreError::unwritable(&path, source)),
    }
}
