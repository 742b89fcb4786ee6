//! The motion that follows a state: the modes that satisfy the laws of contact and of friction
//! there (docs/theory/contact.md).
//!
//! At η′ = 0 rolling, a slide and flight compete. Static friction is read as: where rolling and a
//! slide both are consistent, the contact sticks. So a slide from η′ = 0 is a candidate only if
//! rolling is not. The motion continues if there is exactly one candidate; a start with none or
//! several is an outcome. A motion that arrives in contact stays in contact while it can.

use crate::mechanics::region::PhasePlane;
use crate::mechanics::{
    ContactForces, RollingLaw, Settling, SlidingLaw, contact, contact_rounding, leaves_plane,
    slip_acceleration_at_rest,
};
use crate::model::{
    Body, Detail, Dimension, Heavy, Hoop, Margin, Massless, Mode, SlipDirection, State, Undecided,
};
use crate::modes::{
    Entry, GlideEntry, MasslessLimit, Onset, PhasePoint, RollingLimit, RollingOrbit, StaticLimit,
    Stiction, TakeOff,
};
use crate::walk::resisted::{self, Held, ResistedMotion};

/// The candidate motions at a state, and the quantities that decide between them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Candidates {
    /// Rest is consistent (rolling resistance).
    pub rest: bool,
    /// Rolling is consistent.
    pub rolling: bool,
    /// Skidding with σ = −1 is consistent (rolling resistance).
    pub skidding_negative: bool,
    /// Skidding with σ = +1 is consistent (rolling resistance).
    pub skidding_positive: bool,
    /// Sliding with σ = −1 is consistent.
    pub sliding_negative: bool,
    /// Sliding with σ = +1 is consistent.
    pub sliding_positive: bool,
    /// Flight is consistent.
    pub flight: bool,
    /// Gliding is consistent (massless hoop).
    pub gliding: bool,
    /// Dχ of rolling that is consistent although Dχ < 0, where a jam is consistent, too: pressing
    /// closes the gap, and the hoop may stop dead ([`Hoop::jam`]).
    pub jam: Option<f64>,
    /// N and F that rolling would need (2.12).
    pub rolling_forces: ContactForces,
    /// 1 − h cos θ θ′²; negative if the body would leave the plane.
    pub contact: f64,
    /// P = Î + m h sin θ q for σ = −1 and σ = +1; sliding is not well posed for P ≤ 0 (Painlevé).
    pub solvability: [f64; 2],
}

impl Candidates {
    pub(crate) const fn none(
        rolling_forces: ContactForces,
        contact: f64,
        solvability: [f64; 2],
    ) -> Self {
        Self {
            rest: false,
            rolling: false,
            skidding_negative: false,
            skidding_positive: false,
            sliding_negative: false,
            sliding_positive: false,
            flight: false,
            gliding: false,
            jam: None,
            rolling_forces,
            contact,
            solvability,
        }
    }

    /// Number of consistent motions, a jam among them.
    pub fn count(&self) -> usize {
        self.consistent().count() + usize::from(self.jam.is_some())
    }

    /// The deciding quantities with their names in records.
    pub fn details(&self) -> impl Iterator<Item = (&'static str, Detail)> {
        let [negative, positive] = self.solvability;
        let jam = self.jam.map(|denominator| {
            let name = Margin::ResistedDenominator.name();
            (name, Detail::Real(denominator, Dimension::Ratio))
        });
        let of_all = [
            (
                "rolling_normal",
                Detail::Real(self.rolling_forces.normal, Dimension::Force),
            ),
            (
                "rolling_friction",
                Detail::Real(self.rolling_forces.friction, Dimension::Force),
            ),
            ("contact", Detail::Real(self.contact, Dimension::Ratio)),
            (
                "solvability_negative",
                Detail::Real(negative, Dimension::Ratio),
            ),
            (
                "solvability_positive",
                Detail::Real(positive, Dimension::Ratio),
            ),
        ];
        of_all.into_iter().chain(jam)
    }

