//! A coefficient of restitution with its law.

use crate::model::error::ParameterError;
use crate::model::law::RestitutionLaw;
use crate::model::quantity::Quantity;

/// A coefficient of restitution 0 ≤ e ≤ 1 with its law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Restitution {
    coefficient: f64,
    law: RestitutionLaw,
}

impl Restitution {
    /// A coefficient with a law.
    ///
    /// # Errors
    /// The coefficient must lie between 0 and 1.
    pub fn new(coefficient: f64, law: RestitutionLaw) -> Result<Self, ParameterError> {
        Ok(Self { coefficient: Quantity::Restitution.check(coefficient)?, law })
    }

    /// The coefficient e.
    #[must_use]
    pub const fn coefficient(&self) -> f64 {
        self.coefficient
    }

    /// The law.
    #[must_use]
    pub const fn law(&self) -> RestitutionLaw {
        self.law
    }
}
