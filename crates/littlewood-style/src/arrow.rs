//! Forces, impulses and the velocity of slip, as arrows and as curves against time.

use crate::named::named;
use crate::rgb::Rgb;
use crate::theme::Theme;

named! {
    /// A vector that pictures of the hoop show.
    pub enum Arrow {
        /// Normal force N.
        NormalForce = "normal_force",
        /// Friction force F.
        FrictionForce = "friction_force",
        /// Velocity of slip η′.
        Slip = "slip",
        /// Impulse (J, P) of an impact.
        Impulse = "impulse",
    }
}

impl Arrow {
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
