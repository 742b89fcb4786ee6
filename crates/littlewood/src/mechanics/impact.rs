//! The impact of the rim on the plane: a rigid body, Coulomb friction, and one of three laws of
//! restitution (docs/theory/impact.md).
//!
//! The normal impulse P is the independent variable (Routh; Keller 1986), in which everything is
//! piecewise linear. Of the compliances
//!
//! ```text
//! A = 1/m + (1 + h cos θ)²/Î,   B = h sin θ (1 + h cos θ)/Î,   C = 1/m + h² sin²θ/Î,   A C − B² = D/(m² Î)
//! ```
//!
//! those of a light hoop are large and nearly cancel; dθ′/dP is therefore computed first, and du/dP
//! and dw/dP from it.
//!
//! Literature: J. B. Keller, J. Appl. Mech. 53, 1986; W. J. Stronge, Proc. R. Soc. A 431, 1990 (the
//! energetic law); Y. Wang and M. T. Mason, J. Appl. Mech. 59, 1992 (the cases).

use thiserror::Error;

use crate::math::number::Number;
use crate::math::trig::Angle;
use crate::mechanics::resisted_impact::ResistedContact;
use crate::model::{
    Body, Friction, Heavy, Hoop, Margin, Restitution, RestitutionLaw, RotationDirection,
    SlipDirection, State, Undecided, getters, named,
};

/// The impulse of the plane on the body, in m2 √(gR).
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Impulse<T = f64> {
    /// Upwards, P.
    pub normal: T,
    /// Along E1, J.
    pub friction: T,
}

/// Reason why an impact is undefined.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
#[expect(missing_docs, reason = "the message of each says what its fields are")]
pub enum ImpactError {
    /// The gap does not close.
    #[error(
        "gap_rate = {gap_rate} sqrt(g R) must be finite and not positive: the gap has to close"
    )]
    Opening { gap_rate: f64 },
    /// A massless hoop: an impulse on its rim would cause an infinite velocity.
    #[error("a massless hoop has no impact: an impulse would accelerate its rim without bound")]
    Massless,
    /// Within rounding, static friction holds at its limit where slip ends, |B| = μs A > μk A, or
    /// P = 0 without a closing gap. Next to it impacts differ.
    #[error(
        "rounding decides on the impact at theta = {theta}: between stick and slip, or between a jam and none"
    )]
    Undecided { theta: f64 },
}

named! {
    /// Course of the slip during an impact.
    pub enum ImpactCase, "case of an impact",
    /// Label for tables and figures.
    pub label: &'static str {
        /// No impulse: the gap does not close, and the hoop does not jam.
        None = 0, "none" => "no impulse";
        /// The contact slips throughout.
        Slides = 1, "slides" => "slides";
        /// Slip ends in compression and the contact sticks.
        SticksInCompression = 2, "sticks_in_compression" => "sticks in compression";
        /// Slip reverses in compression.
        ReversesInCompression = 3, "reverses_in_compression" => "reverses in compression";
        /// Slip ends in restitution and the contact sticks.
        SticksInRestitution = 4, "sticks_in_restitution" => "sticks in restitution";
        /// Slip reverses in restitution.
        ReversesInRestitution = 5, "reverses_in_restitution" => "reverses in restitution";
        /// P ≤ 0 (Painlevé): during slip the normal impulse closes the gap, which opens only after
        /// slip has ended; with rolling resistance also without slip, where D_χ ≤ 0, and until the
        /// rotation has ended.
        Jams = 6, "jams" => "jams";
    }
}

/// The velocities that an impact changes.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct ContactVelocities<T = f64> {
    /// Rate θ′.
    pub theta_rate: T,
    /// Slip velocity η′ of the contact point.
    pub slip: T,
    /// Gap rate; negative while the gap closes.
    pub gap_rate: T,
}

impl ContactVelocities {
    pub(crate) const fn of(state: &State, gap_rate: f64) -> Self {
        Self {
            theta_rate: state.theta_rate,
            slip: state.slip,
            gap_rate,
        }
    }
}

/// Binary exponents of the speeds whose squares, and those of the velocities that an impact makes
/// of them, are computed in units of 1.
const EXPONENTS_IN_UNITS_OF_1: core::ops::RangeInclusive<i32> = -300..=300;

/// Largest binary exponent of a velocity in other units. Its derivatives may be larger.
const LARGEST_EXPONENT: i32 = 900;

