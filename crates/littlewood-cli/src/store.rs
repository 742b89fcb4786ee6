//! Where a sweep goes: a Zarr store, a folder of Parquet files or a picture, by the ending of its name.

use std::path::{Path, PathBuf};

use littlewood_sweep::{Class, ZarrStore};

use crate::error::Error;

/// What an ending stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Zarr v3.
    Zarr,
    /// Parquet.
    Parquet,
    /// PNG.
    Picture,
}

/// Finds out what a path is to be.
///
/// # Errors
/// Another ending than those of `allowed`.
pub(crate) fn kind_of(path: &Path, allowed: &[Kind]) -> Result<Kind, Error> {
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    allowed.iter().copied().find(|kind| kind.ending() == ending).ok_or_else(|| {
        let endings: Vec<String> = allowed.iter().map(|kind| format!(".{}", kind.ending())).collect();
        Error::Out {
            path: path.to_owned(),
            reason: "the ending does not say what it is to be".to_owned(),
            hint: format!("names end in {}", endings.join(" or ")),
        }
    })
}

impl Kind {
    const fn ending(self) -> &'static str {
        match self {
            Self::Zarr => "zarr",
            Self::Parquet => "parquet",
            Self::Picture => "png",
        }
    }
}

/// Points of each class that occurs.
pub(crate) type Counts = Vec<(Class, u64)>;

/// Counts the points of a store, class by class.
///
/// # Errors
/// A file of it that cannot be read.
pub(crate) fn count(path: &Path) -> Result<Counts, Error> {
    let store = ZarrStore::open(path)?;
    let mut counts = [0; Class::ALL.len()];
    for number in 0..store.chunks().count() {
        match store.columns(number)? {
            Some(columns) => columns.rows().for_each(|row| counts[Class::of(&row) as usize] += 1),
            None => counts[Class::NotComputed as usize] += store.chunks().chunk(number).len() as u64,
        }
    }
    Ok(Class::ALL.into_iter().zip(counts).filter(|(_, count)| *count > 0).collect())
}

/// What to say when Ctrl-C has come.
pub(crate) fn interrupted(done: u64, total: u64, out: &[PathBuf]) -> Error {
    let hint = match out.iter().find(|path| path.extension().is_none_or(|ending| ending != "png")) {
        Some(path) => format!(
            "{} can be read as far as it goes; the same command with --resume goes on from there",
            path.display()
        ),
        None => "a picture is not resumed; with a .zarr store beside it, it can be".to_owned(),
    };
    Error::Interrupted { done, total, hint }
}
