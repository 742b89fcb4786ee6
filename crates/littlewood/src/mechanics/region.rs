//! The (θ, θ′) plane of rolling: regions 𝓝 and 𝓡 (2.14), their boundaries, the separatrix and the
//! equilibria.

use core::f64::consts::{PI, TAU};

use crate::math::number::Number;
use crate::math::trig::Angle;
use crate::mechanics::{ContactForces, Loads, RollingLaw};
use crate::model::{Body, Hoop, RotationDirection, SlipDirection};

/// The phase plane of the rolling motions of one hoop.
///
/// With rolling resistance rolling one way has other limits than rolling the other, no energy
/// integral, and a band of rest instead of equilibria. Curves and regions in a window are then those
/// of each way; a rate that is one function of the angle is that of lift-off only.
///
/// ```
/// use littlewood::theory::PhasePlane;
/// use littlewood::{SlipDirection, Hoop};
///
/// let plane = PhasePlane::new(&Hoop::equal_masses(0.5, 0.4)?);
/// assert!(plane.in_rolling_region(0.5, 0.2));
/// let rate = plane.slip_rate(4.0, SlipDirection::Positive).expect("the curve f passes over θ = 4");
/// let forces = plane.forces(4.0, rate);
/// assert!((forces.demand() - 0.5).abs() < 1e-14);
/// # Ok::<(), littlewood::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct PhasePlane {
    /// In units in which gravity normal to the plane is 1; rates there are those of the plane over
    /// `pace`.
    pub(super) law: RollingLaw,
    pub(super) hoop: Hoop,
    pub(super) pace: f64,
}

/// Stability of an equilibrium in rolling.
#[derive(Clone, Copy, Debug, PartialEq)]
#[expect(missing_docs, reason = "the text of each says what its fields are")]
pub enum Stability {
    /// Centre, with the angular frequency of small oscillations, √(ℓ̂/D(π)) on a level plane.
    Stable { frequency: f64 },
    /// Saddle, with exponents ±√(ℓ̂/D(0)) on a level plane.
    Unstable { exponent: f64 },
    /// Homogeneous disc: every angle is an equilibrium.
    Neutral,
}

/// An equilibrium of (2.10), at θ′ = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equilibrium {
    /// Angle.
    pub theta: f64,
    /// Stability.
    pub stability: Stability,
}

impl PhasePlane {
    /// The phase plane of a hoop.
    #[must_use]
    pub fn new(hoop: &Hoop) -> Self {
        Self {
            law: RollingLaw::of(hoop),
            hoop: *hoop,
            pace: hoop.pace(),
        }
    }

    /// Whether rolling is the same in both directions.
    pub(super) fn is_even(&self) -> bool {
        self.hoop.rolling_resistance() == 0.0
    }

    /// Normal and friction force of rolling (2.12), or of rest where rolling resistance holds it.
    pub fn forces(&self, theta: f64, theta_rate: f64) -> ContactForces {
        let ContactForces { normal, friction } =
            self.forces_at_unit_gravity(theta, theta_rate / self.pace);
        let weight = self.pace * self.pace;
        ContactForces {
            normal: weight * normal,
            friction: weight * friction,
        }
    }

    /// The same in units in which gravity normal to the plane is 1.
    pub(crate) fn forces_at_unit_gravity(&self, theta: f64, rate: f64) -> ContactForces {
        self.law.forces(theta, rate)
    }

    /// Region 𝓝 of (2.14): N > 0.
    pub fn in_contact_region(&self, theta: f64, theta_rate: f64) -> bool {
        self.forces(theta, theta_rate).normal > 0.0
    }

    /// Region 𝓡 of (2.14): |F| ≤ μs N and N > 0. For Littlewood's hoop (3.10): |θ| ≤ θ_s and
    /// |θ′| < 1.
    pub fn in_rolling_region(&self, theta: f64, theta_rate: f64) -> bool {
        let forces = self.forces(theta, theta_rate);
        forces.normal > 0.0 && forces.friction.abs() <= self.hoop.mu_s() * forces.normal
    }

    /// N and F of rolling one way as linear functions of u = θ′² at an angle, in units in which
    /// gravity normal to the plane is 1: the constants and the slopes. None where pressing would
    /// close the gap, Dχ ≤ 0.
    pub(super) fn line(
        &self,
        theta: f64,
        rotation: RotationDirection,
    ) -> Option<[ContactForces; 2]> {
        if self.is_even() {
            let (angle, d) = (theta.angle(), self.law.denominator(theta));
            let forces = |gravity, u| self.law.forces_at(angle, Loads { gravity, u }, d);
            return Some([forces(1.0, 0.0), forces(0.0, 1.0)]);
        }
        let (angle, law) = (Angle::of(theta), self.resisted_law(rotation));
        let [constant, at_one] = [0.0, 1.0].map(|u| law.forces(angle, u));
        let slope = ContactForces {
            normal: at_one.normal - constant.normal,
            friction: at_one.friction - constant.friction,
        };
        law.presses(angle).then_some([constant, slope])
    }

    /// |θ′| on the curve n, N = 0 in rolling; `None` where N ≠ 0 at every rate.
    pub fn normal_force_rate(&self, theta: f64) -> Option<f64> {
        self.is_even()
            .then(|| self.normal_force_rate_of(theta, RotationDirection::Positive))?
    }

