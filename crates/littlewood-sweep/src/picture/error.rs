//! What is wrong with a picture.

use littlewood::tables::{DerivativeColumn, SummaryColumn};
use thiserror::Error;

/// What is wrong with a picture.
#[derive(Debug, Error)]
#[expect(
    missing_docs,
    reason = "the message of each says what it and its fields are"
)]
pub enum PictureError {
    #[error("a map has 2 axes, this grid has {found}")]
    NotTwoAxes { found: usize },
    #[error(
        "a map cannot shade {column}, which is not a number; it can shade {}",
        SummaryColumn::numbers().map(SummaryColumn::name).collect::<Vec<_>>().join(", ")
    )]
    NoNumber { column: SummaryColumn },
    #[error("a map cannot shade {column}, which its grid does not compute")]
    NotComputed { column: DerivativeColumn },
    #[error(
        "the curves f and n are those of the plane of theta and theta_rate of one hoop without slip; of this map {reason}"
    )]
    NoCurves { reason: &'static str },
    #[error("a picture of {width} x {height} pixels: each side must be from {least} to {most}")]
    Size {
        width: u32,
        height: u32,
        least: u32,
        most: u32,
    },
}
