//! Littlewood's hoop in closed form (§3): massless, with the particle on the rim unless a function
//! takes an offset.
//!
//! Angles are in radians, times in √(R/g), energies in m2 g R. Misprints of the paper are
//! corrected; the documentation quotes the printed formula.

use crate::model::{Massless, Start, named};

/// Conserved energy of rolling, e = (1 + cos θ) θ′² + cos θ (3.2).
pub fn rolling_energy(theta: f64, theta_rate: f64) -> f64 {
    let cos = libm::cos(theta);
    (1.0 + cos) * theta_rate * theta_rate + cos
}

/// α = sin(θ0/2) + θ0′ cos(θ0/2), the amplitude of the growing exponential in (3.3).
///
/// Printed in (3.4) as sin(θ0/2) + √((e0 − cos θ0)/2), which holds for θ0′ ≥ 0 only.
pub fn alpha(theta: f64, theta_rate: f64) -> f64 {
    let (sin, cos) = libm::sincos(0.5 * theta);
    sin + theta_rate * cos
}

/// sin(θ/2) in rolling from any start, after Δτ:
///
/// ```text
/// sin(θ/2) = sin(θ0/2) cosh(Δτ/2) + θ0′ cos(θ0/2) sinh(Δτ/2).
/// ```
///
/// This is (3.3) with α corrected, with exponents ±(τ − τ0)/2 (printed: τ − τ0/2), and without the
/// division by α, which vanishes on the stable manifold. It contains (3.5) to (3.7). A magnitude
/// above 1 means that the particle has reached the plane: the motion has ended.
pub fn rolling_half_sine(start: &Start, elapsed: f64) -> f64 {
    let (sin, cos) = libm::sincos(0.5 * start.theta);
    sin * libm::cosh(0.5 * elapsed) + start.theta_rate * cos * libm::sinh(0.5 * elapsed)
}

/// θ in rolling after Δτ, for |θ0| ≤ π; `None` after the particle has reached the plane.
pub fn rolling_angle(start: &Start, elapsed: f64) -> Option<f64> {
    let sine = rolling_half_sine(start, elapsed);
    (sine.abs() <= 1.0).then(|| 2.0 * libm::asin(sine))
}

/// Time in which rolling, without slip and loss of contact, brings the particle to the plane, θ =
/// ±π; `None` on the stable manifold.
pub fn rolling_time_to_plane(theta: f64, theta_rate: f64) -> Option<f64> {
    let growing = alpha(theta, theta_rate);
    if growing == 0.0 {
        return None;
    }
    // Z = ±1 is reached moving outward: Z + 2Z′ = α e^(Δτ/2), with 4Z′² = 1 − Z0² + 4Z0′² =
    // cos²(θ0/2) (1 + θ0′²).
    let cos = libm::cos(0.5 * theta);
    let rate = cos.abs() * (1.0 + theta_rate * theta_rate).sqrt();
    Some(2.0 * libm::log((1.0 + rate) / growing.abs()))
}

/// θ′ on the stable manifold W^s of the equilibrium θ = 0: e = 1, θ′ = −tan(θ/2) (3.7).
pub fn stable_manifold_rate(theta: f64) -> f64 {
    -libm::tan(0.5 * theta)
}

/// θ′ on the unstable manifold W^u: e = 1, θ′ = tan(θ/2) (3.7).
pub fn unstable_manifold_rate(theta: f64) -> f64 {
    libm::tan(0.5 * theta)
}

/// Normal force in rolling, N = cos²(θ/2) (1 − θ′²) (3.8).
pub fn rolling_normal(theta: f64, theta_rate: f64) -> f64 {
    let cos = libm::cos(0.5 * theta);
    cos * cos * (1.0 - theta_rate * theta_rate)
}

/// Friction force in rolling, F = (θ′² − 1) cos(θ/2) sin(θ/2) (3.8).
pub fn rolling_friction(theta: f64, theta_rate: f64) -> f64 {
    let (sin, cos) = libm::sincos(0.5 * theta);
    (theta_rate * theta_rate - 1.0) * cos * sin
}