impl<T: Number> ContactVelocities<T> {
    /// A unit for these velocities in which the square of `speed`, one of their sizes, neither
    /// underflows nor overflows. Impacts and settling are the same in all units, and, as it is a
    /// power of two, to the last bit.
    pub(crate) fn unit_for(&self, speed: f64) -> f64 {
        let exponent = libm::ilogb(speed);
        if speed == 0.0 || EXPONENTS_IN_UNITS_OF_1.contains(&exponent) {
            return 1.0;
        }
        let largest = [self.theta_rate, self.slip, self.gap_rate]
            .into_iter()
            .fold(speed, |largest, velocity| {
                velocity.value().abs().max(largest)
            });
        let least = libm::ilogb(largest).saturating_sub(LARGEST_EXPONENT);
        libm::scalbn(
            1.0,
            exponent
                .clamp(-LARGEST_EXPONENT, LARGEST_EXPONENT)
                .max(least),
        )
    }

    pub(crate) fn times(self, factor: f64) -> Self {
        Self {
            theta_rate: self.theta_rate * factor,
            slip: self.slip * factor,
            gap_rate: self.gap_rate * factor,
        }
    }
}

/// An impact, or the sum of the impacts by which a hoop settles.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Impact<T = f64> {
    /// Course of the slip.
    pub case: ImpactCase,
    /// Velocities before the impact.
    pub before: ContactVelocities<T>,
    /// Velocities after the impact.
    pub after: ContactVelocities<T>,
    /// Impulse on the body.
    pub impulse: Impulse<T>,
    /// Work of the normal impulse, ∫ w dP.
    pub normal_work: T,
    /// Work of the friction impulse, ∫ u dJ ≤ 0.
    pub friction_work: T,
    /// Work of the couple of rolling resistance, −∫ χ |θ′| dP.
    pub resistance_work: T,
}

getters! {
    Impact, [self]:
    /// Energy lost, in m2 g R. Newton's law can make it negative.
    pub energy_lost: f64 = -(self.normal_work + self.friction_work) - self.resistance_work;
    /// Whether the impact increases the energy by more than rounding, which only Newton's law allows.
    pub gains_energy: bool = self.energy_lost() < -self.work_rounding();
}

impl<T: Number> Impact<T> {
    /// No impulse.
    pub(super) fn none(before: ContactVelocities<T>) -> Self {
        let none = T::constant(0.0);
        Self {
            case: ImpactCase::None,
            before,
            after: before,
            impulse: Impulse {
                normal: none,
                friction: none,
            },
            normal_work: none,
            friction_work: none,
            resistance_work: none,
        }
    }

    /// [`Impact::energy_lost`].
    pub(crate) fn lost(&self) -> T {
        -(self.normal_work + self.friction_work) - self.resistance_work
    }

    /// Whether no velocity and no work overflows.
    pub(super) fn is_finite(&self) -> bool {
        let ContactVelocities {
            theta_rate,
            slip,
            gap_rate,
        } = self.after;
        [theta_rate, slip, gap_rate, self.impulse.normal, self.lost()]
            .into_iter()
            .all(|number| number.value().is_finite())
    }

    /// The impact of other velocities, from that of the same in units of `unit`.
    pub(crate) fn of_units(self, before: ContactVelocities<T>, unit: f64) -> Self {
        let mut after = self.after.times(unit);
        let slip = self.after.slip.value();
        if after.slip.value() == 0.0 && slip != 0.0 {
            // The contact slips, and may not stick by underflow.
            after.slip = after.slip.map(f64::from_bits(1).copysign(slip), 1.0);
        }
        Self {
            before,
            after,
            impulse: Impulse {
                normal: self.impulse.normal * unit,
                friction: self.impulse.friction * unit,
            },
            normal_work: self.normal_work * unit * unit,
            friction_work: self.friction_work * unit * unit,
            resistance_work: self.resistance_work * unit * unit,
            ..self
        }
    }
}

impl Impact {
    /// Of the normal work, whose terms, P times a gap rate, have at most 16 roundings.
    const fn work_rounding(&self) -> f64 {
        let rates = self.before.gap_rate.abs() + self.after.gap_rate.abs();
        8.0 * f64::EPSILON * self.impulse.normal * rates
    }

