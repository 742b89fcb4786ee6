//! A level orbit of rolling in the half angle, with its time as an elliptic integral.
//!
//! Simulation and engine share this geometry. Each has its own search for the slip; the engine has
//! its own time as well (`engine/orbit.rs`), and rounds the rates of points on the orbit otherwise.
//!
//! Let z = −cos(ϑ/2) = k sin ψ, zero at the bottom, where ϑ is the angle in the direction of motion
//! and k² = (K − D(π))/(4ℓ̂) in libration, k = 1 in rotation. With β = 4ℓ̂k² and κ = K − D(0), the
//! energy over the top,
//!
//! ```text
//! dτ = 2 sqrt(D / (|κ| + β cos²ψ)) dψ,     D = D(π) + β sin²ψ,
//! τ(ψ) = 2 sqrt(D(π)/γ) [s R_F(c², q², p) + β s³/(3 D(π)) R_J(c², q², p, 1)],
//! ```
//!
//! with s = sin ψ, c = cos ψ, γ = |κ| + β, q² = (|κ| + βc²)/γ, p = 1 + βs²/D(π): an integral of the
//! third kind in Carlson's symmetric form (DLMF 19.25.14). Its two terms have the same sign, so
//! nothing cancels. It holds for libration, rotation and the separatrix.
//!
//! The time between two points on the same side of the bottom, however near to each other, is a sum
//! of two terms of one sign, too, by the addition theorem (DLMF 19.11):
//!
//! ```text
//! τ(ψ1) − τ(ψ0) = τ(ψ3) + 2 arsinh(β s0 s1 s3 / sqrt(γ D(π))).
//! ```

use core::f64::consts::TAU;

use crate::math::carlson::{rf, rj};
use crate::math::trig::Angle;
use crate::mechanics::RollingLaw;

/// What the time on an orbit depends on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OrbitEnergy {
    /// D(π).
    pub(crate) bottom: f64,
    /// |κ|, with κ = K − D(0).
    pub(crate) separatrix_gap: f64,
    /// β = 4ℓ̂k².
    pub(crate) beta: f64,
}

/// Which way an orbit passes an arc, seen from its start.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum OrbitPass {
    First,
    /// Of a rotation.
    NextTurn,
    /// Of a libration, behind its turning point.
    WayBack,
}

/// The half angle within its turn.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ReducedAngle {
    pub(crate) turn: f64,
    /// −cos(ϑ/2).
    pub(crate) z: f64,
    /// sin(ϑ/2) ≥ 0.
    pub(crate) y: f64,
}

/// The orbit through a start, in the direction of motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HalfAngleOrbit {
    pub(crate) energy: OrbitEnergy,
    /// 4ℓ̂.
    pub(crate) four_l: f64,
    /// Whether it passes the top.
    pub(crate) rotates: bool,
    pub(crate) start: ReducedAngle,
    /// D ϑ′² at the start.
    pub(crate) twice_kinetic: f64,
}

impl ReducedAngle {
    /// Of an angle, from half of it.
    pub(crate) fn new(angle: f64, half: Angle) -> Self {
        let mut turn = (angle / TAU).floor();
        let half_turn = 0.5 * turn;
        let flip = if half_turn == half_turn.floor() {
            1.0
        } else {
            -1.0
        };
        let (mut x, mut y) = (flip * half.cos, flip * half.sin);
        if y < 0.0 {
            // Rounding moved the angle across a multiple of 2π.
            turn += if x > 0.0 { -1.0 } else { 1.0 };
            (x, y) = (-x, -y);
        }
        Self { turn, z: -x, y }
    }

    pub(crate) fn angle(&self) -> f64 {
        TAU * self.turn + 2.0 * libm::atan2(self.y, -self.z)
    }
}

impl HalfAngleOrbit {
    /// Through an angle, given with half of it, at a rate of any sign.
    pub(crate) fn new(law: &RollingLaw, theta: f64, half: Angle, theta_rate: f64) -> Self {
        let start = ReducedAngle::new(theta, half);
        let four_l = 4.0 * law.offset;
        let d = law.bottom + four_l * start.z * start.z;
        let twice_kinetic = d * theta_rate * theta_rate;
        // Energy relative to the top and to the bottom, with the least cancellation.
        let over_top = twice_kinetic - four_l * start.y * start.y;
        let over_bottom = twice_kinetic + four_l * start.z * start.z;
        let rotates = over_top >= 0.0;
        Self {
            energy: OrbitEnergy {
                bottom: law.bottom,
                separatrix_gap: over_top.abs(),
                beta: if rotates { four_l } else { over_bottom },
            },
            four_l,
            rotates,
            start,
            twice_kinetic,
        }
    }

