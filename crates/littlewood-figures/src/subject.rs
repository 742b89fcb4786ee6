//! What a figure is of: a hoop, a start, limits.

use littlewood::{Body, Hoop, Limits, ParameterError, Start, Trajectory};

use crate::error::FigureError;

/// A hoop and a motion of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Subject {
    /// Hoop.
    pub hoop: Hoop,
    /// Start of the motion, for figures that show one.
    pub start: Start,
    /// Where it is stopped.
    pub limits: Limits,
}

impl Subject {
    /// The motion.
    pub(crate) fn motion(&self, figure: &'static str) -> Result<Trajectory, FigureError> {
        let motion = self.hoop.simulate(self.start, self.limits)?;
        if motion.phases().is_empty() {
            return Err(FigureError::NoMotion { figure, outcome: motion.outcome().kind() });
        }
        Ok(motion)
    }

    pub(crate) const fn is_massless(&self) -> bool {
        matches!(self.hoop.body(), Body::Massless(_))
    }

    /// Refuses a massless hoop, and one that is not loaded.
    pub(crate) fn with_inertia(&self, figure: &'static str) -> Result<(), FigureError> {
        if self.is_massless() {
            return Err(FigureError::NeedsInertia { figure });
        }
        self.loaded(figure)
    }

    /// Refuses a hoop that is not loaded.
    pub(crate) fn loaded(&self, figure: &'static str) -> Result<(), FigureError> {
        if self.hoop.offset() == 0.0 { Err(FigureError::NeedsOffset { figure }) } else { Ok(()) }
    }

    /// Refuses all but Littlewood's hoop.
    pub(crate) fn littlewood(&self, figure: &'static str) -> Result<(), FigureError> {
        if !self.is_massless() {
            return Err(FigureError::NeedsMassless {
                figure,
                mass_ratio: self.hoop.mass_ratio(),
                inertia: self.hoop.inertia(),
            });
        }
        let offset = self.hoop.offset();
        if offset == 1.0 { Ok(()) } else { Err(FigureError::NeedsRim { figure, offset }) }
    }
}

/// The subject of a named case.
pub(crate) fn of_case(name: &str) -> Result<Subject, ParameterError> {
    let case = littlewood::find_case(name).unwrap_or(&littlewood::CASES[0]);
    Ok(Subject { hoop: Hoop::new(case.hoop)?, start: case.start, limits: Limits::default() })
}
