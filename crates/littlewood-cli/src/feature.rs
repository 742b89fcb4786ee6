//! The parts of the program that it can be built without.

use core::fmt;

/// A feature of this package, in `Cargo.toml` by the same name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(dead_code, reason = "a feature that is there is named by nobody")]
pub(crate) enum Feature {
    /// `sweep`, `atlas`, Zarr stores and Parquet tables.
    Sweep,
    /// `figures` and `poster`, maps as PDF.
    Figures,
    /// `animate`.
    Film,
    /// `lab`.
    Lab,
}

impl fmt::Display for Feature {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Sweep => "sweep",
            Self::Figures => "figures",
            Self::Film => "film",
            Self::Lab => "lab",
        })
    }
}
