//! The parts into which the energy at the start goes.

use crate::accent::Accent;
use crate::arrow::Arrow;
use crate::rgb::Rgb;
use crate::theme::Theme;

/// A part of the energy that a motion has had at its start. What is lost has the colour of what takes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum EnergyPart {
    /// Kinetic.
    Kinetic,
    /// Potential.
    Potential,
    /// Lost to friction in sliding.
    Friction,
    /// Lost in impacts.
    Impacts,
}

impl EnergyPart {
    /// All, in order.
    pub const ALL: [Self; 4] = [Self::Kinetic, Self::Potential, Self::Friction, Self::Impacts];

    /// Lower-case name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Kinetic => "kinetic",
            Self::Potential => "potential",
            Self::Friction => "lost_to_friction",
            Self::Impacts => "lost_in_impacts",
        }
    }

    /// In words, for legends.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Kinetic => "kinetic",
            Self::Potential => "potential",
            Self::Friction => "lost to friction",
            Self::Impacts => "lost in impacts",
        }
    }

    /// Colour.
    pub const fn colour(self, theme: Theme) -> Rgb {
        match self {
            Self::Kinetic => Accent::Violet.colour(theme),
            Self::Potential => Accent::Teal.colour(theme),
            Self::Friction => Arrow::FrictionForce.colour(theme),
            Self::Impacts => Arrow::Impulse.colour(theme),
        }
    }
}
