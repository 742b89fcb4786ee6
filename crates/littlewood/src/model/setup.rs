//! A hoop and a start, with access by quantity.

use crate::model::{HoopParameters, Quantity, Start};

/// An unchecked hoop and start.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Setup {
    /// The hoop, in the dimensionless parameters of (2.9).
    pub hoop: HoopParameters,
    /// The start, dimensionless.
    pub start: Start,
}

enum Field<'a> {
    Number(&'a mut f64),
    Optional(&'a mut Option<f64>),
}

impl Setup {
    /// A hoop with a start.
    #[must_use]
    pub const fn new(hoop: HoopParameters, start: Start) -> Self {
        Self { hoop, start }
    }

    /// Whether the plane (θ, θ′) of starts with this hoop and the rest of this start is its own
    /// mirror image: the motion from (−θ, −θ′) is then that from (θ, θ′) seen in a mirror, bit for
    /// bit. A mirror turns a slope downhill the other way, and slip around.
    #[must_use]
    pub const fn plane_is_its_mirror_image(&self) -> bool {
        self.hoop.slope == 0.0 && self.start.slip == 0.0
    }

    /// The field of a quantity; `None` for a limit and for quantities in SI units.
    const fn field(&mut self, quantity: Quantity) -> Option<Field<'_>> {
        let Self { hoop, start } = self;
        Some(Field::Number(match quantity {
            Quantity::MassRatio => &mut hoop.mass_ratio,
            Quantity::Offset => &mut hoop.offset,
            Quantity::Inertia => &mut hoop.inertia,
            Quantity::MuS => &mut hoop.mu_s,
            Quantity::MuK => &mut hoop.mu_k,
            Quantity::RollingResistance => &mut hoop.rolling_resistance,
            Quantity::Slope => &mut hoop.slope,
            Quantity::Restitution => return Some(Field::Optional(&mut hoop.restitution)),
            Quantity::Theta => &mut start.theta,
            Quantity::ThetaRate => &mut start.theta_rate,
            Quantity::Slip => &mut start.slip,
            Quantity::GapRate => &mut start.gap_rate,
            Quantity::X => &mut start.x,
            Quantity::Time => &mut start.time,
            Quantity::Until
            | Quantity::DiscMassKg
            | Quantity::ParticleMassKg
            | Quantity::RadiusM
            | Quantity::OffsetM
            | Quantity::InertiaKgM2
            | Quantity::GravityMPerS2
            | Quantity::RollingResistanceM
            | Quantity::ThetaRateRadPerS
            | Quantity::SlipMPerS
            | Quantity::GapRateMPerS
            | Quantity::XM
            | Quantity::TimeS
            | Quantity::UntilS => return None,
        }))
    }

    /// The value of a quantity; `None` if it is absent, for a limit and for quantities in SI units.
    pub fn get(&self, quantity: Quantity) -> Option<f64> {
        Self::value(&mut { *self }, quantity)
    }

    /// The value of a quantity, if it has one that does not go without saying
    /// ([`Quantity::goes_without_saying`]).
    pub fn said(&self, quantity: Quantity) -> Option<f64> {
        self.get(quantity)
            .filter(|value| !quantity.goes_without_saying(*value))
    }

    const fn value(&mut self, quantity: Quantity) -> Option<f64> {
        match self.field(quantity) {
            Some(Field::Number(value)) => Some(*value),
            Some(Field::Optional(value)) => *value,
            None => None,
        }
    }

    /// Sets a quantity; no effect for a limit and for quantities in SI units.
    pub const fn set(&mut self, quantity: Quantity, value: f64) {
        match self.field(quantity) {
            Some(Field::Number(field)) => *field = value,
            Some(Field::Optional(field)) => *field = Some(value),
            None => {}
        }
    }

    /// The values of several quantities; NaN for those without a value.
    pub fn values<const N: usize>(&self, quantities: [Quantity; N]) -> [f64; N] {
        let mut copy = *self;
        quantities.map(|quantity| copy.value(quantity).unwrap_or(f64::NAN))
    }
}
