//! Colours, lines and letters of the figures.
//!
//! The colours are those of M. Okabe and K. Ito, told apart by the colour-blind. In grey they are not all far from each
//! other: so no curve is told by its colour alone, but by its dashes, its width or a label, too.

/// A colour, red, green, blue.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Colour(pub u8, pub u8, pub u8);

/// Axes, letters.
pub const INK: Colour = Colour(0x22, 0x22, 0x22);
/// What stays behind: energy levels, hoops.
pub const GREY: Colour = Colour(0x8a, 0x8a, 0x8a);
/// Orbits behind other curves.
pub const FAINT: Colour = Colour(0xb4, 0xb4, 0xb4);
/// Hatches.
pub const HATCH: Colour = Colour(0xc2, 0xc2, 0xc2);
/// Shaded regions.
pub const SHADE: Colour = Colour(0xd9, 0xe8, 0xf2);
/// Rolling, and the limit f of static friction.
pub const BLUE: Colour = Colour(0x00, 0x72, 0xb2);
/// Sliding.
pub const VERMILION: Colour = Colour(0xd5, 0x5e, 0x00);
/// Gliding.
pub const GREEN: Colour = Colour(0x00, 0x9e, 0x73);
/// The curve n, N = 0.
pub const PURPLE: Colour = Colour(0x8f, 0x3f, 0x71);
/// The light blue of Okabe and Ito.
pub const SKY: Colour = Colour(0x56, 0xb4, 0xe9);
/// White.
pub const WHITE: Colour = Colour(0xff, 0xff, 0xff);

/// Dashes of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dash {
    /// None.
    Solid,
    /// Long.
    Dashed,
    /// Dots.
    Dotted,
    /// A dash and a dot.
    DashDot,
    /// Short dashes.
    Short,
}

impl Dash {
    /// In units of the width of the line, for `stroke-dasharray`.
    pub(crate) const fn pattern(self) -> &'static [f64] {
        match self {
            Self::Solid => &[],
            Self::Dashed => &[5.0, 2.5],
            Self::Dotted => &[1.0, 1.8],
            Self::DashDot => &[6.0, 2.0, 1.0, 2.0],
            Self::Short => &[2.5, 1.8],
        }
    }
}

/// A line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Colour.
    pub colour: Colour,
    /// Width in pixels (1/96 inch).
    pub width: f64,
    /// Dashes.
    pub dash: Dash,
}

impl Stroke {
    /// A line without dashes.
    #[must_use]
    pub const fn solid(colour: Colour, width: f64) -> Self {
        Self { colour, width, dash: Dash::Solid }
    }

    /// The same with dashes.
    #[must_use]
    pub const fn dashed(self, dash: Dash) -> Self {
        Self { dash, ..self }
    }
}

/// The finest line, 0.6 pt in print.
pub const FINE: f64 = 0.8;
/// A curve, 1.2 pt.
pub const CURVE: f64 = 1.6;
/// A curve that matters, 1.8 pt.
pub const BOLD: f64 = 2.4;

/// Size of letters in pixels.
pub const LETTER: f64 = 14.0;
/// Size of the letters of ticks.
pub const SMALL: f64 = 12.5;
