//! The equations of motion, each written once: those of rolling (2.8, 2.11, 2.12), of sliding
//! (2.15, 2.16, 2.18), and 1 − h cos θ θ′² of contact.
//!
//! The formulas take the sine and cosine of θ and u = θ′², which solvers have already computed. A
//! formula that is linear in (1, sin θ, cos θ) takes the 1 as its first argument; applied to
//! coefficients of power series it gives the series.
//!
//! | equation | quantity | function |
//! |---|---|---|
//! | (2.8) | energy | [`energy`], [`RollingLaw::energy`] |
//! | (2.11) | θ″ of rolling, with the denominator D | [`RollingLaw::acceleration`], [`RollingLaw::denominator`] |
//! | (2.12) | N and F of rolling | [`RollingLaw::forces_at`] |
//! | (2.15), (2.18) | N and F of sliding | [`SlidingLaw::forces`] |
//! | (2.16) | θ″ and η″ of sliding | [`SlidingLaw::accelerations`] |
//! | (3.1) to (3.20) | the massless hoop | [`crate::mechanics::closed_form`], [`crate::modes::gliding`] |
//!
//! Symbols: m total mass, h distance and Î moment of inertia of the mass centre, ℓ̂ = m h, σ =
//! sign(η′).

use crate::math::form::Trigonometric;
use crate::math::number::Number;
use crate::math::trig::{Angle, above_bottom};
use crate::mechanics::resisted::ResistedRollingLaw;
use crate::model::{Body, Heavy, Hoop, Margin, RotationDirection, SlipDirection, State, Undecided};

/// Contact forces, in m2 g.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactForces<T = f64> {
    /// Normal force N.
    pub normal: T,
    /// Friction force F along E1.
    pub friction: T,
}

impl ContactForces {
    /// No contact.
    pub(crate) const NONE: Self = Self {
        normal: 0.0,
        friction: 0.0,
    };

    /// Friction demand |F|/N, the least coefficient of friction for this motion. Infinite for
    /// N ≤ 0.
    pub fn demand(&self) -> f64 {
        if self.normal > 0.0 {
            self.friction.abs() / self.normal
        } else {
            f64::INFINITY
        }
    }
}

/// Accelerations of a motion in contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accelerations<T = f64> {
    /// Angular acceleration θ″.
    pub theta: T,
    /// Slip acceleration η″.
    pub slip: T,
}

/// The quantities in which accelerations and forces are linear.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Loads<T = f64> {
    /// Gravity normal to the plane.
    pub(crate) gravity: T,
    /// u = θ′².
    pub(crate) u: T,
}

impl<T: Number> Loads<T> {
    /// In the units of the solvers, in which gravity normal to the plane is 1.
    #[inline]
    pub(crate) fn of(u: T) -> Self {
        Self {
            gravity: T::constant(1.0),
            u,
        }
    }
}

/// Height of the rim over the plane, and its rate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clearance<T = f64> {
    pub(crate) gap: T,
    pub(crate) gap_rate: T,
}

impl Clearance {
    /// In contact.
    pub(crate) const NONE: Self = Self {
        gap: 0.0,
        gap_rate: 0.0,
    };
}

/// The rate, the slip velocity and the position of a body in contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ContactMotion<T = f64> {
    pub(crate) theta_rate: T,
    pub(crate) slip: T,
    pub(crate) x: T,
}

impl ContactMotion {
    pub(crate) const fn of(state: &State) -> Self {
        Self {
            theta_rate: state.theta_rate,
            slip: state.slip,
            x: state.x,
        }
    }
}

/// w = 1 − h cos θ θ′², from cos θ θ′². A hoop can stay in contact while w > 0; sliding lifts off
/// where w = 0 (2.18), independent of μk.
#[inline]
pub(crate) fn contact<T: Number>(one: f64, h: T, cos_u: T) -> T {
    -(h * cos_u) + one
}

