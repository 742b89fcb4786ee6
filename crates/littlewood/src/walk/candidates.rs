//! Which motion follows: the candidates that the accelerations admit, all together.
//!
//! At η′ = 0 three motions compete: rolling (|F| ≤ μs N, N > 0), sliding to either side (N > 0 and σ η″ > 0, or
//! η″ = 0 and η‴ of that sign) and flight (1 − h cos θ θ′² < 0, or = 0 and falling). With the forces N and F of
//! rolling, the slip acceleration of sliding is
//!
//! ```text
//! η″ = −D (F + μk σ N)/(m P),
//! ```
//!
//! so that for P > 0 only σ = −sign F can slide, and only if |F| > μk N. While μk N < |F| ≤ μs N both rolling and
//! sliding would agree with their accelerations; it is the meaning of static friction that a body at rest against
//! the plane then stays at rest. A slide from rest is therefore a candidate only where rolling is not.
//!
//! One candidate is taken. None or several (Painlevé: P ≤ 0) is an answer of its own.

use crate::mechanics::{
    ContactForces, RollingLaw, SlidingLaw, contact, leaves_plane, slip_acceleration_at_rest,
};
use crate::model::{Body, Detail, Dimension, Direction, Heavy, Hoop, Massless, Mode, State};
use crate::modes::{GlideEntry, Hold, RollingLimit, RollingOrbit, TakeOff};

/// The motions that might follow at a state, and what decides between them.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Candidates {
    /// Rolling is consistent.
    pub rolling: bool,
    /// Sliding with σ = −1 is consistent.
    pub sliding_negative: bool,
    /// Sliding with σ = +1 is consistent.
    pub sliding_positive: bool,
    /// Flight is consistent.
    pub flight: bool,
    /// Gliding is consistent (massless hoop).
    pub gliding: bool,
    /// N and F that rolling would need (2.12).
    pub rolling_forces: ContactForces,
    /// 1 − h cos θ θ′²: negative where the body would leave the plane.
    pub contact: f64,
    /// P = Î + m h sin θ q for σ = −1 and σ = +1; sliding is not well posed where it is not positive (Painlevé).
    pub solvability: [f64; 2],
}

impl Candidates {
    /// Number of motions that are consistent.
    #[must_use]
    pub fn count(&self) -> usize {
        self.consistent().count()
    }

    /// The numbers that decide, with the names that records use.
    #[must_use]
    pub const fn details(&self) -> [(&'static str, Detail); 5] {
        let [negative, positive] = self.solvability;
        [
            ("rolling_normal", Detail::Real(self.rolling_forces.normal, Dimension::Force)),
            ("rolling_friction", Detail::Real(self.rolling_forces.friction, Dimension::Force)),
            ("contact", Detail::Real(self.contact, Dimension::Ratio)),
            ("solvability_negative", Detail::Real(negative, Dimension::Ratio)),
            ("solvability_positive", Detail::Real(positive, Dimension::Ratio)),
        ]
    }

    /// The consistent motions, with their direction of slip.
    pub fn consistent(&self) -> impl Iterator<Item = (Mode, Option<Direction>)> {
        [
            (self.rolling, (Mode::Rolling, None)),
            (self.sliding_negative, (Mode::Sliding, Some(Direction::Negative))),
            (self.sliding_positive, (Mode::Sliding, Some(Direction::Positive))),
            (self.gliding, (Mode::Gliding, None)),
            (self.flight, (Mode::Flight, None)),
        ]
        .into_iter()
        .filter_map(|(consistent, motion)| consistent.then_some(motion))
    }
}

/// The motion that follows.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Next {
    /// `on_limit` where |F| = μs N, and static friction holds from there on.
    Roll {
        on_limit: bool,
    },
    /// `slip_acceleration` where η′ = 0.
    Slide {
        body: Heavy,
        direction: Direction,
        slip_acceleration: Option<f64>,
    },
    Glide {
        body: Massless,
        entry: GlideEntry,
    },
    Fly {
        body: Heavy,
        take_off: TakeOff,
    },
    None(Box<Candidates>),
    Several(Box<Candidates>),
}

