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
//! While the body slips, dJ/dP = −μk σ, so that dw/dP = k1 = C − μk σ B = P_solv/(m Î): Painlevé's P of sliding. For a light
//! hoop A, B and C are large and all but cancel: what is computed first is dθ′/dP, and du/dP and dw/dP from it. Where slip
//! ends, the body sticks, dJ/dP = −B/A, if |B| ≤ μs A, and else slips towards sign B; in both dw/dP = k2 > 0. Everything is
//! piecewise linear in P, so that the impact is in closed form. [`crate::Hoop::simulate`] ends before it.
//!
//! Literature: J. B. Keller, J. Appl. Mech. 53, 1986; W. J. Stronge, Proc. R. Soc. A 431, 1990 (the energetic law); Y. Wang and
//! M. T. Mason, J. Appl. Mech. 59, 1992 (the cases).

use thiserror::Error;

use crate::model::{Body, Direction, Heavy, Hoop, Restitution, RestitutionLaw, State, named};

/// The impulse of the plane on the body, over m2 √(gR).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Impulse {
    /// Upwards, P.
    pub normal: f64,
    /// Along E1, J.
    pub friction: f64,
}

/// Why there is no impact to compute.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ImpactError {
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

named! {
    /// Course of the slip during an impact.
    pub enum ImpactCase, "case of an impact",
    /// In words, for tables and pictures.
    pub label: &'static str {
        /// Nothing: the gap does not close, and nothing forces an impulse.
        None = 0, "none" => "no impulse";
        /// Slips throughout.
        Slides = 1, "slides" => "slides";
        /// Slip ends in compression, and the contact sticks.
        SticksInCompression = 2, "sticks_in_compression" => "sticks in compression";
        /// Slip ends in compression and goes on in the other direction.
        ReversesInCompression = 3, "reverses_in_compression" => "reverses in compression";
        /// Slip ends in restitution, and the contact sticks.
        SticksInRestitution = 4, "sticks_in_restitution" => "sticks in restitution";
        /// Slip ends in restitution and goes on in the other direction.
        ReversesInRestitution = 5, "reverses_in_restitution" => "reverses in restitution";
        /// P ≤ 0 (Painlevé): while it slips the plane presses the gap shut; slip must end before the gap can open.
        Jams = 6, "jams" => "jams";
    }
}

/// The velocities that an impact changes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactVelocities {
    /// Rate θ′.
    pub theta_rate: f64,
    /// Slip velocity η′ of the contact point.
    pub slip: f64,
    /// Rate of the gap; negative while it closes.
    pub gap_rate: f64,
}

impl ContactVelocities {
    /// Those of a state, with the rate of the gap.
    pub(crate) const fn of(state: &State, gap_rate: f64) -> Self {
        Self { theta_rate: state.theta_rate, slip: state.slip, gap_rate }
    }
}

/// An impact, or all those of the bounces by which a hoop settles, together.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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
    /// The state after the impact, from that before it.
    pub(crate) fn state_after(&self, before: &State) -> State {
        State { theta_rate: self.after.theta_rate, slip: self.after.slip, ..*before }
    }

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

/// Part of an impact on which everything is linear in P: how J, θ′, u and w change with P.
#[derive(Clone, Copy, Debug)]
struct Slope {
    friction: f64,
    spin: f64,
    slip: f64,
    gap_rate: f64,
}

/// How the velocities of the contact point answer to an impulse (J, P): u′ − u = A J + B P, w′ − w = B J + C P, over 1/m2.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Compliance {
    /// A: slip by friction.
    pub a: f64,
    /// B: slip by the normal impulse, and the rate of the gap by friction.
    pub b: f64,
    /// C: the rate of the gap by the normal impulse.
    pub c: f64,
}

impl Hoop {
    /// What an impact at an angle depends on; none for a massless hoop.
    #[must_use]
    pub fn compliance(&self, theta: f64) -> Option<Compliance> {
        let Body::Heavy(body) = self.body() else { return None };
        let Heavy { mass, h, inertia, .. } = body;
        let (arm, lever) = (h * libm::sin(theta), 1.0 + h * libm::cos(theta));
        Some(Compliance {
            a: 1.0 / mass + lever * lever / inertia,
            b: arm * lever / inertia,
            c: 1.0 / mass + arm * arm / inertia,
        })
    }