    /// The state after the impact, from the state before it.
    pub(crate) fn state_after(&self, before: &State) -> State {
        State {
            theta_rate: self.after.theta_rate,
            slip: self.after.slip,
            ..*before
        }
    }
}

/// The derivatives of J, θ′, u and w with respect to P, constant on each part of an impact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Slope<T> {
    pub(super) friction: T,
    pub(super) spin: T,
    pub(super) slip: T,
    pub(super) gap_rate: T,
}

/// A vertex of the course of an impact: the impulse up to there, and the velocities then.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct ImpactVertex {
    /// Impulse since the start of the impact.
    pub impulse: Impulse,
    /// Velocities.
    pub velocities: ContactVelocities,
}

/// Compliance of the contact point to an impulse (J, P), in 1/m2: u′ − u = A J + B P, w′ − w = B
/// J + C P.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Compliance {
    /// A: change of slip by the friction impulse.
    pub a: f64,
    /// B: change of slip by the normal impulse, and of the gap rate by the friction impulse.
    pub b: f64,
    /// C: change of the gap rate by the normal impulse.
    pub c: f64,
}

impl Hoop {
    /// The compliance at an angle; `None` for a massless hoop.
    pub fn compliance(&self, theta: f64) -> Option<Compliance> {
        let Body::Heavy(body) = self.body() else {
            return None;
        };
        let (sin, cos) = libm::sincos(theta);
        let (h_sin, height) = (body.h * sin, 1.0 + body.h * cos);
        Some(Compliance {
            a: 1.0 / body.mass + height * height / body.inertia,
            b: h_sin * height / body.inertia,
            c: 1.0 / body.mass + h_sin * h_sin / body.inertia,
        })
    }

    /// The vertices of an impact in the plane of impulses (J, P): zero, the impulse at which slip
    /// ends, if it does, and the total; with rolling resistance also those at which a rotation
    /// ends. Empty for a massless hoop. Not defined for the sum of the
    /// impacts of a [`crate::impact::Settling`].
    pub fn impact_course(&self, theta: f64, impact: &Impact) -> Vec<ImpactVertex> {
        let Body::Heavy(body) = self.body() else {
            return Vec::new();
        };
        let contact = Contact::new(self, &body, theta);
        let start = ImpactVertex {
            impulse: Impulse {
                normal: 0.0,
                friction: 0.0,
            },
            velocities: impact.before,
        };
        let end = ImpactVertex {
            impulse: impact.impulse,
            velocities: impact.after,
        };
        let bends = match &contact.resisted {
            Some(resisted) => resisted.bends(impact.before, impact.impulse.normal),
            None => contact.bend(impact).into_iter().collect(),
        };
        [vec![start], bends, vec![end]].concat()
    }

    /// The impact of a hoop whose rim touches the plane in `state` with `gap_rate` ≤ 0. Friction is
    /// μk in slip and at most μs in stick.
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
    /// `gap_rate` > 0 or not finite; a massless hoop; a tie within rounding.
    pub fn impact(
        &self,
        state: &State,
        gap_rate: f64,
        restitution: Restitution,
    ) -> Result<Impact, ImpactError> {
        let Body::Heavy(body) = self.body() else {
            return Err(ImpactError::Massless);
        };
        if !(gap_rate.is_finite() && gap_rate <= 0.0) {
            return Err(ImpactError::Opening { gap_rate });
        }
        let before = ContactVelocities::of(state, gap_rate);
        let contact = Contact::new(self, &body, state.theta);
        let impact = contact.impact(before, restitution);
        if contact.undecided(&impact, restitution).is_some() {
            return Err(ImpactError::Undecided { theta: state.theta });
        }
        Ok(impact)
    }

    /// The impact without collision that continues a slide where no motion is consistent, P ≤ 0, or
    /// which has reached P = 0. `None` for a massless hoop, without a coefficient of restitution,
    /// and without slip. Does not apply where P > 0.
    ///
    /// With rolling resistance a hoop without slip may jam, too: where D_χ < 0 it stops dead (eq.
    /// dead-stop). `None` where a normal impulse opens the gap.
    pub fn jam(&self, state: &State) -> Option<Impact> {
        let (Body::Heavy(body), Some(restitution)) = (self.body(), self.restitution()) else {
            return None;
        };
        let contact = Contact::new(self, &body, state.theta);
        contact.jam(ContactVelocities::of(state, 0.0), restitution)
    }
}

