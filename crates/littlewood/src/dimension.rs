//! Dimensions of the quantities, and with them the conversion between (2.9) and SI units.

use crate::error::ParameterError;
use crate::quantity::Quantity;

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

/// What stands in a row of the table of dimensions.
struct Row {
    /// Twice the exponents of m2, R and g.
    halves: [i8; 3],
    /// The unit of (2.9) in plain letters, and as it is printed.
    scale: &'static str,
    sign: &'static str,
    /// The SI unit in plain letters, as it is printed, and at the end of a name.
    si: &'static str,
    si_sign: &'static str,
    suffix: &'static str,
}

impl Dimension {
    const fn row(self) -> Row {
        let (halves, [scale, sign], [si, si_sign, suffix]) = match self {
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
        };
        Row { halves, scale, sign, si, si_sign, suffix }
    }

    /// The unit of (2.9) in m2, R and g, in plain letters; `1` for a ratio and an angle.
    #[must_use]
    pub const fn scale(self) -> &'static str {
        self.row().scale
    }

    /// The same as it is printed; empty for a ratio and an angle.
    #[must_use]
    pub const fn scale_sign(self) -> &'static str {
        self.row().sign
    }

    /// The SI unit in plain letters; `1` for a ratio.
    #[must_use]
    pub const fn si_unit(self) -> &'static str {
        self.row().si
    }

    /// The same as it is printed; empty for a ratio.
    #[must_use]
    pub const fn si_sign(self) -> &'static str {
        self.row().si_sign
    }

    /// What follows the name of a quantity that is given in SI units; empty for a ratio.
    #[must_use]
    pub const fn si_suffix(self) -> &'static str {
        self.row().suffix
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
        self.row().halves
    }
}

/// The units of (2.9): SI value = dimensionless value × unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// Mass m2, kg.
    pub mass_kg: f64,
    /// Length R, m.
    pub length_m: f64,
    /// Time √(R/g), s.
    pub time_s: f64,
    /// Gravitational acceleration g, m/s².
    pub gravity_m_per_s2: f64,
}

impl Units {
    /// From m2, R and g.
    ///
    /// # Errors
    /// All three must be finite and greater than zero.
    pub fn new(particle_mass_kg: f64, radius_m: f64, gravity_m_per_s2: f64) -> Result<Self, ParameterError> {
        let mass_kg = Quantity::ParticleMassKg.check(particle_mass_kg)?;
        let length_m = Quantity::RadiusM.check(radius_m)?;
        let gravity = Quantity::GravityMPerS2.check(gravity_m_per_s2)?;
        Ok(Self { mass_kg, length_m, time_s: (length_m / gravity).sqrt(), gravity_m_per_s2: gravity })
    }

    /// The unit of a dimension as a fraction, by the exponents of m2, R and g. Powers of R/g alone are powers of the
    /// unit of time; an odd power of √g brings one unit of time.
    fn fraction(&self, dimension: Dimension) -> (Option<f64>, f64) {
        let [mass, mut length, mut gravity] = dimension.halves();
        let mut time = 0;
        if length == -gravity {
            (time, length, gravity) = (length, 0, 0);
        } else if gravity % 2 != 0 {
            (time, length, gravity) = (-1, length + 1, gravity - 1);
        }
        let powers = [
            (self.mass_kg, mass / 2),
            (self.gravity_m_per_s2, gravity / 2),
            (self.length_m, length / 2),
            (self.time_s, time),
        ];
        let product = |sign: i8| {
            let factors =
                powers.iter().flat_map(|&(unit, power)| (0..(sign * power).max(0)).map(move |_| unit));
            factors.reduce(|product, unit| product * unit)
        };
        (product(1), product(-1).unwrap_or(1.0))
    }

    /// The SI value of one unit of (2.9).
    #[must_use]
    pub fn unit(&self, dimension: Dimension) -> f64 {
        let (above, below) = self.fraction(dimension);
        above.unwrap_or(1.0) / below
    }

    /// A dimensionless value in SI units.
    #[must_use]
    pub fn to_si(&self, dimension: Dimension, value: f64) -> f64 {
        match self.fraction(dimension) {
            // A quotient, not a product with the reciprocal: one rounding less.
            (None, below) => value / below,
            (Some(above), below) => value * (above / below),
        }
    }

    /// A value in SI units without dimension.
    #[must_use]
    pub fn from_si(&self, dimension: Dimension, value: f64) -> f64 {
        match self.fraction(dimension) {
            (None, below) => value * below,
            (Some(above), below) => value / (above / below),
        }
    }

    /// Velocity √(g R), m/s.
    #[must_use]
    pub fn velocity_m_per_s(&self) -> f64 {
        self.unit(Dimension::Velocity)
    }

    /// Force m2 g, N.
    #[must_use]
    pub fn force_n(&self) -> f64 {
        self.unit(Dimension::Force)
    }

    /// Energy m2 g R, J.
    #[must_use]
    pub fn energy_j(&self) -> f64 {
        self.unit(Dimension::Energy)
    }

    /// Moment of inertia m2 R², kg m².
    #[must_use]
    pub fn inertia_kg_m2(&self) -> f64 {
        self.unit(Dimension::Inertia)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_the_powers_of_mass_length_and_gravity() {
        let units = Units::new(0.14, 0.45, 9.81).expect("three positive numbers");
        let (m, r, g) = (0.14_f64, 0.45_f64, 9.81_f64);
        for (dimension, expected) in [
            (Dimension::Ratio, 1.0),
            (Dimension::Angle, 1.0),
            (Dimension::Mass, m),
            (Dimension::Length, r),
            (Dimension::Time, (r / g).sqrt()),
            (Dimension::AngularRate, (g / r).sqrt()),
            (Dimension::AngularAcceleration, g / r),
            (Dimension::Velocity, (g * r).sqrt()),
            (Dimension::Acceleration, g),
            (Dimension::Force, m * g),
            (Dimension::Energy, m * g * r),
            (Dimension::Impulse, m * (g * r).sqrt()),
            (Dimension::Inertia, m * r * r),
        ] {
            assert!((units.unit(dimension) / expected - 1.0).abs() < 1e-15, "{dimension:?}");
            assert!((units.from_si(dimension, units.to_si(dimension, 0.7)) - 0.7).abs() < 1e-15);
            assert!((units.to_si(dimension, 0.7) / (0.7 * expected) - 1.0).abs() < 1e-15, "{dimension:?}");
        }
    }
}
