//! The impact of the rim on the plane: a rigid body, friction by Coulomb's law, restitution by one of three laws.
//!
//! The vertical impulse P is the independent variable (Routh; Keller 1986). With the slip velocity u and the gap rate w of the
//! contact point, (h sin θ, −(1 + h cos θ)) from the mass centre,
//!
//! ```text
//! du = A dJ + B dP,   dw = B dJ + C dP,   dθ′ = [(1 + h cos θ) dJ + h sin θ dP]/Î,
//! A = 1/m + (1 + h cos θ)²/Î,   B = h sin θ (1 + h cos θ)/Î,   C = 1/m + h² sin²θ/Î,   A C − B² = D/(m² Î).
//! ```
//!
//! While the body slips, dJ/dP = −μk σ, so that dw/dP = k1 = C − μk σ B = P_solv/(m Î): Painlevé's P of sliding. Where slip
//! ends, the body sticks, dJ/dP = −B/A, if |B| ≤ μs A, and else slips towards sign B; in both dw/dP = k2 > 0. Everything is
//! piecewise linear in P, so that the impact is in closed form. [`crate::Hoop::simulate`] ends before it.
//!
//! Literature: J. B. Keller, J. Appl. Mech. 53, 1986; W. J. Stronge, Proc. R. Soc. A 431, 1990 (the energetic law); Y. Wang and
//! M. T. Mason, J. Appl. Mech. 59, 1992 (the cases).

use thiserror::Error;

use crate::hoop::{Body, Heavy, Hoop};
use crate::mode::Direction;
use crate::named::named;
use crate::state::State;
use crate::transition::Impulse;

named! {
    /// What the coefficient of restitution is a ratio of.
    pub enum RestitutionLaw, "law of restitution" {
        /// Of works: the work that the normal force gives back is e² of what it has taken up (Stronge).
        Energetic = 0, "energetic";
        /// Of impulses: that of restitution is e times that of compression.
        Poisson = 1, "poisson";
        /// Of velocities: the gap opens e times as fast as it has closed. It can gain energy where friction changes on the
        /// way.
        Newton = 2, "newton";
    }
}

/// A coefficient of restitution 0 ≤ e ≤ 1 with its law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Restitution {
    coefficient: f64,
    law: RestitutionLaw,
}

/// Why there is no impact to compute.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum ImpactError {
    /// The coefficient of restitution is outside 0 to 1.
    #[error("restitution = {value} must lie between 0 and 1")]
    Coefficient {
        /// The coefficient that was given.
        value: f64,
    },
    /// The gap does not close.
    #[error("gap_rate = {gap_rate} sqrt(g R) must be finite and not positive: the gap has to close")]
    Opening {
        /// The gap rate that was given.
        gap_rate: f64,
    },
    /// A massless hoop carries no impulse: without inertia the contact force that an impact needs would accelerate the rim
    /// without bound.
    #[error("a massless hoop has no impact: its rim has no inertia that an impulse could act on")]
    Massless,
}

impl Restitution {
    /// A coefficient with a law.
    ///
    /// # Errors
    /// The coefficient must lie between 0 and 1.
    pub fn new(coefficient: f64, law: RestitutionLaw) -> Result<Self, ImpactError> {
        if (0.0..=1.0).contains(&coefficient) {
            Ok(Self { coefficient, law })
        } else {
            Err(ImpactError::Coefficient { value: coefficient })
        }
    }

    /// The coefficient e.
    #[must_use]
    pub const fn coefficient(&self) -> f64 {
        self.coefficient
    }

    /// The law.
    #[must_use]
    pub const fn law(&self) -> RestitutionLaw {
        self.law
    }
}

named! {
    /// Course of the slip during an impact.
    pub enum ImpactCase, "case of an impact" {
        /// Nothing: the gap does not close, and nothing forces an impulse.
        None = 0, "none";
        /// Slips throughout.
        Slides = 1, "slides";
        /// Slip ends in compression, and the contact sticks.
        SticksInCompression = 2, "sticks_in_compression";
        /// Slip ends in compression and goes on in the other direction.
        ReversesInCompression = 3, "reverses_in_compression";
        /// Slip ends in restitution, and the contact sticks.
        SticksInRestitution = 4, "sticks_in_restitution";
        /// Slip ends in restitution and goes on in the other direction.
        ReversesInRestitution = 5, "reverses_in_restitution";
        /// P ≤ 0 (Painlevé): while it slips the plane presses the gap shut; slip must end before the gap can open.
        Jams = 6, "jams";
    }
}