/// An impact whose slip ends in a stick, by its slopes with respect to the normal impulse.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sticking {
    /// k1 and k2: the slopes of the gap rate in slip and in stick.
    pub(crate) in_slip: f64,
    pub(crate) in_stick: f64,
    /// The rate at which the slip decreases.
    pub(crate) braking: f64,
}

/// What follows where slip ends.
#[derive(Clone, Copy, Debug, PartialEq)]
enum AfterSlip {
    /// Static friction holds, |B| ≤ μs A.
    Sticks,
    /// The contact slips again.
    Reverses,
    /// |B|/A − μs is zero within rounding, and kinetic friction is weaker.
    Undecided { excess: f64, rounding: f64 },
}

/// The coefficients of an impact at one angle.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Contact<T = f64> {
    mass: T,
    /// h sin θ and 1 + h cos θ, from the contact point to the mass centre.
    h_sin: T,
    height: T,
    /// In slip with σ = −1 and σ = +1.
    slipping: [Slope<T>; 2],
    /// m Î times the slope of the gap rate in slip is P.
    painleve_per_slope: f64,
    /// Rounding of the slopes of the gap rate in slip.
    slope_rounding: f64,
    /// After slip has ended.
    at_rest: Slope<T>,
    after_slip: AfterSlip,
    /// With rolling resistance, which the other coefficients leave out.
    resisted: Option<ResistedContact<T>>,
}

/// Sizes of the terms of the compliances.
struct TermSizes {
    mass: f64,
    inertia: f64,
    /// h |sin θ|.
    arm: f64,
    /// |1 + h cos θ|, and the sum of the sizes of its terms.
    height: f64,
    reach: f64,
}

impl TermSizes {
    /// Of m Î (|B| − μs A). A term has at most 18 roundings: of μs m (1 + h cos θ)² 6 in each
    /// factor, 1 of m, 3 products and 2 sums.
    fn rounding_of_excess(&self, mu_s: f64) -> f64 {
        let Self {
            mass,
            inertia,
            arm,
            height,
            reach,
        } = *self;
        let height = height + 3.0 * f64::EPSILON * reach;
        9.0 * f64::EPSILON * (mass * reach * (arm + 2.0 * mu_s * height) + mu_s * inertia)
    }

    /// Of k1 = P/(m Î). A term has at most 20 roundings: 16 of P, and 4 of the quotient.
    fn rounding_of_slope(&self, mu_k: f64) -> f64 {
        let Self {
            mass,
            inertia,
            arm,
            reach,
            ..
        } = *self;
        10.0 * f64::EPSILON * (1.0 / mass + arm * (arm + mu_k * reach) / inertia)
    }
}

impl Contact {
    /// Where the slip of an impact ends on the way.
    fn bend(&self, impact: &Impact) -> Option<ImpactVertex> {
        let before = impact.before;
        let direction = SlipDirection::of_sign(before.slip);
        let slipping = direction.map_or(self.at_rest, |direction| self.slope(direction));
        let first = self.course(before, direction, slipping).first;
        (first > 0.0 && first < impact.impulse.normal).then_some(ImpactVertex {
            impulse: Impulse {
                normal: first,
                friction: slipping.friction * first,
            },
            velocities: ContactVelocities {
                theta_rate: before.theta_rate + slipping.spin * first,
                slip: 0.0,
                gap_rate: before.gap_rate + slipping.gap_rate * first,
            },
        })
    }

    pub(crate) fn new(hoop: &Hoop, body: &Heavy, theta: f64) -> Self {
        Self::of(body, hoop.friction(), theta.angle())
    }

    /// The slopes of an impact that begins with slip in this direction, of a hoop that turns on in
    /// another; `None` where the slip does not end in a stick.
    pub(crate) fn sticking(
        &self,
        direction: SlipDirection,
        rotation: RotationDirection,
    ) -> Option<Sticking> {
        if let Some(resisted) = &self.resisted {
            return resisted.sticking(direction, rotation);
        }
        let slipping = self.slope(direction);
        let braking = -direction.sign() * slipping.slip;
        (braking > 0.0 && self.after_slip == AfterSlip::Sticks).then_some(Sticking {
            in_slip: slipping.gap_rate,
            in_stick: self.at_rest.gap_rate,
            braking,
        })
    }
}

