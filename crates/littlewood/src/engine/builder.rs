//! Engines for as many starts as are expected, and the summaries of many.

use thiserror::Error;

use super::Engine;
use crate::model::{Hoop, Limits, ParameterError, Start};
use crate::motion::summary::Summary;

/// Starts of one hoop from which on motions use its tables from their first phase on.
const MANY: u64 = 256;

/// Starts of one hoop from which on slides out of rolling are interpolated, and chains of slips from
/// the first slip of a motion on: what is prepared costs as much as so many motions.
const MANY_FOR_MAPS: u64 = 4_096;

/// With fewer starts, phases of a motion before its slips are interpolated: few motions have more,
/// and those have thousands.
const PHASES_BEFORE_LINKS: u32 = 128;

/// Makes an [`Engine`] for as many starts of a hoop as are expected.
///
/// ```
/// use littlewood::{Engine, Hoop};
///
/// let hoop = Hoop::equal_masses(0.5, 0.4)?;
/// // Where each start has its own hoop, only long motions use tables.
/// assert!(!Engine::builder(&hoop).expected_starts(1).prepares());
/// assert!(Engine::builder(&hoop).expected_starts(40_000).prepares());
/// # Ok::<(), littlewood::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
#[must_use]
pub struct EngineBuilder {
    hoop: Hoop,
    starts: u64,
    interpolates_slips: bool,
}

impl EngineBuilder {
    /// For so many starts: many, if it is not called. The number changes how long summaries take,
    /// and their last digits.
    pub const fn expected_starts(self, starts: u64) -> Self {
        Self { starts, ..self }
    }

    /// Interpolates chains of slips: a motion that slips out of rolling a thousand times takes as
    /// long as one of some twenty phases, or of 128 where fewer than 4,096 starts are expected, for
    /// which maps of short motions would not pay. It has no effect on an engine for few starts,
    /// without kinetic friction, with rolling resistance, on a hoop that is simulated, or on motions
    /// that are limited to fewer than 256 transitions.
    ///
    /// The promise is weaker. The map from one slip to the next is interpolated between starts that
    /// were computed, and accepted where the starts halfway between them agree: nothing is proved
    /// in between. A phase that appears and vanishes between two neighbours would be missed, and
    /// with it an outcome. The tests search for such a motion, and have found none.
    ///
    /// ```
    /// use littlewood::{Engine, Hoop};
    ///
    /// let hoop = Hoop::equal_masses(0.5, 0.499)?;
    /// assert!(!Engine::new(&hoop).interpolates_slips());
    /// assert!(Engine::builder(&hoop).interpolate_slips().build().interpolates_slips());
    /// # Ok::<(), littlewood::ParameterError>(())
    /// ```
    pub const fn interpolate_slips(self) -> Self {
        Self {
            interpolates_slips: true,
            ..self
        }
    }

    /// Whether so many starts use tables from the first phase on.
    pub const fn prepares(&self) -> bool {
        self.starts >= MANY
    }

    /// The engine.
    pub fn build(self) -> Engine {
        if !self.prepares() {
            return Engine::for_few_starts(&self.hoop);
        }
        let is_worth_maps = self.starts >= MANY_FOR_MAPS;
        let engine = Engine {
            interpolates_slides: is_worth_maps,
            ..Engine::new(&self.hoop)
        };
        if self.interpolates_slips {
            engine.with_slip_maps(if is_worth_maps {
                0
            } else {
                PHASES_BEFORE_LINKS
            })
        } else {
            engine
        }
    }
}

/// A start of many that is refused, with the limits of its motion.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[error("start {index}: {error}")]
#[non_exhaustive]
pub struct StartError {
    /// Its place among the starts, from 0 on.
    pub index: usize,
    /// Why it is refused.
    pub error: ParameterError,
}

impl Engine {
    /// An engine for as many starts as are expected; [`Engine::new`] is for many.
    pub const fn builder(hoop: &Hoop) -> EngineBuilder {
        EngineBuilder {
            hoop: *hoop,
            starts: u64::MAX,
            interpolates_slips: false,
        }
    }

    /// The summaries of many starts, one after the other, as [`Engine::summary`] makes them.
    ///
    /// ```
    /// use littlewood::many::StartError;
    /// use littlewood::{Engine, Hoop, Limits, Start, Summary};
    ///
    /// let engine = Engine::new(&Hoop::equal_masses(0.5, 0.4)?);
    /// let starts = [Start::at(1.0, 2.0), Start::at(1.0, f64::NAN)];
    /// let summaries: Vec<Result<Summary, StartError>> = engine.summaries(starts, Limits::default()).collect();
    /// assert!(summaries[0].is_ok());
    /// assert_eq!(summaries[1].map_err(|refused| refused.index), Err(1));
    /// # Ok::<(), littlewood::ParameterError>(())
    /// ```
    pub fn summaries<I: IntoIterator<Item = Start>>(
        &self,
        starts: I,
        limits: Limits,
    ) -> impl Iterator<Item = Result<Summary, StartError>> + use<'_, I> {
        starts.into_iter().enumerate().map(move |(index, start)| {
            self.summary(start, limits)
                .map_err(|error| StartError { index, error })
        })
    }
}
