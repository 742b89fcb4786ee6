//! The parts into which the energy at the start goes.

use littlewood::energy::EnergyParts;

use crate::accent::Accent;
use crate::arrow::Arrow;
use crate::named::named;
use crate::rgb::Rgb;
use crate::theme::Theme;

named! {
    /// A part of the energy that a motion has had at its start, in the order in which they stand
    /// one upon the other: the potential energy may be negative. What is lost has the colour of
    /// what takes it.
    pub enum EnergyPart {
        /// Potential.
        Potential = "potential",
        /// Kinetic.
        Kinetic = "kinetic",
        /// Lost to friction in slip.
        Friction = "lost_to_friction",
        /// Lost to rolling resistance.
        RollingResistance = "lost_to_rolling_resistance",
        /// Lost in impacts.
        Impacts = "lost_in_impacts",
    }
}

impl EnergyPart {
    /// In words, for legends.
    pub const fn label(self) -> &'static str {
        match self {
            Self::Kinetic => "kinetic",
            Self::Potential => "potential",
            Self::Friction => "lost to friction",
            Self::RollingResistance => "lost to rolling resistance",
            Self::Impacts => "lost in impacts",
        }
    }

    /// The amount of this part.
    pub const fn of(self, parts: &EnergyParts) -> f64 {
        match self {
            Self::Kinetic => parts.kinetic,
            Self::Potential => parts.potential,
            Self::Friction => parts.friction,
            Self::RollingResistance => parts.rolling_resistance,
            Self::Impacts => parts.impacts,
        }
    }

    /// Colour.
    pub const fn colour(self, theme: Theme) -> Rgb {
        match self {
            Self::Kinetic => Accent::Teal.colour(theme),
            Self::Potential => Accent::Violet.colour(theme),
            Self::Friction => Arrow::FrictionForce.colour(theme),
            Self::RollingResistance => Accent::Brown.colour(theme),
            Self::Impacts => Arrow::Impulse.colour(theme),
        }
    }
}
