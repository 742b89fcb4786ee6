//! The motion that follows a state of a hoop with rolling resistance
//! (docs/theory/rolling-resistance.md).
//!
//! A mode is a pair of signs, of η′ and of θ′, each of which may be zero. Every mode that the state
//! allows is tried: its forces must obey their laws, and a velocity that is zero must leave zero with
//! the sign of the mode. What is at rest stays at rest while it can: a mode is possible only where no
//! other consistent one keeps at zero all that it keeps, and more.

use crate::math::bounded::Bounded;
use crate::math::number::Number;
use crate::math::series::Series;
use crate::math::trig::Angle;
use crate::mechanics::region::PhasePlane;
use crate::mechanics::{
    Contact, ContactVelocities, HeldLaw, ResistedRollingLaw, SlidingLaw, slip_acceleration_at_rest,
};
use crate::model::{
    Body, Composition, Heavy, Hoop, Margin, Massless, Mode, Restitution, RestitutionLaw,
    RotationDirection, SlipDirection, State, Undecided,
};
use crate::modes::{Entry, PhasePoint, RollingLimit, RollingSeries, SlideSeries, TakeOff};
use crate::walk::candidates::{
    Arrival, Candidates, ContactMargin, NextMotion, contact_margin, glide,
};

/// Highest order of a series that decides where the lower ones are rounding.
const HIGHEST_ORDER: usize = 6;

/// A motion in contact with rolling resistance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ResistedMotion {
    Rest,
    Roll(RotationDirection),
    Skid(SlipDirection),
    Slide {
        direction: SlipDirection,
        rotation: RotationDirection,
        entry: Entry,
    },
}

impl ResistedMotion {
    pub(crate) const fn mode(&self) -> Mode {
        match self {
            Self::Rest => Mode::Rest,
            Self::Roll(_) => Mode::Rolling,
            Self::Skid(_) => Mode::Skidding,
            Self::Slide { .. } => Mode::Sliding,
        }
    }

    /// Direction of slip.
    pub(crate) const fn direction(&self) -> Option<SlipDirection> {
        match self {
            Self::Skid(direction) | Self::Slide { direction, .. } => Some(*direction),
            Self::Rest | Self::Roll(_) => None,
        }
    }

    /// The velocities that it keeps at zero.
    const fn holds(&self) -> Held {
        match self {
            Self::Rest => Held {
                slip: true,
                turn: true,
            },
            Self::Roll(_) => Held {
                slip: true,
                turn: false,
            },
            Self::Skid(_) => Held {
                slip: false,
                turn: true,
            },
            Self::Slide { .. } => Held::NOTHING,
        }
    }
}

/// The velocities that a contact holds at zero: η′ and θ′.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Held {
    pub(crate) slip: bool,
    pub(crate) turn: bool,
}

impl Held {
    pub(crate) const NOTHING: Self = Self {
        slip: false,
        turn: false,
    };

    /// Whether it holds all that another holds, and more.
    const fn exceeds(self, other: Self) -> bool {
        (self.slip >= other.slip)
            & (self.turn >= other.turn)
            & (self.slip != other.slip || self.turn != other.turn)
    }

    const fn shares(self, other: Self) -> bool {
        (self.slip & other.slip) | (self.turn & other.turn)
    }
}

/// Whether a condition, or a mode with all of its conditions, is met.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Verdict {
    Holds,
    Fails,
    Undecided(Undecided),
}

impl Verdict {
    fn of(margin: Margin, number: Bounded, holds: Option<bool>) -> Self {
        match holds {
            Some(true) => Self::Holds,
            Some(false) => Self::Fails,
            None => Self::Undecided(Undecided::Rounding {
                margin,
                value: number.value,
                // Divided by what may be zero, a number has no bound.
                bound: if number.bound.is_nan() {
                    f64::INFINITY
                } else {
                    number.bound
                },
            }),
        }
    }

    fn positive(margin: Margin, number: Bounded) -> Self {
        Self::of(margin, number, number.is_positive())
    }

    fn non_negative(margin: Margin, number: Bounded) -> Self {
        Self::of(margin, number, number.is_non_negative())
    }

