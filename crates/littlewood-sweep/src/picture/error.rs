//! What is wrong with a picture.

use littlewood::SummaryColumn;
use thiserror::Error;

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
    /// The drawing library refuses. No input is known that does this.
    #[error("cannot draw: {0}")]
    Drawing(String),
}

impl PictureError {
    /// Of the drawing library.
    pub(super) fn drawing<E: core::fmt::Display>(error: E) -> Self {
        Self::Drawing(error.to_string())
    }
}