/// How the state was reached, which resolves ties on a boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Arrival {
    /// No boundary: a start, or a slide that came to rest.
    Open,
    /// The slip of a glide has just come to rest, where the normal force of rolling is positive or negative.
    GlideAtRest { presses: bool },
    /// Rolling has just reached this limit.
    RollingLimit(RollingLimit),
    /// A slide without kinetic friction has come back to the limit of static friction, and slips on in this direction; or static
    /// friction holds from there on.
    BackOnLimit(Option<Direction>),
    /// The normal force of a slide has just vanished, w falling through zero: only flight follows.
    LiftOff,
}

/// Decides which motion follows at `state`, from the exact conditions.
pub(crate) fn next_motion(hoop: &Hoop, state: &State, arrival: Arrival) -> Next {
    match hoop.body() {
        Body::Heavy(body) => match arrival {
            Arrival::LiftOff => Next::Fly { body, take_off: TakeOff::Grazing },
            Arrival::Open
            | Arrival::GlideAtRest { .. }
            | Arrival::RollingLimit(_)
            | Arrival::BackOnLimit(_) => {
                weigh(hoop, &body, state, &exact_evidence(hoop, &body, state, arrival))
            }
        },
        Body::Massless(body) => massless(hoop, &body, state, arrival),
    }
}

/// Quantities on which the decision for a heavy hoop rests.
pub(crate) struct Evidence<P> {
    /// w = 1 − h cos θ θ′².
    pub(crate) contact: f64,
    /// Whether the body leaves the plane.
    pub(crate) leaves: bool,
    /// The slip.
    pub(crate) slip: SlipEvidence,
    /// P in a direction of slip.
    pub(crate) solvability: P,
    /// Whether P > 0 in both directions.
    pub(crate) is_solvable: bool,
    /// Whether rolling, if it follows, begins with |F| = μs N.
    pub(crate) on_limit: bool,
}

/// State of the slip.
#[derive(Clone, Copy, Debug)]
pub(crate) enum SlipEvidence {
    /// η′ ≠ 0.
    Moving(Direction),
    /// η′ = 0: whether static friction sustains rolling, N and F of rolling, and D.
    AtRest { hold: Hold, rolling_forces: ContactForces, denominator: f64 },
}

/// From the state by the exact rules: rolling is decided by the coefficients of the margins from which the end of
/// rolling is found, too.
fn exact_evidence(
    hoop: &Hoop,
    body: &Heavy,
    state: &State,
    arrival: Arrival,
) -> Evidence<impl Fn(Direction) -> f64> {
    let (theta, theta_rate) = (state.theta, state.theta_rate);
    let laws = Direction::ALL.map(|direction| SlidingLaw::of_body(*body, hoop.mu_k(), direction));
    let contact = laws[0].contact(theta, theta_rate);
    let slip = Direction::of_sign(state.slip).map_or_else(
        || {
            let rolling = RollingLaw::new(hoop);
            SlipEvidence::AtRest {
                hold: match arrival {
                    Arrival::RollingLimit(RollingLimit::Friction(direction)) => {
                        Hold::Slips { direction, excess: 0.0 }
                    }
                    Arrival::RollingLimit(RollingLimit::NormalForce) | Arrival::LiftOff => {
                        Hold::NoNormalForce
                    }
                    Arrival::BackOnLimit(None) => Hold::Holds,
                    Arrival::BackOnLimit(Some(direction)) => {
                        let forces = rolling.forces(theta, theta_rate);
                        let excess = forces.friction.abs() - hoop.mu_s() * forces.normal;
                        Hold::Slips { direction, excess }
                    }
                    Arrival::Open | Arrival::GlideAtRest { .. } => {
                        RollingOrbit::new(hoop, theta, theta_rate).hold()
                    }
                },
                rolling_forces: rolling.forces(theta, theta_rate),
                denominator: rolling.denominator(theta),
            }
        },
        SlipEvidence::Moving,
    );
    let solvability = laws.map(|law| law.solvability(theta));
    Evidence {
        contact,
        leaves: leaves_plane(contact, libm::sin(theta), theta_rate),
        slip,
        solvability: move |direction: Direction| solvability[direction.index()],
        is_solvable: solvability.iter().all(|p| *p > 0.0),
        on_limit: arrival == Arrival::BackOnLimit(None),
    }
}

