//! Forces, impulses and the velocity of slip, as arrows and as curves against time.

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
    /// Impulse (J, P) of an impact.
    Impulse,
}

impl Arrow {
    /// All, in order.
    pub const ALL: [Self; 4] = [Self::NormalForce, Self::FrictionForce, Self::Slip, Self::Impulse];

    /// Lower-case name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::NormalForce => "normal_force",
            Self::FrictionForce => "friction_force",
            Self::Slip => "slip",
            Self::Impulse => "impulse",
        }
    }

    /// Colour.
    pub const fn colour(self, theme: Theme) -> Rgb {
        match self {
            Self::NormalForce => theme.pick(0x006d4e, 0x4fd1a1),
            Self::FrictionForce => theme.pick(0x9a1b6a, 0xfe79b7),
            Self::Slip => theme.pick(0x7f6100, 0xf0c44c),
            Self::Impulse => theme.pick(0xd7263d, 0xff4d4d),
        }
    }
}