/// Bound of the rounding of w. A term has at most 15 roundings: 9 of θ′², with the unit of time of
/// a slope, 2 of the cosine, 2 of h, and 2 products.
pub(crate) fn contact_rounding(h: f64, cos: f64, u: f64) -> f64 {
    7.5 * f64::EPSILON * h * u * cos.abs()
}

/// Whether the body lifts off: w < 0, or w = 0, but for rounding, and decreasing. At w = 0, w′ = h
/// sin θ θ′³; where that vanishes too, at the top, w″ = h cos θ θ′⁴ > 0 and the body stays in
/// contact.
pub(crate) fn leaves_plane(w: f64, rounding: f64, lift: f64, theta_rate: f64) -> bool {
    if w.abs() > rounding {
        return w < 0.0;
    }
    // With `lift` = h sin θ θ′², and h cos θ θ′² = 1, w falls by w′²/2w″ = ½ (h sin θ θ′²)².
    let is_at_top = lift * lift <= 2.0 * rounding;
    !is_at_top && lift * theta_rate < 0.0
}

/// σ η″ at η′ = 0 where rolling violates static friction: −σ D (F + μk σ N)/(m P) with N and F of
/// (2.12), from `net_slip_force` = |F| − μk N and D.
#[inline]
pub(crate) fn slip_acceleration_at_rest(
    mass: f64,
    denominator: f64,
    net_slip_force: f64,
    p: f64,
) -> f64 {
    denominator * net_slip_force / (mass * p)
}

/// Kinetic plus potential energy of a body in contact or above the plane (2.8).
pub(crate) fn energy(hoop: &Hoop, state: &State, gap: f64, gap_rate: f64) -> f64 {
    energy_at(
        hoop,
        state,
        state.theta.angle(),
        Clearance { gap, gap_rate },
    )
}

/// [`energy`], with the sine and cosine of θ.
#[inline]
pub(crate) fn energy_at(hoop: &Hoop, state: &State, angle: Angle, clearance: Clearance) -> f64 {
    energy_of(
        &hoop.rigid_body(),
        ContactMotion::of(state),
        angle,
        clearance,
    )
}

/// [`energy`] of a body with inertia or without, from θ′, η′ and x.
#[inline]
pub(crate) fn energy_of<T: Number>(
    body: &Heavy<T>,
    motion: ContactMotion<T>,
    Angle { sin, cos }: Angle<T>,
    clearance: Clearance<T>,
) -> T {
    let (mass, h, rate) = (body.mass, body.h, motion.theta_rate);
    let vx = motion.slip - (h * cos + 1.0) * rate;
    let vy = clearance.gap_rate - h * sin * rate;
    let spin = body.inertia * rate * rate;
    let risen = mass * body.tilt * (motion.x - h * sin);
    (mass * (vx * vx + vy * vy) + spin) * 0.5 + body.offset * cos + mass * clearance.gap + risen
}

/// The equations of rolling (2.10) to (2.12) of one body, massless or not.
///
/// With rolling resistance θ″, N and F depend on the sign of θ′. Where θ′ = 0 they are those with
/// which the hoop begins to turn as its weight pulls, or of rest in the band of rest
/// (docs/theory/rolling-resistance.md); the energy decreases.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RollingLaw<T = f64> {
    pub(crate) mass: T,
    pub(crate) offset: T,
    /// D(0) = Î + m(1 + h)².
    pub(crate) top: T,
    /// D(π) = Î + m(1 − h)². Zero only for a massless hoop with the particle on the rim.
    pub(crate) bottom: T,
    /// D − (m + ℓ̂ cos θ) = Î + ℓ̂(h + cos θ) at θ = 0 and π: of a heavy hoop a small part of D.
    pub(crate) inertia_excess: [T; 2],
    /// tan α, or −0.
    pub(crate) tilt: T,
    /// m Î.
    pub(crate) mass_inertia: T,
    /// Gravity normal to the plane: cos α for users, 1 for the solvers ([`crate::walk::Origin`]).
    pub(crate) normal_gravity: T,
    /// χ for users; the solvers of rolling with resistance have [`ResistedRollingLaw`].
    pub(crate) rolling_resistance: T,
}

