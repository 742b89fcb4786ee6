//! A hoop and a start, in either system of units.

use littlewood::{
    Body, Dimension, Hoop, HoopParameters, Limits, Quantity, SampleColumn, Setup, SiSetup, Start, Units,
};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::refusal::Refusal;

/// The numbers of a problem without dimension, in the order in which they cross the boundary.
pub(crate) fn dimensionless_quantities() -> impl Iterator<Item = Quantity> {
    Quantity::HOOP.into_iter().chain(Quantity::START)
}

/// The numbers of a problem in SI units, in the order in which they cross the boundary.
pub(crate) fn si_quantities() -> impl Iterator<Item = Quantity> {
    Quantity::SI_HOOP.into_iter().chain(Quantity::SI_START)
}

/// A hoop, a start and a time limit that have been checked.
#[wasm_bindgen]
#[derive(Clone, Debug)]
pub struct Problem {
    pub(crate) hoop: Hoop,
    pub(crate) start: Start,
    pub(crate) limits: Limits,
    pub(crate) units: Option<Units>,
}

#[wasm_bindgen]
impl Problem {
    /// Without dimension (2.9): the numbers of [`Quantity::HOOP`], then those of [`Quantity::START`]. `until` limits
    /// the time; none to follow the motion to its end. A number that is missing is refused as NaN is.
    ///
    /// # Errors
    /// Values without physical meaning.
    pub fn dimensionless(numbers: &[f64], until: Option<f64>) -> Result<Self, Refusal> {
        let mut setup = Setup::new(HoopParameters::default(), Start::default());
        for (index, quantity) in dimensionless_quantities().enumerate() {
            setup.set(quantity, number(numbers, index));
        }
        Self::checked(&setup, until, None)
    }

    /// In SI units: the numbers of [`Quantity::SI_HOOP`], then those of [`Quantity::SI_START`]. Converted just as the
    /// command line does.
    ///
    /// # Errors
    /// Values without physical meaning.
    pub fn si(numbers: &[f64], until_s: Option<f64>) -> Result<Self, Refusal> {
        let value = |wanted: Quantity| {
            si_quantities().position(|quantity| quantity == wanted).map(|i| number(numbers, i))
        };
        let (setup, units) = SiSetup::from_values(value, None).to_setup()?;
        let until = until_s.map(|until_s| units.until(until_s, &setup.start)).transpose()?;
        Self::checked(&setup, until, Some(units))
    }

    /// The dimensionless numbers, in the order of [`Problem::dimensionless`].
    #[wasm_bindgen(js_name = toDimensionless)]
    #[must_use]
    pub fn to_dimensionless(&self) -> Vec<f64> {
        let setup = self.setup();
        dimensionless_quantities().filter_map(|quantity| setup.get(quantity)).collect()
    }

    /// The numbers in SI units, in the order of [`Problem::si`], for m2, R and g.
    ///
    /// # Errors
    /// Units that are not greater than zero.
    #[wasm_bindgen(js_name = toSi)]
    pub fn to_si(
        &self,
        particle_mass_kg: f64,
        radius_m: f64,
        gravity_m_per_s2: f64,
    ) -> Result<Vec<f64>, Refusal> {
        let units = Units::new(particle_mass_kg, radius_m, gravity_m_per_s2)?;
        let setup = SiSetup::new(&self.setup(), &units);
        Ok(si_quantities().filter_map(|quantity| setup.get(quantity)).collect())
    }

    /// What one unit of (2.9) of each column of a sample is worth in the units of the problem, in the order of
    /// [`SampleColumn::ALL`]: 1 without dimension, and for a code.
    #[wasm_bindgen(js_name = columnUnits)]
    #[must_use]
    pub fn column_units(&self) -> Vec<f64> {
        let unit = |dimension: Dimension| self.units.map_or(1.0, |units| units.unit(dimension));
        SampleColumn::ALL.into_iter().map(|column| column.dimension().map_or(1.0, unit)).collect()
    }

    /// Whether the hoop has no inertia: it rolls and glides (§3).
    #[wasm_bindgen(getter, js_name = isMassless)]
    #[must_use]
    pub fn is_massless(&self) -> bool {
        matches!(self.hoop.body(), Body::Massless(_))
    }

    /// h, the distance of the mass centre from the geometric centre (2.4).
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn h(&self) -> f64 {
        self.hoop.h()
    }
}

impl Problem {
    fn checked(setup: &Setup, until: Option<f64>, units: Option<Units>) -> Result<Self, Refusal> {
        let hoop = Hoop::new(setup.hoop)?;
        // A start has its own bounds, which only a use of it checks.
        setup.start.check()?;
        Ok(Self { hoop, start: setup.start, limits: Limits::default().with_until(until), units })
    }

    const fn setup(&self) -> Setup {
        Setup::new(self.hoop.parameters(), self.start)
    }
}

/// A number by its place; NaN, which is refused, where there is none.
fn number(numbers: &[f64], index: usize) -> f64 {
    numbers.get(index).copied().unwrap_or(f64::NAN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_problem_in_si_units_has_the_quotients_of_2_9() {
        // m2 = 0.5, R = 2, g = 8: the unit of time is 1/2, that of velocity 4, that of inertia 2.
        let numbers = [1.5, 0.5, 2.0, 1.0, 3.0, 8.0, 0.5, 0.4, 0.25, 6.0, 1.0, 4.0, 3.0];
        let problem = Problem::si(&numbers, Some(5.0)).unwrap();
        assert_eq!(problem.to_dimensionless(), [3.0, 0.5, 1.5, 0.5, 0.4, 0.25, 3.0, 0.25, 2.0, 6.0]);
        assert_eq!(problem.to_si(0.5, 2.0, 8.0).unwrap(), numbers);
        assert_eq!(problem.limits.until, Some(10.0));
        let units = problem.column_units();
        let unit = |column: SampleColumn| units[usize::from(column.code())];
        assert_eq!([SampleColumn::Time, SampleColumn::Slip, SampleColumn::Mode].map(unit), [0.5, 4.0, 1.0]);
    }

    #[test]
    fn a_refusal_names_the_quantity_that_was_given() {
        let refused = |numbers: &[f64], until: Option<f64>| Problem::si(numbers, until).unwrap_err();
        let mut numbers = [1.5, 0.5, 2.0, 1.0, 3.0, 8.0, 0.5, 0.4, 0.25, 6.0, 1.0, 4.0, 3.0];
        assert_eq!(refused(&numbers, Some(2.0)).quantity(), "until_s");
        assert_eq!(refused(&numbers[..12], None).quantity(), "time_s");
        numbers[3] = 2.5;
        assert_eq!(refused(&numbers, None).quantity(), "offset_m");
        let point_mass = [1.0, 0.0, 0.0, 0.5, 0.4, 0.0, 0.0, 0.0, 0.0, 0.0];
        assert_eq!(Problem::dimensionless(&point_mass, None).unwrap_err().quantity(), "offset");
    }
}
