//! The end of rolling: the boundary of 𝓡 (2.14) on an orbit, as roots of forms in the half angle
//! (docs/theory/rolling.md).
//!
//! On an orbit with constant K they are of degree six in X = cos(θ/2), Y = sin(θ/2):
//!
//! ```text
//! N D² = (m + ℓ̂c) D² − ℓ̂ K (ℓ̂ s² + c D)
//! F D² = s ℓ̂ [(K − D) (D − m − ℓ̂c) − D (m + ℓ̂c)]
//! ```
//!
//! K − D = D θ′² is twice the energy over the top times X² and that over the bottom times Y². So F
//! keeps its digits where D is large. For a massless hoop the contact force points at the particle,
//! F/N = −ℓ̂ s/(1 + ℓ̂c), and the boundary splits into forms of lower degree.

use crate::math::bernstein::Bernstein;
use crate::math::form::{Form, HalfAngle};
use crate::math::series::product;
use crate::mechanics::RollingLaw;
use crate::model::{Body, Hoop, SlipDirection};

/// The limit at which rolling ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum RollingLimit {
    /// |F| = μs N: the body begins to slip in this direction, against the friction force.
    Friction(SlipDirection),
    /// N = 0 before |F| = μs N: only for a massless hoop, where N and F vanish together.
    NormalForce,
}

impl RollingLimit {
    /// The direction in which the body begins to slip; none at N = 0.
    pub const fn direction(self) -> Option<SlipDirection> {
        match self {
            Self::Friction(direction) => Some(direction),
            Self::NormalForce => None,
        }
    }
}

/// The end of rolling, at a limit of static friction or of the normal force.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RollingEnd {
    /// Time since the start of the phase.
    pub elapsed: f64,
    /// Angle.
    pub theta: f64,
    /// Rate.
    pub theta_rate: f64,
    /// The limit reached.
    pub limit: RollingLimit,
}

/// Whether static friction can sustain rolling at a state with η′ = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Stiction {
    /// Rolling holds for some time.
    Holds,
    /// |F| exceeds μs N by `excess` ≥ 0; zero on the boundary if the orbit leaves 𝓡.
    Slips {
        direction: SlipDirection,
        excess: f64,
    },
    /// N < 0, or N = 0 and decreasing.
    NoNormalForce,
}

impl Stiction {
    /// From the margins that become negative at once, by their values and in the frame of the
    /// motion.
    pub(super) fn of(negative: impl Iterator<Item = (f64, RollingLimit)>, heading: f64) -> Self {
        negative.fold(Self::Holds, |stiction, (margin, limit)| {
            match (stiction, in_body_frame(limit, heading)) {
                // Both margins are negative only where N < 0.
                (Self::Slips { .. } | Self::NoNormalForce, _) | (_, RollingLimit::NormalForce) => {
                    Self::NoNormalForce
                }
                (Self::Holds, RollingLimit::Friction(direction)) => Self::Slips {
                    direction,
                    excess: -margin,
                },
            }
        })
    }
}

/// Converts a limit from the frame of the motion, where ϑ increases, to the frame of the body.
pub(super) fn in_body_frame(limit: RollingLimit, heading: f64) -> RollingLimit {
    match limit {
        RollingLimit::Friction(direction) if heading < 0.0 => {
            RollingLimit::Friction(direction.reversed())
        }
        other => other,
    }
}

/// X² + Y² = 1. Forms in even powers have the coefficients of those powers alone: a0 X² + a1 Y².
const HALF_ANGLE_NORM: [f64; 2] = [1.0, 1.0];

/// N D² and F D²/(2ℓ̂) as forms in the half angle, the first in even powers and the second in odd
/// ones, from K − D in X² and Y², and K. `one` is the coefficient of what does not depend on them.
fn forces(law: &RollingLaw, one: f64, excess: [f64; 2], k: f64) -> ([f64; 4], [f64; 3]) {
    let l = law.offset;
    let d = [law.top, law.bottom];
    let carried = [law.mass + l, law.mass - l];
    let d2: [f64; 3] = product(&d, &d);
    let inertial: [f64; 4] = product(&d2, &carried);
    let c_d: [f64; 3] = product(&[l, -l], &d);
    let centripetal: [f64; 4] = product(&[c_d[0], c_d[1] + 4.0 * l * l, c_d[2]], &HALF_ANGLE_NORM);
    let driven: [f64; 3] = product(&excess, &law.inertia_excess);
    let held: [f64; 3] = product(&d, &carried);
    (
        core::array::from_fn(|i| one * inertial[i] - k * centripetal[i]),
        core::array::from_fn(|i| driven[i] - one * held[i]),
    )
}

/// The forms that are non-negative while the body rolls, in a frame where its angle increases.
#[derive(Clone, Copy, Debug)]
pub(super) enum Boundary {
    /// (μs N − F) D² and (μs N + F) D².
    Heavy([Form<7>; 2]),
    /// μs ± ℓ̂ s/(1 + ℓ̂c) and N, each over a positive factor.
    Massless([Form<3>; 2], Form<5>),
}

