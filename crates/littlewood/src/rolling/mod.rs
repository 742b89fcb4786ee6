//! Rolling (§2a, §3a): η′ = 0, held by static friction.
//!
//! With D(θ) = Î + m(1 + h² + 2h cos θ), the denominator of (2.11), energy conservation reads
//!
//! ```text
//! D(θ) (θ′² + 1) = K,     K = 2E + Î + m(1 + h²) constant,
//! ```
//!
//! so that θ′², θ″, N and F are functions of θ alone on an orbit: rolling is algebraic. [`orbit`] gives the time as
//! an elliptic integral, [`boundary`] the angle at which static friction gives way as a root of a polynomial.

mod boundary;
mod orbit;
mod recurrence;
mod rim;

pub use boundary::RollingLimit;
pub(crate) use orbit::Hold;
pub use orbit::{RollingEnd, RollingOrbit};
pub use recurrence::{Recurrence, RecurrenceKind};

use crate::hoop::{Body, Hoop};
use crate::mode::Mode;
use crate::state::{Instant, Sample, State};

/// The equation of rolling of one body, massless or not: what (2.10) to (2.12) depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingLaw {
    mass: f64,
    offset: f64,
    /// D(0) = Î + m(1 + h)².
    top: f64,
    /// D(π) = Î + m(1 − h)². Zero only for a massless hoop with the particle on the rim.
    bottom: f64,
}

/// Contact forces, over m2 g.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactForces {
    /// Normal force N.
    pub normal: f64,
    /// Friction force F along E1.
    pub friction: f64,
}

impl ContactForces {
    /// Friction demand |F|/N: the coefficient of friction that this motion needs. Infinite for N ≤ 0.
    #[must_use]
    pub fn demand(&self) -> f64 {
        if self.normal > 0.0 { self.friction.abs() / self.normal } else { f64::INFINITY }
    }
}

impl RollingLaw {
    /// The law of a hoop.
    #[must_use]
    pub fn new(hoop: &Hoop) -> Self {
        let (m, h) = (hoop.mass(), hoop.h());
        let inertia = match hoop.body() {
            Body::Heavy(heavy) => heavy.inertia,
            Body::Massless(_) => 0.0,
        };
        Self {
            mass: m,
            offset: hoop.offset(),
            top: inertia + m * (1.0 + h) * (1.0 + h),
            bottom: inertia + m * (1.0 - h) * (1.0 - h),
        }
    }

    /// D(θ), the denominator of (2.11): twice the kinetic energy of rolling over θ′².
    #[must_use]
    pub fn denominator(&self, theta: f64) -> f64 {
        let cos_half = libm::cos(0.5 * theta);
        self.bottom + 4.0 * self.offset * cos_half * cos_half
    }

    /// Angular acceleration θ″ = f_R(θ, θ′) (2.11). Not defined where D = 0 (footnote 8).
    #[must_use]
    pub fn theta_acceleration(&self, theta: f64, theta_rate: f64) -> f64 {
        self.offset * libm::sin(theta) * (1.0 + theta_rate * theta_rate) / self.denominator(theta)
    }

    /// Normal and friction force (2.12). In 𝓡 of (2.14) they hold the body in rolling; elsewhere they say what
    /// would be needed.
    #[must_use]
    pub fn forces(&self, theta: f64, theta_rate: f64) -> ContactForces {
        let (sin, cos) = libm::sincos(theta);
        let u = theta_rate * theta_rate;
        let acceleration = self.theta_acceleration(theta, theta_rate);
        ContactForces {
            normal: self.mass - self.offset * (sin * acceleration + cos * u),
            friction: self.offset * sin * u - (self.mass + self.offset * cos) * acceleration,
        }
    }

    /// Conserved energy E = D θ′²/2 + ℓ̂ cos θ (2.8, and 3.2 for Littlewood's hoop).
    #[must_use]
    pub fn energy(&self, theta: f64, theta_rate: f64) -> f64 {
        0.5 * self.denominator(theta) * theta_rate * theta_rate + self.offset * libm::cos(theta)
    }

    /// Energy on the separatrix through the unstable equilibrium, E = ℓ̂.
    #[must_use]
    pub const fn separatrix_energy(&self) -> f64 {
        self.offset
    }
}

/// Coefficients of (μs N − F) D² and (μs N + F) D² as forms of degree six in (cos θ/2, sin θ/2) on the orbit with
/// constant K; none for a massless hoop.
pub(crate) fn margin_forms(hoop: &Hoop, k: f64) -> Option<[[f64; 7]; 2]> {
    boundary::Boundary::new(hoop, &RollingLaw::new(hoop), k).heavy_forms()
}

/// A phase of rolling: an orbit entered at a state.
#[derive(Clone, Copy, Debug)]
pub struct Rolling {
    law: RollingLaw,
    orbit: RollingOrbit,
    start: State,
}

impl Rolling {
    pub(crate) fn new(hoop: &Hoop, start: State) -> Self {
        let start = State { slip: 0.0, ..start };
        Self {
            law: RollingLaw::new(hoop),
            orbit: RollingOrbit::new(hoop, start.theta, start.theta_rate),
            start,
        }
    }

    /// The orbit in the (θ, θ′) plane.
    #[must_use]
    pub const fn orbit(&self) -> &RollingOrbit {
        &self.orbit
    }

    /// State after the time `elapsed` since the phase began. The cost does not depend on `elapsed`.
    #[must_use]
    pub fn state(&self, elapsed: f64) -> State {
        if elapsed == 0.0 {
            return self.start;
        }
        let (theta, theta_rate) = self.orbit.position(elapsed);
        self.state_at(theta, theta_rate, elapsed)
    }

    /// The constraint x + θ = const of rolling gives the position.
    pub(crate) fn state_at(&self, theta: f64, theta_rate: f64, elapsed: f64) -> State {
        State {
            time: self.start.time + elapsed,
            theta,
            theta_rate,
            slip: 0.0,
            x: self.start.x - (theta - self.start.theta),
        }
    }

    pub(crate) fn sample(&self, hoop: &Hoop, state: State) -> Sample {
        let forces = self.law.forces(state.theta, state.theta_rate);
        let instant = Instant {
            mode: Mode::Rolling,
            direction: None,
            accelerations: (self.law.theta_acceleration(state.theta, state.theta_rate), 0.0),
            forces: (forces.normal, forces.friction),
            gap: (0.0, 0.0),
        };
        instant.sample(hoop, state)
    }
}
