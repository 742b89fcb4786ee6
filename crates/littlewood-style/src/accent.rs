//! Colours for what has none of its own.

use crate::rgb::Rgb;
use crate::theme::Theme;

/// A colour that a picture gives a meaning for itself alone: no mode, class, force or curve has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Accent {
    /// The first.
    Violet,
    /// The second.
    Teal,
    /// The third.
    Brown,
}

impl Accent {
    /// All, in order.
    pub const ALL: [Self; 3] = [Self::Violet, Self::Teal, Self::Brown];

    /// Lower-case name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Violet => "violet",
            Self::Teal => "teal",
            Self::Brown => "brown",
        }
    }

    /// Colour.
    pub const fn colour(self, theme: Theme) -> Rgb {
        match self {
            Self::Violet => theme.pick(0x693c99, 0x9a7fd1),
            Self::Teal => theme.pick(0x08828e, 0x35aab5),
            Self::Brown => theme.pick(0xb08163, 0xdcc0ae),
        }
    }
}
