//! Units of (2.9) in SI units, from the exponents of the dimensions.

use crate::model::Dimension;

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
    /// The unit of a dimension as a fraction, from the exponents of m2, R and g. Powers of R/g are
    /// powers of the unit of time; an odd power of √g contributes one unit of time.
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
            let factors = powers
                .iter()
                .flat_map(|&(unit, power)| (0..(sign * power).max(0)).map(move |_| unit));
            factors.reduce(|product, unit| product * unit)
        };
        (product(1), product(-1).unwrap_or(1.0))
    }

    /// The SI value of one unit of (2.9).
    pub fn unit(&self, dimension: Dimension) -> f64 {
        let (above, below) = self.fraction(dimension);
        above.unwrap_or(1.0) / below
    }

    /// A dimensionless value in SI units.
    pub fn to_si(&self, dimension: Dimension, value: f64) -> f64 {
        match self.fraction(dimension) {
            // A quotient has one rounding less than a product with the reciprocal.
            (None, below) => value / below,
            (Some(above), below) => value * (above / below),
        }
    }

    /// A value in SI units, made dimensionless.
    pub fn from_si(&self, dimension: Dimension, value: f64) -> f64 {
        match self.fraction(dimension) {
            (None, below) => value * below,
            (Some(above), below) => value / (above / below),
        }
    }
}