    /// The consistent motions, with their direction of slip.
    pub fn consistent(&self) -> impl Iterator<Item = (Mode, Option<SlipDirection>)> {
        [
            (self.rest, (Mode::Rest, None)),
            (self.rolling, (Mode::Rolling, None)),
            (
                self.skidding_negative,
                (Mode::Skidding, Some(SlipDirection::Negative)),
            ),
            (
                self.skidding_positive,
                (Mode::Skidding, Some(SlipDirection::Positive)),
            ),
            (
                self.sliding_negative,
                (Mode::Sliding, Some(SlipDirection::Negative)),
            ),
            (
                self.sliding_positive,
                (Mode::Sliding, Some(SlipDirection::Positive)),
            ),
            (self.gliding, (Mode::Gliding, None)),
            (self.flight, (Mode::Flight, None)),
        ]
        .into_iter()
        .filter_map(|(consistent, motion)| consistent.then_some(motion))
    }
}

/// The motion that begins; `on_limit` if |F| = μs N at the start and static friction holds after
/// it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum NextMotion {
    Roll {
        on_limit: bool,
    },
    Slide {
        body: Heavy,
        direction: SlipDirection,
        entry: Entry,
    },
    Glide {
        body: Massless,
        entry: GlideEntry,
    },
    Fly {
        body: Heavy,
        take_off: TakeOff,
    },
    /// Infinitely many bounces.
    Settle {
        body: Heavy,
        settling: Box<Settling>,
    },
    /// In contact with rolling resistance.
    Resisted {
        body: Heavy,
        motion: ResistedMotion,
    },
    None(Box<Candidates>),
    Several(Box<Candidates>),
    /// Rounding decides between motions.
    Undecided(Undecided),
}

impl NextMotion {
    /// The motion that begins at `state`, from the exact conditions.
    pub(crate) fn at(hoop: &Hoop, state: &State, arrival: Arrival) -> Self {
        match hoop.body() {
            Body::Heavy(body) => match arrival {
                Arrival::LiftOff => Self::Fly {
                    body,
                    take_off: TakeOff::Grazing,
                },
                _ if hoop.rolling_resistance() > 0.0 => {
                    resisted::next_motion(hoop, &body, state, arrival)
                }
                Arrival::Start
                | Arrival::InContact
                | Arrival::Held(_)
                | Arrival::GlideAtRest { .. }
                | Arrival::RollingLimit(_)
                | Arrival::BackOnLimit(_) => select_mode(
                    hoop,
                    &body,
                    state,
                    &exact_inputs(hoop, &body, state, arrival),
                ),
            },
            Body::Massless(body) => match (arrival, hoop.undecided_place(state.theta)) {
                (Arrival::GlideAtRest { .. }, Some(undecided)) => Self::Undecided(undecided),
                _ if hoop.rolling_resistance() > 0.0 => {
                    resisted::massless(hoop, &body, state, arrival)
                }
                _ => massless(hoop, &body, state, arrival),
            },
        }
    }

    pub(crate) const fn mode(&self) -> Option<Mode> {
        match self {
            Self::Roll { .. } => Some(Mode::Rolling),
            Self::Slide { .. } => Some(Mode::Sliding),
            Self::Glide { .. } => Some(Mode::Gliding),
            Self::Fly { .. } | Self::Settle { .. } => Some(Mode::Flight),
            Self::Resisted { motion, .. } => Some(motion.mode()),
            Self::None(_) | Self::Several(_) | Self::Undecided(_) => None,
        }
    }

    /// The direction of slip, if it is known before the phase is solved.
    pub(crate) const fn direction(&self) -> Option<SlipDirection> {
        match self {
            Self::Slide { direction, .. } => Some(*direction),
            Self::Resisted { motion, .. } => motion.direction(),
            Self::Roll { .. }
            | Self::Glide { .. }
            | Self::Fly { .. }
            | Self::Settle { .. }
            | Self::None(_)
            | Self::Several(_)
            | Self::Undecided(_) => None,
        }
    }
}

/// How the state was reached; resolves ties on a boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Arrival {
    /// A start: any consistent motion may follow.
    Start,
    /// In contact, on no known boundary: at the end of a slide, or of an impact without rebound.
    InContact,
    /// The same at the end of a phase with rolling resistance, which held some velocities at zero.
    Held(Held),
    /// The slip of a glide vanishes. `presses` if the normal force of rolling is positive.
    GlideAtRest { presses: bool },
    /// Rolling reaches this limit.
    RollingLimit(RollingLimit),
    /// A slide without kinetic friction returns to the limit of static friction. The slip continues
    /// in this direction, or none if static friction holds.
    BackOnLimit(Option<SlipDirection>),
    /// The normal force of a slide vanishes, with w decreasing: only flight follows.
    LiftOff,
}