    /// K − D(0), the energy over the top.
    pub(crate) fn over_top(&self) -> f64 {
        self.twice_kinetic - self.four_l * self.start.y * self.start.y
    }

    /// K − D(π), twice the energy over the bottom.
    pub(crate) fn orbit_level(&self) -> f64 {
        self.twice_kinetic + self.four_l * self.start.z * self.start.z
    }

    /// sin ψ = z/k.
    pub(crate) fn phase_sine(&self, z: f64) -> f64 {
        z * (self.four_l / self.energy.beta).sqrt()
    }

    /// ψ at z, y and D ϑ′².
    pub(crate) fn phase(&self, z: f64, y: f64, twice_kinetic: f64) -> Angle {
        if self.rotates {
            Angle { sin: z, cos: y }
        } else {
            Angle {
                sin: self.phase_sine(z).clamp(-1.0, 1.0),
                cos: (twice_kinetic.max(0.0) / self.energy.beta).sqrt(),
            }
        }
    }

    pub(crate) fn start_phase(&self) -> Angle {
        self.phase(self.start.z, self.start.y, self.twice_kinetic)
    }
}

impl OrbitEnergy {
    /// τ(ψ) − τ(0) for ψ in [−π/2, π/2].
    pub(crate) fn time_from_bottom(&self, phase: Angle) -> f64 {
        let Self {
            bottom,
            separatrix_gap,
            beta,
        } = *self;
        let gamma = separatrix_gap + beta;
        let c2 = phase.cos * phase.cos;
        let q2 = (separatrix_gap + beta * c2) / gamma;
        let lift = beta * phase.sin * phase.sin / bottom;
        let first = rf(c2, q2, 1.0 + lift);
        let third = if lift == 0.0 {
            0.0
        } else {
            lift / 3.0 * rj(c2, q2, 1.0 + lift, 1.0)
        };
        2.0 * (bottom / gamma).sqrt() * phase.sin * (first + third)
    }

    /// τ(ψ1) − τ(ψ0) from sin²ψ1 − sin²ψ0 (`gain`), which may be known better than its terms.
    pub(crate) fn time_between(&self, from: Angle, to: Angle, gain: f64) -> f64 {
        if from.sin * to.sin <= 0.0 {
            return self.time_from_bottom(to) - self.time_from_bottom(from);
        }
        if gain == 0.0 {
            return 0.0;
        }
        // The time is odd in ψ.
        let sign = 1.0_f64.copysign(gain * to.sin);
        let (first, second) = if gain < 0.0 { (to, from) } else { (from, to) };
        let (s0, c0) = (first.sin.abs(), first.cos);
        let (s1, c1) = (second.sin.abs(), second.cos);
        let Self {
            bottom,
            separatrix_gap,
            beta,
        } = *self;
        let (at_bottom, at_quarter) = (separatrix_gap + beta, bottom + beta);
        let kinetic = [c0, c1].map(|c| (separatrix_gap + beta * c * c).sqrt());
        let d = [s0, s1].map(|s| (bottom + beta * s * s).sqrt());
        // sn and cn of the difference; cn as a quotient of sums of positive terms.
        let sn = (at_bottom * at_quarter).sqrt() * gain.abs()
            / (s1 * c0 * kinetic[0] * d[1] + s0 * c1 * kinetic[1] * d[0]);
        let (a, b) = (c1 * d[0], s1 * kinetic[0]);
        let cn = (at_bottom * c0 * a * d[1] + at_quarter * s0 * b * kinetic[1])
            / (at_bottom * a * a + at_quarter * b * b);
        let (sine, cosine) = (sn * bottom.sqrt(), cn * at_quarter.sqrt());
        let length = libm::hypot(sine, cosine);
        let difference = Angle {
            sin: sine / length,
            cos: cosine / length,
        };
        let rest = beta * s0 * s1 * difference.sin / (at_bottom * bottom).sqrt();
        sign * (self.time_from_bottom(difference) + 2.0 * libm::asinh(rest))
    }
}
