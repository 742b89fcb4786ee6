//! The motion that follows a state: all candidates that are consistent with the accelerations
//! (docs/theory/contact.md).
//!
//! At η′ = 0 rolling, sliding in either direction and flight compete. Static friction is read as:
//! where rolling and a slide both are consistent, the contact sticks. So a slide from η′ = 0 is a
//! candidate only if rolling is not. The motion continues if there is exactly one candidate; none
//! or several (Painlevé: P ≤ 0) is an outcome.

use crate::mechanics::{
    ContactForces, RollingLaw, Settling, SlidingLaw, contact, leaves_plane,
    slip_acceleration_at_rest,
};
use crate::model::{Body, Detail, Dimension, Direction, Heavy, Hoop, Massless, Mode, State};
use crate::modes::{Entry, GlideEntry, Hold, RollingLimit, RollingOrbit, TakeOff};

/// The candidate motions at a state, and the quantities that decide between them.
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
    /// 1 − h cos θ θ′²; negative if the body would leave the plane.
    pub contact: f64,
    /// P = Î + m h sin θ q for σ = −1 and σ = +1; sliding is not well posed for P ≤ 0 (Painlevé).
    pub solvability: [f64; 2],
}

impl Candidates {
    const fn none(rolling_forces: ContactForces, contact: f64, solvability: [f64; 2]) -> Self {
        Self {
            rolling: false,
            sliding_negative: false,
            sliding_positive: false,
            flight: false,
            gliding: false,
            rolling_forces,
            contact,
            solvability,
        }
    }

    /// Number of consistent motions.
    pub fn count(&self) -> usize {
        self.consistent().count()
    }