impl Arrival {
    /// The velocities that the contact held at zero before.
    pub(crate) const fn held(self) -> Held {
        match self {
            Self::Held(held) => held,
            Self::RollingLimit(_) => Held {
                slip: true,
                turn: false,
            },
            Self::Start
            | Self::InContact
            | Self::GlideAtRest { .. }
            | Self::BackOnLimit(_)
            | Self::LiftOff => Held::NOTHING,
        }
    }
}

/// w = 1 − h cos θ θ′², and what follows from it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ContactMargin {
    pub(crate) value: f64,
    /// Flight is consistent: w < 0, or w = 0 and decreasing.
    pub(crate) lifts_off: bool,
    /// w = 0, but for rounding.
    pub(crate) grazes: bool,
}

/// What selects the mode of a heavy hoop.
pub(crate) struct ModeInputs {
    pub(crate) contact: ContactMargin,
    pub(crate) slip: SlipInputs,
    /// P for σ = −1 and σ = +1; zero within rounding.
    pub(crate) painleve: [f64; 2],
    /// Whether the motion is in contact and so keeps it, if rolling allows it. At a start rolling
    /// and flight are then ambiguous.
    pub(crate) keeps_contact: bool,
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum SlipInputs {
    /// η′ ≠ 0.
    Moving(SlipDirection),
    /// η′ = 0.
    AtRest(RestInputs),
}

/// What rolling needs at η′ = 0, and whether static friction supplies it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RestInputs {
    pub(crate) stiction: Stiction,
    /// Whether rolling would begin with |F| = μs N.
    pub(crate) on_limit: bool,
    /// Static friction holds by rounding, or a slip in this direction begins.
    pub(crate) may_slip: Option<SlipDirection>,
    pub(crate) rolling_forces: ContactForces,
    /// D.
    pub(crate) effective_inertia: f64,
}

/// Whether rolling can need N > 0 where the plane does not press, w ≤ 0. Then N (A C − B²) = A w −
/// B (h sin θ u + tan α) and B has the sign of sin θ, so the term of the slope has to be the larger
/// one, and against it. On a level plane it never is.
pub(crate) fn may_wedge(body: &Heavy, sin: f64, u: f64) -> bool {
    (body.h * sin * u + body.pull()) * sin < 0.0
}

/// w at a state, and what follows from it.
pub(crate) fn contact_margin(body: &Heavy, state: &State) -> ContactMargin {
    let (sin, cos) = libm::sincos(state.theta);
    let u = state.theta_rate * state.theta_rate;
    let value = contact(1.0, body.h, cos * u);
    let rounding = contact_rounding(body.h, cos, u);
    ContactMargin {
        value,
        lifts_off: leaves_plane(value, rounding, body.h * sin * u, state.theta_rate),
        grazes: value.abs() <= rounding,
    }
}

/// Evaluates what selects the mode at a state.
fn exact_inputs(hoop: &Hoop, body: &Heavy, state: &State, arrival: Arrival) -> ModeInputs {
    let theta = state.theta;
    let laws =
        SlipDirection::ALL.map(|direction| SlidingLaw::of_body(*body, hoop.mu_k(), direction));
    let contact = contact_margin(body, state);
    let at_rest = || SlipInputs::AtRest(exact_rest(hoop, body, state, arrival, contact));
    ModeInputs {
        contact,
        slip: SlipDirection::of_sign(state.slip).map_or_else(at_rest, SlipInputs::Moving),
        painleve: laws.map(|law| {
            if law.is_singular(theta) {
                0.0
            } else {
                law.painleve(theta)
            }
        }),
        keeps_contact: arrival != Arrival::Start,
    }
}

