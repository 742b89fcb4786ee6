//! Light and dark paper.

use crate::rgb::Rgb;

/// What a picture is drawn on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Theme {
    /// Dark on white.
    #[default]
    Light,
    /// Light on black.
    Dark,
}

impl Theme {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Light, Self::Dark];

    /// Lower-case name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Light => "light",
            Self::Dark => "dark",
        }
    }

    /// One of two colours.
    pub(crate) const fn pick(self, light: u32, dark: u32) -> Rgb {
        match self {
            Self::Light => Rgb::of_hex(light),
            Self::Dark => Rgb::of_hex(dark),
        }
    }
}