    /// The impulses through which an impact at an angle goes, with straight lines between them: from none to all of it, and
    /// on the way that at which the slip ends, if it does. Empty for a massless hoop; bounces that settle have no such course.
    #[must_use]
    pub fn impact_course(&self, theta: f64, impact: &Impact) -> Vec<Impulse> {
        let Body::Heavy(body) = self.body() else { return Vec::new() };
        let contact = Contact::new(self, &body, theta);
        let direction = Direction::of_sign(impact.before.slip);
        let slipping = direction.map_or(contact.at_rest, |direction| contact.slope(direction));
        let first = contact.course(impact.before, direction, slipping).first;
        let bend = (first > 0.0 && first < impact.impulse.normal)
            .then_some(Impulse { normal: first, friction: slipping.friction * first });
        let none = Impulse { normal: 0.0, friction: 0.0 };
        [Some(none), bend, Some(impact.impulse)].into_iter().flatten().collect()
    }

    /// The impact of a hoop whose rim touches the plane in `state`, the gap closing at `gap_rate` ≤ 0, with friction μk where
    /// it slips and μs where it sticks.
    ///
    /// ```
    /// use littlewood::cases::find_case;
    /// use littlewood::impact::ImpactCase;
    /// use littlewood::{Outcome, Restitution, RestitutionLaw};
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
        let before = ContactVelocities::of(state, gap_rate);
        Ok(Contact::new(self, &body, state.theta).impact(before, restitution))
    }

    /// The impact without a collision by which a hoop goes on where it slips and no motion is consistent, or where its slide
    /// has run into P = 0. None for a massless hoop, one without a coefficient of restitution, and one that does not slip.
    /// Where sliding has a solution, P > 0, it does not apply.
    #[must_use]
    pub fn jam(&self, state: &State) -> Option<Impact> {
        let (Body::Heavy(body), Some(restitution)) = (self.body(), self.restitution()) else { return None };
        let direction = Direction::of_sign(state.slip)?;
        let contact = Contact::new(self, &body, state.theta);
        Some(contact.jam(ContactVelocities::of(state, 0.0), direction, restitution))
    }
}

/// An angle at which the rim touches the plane, with what an impact there depends on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contact {
    mass: f64,
    /// h sin θ and 1 + h cos θ.
    arm: f64,
    lever: f64,
    /// While it slips with σ = −1 and σ = +1.
    slipping: [Slope; 2],
    /// From rest, and whether it slips then.
    at_rest: Slope,
    reverses: bool,
}

impl Contact {
    pub(crate) fn new(hoop: &Hoop, body: &Heavy, theta: f64) -> Self {
        let (sin, cos) = libm::sincos(theta);
        let (mass, arm, lever) = (body.mass, body.h * sin, 1.0 + body.h * cos);
        let slope = |friction: f64, spin: f64| Slope {
            friction,
            spin,
            slip: friction / mass + lever * spin,
            gap_rate: 1.0 / mass + arm * spin,
        };
        let slipping = Direction::ALL.map(|direction| {
            let friction = -hoop.mu_k() * direction.sign();
            slope(friction, (arm + friction * lever) / body.inertia)
        });
        // m Î A and m Î B: what sticking needs is |B|/A.
        let (a, b) = (body.inertia + mass * lever * lever, mass * arm * lever);
        let stuck = Slope { slip: 0.0, ..slope(-b / a, arm / a) };
        let reversed = Direction::of_sign(b).filter(|_| b.abs() > hoop.mu_s() * a);
        let at_rest = reversed.map_or(stuck, |direction| slipping[direction.index()]);
        Self { mass, arm, lever, slipping, at_rest, reverses: reversed.is_some() }
    }

    const fn slope(&self, direction: Direction) -> Slope {
        self.slipping[direction.index()]
    }

    /// The impact with these velocities, the gap not opening.
    pub(crate) fn impact(&self, before: ContactVelocities, restitution: Restitution) -> Impact {
        let direction = Direction::of_sign(before.slip);
        let slipping = direction.map_or(self.at_rest, |direction| self.slope(direction));
        let jams = direction.is_some() && slipping.gap_rate <= 0.0;
        if before.gap_rate == 0.0 && !jams {
            return Impact {
                case: ImpactCase::None,
                before,
                after: before,
                impulse: Impulse { normal: 0.0, friction: 0.0 },
                normal_work: 0.0,
                friction_work: 0.0,
            };
        }
        self.course(before, direction, slipping).impact(jams, restitution)
    }

