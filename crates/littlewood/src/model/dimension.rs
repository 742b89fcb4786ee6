//! Dimensions, with the units of (2.9) and of the SI.

use crate::model::getters;

/// System of units.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum System {
    /// Dimensionless, m2 = R = g = 1 (2.9).
    Dimensionless,
    /// Kilograms, metres, seconds.
    Si,
}

/// The dimension of a quantity, with its unit of (2.9).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Dimension {
    /// A ratio.
    Ratio,
    /// Angle.
    Angle,
    /// Mass m2.
    Mass,
    /// Length R.
    Length,
    /// Time √(R/g).
    Time,
    /// Rate of an angle, √(g/R).
    AngularRate,
    /// Angular acceleration g/R.
    AngularAcceleration,
    /// Velocity √(gR).
    Velocity,
    /// Acceleration g.
    Acceleration,
    /// Force m2 g.
    Force,
    /// Energy m2 g R.
    Energy,
    /// Moment of a force m2 g R.
    Moment,
    /// Impulse m2 √(gR).
    Impulse,
    /// Moment of inertia m2 R².
    Inertia,
}

getters! {
    Dimension, self:
    /// Unit of (2.9) in plain letters; `1` for a ratio and an angle.
    pub scale: &'static str = self.row().1[0];
    /// Typeset unit of (2.9); empty for a ratio and an angle.
    pub scale_sign: &'static str = self.row().1[1];
    /// SI unit in plain letters; `1` for a ratio.
    pub si_unit: &'static str = self.row().2[0];
    /// Typeset SI unit; empty for a ratio.
    pub si_sign: &'static str = self.row().2[1];
    /// Suffix of the name of a quantity in SI units; empty for a ratio.
    pub si_suffix: &'static str = self.row().2[2];
    /// Twice the exponents of m2, R and g.
    pub halves: [i8; 3] = self.row().0;
}

impl Dimension {
    /// Twice the exponents of m2, R and g; the unit of (2.9), plain and typeset; the SI unit,
    /// plain, typeset and as the suffix of a name.
    const fn row(self) -> ([i8; 3], [&'static str; 2], [&'static str; 3]) {
        match self {
            Self::Ratio => ([0, 0, 0], ["1", ""], ["1", "", ""]),
            Self::Angle => ([0, 0, 0], ["1", ""], ["rad", "rad", "_rad"]),
            Self::Mass => ([2, 0, 0], ["m2", "m₂"], ["kg", "kg", "_kg"]),
            Self::Length => ([0, 2, 0], ["R", "R"], ["m", "m", "_m"]),
            Self::Time => ([0, 1, -1], ["sqrt(R/g)", "√(R/g)"], ["s", "s", "_s"]),
            Self::AngularRate => (
                [0, -1, 1],
                ["sqrt(g/R)", "√(g/R)"],
                ["rad/s", "rad/s", "_rad_per_s"],
            ),
            Self::AngularAcceleration => (
                [0, -2, 2],
                ["g/R", "g/R"],
                ["rad/s^2", "rad/s²", "_rad_per_s2"],
            ),
            Self::Velocity => (
                [0, 1, 1],
                ["sqrt(g R)", "√(gR)"],
                ["m/s", "m/s", "_m_per_s"],
            ),
            Self::Acceleration => ([0, 0, 2], ["g", "g"], ["m/s^2", "m/s²", "_m_per_s2"]),
            Self::Force => ([2, 0, 2], ["m2 g", "m₂g"], ["N", "N", "_n"]),
            Self::Energy => ([2, 2, 2], ["m2 g R", "m₂gR"], ["J", "J", "_j"]),
            Self::Moment => ([2, 2, 2], ["m2 g R", "m₂gR"], ["N m", "N m", "_n_m"]),
            Self::Impulse => (
                [2, 1, 1],
                ["m2 sqrt(g R)", "m₂√(gR)"],
                ["N s", "N s", "_n_s"],
            ),
            Self::Inertia => ([2, 4, 0], ["m2 R^2", "m₂R²"], ["kg m^2", "kg m²", "_kg_m2"]),
        }
    }

    /// UDUNITS unit of a value in the system of (2.9): `rad` for an angle, else `1`.
    /// [`Dimension::scale`] is a separate attribute.
    pub const fn cf_unit(self) -> &'static str {
        if matches!(self, Self::Angle) {
            "rad"
        } else {
            "1"
        }
    }
}

/// A detail of an outcome in records.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Detail {
    /// A number with its dimension.
    Real(f64, Dimension),
    /// A count.
    Count(usize),
    /// A word.
    Word(&'static str),
}
