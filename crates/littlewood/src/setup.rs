//! A hoop and a start together, by the quantities of the table.

use crate::hoop::HoopParameters;
use crate::quantity::Quantity;
use crate::state::Start;

/// A hoop and a start as they are given, not yet checked.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Setup {
    /// The hoop, in the dimensionless parameters of (2.9).
    pub hoop: HoopParameters,
    /// The start, dimensionless.
    pub start: Start,
}

impl Setup {
    /// A hoop with a start.
    #[must_use]
    pub const fn new(hoop: HoopParameters, start: Start) -> Self {
        Self { hoop, start }
    }

    /// Where a quantity stands; none for a limit and for what is in SI units.
    pub const fn place(&mut self, quantity: Quantity) -> Option<&mut f64> {
        let Self { hoop, start } = self;
        Some(match quantity {
            Quantity::MassRatio => &mut hoop.mass_ratio,
            Quantity::Offset => &mut hoop.offset,
            Quantity::Inertia => &mut hoop.inertia,
            Quantity::MuS => &mut hoop.mu_s,
            Quantity::MuK => &mut hoop.mu_k,
            Quantity::Theta => &mut start.theta,
            Quantity::ThetaRate => &mut start.theta_rate,
            Quantity::Slip => &mut start.slip,
            Quantity::X => &mut start.x,
            Quantity::Time => &mut start.time,
            Quantity::Until
            | Quantity::DiscMassKg
            | Quantity::ParticleMassKg
            | Quantity::RadiusM
            | Quantity::OffsetM
            | Quantity::InertiaKgM2
            | Quantity::GravityMPerS2
            | Quantity::ThetaRateRadPerS
            | Quantity::SlipMPerS
            | Quantity::XM
            | Quantity::TimeS
            | Quantity::UntilS => return None,
        })
    }

    /// The value of a quantity; none for a limit and for what is in SI units.
    #[must_use]
    pub fn get(&self, quantity: Quantity) -> Option<f64> {
        let mut copy = *self;
        copy.place(quantity).copied()
    }

    /// Sets a quantity; nothing happens for a limit and for what is in SI units.
    pub const fn set(&mut self, quantity: Quantity, value: f64) {
        if let Some(place) = self.place(quantity) {
            *place = value;
        }
    }

    /// The values of some quantities; NaN for those that are not part of a setup.
    #[must_use]
    pub fn values<const N: usize>(&self, quantities: [Quantity; N]) -> [f64; N] {
        quantities.map(|quantity| self.get(quantity).unwrap_or(f64::NAN))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_setup_has_every_quantity_of_a_hoop_and_a_start() {
        let mut setup = Setup::new(HoopParameters::default(), Start::default());
        for (value, quantity) in (1_u8..).zip(Quantity::HOOP.into_iter().chain(Quantity::START)) {
            setup.set(quantity, f64::from(value));
        }
        for (value, quantity) in (1_u8..).zip(Quantity::HOOP.into_iter().chain(Quantity::START)) {
            assert_eq!(setup.get(quantity), Some(f64::from(value)));
            assert_eq!(setup.get(quantity.si_twin().unwrap_or(Quantity::Until)), None);
        }
        assert!(Quantity::AXES.iter().all(|axis| setup.get(*axis).is_some()));
    }
}