/// The velocities that an impact changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactVelocities {
    /// Rate θ′.
    pub theta_rate: f64,
    /// Slip velocity η′ of the contact point.
    pub slip: f64,
    /// Rate of the gap; negative while it closes.
    pub gap_rate: f64,
}

/// An impact.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Impact {
    /// What the contact point does.
    pub case: ImpactCase,
    /// Velocities before.
    pub before: ContactVelocities,
    /// Velocities after.
    pub after: ContactVelocities,
    /// Impulse on the body.
    pub impulse: Impulse,
    /// Work of the normal impulse, ∫ w dP.
    pub normal_work: f64,
    /// Work of the friction impulse, ∫ u dJ ≤ 0.
    pub friction_work: f64,
}

impl Impact {
    /// Energy lost, over m2 g R. Negative where Newton's law gains energy.
    #[must_use]
    pub fn energy_lost(&self) -> f64 {
        -(self.normal_work + self.friction_work)
    }

    /// Whether the law has gained energy, which only Newton's can.
    #[must_use]
    pub fn gains_energy(&self) -> bool {
        self.energy_lost() < 0.0
    }
}

/// Part of an impact on which everything is linear in P: how J, u and w change with P.
#[derive(Clone, Copy, Debug)]
struct Slope {
    friction: f64,
    slip: f64,
    gap_rate: f64,
}

/// A, B and C.
#[derive(Clone, Copy, Debug)]
struct Compliance {
    a: f64,
    b: f64,
    c: f64,
    determinant: f64,
}

impl Compliance {
    fn new(body: &Heavy, sin: f64, cos: f64) -> Self {
        let Heavy { mass, h, inertia, .. } = *body;
        let (arm, lever) = (h * sin, 1.0 + h * cos);
        Self {
            a: 1.0 / mass + lever * lever / inertia,
            b: arm * lever / inertia,
            c: 1.0 / mass + arm * arm / inertia,
            determinant: (inertia + mass * (arm * arm + lever * lever)) / (mass * mass * inertia),
        }
    }

    /// While it slips in a direction.
    fn slipping(&self, mu_k: f64, direction: Direction) -> Slope {
        let friction = -mu_k * direction.sign();
        Slope { friction, slip: self.a * friction + self.b, gap_rate: self.c + friction * self.b }
    }

    /// Where the slip velocity is zero.
    fn at_rest(&self, hoop: &Hoop) -> (Slope, bool) {
        let sticks = self.b.abs() <= hoop.mu_s() * self.a;
        match Direction::of_sign(self.b).filter(|_| !sticks) {
            Some(direction) => (self.slipping(hoop.mu_k(), direction), true),
            None => {
                let stuck =
                    Slope { friction: -self.b / self.a, slip: 0.0, gap_rate: self.determinant / self.a };
                (stuck, false)
            }
        }
    }
}

/// The two parts of an impact: slip as it was, up to the impulse `first`, and what follows.
#[derive(Clone, Copy, Debug)]
struct Course {
    before: ContactVelocities,
    slipping: Slope,
    first: f64,
    then: Slope,
    reverses: bool,
}

impl Hoop {
    /// The impact of a hoop whose rim touches the plane in `state`, the gap closing at `gap_rate` ≤ 0, with friction μk where
    /// it slips and μs where it sticks.
    ///
    /// ```
    /// use littlewood::{ImpactCase, Outcome, Restitution, RestitutionLaw, find_case};
    ///
    /// let motion = find_case("figure-3").expect("a named case").simulate()?;
    /// let Outcome::Landing { state, gap_rate } = motion.outcome() else { panic!("lands") };
    /// let restitution = Restitution::new(0.5, RestitutionLaw::Energetic)?;
    /// let impact = motion.hoop().impact(&state, gap_rate, restitution)?;
    /// assert_eq!(impact.case, ImpactCase::SticksInRestitution);
    /// assert!((impact.after.gap_rate - 0.978_517_419_970_790_8).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// A gap that opens; a massless hoop.
    pub fn impact(
        &self,
        state: &State,
        gap_rate: f64,
        restitution: Restitution,
    ) -> Result<Impact, ImpactError> {
        let Body::Heavy(body) = self.body() else { return Err(ImpactError::Massless) };
        if !(gap_rate.is_finite() && gap_rate <= 0.0) {
            return Err(ImpactError::Opening { gap_rate });
        }
        let (sin, cos) = libm::sincos(state.theta);
        let compliance = Compliance::new(&body, sin, cos);
        let before = ContactVelocities { theta_rate: state.theta_rate, slip: state.slip, gap_rate };
        let (then, reverses) = compliance.at_rest(self);
        let direction = Direction::of_sign(state.slip);
        let slipping = direction.map_or(then, |direction| compliance.slipping(self.mu_k(), direction));
        let first = match direction {
            None => 0.0,
            Some(direction) => {
                let deceleration = -direction.sign() * slipping.slip;
                if deceleration > 0.0 { state.slip.abs() / deceleration } else { f64::INFINITY }
            }
        };
        let course = Course { before, slipping, first, then, reverses };
        let jams = direction.is_some() && slipping.gap_rate <= 0.0;
        if gap_rate == 0.0 && !jams {
            return Ok(course.nothing());
        }
        let (case, normal) = course.end(jams, restitution);
        Ok(course.after(&body, (sin, cos), case, normal))
    }
}

