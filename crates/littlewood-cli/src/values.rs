//! Numbers with the place that they were given in, in layers: flags over scenario file over case.

use std::ops::Range;

use littlewood::{HoopParameters, Quantity, Start};

/// Where a number was given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    /// By a named case.
    Case,
    /// By a scenario file, at these bytes.
    File(Range<usize>),
    /// By a flag.
    Flag,
}

/// A number as it was given.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Given {
    /// What it is, with its unit.
    pub(crate) quantity: Quantity,
    /// Its value.
    pub(crate) value: f64,
    /// Where it comes from.
    pub(crate) origin: Origin,
}

/// At most one number for each quantity of (2.9), dimensionless or in SI units.
#[derive(Clone, Debug, Default)]
pub(crate) struct Values(Vec<Given>);

impl Values {
    /// The hoop and the start of a named case.
    pub(crate) fn of_case(hoop: &HoopParameters, start: &Start) -> Self {
        let pairs = [
            (Quantity::MassRatio, hoop.mass_ratio),
            (Quantity::Offset, hoop.offset),
            (Quantity::Inertia, hoop.inertia),
            (Quantity::MuS, hoop.mu_s),
            (Quantity::MuK, hoop.mu_k),
            (Quantity::Theta, start.theta),
            (Quantity::ThetaRate, start.theta_rate),
            (Quantity::Slip, start.slip),
            (Quantity::X, start.x),
            (Quantity::Time, start.time),
        ];
        let given = |(quantity, value)| Given { quantity, value, origin: Origin::Case };
        Self(pairs.into_iter().map(given).collect())
    }

    /// Puts a layer on top: a number replaces the one below it, in whichever unit that is.
    pub(crate) fn cover(&mut self, layer: Vec<Given>) {
        for given in layer {
            self.0.retain(|below| dimensionless(below.quantity) != dimensionless(given.quantity));
            self.0.push(given);
        }
    }

    /// The number for a quantity, in whichever unit it was given.
    pub(crate) fn find(&self, quantity: Quantity) -> Option<&Given> {
        self.0.iter().find(|given| dimensionless(given.quantity) == dimensionless(quantity))
    }

    /// The number for a quantity, if it was given in this unit.
    pub(crate) fn get(&self, quantity: Quantity) -> Option<f64> {
        self.0.iter().find(|given| given.quantity == quantity).map(|given| given.value)
    }

    /// All numbers.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &Given> {
        self.0.iter()
    }

    /// Whether any number is in SI units.
    pub(crate) fn any_si(&self) -> bool {
        self.0.iter().any(|given| is_si(given.quantity))
    }
}

/// A dimensionless and an SI number in one layer, which do not go together.
pub(crate) fn find_mixture(layer: &[Given]) -> Option<(&Given, &Given)> {
    let plain = layer.iter().find(|given| si_twin(given.quantity).is_some())?;
    let si = layer.iter().find(|given| is_si(given.quantity))?;
    Some((plain, si))
}

/// Whether the quantity has an SI unit. θ, μs and μk are the same numbers in both systems and count for neither.
fn is_si(quantity: Quantity) -> bool {
    dimensionless(quantity) != quantity
        || matches!(quantity, Quantity::ParticleMassKg | Quantity::RadiusM | Quantity::GravityMPerS2)
}

const TWINS: [(Quantity, Quantity); 8] = [
    (Quantity::MassRatio, Quantity::DiscMassKg),
    (Quantity::Offset, Quantity::OffsetM),
    (Quantity::Inertia, Quantity::InertiaKgM2),
    (Quantity::ThetaRate, Quantity::ThetaRateRadPerS),
    (Quantity::Slip, Quantity::SlipMPerS),
    (Quantity::X, Quantity::XM),
    (Quantity::Time, Quantity::TimeS),
    (Quantity::Until, Quantity::UntilS),
];

/// The SI quantity that (2.9) makes this one of; none for a quantity that is the same in both systems, or is SI.
pub(crate) fn si_twin(quantity: Quantity) -> Option<Quantity> {
    TWINS.into_iter().find(|(plain, _)| *plain == quantity).map(|(_, si)| si)
}

/// The dimensionless quantity that (2.9) makes of this one; itself where there is none.
pub(crate) fn dimensionless(quantity: Quantity) -> Quantity {
    TWINS.into_iter().find(|(_, si)| *si == quantity).map_or(quantity, |(plain, _)| plain)
}

/// The flag of a quantity.
pub(crate) fn flag(quantity: Quantity) -> String {
    format!("--{}", quantity.name().replace('_', "-"))
}
