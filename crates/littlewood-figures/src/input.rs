//! What a figure is made of: a hoop, a start, limits.

use littlewood::si::Units;
use littlewood::theory::{Body, Massless};
use littlewood::{Hoop, Limits, Start};
use littlewood_draw::{Content, Entries, Figure, ROOM, Sheet};

use crate::error::FigureError;
use crate::motion::Shown;
use crate::wording::Wording;

/// Width of the sheet and height of the panel of a figure of the plane, on a screen.
const PLANE: [f64; 2] = [580.0, 402.0];

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
    /// Units, if axes and values are in seconds, metres and newtons.
    pub units: Option<Units>,
    /// Width in print, in millimetres, from [`crate::LEAST_WIDTH_MM`] to [`crate::MOST_WIDTH_MM`];
    /// for a screen if there is none.
    pub width_mm: Option<f64>,
}

impl FigureInput {
    /// The hoop and the start of a named case, to the final outcome.
    ///
    /// # Errors
    /// A name that no case has.
    pub fn of_case(name: &str) -> Result<Self, FigureError> {
        let case = littlewood::cases::find_case(name).ok_or_else(|| FigureError::UnknownCase {
            name: name.to_owned(),
        })?;
        Ok(Self::new(
            Hoop::new(case.setup.hoop)?,
            case.setup.start,
            Limits::default(),
        ))
    }

    /// A hoop and a start; of the impacts the first.
    #[must_use]
    pub const fn new(hoop: Hoop, start: Start, limits: Limits) -> Self {
        Self {
            hoop,
            start,
            limits,
            impact: 1,
            units: None,
            width_mm: None,
        }
    }

    /// How numbers are said.
    pub(crate) const fn wording(&self) -> Wording {
        Wording { units: self.units }
    }

    /// The hoop and the start, in words.
    pub(crate) fn in_words(&self) -> String {
        let say = self.wording();
        format!(
            "{}; {}",
            say.hoop(&self.hoop),
            say.start(&self.hoop, &self.start)
        )
    }

    /// A figure of a part of the plane (θ, θ′), or of one like it.
    pub(crate) fn plane(
        &self,
        name: &'static str,
        title: &str,
        caption: String,
        content: Content,
        entries: Entries,
    ) -> Result<Figure, FigureError> {
        let [width, height] = PLANE;
        Ok(self
            .sheet(width)?
            .plot(name, title, caption, height, content, entries))
    }

    /// Width and height between the axes of such a figure, in pixels.
    pub(crate) fn plane_size(&self) -> Result<[f64; 2], FigureError> {
        let [width, height] = PLANE;
        let sheet = self.sheet(width)?;
        let [_, inner] = sheet.span();
        Ok([inner - ROOM[0], sheet.height(height) - ROOM[1]])
    }

    /// The sheet, so wide on a screen.
    pub(crate) fn sheet(&self, width: f64) -> Result<Sheet, FigureError> {
        Ok(Sheet::new(self.width_mm, width)?)
    }

    /// The motion.
    pub(crate) fn motion(&self, figure: &'static str) -> Result<Shown, FigureError> {
        let motion = self.hoop.simulate(self.start, self.limits)?;
        if motion.phases().is_empty() {
            return Err(FigureError::NoMotion {
                figure,
                outcome: motion.outcome().kind(),
            });
        }
        let time = motion.start().time;
        if motion.end_time() <= time {
            return Err(FigureError::NoDuration {
                figure,
                time,
                outcome: motion.outcome().kind(),
            });
        }
        Ok(Shown::new(motion, self.wording()))
    }

    pub(crate) const fn is_massless(&self) -> bool {
        matches!(self.hoop.body(), Body::Massless(_))
    }

    /// Refuses a massless hoop.
    pub(crate) fn heavy(&self, figure: &'static str) -> Result<(), FigureError> {
        if self.is_massless() {
            Err(FigureError::NeedsInertia { figure })
        } else {
            Ok(())
        }
    }

    /// Refuses a massless hoop, and one that is not loaded.
    pub(crate) fn with_inertia(&self, figure: &'static str) -> Result<(), FigureError> {
        self.heavy(figure)?;
        self.loaded(figure)
    }

    /// Refuses a hoop that is not loaded.
    pub(crate) fn loaded(&self, figure: &'static str) -> Result<(), FigureError> {
        if self.hoop.offset() == 0.0 {
            Err(FigureError::NeedsOffset { figure })
        } else {
            Ok(())
        }
    }

    /// The motion, if it touches the plane for a while, or hits it.
    pub(crate) fn motion_in_contact(&self, figure: &'static str) -> Result<Shown, FigureError> {
        let motion = self.motion(figure)?;
        let touches = motion.phases().iter().any(|it| it.mode().touches_plane());
        if touches || motion.transitions().iter().any(|it| it.impact.is_some()) {
            Ok(motion)
        } else {
            Err(FigureError::NoContact {
                figure,
                outcome: motion.outcome().kind(),
            })
        }
    }

    /// Refuses all but Littlewood's hoop with static friction and without rolling resistance.
    pub(crate) fn littlewood_that_rolls(
        &self,
        figure: &'static str,
    ) -> Result<Massless, FigureError> {
        let body = self.littlewood(figure)?;
        self.level(figure)?;
        let resistance = self.hoop.rolling_resistance();
        if resistance > 0.0 {
            return Err(FigureError::NeedsNoResistance { figure, resistance });
        }
        if self.hoop.mu_s() > 0.0 {
            Ok(body)
        } else {
            Err(FigureError::NeedsStaticFriction { figure })
        }
    }

    /// Refuses a hoop with inertia.
    pub(crate) fn massless(&self, figure: &'static str) -> Result<Massless, FigureError> {
        let (mass_ratio, inertia) = (self.hoop.mass_ratio(), self.hoop.inertia());
        match self.hoop.body() {
            Body::Massless(body) => Ok(body),
            Body::Heavy(_) => Err(FigureError::NeedsMassless {
                figure,
                mass_ratio,
                inertia,
            }),
        }
    }

    /// Refuses a slope.
    pub(crate) fn level(&self, figure: &'static str) -> Result<(), FigureError> {
        match self.hoop.slope() {
            0.0 => Ok(()),
            slope => Err(FigureError::NeedsLevel { figure, slope }),
        }
    }

    /// Refuses all but Littlewood's hoop.
    pub(crate) fn littlewood(&self, figure: &'static str) -> Result<Massless, FigureError> {
        let (body, offset) = (self.massless(figure)?, self.hoop.offset());
        if offset == 1.0 {
            Ok(body)
        } else {
            Err(FigureError::NeedsRim { figure, offset })
        }
    }
}
