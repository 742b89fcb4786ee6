//! The lock of a store against other processes.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::ErrorKind;
use std::path::Path;

use super::error::StoreError;
use super::format::Format;
use crate::disk::Disk;

/// Locks the store against other processes; none on file systems without locks. The lock ends with the process, however
/// it ends; the empty file stays, since another process may have it open.
pub(super) fn lock(
    root: &Path,
    format: &dyn Format,
    disk: &dyn Disk,
    complete: bool,
) -> Result<Option<File>, StoreError> {
    let path = root.join(format.names().lock);
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
