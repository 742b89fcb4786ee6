//! Writing files atomically.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// File operations of a sweep, with the errors of the operating system; tests replace them by a
/// disk that fills up.
pub trait Disk: Sync {
    /// Makes a folder and those above it.
    fn create_folder(&self, path: &Path) -> io::Result<()>;

    /// Writes a file atomically: a reader sees all of it or nothing.
    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()>;

    /// Adds to the end of a file.
    fn append(&self, path: &Path, bytes: &[u8]) -> io::Result<()>;

    /// Gives a file another name; a file that has that name is replaced.
    fn rename(&self, from: &Path, to: &Path) -> io::Result<()>;
}

/// The file system.
///
/// A file is written under another name and then renamed. It is not forced to the medium (`fsync`):
/// after a failure of the power the checksums of the chunks show what is missing when the run is
/// resumed.
#[derive(Clone, Copy, Debug, Default)]
pub struct FileSystem;

/// Ending of files that are not finished.
pub const UNFINISHED: &str = ".unfinished";

/// Ending of the folder of the finished chunks of a file.
pub(crate) const PARTS: &str = ".parts";

pub(crate) fn with_ending(path: &Path, ending: &str) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(ending);
    PathBuf::from(name)
}

impl Disk for FileSystem {
    fn create_folder(&self, path: &Path) -> io::Result<()> {
        fs::create_dir_all(path)
    }

    fn write(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        let unfinished = with_ending(path, UNFINISHED);
        let written = File::create(&unfinished)
            .and_then(|mut file| file.write_all(bytes))
            .and_then(|()| fs::rename(&unfinished, path));
        if written.is_err() {
            // The first error is the one to report; this only frees the room that the unfinished
            // file takes.
            let _ = fs::remove_file(&unfinished);
        }
        written
    }

    fn append(&self, path: &Path, bytes: &[u8]) -> io::Result<()> {
        OpenOptions::new()
            .append(true)
            .create(true)
            .open(path)?
            .write_all(bytes)
    }

    fn rename(&self, from: &Path, to: &Path) -> io::Result<()> {
        fs::rename(from, to)
    }
}
