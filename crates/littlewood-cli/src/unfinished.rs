//! Files that are being written under another name, so that they can be removed when the program is
//! ended from outside.

use std::collections::BTreeSet;
use std::fs::{self, File, Permissions, TryLockError as LockError};
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

/// Removes them all, and holds the list. A medium that does not answer is not waited for; then
/// there is nothing to hold.
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

/// The ending of unfinished files, and the number of letters before it that tell apart those of one
/// name.
const SUFFIX: &str = ".part";
const RANDOM: usize = 6;

/// Bytes of the name that an unfinished file has in its own, which must not be too long.
const NAME: usize = 200;

/// The folder of a file.
pub(crate) fn folder_of(path: &Path) -> &Path {
    path.parent()
        .filter(|folder| !folder.as_os_str().is_empty())
        .unwrap_or(Path::new("."))
}

/// How the unfinished files for a name begin: `.littlewood-map.png-`.
fn prefix_of(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    format!(".littlewood-{}-", &name[..name.floor_char_boundary(NAME)])
}

/// Who holds an unfinished file. The lock ends with the process, however it ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Locked {
    /// This process.
    Here,
    ByAnother,
    /// There are no locks; elsewhere than on Unix they would keep ffmpeg from the file.
    Never,
}

fn lock(file: &File) -> Locked {
    if !cfg!(unix) {
        return Locked::Never;
    }
    match file.try_lock() {
        Ok(()) => Locked::Here,
        Err(LockError::WouldBlock) => Locked::ByAnother,
        Err(LockError::Error(_)) => Locked::Never,
    }
}

/// Removes the unfinished files with this beginning that no process holds. What cannot be removed
/// stays: it stands in nobody's way.
fn remove_left(folder: &Path, prefix: &str) {
    let is_one = |name: &str| {
        let letters = name
            .strip_prefix(prefix)
            .and_then(|rest| rest.strip_suffix(SUFFIX));
        letters.is_some_and(|it| {
            it.len() == RANDOM && it.bytes().all(|byte| byte.is_ascii_alphanumeric())
        })
    };
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        if entry.file_name().to_str().is_some_and(is_one)
            && entry.file_type().is_ok_and(|kind| kind.is_file())
            && let Ok(file) = File::open(entry.path())
            && lock(&file) == Locked::Here
        {
            let _ = fs::remove_file(entry.path());
        }
    }
}

/// A file that has a name of its own until it is finished. It is removed if it does not come to
/// that.
#[derive(Debug)]
pub(crate) struct Temporary(NamedTempFile);

impl Temporary {
    /// Begins the file that is to have a name and permissions. What a run that was killed has left
    /// of one for the same name is removed.
    pub(crate) fn new(path: &Path, permissions: Option<Permissions>) -> io::Result<Self> {
        let folder = folder_of(path);
        let prefix = prefix_of(path);
        remove_left(folder, &prefix);
        let mut builder = Builder::new();
        builder.prefix(&prefix).suffix(SUFFIX).rand_bytes(RANDOM);
        if let Some(permissions) = permissions {
            builder.permissions(permissions);
        }
        loop {
            let mut paths = held();
            let file = builder.tempfile_in(folder)?;
            // Before it was locked another run may have taken it for one that was left.
            if lock(file.as_file()) != Locked::ByAnother && file.path().exists() {
                paths.insert(file.path().to_owned());
                return Ok(Self(file));
            }
        }
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
