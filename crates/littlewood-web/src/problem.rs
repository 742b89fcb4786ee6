//! A hoop and a start, in either system of units.

use littlewood::si::{SiParameters, SiSetup, Units};
use littlewood::tables::{Dimension, Presence, Quantity, SampleColumn, Setup};
use littlewood::theory::Body;
use littlewood::{Hoop, Limits, Restitution, RestitutionLaw, Start};
use littlewood_report::link;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::refusal::Refusal;

/// The numbers of a problem without dimension, in the order in which they cross the boundary: all
/// but those whose absence has a meaning.
pub fn dimensionless_quantities() -> impl Iterator<Item = Quantity> {
    Quantity::HOOP
        .into_iter()
        .chain(Quantity::START)
        .filter(has_value)
}

/// The numbers of a problem in SI units, in the order in which they cross the boundary, likewise.
pub fn si_quantities() -> impl Iterator<Item = Quantity> {
    Quantity::SI_HOOP
        .into_iter()
        .chain(Quantity::SI_START)
        .filter(has_value)
}

/// Whether a problem always has a value of a quantity.
fn has_value(quantity: &Quantity) -> bool {
    match quantity.row().presence {
        Presence::Required | Presence::Default(_) => true,
        Presence::Optional => false,
    }
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
    /// Without dimension (2.9): the numbers of [`dimensionless_quantities`]; the coefficient of
    /// restitution and the name of its law, none where the motion ends at the landing. `until`
    /// limits the time; none to follow the motion to its end. A number that is missing is refused
    /// as NaN is.
    ///
    /// # Errors
    /// Values without physical meaning.
    pub fn dimensionless(
        numbers: &[f64],
        restitution: Option<f64>,
        law: Option<String>,
        until: Option<f64>,
    ) -> Result<Self, Refusal> {
        Self::checked(&given(false, numbers, restitution, law_named(law)?, until))
    }

    /// In SI units: the numbers of [`si_quantities`], and the rest as without dimension. Converted
    /// just as the command line does.
    ///
    /// # Errors
    /// Values without physical meaning.
    pub fn si(
        numbers: &[f64],
        restitution: Option<f64>,
        law: Option<String>,
        until_s: Option<f64>,
    ) -> Result<Self, Refusal> {
        Self::checked(&given(true, numbers, restitution, law_named(law)?, until_s))
    }

    /// The dimensionless numbers, in the order of [`Problem::dimensionless`].
    #[wasm_bindgen(js_name = toDimensionless)]
    pub fn to_dimensionless(&self) -> Vec<f64> {
        let setup = self.setup();
        dimensionless_quantities()
            .filter_map(|quantity| setup.get(quantity))
            .collect()
    }

    /// The coefficient of restitution; none where the motion ends at the landing.
    #[wasm_bindgen(getter)]
    pub fn restitution(&self) -> Option<f64> {
        self.hoop
            .restitution()
            .map(|restitution| restitution.coefficient())
    }

    /// The name of its law.
    #[wasm_bindgen(getter, js_name = restitutionLaw)]
    pub fn restitution_law(&self) -> Option<String> {
        self.hoop
            .restitution()
            .as_ref()
            .map(Restitution::law)
            .map(|law| law.name().to_owned())
    }

    /// What one unit of (2.9) of an impulse is worth in the units of the problem: 1 without
    /// dimension.
    #[wasm_bindgen(getter, js_name = impulseUnit)]
    pub fn impulse_unit(&self) -> f64 {
        self.units
            .map_or(1.0, |units| units.unit(Dimension::Impulse))
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
        let units = SiParameters {
            particle_mass_kg,
            radius_m,
            gravity_m_per_s2,
            ..SiParameters::default()
        }
        .units()?;
        let setup = SiSetup::new(&self.setup(), &units);
        Ok(si_quantities()
            .filter_map(|quantity| setup.get(quantity))
            .collect())
    }

    /// What one unit of (2.9) of each column of a sample is worth in the units of the problem, in
    /// the order of
    /// [`SampleColumn::ALL`]: 1 without dimension, and for a code.
    #[wasm_bindgen(js_name = columnUnits)]
    pub fn column_units(&self) -> Vec<f64> {
        let unit = |dimension: Dimension| self.units.map_or(1.0, |units| units.unit(dimension));
        SampleColumn::ALL
            .into_iter()
            .map(|column| column.dimension().map_or(1.0, unit))
            .collect()
    }

    /// Whether the hoop has no inertia: it rolls and glides (§3).
    #[wasm_bindgen(getter, js_name = isMassless)]
    pub fn is_massless(&self) -> bool {
        matches!(self.hoop.body(), Body::Massless(_))
    }

    /// h, the distance of the mass centre from the geometric centre (2.4).
    #[wasm_bindgen(getter)]
    pub fn h(&self) -> f64 {
        self.hoop.h()
    }
}

impl Problem {
    fn checked(given: &link::Problem) -> Result<Self, Refusal> {
        let (setup, units, until) = given.to_setup()?;
        let hoop = Hoop::new(setup.hoop)?;
        // A start has its own bounds, which only a use of it checks.
        setup.start.check()?;
        Ok(Self {
            hoop,
            start: setup.start,
            limits: Limits::default().with_until(until),
            units,
        })
    }

    pub(crate) const fn setup(&self) -> Setup {
        Setup::new(self.hoop.parameters(), self.start)
    }
}

fn law_named(name: Option<String>) -> Result<Option<RestitutionLaw>, Refusal> {
    Ok(name.as_deref().map(str::parse).transpose()?)
}

/// A problem of numbers as they cross the boundary. One that is missing is refused where the
/// problem is checked.
pub(crate) fn given(
    is_si: bool,
    numbers: &[f64],
    restitution: Option<f64>,
    law: Option<RestitutionLaw>,
    until: Option<f64>,
) -> link::Problem {
    let mut numbers = numbers.iter().copied();
    let mut value = |quantity| match quantity {
        Quantity::Restitution => restitution,
        Quantity::Until | Quantity::UntilS => until,
        _ => numbers.next(),
    };
    let values = link::Problem::quantities(is_si)
        .map(|quantity| (quantity, value(quantity)))
        .collect();
    link::Problem { is_si, values, law }
}
