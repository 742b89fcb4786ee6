//! Dimensions of the quantities: what a unit of (2.9) is in m2, R and g, and in SI units.

/// Which system of units a number is in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum System {
    /// That of (2.9): m2 = R = g = 1.
    Dimensionless,
    /// Kilograms, metres, seconds.
    Si,
}

/// The dimension of a quantity: what one unit of (2.9) is in m2, R and g, and in SI units.
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
    /// Impulse m2 √(gR).
    Impulse,
    /// Moment of inertia m2 R².
    Inertia,
}

impl Dimension {
    /// Twice the exponents of m2, R and g; the unit of (2.9) in plain letters, and as it is printed; the SI unit in plain letters, as
    /// it is printed, and at the end of a name.
    const fn row(self) -> ([i8; 3], [&'static str; 2], [&'static str; 3]) {
        match self {
            Self::Ratio => ([0, 0, 0], ["1", ""], ["1", "", ""]),
            Self::Angle => ([0, 0, 0], ["1", ""], ["rad", "rad", "_rad"]),
            Self::Mass => ([2, 0, 0], ["m2", "m₂"], ["kg", "kg", "_kg"]),
            Self::Length => ([0, 2, 0], ["R", "R"], ["m", "m", "_m"]),
            Self::Time => ([0, 1, -1], ["sqrt(R/g)", "√(R/g)"], ["s", "s", "_s"]),
            Self::AngularRate => ([0, -1, 1], ["sqrt(g/R)", "√(g/R)"], ["rad/s", "rad/s", "_rad_per_s"]),
            Self::AngularAcceleration => ([0, -2, 2], ["g/R", "g/R"], ["rad/s^2", "rad/s²", "_rad_per_s2"]),
            Self::Velocity => ([0, 1, 1], ["sqrt(g R)", "√(gR)"], ["m/s", "m/s", "_m_per_s"]),
            Self::Acceleration => ([0, 0, 2], ["g", "g"], ["m/s^2", "m/s²", "_m_per_s2"]),
            Self::Force => ([2, 0, 2], ["m2 g", "m₂g"], ["N", "N", "_n"]),
            Self::Energy => ([2, 2, 2], ["m2 g R", "m₂gR"], ["J", "J", "_j"]),
            Self::Impulse => ([2, 1, 1], ["m2 sqrt(g R)", "m₂√(gR)"], ["N s", "N s", "_n_s"]),
            Self::Inertia => ([2, 4, 0], ["m2 R^2", "m₂R²"], ["kg m^2", "kg m²", "_kg_m2"]),
        }
    }

    /// The unit of (2.9) in m2, R and g, in plain letters; `1` for a ratio and an angle.
    #[must_use]
    pub const fn scale(self) -> &'static str {
        self.row().1[0]
    }

    /// The same as it is printed; empty for a ratio and an angle.
    #[must_use]
    pub const fn scale_sign(self) -> &'static str {
        self.row().1[1]
    }

    /// The SI unit in plain letters; `1` for a ratio.
    #[must_use]
    pub const fn si_unit(self) -> &'static str {
        self.row().2[0]
    }

    /// The same as it is printed; empty for a ratio.
    #[must_use]
    pub const fn si_sign(self) -> &'static str {
        self.row().2[1]
    }

    /// What follows the name of a quantity that is given in SI units; empty for a ratio.
    #[must_use]
    pub const fn si_suffix(self) -> &'static str {
        self.row().2[2]
    }

    /// Unit of a value in the system of (2.9) that UDUNITS can read: `rad` for an angle, else `1`, with
    /// [`Dimension::scale`] in an attribute of its own.
    #[must_use]
    pub const fn cf_unit(self) -> &'static str {
        if matches!(self, Self::Angle) { "rad" } else { "1" }
    }

    /// Exponents of m2, R and g, twice each.
    #[must_use]
    pub const fn halves(self) -> [i8; 3] {
        self.row().0
    }
}

/// A number or a word that belongs to an outcome, under its name in records.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Detail {
    /// A number with its dimension.
    Real(f64, Dimension),
    /// A count.
    Count(usize),
    /// A word.
    Word(&'static str),
}
