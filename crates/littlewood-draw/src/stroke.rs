//! Lines and letters, in the colours of [`littlewood_style`] on white paper.

use littlewood::Mode;
use littlewood_style::{Arrow, Curve, Dash, ImpulseLine, Ink, Rgb, Theme, dash_of, of_mode, width};

/// What figures are drawn on.
pub const THEME: Theme = Theme::Light;

/// The paper.
pub const PAPER: Rgb = Ink::Paper.colour(THEME);
/// Axes, letters.
pub const INK: Rgb = Ink::Ink.colour(THEME);
/// Letters and lines of less weight.
pub const SOFT: Rgb = Ink::Soft.colour(THEME);
/// Lines behind others.
pub const FAINT: Rgb = Ink::Faint.colour(THEME);
/// Grids.
pub const GRID: Rgb = Ink::Line.colour(THEME);
/// Outcomes that change more finely than a map tells.
pub const MIXED_OUTCOMES: Rgb = Ink::Mixed.colour(THEME);
/// Hatches.
pub const HATCH: Rgb = Ink::Hatch.colour(THEME);
/// Between regions of a plane.
pub const BOUNDARY: Stroke = Stroke::solid(INK, 0.6 * width::FINE);
/// The region 𝓡.
pub const REGION: Rgb = Ink::Region.colour(THEME);
/// Normal force, and the curve n.
pub const NORMAL_FORCE: Rgb = Arrow::NormalForce.colour(THEME);
/// Friction force, and the curve f.
pub const FRICTION_FORCE: Rgb = Arrow::FrictionForce.colour(THEME);
/// Impulse of an impact.
pub const IMPULSE: Rgb = Arrow::Impulse.colour(THEME);

/// A line.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Stroke {
    /// Colour.
    pub colour: Rgb,
    /// Width in pixels (1/96 inch).
    pub width: f64,
    /// Dashes.
    pub dash: Dash,
}

impl Stroke {
    /// A line without dashes.
    pub const fn solid(colour: Rgb, width: f64) -> Self {
        Self {
            colour,
            width,
            dash: Dash::Solid,
        }
    }

    /// A curve of the (θ, θ′) plane.
    pub const fn of_curve(curve: Curve) -> Self {
        Self {
            colour: curve.colour(THEME),
            width: curve.width(),
            dash: curve.dash(),
        }
    }

    /// A line of the plane of impulses.
    pub const fn of_impulse_line(line: ImpulseLine) -> Self {
        Self {
            colour: line.colour(THEME),
            width: line.width(),
            dash: line.dash(),
        }
    }

    /// A motion in a mode.
    pub const fn of_mode(mode: Mode) -> Self {
        Self {
            colour: of_mode(mode, THEME),
            width: width::CURVE,
            dash: dash_of(mode),
        }
    }

    /// The same with dashes.
    pub const fn dashed(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }

    /// Lengths of dashes and gaps in pixels; empty for a solid line.
    pub(crate) fn pattern(&self) -> impl Iterator<Item = f64> {
        self.dash.pattern().iter().map(|part| part * self.width)
    }

    /// The same of another width.
    pub const fn wide(self, width: f64) -> Self {
        Self { width, ..self }
    }
}

/// Size of letters in pixels.
pub const LETTER: f64 = 14.0;
/// Size of the letters of ticks.
pub const SMALL: f64 = 12.5;

/// Room for the labels of the two axes, in pixels.
pub const ROOM: [f64; 2] = [62.0, 46.0];

/// Length of a tick, in pixels.
pub const TICK: f64 = 4.0;