/// Weighs all candidates for the motion of a heavy hoop together.
#[inline(always)]
pub(crate) fn weigh<P: Fn(Direction) -> f64>(
    hoop: &Hoop,
    body: &Heavy,
    state: &State,
    evidence: &Evidence<P>,
) -> Next {
    let Evidence { contact, leaves, slip, ref solvability, is_solvable, on_limit } = *evidence;
    if is_solvable && contact != 0.0 {
        // Without Painlevé's paradox the candidates exclude each other: the plane presses on a hoop in contact where w > 0,
        // and while N > 0 in rolling, friction drives a slide only against its own direction.
        match slip {
            _ if leaves => return Next::Fly { body: *body, take_off: TakeOff::Unloaded },
            SlipEvidence::Moving(direction) => {
                return Next::Slide { body: *body, direction, slip_acceleration: None };
            }
            SlipEvidence::AtRest { hold: Hold::Holds, .. } => {
                return Next::Roll { on_limit };
            }
            SlipEvidence::AtRest {
                hold: Hold::Slips { direction, excess },
                rolling_forces: forces,
                denominator,
            } if forces.normal > 0.0 => {
                let drive = slip_drive(hoop, &forces, (direction, excess));
                let p = solvability(direction);
                let acceleration = slip_acceleration_at_rest(body.mass, denominator, drive, p);
                if acceleration > 0.0 {
                    let slip_acceleration = Some(direction.sign() * acceleration);
                    return Next::Slide { body: *body, direction, slip_acceleration };
                }
            }
            SlipEvidence::AtRest { .. } => {}
        }
    }
    weigh_all((hoop, body, state), (contact, leaves), (slip, on_limit), Direction::ALL.map(solvability))
}

/// −σF − μk N of a slip in the direction σ that begins with −σF − μs N = `excess`, where N > 0 never less than that. With a large
/// coefficient μs N is large where N is a small difference, and F has the digits; on the limit −σF = μs N.
pub(crate) fn slip_drive(hoop: &Hoop, forces: &ContactForces, (direction, excess): (Direction, f64)) -> f64 {
    let (mu_s, mu_k) = (hoop.mu_s(), hoop.mu_k());
    if mu_s <= 1.0 {
        return excess + (mu_s - mu_k) * forces.normal;
    }
    let against = -direction.sign() * forces.friction;
    let drive = against - mu_k * forces.normal;
    match (excess == 0.0, forces.normal > 0.0) {
        (true, _) => (mu_s - mu_k) / mu_s * against,
        (false, true) => drive.max(excess),
        (false, false) => drive,
    }
}

