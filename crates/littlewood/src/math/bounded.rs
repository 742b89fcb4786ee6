//! Numbers that carry a bound of their rounding: an equation written for a [`Number`] gives with
//! them the sign of its value, where rounding does not decide it.
//!
//! Running error analysis (N. J. Higham, Accuracy and Stability of Numerical Algorithms, §3.3):
//! each operation adds half a unit in the last place of its result to what it inherits.

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::math::number::Number;

/// A value, and a bound of its distance from the exact one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Bounded {
    pub(crate) value: f64,
    pub(crate) bound: f64,
}

/// The bounds themselves are rounded: by less than this, in a few thousand operations.
const ROUNDING_OF_BOUNDS: f64 = 1.0 + 1e-12;

impl Bounded {
    /// A number that is known to its last place.
    pub(crate) fn rounded(value: f64) -> Self {
        Self::with(value, 0.0)
    }

    /// A result that has inherited `bound`.
    fn with(value: f64, bound: f64) -> Self {
        let last_place = if value == 0.0 && bound == 0.0 {
            0.0
        } else {
            (0.5 * f64::EPSILON * value.abs()).max(f64::MIN_POSITIVE)
        };
        Self {
            value,
            bound: (bound + last_place) * ROUNDING_OF_BOUNDS,
        }
    }

    /// Whether the number is positive; none if rounding decides.
    pub(crate) fn is_positive(self) -> Option<bool> {
        if self.value > self.bound {
            Some(true)
        } else if self.value <= -self.bound {
            Some(false)
        } else {
            None
        }
    }

    /// Whether the number is not negative; none if rounding decides.
    pub(crate) fn is_non_negative(self) -> Option<bool> {
        (-self).is_positive().map(|is_negative| !is_negative)
    }

    /// Whether the number is zero without any rounding.
    pub(crate) const fn is_exactly_zero(self) -> bool {
        self.value == 0.0 && self.bound == 0.0
    }
}

impl Number for Bounded {
    fn constant(value: f64) -> Self {
        Self { value, bound: 0.0 }
    }

    fn value(self) -> f64 {
        self.value
    }

    /// Functions are rounded to the last place, not to half of it.
    fn map(self, value: f64, derivative: f64) -> Self {
        let last_place = 0.5 * f64::EPSILON * value.abs();
        Self::with(value, derivative.abs() * self.bound + last_place)
    }

    fn abs(self) -> Self {
        if self.value < 0.0 { -self } else { self }
    }
}

impl Add for Bounded {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        let sum = self.value + other.value;
        // A sum with zero is exact.
        if self.is_exactly_zero() || other.is_exactly_zero() {
            return Self {
                value: sum,
                bound: self.bound + other.bound,
            };
        }
        Self::with(sum, self.bound + other.bound)
    }
}

impl Sub for Bounded {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Bounded {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        let inherited = self.value.abs() * other.bound
            + other.value.abs() * self.bound
            + self.bound * other.bound;
        let product = self.value * other.value;
        // A product with a sign, or with zero, is exact.
        let is_exact =
            |factor: Self| factor.bound == 0.0 && [0.0, 1.0].contains(&factor.value.abs());
        if is_exact(self) || is_exact(other) {
            return Self {
                value: product,
                bound: inherited,
            };
        }
        // Underflow loses all of it.
        let lost = if product == 0.0 {
            f64::MIN_POSITIVE
        } else {
            0.0
        };
        Self::with(product, inherited + lost)
    }
}

impl Div for Bounded {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        let quotient = self.value / other.value;
        let least = other.value.abs() - other.bound;
        if self.is_exactly_zero() && least > 0.0 {
            return self;
        }
        let bound = if least > 0.0 {
            (self.bound + quotient.abs() * other.bound) / least
        } else {
            f64::INFINITY
        };
        Self::with(quotient, bound)
    }
}

impl Neg for Bounded {
    type Output = Self;
    fn neg(self) -> Self {
        Self {
            value: -self.value,
            ..self
        }
    }
}

/// Operations with a number that is exact.
macro_rules! with_exact {
    ($( $operation:ident $method:ident; )+) => {
        $( impl $operation<f64> for Bounded {
            type Output = Self;
            fn $method(self, exact: f64) -> Self {
                $operation::$method(self, Self::constant(exact))
            }
        } )+
    };
}

with_exact! {
    Add add;
    Sub sub;
    Mul mul;
    Div div;
}