impl<T: Number> Contact<T> {
    /// The contact of a body at an angle.
    pub(crate) fn of(body: &Heavy<T>, friction: Friction<T>, angle: Angle<T>) -> Self {
        let Angle { sin, cos } = angle;
        let Friction { mu_s, mu_k, .. } = friction;
        let (mass, h_sin, height) = (body.mass, body.h * sin, body.h * cos + 1.0);
        let slope = |friction: T, spin: T| Slope {
            friction,
            spin,
            slip: friction / mass + height * spin,
            gap_rate: T::constant(1.0) / mass + h_sin * spin,
        };
        let slipping = SlipDirection::ALL.map(|direction| {
            let friction = -mu_k * direction.sign();
            slope(friction, (h_sin + friction * height) / body.inertia)
        });
        // m Î A and m Î B.
        let (a, b) = (body.inertia + mass * height * height, mass * h_sin * height);
        let stuck = Slope {
            slip: T::constant(0.0),
            ..slope(-b / a, h_sin / a)
        };
        let sizes = TermSizes {
            mass: mass.value(),
            inertia: body.inertia.value(),
            arm: h_sin.value().abs(),
            height: height.value().abs(),
            reach: 1.0 + (body.h * cos).value().abs(),
        };
        // Sticking requires |B| ≤ μs A. Where P ≤ 0 in slip towards sign B, μk |B| ≥ C, it holds:
        // μs A ≥ A C/|B| > |B|.
        let (mu_s, mu_k) = (mu_s.value(), mu_k.value());
        let excess = b.value().abs() - mu_s * a.value();
        let rounding = sizes.rounding_of_excess(mu_s);
        let reversed = SlipDirection::of_sign(b.value())
            .map(|direction| slipping[direction.index()])
            .filter(|reversed| reversed.gap_rate.value() > 0.0);
        let (at_rest, after_slip) = match reversed {
            // With μk = μs both are the same impact.
            Some(_) if excess.abs() <= rounding && (mu_s - mu_k) * a.value() > rounding => {
                let [excess, rounding] = [excess, rounding].map(|number| number / a.value());
                (stuck, AfterSlip::Undecided { excess, rounding })
            }
            Some(reversed) if excess > 0.0 => (reversed, AfterSlip::Reverses),
            Some(_) | None => (stuck, AfterSlip::Sticks),
        };
        Self {
            mass,
            h_sin,
            height,
            slipping,
            painleve_per_slope: (mass * body.inertia).value(),
            slope_rounding: sizes.rounding_of_slope(mu_k),
            at_rest,
            after_slip,
            resisted: ResistedContact::new(body, friction, angle),
        }
    }

    /// The number that decides on an impact, where its sign is rounding and the impacts to both
    /// sides of the tie differ.
    pub(crate) fn undecided(
        &self,
        impact: &Impact<T>,
        restitution: Restitution<T>,
    ) -> Option<Undecided> {
        if let Some(resisted) = &self.resisted {
            return resisted.undecided(impact.before, restitution);
        }
        match impact.case {
            ImpactCase::Slides => None,
            // P = 0: without a closing gap, between none and a jam.
            ImpactCase::None | ImpactCase::Jams => {
                let before = impact.before;
                let direction = SlipDirection::of_sign(before.slip.value())
                    .filter(|_| before.gap_rate.value() == 0.0)?;
                let slope = self.slope(direction).gap_rate.value();
                (slope.abs() <= self.slope_rounding).then_some(Undecided::Rounding {
                    margin: Margin::Painleve,
                    value: slope * self.painleve_per_slope,
                    bound: self.slope_rounding * self.painleve_per_slope,
                })
            }
            ImpactCase::SticksInCompression
            | ImpactCase::ReversesInCompression
            | ImpactCase::SticksInRestitution
            | ImpactCase::ReversesInRestitution => match self.after_slip {
                AfterSlip::Undecided { excess, rounding } => Some(Undecided::Rounding {
                    margin: Margin::ImpactFriction,
                    value: excess,
                    bound: rounding,
                }),
                AfterSlip::Sticks | AfterSlip::Reverses => None,
            },
        }
    }

    pub(super) const fn resisted(&self) -> Option<&ResistedContact<T>> {
        self.resisted.as_ref()
    }

    fn slope(&self, direction: SlipDirection) -> Slope<T> {
        self.slipping[direction.index()]
    }