impl<T: Number> RollingLaw<T> {
    /// The equations in units in which gravity normal to the plane is 1, of a body with inertia or
    /// without.
    pub(crate) fn of_body(body: &Heavy<T>) -> Self {
        let (mass, offset, inertia) = (body.mass, body.offset, body.inertia);
        let (outer, inner) = (body.h + 1.0, -body.h + 1.0);
        Self {
            mass,
            offset,
            top: inertia + mass * outer * outer,
            bottom: inertia + mass * inner * inner,
            inertia_excess: [inertia + offset * outer, inertia - offset * inner],
            mass_inertia: mass * inertia,
            tilt: body.tilt,
            normal_gravity: T::constant(1.0),
            rolling_resistance: T::constant(0.0),
        }
    }

    /// D(θ).
    #[inline]
    pub(crate) fn denominator_of(&self, angle: Angle<T>) -> T {
        self.bottom + self.offset * 2.0 * above_bottom(angle)
    }

    /// D(π/2), the mean of D over a turn.
    #[inline]
    pub(crate) fn mean_denominator(&self) -> T {
        (self.top + self.bottom) * 0.5
    }

    /// D θ″ = ℓ̂ sin θ (1 + u) + (m + ℓ̂ cos θ) tan α, from 1, sin θ, cos θ and sin θ (1 + u).
    #[inline]
    pub(crate) fn driving_moment(&self, one: T, cos: T, weighted_sin: T) -> T {
        self.offset * weighted_sin + (self.mass * one + self.offset * cos) * self.tilt
    }

    /// The gain of D u over an arc, from the angle of its middle, its chord 2 sin(½ arc), and the
    /// arc.
    #[inline]
    pub(crate) fn gain(&self, Angle { sin, cos }: Angle<T>, chord: T, arc: T) -> T {
        (self.offset * chord * (sin + self.tilt * cos) + self.tilt * self.mass * arc) * 2.0
    }

    /// θ″ = [ℓ̂ sin θ (1 + u) + (m + ℓ̂ cos θ) tan α]/D, (2.11) on a level plane; from D.
    #[inline]
    pub(crate) fn acceleration(
        &self,
        Angle { sin, cos }: Angle<T>,
        Loads { gravity, u }: Loads<T>,
        denominator: T,
    ) -> T {
        let pull = (self.mass + self.offset * cos) * self.tilt;
        (self.offset * sin * (gravity + u) + pull * gravity) / denominator
    }

    /// E of (2.8) from the kinetic energy and θ, with its sine and cosine.
    pub(crate) fn energy_of(&self, kinetic: T, theta: T, Angle { sin, cos }: Angle<T>) -> T {
        let fallen = (self.mass * theta + self.offset * sin) * self.tilt;
        kinetic + self.normal_gravity * (self.offset * cos) - self.normal_gravity * fallen
    }

    /// N = m − ℓ̂ (sin θ θ″ + cos θ u) and F = ℓ̂ sin θ u − (m + ℓ̂ cos θ) θ″ + m tan α (2.12),
    /// from D. With θ″ of (2.11) F = [ℓ̂ sin θ (u (Î + ℓ̂(h + cos θ)) − m − ℓ̂ cos θ) + (m Î + ℓ̂²
    /// sin²θ) tan α]/D, which keeps the digits of a heavy hoop.
    #[inline(always)]
    pub(crate) fn forces_at(
        &self,
        angle: Angle<T>,
        loads: Loads<T>,
        denominator: T,
    ) -> ContactForces<T> {
        let Angle { sin, cos } = angle;
        let Loads { gravity, u } = loads;
        let acceleration = self.acceleration(angle, loads, denominator);
        let inertia_excess = self.inertia_excess[1] + self.offset * above_bottom(angle);
        let offset_sin = self.offset * sin;
        // F D of a level plane; the slope adds its own term.
        let level = offset_sin * (u * inertia_excess - gravity * (self.mass + self.offset * cos));
        ContactForces {
            normal: self.mass * gravity - self.offset * (sin * acceleration + cos * u),
            friction: (level + (self.mass_inertia + offset_sin * offset_sin) * self.tilt * gravity)
                / denominator,
        }
    }
}

