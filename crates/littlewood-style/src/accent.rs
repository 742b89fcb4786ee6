//! Colours for what has none of its own.

use crate::named::named;
use crate::rgb::Rgb;
use crate::theme::Theme;

named! {
    /// A colour that a picture gives a meaning for itself alone: no mode, class, force or curve has
    /// it.
    pub enum Accent {
        /// The first.
        Violet = "violet",
        /// The second.
        Teal = "teal",
        /// The third.
        Brown = "brown",
    }
}

impl Accent {
    /// Colour.
    pub const fn colour(self, theme: Theme) -> Rgb {
        match self {
            Self::Violet => theme.pick(0x693c99, 0x9a7fd1),
            Self::Teal => theme.pick(0x08828e, 0x35aab5),
            Self::Brown => theme.pick(0xb08163, 0xdcc0ae),
        }
    }
}