    /// The impact with these velocities, for a gap rate ≤ 0.
    pub(crate) fn impact(
        &self,
        before: ContactVelocities<T>,
        restitution: Restitution<T>,
    ) -> Impact<T> {
        if let Some(resisted) = &self.resisted {
            return resisted.impact(before, restitution).impact;
        }
        let direction = SlipDirection::of_sign(before.slip.value());
        let slipping = direction.map_or(self.at_rest, |direction| self.slope(direction));
        let jams = direction.is_some() && slipping.gap_rate.value() <= 0.0;
        if before.gap_rate.value() == 0.0 && !jams {
            return Impact::none(before);
        }
        self.collide(before, direction, slipping, jams, restitution)
    }

    /// The jam at gap rate 0 of a hoop that slips where P ≤ 0, or, with rolling resistance, that
    /// does not slip where a normal impulse closes the gap. Where a slide has reached P = 0,
    /// rounding may make P positive; it is set to zero.
    pub(crate) fn jam(
        &self,
        before: ContactVelocities<T>,
        restitution: Restitution<T>,
    ) -> Option<Impact<T>> {
        if let Some(resisted) = &self.resisted {
            return resisted.jam(before, restitution, &mut |_, _| ());
        }
        let direction = SlipDirection::of_sign(before.slip.value())?;
        let slope = self.slope(direction);
        let slipping = if slope.gap_rate.value() <= 0.0 {
            slope
        } else {
            let spin = T::constant(-1.0) / (self.mass * self.h_sin);
            let slip = slope.friction / self.mass + self.height * spin;
            Slope {
                spin,
                slip,
                gap_rate: T::constant(0.0),
                ..slope
            }
        };
        Some(self.collide(before, Some(direction), slipping, true, restitution))
    }

    /// The number that decides on the course of a jam.
    pub(crate) fn undecided_jam(
        &self,
        jam: &Impact<T>,
        restitution: Restitution<T>,
    ) -> Option<Undecided> {
        let resisted = self.resisted.as_ref()?;
        resisted.undecided_jam(jam.before, restitution)
    }

    /// The impact with these velocities and these slopes of the initial slip.
    fn collide(
        &self,
        before: ContactVelocities<T>,
        direction: Option<SlipDirection>,
        slipping: Slope<T>,
        jams: bool,
        restitution: Restitution<T>,
    ) -> Impact<T> {
        // Without a jam the impulse is proportional to the closing rate.
        let (closing, slip) = (before.gap_rate.value().abs(), before.slip.value().abs());
        let unit = before.unit_for(if jams { closing.max(slip) } else { closing });
        self.course(before.times(1.0 / unit), direction, slipping)
            .impact(jams, restitution)
            .of_units(before, unit)
    }

    fn course(
        &self,
        before: ContactVelocities<T>,
        direction: Option<SlipDirection>,
        slipping: Slope<T>,
    ) -> Course<'_, T> {
        let first = match direction {
            None => T::constant(0.0),
            Some(direction) => {
                let deceleration = slipping.slip * -direction.sign();
                if deceleration.value() > 0.0 {
                    before.slip.abs() / deceleration
                } else {
                    T::constant(f64::INFINITY)
                }
            }
        };
        Course {
            contact: self,
            before,
            slipping,
            first,
        }
    }
}

/// The two parts of an impact: the initial slip, up to the normal impulse `first`, and the rest.
#[derive(Clone, Copy, Debug)]
struct Course<'a, T> {
    contact: &'a Contact<T>,
    before: ContactVelocities<T>,
    slipping: Slope<T>,
    first: T,
}

struct End<T> {
    case: ImpactCase,
    /// P.
    normal: T,
    /// Gap rate after the impact, from the law of restitution. Summed over P it would be lost in
    /// rounding for small e.
    opening: T,
}