impl Hoop {
    /// Why a phase in contact that ends at this angle leaves the motion open: the particle of a
    /// massless hoop passes the contact point at a distance √D that the last digit of θ may change
    /// altogether. Then neither the energy D θ′²/2, the only kinetic energy, nor the direction of the
    /// contact force, from the contact point to the particle, has a digit.
    pub(crate) fn undecided_place(&self, theta: f64) -> Option<Undecided> {
        if !matches!(self.body(), Body::Massless(_)) {
            return None;
        }
        let distance = RollingLaw::new(self).denominator(theta).sqrt();
        // |dD/dθ| = 2 ℓ̂|sin θ| ≤ 2 √D: where √D is less than this, D has no digit.
        let bound = 2.0 * f64::EPSILON * theta.abs();
        (distance <= bound).then_some(Undecided::Rounding {
            margin: Margin::ContactDistance,
            value: distance,
            bound,
        })
    }
}

impl RollingLaw {
    /// The equations of rolling of a hoop.
    #[must_use]
    pub fn new(hoop: &Hoop) -> Self {
        Self {
            normal_gravity: libm::cos(hoop.slope()),
            ..Self::of(hoop)
        }
    }

    /// The equations in units in which gravity normal to the plane is 1.
    pub(crate) fn of(hoop: &Hoop) -> Self {
        Self {
            rolling_resistance: hoop.rolling_resistance(),
            ..Self::of_body(&hoop.rigid_body())
        }
    }

    /// The equations in the direction in which the hoop turns, with rolling resistance, in units in
    /// which gravity normal to the plane is 1; none where it rests. From rest the weight decides.
    fn resisted(&self, Angle { sin, cos }: Angle, theta_rate: f64) -> Option<ResistedRollingLaw> {
        // The arm of the weight, as `HeldLaw` has it.
        let h = self.offset / self.mass;
        let arm = (h * cos + 1.0) * self.tilt + h * sin;
        let rests = theta_rate == 0.0 && arm.abs() <= self.rolling_resistance;
        let turns = if theta_rate == 0.0 { arm } else { theta_rate };
        (!rests).then(|| ResistedRollingLaw {
            rolling: *self,
            resistance: self.rolling_resistance.copysign(turns),
        })
    }

    /// D(θ), the denominator of (2.11): twice the kinetic energy of rolling over θ′². A sum of
    /// non-negative terms, accurate near the bottom, where D of a light hoop is small.
    pub fn denominator(&self, theta: f64) -> f64 {
        self.bottom + self.height(theta)
    }

    /// D(θ) − D(π) = 2ℓ̂(1 + cos θ).
    pub(crate) fn height(&self, theta: f64) -> f64 {
        let cos_half = libm::cos(0.5 * theta);
        4.0 * self.offset * cos_half * cos_half
    }

    pub(crate) fn denominator_polynomial(&self) -> Trigonometric {
        Trigonometric::linear(self.mean_denominator(), 0.0, 2.0 * self.offset)
    }

    /// D(θ) − D(π) as a trigonometric polynomial.
    pub(crate) fn above_bottom(&self) -> Trigonometric {
        Trigonometric::linear(2.0 * self.offset, 0.0, 2.0 * self.offset)
    }

    fn loads(&self, theta_rate: f64) -> Loads {
        Loads {
            gravity: self.normal_gravity,
            u: theta_rate * theta_rate,
        }
    }

    /// Angular acceleration θ″ = f_R(θ, θ′) (2.11). Undefined where D = 0 (footnote 8).
    pub fn theta_acceleration(&self, theta: f64, theta_rate: f64) -> f64 {
        if self.rolling_resistance > 0.0 {
            let (gravity, angle) = (self.normal_gravity, Angle::of(theta));
            let u = theta_rate * theta_rate / gravity;
            let law = self.resisted(angle, theta_rate);
            return law.map_or(0.0, |law| gravity * law.acceleration(angle, u));
        }
        self.acceleration(
            theta.angle(),
            self.loads(theta_rate),
            self.denominator(theta),
        )
    }