/// The same at η′ = 0. Rolling is decided by the same margins from which its end is computed.
fn exact_rest(
    hoop: &Hoop,
    body: &Heavy,
    state: &State,
    arrival: Arrival,
    contact: ContactMargin,
) -> RestInputs {
    let place = PhasePoint {
        theta: state.theta,
        rate: state.theta_rate,
    };
    let rolling = RollingLaw::of(hoop);
    let forces = rolling.forces(place.theta, place.rate);
    let of = |stiction: Stiction| RestInputs {
        stiction,
        on_limit: false,
        may_slip: None,
        rolling_forces: forces,
        effective_inertia: rolling.denominator(place.theta),
    };
    let slips = |direction, excess| of(Stiction::Slips { direction, excess });
    let on_limit = || RestInputs {
        on_limit: true,
        ..of(Stiction::Holds)
    };
    match arrival {
        // Next to w = 0 rounding could tell otherwise.
        _ if contact.lifts_off
            && !may_wedge(body, libm::sin(place.theta), place.rate * place.rate) =>
        {
            of(Stiction::NoNormalForce)
        }
        Arrival::RollingLimit(RollingLimit::Friction(direction)) => slips(direction, 0.0),
        Arrival::RollingLimit(RollingLimit::NormalForce) | Arrival::LiftOff => {
            of(Stiction::NoNormalForce)
        }
        Arrival::BackOnLimit(None) => on_limit(),
        Arrival::BackOnLimit(Some(direction)) => slips(
            direction,
            forces.friction.abs() - hoop.mu_s() * forces.normal,
        ),
        Arrival::Start | Arrival::InContact | Arrival::Held(_) | Arrival::GlideAtRest { .. } => {
            let free_fall = contact
                .grazes
                .then(|| StaticLimit::in_free_fall(hoop, &place))
                .flatten();
            let rolling_forces = if free_fall.is_some() {
                ContactForces::NONE
            } else {
                forces
            };
            // On the limit the sign of |F| − μs N is that of rounding.
            let rest = match free_fall.or_else(|| StaticLimit::at(hoop, &place)) {
                Some(StaticLimit::Holds) => on_limit(),
                Some(StaticLimit::Slips { direction, excess }) => slips(direction, excess),
                Some(StaticLimit::Undecided(direction)) if arrival == Arrival::Start => {
                    RestInputs {
                        may_slip: Some(direction),
                        ..of(Stiction::Holds)
                    }
                }
                Some(StaticLimit::Undecided(_)) | None => {
                    of(RollingOrbit::of(hoop, place.theta, place.rate).stiction())
                }
            };
            RestInputs {
                rolling_forces,
                ..rest
            }
        }
    }
}

/// A slide that is consistent.
struct Slide {
    direction: SlipDirection,
    entry: Entry,
}

/// Selects the mode of a heavy hoop: the one rule for every solver, for starts and arrivals.
///
/// Sliding needs N = m Î w/P > 0. At η′ = 0 that leaves one mode where w > 0, and where w < 0 at
/// most rolling and flight (docs/theory/contact.md), so that no more than one slide need be
/// examined.
#[inline(always)]
pub(crate) fn select_mode(
    hoop: &Hoop,
    body: &Heavy,
    state: &State,
    inputs: &ModeInputs,
) -> NextMotion {
    let ModeInputs {
        contact: ContactMargin {
            lifts_off, grazes, ..
        },
        ref slip,
        painleve,
        keeps_contact,
    } = *inputs;
    let on_limit = matches!(slip, SlipInputs::AtRest(rest) if rest.on_limit);
    let (rolls, slide) = match slip {
        SlipInputs::Moving(direction) => {
            // At w = 0 the sign of w just after, which is that of flight, decides. At P = 0 nothing
            // does, and the slide is unresolved.
            let p = painleve[direction.index()];
            let is_pressed = if lifts_off { p <= 0.0 } else { p >= 0.0 };
            let slide = is_pressed.then_some(Slide {
                direction: *direction,
                entry: Entry::Moving,
            });
            (false, slide)
        }
        SlipInputs::AtRest(rest) if rest.stiction == Stiction::Holds => {
            let slide = rest.may_slip.map(|direction| Slide {
                direction,
                entry: Entry::FromRest {
                    slip_acceleration: 0.0,
                },
            });
            (true, slide)
        }
        // A slide that presses with w < 0 has P < 0, and begins only where rolling holds, too.
        SlipInputs::AtRest(_) if lifts_off => (false, None),
        SlipInputs::AtRest(rest) => (false, slip_onset(hoop, body, state, rest, painleve)),
    };
    match (rolls, slide, lifts_off) {
        (true, None, false) => NextMotion::Roll { on_limit },
        (true, None, true) if keeps_contact => NextMotion::Roll { on_limit },
        (false, Some(Slide { direction, entry }), false) => NextMotion::Slide {
            body: *body,
            direction,
            entry,
        },
        (false, None, true) => {
            let take_off = if grazes {
                TakeOff::Grazing
            } else {
                TakeOff::Unloaded
            };
            NextMotion::Fly {
                body: *body,
                take_off,
            }
        }
        (_, slide, _) => undecided(hoop, state, inputs, rolls, slide),
    }
}

