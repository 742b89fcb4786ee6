//! Numbers that carry derivatives: one statement of an equation gives its value, for `f64`, and its
//! derivatives, for [`Dual`].

use core::ops::{Add, Div, Mul, Neg, Sub};

use crate::math::trig::Angle;

/// A number in which an equation is written.
pub trait Number:
    Copy
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
    + Neg<Output = Self>
    + Add<f64, Output = Self>
    + Sub<f64, Output = Self>
    + Mul<f64, Output = Self>
    + Div<f64, Output = Self>
{
    fn constant(value: f64) -> Self;
    fn value(self) -> f64;
    /// A function of this number, from its value and its derivative.
    fn map(self, value: f64, derivative: f64) -> Self;

    /// Whether it is zero, and has no derivatives that are not.
    fn vanishes(self) -> bool {
        self.value() == 0.0
    }

    /// Sine and cosine, by `libm`.
    fn angle(self) -> Angle<Self> {
        let (sin, cos) = libm::sincos(self.value());
        Angle {
            sin: self.map(sin, cos),
            cos: self.map(cos, -sin),
        }
    }

    fn sqrt(self) -> Self {
        let root = self.value().sqrt();
        self.map(root, 0.5 / root)
    }

    fn abs(self) -> Self {
        self.map(self.value().abs(), 1.0_f64.copysign(self.value()))
    }
}

impl Number for f64 {
    #[inline(always)]
    fn constant(value: f64) -> Self {
        value
    }

    #[inline(always)]
    fn value(self) -> f64 {
        self
    }

    #[inline(always)]
    fn map(self, value: f64, _: f64) -> Self {
        value
    }
}

/// Number of derivatives that a value carries. Four share the series of a state. A single
/// derivative takes 1.4 times as long as with width 1; a generic width would complicate all
/// equations.
pub(crate) const WIDTH: usize = 4;

/// A value and its derivatives with respect to some quantities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Dual {
    pub(crate) value: f64,
    pub(crate) parts: [f64; WIDTH],
}

impl Dual {
    /// The same derivatives of a value that is known better.
    pub(crate) const fn at(self, value: f64) -> Self {
        Self { value, ..self }
    }
}

impl Number for Dual {
    #[inline]
    fn constant(value: f64) -> Self {
        Self {
            value,
            parts: [0.0; WIDTH],
        }
    }

    #[inline]
    fn value(self) -> f64 {
        self.value
    }

    #[inline]
    fn map(self, value: f64, derivative: f64) -> Self {
        Self {
            value,
            parts: self.parts.map(|part| derivative * part),
        }
    }

    #[inline]
    fn vanishes(self) -> bool {
        self.value == 0.0 && self.parts == [0.0; WIDTH]
    }
}

impl Add for Dual {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        let parts = core::array::from_fn(|k| self.parts[k] + other.parts[k]);
        Self {
            value: self.value + other.value,
            parts,
        }
    }
}

impl Sub for Dual {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Dual {
    type Output = Self;
    #[expect(
        clippy::suspicious_arithmetic_impl,
        reason = "the derivative of a product"
    )]
    #[inline]
    fn mul(self, other: Self) -> Self {
        let parts =
            core::array::from_fn(|k| self.parts[k] * other.value + self.value * other.parts[k]);
        Self {
            value: self.value * other.value,
            parts,
        }
    }
}

impl Div for Dual {
    type Output = Self;
    #[expect(
        clippy::suspicious_arithmetic_impl,
        reason = "the derivative of a quotient"
    )]
    #[inline]
    fn div(self, other: Self) -> Self {
        let value = self.value / other.value;
        let parts =
            core::array::from_fn(|k| (self.parts[k] - value * other.parts[k]) / other.value);
        Self { value, parts }
    }
}

impl Neg for Dual {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.map(-self.value, -1.0)
    }
}

impl Add<f64> for Dual {
    type Output = Self;
    #[inline]
    fn add(self, other: f64) -> Self {
        self.at(self.value + other)
    }
}

impl Sub<f64> for Dual {
    type Output = Self;
    #[inline]
    fn sub(self, other: f64) -> Self {
        self.at(self.value - other)
    }
}

impl Mul<f64> for Dual {
    type Output = Self;
    #[inline]
    fn mul(self, other: f64) -> Self {
        self.map(self.value * other, other)
    }
}

impl Div<f64> for Dual {
    type Output = Self;
    #[inline]
    fn div(self, other: f64) -> Self {
        Self {
            value: self.value / other,
            parts: self.parts.map(|part| part / other),
        }
    }
}
