//! One hoop prepared for many starts.

use crate::error::ParameterError;
use crate::hoop::Hoop;
use crate::simulate::Limits;
use crate::state::Start;
use crate::summary::Summary;

/// A hoop prepared for many motions: what depends on the body and the friction alone is computed once.
#[derive(Clone, Debug)]
pub struct Engine {
    hoop: Hoop,
}

impl Engine {
    /// Prepares a hoop.
    #[must_use]
    pub fn new(hoop: &Hoop) -> Self {
        Self { hoop: *hoop }
    }

    /// The hoop.
    #[must_use]
    pub const fn hoop(&self) -> &Hoop {
        &self.hoop
    }

    /// The summary of one motion: that of [`Hoop::simulate`].
    ///
    /// # Errors
    /// As [`Hoop::simulate`].
    pub fn summary(&self, start: Start, limits: Limits) -> Result<Summary, ParameterError> {
        Ok(self.hoop.simulate(start, limits)?.summary())
    }
}
