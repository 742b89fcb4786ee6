//! Forces and the velocity of slip, as arrows and as curves against time.

use crate::rgb::Rgb;
use crate::theme::Theme;

/// A vector that pictures of the hoop show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Arrow {
    /// Normal force N.
    NormalForce,
    /// Friction force F.
    FrictionForce,
    /// Velocity of slip η′.
    Slip,
}

impl Arrow {
    /// All, in order.
    pub const ALL: [Self; 3] = [Self::NormalForce, Self::FrictionForce, Self::Slip];

    /// Lower-case name.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::NormalForce => "normal_force",
            Self::FrictionForce => "friction_force",
            Self::Slip => "slip",
        }
    }

    /// Colour.
    #[must_use]
    pub const fn colour(self, theme: Theme) -> Rgb {
        match self {
            Self::NormalForce => theme.pick(0x006d4e, 0x4fd1a1),
            Self::FrictionForce => theme.pick(0x9a1b6a, 0xfe79b7),
            Self::Slip => theme.pick(0x7f6100, 0xf0c44c),
        }
    }
}
