//! Dashes of lines.

use crate::named::named;

named! {
    /// Dashes of a line.
    pub enum Dash {
        /// An unbroken line.
        Solid = "solid",
        /// Long dashes.
        Dashed = "dashed",
        /// Dots.
        Dotted = "dotted",
        /// A dash and a dot.
        DashDot = "dash_dot",
        /// Short dashes.
        Short = "short",
        /// A dash and two dots.
        DashDotDot = "dash_dot_dot",
    }
}

impl Dash {
    /// Lengths of dashes and gaps by turns in units of the width of the line, as `stroke-dasharray`
    /// and programs that plot take them; empty for a solid line.
    pub const fn pattern(self) -> &'static [f64] {
        match self {
            Self::Solid => &[],
            Self::Dashed => &[5.0, 2.5],
            Self::Dotted => &[1.0, 1.8],
            Self::DashDot => &[6.0, 2.0, 1.0, 2.0],
            Self::Short => &[2.5, 1.8],
            Self::DashDotDot => &[6.0, 2.0, 1.0, 2.0, 1.0, 2.0],
        }
    }
}
