//! Lines of the plane of impulses (J, P): Routh's diagram of an impact.

use crate::arrow::Arrow;
use crate::dash::Dash;
use crate::ink::Ink;
use crate::named::named;
use crate::rgb::Rgb;
use crate::theme::Theme;
use crate::width::{CURVE, FINE};

named! {
    /// A line of the plane of impulses. A limit of friction has the colour of the friction force,
    /// the line without slip that of the slip.
    pub enum ImpulseLine {
        /// u = 0.
        Sticking = "sticking",
        /// w = 0.
        Compression = "greatest_compression",
        /// Where the law of restitution ends the impact.
        Termination = "termination",
        /// |J| = μs P.
        StaticCone = "static_cone",
        /// |J| = μk P.
        KineticCone = "kinetic_cone",
    }
}

impl ImpulseLine {
    /// In words, for legends.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Sticking => "sticking: u = 0",
            Self::Compression => "greatest compression: w = 0",
            Self::Termination => "termination",
            Self::StaticCone => "friction cone: |J| = μₛ P",
            Self::KineticCone => "friction cone: |J| = μₖ P",
        }
    }

    /// Colour.
    pub const fn colour(self, theme: Theme) -> Rgb {
        match self {
            Self::Sticking => Arrow::Slip.colour(theme),
            Self::Compression | Self::Termination => Ink::Ink.colour(theme),
            Self::StaticCone | Self::KineticCone => Arrow::FrictionForce.colour(theme),
        }
    }

    /// Dashes.
    pub const fn dash(self) -> Dash {
        match self {
            Self::Sticking => Dash::DashDot,
            Self::Compression | Self::StaticCone => Dash::Dashed,
            Self::Termination => Dash::Solid,
            Self::KineticCone => Dash::Dotted,
        }
    }

    /// Width in pixels of 1/96 inch.
    pub const fn width(self) -> f64 {
        match self {
            Self::Sticking | Self::Compression | Self::StaticCone | Self::KineticCone => CURVE,
            Self::Termination => FINE,
        }
    }
}