    /// By the first coefficient of a series that rounding does not decide, from an order on.
    fn just_after(margin: Margin, series: &Series<Bounded>, first: usize) -> Self {
        let decided = series[first..=HIGHEST_ORDER].iter().find_map(|c| {
            if c.is_exactly_zero() {
                None
            } else {
                c.is_positive()
            }
        });
        Self::of(margin, series[first], decided)
    }

    /// Both conditions.
    fn and(self, other: impl FnOnce() -> Self) -> Self {
        match self {
            Self::Fails => Self::Fails,
            Self::Holds => other(),
            Self::Undecided(_) => match other() {
                Self::Fails => Self::Fails,
                Self::Holds | Self::Undecided(_) => self,
            },
        }
    }
}

/// A mode that is consistent, or that rounding decides.
#[derive(Clone, Copy, Debug)]
struct Tried {
    motion: ResistedMotion,
    verdict: Verdict,
    /// Rolling with Dχ < 0: pressing closes the gap.
    is_unstable: bool,
}

/// What is consistent beside the modes that are tried.
#[derive(Clone, Copy, Debug)]
struct Others {
    flight: bool,
    gliding: bool,
    /// Dχ < 0 of rolling beside which the hoop may jam.
    jam: Option<f64>,
}

impl Others {
    const fn any(&self) -> bool {
        self.flight | self.gliding | self.jam.is_some()
    }
}

/// A state with bounds of its rounding.
struct Trial<'a> {
    hoop: &'a Hoop,
    state: &'a State,
    contact: ContactMargin,
    body: Heavy<Bounded>,
    place: PhasePoint<Bounded>,
    angle: Angle<Bounded>,
}

/// The motion that begins at a state of a heavy hoop.
pub(crate) fn next_motion(
    hoop: &Hoop,
    body: &Heavy,
    state: &State,
    arrival: Arrival,
) -> NextMotion {
    let trial = Trial::new(hoop, body, state);
    let slip = match arrival {
        Arrival::RollingLimit(RollingLimit::Friction(direction)) => {
            trial.slip_out_of_rolling(body, direction)
        }
        Arrival::Start
        | Arrival::InContact
        | Arrival::Held(_)
        | Arrival::GlideAtRest { .. }
        | Arrival::RollingLimit(RollingLimit::NormalForce)
        | Arrival::BackOnLimit(_)
        | Arrival::LiftOff => None,
    };
    if let Some(motion) = slip {
        return NextMotion::Resisted {
            body: *body,
            motion,
        };
    }
    let mut tried = trial.modes();
    if matches!(arrival, Arrival::RollingLimit(_)) {
        tried.retain(|one| !one.motion.holds().slip);
    }
    let arrives = arrival != Arrival::Start;
    if arrives {
        keep_held(&mut tried, arrival);
    }
    let others = Others {
        flight: trial.contact.lifts_off,
        gliding: false,
        jam: trial.jam(body, &tried),
    };
    trial.selected(body, &tried, others, arrives)
}

/// The motion that begins at a state of a massless hoop: it glides where nothing else is
/// consistent.
pub(crate) fn massless(
    hoop: &Hoop,
    body: &Massless,
    state: &State,
    arrival: Arrival,
) -> NextMotion {
    let rigid = hoop.rigid_body();
    let trial = Trial::new(hoop, &rigid, state);
    let mut tried = trial.modes();
    if matches!(arrival, Arrival::RollingLimit(_)) {
        tried.clear();
    }
    if arrival != Arrival::Start {
        keep_held(&mut tried, arrival);
    }
    let glide = || glide(hoop, body, state, arrival, None);
    if tried.is_empty() {
        return glide();
    }
    // Where pressing closes the gap rolling does not come before a glide, which needs no force.
    let others = Others {
        flight: false,
        gliding: tried.iter().any(|one| one.is_unstable) && glide().mode().is_some(),
        jam: None,
    };
    trial.selected(&rigid, &tried, others, true)
}

/// A motion that arrives goes on holding what it held.
fn keep_held(tried: &mut Vec<Tried>, arrival: Arrival) {
    let is_held = |one: &Tried| one.motion.holds().shares(arrival.held());
    if tried.iter().any(is_held) {
        tried.retain(is_held);
    }
}