/// No motion is consistent, or several are.
#[cold]
fn undecided(
    hoop: &Hoop,
    state: &State,
    inputs: &ModeInputs,
    rolling: bool,
    slide: Option<Slide>,
) -> NextMotion {
    let slides = |direction| {
        slide
            .as_ref()
            .is_some_and(|slide| slide.direction == direction)
    };
    let forces = RollingLaw::of(hoop).forces(state.theta, state.theta_rate);
    let candidates = Box::new(Candidates {
        rolling,
        sliding_negative: slides(SlipDirection::Negative),
        sliding_positive: slides(SlipDirection::Positive),
        flight: inputs.contact.lifts_off,
        ..Candidates::none(forces, inputs.contact.value, inputs.painleve)
    });
    if candidates.count() == 0 {
        NextMotion::None(candidates)
    } else {
        NextMotion::Several(candidates)
    }
}

/// The slide that begins at η′ = 0 where w > 0 and static friction does not hold: against the
/// friction force of rolling, since |F| > μk N, and P > 0 there.
fn slip_onset(
    hoop: &Hoop,
    body: &Heavy,
    state: &State,
    rest: &RestInputs,
    painleve: [f64; 2],
) -> Option<Slide> {
    if hoop.mu_s() == 0.0 {
        // Where F is rounding, the first derivative of η′ that does not vanish decides.
        let law = SlidingLaw::of_body(*body, 0.0, SlipDirection::Positive);
        let place = PhasePoint {
            theta: state.theta,
            rate: state.theta_rate,
        };
        if let Some(Onset { direction, .. }) = Onset::of(&law, place).filter(|it| it.order > 1) {
            return Some(Slide {
                direction,
                entry: Entry::FromRest {
                    slip_acceleration: 0.0,
                },
            });
        }
    }
    let forces = &rest.rolling_forces;
    let (direction, excess) = match rest.stiction {
        Stiction::Holds => return None,
        Stiction::Slips { direction, excess } => (direction, excess),
        Stiction::NoNormalForce => {
            let direction = SlipDirection::of_sign(forces.friction)?.reversed();
            (
                direction,
                forces.friction.abs() - hoop.mu_s() * forces.normal,
            )
        }
    };
    // The excess over μs N has decided against rolling, and the force follows from it, so that
    // their signs agree.
    let onward = net_slip_force(hoop, forces, direction, excess);
    // On the limit N, with a large μs also F, may be rounding, and the direction, too. Then the
    // slide the other way is the consistent one.
    let back = direction.sign() * forces.friction - hoop.mu_k() * forces.normal;
    [(direction, onward), (direction.reversed(), back)]
        .into_iter()
        .find_map(|(towards, force)| {
            let p = painleve[towards.index()];
            let acceleration =
                slip_acceleration_at_rest(body.mass, rest.effective_inertia, force, p);
            // On the static limit with μs = μk it vanishes, and η‴ has the sign of `direction`.
            let begins = acceleration > 0.0 || (force == 0.0 && towards == direction);
            (p > 0.0 && begins).then_some(Slide {
                direction: towards,
                entry: Entry::FromRest {
                    slip_acceleration: towards.sign() * acceleration,
                },
            })
        })
}

