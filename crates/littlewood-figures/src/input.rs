//! What a figure is made of: a hoop, a start, limits.

use littlewood::{Body, Engine, Hoop, Limits, Start, Summary, Trajectory, Units};
use littlewood_sweep::Axis;

use crate::axes::outcome_window;
use crate::error::FigureError;
use crate::sheet::Sheet;
use crate::wording::Wording;

/// Transitions to which the motions of a very light hoop are followed where there are many of them, and those of a hoop whose
/// motions have more than these.
const LIGHT_TRANSITIONS: usize = 24;
const LONG_TRANSITIONS: usize = 100;
/// Starts to either side of the plane from which that is known, and how many of them do not matter.
const PROBES: u32 = 8;
const FEW: usize = 1;
/// Hoops that are better balanced, by h, are simulated though they are not light.
const BALANCED: f64 = 1e-3;

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
        let case =
            littlewood::find_case(name).ok_or_else(|| FigureError::UnknownCase { name: name.to_owned() })?;
        Ok(Self::new(Hoop::new(case.setup.hoop)?, case.setup.start, Limits::default()))
    }

    /// A hoop and a start; of the impacts the first.
    #[must_use]
    pub const fn new(hoop: Hoop, start: Start, limits: Limits) -> Self {
        Self { hoop, start, limits, impact: 1, along: None, units: None, width_mm: None }
    }

    /// The limits of each of many motions, and the number of transitions at which they cut what would go on: motions of very light
    /// hoops have thousands of phases, each of which is simulated, and so have those of hoops that hardly lose energy.
    pub(crate) fn limits_of_many(&self, engine: &Engine) -> (Limits, Option<usize>) {
        let most = if self.is_massless() {
            usize::MAX
        } else if engine.is_exact() && self.hoop.h() > BALANCED && self.hoop.mu_k() > 0.0 {
            LIGHT_TRANSITIONS
        } else if self.are_long(engine) {
            LONG_TRANSITIONS
        } else {
            usize::MAX
        };
        let limits = self.limits;
        if limits.transitions > most { (limits.with_transitions(most), Some(most)) } else { (limits, None) }
    }

    /// Whether some motions of a hoop have many transitions.
    fn are_long(&self, engine: &Engine) -> bool {
        let window = outcome_window(&self.hoop);
        let limits = self.limits.with_transitions(LONG_TRANSITIONS);
        let at = |range: [f64; 2], i: u32| {
            range[0] + (range[1] - range[0]) * (f64::from(i) + 0.5) / f64::from(PROBES)
        };
        let starts = (0..PROBES).flat_map(|i| (0..PROBES).map(move |j| [i, j]));
        let starts = starts.map(|[i, j]| Start::at(at(window.x, i), at(window.y, j)));
        let summaries = starts.filter_map(|start| engine.summary(start, limits).ok());
        // What comes after the lift-off decides nothing.
        let is_long = |summary: &Summary| {
            summary.lift_off_time.is_nan() && summary.transitions as usize >= LONG_TRANSITIONS
        };
        summaries.filter(is_long).count() > FEW
    }

    /// How numbers are said.
    pub(crate) const fn wording(&self) -> Wording {
        Wording::new(self.units)
    }

    /// The sheet, so wide on a screen.
    pub(crate) fn sheet(&self, width: f64) -> Result<Sheet, FigureError> {
        Sheet::new(self.width_mm, width)
    }

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

    /// Refuses all but Littlewood's hoop.
    pub(crate) fn littlewood(&self, figure: &'static str) -> Result<(), FigureError> {
        self.massless(figure)?;
        let offset = self.hoop.offset();
        if offset == 1.0 { Ok(()) } else { Err(FigureError::NeedsRim { figure, offset }) }
    }
}