    /// The deciding quantities with their names in records.
    pub const fn details(&self) -> [(&'static str, Detail); 5] {
        let [negative, positive] = self.solvability;
        [
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
        ]
    }

    /// The consistent motions, with their direction of slip.
    pub fn consistent(&self) -> impl Iterator<Item = (Mode, Option<Direction>)> {
        [
            (self.rolling, (Mode::Rolling, None)),
            (
                self.sliding_negative,
                (Mode::Sliding, Some(Direction::Negative)),
            ),
            (
                self.sliding_positive,
                (Mode::Sliding, Some(Direction::Positive)),
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
pub(crate) enum Next {
    Roll {
        on_limit: bool,
    },
    Slide {
        body: Heavy,
        direction: Direction,
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
    None(Box<Candidates>),
    Several(Box<Candidates>),
}

impl Next {
    pub(crate) const fn mode(&self) -> Option<Mode> {
        match self {
            Self::Roll { .. } => Some(Mode::Rolling),
            Self::Slide { .. } => Some(Mode::Sliding),
            Self::Glide { .. } => Some(Mode::Gliding),
            Self::Fly { .. } | Self::Settle { .. } => Some(Mode::Flight),
            Self::None(_) | Self::Several(_) => None,
        }
    }

    /// The direction of slip, if it is known before the phase is solved.
    pub(crate) const fn direction(&self) -> Option<Direction> {
        if let Self::Slide { direction, .. } = self {
            Some(*direction)
        } else {
            None
        }
    }
}

/// How the state was reached; resolves ties on a boundary.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Arrival {
    /// On no known boundary: a start, or the end of a slide.
    Open,
    /// The slip of a glide vanishes. `presses` if the normal force of rolling is positive.
    GlideAtRest { presses: bool },
    /// Rolling reaches this limit.
    RollingLimit(RollingLimit),
    /// A slide without kinetic friction returns to the limit of static friction. The slip continues
    /// in this direction, or none if static friction holds.
    BackOnLimit(Option<Direction>),
    /// The normal force of a slide vanishes, with w decreasing: only flight follows.
    LiftOff,
}

/// Decides which motion begins at `state`, from the exact conditions.
pub(crate) fn next_motion(hoop: &Hoop, state: &State, arrival: Arrival) -> Next {
    match hoop.body() {
        Body::Heavy(body) => match arrival {
            Arrival::LiftOff => Next::Fly {
                body,
                take_off: TakeOff::Grazing,
            },
            Arrival::Open
            | Arrival::GlideAtRest { .. }
            | Arrival::RollingLimit(_)
            | Arrival::BackOnLimit(_) => weigh(
                hoop,
                &body,
                state,
                &exact_evidence(hoop, &body, state, arrival),
            ),
        },
        Body::Massless(body) => massless(hoop, &body, state, arrival),
    }
}

/// The quantities that decide for a heavy hoop.
pub(crate) struct Evidence<P> {
    /// w = 1 − h cos θ θ′².
    pub(crate) contact: f64,
    pub(crate) leaves: bool,
    pub(crate) slip: SlipEvidence,
    /// P in a direction of slip.
    pub(crate) solvability: P,
    /// Whether P > 0 in both directions.
    pub(crate) is_solvable: bool,
    /// Whether rolling would begin with |F| = μs N.
    pub(crate) on_limit: bool,
}

#[derive(Clone, Copy, Debug)]
pub(crate) enum SlipEvidence {
    /// η′ ≠ 0.
    Moving(Direction),
    /// η′ = 0, with N, F and D of rolling.
    AtRest {
        hold: Hold,
        rolling_forces: ContactForces,
        denominator: f64,
    },
}

/// Evaluates the evidence at a state. Rolling is decided by the same margins from which its end is
/// computed.
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
            let rolling = RollingLaw::of(hoop);
            SlipEvidence::AtRest {
                hold: match arrival {
                    Arrival::RollingLimit(RollingLimit::Friction(direction)) => Hold::Slips {
                        direction,
                        excess: 0.0,
                    },
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
                        RollingOrbit::of(hoop, theta, theta_rate).hold()
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

/// Decides between all candidates for a heavy hoop.
#[inline(always)]
pub(crate) fn weigh<P: Fn(Direction) -> f64>(
    hoop: &Hoop,
    body: &Heavy,
    state: &State,
    evidence: &Evidence<P>,
) -> Next {
    let Evidence {
        contact,
        leaves,
        slip,
        ref solvability,
        is_solvable,
        on_limit,
    } = *evidence;
    if is_solvable && contact != 0.0 {
        // For P > 0 the candidates exclude each other: contact requires w > 0, and with N > 0 in
        // rolling a slide begins only against the friction force.
        match slip {
            _ if leaves => {
                return Next::Fly {
                    body: *body,
                    take_off: TakeOff::Unloaded,
                };
            }
            SlipEvidence::Moving(direction) => {
                return Next::Slide {
                    body: *body,
                    direction,
                    entry: Entry::Moving,
                };
            }
            SlipEvidence::AtRest {
                hold: Hold::Holds, ..
            } => {
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
                    let entry = Entry::FromRest {
                        slip_acceleration: direction.sign() * acceleration,
                    };
                    return Next::Slide {
                        body: *body,
                        direction,
                        entry,
                    };
                }
            }
            SlipEvidence::AtRest { .. } => {}
        }
    }
    weigh_all(
        (hoop, body, state),
        (contact, leaves),
        (slip, on_limit),
        Direction::ALL.map(solvability),
    )
}

/// −σF − μk N of a slip in the direction σ that begins with −σF − μs N = `excess`; at least
/// `excess` for N > 0. With a large μs the term μs N amplifies the cancellation in N, so F is used
/// instead; on the limit −σF = μs N.
pub(crate) fn slip_drive(
    hoop: &Hoop,
    forces: &ContactForces,
    (direction, excess): (Direction, f64),
) -> f64 {
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

/// The general case of [`weigh`], which includes P ≤ 0 and w = 0.
fn weigh_all(
    (hoop, body, state): (&Hoop, &Heavy, &State),
    (contact, leaves): (f64, bool),
    (slip, on_limit): (SlipEvidence, bool),
    solvability: [f64; 2],
) -> Next {
    // N = Î m w/P > 0; for w = 0 the normal force increases from zero unless the body leaves the
    // plane.
    let w = if contact == 0.0 && !leaves {
        1.0
    } else {
        contact
    };
    let pressed = |direction: Direction| {
        let p = solvability[direction.index()];
        (w > 0.0 && p > 0.0) || (w < 0.0 && p < 0.0)
    };

    // The consistent slides.
    let mut sliding: [Option<Entry>; 2] = [None; 2];
    let mut rolling = false;
    match slip {
        SlipEvidence::Moving(direction) => {
            sliding[direction.index()] = pressed(direction).then_some(Entry::Moving);
        }
        SlipEvidence::AtRest {
            hold,
            rolling_forces: forces,
            denominator,
        } => {
            rolling = hold == Hold::Holds;
            let slip = match hold {
                Hold::Holds => None,
                Hold::Slips { direction, excess } => Some((direction, excess)),
                Hold::NoNormalForce => opposing(&forces, hoop.mu_s()),
            };
            for (against, direction, excess) in slip.into_iter().flat_map(|(against, excess)| {
                [against, against.reversed()].map(|direction| (against, direction, excess))
            }) {
                // −(σF + μk N). Towards `against` it equals |F| − μk N and follows from the excess
                // over μs N that decided against rolling, so the signs agree.
                let drive = if direction == against {
                    slip_drive(hoop, &forces, (direction, excess))
                } else {
                    // On the limit with a large μs, F may vanish to rounding, and its sign need not
                    // agree with `against`.
                    let rounds = excess == 0.0 && hoop.mu_s() > 1.0;
                    let along = if rounds {
                        direction.sign() * forces.friction
                    } else {
                        forces.friction.abs()
                    };
                    -along - hoop.mu_k() * forces.normal
                };
                let p = solvability[direction.index()];
                if !pressed(direction) {
                    continue;
                }
                let acceleration = slip_acceleration_at_rest(body.mass, denominator, drive, p);
                // On the static limit with μs = μk it vanishes, and η‴ has the sign of `against`.
                if acceleration > 0.0 || (drive == 0.0 && direction == against) {
                    let entry = Entry::FromRest {
                        slip_acceleration: direction.sign() * acceleration,
                    };
                    sliding[direction.index()] = Some(entry);
                }
            }
        }
    }

    let slide = |direction, entry| Next::Slide {
        body: *body,
        direction,
        entry,
    };
    match (rolling, sliding, leaves) {
        (true, [None, None], false) => Next::Roll { on_limit },
        (false, [Some(entry), None], false) => slide(Direction::Negative, entry),
        (false, [None, Some(entry)], false) => slide(Direction::Positive, entry),
        (false, [None, None], true) => {
            let take_off = if contact == 0.0 {
                TakeOff::Grazing
            } else {
                TakeOff::Unloaded
            };
            Next::Fly {
                body: *body,
                take_off,
            }
        }
        (_, [negative, positive], _) => {
            let forces = RollingLaw::of(hoop).forces(state.theta, state.theta_rate);
            let candidates = Box::new(Candidates {
                rolling,
                sliding_negative: negative.is_some(),
                sliding_positive: positive.is_some(),
                flight: leaves,
                ..Candidates::none(forces, contact, solvability)
            });
            if candidates.count() == 0 {
                Next::None(candidates)
            } else {
                Next::Several(candidates)
            }
        }
    }
}

/// The direction against the friction force of rolling, and |F| − μs N.
fn opposing(forces: &ContactForces, mu_s: f64) -> Option<(Direction, f64)> {
    let direction = Direction::of_sign(forces.friction)?.reversed();
    Some((direction, forces.friction.abs() - mu_s * forces.normal))
}

fn massless(hoop: &Hoop, body: &Massless, state: &State, arrival: Arrival) -> Next {
    let (theta, theta_rate) = (state.theta, state.theta_rate);
    let sin = libm::sin(theta);
    let forces = RollingLaw::of(hoop).forces(theta, theta_rate);
    let at_rest = state.slip == 0.0;
    let may_roll = match arrival {
        Arrival::Open => at_rest,
        Arrival::GlideAtRest { presses } => presses,
        Arrival::RollingLimit(_) | Arrival::BackOnLimit(_) | Arrival::LiftOff => false,
    };
    if may_roll && RollingOrbit::of(hoop, theta, theta_rate).hold() == Hold::Holds {
        return Next::Roll { on_limit: false };
    }
    let contact = contact(
        1.0,
        body.offset,
        libm::cos(theta) * (theta_rate * theta_rate),
    );
    // At the top a glide requires the acceleration of free fall: ℓ̂ θ′² = 1.
    if sin != 0.0 || (contact == 0.0 && libm::cos(theta) > 0.0) {
        let entry = match arrival {
            Arrival::Open | Arrival::BackOnLimit(_) | Arrival::LiftOff if !at_rest => {
                GlideEntry::Moving
            }
            Arrival::RollingLimit(RollingLimit::NormalForce) => GlideEntry::Unloaded,
            Arrival::RollingLimit(RollingLimit::Friction(_)) => GlideEntry::FromRest {
                presses: Some(true),
            },
            Arrival::GlideAtRest { presses } => GlideEntry::FromRest {
                presses: Some(presses),
            },
            Arrival::Open | Arrival::BackOnLimit(_) | Arrival::LiftOff => {
                GlideEntry::FromRest { presses: None }
            }
        };
        return Next::Glide { body: *body, entry };
    }
    Next::None(Box::new(Candidates::none(forces, contact, [0.0; 2])))
}