/// Angle θ_s > 0 at which slip begins (3.9): θ_s = 2 atan μs for the particle on the rim (53.13°
/// for μs = 0.5; the caption of Figure 5 has half of it).
///
/// For ℓ̂ < 1 (footnote 7) |F|/N = ℓ̂|sin θ|/(1 + ℓ̂ cos θ), so θ_s = atan μs + asin(μs/(ℓ̂ √(1 +
/// μs²))); `None` for μs > ℓ̂/√(1 − ℓ̂²), where static friction always suffices.
pub fn slip_angle(hoop: &Massless, mu_s: f64) -> Option<f64> {
    if hoop.offset == 1.0 {
        return Some(2.0 * libm::atan(mu_s));
    }
    let sine = mu_s / (hoop.offset * (1.0 + mu_s * mu_s).sqrt());
    (sine <= 1.0).then(|| libm::atan(mu_s) + libm::asin(sine))
}

/// Region 𝓡 of Littlewood's hoop (3.10): |θ| < θ_s, |θ′| < 1.
pub fn in_rolling_region(start: &Start, mu_s: f64) -> bool {
    start.theta.abs() < 2.0 * libm::atan(mu_s) && start.theta_rate.abs() < 1.0
}

named! {
    /// The three types of motion from 𝓡 (§3a). On the stable manifold, e = 1, a motion has none.
    pub enum RollingType, "type of rolling" {
        /// N vanishes before slip begins: 1 + 2 cos θ_s < e < 3.
        I = 1, "I";
        /// N vanishes as slip begins: e = 1 + 2 cos θ_s.
        II = 2, "II";
        /// Slip begins with N > 0: cos θ_s < e < 1 + 2 cos θ_s.
        III = 3, "III";
    }
}

/// cos θ_s = (1 − μs²)/(1 + μs²) of the particle on the rim.
fn slip_cosine(mu_s: f64) -> f64 {
    let square = mu_s * mu_s;
    (1.0 - square) / (1.0 + square)
}

impl RollingType {
    /// Energy of Type II, 1 + 2 cos θ_s: that of the corners of 𝓡. Above μs = 1 it is less than
    /// that of the equilibrium, 1, and motions of Type II turn back before they reach the top.
    pub fn energy_of_ii(mu_s: f64) -> f64 {
        1.0 + 2.0 * slip_cosine(mu_s)
    }

    /// The type of a motion of energy e (3.2); `None` outside (cos θ_s, 3), the energies in 𝓡.
    pub fn of_energy(energy: f64, mu_s: f64) -> Option<Self> {
        let (cos, both) = (slip_cosine(mu_s), Self::energy_of_ii(mu_s));
        if energy <= cos || energy >= 3.0 || energy.is_nan() {
            None
        } else if energy > both {
            Some(Self::I)
        } else if energy < both {
            Some(Self::III)
        } else {
            Some(Self::II)
        }
    }
}

/// Time at which a hoop that rolls from the top (θ0 = 0) begins to slip: τ = 2
/// asinh(sin(θ_s/2)/θ0′) by (3.6).
pub fn slip_time_from_top(theta_rate: f64, mu_s: f64) -> f64 {
    let sine = mu_s / (1.0 + mu_s * mu_s).sqrt();
    2.0 * libm::asinh(sine / theta_rate.abs())
}

/// Time at which N = 0 for a hoop that rolls from the top with |θ0′| ≤ 1: τ = arccosh(1/θ0′²),
/// where cos θ = θ0′².
pub fn unloading_time_from_top(theta_rate: f64) -> f64 {
    libm::acosh(1.0 / (theta_rate * theta_rate))
}

/// Duration of a glide from (θ0, θ0′) to θ = ±π, the positive root of (3.20):
/// τ_g − τ0 = −θ0′ sin θ0 + √(θ0′² sin²θ0 + 2(1 + cos θ0)).
pub fn gliding_time_to_plane(theta: f64, theta_rate: f64) -> f64 {
    let rise = -theta_rate * libm::sin(theta);
    let cos_half = libm::cos(0.5 * theta);
    let height = 2.0 * cos_half * cos_half;
    let root = (rise * rise + 2.0 * height).sqrt();
    if rise >= 0.0 {
        rise + root
    } else {
        2.0 * height / (root - rise)
    }
}

/// Position of the particle (mass centre) of a gliding hoop relative to x̄0, after Δτ (3.19): a
/// parabola, or a vertical line if η0′ = θ0′ (1 + cos θ0).
pub fn gliding_path(start: &Start, elapsed: f64) -> (f64, f64) {
    let (rate, slip) = (start.theta_rate, start.slip);
    let (sin, cos) = libm::sincos(start.theta);
    (
        (slip - rate * (1.0 + cos)) * elapsed,
        1.0 + cos - rate * sin * elapsed - 0.5 * elapsed * elapsed,
    )
}
