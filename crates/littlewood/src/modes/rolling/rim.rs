//! Rolling of Littlewood's hoop, massless with the particle on the rim (§3a), in closed form
//! (docs/theory/rolling.md).
//!
//! D = 2(1 + cos θ) vanishes at θ = ±π, and Z = sin(θ/2) = a cosh(Δτ/2) + b sinh(Δτ/2), with a = Z0
//! and b = 2Z0′ = θ0′ cos(θ0/2). This is (3.3) without division by α: the α of (3.4) is a + b, for
//! θ0′ of either sign.

use core::f64::consts::TAU;

use crate::model::SlipDirection;

use super::boundary::{RollingEnd, RollingLimit, Stiction};
use super::recurrence::Recurrence;

#[derive(Clone, Copy, Debug)]
pub(super) struct RimOrbit {
    /// Number of turns to the nearest top.
    turn: f64,
    /// Z0 = sin(θ0/2) and 2Z0′.
    a: f64,
    b: f64,
    theta_rate: f64,
    /// sin²(θ_s/2) of (3.9).
    slip: f64,
}

impl RimOrbit {
    pub(super) fn new(mu_s: f64, theta: f64, theta_rate: f64) -> Self {
        let turn = (theta / TAU).round();
        let (sin, cos) = libm::sincos(0.5 * theta);
        let flip = if cos < 0.0 { -1.0 } else { 1.0 };
        Self {
            turn,
            a: flip * sin,
            b: theta_rate * cos.abs(),
            theta_rate,
            slip: mu_s * mu_s / (1.0 + mu_s * mu_s),
        }
    }

    pub(super) fn position(&self, elapsed: f64) -> (f64, f64) {
        if self.a == 0.0 && self.b == 0.0 {
            return (TAU * self.turn, 0.0);
        }
        let growth = libm::exp(0.5 * elapsed);
        let (out, back) = (
            0.5 * (self.a + self.b) * growth,
            0.5 * (self.a - self.b) / growth,
        );
        self.angle(out + back, out - back)
    }

    /// θ and θ′ from Z and 2Z′.
    fn angle(&self, z: f64, twice_rate: f64) -> (f64, f64) {
        let x = (1.0 - z * z).max(0.0).sqrt();
        (TAU * self.turn + 2.0 * libm::atan2(z, x), twice_rate / x)
    }

    /// sin²(θ/2) at N = 0, that is, θ′² = 1, on this orbit.
    fn unloaded(&self) -> f64 {
        0.5 * (1.0 + self.a * self.a - self.b * self.b)
    }

    pub(super) fn end(&self) -> Option<RollingEnd> {
        let outward = SlipDirection::of_sign(self.a + self.b)?;
        let unloaded = self.unloaded();
        let (square, limit) = if unloaded <= self.slip {
            (unloaded, RollingLimit::NormalForce)
        } else {
            (self.slip, RollingLimit::Friction(outward))
        };
        let z = outward.sign() * square.sqrt();
        let twice_rate =
            outward.sign() * (square - self.a * self.a + self.b * self.b).max(0.0).sqrt();
        let elapsed = 2.0 * libm::log((z + twice_rate) / (self.a + self.b));
        let (theta, theta_rate) = self.angle(z, twice_rate);
        Some(RollingEnd {
            elapsed: elapsed.max(0.0),
            theta,
            theta_rate,
            limit,
        })
    }

    pub(super) fn recurrence(&self) -> Recurrence {
        if self.a == 0.0 && self.b == 0.0 {
            Recurrence::Rest
        } else {
            Recurrence::Asymptotic {
                theta: TAU * self.turn,
            }
        }
    }

    pub(super) fn stiction(&self) -> Stiction {
        let inward = self.a * self.b < 0.0;
        let unloading = 1.0 - self.theta_rate * self.theta_rate;
        if unloading < 0.0 || (unloading == 0.0 && !inward) {
            return Stiction::NoNormalForce;
        }
        let margin = self.slip - self.a * self.a;
        if margin > 0.0 || (margin == 0.0 && (inward || (self.a == 0.0 && self.b == 0.0))) {
            Stiction::Holds
        } else {
            match SlipDirection::of_sign(self.a).or_else(|| SlipDirection::of_sign(self.b)) {
                Some(direction) => Stiction::Slips {
                    direction,
                    excess: -margin,
                },
                None => Stiction::Holds,
            }
        }
    }
}