/// −σF − μk N of a slip in the direction σ that begins with −σF − μs N = `excess`, whose sign it
/// has for N > 0. With a large μs the term μs N amplifies the cancellation in N, so F is used
/// instead; on the limit −σF = μs N.
pub(crate) fn net_slip_force(
    hoop: &Hoop,
    forces: &ContactForces,
    direction: SlipDirection,
    excess: f64,
) -> f64 {
    let (mu_s, mu_k) = (hoop.mu_s(), hoop.mu_k());
    if mu_s <= 1.0 {
        return excess + (mu_s - mu_k) * forces.normal;
    }
    let against = -direction.sign() * forces.friction;
    let force = against - mu_k * forces.normal;
    match (excess == 0.0, forces.normal > 0.0) {
        (true, _) => (mu_s - mu_k) / mu_s * against,
        (false, true) if force <= 0.0 => excess,
        (false, _) => force,
    }
}

fn massless(hoop: &Hoop, body: &Massless, state: &State, arrival: Arrival) -> NextMotion {
    let (theta, theta_rate) = (state.theta, state.theta_rate);
    let at_rest = state.slip == 0.0;
    let may_roll = match arrival {
        Arrival::Start | Arrival::InContact | Arrival::Held(_) => at_rest,
        Arrival::GlideAtRest { presses } => presses,
        Arrival::RollingLimit(_) | Arrival::BackOnLimit(_) | Arrival::LiftOff => false,
    };
    let limit = if may_roll && arrival == Arrival::Start {
        let place = PhasePoint {
            theta,
            rate: theta_rate,
        };
        MasslessLimit::at(hoop, &place)
    } else {
        None
    };
    match limit {
        Some(MasslessLimit::Rolls) => return NextMotion::Roll { on_limit: true },
        Some(MasslessLimit::Undecided) => {
            let forces = RollingLaw::of(hoop).forces(theta, theta_rate);
            let cos_u = libm::sincos(theta).1 * (theta_rate * theta_rate);
            let contact_margin = contact(1.0, body.offset, cos_u);
            return NextMotion::Several(Box::new(Candidates {
                rolling: true,
                gliding: true,
                ..Candidates::none(forces, contact_margin, [0.0; 2])
            }));
        }
        Some(MasslessLimit::Glides { .. }) => {}
        None => {
            let stiction = || RollingOrbit::of(hoop, theta, theta_rate).stiction();
            if may_roll && stiction() == Stiction::Holds {
                return NextMotion::Roll { on_limit: false };
            }
        }
    }
    glide(hoop, body, state, arrival, limit)
}

/// The glide from a state of a massless hoop that does not roll.
pub(crate) fn glide(
    hoop: &Hoop,
    body: &Massless,
    state: &State,
    arrival: Arrival,
    limit: Option<MasslessLimit>,
) -> NextMotion {
    let (sin, cos) = libm::sincos(state.theta);
    let u = state.theta_rate * state.theta_rate;
    let contact_margin = contact(1.0, body.offset, cos * u);
    let at_rest = state.slip == 0.0;
    // At the top a glide requires the acceleration of free fall: ℓ̂ θ′² = 1.
    let falls_freely =
        || cos > 0.0 && contact_margin.abs() <= contact_rounding(body.offset, cos, u);
    if sin != 0.0 || falls_freely() {
        let entry = match (arrival, limit) {
            (
                Arrival::Start
                | Arrival::InContact
                | Arrival::Held(_)
                | Arrival::BackOnLimit(_)
                | Arrival::LiftOff,
                _,
            ) if !at_rest => GlideEntry::Moving,
            (Arrival::RollingLimit(RollingLimit::NormalForce), _)
            | (_, Some(MasslessLimit::Glides { unloaded: true })) => GlideEntry::Unloaded,
            (Arrival::RollingLimit(RollingLimit::Friction(_)), _) => GlideEntry::FromRest {
                presses: Some(true),
            },
            (Arrival::GlideAtRest { presses }, _) => GlideEntry::FromRest {
                presses: Some(presses),
            },
            (
                Arrival::Start
                | Arrival::InContact
                | Arrival::Held(_)
                | Arrival::BackOnLimit(_)
                | Arrival::LiftOff,
                _,
            ) => GlideEntry::FromRest { presses: None },
        };
        return NextMotion::Glide { body: *body, entry };
    }
    let forces = PhasePlane::new(hoop).forces_at_unit_gravity(state.theta, state.theta_rate);
    NextMotion::None(Box::new(Candidates::none(forces, contact_margin, [0.0; 2])))
}
