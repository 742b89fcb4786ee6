//! What is wrong with a parameter: the quantity, its value, the bound it breaks and its unit.

use core::fmt;

use thiserror::Error;

use crate::quantity::Quantity;

/// The bound that a value breaks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bound {
    /// The value must be a finite number.
    Finite,
    /// The value must be greater than zero.
    Positive,
    /// The value must be zero or greater.
    NonNegative,
    /// The value must not exceed that of another quantity.
    AtMost(Quantity, f64),
    /// The value must not exceed a constant.
    AtMostConstant(f64),
    /// The magnitude must not exceed a constant.
    MagnitudeAtMost(f64),
    /// The value must not be less than that of another quantity.
    AtLeast(Quantity, f64),
}

impl Bound {
    /// Whether a value keeps it.
    #[inline]
    #[must_use]
    pub const fn allows(&self, value: f64) -> bool {
        match *self {
            Self::Finite => value.is_finite(),
            Self::Positive => value > 0.0,
            Self::NonNegative => value >= 0.0,
            Self::AtMost(_, most) | Self::AtMostConstant(most) => value <= most,
            Self::MagnitudeAtMost(most) => value.abs() <= most,
            Self::AtLeast(_, least) => value >= least,
        }
    }
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Finite => f.write_str("must be a finite number"),
            Self::Positive => f.write_str("must be greater than 0"),
            Self::NonNegative => f.write_str("must not be negative"),
            Self::AtMost(quantity, value) => write!(f, "must not exceed {}", Reading(*quantity, *value)),
            Self::AtMostConstant(value) => write!(f, "must not exceed {value}"),
            Self::MagnitudeAtMost(value) => write!(f, "must lie between {:e} and {value:e}", -value),
            Self::AtLeast(quantity, value) => {
                write!(f, "must not be less than {}", Reading(*quantity, *value))
            }
        }
    }
}

struct Reading(Quantity, f64);

impl fmt::Display for Reading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(quantity, value) = self;
        match quantity.unit() {
            "" => write!(f, "{quantity} = {value}"),
            unit => write!(f, "{quantity} = {value} {unit}"),
        }
    }
}

/// A parameter of a hoop or of a start that has no physical meaning.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ParameterError {
    /// One value breaks one bound.
    #[error("{} {bound}", Reading(*quantity, *value))]
    OutOfBounds {
        /// The quantity that was given.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// The bound it breaks.
        bound: Bound,
    },
    /// A single point mass at the centre: nothing resists or drives a rotation, so there is no motion.
    #[error(
        "offset = 0 and moment of inertia = 0 (mass_ratio = {mass_ratio}, inertia = 0): \
         a point mass at the centre of the hoop has no equation of motion"
    )]
    NoMotion {
        /// The mass ratio that was given.
        mass_ratio: f64,
    },
}

impl ParameterError {
    /// Advice for the person who typed the value.
    #[must_use]
    pub const fn hint(&self) -> &'static str {
        match self {
            Self::NoMotion { .. } => "give the disc a moment of inertia, or move the particle off the centre",
            Self::OutOfBounds { bound: Bound::Finite, .. } => {
                "NaN and infinities are not numbers to start from"
            }
            Self::OutOfBounds { bound: Bound::MagnitudeAtMost(_), .. } => {
                "beyond this bound a double no longer resolves the motion"
            }
            Self::OutOfBounds { quantity, .. } => quantity.hint(),
        }
    }

    /// The quantity that it is about: one of those that would have to change.
    #[must_use]
    pub const fn quantity(&self) -> Quantity {
        match self {
            Self::OutOfBounds { quantity, .. } => *quantity,
            Self::NoMotion { .. } => Quantity::Offset,
        }
    }

    /// Whether two values contradict each other that have a meaning each by itself, such as μk > μs.
    #[must_use]
    pub const fn is_contradiction(&self) -> bool {
        matches!(
            self,
            Self::NoMotion { .. }
                | Self::OutOfBounds { quantity: Quantity::MuK, bound: Bound::AtMost(..), .. }
        )
    }
}

/// Passes `value` on when the bound allows it.
pub(crate) fn within(quantity: Quantity, value: f64, bound: Bound) -> Result<f64, ParameterError> {
    if bound.allows(value) { Ok(value) } else { Err(ParameterError::OutOfBounds { quantity, value, bound }) }
}
