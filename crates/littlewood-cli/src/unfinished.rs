//! Files that are being written under another name, so that they can be removed when the program is ended from outside.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError, TryLockError};
use std::thread;
use std::time::{Duration, Instant};

use littlewood_sweep::{Disk, FileSystem, UNFINISHED};
use tempfile::{Builder, NamedTempFile};

/// How long the end of the program waits for a file that is being written at that instant.
const LONGEST_WAIT: Duration = Duration::from_millis(500);

static PATHS: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// The files that there are now. While it is held none is begun, and none is put in its place.
fn held() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    PATHS.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Removes them all, and holds the list. A medium that does not answer is not waited for; then there is nothing to hold.
pub(crate) fn remove_all() -> Option<MutexGuard<'static, BTreeSet<PathBuf>>> {
    let begun = Instant::now();
    loop {
        let paths = match PATHS.try_lock() {
            Ok(paths) => paths,
            Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
            Err(TryLockError::WouldBlock) if begun.elapsed() > LONGEST_WAIT => return None,
            Err(TryLockError::WouldBlock) => {
                thread::sleep(Duration::from_millis(1));
                continue;
            }
        };
        for path in paths.iter() {
            // The program ends: there is nobody left to tell that a file could not be removed.
            let _ = fs::remove_file(path);
        }
        return Some(paths);
    }
}

/// A file that has a name of its own until it is finished. It is removed if it does not come to that.
#[derive(Debug)]
pub(crate) struct Temporary(NamedTempFile);

impl Temporary {
    /// Begins a file in a folder.
    ///
    /// # Errors
    /// Of the operating system.
    pub(crate) fn new(builder: &Builder<'_, '_>, folder: &Path) -> io::Result<Self> {
        let mut paths = held();
        let file = builder.tempfile_in(folder)?;
        paths.insert(file.path().to_owned());
        Ok(Self(file))
    }

    /// Its name until it is finished.
    pub(crate) fn path(&self) -> &Path {
        self.0.path()
    }

    /// The open file.
    pub(crate) fn file(&mut self) -> &mut File {
        self.0.as_file_mut()
    }

    /// Gives it the name that it is to have; a file of that name is replaced.
    ///
    /// # Errors
    /// Of the operating system.
    pub(crate) fn persist(self, path: &Path) -> io::Result<()> {
        let mut paths = held();
        paths.remove(self.path());
        self.0.persist(path)?;
        Ok(())
    }
}

/// The file system, with a list of what is not finished.
#[derive(Debug)]
pub(crate) struct ListedDisk;

impl Disk for ListedDisk {
    fn create_folder(&self, path: &Path) -> io::Result<()> {
        FileSystem.create_folder(path)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        // It is finished, or removed, before the list is free again.
        let _held = held();
        FileSystem.write(path, bytes)
    }

    fn append(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let mut paths = held();
        if path.as_os_str().to_string_lossy().ends_with(UNFINISHED) {
            paths.insert(path.to_owned());
        }
        FileSystem.append(path, bytes)
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        let mut paths = held();
        let renamed = FileSystem.rename(from, to);
        if renamed.is_ok() {
            paths.remove(from);
        }
        renamed
    }
}
