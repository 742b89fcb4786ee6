//! Sums of two doubles, for expected values with twice the digits.

use std::ops::{Add, Mul, Neg, Sub};

/// A number as a double and what it leaves.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Dd {
    pub(crate) high: f64,
    low: f64,
}

/// π/2 as a sum of three doubles.
const HALF_PI: [f64; 3] = [
    std::f64::consts::FRAC_PI_2,
    6.123_233_995_736_766e-17,
    -1.497_384_904_859_169_8e-33,
];

impl From<f64> for Dd {
    fn from(high: f64) -> Self {
        Self { high, low: 0.0 }
    }
}

impl Dd {
    /// a + b for |a| ≥ |b|.
    fn ordered(a: f64, b: f64) -> Self {
        let high = a + b;
        Self {
            high,
            low: b - (high - a),
        }
    }

    /// a + b, exactly.
    fn sum(a: f64, b: f64) -> Self {
        let high = a + b;
        let part = high - a;
        Self {
            high,
            low: (a - (high - part)) + (b - part),
        }
    }

    /// a b, exactly: halves of 26 bits have products that are doubles.
    fn product(a: f64, b: f64) -> Self {
        let halves = |x: f64| {
            let scaled = 134_217_729.0 * x;
            let high = scaled - (scaled - x);
            (high, x - high)
        };
        let ((a_high, a_low), (b_high, b_low)) = (halves(a), halves(b));
        let high = a * b;
        let low = ((a_high * b_high - high) + a_high * b_low + a_low * b_high) + a_low * b_low;
        Self { high, low }
    }

    /// An angle without the turns in it.
    pub(crate) fn without_turns(self) -> Self {
        let quarters = 4.0 * (self.high / (4.0 * HALF_PI[0])).round();
        HALF_PI
            .iter()
            .fold(self, |rest, part| rest - Self::product(quarters, *part))
    }

    /// Sine and cosine, by their series about the next multiple of π/2.
    pub(crate) fn sincos(self) -> (Self, Self) {
        let multiple = (self.high / HALF_PI[0]).round();
        let rest = HALF_PI
            .iter()
            .fold(self, |rest, part| rest - Self::product(multiple, *part));
        let square = rest * rest;
        let (mut sin, mut cos) = (Self::from(0.0), Self::from(0.0));
        let (mut odd, mut even) = (rest, Self::from(1.0));
        for k in 0..15 {
            (sin, cos) = (sin + odd, cos + even);
            let n = 2.0 * f64::from(k);
            even = -(even * square).over((n + 1.0) * (n + 2.0));
            odd = -(odd * square).over((n + 2.0) * (n + 3.0));
        }
        match multiple.rem_euclid(4.0) as u8 {
            0 => (sin, cos),
            1 => (cos, -sin),
            2 => (-sin, -cos),
            _ => (-cos, sin),
        }
    }

    /// The quotient by a double.
    fn over(self, divisor: f64) -> Self {
        let quotient = self.high / divisor;
        let rest = self - Self::product(quotient, divisor);
        Self::ordered(quotient, rest.high / divisor)
    }
}

impl Add for Dd {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let (high, low) = (
            Self::sum(self.high, other.high),
            Self::sum(self.low, other.low),
        );
        let sum = Self::ordered(high.high, high.low + low.high);
        Self::ordered(sum.high, sum.low + low.low)
    }
}

impl Neg for Dd {
    type Output = Self;

    fn neg(self) -> Self {
        Self {
            high: -self.high,
            low: -self.low,
        }
    }
}

impl Sub for Dd {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        self + -other
    }
}

impl Mul for Dd {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        let product = Self::product(self.high, other.high);
        Self::ordered(
            product.high,
            product.low + (self.high * other.low + self.low * other.high),
        )
    }
}
