//! Numbers with the place that they were given in, in layers: flags over scenario file over case.

use std::borrow::Cow;
use std::ops::Range;

use littlewood::RestitutionLaw;
use littlewood::tables::{Quantity, Setup};

#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    Case,
    /// By a scenario file, at these bytes.
    File(Range<usize>),
    Flag,
}

/// A number as it was given.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Given {
    /// What it is, with its unit.
    pub(crate) quantity: Quantity,
    pub(crate) value: f64,
    pub(crate) origin: Origin,
}

impl Given {
    /// A number that was typed, or stands for one.
    pub(crate) const fn by_flag(quantity: Quantity, value: f64) -> Self {
        Self {
            quantity,
            value,
            origin: Origin::Flag,
        }
    }
}

/// A law of restitution as it was given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct GivenLaw {
    pub(crate) law: RestitutionLaw,
    pub(crate) origin: Origin,
}

/// At most one number for each quantity of (2.9), dimensionless or in SI units.
#[derive(Clone, Debug, Default)]
pub(crate) struct Values(Vec<Given>);

impl Values {
    pub(crate) fn of_case(setup: &Setup) -> Self {
        let given = |quantity| {
            Some(Given {
                quantity,
                value: setup.get(quantity)?,
                origin: Origin::Case,
            })
        };
        Self(
            Quantity::HOOP
                .into_iter()
                .chain(Quantity::START)
                .filter_map(given)
                .collect(),
        )
    }

    /// Puts a layer on top: a number replaces the one below it, in whichever unit that is.
    pub(crate) fn cover(&mut self, layer: Vec<Given>) {
        for given in layer {
            self.0
                .retain(|below| below.quantity.dimensionless() != given.quantity.dimensionless());
            self.0.push(given);
        }
    }

    /// The number for a quantity, in whichever unit it was given.
    pub(crate) fn find(&self, quantity: Quantity) -> Option<&Given> {
        self.0
            .iter()
            .find(|given| given.quantity.dimensionless() == quantity.dimensionless())
    }

    /// The number for a quantity, if it was given in this unit.
    pub(crate) fn get(&self, quantity: Quantity) -> Option<f64> {
        self.0
            .iter()
            .find(|given| given.quantity == quantity)
            .map(|given| given.value)
    }

    pub(crate) fn iter(&self) -> impl Iterator<Item = &Given> {
        self.0.iter()
    }

    /// Whether any number is in SI units.
    pub(crate) fn any_si(&self) -> bool {
        self.0.iter().any(|given| given.quantity.is_si())
    }
}

/// A dimensionless and an SI number in one layer, which do not go together.
pub(crate) fn find_mixture(layer: &[Given]) -> Option<(&Given, &Given)> {
    let plain = layer
        .iter()
        .find(|given| given.quantity.si_twin().is_some())?;
    let si = layer.iter().find(|given| given.quantity.is_si())?;
    Some((plain, si))
}

pub(crate) fn flag(quantity: Quantity) -> String {
    format!("--{}", quantity.name().replace('_', "-"))
}

/// The name that a quantity has among others in SI units: with the unit at its end, `theta_rad`.
pub(crate) fn si_name(quantity: Quantity) -> Cow<'static, str> {
    if quantity.is_si() {
        quantity.name().into()
    } else {
        format!("{quantity}{}", quantity.dimension().si_suffix()).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_in_si_units_end_in_the_unit() {
        let names: Vec<_> = Quantity::SI_START.into_iter().map(si_name).collect();
        assert_eq!(
            names,
            [
                "theta_rad",
                "theta_rate_rad_per_s",
                "slip_m_per_s",
                "gap_rate_m_per_s",
                "x_m",
                "time_s"
            ]
        );
        assert_eq!(si_name(Quantity::MuS), "mu_s");
    }
}
