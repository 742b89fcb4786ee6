//! Sliding (§2b): η′ ≠ 0, kinetic friction F = −μk N σ with σ = sign(η′) (2.15).
//!
//! With q = h sin θ − μk σ (1 + h cos θ), solving (2.16) for the accelerations gives
//!
//! ```text
//! w = 1 − h cos θ θ′²,      P = Î + m h sin θ q,
//! N = Î m w/P,              θ″ = N q/Î = m q w/P,
//! η″ = −μk σ N/m + (1 + h cos θ) θ″ − h sin θ θ′².
//! ```
//!
//! Two first integrals reduce a slide to the single function θ(τ). The horizontal and vertical balances of momentum,
//! m x̄″ = −μk σ N and m ȳ″ = N − m, have the combination x̄″ + μk σ (ȳ″ + 1) = 0, hence
//!
//! ```text
//! η′ − θ′ (1 + h cos θ + μk σ h sin θ) + μk σ τ = const,
//! x̄ + μk σ (ȳ + τ²/2) = linear in τ.
//! ```

mod arc;
mod series;

pub use arc::Sliding;
pub(crate) use arc::{Entry, SlidingEnd};

use crate::hoop::{Heavy, Hoop};
use crate::mode::Direction;
use crate::rolling::ContactForces;

/// The equations of sliding of a heavy hoop in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlidingLaw {
    body: Heavy,
    /// μk σ.
    friction: f64,
}

/// Accelerations of a motion in contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accelerations {
    /// Angular acceleration θ″.
    pub theta: f64,
    /// Acceleration η″ of the slip.
    pub slip: f64,
}

impl SlidingLaw {
    /// The law of `body` with the kinetic friction of `hoop`, slipping in `direction`.
    #[must_use]
    pub fn new(hoop: &Hoop, body: &Heavy, direction: Direction) -> Self {
        Self { body: *body, friction: hoop.mu_k() * direction.sign() }
    }

    /// w = 1 − h cos θ θ′². The body can stay in contact while w > 0; sliding lifts off where w = 0, whatever μk.
    #[must_use]
    pub fn contact(&self, theta: f64, theta_rate: f64) -> f64 {
        1.0 - self.body.h * (libm::cos(theta) * (theta_rate * theta_rate))
    }

    /// P = Î + m h sin θ q. Where P ≤ 0 sliding has no solution with N > 0, or several motions are possible.
    #[must_use]
    pub fn solvability(&self, theta: f64) -> f64 {
        let (sin, cos) = libm::sincos(theta);
        let Heavy { mass, h, inertia, .. } = self.body;
        inertia + mass * h * sin * (h * sin - self.friction * (1.0 + h * cos))
    }

    /// N = Î m w/P and F = −μk σ N (2.15, 2.18).
    #[must_use]
    pub fn forces(&self, theta: f64, theta_rate: f64) -> ContactForces {
        let normal =
            self.body.inertia * self.body.mass * self.contact(theta, theta_rate) / self.solvability(theta);
        ContactForces { normal, friction: -self.friction * normal }
    }

    /// θ″ and η″ of (2.16), solved.
    #[must_use]
    pub fn accelerations(&self, theta: f64, theta_rate: f64) -> Accelerations {
        let (sin, cos) = libm::sincos(theta);
        let Heavy { mass, h, .. } = self.body;
        let w = self.contact(theta, theta_rate);
        let p = self.solvability(theta);
        let q = h * sin - self.friction * (1.0 + h * cos);
        let theta_acceleration = mass * q * w / p;
        let normal_over_mass = self.body.inertia * w / p;
        Accelerations {
            theta: theta_acceleration,
            slip: (1.0 + h * cos) * theta_acceleration
                - self.friction * normal_over_mass
                - h * sin * theta_rate * theta_rate,
        }
    }

    /// The first integral η′ − θ′ (1 + h cos θ + μk σ h sin θ) + μk σ τ.
    #[must_use]
    pub fn momentum_integral(&self, time: f64, theta: f64, theta_rate: f64, slip: f64) -> f64 {
        slip - theta_rate * self.lever(theta) + self.friction * time
    }

    /// 1 + h cos θ + μk σ h sin θ.
    fn lever(&self, theta: f64) -> f64 {
        let (sin, cos) = libm::sincos(theta);
        1.0 + self.body.h * (cos + self.friction * sin)
    }
}
