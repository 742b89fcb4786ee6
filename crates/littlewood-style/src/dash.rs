//! Dashes of lines.

/// Dashes of a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Dash {
    /// An unbroken line.
    Solid,
    /// Long dashes.
    Dashed,
    /// Dots.
    Dotted,
    /// A dash and a dot.
    DashDot,
    /// Short dashes.
    Short,
}

impl Dash {
    /// All, in order.
    pub const ALL: [Self; 5] = [Self::Solid, Self::Dashed, Self::Dotted, Self::DashDot, Self::Short];

    /// Lower-case name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Solid => "solid",
            Self::Dashed => "dashed",
            Self::Dotted => "dotted",
            Self::DashDot => "dash_dot",
            Self::Short => "short",
        }
    }

    /// Lengths of dashes and gaps by turns in units of the width of the line, as `stroke-dasharray` and programs that
    /// plot take them; empty for a solid line.
    pub const fn pattern(self) -> &'static [f64] {
        match self {
            Self::Solid => &[],
            Self::Dashed => &[5.0, 2.5],
            Self::Dotted => &[1.0, 1.8],
            Self::DashDot => &[6.0, 2.0, 1.0, 2.0],
            Self::Short => &[2.5, 1.8],
        }
    }
}