    /// Normal and friction force (2.12). In 𝓡 of (2.14) they are the contact forces; elsewhere,
    /// those that rolling would require.
    pub fn forces(&self, theta: f64, theta_rate: f64) -> ContactForces {
        if self.rolling_resistance > 0.0 {
            let (gravity, angle) = (self.normal_gravity, Angle::of(theta));
            let u = theta_rate * theta_rate / gravity;
            let rest = ContactForces {
                normal: self.mass,
                // Never −0.
                friction: self.mass * self.tilt + 0.0,
            };
            let law = self.resisted(angle, theta_rate);
            let ContactForces { normal, friction } = law.map_or(rest, |law| law.forces(angle, u));
            return ContactForces {
                normal: gravity * normal,
                friction: gravity * friction,
            };
        }
        self.forces_at(
            theta.angle(),
            self.loads(theta_rate),
            self.denominator(theta),
        )
    }

    /// Whether the forces of rolling stay as they are: of a balanced hoop, and at rest in an
    /// equilibrium, but for rounding. A term of D θ″ at rest has at most 8 roundings.
    pub(crate) fn is_steady(&self, theta: f64, theta_rate: f64) -> bool {
        let Angle { sin, cos } = theta.angle();
        let pull = self.tilt.abs();
        let size = |sin: f64, cos: f64| self.offset * sin + pull * (self.mass + self.offset * cos);
        let by_angle = theta.abs() * size(cos.abs(), sin.abs());
        let rounding = 0.5 * f64::EPSILON * (8.0 * size(sin.abs(), cos.abs()) + by_angle);
        let drive = self.driving_moment(1.0, cos, sin);
        self.offset == 0.0 || (theta_rate * theta_rate == 0.0 && drive.abs() <= rounding)
    }

    /// Energy, conserved without rolling resistance: E = D θ′²/2 + ℓ̂ cos θ cos α − (m θ + ℓ̂ sin θ) sin α (2.8, and 3.2 for
    /// Littlewood's hoop), where x = −θ.
    pub fn energy(&self, theta: f64, theta_rate: f64) -> f64 {
        let kinetic = 0.5 * self.denominator(theta) * theta_rate * theta_rate;
        self.energy_of(kinetic, theta, theta.angle())
    }

    /// The angles of the unstable and of the stable equilibrium, sin(θ + α) = −sin α/h: 0 and π on
    /// a level plane. None where the slope exceeds asin h, and for a balanced hoop. With rolling
    /// resistance they are where it holds nothing, within the bands of rest.
    pub fn equilibria(&self) -> Option<[f64; 2]> {
        if self.tilt == 0.0 {
            return (self.offset > 0.0).then_some([0.0, core::f64::consts::PI]);
        }
        let away = self.tilt / (1.0 + self.tilt * self.tilt).sqrt() * self.mass / self.offset;
        let lean = libm::atan(self.tilt);
        (away.abs() < 1.0).then(|| {
            let away = libm::asin(away);
            [-lean - away, core::f64::consts::PI - lean + away]
        })
    }

    /// Energy at the unstable equilibrium, that of the separatrix through it without rolling
    /// resistance: E = ℓ̂ on a level plane; NaN without such an equilibrium.
    pub fn separatrix_energy(&self) -> f64 {
        if self.tilt == 0.0 {
            return self.offset;
        }
        self.equilibria()
            .map_or(f64::NAN, |[unstable, _]| self.energy(unstable, 0.0))
    }
}

/// The equations of sliding of a heavy hoop in one direction.
///
/// With q = h sin θ − μk σ (1 + h cos θ) − ς χ, solving (2.16) for the accelerations gives
///
/// ```text
/// w = cos α − h cos θ θ′²,  P = Î + m h sin θ q,
/// N = Î m w/P,              θ″ = N q/Î = m q w/P,
/// η″ = −μk σ N/m + (1 + h cos θ) θ″ − h sin θ θ′² − sin α.
/// ```
///
/// With rolling resistance a slide keeps both of its directions, σ of slip and ς of rotation
/// (docs/theory/rolling-resistance.md).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlidingLaw<T = f64> {
    pub(crate) body: Heavy<T>,
    /// μk σ.
    pub(crate) friction: T,
    /// ς χ; never −0, so that without resistance every difference with it is unchanged.
    pub(crate) resistance: T,
    /// Gravity normal to the plane, as in [`RollingLaw`].
    pub(crate) normal_gravity: T,
}