impl<'a> Trial<'a> {
    fn new(hoop: &'a Hoop, body: &Heavy, state: &'a State) -> Self {
        let parameters = hoop.parameters();
        let [mass_ratio, offset, inertia, slope] = [
            parameters.mass_ratio,
            parameters.offset,
            parameters.inertia,
            parameters.slope,
        ]
        .map(Bounded::constant);
        let composition = Composition {
            mass_ratio,
            offset,
            inertia,
        };
        // Where a velocity is zero it is so exactly.
        let [theta, rate] = [state.theta, state.theta_rate].map(Bounded::rounded);
        Self {
            hoop,
            state,
            contact: contact_margin(body, state),
            body: Heavy::of(composition, slope),
            place: PhasePoint { theta, rate },
            angle: theta.angle(),
        }
    }

    fn resistance(&self, rotation: RotationDirection) -> Bounded {
        Bounded::constant(self.hoop.rolling_resistance()) * rotation.sign()
    }

    fn friction(&self) -> [Bounded; 2] {
        [self.hoop.mu_s(), self.hoop.mu_k()].map(Bounded::constant)
    }

    /// The modes that are consistent, and those that rounding decides, without those that another
    /// consistent one excludes.
    fn modes(&self) -> Vec<Tried> {
        let slips = SlipDirection::of_sign(self.state.slip)
            .map_or(SlipDirection::ALL.to_vec(), |direction| vec![direction]);
        let rotations = RotationDirection::of_sign(self.state.theta_rate)
            .map_or(RotationDirection::ALL.to_vec(), |direction| vec![direction]);
        let (sticks, holds) = (self.state.slip == 0.0, self.state.theta_rate == 0.0);
        let mut tried = Vec::new();
        if sticks && holds {
            tried.push(self.rest());
        }
        if sticks {
            tried.extend(rotations.iter().map(|rotation| self.roll(*rotation)));
        }
        if holds {
            tried.extend(slips.iter().map(|direction| self.skid(*direction)));
        }
        // A massless hoop that slips and turns glides, without a force. Whatever holds a velocity comes
        // before a slide, whose series take longer than a half swing.
        let holds_a_velocity = tried
            .iter()
            .any(|one| one.verdict == Verdict::Holds && !one.is_unstable);
        let slides = matches!(self.hoop.body(), Body::Heavy(_)) && !holds_a_velocity;
        for direction in slips.into_iter().filter(|_| slides) {
            tried.extend(
                rotations
                    .iter()
                    .map(|rotation| self.slide(direction, *rotation)),
            );
        }
        tried.retain(|one| one.verdict != Verdict::Fails);
        // What is unstable does not go on while it can.
        let is_excluded = |one: &Tried| {
            tried.iter().any(|other| {
                other.verdict == Verdict::Holds
                    && !other.is_unstable
                    && other.motion.holds().exceeds(one.motion.holds())
            })
        };
        tried
            .iter()
            .filter(|one| !is_excluded(one))
            .copied()
            .collect()
    }

    /// Rest: the couple holds the angle, and friction the rim.
    fn rest(&self) -> Tried {
        let [mu_s, friction] = self.friction();
        let law = HeldLaw {
            body: self.body,
            friction,
        };
        let couple = if self.hoop.slope() == 0.0 && self.hoop.rolling_resistance() >= self.hoop.h()
        {
            // On a level plane the hoop then rests anywhere.
            Verdict::Holds
        } else {
            self.couple_margin(law.arm_of_rest(self.angle))
        };
        let friction = mu_s - self.body.tilt.abs();
        Tried {
            motion: ResistedMotion::Rest,
            verdict: couple.and(|| Verdict::non_negative(Margin::StaticFriction, friction)),
            is_unstable: false,
        }
    }

    /// Whether the couple can hold the angle: |M| ≤ χ N.
    fn couple_margin(&self, arm: Bounded) -> Verdict {
        let chi = Bounded::constant(self.hoop.rolling_resistance());
        Verdict::non_negative(Margin::HeldAngle, chi - arm.abs())
    }