/// The same without a short cut.
fn weigh_all(
    (hoop, body, state): (&Hoop, &Heavy, &State),
    (contact, leaves): (f64, bool),
    (slip, on_limit): (SlipEvidence, bool),
    solvability: [f64; 2],
) -> Next {
    // N = Î m w/P > 0; with w = 0 the normal force grows from zero if the body does not leave the plane.
    let w = if contact == 0.0 && !leaves { 1.0 } else { contact };
    let pressed = |direction: Direction| {
        let p = solvability[direction.index()];
        (w > 0.0 && p > 0.0) || (w < 0.0 && p < 0.0)
    };

    // Of a slide that is consistent, η″ where η′ = 0.
    let mut sliding: [Option<Option<f64>>; 2] = [None; 2];
    let mut rolling = false;
    match slip {
        SlipEvidence::Moving(direction) => {
            sliding[direction.index()] = pressed(direction).then_some(None);
        }
        SlipEvidence::AtRest { hold, rolling_forces: forces, denominator } => {
            rolling = hold == Hold::Holds;
            let slip = match hold {
                Hold::Holds => None,
                Hold::Slips { direction, excess } => Some((direction, excess)),
                Hold::NoNormalForce => opposing(&forces, hoop.mu_s()),
            };
            for (against, direction, excess) in slip.into_iter().flat_map(|(against, excess)| {
                [against, against.reversed()].map(|direction| (against, direction, excess))
            }) {
                // −(σF + μk N): towards `against` it is |F| − μk N, from the excess over μs N that made the
                // decision, so that its sign cannot differ.
                let drive = if direction == against {
                    slip_drive(hoop, &forces, (direction, excess))
                } else {
                    // On the limit of a large coefficient F may be zero but for rounding, which then tells either side of the cone.
                    let rounds = excess == 0.0 && hoop.mu_s() > 1.0;
                    let along =
                        if rounds { direction.sign() * forces.friction } else { forces.friction.abs() };
                    -along - hoop.mu_k() * forces.normal
                };
                let p = solvability[direction.index()];
                if !pressed(direction) {
                    continue;
                }
                let acceleration = slip_acceleration_at_rest(body.mass, denominator, drive, p);
                // On the static limit with μs = μk it is 0, and η‴ has the sign of `against`.
                if acceleration > 0.0 || (drive == 0.0 && direction == against) {
                    sliding[direction.index()] = Some(Some(direction.sign() * acceleration));
                }
            }
        }
    }

    let slide = |direction, slip_acceleration| Next::Slide { body: *body, direction, slip_acceleration };
    match (rolling, sliding, leaves) {
        (true, [None, None], false) => Next::Roll { on_limit },
        (false, [Some(acceleration), None], false) => slide(Direction::Negative, acceleration),
        (false, [None, Some(acceleration)], false) => slide(Direction::Positive, acceleration),
        (false, [None, None], true) => {
            let take_off = if contact == 0.0 { TakeOff::Grazing } else { TakeOff::Unloaded };
            Next::Fly { body: *body, take_off }
        }
        (_, [negative, positive], _) => {
            let candidates = Candidates {
                rolling,
                sliding_negative: negative.is_some(),
                sliding_positive: positive.is_some(),
                flight: leaves,
                gliding: false,
                rolling_forces: RollingLaw::new(hoop).forces(state.theta, state.theta_rate),
                contact,
                solvability,
            };
            let candidates = Box::new(candidates);
            if candidates.count() == 0 { Next::None(candidates) } else { Next::Several(candidates) }
        }
    }
}

/// The direction against the friction force that rolling would need, and by how much it exceeds μs N.
fn opposing(forces: &ContactForces, mu_s: f64) -> Option<(Direction, f64)> {
    let direction = Direction::of_sign(forces.friction)?.reversed();
    Some((direction, forces.friction.abs() - mu_s * forces.normal))
}

fn massless(hoop: &Hoop, body: &Massless, state: &State, arrival: Arrival) -> Next {
    let (theta, theta_rate) = (state.theta, state.theta_rate);
    let sin = libm::sin(theta);
    let forces = RollingLaw::new(hoop).forces(theta, theta_rate);
    let at_rest = state.slip == 0.0;
    let may_roll = match arrival {
        Arrival::Open => at_rest,
        Arrival::GlideAtRest { presses } => presses,
        Arrival::RollingLimit(_) | Arrival::BackOnLimit(_) | Arrival::LiftOff => false,
    };
    if may_roll && RollingOrbit::new(hoop, theta, theta_rate).hold() == Hold::Holds {
        return Next::Roll { on_limit: false };
    }
    let contact = contact(1.0, body.offset, libm::cos(theta) * (theta_rate * theta_rate));
    // At the top the particle must have just the acceleration of free fall: ℓ̂ θ′² = 1.
    if sin != 0.0 || (contact == 0.0 && libm::cos(theta) > 0.0) {
        let entry = match arrival {
            Arrival::Open | Arrival::BackOnLimit(_) | Arrival::LiftOff if !at_rest => GlideEntry::Moving,
            Arrival::RollingLimit(RollingLimit::NormalForce) => GlideEntry::Unloaded,
            Arrival::RollingLimit(RollingLimit::Friction(_)) => GlideEntry::FromRest { presses: Some(true) },
            Arrival::GlideAtRest { presses } => GlideEntry::FromRest { presses: Some(presses) },
            Arrival::Open | Arrival::BackOnLimit(_) | Arrival::LiftOff => {
                GlideEntry::FromRest { presses: None }
            }
        };
        return Next::Glide { body: *body, entry };
    }
    Next::None(Box::new(Candidates {
        rolling: false,
        sliding_negative: false,
        sliding_positive: false,
        flight: false,
        gliding: false,
        rolling_forces: forces,
        contact,
        solvability: [0.0; 2],
    }))
}
