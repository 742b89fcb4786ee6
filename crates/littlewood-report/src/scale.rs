//! The system of units that a person sees: none (2.9), or SI.

use littlewood::si::Units;
use littlewood::tables::{Dimension, Quantity, SampleColumn};

use crate::number::brief;

/// A system of units.
#[derive(Clone, Copy, Debug)]
pub struct Scale<'a>(Option<&'a Units>);

impl<'a> Scale<'a> {
    /// That of these units; none for the dimensionless system.
    #[must_use]
    pub const fn new(units: Option<&'a Units>) -> Self {
        Self(units)
    }

    /// The printed symbol of a dimensionless quantity, or of its counterpart in SI units.
    pub fn sign(self, quantity: Quantity) -> &'static str {
        let shown = match self.0 {
            None => quantity,
            Some(_) => quantity.si_twin().unwrap_or(quantity),
        };
        shown.sign()
    }

    /// The printed symbol of a column of samples, or of its counterpart in SI units. The columns of
    /// a state have the names of the quantities that a start is given by.
    pub fn column_sign(self, column: SampleColumn) -> &'static str {
        column
            .name()
            .parse()
            .map_or_else(|_| column.sign(), |quantity| self.sign(quantity))
    }

    /// The heading of a column: in SI units with the unit in a second line.
    pub fn heading(self, label: &str, dimension: Dimension) -> String {
        match self.0 {
            None => label.to_owned(),
            Some(_) => format!("{label}\n[{}]", dimension.si_sign()),
        }
    }

    /// A dimensionless value in this system.
    pub fn value(self, dimension: Dimension, value: f64) -> f64 {
        self.0.map_or(value, |units| units.to_si(dimension, value))
    }

    /// A dimensionless value in this system, with its unit if that is one of SI.
    pub fn show(self, dimension: Dimension, value: f64) -> String {
        let number = brief(self.value(dimension, value));
        match self.0 {
            None => number,
            Some(_) => with_unit(number, dimension.si_sign()),
        }
    }

    /// A dimensionless value in this system, with its unit in either: without dimension that is a
    /// power of m2, R and g.
    pub fn show_with_unit(self, dimension: Dimension, value: f64) -> String {
        match self.0 {
            None if value == 0.0 => brief(value),
            None => with_unit(brief(value), dimension.scale_sign()),
            Some(_) => self.show(dimension, value),
        }
    }

    /// θ in radians and in degrees.
    pub fn show_angle(self, theta: f64) -> String {
        let degrees = brief((theta.to_degrees() * 10.0).round() / 10.0);
        format!(
            "{} = {} ({degrees}°)",
            self.sign(Quantity::Theta),
            self.show(Dimension::Angle, theta)
        )
    }
}

fn with_unit(number: String, unit: &str) -> String {
    if unit.is_empty() {
        number
    } else {
        format!("{number} {unit}")
    }
}