impl<T: Number> SlidingLaw<T> {
    pub(crate) fn of_body(body: Heavy<T>, mu_k: T, direction: SlipDirection) -> Self {
        Self {
            body,
            friction: mu_k * direction.sign(),
            resistance: T::constant(0.0),
            normal_gravity: T::constant(1.0),
        }
    }

    /// q = h sin θ − μk σ (1 + h cos θ) − ς χ.
    #[inline]
    pub(crate) fn q(&self, one: f64, sin: T, cos: T) -> T {
        let h = self.body.h;
        h * sin - self.friction * (h * cos + one) - self.resistance * one
    }

    /// P = Î + m h sin θ q.
    #[inline]
    pub(crate) fn p(&self, sin: T, q: T) -> T {
        self.body.inertia + self.body.mass * self.body.h * sin * q
    }

    /// μk σ + tan α, the rate at which η′ decreases on average.
    #[inline]
    pub(crate) fn mean_slip_loss(&self) -> T {
        self.friction + self.body.tilt
    }

    /// 1 + h cos θ + μk σ h sin θ, the coefficient of θ′ in the first integral.
    #[inline]
    pub(crate) fn slip_coefficient(&self, sin: T, cos: T) -> T {
        self.body.h * (cos + self.friction * sin) + 1.0
    }

    /// θ″ and η″ of (2.16), solved, from θ′.
    pub(crate) fn accelerations_at(
        &self,
        Angle { sin, cos }: Angle<T>,
        theta_rate: T,
    ) -> Accelerations<T> {
        let (mass, h) = (self.body.mass, self.body.h);
        let w = self.normal_gravity - h * (cos * (theta_rate * theta_rate));
        let q = self.q(1.0, sin, cos);
        let p = self.p(sin, q);
        let theta_acceleration = mass * q * w / p;
        let normal_over_mass = self.body.inertia * w / p;
        Accelerations {
            theta: theta_acceleration,
            slip: (h * cos + 1.0) * theta_acceleration
                - self.friction * normal_over_mass
                - h * sin * theta_rate * theta_rate
                - self.body.pull() * self.normal_gravity,
        }
    }

    /// The second integral, x̄ + μk σ (ȳ + τ²/2) + tan α τ²/2 minus a linear function of τ, of the
    /// slide from an angle.
    pub(crate) fn path(
        &self,
        start: ContactMotion<T>,
        Angle { sin, cos }: Angle<T>,
    ) -> SlidePath<T> {
        let (h, rate) = (self.body.h, start.theta_rate);
        let vx = start.slip - (h * cos + 1.0) * rate;
        let vy = -h * sin * rate;
        SlidePath {
            h,
            friction: self.friction,
            pull: self.body.pull(),
            mass_centre_x: start.x - h * sin,
            drift: vx + self.friction * vy,
            cos_start: cos,
        }
    }
}

impl SlidingLaw {
    /// The equations of a hoop that slips and turns in these directions; `None` for a massless
    /// hoop, which glides. The direction of rotation matters with rolling resistance only.
    pub fn new(hoop: &Hoop, slip: SlipDirection, rotation: RotationDirection) -> Option<Self> {
        match hoop.body() {
            Body::Heavy(body) => Some(Self {
                normal_gravity: libm::cos(hoop.slope()),
                resistance: hoop.rolling_resistance() * rotation.sign() + 0.0,
                ..Self::of_body(body, hoop.mu_k(), slip)
            }),
            Body::Massless(_) => None,
        }
    }

