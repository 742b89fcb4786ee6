//! Colours of what is not data: paper, letters, axes, the ground.

use crate::named::named;
use crate::rgb::Rgb;
use crate::theme::Theme;

named! {
    /// A colour for lines and areas that mean no mode, class or force.
    pub enum Ink {
        /// The background.
        Paper = "paper",
        /// Letters, axes, the body.
        Ink = "ink",
        /// Letters and lines of less weight.
        Soft = "soft",
        /// Lines of the least weight.
        Faint = "faint",
        /// Grids, frames, earlier positions of the hoop.
        Line = "line",
        /// Hatching of states that cannot occur.
        Hatch = "hatch",
        /// The region where the hoop can roll.
        Region = "region",
        /// The ground under the plane.
        Ground = "ground",
        /// A point without a value in a map of numbers.
        NoValue = "no_value",
        /// Where outcomes change more finely than a map tells.
        Mixed = "mixed",
    }
}

impl Ink {
    /// Colour.
    pub const fn colour(self, theme: Theme) -> Rgb {
        match self {
            Self::Paper => theme.pick(0xffffff, 0x14171d),
            Self::Ink => theme.pick(0x222222, 0xeceef2),
            Self::Soft => theme.pick(0x6b6b6b, 0xaab0bd),
            Self::Faint => theme.pick(0x9a9a9a, 0x7d8594),
            Self::Line => theme.pick(0xc4c4c4, 0x3b414d),
            Self::Hatch => theme.pick(0xc2c2c2, 0x444b58),
            Self::Region => theme.pick(0xe3ecf2, 0x232b36),
            Self::Ground => theme.pick(0xeceae4, 0x24231f),
            Self::NoValue => theme.pick(0xe4e4e4, 0x292929),
            Self::Mixed => theme.pick(0xf4f4f4, 0x060606),
        }
    }
}