impl<T: Number> Course<'_, T> {
    /// The end of the impact by the law of restitution.
    fn end(&self, jams: bool, restitution: Restitution<T>) -> End<T> {
        let e = restitution.coefficient;
        let (closing, k1) = (-self.before.gap_rate, self.slipping.gap_rate);
        let whole = (e + 1.0) * closing;
        if !jams && self.first.value() * k1.value() >= whole.value() {
            return End {
                case: ImpactCase::Slides,
                normal: whole / k1,
                opening: e * closing,
            };
        }
        // The gap rate where slip ends.
        let at_end = k1 * self.first - closing;
        if at_end.value() <= 0.0 {
            self.end_after_slip_in_compression(at_end, jams, restitution)
        } else {
            self.end_after_slip_in_restitution(at_end, restitution)
        }
    }

    /// The end of the impact if slip ends at a gap rate ≤ 0.
    fn end_after_slip_in_compression(
        &self,
        at_end: T,
        jams: bool,
        restitution: Restitution<T>,
    ) -> End<T> {
        let case = match (jams, self.contact.after_slip) {
            (true, _) => ImpactCase::Jams,
            (false, AfterSlip::Reverses) => ImpactCase::ReversesInCompression,
            (false, AfterSlip::Sticks | AfterSlip::Undecided { .. }) => {
                ImpactCase::SticksInCompression
            }
        };
        let e = restitution.coefficient;
        let (closing, first) = (-self.before.gap_rate, self.first);
        let k2 = self.contact.at_rest.gap_rate;
        let compression = first - at_end / k2;
        let opening = match restitution.law {
            RestitutionLaw::Energetic => {
                let work = (closing - at_end) * 0.5 * first + at_end * 0.5 * at_end / k2;
                e * (work * 2.0 * k2).sqrt()
            }
            RestitutionLaw::Poisson => e * compression * k2,
            RestitutionLaw::Newton => e * closing,
        };
        End {
            case,
            normal: compression + opening / k2,
            opening,
        }
    }

    /// The end of the impact if slip ends at a gap rate > 0.
    fn end_after_slip_in_restitution(&self, at_end: T, restitution: Restitution<T>) -> End<T> {
        let case = match self.contact.after_slip {
            AfterSlip::Reverses => ImpactCase::ReversesInRestitution,
            AfterSlip::Sticks | AfterSlip::Undecided { .. } => ImpactCase::SticksInRestitution,
        };
        let e = restitution.coefficient;
        let (closing, first) = (-self.before.gap_rate, self.first);
        let (k1, k2) = (self.slipping.gap_rate, self.contact.at_rest.gap_rate);
        let opening = match restitution.law {
            RestitutionLaw::Energetic => {
                let left = e * e * closing * closing - at_end * at_end;
                // It is not negative, but for rounding.
                let left = if left.value() < 0.0 {
                    T::constant(0.0)
                } else {
                    left
                };
                (at_end * at_end + k2 / k1 * left).sqrt()
            }
            RestitutionLaw::Poisson => at_end + k2 * ((e + 1.0) * closing / k1 - first),
            RestitutionLaw::Newton => e * closing,
        };
        End {
            case,
            normal: first + (opening - at_end) / k2,
            opening,
        }
    }

    fn impact(&self, jams: bool, restitution: Restitution<T>) -> Impact<T> {
        let End {
            case,
            normal,
            opening,
        } = self.end(jams, restitution);
        let before = self.before;
        let then = self.contact.at_rest;
        let (one, slip_between) = match case {
            ImpactCase::Slides => {
                let slip = before.slip + self.slipping.slip * normal;
                // Where slip all but ends with the impact, rounding may not reverse it.
                let [now, reversed] =
                    [slip, -before.slip].map(|it| SlipDirection::of_sign(it.value()));
                let ends = now == reversed;
                (normal, if ends { T::constant(0.0) } else { slip })
            }
            ImpactCase::None
            | ImpactCase::SticksInCompression
            | ImpactCase::ReversesInCompression
            | ImpactCase::SticksInRestitution
            | ImpactCase::ReversesInRestitution
            | ImpactCase::Jams => (self.first, T::constant(0.0)),
        };
        let two = normal - one;
        let impulse = Impulse {
            normal,
            friction: self.slipping.friction * one + then.friction * two,
        };
        let gap_between = before.gap_rate + self.slipping.gap_rate * one;
        let after = ContactVelocities {
            theta_rate: before.theta_rate + self.slipping.spin * one + then.spin * two,
            slip: slip_between + then.slip * two,
            gap_rate: opening,
        };
        let normal_work = one * 0.5 * (before.gap_rate + gap_between)
            + two * 0.5 * (gap_between + after.gap_rate);
        let friction_work = self.slipping.friction * 0.5 * one * (before.slip + slip_between)
            + then.friction * 0.5 * two * (slip_between + after.slip);
        Impact {
            case,
            before,
            after,
            impulse,
            normal_work,
            friction_work,
            resistance_work: T::constant(0.0),
        }
    }
}