/// (μs N − F) D² and (μs N + F) D² from N D² and F D²/(2ℓ̂).
fn margins(mu: f64, l: f64, (normal, friction): ([f64; 4], [f64; 3])) -> [Form<7>; 2] {
    let form = |sign: f64| {
        let mut form = [0.0; 7];
        for i in 0..4 {
            form[2 * i] = mu * normal[i];
        }
        for i in 0..3 {
            form[2 * i + 1] = sign * (2.0 * l * friction[i]);
        }
        Form(form)
    };
    [form(-1.0), form(1.0)]
}

impl Boundary {
    /// On the orbit with K − D = `over_top` X² + `over_bottom` Y².
    pub(super) fn new(hoop: &Hoop, law: &RollingLaw, (over_top, over_bottom): (f64, f64)) -> Self {
        let (l, mu) = (law.offset, hoop.mu_s());
        let excess = [over_top, over_bottom];
        match hoop.body() {
            Body::Heavy(_) => Self::Heavy(margins(
                mu,
                l,
                forces(law, 1.0, excess, law.bottom + over_bottom),
            )),
            Body::Massless(_) => {
                let lever = [1.0 + l, 1.0 - l];
                let cone = |sign: f64| Form([mu * lever[0], sign * 2.0 * l, mu * lever[1]]);
                // N D/(1 + ℓ̂c) = (1 + ℓ̂c) D − ℓ̂(ℓ̂ + c)(K − D)
                let held: [f64; 3] = product(&lever, &[law.top, law.bottom]);
                let pulled: [f64; 3] = product(&[l * (1.0 + l), -l * (1.0 - l)], &excess);
                let normal: [f64; 3] = core::array::from_fn(|i| held[i] - pulled[i]);
                Self::Massless(
                    [cone(1.0), cone(-1.0)],
                    Form([normal[0], 0.0, normal[1], 0.0, normal[2]]),
                )
            }
        }
    }

    /// The margins on an arc, each with the limit that is reached when it becomes negative.
    pub(super) fn on_arc(
        &self,
        from: HalfAngle,
        to: HalfAngle,
    ) -> impl Iterator<Item = (Bernstein, RollingLimit)> + use<> {
        let negative = RollingLimit::Friction(SlipDirection::Negative);
        let positive = RollingLimit::Friction(SlipDirection::Positive);
        match self {
            Self::Heavy([minus, plus]) => [
                Some((minus.on_arc(from, to), negative)),
                Some((plus.on_arc(from, to), positive)),
                None,
            ],
            Self::Massless([minus, plus], normal) => [
                Some((normal.on_arc(from, to), RollingLimit::NormalForce)),
                Some((minus.on_arc(from, to), negative)),
                Some((plus.on_arc(from, to), positive)),
            ],
        }
        .into_iter()
        .flatten()
    }
}

/// What a slope adds to the margins: −T ℓ̂ s (m + ℓ̂c) D to N D², and T (m Î + ℓ̂² s²) D to F D².
fn pulled(law: &RollingLaw, heading: f64, mu: f64) -> [Form<7>; 2] {
    let RollingLaw {
        mass,
        offset: l,
        top,
        bottom,
        mass_inertia,
        tilt,
        ..
    } = *law;
    let (pull, d) = (heading * tilt, [top, bottom]);
    let normal: [f64; 3] = product(&[mass + l, mass - l], &d);
    let friction: [f64; 4] = product(
        &[mass_inertia, 2.0 * mass_inertia + 4.0 * l * l, mass_inertia],
        &d,
    );
    [-1.0, 1.0].map(|sign| {
        let mut form = [0.0; 7];
        for i in 0..4 {
            form[2 * i] = sign * (pull * friction[i]);
        }
        for i in 0..3 {
            form[2 * i + 1] = -2.0 * mu * l * (pull * normal[i]);
        }
        Form(form)
    })
}

/// The margins (μs N − F) D² and (μs N + F) D² = A + E B with E = K − D(π), on a level plane twice
/// the energy over the bottom: for each, A and B as forms of degree six in (cos θ/2, sin θ/2), in
/// the direction `heading` of motion; none for a massless hoop.
pub(crate) fn margin_forms(hoop: &Hoop, heading: f64) -> Option<[[Form<7>; 2]; 2]> {
    let Body::Heavy(_) = hoop.body() else {
        return None;
    };
    let law = RollingLaw::of(hoop);
    let part = |one, excess, k| margins(hoop.mu_s(), law.offset, forces(&law, one, excess, k));
    let [minus, plus] = part(1.0, [-4.0 * law.offset, 0.0], law.bottom);
    let [minus_driven, plus_driven] = part(0.0, [1.0, 1.0], 1.0);
    let [pulled_minus, pulled_plus] = pulled(&law, heading, hoop.mu_s());
    let with = |form: Form<7>, pulled: Form<7>| {
        if law.tilt == 0.0 {
            form
        } else {
            Form(core::array::from_fn(|i| form.0[i] + pulled.0[i]))
        }
    };
    Some([
        [with(minus, pulled_minus), minus_driven],
        [with(plus, pulled_plus), plus_driven],
    ])
}