    fn skid(&self, direction: SlipDirection) -> Tried {
        let [_, mu_k] = self.friction();
        let law = HeldLaw {
            body: self.body,
            friction: mu_k * direction.sign(),
        };
        let begins = || {
            if self.state.slip != 0.0 {
                return Verdict::Holds;
            }
            let acceleration = law.slip_acceleration() * direction.sign();
            Verdict::positive(Margin::Onset, acceleration)
        };
        Tried {
            motion: ResistedMotion::Skid(direction),
            verdict: self.couple_margin(law.arm_of_skid(self.angle)).and(begins),
            is_unstable: false,
        }
    }

    fn roll(&self, rotation: RotationDirection) -> Tried {
        let law = ResistedRollingLaw::of_body(&self.body, self.resistance(rotation));
        let series = RollingSeries::new(&law, self.place, HIGHEST_ORDER);
        let [mu_s, _] = self.friction();
        let begins = if self.state.theta_rate == 0.0 {
            let acceleration = series.theta_rate[1] * rotation.sign();
            Verdict::positive(Margin::Onset, acceleration)
        } else {
            Verdict::Holds
        };
        let denominator = series.denominator[0].is_positive();
        let verdict = begins
            .and(|| {
                Verdict::of(
                    Margin::ResistedDenominator,
                    series.denominator[0],
                    denominator.map(|_| true),
                )
            })
            .and(|| Verdict::just_after(Margin::NormalForce, &series.normal, 0));
        let [back, forth] = SlipDirection::ALL.map(|direction| {
            let margin = series.margin(mu_s, direction.sign());
            move || Verdict::just_after(Margin::StaticFriction, &margin, 0)
        });
        Tried {
            motion: ResistedMotion::Roll(rotation),
            verdict: verdict.and(back).and(forth),
            is_unstable: denominator == Some(false),
        }
    }

    fn slide(&self, direction: SlipDirection, rotation: RotationDirection) -> Tried {
        let [_, mu_k] = self.friction();
        let law = SlidingLaw {
            resistance: self.resistance(rotation),
            ..SlidingLaw::of_body(self.body, mu_k, direction)
        };
        let Angle { sin, cos } = self.angle;
        let q = law.q(1.0, sin, cos);
        let p = law.p(sin, q);
        // N = m Î w/P; at w = 0 the sign of w just after decides.
        let pressing = if self.contact.lifts_off { -p } else { p };
        let pressed = Verdict::positive(Margin::Painleve, pressing);
        let turns = || {
            if self.state.theta_rate != 0.0 {
                return Verdict::Holds;
            }
            Verdict::positive(Margin::Onset, q * rotation.sign())
        };
        let (mut entry, mut begins) = (Entry::Moving, Verdict::Holds);
        if self.state.slip == 0.0 && pressed != Verdict::Fails {
            let series = SlideSeries::new(&law, self.place, Bounded::constant(0.0));
            let ahead = series.slip.map(|c| c * direction.sign());
            begins = Verdict::just_after(Margin::Onset, &ahead, 1);
            let acceleration = series.slip[1];
            let is_decided = acceleration.is_positive().is_some();
            entry = Entry::FromRest {
                slip_acceleration: if is_decided { acceleration.value } else { 0.0 },
            };
        }
        Tried {
            motion: ResistedMotion::Slide {
                direction,
                rotation,
                entry,
            },
            verdict: pressed.and(turns).and(|| begins),
            is_unstable: false,
        }
    }

    /// The slide in the direction in which rolling reaches |F| = μs N. There η″ = σ Dχ (μs − μk) N/(m
    /// P), which vanishes for equal coefficients; η‴ then has the sign of σ.
    fn slip_out_of_rolling(
        &self,
        body: &Heavy,
        direction: SlipDirection,
    ) -> Option<ResistedMotion> {
        let rotation = RotationDirection::of_sign(self.state.theta_rate)?;
        let chi = rotation.sign() * self.hoop.rolling_resistance();
        let law = SlidingLaw {
            resistance: chi,
            ..SlidingLaw::of_body(*body, self.hoop.mu_k(), direction)
        };
        let p = law.painleve(self.state.theta);
        if p <= 0.0 || self.contact.lifts_off {
            return None;
        }
        let angle = Angle::of(self.state.theta);
        let rolling = ResistedRollingLaw::of_body(body, chi);
        let normal = rolling
            .forces(angle, self.state.theta_rate * self.state.theta_rate)
            .normal;
        let excess = (self.hoop.mu_s() - self.hoop.mu_k()) * normal.max(0.0);
        let denominator = rolling.denominator_of(angle);
        let acceleration = slip_acceleration_at_rest(body.mass, denominator, excess, p);
        Some(ResistedMotion::Slide {
            direction,
            rotation,
            entry: Entry::FromRest {
                slip_acceleration: direction.sign() * acceleration,
            },
        })
    }