    /// The same of rolling one way.
    pub(super) fn normal_force_rate_of(
        &self,
        theta: f64,
        rotation: RotationDirection,
    ) -> Option<f64> {
        let [constant, slope] = self.line(theta, rotation)?;
        self.rate_of(-constant.normal / slope.normal)
    }

    /// |θ′| on the branch of the curve f, |F| = μs N with N ≥ 0 in rolling, where slip begins in this direction; `None`
    /// where the branch has no point at θ. For a massless hoop f is a vertical line:
    /// [`crate::mechanics::closed_form::slip_angle`].
    pub fn slip_rate(&self, theta: f64, direction: SlipDirection) -> Option<f64> {
        self.is_even()
            .then(|| self.slip_rate_of(theta, direction, RotationDirection::Positive))?
    }

    /// The same of rolling one way.
    pub(super) fn slip_rate_of(
        &self,
        theta: f64,
        direction: SlipDirection,
        rotation: RotationDirection,
    ) -> Option<f64> {
        if matches!(self.hoop.body(), Body::Massless(_)) {
            return None;
        }
        let [constant, slope] = self.line(theta, rotation)?;
        let cone = direction.sign() * self.hoop.mu_s();
        let u =
            -(constant.friction + cone * constant.normal) / (slope.friction + cone * slope.normal);
        let rate = self.rate_of(u)?;
        (constant.normal + slope.normal * u >= 0.0).then_some(rate)
    }

    /// |θ′| of lift-off from sliding, h cos θ θ′² = cos α, independent of μk. Below this curve and above n the body slides at
    /// once, although rolling would require N < 0.
    pub fn lift_off_rate(&self, theta: f64) -> Option<f64> {
        self.rate_of(1.0 / (self.hoop.h() * libm::cos(theta)))
    }

    /// |θ′| on the separatrix through the unstable equilibrium, θ′² = 4ℓ̂ sin²(θ/2)/D(θ) on a level plane. On a slope it is that of the
    /// equilibrium next downhill from θ, which bounds the well; zero where it does not reach θ, and with rolling resistance.
    pub fn separatrix_rate(&self, theta: f64) -> f64 {
        if !self.is_even() {
            return 0.0;
        }
        if self.hoop.slope() == 0.0 {
            return self
                .level_rate(theta, self.law.separatrix_energy())
                .unwrap_or(0.0);
        }
        let Some([unstable, _]) = self.law.equilibria() else {
            return 0.0;
        };
        let turns = (theta - unstable) / TAU;
        let is_uphill = self.hoop.slope() > 0.0;
        let saddle = unstable
            + TAU
                * if is_uphill {
                    turns.ceil()
                } else {
                    turns.floor()
                };
        let kinetic = self.law.energy(saddle, 0.0) - self.law.energy(theta, 0.0);
        self.rate_of(2.0 * kinetic / self.law.denominator(theta))
            .unwrap_or(0.0)
    }

    /// |θ′| on the orbit of energy E, θ′² = 2(E − ℓ̂ cos θ)/D(θ) on a level plane; `None` where the orbit does not reach θ. On a slope E
    /// is that of [`RollingLaw::energy`].
    pub fn level_rate(&self, theta: f64, energy: f64) -> Option<f64> {
        if !self.is_even() {
            return None;
        }
        let kinetic = if self.hoop.slope() == 0.0 {
            let sin_half = libm::sin(0.5 * theta);
            // E − ℓ̂ cos θ, without cancellation near the top.
            (energy - self.hoop.offset()) + 2.0 * self.hoop.offset() * sin_half * sin_half
        } else {
            energy / (self.pace * self.pace) - self.law.energy(theta, 0.0)
        };
        self.rate_of(2.0 * kinetic / self.law.denominator(theta))
    }

    /// The equilibria of rolling in (−π, π]; none where the slope exceeds asin h. A massless hoop
    /// with the particle on the rim of a level plane has none at θ = π (§3a).
    pub fn equilibria(&self) -> Vec<Equilibrium> {
        if !self.is_even() {
            return Vec::new();
        }
        let offset = self.hoop.offset();
        let Some([unstable, stable]) = self.law.equilibria() else {
            let neutral = |theta| Equilibrium {
                theta,
                stability: Stability::Neutral,
            };
            return if self.hoop.slope() == 0.0 {
                [0.0, PI].map(neutral).to_vec()
            } else {
                Vec::new()
            };
        };
        // D θ″ = ℓ̂ (1 + u) sin θ + (m + ℓ̂ cos θ) tan α has this slope at an equilibrium.
        let stiffness = |theta: f64| {
            let (sin, cos) = libm::sincos(theta);
            self.pace
                * (offset * (cos - self.law.tilt * sin).abs() / self.law.denominator(theta)).sqrt()
        };
        let within = |theta: f64| {
            if theta > PI {
                theta - TAU
            } else if theta <= -PI {
                theta + TAU
            } else {
                theta
            }
        };
        let mut equilibria = vec![Equilibrium {
            theta: within(unstable),
            stability: Stability::Unstable {
                exponent: stiffness(unstable),
            },
        }];
        if self.law.bottom > 0.0 || self.hoop.slope() != 0.0 {
            equilibria.push(Equilibrium {
                theta: within(stable),
                stability: Stability::Stable {
                    frequency: stiffness(stable),
                },
            });
        }
        equilibria
    }

    fn rate_of(&self, u: f64) -> Option<f64> {
        (u >= 0.0 && u.is_finite()).then(|| self.pace * u.sqrt())
    }
}
