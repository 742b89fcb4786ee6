//! Curves of the (θ, θ′) plane.

use crate::arrow::Arrow;
use crate::dash::Dash;
use crate::ink::Ink;
use crate::rgb::Rgb;
use crate::theme::Theme;
use crate::width::{BOLD, CURVE, FINE};

/// A curve of the (θ, θ′) plane. A limit of a force has the colour of the force.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Curve {
    /// f: static friction gives way in rolling, |F| = μs N (2.13, 3.9).
    SlipLimit,
    /// n: N = 0 in rolling (3.8).
    NormalForceZero,
    /// Through the unstable equilibrium; without inertia its stable and unstable manifold.
    Separatrix,
    /// h cos θ θ′² = 1: N = 0 in sliding, beyond which the body leaves the plane (2.18).
    LiftOff,
    /// Constant energy in rolling.
    Level,
}

impl Curve {
    /// All, in order.
    pub const ALL: [Self; 5] =
        [Self::SlipLimit, Self::NormalForceZero, Self::Separatrix, Self::LiftOff, Self::Level];

    /// Lower-case name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::SlipLimit => "slip_limit",
            Self::NormalForceZero => "normal_force_zero",
            Self::Separatrix => "separatrix",
            Self::LiftOff => "lift_off",
            Self::Level => "level",
        }
    }

    /// The letter of the paper, for those that have one.
    #[must_use]
    pub const fn letter(self) -> Option<&'static str> {
        match self {
            Self::SlipLimit => Some("f"),
            Self::NormalForceZero => Some("n"),
            Self::Separatrix | Self::LiftOff | Self::Level => None,
        }
    }

    /// In words, for legends.
    #[must_use]
    pub const fn label(self) -> &'static str {
        match self {
            Self::SlipLimit => "f: |F| = μₛ N in rolling",
            Self::NormalForceZero => "n: N = 0 in rolling",
            Self::Separatrix => "separatrix",
            Self::LiftOff => "lift-off: h cos θ θ′² = 1",
            Self::Level => "constant energy",
        }
    }

    /// Colour.
    #[must_use]
    pub const fn colour(self, theme: Theme) -> Rgb {
        match self {
            Self::SlipLimit => Arrow::FrictionForce.colour(theme),
            Self::NormalForceZero | Self::LiftOff => Arrow::NormalForce.colour(theme),
            Self::Separatrix => Ink::Ink.colour(theme),
            Self::Level => Ink::Faint.colour(theme),
        }
    }

    /// Dashes.
    #[must_use]
    pub const fn dash(self) -> Dash {
        match self {
            Self::SlipLimit => Dash::Dashed,
            Self::LiftOff => Dash::Short,
            Self::NormalForceZero | Self::Separatrix | Self::Level => Dash::Solid,
        }
    }

    /// Width in pixels of 1/96 inch.
    #[must_use]
    pub const fn width(self) -> f64 {
        match self {
            Self::SlipLimit | Self::NormalForceZero => BOLD,
            Self::Separatrix | Self::LiftOff => CURVE,
            Self::Level => FINE,
        }
    }
}
