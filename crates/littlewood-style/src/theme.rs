//! Light and dark paper.

use crate::named::named;
use crate::rgb::Rgb;

named! {
    /// What a picture is drawn on.
    #[derive(Default)]
    pub enum Theme {
        /// Dark on white.
        #[default]
        Light = "light",
        /// Light on black.
        Dark = "dark",
    }
}

impl Theme {
    /// One of two colours.
    pub(crate) const fn pick(self, light: u32, dark: u32) -> Rgb {
        match self {
            Self::Light => Rgb::of_hex(light),
            Self::Dark => Rgb::of_hex(dark),
        }
    }
}
