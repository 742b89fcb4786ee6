//! What is at the path of a store: whether a run may begin or go on there, and which chunks are
//! intact.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::Path;

use rayon::prelude::*;

use super::error::StoreError;
use super::format::{Format, Header};
use super::manifest::{Checksum, Manifest};
use crate::disk::UNFINISHED;
use crate::file::read_file;

/// The header of a store that may be resumed; none where a store may be begun.
pub(super) fn check(
    root: &Path,
    format: &dyn Format,
    resume: bool,
) -> Result<Option<Header>, StoreError> {
    let Some(header) = read_header(root, format)? else {
        return Ok(None);
    };
    header.check_versions(root)?;
    let differences = format.description().differences(&header.run);
    if !differences.is_empty() {
        return Err(StoreError::OtherParameters {
            path: root.to_owned(),
            differences,
        });
    }
    if !resume {
        return Err(StoreError::Exists {
            path: root.to_owned(),
            complete: header.complete,
        });
    }
    Ok(Some(header))
}

/// The header of a store; none if there is nothing.
fn read_header(root: &Path, format: &dyn Format) -> Result<Option<Header>, StoreError> {
    let not_a_store = || StoreError::NotAStore {
        path: root.to_owned(),
    };
    match fs::metadata(root) {
        Err(error) if error.kind() == ErrorKind::NotFound => return Ok(None),
        // A path through a file, or through a folder that may not be read: nothing can be written
        // there.
        Err(source) => return Err(StoreError::unwritable(root, source)),
        Ok(metadata) if !metadata.is_dir() => return Err(not_a_store()),
        Ok(_) => {}
    }
    let path = root.join(format.names().header);
    match read_file(&path, u64::MAX) {
        Ok(bytes) => {
            let header =
                serde_json::from_slice(&bytes).map_err(|error| StoreError::DamagedMetadata {
                    path: path.clone(),
                    reason: error.to_string(),
                })?;
            format
                .read_header(&header)
                .map(Some)
                .ok_or_else(not_a_store)
        }
        Err(error) if error.kind() == ErrorKind::NotFound => {
            if has_other_files(root, format)
                .map_err(|source| StoreError::unreadable(root, source))?
            {
                return Err(not_a_store());
            }
            Ok(None)
        }
        Err(source) => Err(StoreError::unreadable(&path, source)),
    }
}

/// Whether a folder without a header has anything in it but what a kill leaves of the first steps:
/// the lock, and an unfinished header.
fn has_other_files(root: &Path, format: &dyn Format) -> io::Result<bool> {
    let unfinished = format!("{}{UNFINISHED}", format.names().header);
    let lock = Path::new(format.names().lock);
    let lock_folder = lock
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    for entry in fs::read_dir(root)? {
        let name = entry?.file_name();
        if name.to_str() == Some(&unfinished) || Path::new(&name) == lock {
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

pub(super) fn is_intact(
    root: &Path,
    format: &dyn Format,
    number: usize,
    checksum: Checksum,
) -> bool {
    let files: Result<Vec<Vec<u8>>, io::Error> = format
        .paths(number)
        .iter()
        .map(|path| read_file(&root.join(path), u64::MAX))
        .collect();
    files.is_ok_and(|files| Checksum::of(files.iter().map(Vec::as_slice)) == checksum)
}

/// The numbers of chunks of a store that its manifest does not have, or whose files do not match
/// it.
///
/// # Errors
/// If the manifest is damaged or cannot be read.
pub(crate) fn broken_chunks(
    root: &Path,
    format: &dyn Format,
    count: usize,
) -> Result<BTreeSet<usize>, StoreError> {
    let path = root.join(format.names().manifest);
    let text =
        read_file(&path, u64::MAX).map_err(|source| StoreError::unreadable(&path, source))?;
    let manifest = Manifest::parse(&text, format.description().crc(), count)
        .map_err(|line| StoreError::DamagedManifest { path, line })?;
    let is_broken = |number: &usize| {
        manifest
            .chunks
            .get(number)
            .is_none_or(|chunk| !is_intact(root, format, *number, chunk.checksum))
    };
    Ok((0..count).into_par_iter().filter(is_broken).collect())
}
