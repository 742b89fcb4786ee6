//! Parameter errors: the quantity, its value and unit, and the violated bound.

use thiserror::Error;

use crate::model::{Bound, Number, Quantity, Reading, RestitutionLaw};

/// Least moment of inertia about the mass centre: fifth powers of its inverse, 1e300, are
/// representable.
pub(crate) const MIN_INERTIA: f64 = 1e-60;

/// Least offset of a massless hoop. Its accelerations are 1/(ℓ̂ sin θ), their derivatives 1/ℓ̂², and
/// products of its heights over the bottom and under the top are ℓ̂² sin²θ, with angles from the top
/// of 1e-60 and more. All are representable with some 1e60 to spare.
pub(crate) const MIN_MASSLESS_OFFSET: f64 = 1e-60;

/// A parameter of a hoop or a start without physical meaning.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
#[expect(missing_docs, reason = "the message of each says what its fields are")]
pub enum ParameterError {
    /// A value violates a bound.
    #[error("{} {bound}", Reading(*quantity, *value))]
    OutOfBounds {
        quantity: Quantity,
        value: f64,
        bound: Bound,
    },
    /// A point mass at the centre, without inertia and without a moment of its weight: no equation
    /// of motion.
    #[error(
        "offset = 0 and moment of inertia = 0 (mass_ratio = {}, inertia = 0): \
         a point mass at the centre of the hoop has no equation of motion",
        Number(*mass_ratio)
    )]
    NoMotion { mass_ratio: f64 },
    /// A nearly massless hoop: powers of 1/Î overflow.
    #[error(
        "moment of inertia about the mass centre = {} m2 R^2 must be 0, or not less than {} m2 R^2",
        Number(*inertia), Number(MIN_INERTIA)
    )]
    NearlyMassless { inertia: f64 },
    /// A massless hoop with the particle next to its centre: powers of 1/ℓ̂ overflow.
    #[error(
        "offset = {} of a massless hoop (mass_ratio = 0, inertia = 0) must not be less than {}",
        Number(*offset), Number(MIN_MASSLESS_OFFSET)
    )]
    NearlyCentred { offset: f64 },
    /// A law of restitution without a coefficient.
    #[error(
        "restitution_law = {law} without restitution: without a coefficient the motion ends where the rim lands"
    )]
    LawAlone { law: RestitutionLaw },
    /// A massless hoop with a coefficient of restitution.
    #[error(
        "restitution = {} of a massless hoop (mass_ratio = 0, inertia = 0): \
         an impulse would accelerate its rim without bound",
        Number(*restitution)
    )]
    MasslessImpact { restitution: f64 },
    /// A massless hoop that starts in flight, where its rotation is not determined.
    #[error(
        "gap_rate = {} of a massless hoop (mass_ratio = 0, inertia = 0): \
         without inertia its rotation in the air is not determined",
        Number(*gap_rate)
    )]
    MasslessFlight { gap_rate: f64 },
}

impl ParameterError {
    /// Advice for the user.
    pub const fn hint(&self) -> &'static str {
        match self {
            Self::LawAlone { .. } => "give the coefficient too, 0 to 1, or leave out the law",
            Self::MasslessImpact { .. } | Self::MasslessFlight { .. } => {
                "leave it out, or give the hoop a mass or a moment of inertia"
            }
            Self::NoMotion { .. } | Self::NearlyCentred { .. } => {
                "give the disc a moment of inertia, or move the particle off the centre"
            }
            Self::NearlyMassless { .. } => {
                "set mass_ratio and inertia to 0 for a massless hoop, or to 1e-16: smaller values give the same motion"
            }
            Self::OutOfBounds {
                bound: Bound::Finite,
                ..
            } => "NaN and infinities are not numbers to start from",
            Self::OutOfBounds {
                bound: Bound::MagnitudeAtMost(_) | Bound::ResolvedAtMost(_),
                ..
            } => "beyond this bound a double no longer resolves the motion",
            Self::OutOfBounds { quantity, .. } => quantity.hint(),
        }
    }

    /// The quantity to change, or one of them.
    pub const fn quantity(&self) -> Quantity {
        match self {
            Self::OutOfBounds { quantity, .. } => *quantity,
            Self::NoMotion { .. } | Self::NearlyCentred { .. } => Quantity::Offset,
            Self::NearlyMassless { .. } => Quantity::Inertia,
            Self::LawAlone { .. } | Self::MasslessImpact { .. } => Quantity::Restitution,
            Self::MasslessFlight { .. } => Quantity::GapRate,
        }
    }

    /// Whether several values, each valid alone, contradict each other, such as μk > μs.
    pub const fn is_contradiction(&self) -> bool {
        matches!(
            self,
            Self::NoMotion { .. }
                | Self::NearlyMassless { .. }
                | Self::NearlyCentred { .. }
                | Self::MasslessImpact { .. }
                | Self::MasslessFlight { .. }
                | Self::OutOfBounds {
                    quantity: Quantity::MuK,
                    bound: Bound::AtMost(..),
                    ..
                }
        )
    }
}

impl Quantity {
    /// Checks that a value is finite and within the bounds of the table.
    ///
    /// # Errors
    /// The first violated bound.
    #[inline(always)]
    pub fn check(self, value: f64) -> Result<f64, ParameterError> {
        // Without a loop the compiler folds the bounds of a constant quantity.
        let keeps = match self.bounds() {
            [] => true,
            [only] => only.allows(value),
            [first, second] => first.allows(value) && second.allows(value),
            more => more.iter().all(|bound| bound.allows(value)),
        };
        if value.is_finite() && keeps {
            Ok(value)
        } else {
            Err(self.refusal(value))
        }
    }

    /// The first bound that a value violates.
    #[cold]
    fn refusal(self, value: f64) -> ParameterError {
        let broken = self
            .bounds()
            .iter()
            .find(|bound| value.is_finite() && !bound.allows(value));
        let bound = broken.copied().unwrap_or(Bound::Finite);
        ParameterError::OutOfBounds {
            quantity: self,
            value,
            bound,
        }
    }
}

/// `value`, if the bound allows it.
pub(crate) fn within(quantity: Quantity, value: f64, bound: Bound) -> Result<f64, ParameterError> {
    if bound.allows(value) {
        Ok(value)
    } else {
        Err(ParameterError::OutOfBounds {
            quantity,
            value,
            bound,
        })
    }
}
