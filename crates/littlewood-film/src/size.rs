//! The size of a picture.

use core::fmt;
use core::ops::RangeInclusive;

use thiserror::Error;

/// Shortest and longest side.
pub(crate) const SIDES: RangeInclusive<u32> = 160..=4096;

/// A side that is too short to read, or too long.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("size = {size} px: both sides must be between {} and {} px", SIDES.start(), SIDES.end())]
pub struct SizeError {
    /// The size that was asked for.
    pub size: FrameSize,
}

/// Size in pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameSize {
    width: u32,
    height: u32,
}

impl FrameSize {
    /// A size of 160 to 4096 pixels each way.
    ///
    /// # Errors
    /// A side outside these bounds.
    pub fn new(width: u32, height: u32) -> Result<Self, SizeError> {
        let size = Self { width, height };
        if SIDES.contains(&width) && SIDES.contains(&height) {
            Ok(size)
        } else {
            Err(SizeError { size })
        }
    }

    /// Width.
    pub const fn width(self) -> u32 {
        self.width
    }

    /// Height.
    pub const fn height(self) -> u32 {
        self.height
    }

    /// Number of pixels.
    pub(crate) const fn area(self) -> usize {
        self.width as usize * self.height as usize
    }

    /// The unit in which lettering and line widths are measured: a pixel at 640 × 360.
    pub(crate) fn unit(self) -> f64 {
        (f64::from(self.width) / 640.0).min(f64::from(self.height) / 360.0)
    }
}

impl Default for FrameSize {
    fn default() -> Self {
        Self {
            width: 640,
            height: 360,
        }
    }
}

impl fmt::Display for FrameSize {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}x{}", self.width, self.height)
    }
}
