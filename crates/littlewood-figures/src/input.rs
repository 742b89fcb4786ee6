//! What a figure is made of: a hoop, a start, limits.

use littlewood::si::Units;
use littlewood::theory::Body;
use littlewood::{Hoop, Limits, Start, Trajectory};
use littlewood_draw::Sheet;
use littlewood_sweep::Axis;

use crate::error::FigureError;
use crate::wording::Wording;

/// A hoop and a motion of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FigureInput {
    /// Hoop.
    pub hoop: Hoop,
    /// Start of the motion, for figures that show one.
    pub start: Start,
    /// Where it is stopped.
    pub limits: Limits,
    /// Which impact of the motion is shown, from 1, by the figure that shows one.
    pub impact: usize,
    /// The line of the figure that shows how a motion changes along one, by its ends: a quantity of the start or of the hoop; a
    /// rate at the start if there is none.
    pub along: Option<Axis>,
    /// Units, if axes and values are in seconds, metres and newtons.
    pub units: Option<Units>,
    /// Width in print, in millimetres, from [`crate::LEAST_WIDTH_MM`] to [`crate::MOST_WIDTH_MM`]; for a screen if there is
    /// none.
    pub width_mm: Option<f64>,
}

impl FigureInput {
    /// The hoop and the start of a named case, to the final outcome.
    ///
    /// # Errors
    /// A name that no case has.
    pub fn of_case(name: &str) -> Result<Self, FigureError> {
        let case = littlewood::cases::find_case(name)
            .ok_or_else(|| FigureError::UnknownCase { name: name.to_owned() })?;
        Ok(Self::new(Hoop::new(case.setup.hoop)?, case.setup.start, Limits::default()))
    }

    /// A hoop and a start; of the impacts the first.
    #[must_use]
    pub const fn new(hoop: Hoop, start: Start, limits: Limits) -> Self {
        Self { hoop, start, limits, impact: 1, along: None, units: None, width_mm: None }
    }

    /// How numbers are said.
    pub(crate) const fn wording(&self) -> Wording {
        Wording::new(self.units)
    }

    /// The sheet, so wide on a screen.
    pub(crate) fn sheet(&self, width: f64) -> Result<Sheet, FigureError> {
        Ok(Sheet::new(self.width_mm, width)?)
    }

    /// The motion.
    pub(crate) fn motion(&self, figure: &'static str) -> Result<Trajectory, FigureError> {
        let motion = self.hoop.simulate(self.start, self.limits)?;
        if motion.phases().is_empty() {
            return Err(FigureError::NoMotion { figure, outcome: motion.outcome().kind() });
        }
        let time = motion.start().time;
        if motion.end_time() <= time {
            return Err(FigureError::NoDuration { figure, time, outcome: motion.outcome().kind() });
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

    /// The motion, if it touches the plane for a while, or hits it.
    pub(crate) fn motion_in_contact(&self, figure: &'static str) -> Result<Trajectory, FigureError> {
        let motion = self.motion(figure)?;
        let touches = motion.phases().iter().any(|phase| phase.mode().touches_plane());
        if touches || motion.transitions().iter().any(|transition| transition.impact.is_some()) {
            Ok(motion)
        } else {
            Err(FigureError::NoContact { figure, outcome: motion.outcome().kind() })
        }
    }

    /// Refuses all but Littlewood's hoop with static friction.
    pub(crate) fn littlewood_that_rolls(&self, figure: &'static str) -> Result<(), FigureError> {
        self.littlewood(figure)?;
        self.level(figure)?;
        if self.hoop.mu_s() > 0.0 { Ok(()) } else { Err(FigureError::NeedsStaticFriction { figure }) }
    }

    /// Refuses a hoop with inertia.
    pub(crate) fn massless(&self, figure: &'static str) -> Result<(), FigureError> {
        if self.is_massless() {
            return Ok(());
        }
        Err(FigureError::NeedsMassless {
            figure,
            mass_ratio: self.hoop.mass_ratio(),
            inertia: self.hoop.inertia(),
        })
    }

    /// Refuses a slope.
    pub(crate) fn level(&self, figure: &'static str) -> Result<(), FigureError> {
        match self.hoop.slope() {
            0.0 => Ok(()),
            slope => Err(FigureError::NeedsLevel { figure, slope }),
        }
    }

    /// Refuses all but Littlewood's hoop.
    pub(crate) fn littlewood(&self, figure: &'static str) -> Result<(), FigureError> {
        self.massless(figure)?;
        let offset = self.hoop.offset();
        if offset == 1.0 { Ok(()) } else { Err(FigureError::NeedsRim { figure, offset }) }
    }
}
