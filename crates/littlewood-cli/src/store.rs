//! Where a sweep goes: a Zarr store, a table, a text or a picture, by the ending of its name.

use std::path::{Path, PathBuf};

use littlewood_sweep::Target;

use crate::error::Error;
use crate::output::{by_ending, check_folder, place_of};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Zarr,
    Parquet,
    Csv,
    /// PNG.
    Picture,
    Svg,
    Pdf,
}

/// Starts up to which a table is one file. The footer of a file grows with it.
const ONE_FILE: u64 = 1 << 24;

/// Finds out what a path is to be, by its ending.
pub(crate) fn kind_of(path: &Path, allowed: &[Kind]) -> Result<Kind, Error> {
    let endings: Vec<(&str, Kind)> = allowed.iter().map(|kind| (kind.ending(), *kind)).collect();
    let kind = by_ending(path, "it", &endings)?;
    let missing = match kind {
        Kind::Zarr | Kind::Parquet if !cfg!(feature = "sweep") => Some("sweep"),
        Kind::Pdf if !cfg!(feature = "figures") => Some("figures"),
        _ => None,
    };
    match missing {
        None => Ok(kind),
        Some(feature) => Err(Error::NotBuilt {
            what: format!("what --out {} needs", path.display()),
            feature,
        }),
    }
}

impl Kind {
    /// What a map can be written as.
    pub(crate) const OF_A_MAP: [Self; 6] = [
        Self::Zarr,
        Self::Parquet,
        Self::Csv,
        Self::Picture,
        Self::Svg,
        Self::Pdf,
    ];

    /// Whether it shows the map.
    pub(crate) const fn is_picture(self) -> bool {
        matches!(self, Self::Picture | Self::Svg | Self::Pdf)
    }

    /// Whether it shows the map in vectors.
    pub(crate) const fn is_drawing(self) -> bool {
        matches!(self, Self::Svg | Self::Pdf)
    }

    const fn ending(self) -> &'static str {
        match self {
            Self::Zarr => "zarr",
            Self::Parquet => "parquet",
            Self::Csv => "csv",
            Self::Picture => "png",
            Self::Svg => "svg",
            Self::Pdf => "pdf",
        }
    }

    /// Whether it is written once all is computed, and not chunk by chunk.
    pub(crate) const fn is_written_at_the_end(self) -> bool {
        !matches!(self, Self::Zarr | Self::Parquet)
    }

    /// The target of a run with so many starts; none for what is written at its end.
    pub(crate) const fn target(self, path: &Path, starts: u64) -> Option<Target<'_>> {
        match self {
            Self::Zarr => Some(Target::Zarr(path)),
            Self::Parquet if starts <= ONE_FILE => Some(Target::Parquet(path)),
            Self::Parquet => Some(Target::ParquetFolder(path)),
            Self::Csv | Self::Picture | Self::Svg | Self::Pdf => None,
        }
    }
}

/// What every `--out` is to be, each place once, and in a folder that is there.
pub(crate) fn kinds<'a>(
    out: &'a [PathBuf],
    allowed: &[Kind],
) -> Result<Vec<(Kind, &'a Path)>, Error> {
    let mut kinds: Vec<(Kind, &Path)> = Vec::new();
    for path in out {
        if kinds
            .iter()
            .any(|(_, other)| place_of(other) == place_of(path))
        {
            let reason = "this place is given twice".to_owned();
            let hint = "give each output a name of its own".to_owned();
            return Err(Error::Out {
                path: path.clone(),
                reason,
                hint,
            });
        }
        kinds.push((kind_of(path, allowed)?, path));
    }
    for (_, path) in &kinds {
        check_folder(path)?;
    }
    Ok(kinds)
}

/// What to say when Ctrl-C has come.
pub(crate) fn interrupted(done: u64, total: u64, kept: &[PathBuf]) -> Error {
    let at_the_end =
        |path: &Path| kind_of(path, &Kind::OF_A_MAP).is_ok_and(Kind::is_written_at_the_end);
    let store = kept.iter().find(|path| !at_the_end(path));
    let hint = match (store, kept.first()) {
        (Some(path), _) => format!(
            "{} can be read as far as it goes; the same command with --resume goes on from there",
            path.display()
        ),
        (None, Some(partial)) => format!(
            "what was done is in {}; a picture or a text alone is not resumed, with a .zarr store beside it, it can be",
            partial.display()
        ),
        (None, None) => "nothing was done that could be kept".to_owned(),
    };
    Error::Interrupted { done, total, hint }
}