    /// Dχ < 0 of rolling, if a normal impulse closes the gap: the hoop may then also jam.
    fn jam(&self, body: &Heavy, tried: &[Tried]) -> Option<f64> {
        let rolling = tried.iter().find(|one| one.is_unstable)?;
        let rotation = RotationDirection::of_sign(self.state.theta_rate)?;
        let without_rebound = Restitution {
            coefficient: 0.0,
            law: RestitutionLaw::Energetic,
        };
        let contact = Contact::new(self.hoop, body, self.state.theta);
        contact.jam(ContactVelocities::of(self.state, 0.0), without_rebound)?;
        let law = ResistedRollingLaw::of_body(&self.body, self.resistance(rotation));
        (rolling.verdict == Verdict::Holds).then(|| law.denominator_of(self.angle).value)
    }

    /// The one motion among those that are possible; with `keeps_contact` flight only where there is
    /// no other that is stable.
    fn selected(
        &self,
        body: &Heavy,
        tried: &[Tried],
        others: Others,
        keeps_contact: bool,
    ) -> NextMotion {
        let undecided = tried.iter().find_map(|one| match one.verdict {
            Verdict::Undecided(undecided) => Some(undecided),
            Verdict::Holds | Verdict::Fails => None,
        });
        if let Some(undecided) = undecided {
            return NextMotion::Undecided(undecided);
        }
        match tried {
            [] if others.flight => NextMotion::Fly {
                body: *body,
                take_off: if self.contact.grazes {
                    TakeOff::Grazing
                } else {
                    TakeOff::Unloaded
                },
            },
            [] => NextMotion::None(Box::new(self.candidates(tried, others))),
            [one] if !others.any() || (keeps_contact && !one.is_unstable) => NextMotion::Resisted {
                body: *body,
                motion: one.motion,
            },
            _ => NextMotion::Several(Box::new(self.candidates(tried, others))),
        }
    }

    fn candidates(&self, tried: &[Tried], others: Others) -> Candidates {
        let has = |mode: Mode, direction: Option<SlipDirection>| {
            tried
                .iter()
                .any(|one| (one.motion.mode(), one.motion.direction()) == (mode, direction))
        };
        // What slides would need in the direction of rotation.
        let rotation = RotationDirection::of_sign(self.state.theta_rate);
        let resistance = rotation.map_or(Bounded::constant(0.0), |it| self.resistance(it));
        let forces = PhasePlane::new(self.hoop)
            .forces_at_unit_gravity(self.state.theta, self.state.theta_rate);
        let [_, mu_k] = self.friction();
        let solvability = SlipDirection::ALL.map(|direction| {
            let law = SlidingLaw {
                resistance,
                ..SlidingLaw::of_body(self.body, mu_k, direction)
            };
            let Angle { sin, cos } = self.angle;
            law.p(sin, law.q(1.0, sin, cos)).value
        });
        let [negative, positive] = SlipDirection::ALL.map(Some);
        Candidates {
            rest: has(Mode::Rest, None),
            rolling: has(Mode::Rolling, None),
            skidding_negative: has(Mode::Skidding, negative),
            skidding_positive: has(Mode::Skidding, positive),
            sliding_negative: has(Mode::Sliding, negative),
            sliding_positive: has(Mode::Sliding, positive),
            flight: others.flight,
            gliding: others.gliding,
            jam: others.jam,
            ..Candidates::none(forces, self.contact.value, solvability)
        }
    }
}