    /// a = 2 θ″/w of the linear equation du/dθ = a w.
    #[inline]
    pub(crate) fn u_growth(&self, sin: f64, cos: f64) -> f64 {
        let q = self.q(1.0, sin, cos);
        2.0 * self.body.mass * q / self.p(sin, q)
    }

    /// α and β of η″ = α + β u (2.16): one division where [`SlidingLaw::accelerations`] has two.
    #[inline]
    pub(crate) fn slip_acceleration(&self, sin: f64, cos: f64) -> (f64, f64) {
        let (h, inertia) = (self.body.h, self.body.inertia);
        let q = self.q(1.0, sin, cos);
        let alpha =
            ((1.0 + h * cos) * self.body.mass * q - self.friction * inertia) / self.p(sin, q);
        (alpha - self.body.pull(), -h * cos * alpha - h * sin)
    }

    /// w = cos α − h cos θ θ′². The body can stay in contact while w > 0; sliding lifts off where
    /// w = 0, independent of μk.
    pub fn contact(&self, theta: f64, theta_rate: f64) -> f64 {
        contact(
            self.normal_gravity,
            self.body.h,
            libm::cos(theta) * (theta_rate * theta_rate),
        )
    }

    /// P = Î + m h sin θ q. Where P ≤ 0, sliding has no solution with N > 0, or the motion is not
    /// unique.
    pub fn painleve(&self, theta: f64) -> f64 {
        let Angle { sin, cos } = theta.angle();
        self.p(sin, self.q(1.0, sin, cos))
    }

    /// Whether P = 0, but for rounding. Next to it the motion depends on the logarithm of P.
    pub(crate) fn is_singular(&self, theta: f64) -> bool {
        self.painleve(theta).abs() <= self.painleve_rounding(theta)
    }

    /// Bound of the rounding of P. A term has at most 16 roundings.
    pub(crate) fn painleve_rounding(&self, theta: f64) -> f64 {
        let Heavy {
            mass, h, inertia, ..
        } = self.body;
        let Angle { sin, cos } = theta.angle();
        let arm = h * sin.abs();
        let levers = arm + self.friction.abs() * (1.0 + h * cos) + self.resistance.abs();
        let terms = inertia + mass * arm * levers;
        8.0 * f64::EPSILON * terms
    }

    /// N = Î m w/P and F = −μk σ N (2.15, 2.18).
    pub fn forces(&self, theta: f64, theta_rate: f64) -> ContactForces {
        let normal = self.body.inertia * self.body.mass * self.contact(theta, theta_rate)
            / self.painleve(theta);
        ContactForces {
            normal,
            friction: -self.friction * normal,
        }
    }

    /// θ″ and η″ of (2.16), solved.
    pub fn accelerations(&self, theta: f64, theta_rate: f64) -> Accelerations {
        self.accelerations_at(theta.angle(), theta_rate)
    }

    /// The first integral η′ − θ′ (1 + h cos θ + μk σ h sin θ) + (μk σ cos α + sin α) τ.
    pub fn momentum_integral(&self, state: &State) -> f64 {
        let Angle { sin, cos } = state.theta.angle();
        state.slip - state.theta_rate * self.slip_coefficient(sin, cos)
            + self.mean_slip_loss() * self.normal_gravity * state.time
    }
}

/// Position of the geometric centre during a slide, by the second integral.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SlidePath<T = f64> {
    h: T,
    friction: T,
    pull: T,
    /// x̄0, x̄′ + μk σ ȳ′ and cos θ0: the constants of the integral.
    mass_centre_x: T,
    drift: T,
    cos_start: T,
}

impl<T: Number> SlidePath<T> {
    /// x after the time `elapsed`, at this angle.
    #[inline]
    pub(crate) fn x(&self, elapsed: T, Angle { sin, cos }: Angle<T>) -> T {
        let fall = self.h * (cos - self.cos_start) + elapsed * 0.5 * elapsed;
        let pulled = self.pull * 0.5 * elapsed * elapsed;
        let mass_centre = self.mass_centre_x + self.drift * elapsed - self.friction * fall - pulled;
        mass_centre + self.h * sin
    }
}
