//! What is wrong with a picture.

use littlewood::tables::{DerivativeColumn, SummaryColumn};
use thiserror::Error;

use super::shade::Shade;

/// What is wrong with a picture.
#[derive(Debug, Error)]
pub enum PictureError {
    /// A map needs two axes.
    #[error("a map has 2 axes, this grid has {found}")]
    NotTwoAxes {
        /// Number of axes.
        found: usize,
    },
    /// A scale of colours needs numbers.
    #[error(
        "a map cannot shade {column}, which is not a number; it can shade {}",
        SummaryColumn::numbers().map(SummaryColumn::name).collect::<Vec<_>>().join(", ")
    )]
    NoNumber {
        /// The column.
        column: SummaryColumn,
    },
    /// A derivative is shown where it is computed.
    #[error("a map cannot shade {column}, which its grid does not compute")]
    NotComputed {
        /// The derivative.
        column: DerivativeColumn,
    },
    /// Lines of constant value need a scale.
    #[error("a map of {} has no scale, and so no lines of constant value", shade.name())]
    NoScale {
        /// What is shown.
        shade: Shade,
    },
    /// The curves f and n belong to the phase plane of rolling.
    #[error(
        "the curves f and n are those of the plane of theta and theta_rate of one hoop without slip; of this map {reason}"
    )]
    NoCurves {
        /// What stands in the way.
        reason: &'static str,
    },
    /// Too small to draw in, or too large to hold.
    #[error("a picture of {width} x {height} pixels: each side must be from {least} to {most}")]
    Size {
        /// Width in pixels.
        width: u32,
        /// Height in pixels.
        height: u32,
        /// Smallest side.
        least: u32,
        /// Largest side.
        most: u32,
    },
}
