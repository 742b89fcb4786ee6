//! Files that a user names, which end.

use std::fs::{self, File};
use std::io::{self, ErrorKind, Read as _};
use std::path::Path;

/// Opens a file to read it. A pipe would make the program wait for who writes into it, and a device
/// need not end.
///
/// # Errors
/// What the system says, and [`ErrorKind::InvalidInput`] for what is not a file.
pub fn open_file(path: &Path) -> io::Result<File> {
    let kind = fs::metadata(path)?;
    if kind.is_dir() {
        return Err(io::Error::new(ErrorKind::IsADirectory, "it is a folder"));
    }
    if !kind.is_file() {
        return Err(io::Error::new(
            ErrorKind::InvalidInput,
            "it is a pipe or a device, not a file",
        ));
    }
    File::open(path)
}

/// Reads a file that has at most so many bytes.
///
/// # Errors
/// As [`open_file`], and [`ErrorKind::FileTooLarge`].
pub fn read_file(path: &Path, most: u64) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    // Of a file that grows meanwhile no more is read, either.
    open_file(path)?
        .take(most.saturating_add(1))
        .read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most {
        return Err(io::Error::new(
            ErrorKind::FileTooLarge,
            format!("it has more than {most} bytes"),
        ));
    }
    Ok(bytes)
}