impl Course {
    fn nothing(&self) -> Impact {
        Impact {
            case: ImpactCase::None,
            before: self.before,
            after: self.before,
            impulse: Impulse { normal: 0.0, friction: 0.0 },
            normal_work: 0.0,
            friction_work: 0.0,
        }
    }

    /// The case and the normal impulse.
    fn end(&self, jams: bool, Restitution { coefficient: e, law }: Restitution) -> (ImpactCase, f64) {
        let closing = -self.before.gap_rate;
        let (k1, k2, first) = (self.slipping.gap_rate, self.then.gap_rate, self.first);
        if !jams && first * k1 >= (1.0 + e) * closing {
            return (ImpactCase::Slides, (1.0 + e) * closing / k1);
        }
        // The gap rate where slip ends.
        let at_end = k1 * first - closing;
        if at_end <= 0.0 {
            let case = match (jams, self.reverses) {
                (true, _) => ImpactCase::Jams,
                (false, true) => ImpactCase::ReversesInCompression,
                (false, false) => ImpactCase::SticksInCompression,
            };
            let compression = first - at_end / k2;
            let normal = match law {
                RestitutionLaw::Energetic => {
                    let work = 0.5 * (closing - at_end) * first + 0.5 * at_end * at_end / k2;
                    compression + e * (2.0 * work / k2).sqrt()
                }
                RestitutionLaw::Poisson => (1.0 + e) * compression,
                RestitutionLaw::Newton => compression + e * closing / k2,
            };
            return (case, normal);
        }
        let case =
            if self.reverses { ImpactCase::ReversesInRestitution } else { ImpactCase::SticksInRestitution };
        let normal = match law {
            RestitutionLaw::Energetic => {
                let given_back = e * e * closing * closing - at_end * at_end;
                let opening = (at_end * at_end + k2 / k1 * given_back).sqrt();
                first + (opening - at_end) / k2
            }
            RestitutionLaw::Poisson => (1.0 + e) * closing / k1,
            RestitutionLaw::Newton => first + (e * closing - at_end) / k2,
        };
        (case, normal)
    }

    /// The velocities after, and the works on both parts.
    fn after(&self, body: &Heavy, (sin, cos): (f64, f64), case: ImpactCase, normal: f64) -> Impact {
        let before = self.before;
        let one = normal.min(self.first);
        let two = normal - one;
        let friction = self.slipping.friction * one + self.then.friction * two;
        let slips_on = normal <= self.first;
        let slip_between = if slips_on { before.slip + self.slipping.slip * one } else { 0.0 };
        let gap_between = before.gap_rate + self.slipping.gap_rate * one;
        let after = ContactVelocities {
            theta_rate: before.theta_rate
                + ((1.0 + body.h * cos) * friction + body.h * sin * normal) / body.inertia,
            slip: slip_between + self.then.slip * two,
            gap_rate: gap_between + self.then.gap_rate * two,
        };
        let normal_work =
            0.5 * one * (before.gap_rate + gap_between) + 0.5 * two * (gap_between + after.gap_rate);
        let friction_work = 0.5 * self.slipping.friction * one * (before.slip + slip_between)
            + 0.5 * self.then.friction * two * (slip_between + after.slip);
        Impact { case, before, after, impulse: Impulse { normal, friction }, normal_work, friction_work }
    }
}