    /// The jam of a hoop that slips where P ≤ 0, the rim at the plane and the gap neither closing nor opening. Where a slide
    /// has run into P = 0 the rounded P may have either sign; it is zero.
    fn jam(&self, before: ContactVelocities, direction: Direction, restitution: Restitution) -> Impact {
        let slope = self.slope(direction);
        let slipping = if slope.gap_rate <= 0.0 {
            slope
        } else {
            let spin = -1.0 / (self.mass * self.arm);
            Slope { spin, slip: slope.friction / self.mass + self.lever * spin, gap_rate: 0.0, ..slope }
        };
        self.course(before, Some(direction), slipping).impact(true, restitution)
    }

    fn course(&self, before: ContactVelocities, direction: Option<Direction>, slipping: Slope) -> Course<'_> {
        let first = match direction {
            None => 0.0,
            Some(direction) => {
                let deceleration = -direction.sign() * slipping.slip;
                if deceleration > 0.0 { before.slip.abs() / deceleration } else { f64::INFINITY }
            }
        };
        Course { contact: self, before, slipping, first }
    }
}

/// The two parts of an impact: slip as it was, up to the impulse `first`, and what follows.
#[derive(Clone, Copy, Debug)]
struct Course<'a> {
    contact: &'a Contact,
    before: ContactVelocities,
    slipping: Slope,
    first: f64,
}

/// How an impact ends.
struct End {
    case: ImpactCase,
    /// P.
    normal: f64,
    /// Rate at which the gap opens, from the law itself: as a sum over P it would be lost in rounding where e is small.
    opening: f64,
}

impl Course<'_> {
    /// The end by the law of restitution.
    fn end(&self, jams: bool, restitution: Restitution) -> End {
        let (e, law) = (restitution.coefficient(), restitution.law());
        let closing = -self.before.gap_rate;
        let (k1, k2, first) = (self.slipping.gap_rate, self.contact.at_rest.gap_rate, self.first);
        let reverses = self.contact.reverses;
        if !jams && first * k1 >= (1.0 + e) * closing {
            return End { case: ImpactCase::Slides, normal: (1.0 + e) * closing / k1, opening: e * closing };
        }
        // The gap rate where slip ends.
        let at_end = k1 * first - closing;
        if at_end <= 0.0 {
            let case = match (jams, reverses) {
                (true, _) => ImpactCase::Jams,
                (false, true) => ImpactCase::ReversesInCompression,
                (false, false) => ImpactCase::SticksInCompression,
            };
            let compression = first - at_end / k2;
            let opening = match law {
                RestitutionLaw::Energetic => {
                    let work = 0.5 * (closing - at_end) * first + 0.5 * at_end * at_end / k2;
                    e * (2.0 * work * k2).sqrt()
                }
                RestitutionLaw::Poisson => e * compression * k2,
                RestitutionLaw::Newton => e * closing,
            };
            return End { case, normal: compression + opening / k2, opening };
        }
        let case = if reverses { ImpactCase::ReversesInRestitution } else { ImpactCase::SticksInRestitution };
        let opening = match law {
            RestitutionLaw::Energetic => {
                let given_back = e * e * closing * closing - at_end * at_end;
                (at_end * at_end + k2 / k1 * given_back).sqrt()
            }
            RestitutionLaw::Poisson => at_end + k2 * ((1.0 + e) * closing / k1 - first),
            RestitutionLaw::Newton => e * closing,
        };
        End { case, normal: first + (opening - at_end) / k2, opening }
    }

    /// The velocities after, and the works on both parts.
    fn impact(&self, jams: bool, restitution: Restitution) -> Impact {
        let End { case, normal, opening } = self.end(jams, restitution);
        let before = self.before;
        let then = self.contact.at_rest;
        let one = normal.min(self.first);
        let two = normal - one;
        let impulse = Impulse { normal, friction: self.slipping.friction * one + then.friction * two };
        let slip_between = match case {
            ImpactCase::Slides => before.slip + self.slipping.slip * one,
            ImpactCase::None
            | ImpactCase::SticksInCompression
            | ImpactCase::ReversesInCompression
            | ImpactCase::SticksInRestitution
            | ImpactCase::ReversesInRestitution
            | ImpactCase::Jams => 0.0,
        };
        let gap_between = before.gap_rate + self.slipping.gap_rate * one;
        let after = ContactVelocities {
            theta_rate: before.theta_rate + self.slipping.spin * one + then.spin * two,
            slip: slip_between + then.slip * two,
            gap_rate: opening,
        };
        let normal_work =
            0.5 * one * (before.gap_rate + gap_between) + 0.5 * two * (gap_between + after.gap_rate);
        let friction_work = 0.5 * self.slipping.friction * one * (before.slip + slip_between)
            + 0.5 * then.friction * two * (slip_between + after.slip);
        Impact { case, before, after, impulse, normal_work, friction_work }
    }
}
