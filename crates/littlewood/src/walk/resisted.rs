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
    Arrival, Candidates, ContactMargin, NextMotion, contact_margin, glide, net_slip_force,
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

    /// By the value of a series, where that decides.
    fn at_once(margin: Margin, value: Bounded) -> Self {
        let is_zero = value.is_exactly_zero();
        let decided = value.is_positive().filter(|_| !is_zero);
        Self::of(margin, value, decided)
    }

    /// Whether Dχ is not zero.
    fn regular(denominator: Bounded) -> Self {
        let is_regular = denominator.is_positive().map(|_| true);
        Self::of(Margin::ResistedDenominator, denominator, is_regular)
    }

    /// By the first coefficient of a series that rounding does not decide, from the order `first` on.
    fn just_after(margin: Margin, series: &Series<Bounded>, first: usize, order: Order) -> Self {
        let mut coefficients = series[first..=order.highest]
            .iter()
            .filter(|c| !c.is_exactly_zero());
        let decided = if order.is_of_exact_state {
            coefficients.find_map(|c| c.is_positive())
        } else {
            coefficients.next().and_then(|c| c.is_positive())
        };
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

/// Up to which order series are computed. Of a state that is another one than that of the simulation
/// the first coefficient alone decides: where it is not certain the next one may not be asked there.
#[derive(Clone, Copy, Debug)]
struct Order {
    highest: usize,
    is_of_exact_state: bool,
}

/// By how much a state may differ from the one that is decided on: θ by `theta`, and θ′, where it is
/// not zero, by `rate` times 1 + |θ′|.
#[derive(Clone, Copy, Debug)]
pub(crate) struct StateDifference {
    pub(crate) theta: f64,
    pub(crate) rate: f64,
}

impl StateDifference {
    const NONE: Self = Self {
        theta: 0.0,
        rate: 0.0,
    };

    const fn is_none(&self) -> bool {
        self.theta == 0.0 && self.rate == 0.0
    }

    /// The angle and the rate of a state, with bounds of what they may be.
    fn place(&self, state: &State) -> PhasePoint<Bounded> {
        // Where a velocity is zero it is so exactly.
        let [mut theta, mut rate] = [state.theta, state.theta_rate].map(Bounded::rounded);
        theta.bound += self.theta;
        if state.theta_rate != 0.0 {
            rate.bound += self.rate * (1.0 + state.theta_rate.abs());
        }
        PhasePoint { theta, rate }
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
    is_exact: bool,
}

/// The motion that begins at a state of a heavy hoop.
pub(crate) fn next_motion(
    hoop: &Hoop,
    body: &Heavy,
    state: &State,
    arrival: Arrival,
) -> NextMotion {
    next_motion_near(hoop, body, state, arrival, StateDifference::NONE)
}

/// The same at a state that may differ from the one given; undecided where that tells.
pub(crate) fn next_motion_near(
    hoop: &Hoop,
    body: &Heavy,
    state: &State,
    arrival: Arrival,
    difference: StateDifference,
) -> NextMotion {
    let trial = Trial::new(hoop, body, state, difference);
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
    let trial = Trial::new(hoop, &rigid, state, StateDifference::NONE);
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
    fn new(hoop: &'a Hoop, body: &Heavy, state: &'a State, difference: StateDifference) -> Self {
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
        let place = difference.place(state);
        Self {
            hoop,
            state,
            contact: contact_margin(body, state),
            body: Heavy::of(composition, slope),
            angle: place.theta.angle(),
            place,
            is_exact: difference.is_none(),
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
        // What holds excludes all that holds less, which need not be tried; not if it is unstable,
        // and does not go on while it can.
        let is_open = |tried: &[Tried], held: Held| {
            !tried.iter().any(|one| {
                one.verdict == Verdict::Holds
                    && !one.is_unstable
                    && one.motion.holds().exceeds(held)
            })
        };
        let (rolls, skids) = (
            Held {
                slip: true,
                turn: false,
            },
            Held {
                slip: false,
                turn: true,
            },
        );
        if sticks && is_open(&tried, rolls) {
            tried.extend(rotations.iter().map(|rotation| self.roll(*rotation)));
        }
        if holds && is_open(&tried, skids) {
            tried.extend(slips.iter().map(|direction| self.skid(*direction)));
        }
        // A massless hoop that slips and turns glides, without a force.
        let slides = matches!(self.hoop.body(), Body::Heavy(_));
        if slides && is_open(&tried, Held::NOTHING) {
            for direction in slips {
                tried.extend(
                    rotations
                        .iter()
                        .map(|rotation| self.slide(direction, *rotation)),
                );
            }
        }
        tried.retain(|one| one.verdict != Verdict::Fails);
        tried
            .iter()
            .filter(|one| is_open(&tried, one.motion.holds()))
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

    const fn order(&self, highest: usize) -> Order {
        Order {
            highest,
            is_of_exact_state: self.is_exact,
        }
    }

    fn roll(&self, rotation: RotationDirection) -> Tried {
        let law = ResistedRollingLaw::of_body(&self.body, self.resistance(rotation));
        if law.is_massless() {
            return self.roll_by(rotation, &law);
        }
        let u = self.place.rate * self.place.rate;
        let forces = law.forces(self.angle, u);
        let [mu_s, _] = self.friction();
        let [back, forth] = SlipDirection::ALL.map(|direction| {
            let margin = mu_s * forces.normal + forces.friction * direction.sign();
            move || Verdict::at_once(Margin::StaticFriction, margin)
        });
        let denominator = law.denominator_of(self.angle);
        let verdict = self
            .begins_to_turn(rotation, || law.acceleration(self.angle, u))
            .and(|| Verdict::regular(denominator))
            .and(|| Verdict::at_once(Margin::NormalForce, forces.normal))
            .and(back)
            .and(forth);
        match verdict {
            Verdict::Holds | Verdict::Fails => Tried {
                motion: ResistedMotion::Roll(rotation),
                verdict,
                is_unstable: denominator.is_positive() == Some(false),
            },
            // Where rounding decides the next derivative is asked.
            Verdict::Undecided(_) => self.roll_by(rotation, &law),
        }
    }

    /// Whether θ′ leaves zero in a direction, if it is zero.
    fn begins_to_turn(
        &self,
        rotation: RotationDirection,
        acceleration: impl FnOnce() -> Bounded,
    ) -> Verdict {
        if self.state.theta_rate == 0.0 {
            Verdict::positive(Margin::Onset, acceleration() * rotation.sign())
        } else {
            Verdict::Holds
        }
    }

    fn roll_by(&self, rotation: RotationDirection, law: &ResistedRollingLaw<Bounded>) -> Tried {
        let order = self.order(HIGHEST_ORDER);
        let series = RollingSeries::new(law, self.place, order.highest);
        let [mu_s, _] = self.friction();
        let denominator = series.denominator[0];
        let verdict = self
            .begins_to_turn(rotation, || series.theta_rate[1])
            .and(|| Verdict::regular(denominator))
            .and(|| Verdict::just_after(Margin::NormalForce, &series.normal, 0, order));
        let [back, forth] = SlipDirection::ALL.map(|direction| {
            let margin = series.margin(mu_s, direction.sign());
            move || Verdict::just_after(Margin::StaticFriction, &margin, 0, order)
        });
        Tried {
            motion: ResistedMotion::Roll(rotation),
            verdict: verdict.and(back).and(forth),
            is_unstable: denominator.is_positive() == Some(false),
        }
    }

    fn slide(&self, direction: SlipDirection, rotation: RotationDirection) -> Tried {
        // The series are long, and their first coefficients mostly decide.
        let tried = self.slide_by(direction, rotation, self.order(1));
        match tried.verdict {
            Verdict::Holds | Verdict::Fails => tried,
            Verdict::Undecided(_) => self.slide_by(direction, rotation, self.order(HIGHEST_ORDER)),
        }
    }

    fn slide_by(
        &self,
        direction: SlipDirection,
        rotation: RotationDirection,
        order: Order,
    ) -> Tried {
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
            let zero = Bounded::constant(0.0);
            let series = SlideSeries::to_order(&law, self.place, zero, order.highest);
            let ahead = series.slip.map(|c| c * direction.sign());
            begins = Verdict::just_after(Margin::Onset, &ahead, 1, order);
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
        let forces = rolling.forces(angle, self.state.theta_rate * self.state.theta_rate);
        let force = net_slip_force(self.hoop, &forces, direction, 0.0).max(0.0);
        let denominator = rolling.denominator_of(angle);
        let acceleration = slip_acceleration_at_rest(body.mass, denominator, force, p);
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
