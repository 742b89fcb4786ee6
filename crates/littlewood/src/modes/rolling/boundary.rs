//! Where rolling gives way: the boundary of 𝓡 (2.14) on an orbit, as roots of forms in the half angle.
//!
//! On an orbit with constant K, N D² and F D² are trigonometric polynomials of degree three in θ (rolling is
//! algebraic), that is, forms of degree six in X = cos(θ/2), Y = sin(θ/2), with 1 = X² + Y²,
//! cos θ = X² − Y², sin θ = 2XY:
//!
//! ```text
//! N D² = (m + ℓ̂c) D² − ℓ̂² K s² − ℓ̂ c K D
//! F D² = s [ℓ̂ K (D − m − ℓ̂c) − ℓ̂ D²]
//! ```
//!
//! [`crate::math::form`] restricts them to an arc, where the first crossing is isolated. For a massless hoop the resultant of N and F points at the particle,
//! F/N = −ℓ̂ s/(1 + ℓ̂c), and the boundary splits into forms of lower degree.

use crate::math::bernstein::Bernstein;
use crate::math::form::{Form, HalfAngle};
use crate::mechanics::RollingLaw;
use crate::model::{Body, Direction, Heavy, Hoop};

/// What gives way where rolling ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum RollingLimit {
    /// |F| = μs N: the body begins to slip in this direction (opposite to the friction force).
    Friction(Direction),
    /// N = 0 before static friction gives way: only a massless hoop, where N and F vanish together.
    NormalForce,
}

impl RollingLimit {
    /// The direction in which the body begins to slip; none where the normal force gives way.
    #[must_use]
    pub const fn direction(self) -> Option<Direction> {
        match self {
            Self::Friction(direction) => Some(direction),
            Self::NormalForce => None,
        }
    }
}

/// The end of rolling: where and when static friction or the normal force gives way.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RollingEnd {
    /// Time since the orbit was entered.
    pub elapsed: f64,
    /// Angle.
    pub theta: f64,
    /// Rate.
    pub theta_rate: f64,
    /// What gives way.
    pub limit: RollingLimit,
}

/// Whether static friction can sustain rolling at a state with η′ = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Hold {
    /// Rolling holds, now and for some time.
    Holds,
    /// The friction demand exceeds μs N by `excess` ≥ 0; zero on the boundary, when the orbit leaves 𝓡.
    Slips { direction: Direction, excess: f64 },
    /// N would have to be negative, or vanishes and would become so.
    NoNormalForce,
}

/// A limit seen in the frame of the body instead of the direction of motion.
pub(super) fn turned(limit: RollingLimit, travel: f64) -> RollingLimit {
    match limit {
        RollingLimit::Friction(direction) if travel < 0.0 => RollingLimit::Friction(direction.reversed()),
        other => other,
    }
}

/// Product of quadratic forms that have only even powers, a0 X² + a1 Y².
fn even_product<const P: usize, const Q: usize, const R: usize>(p: [f64; P], q: [f64; Q]) -> [f64; R] {
    let mut product = [0.0; R];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            product[i + j] += a * b;
        }
    }
    product
}

/// X² + Y² = 1.
const ONE: [f64; 2] = [1.0, 1.0];

/// N D² and F D², each as its part without K and the factor of K, in forms of the half angle: N D² in its even powers, F D² in its odd ones.
#[derive(Clone, Copy, Debug)]
struct Forces {
    normal: [[f64; 4]; 2],
    friction: [[f64; 3]; 2],
}

impl Forces {
    fn new(body: &Heavy, law: &RollingLaw) -> Self {
        let l = law.offset;
        let d = [law.top, law.bottom];
        let carried = [law.mass + l, law.mass - l];
        // D − m − ℓ̂ c = Î + m h² + ℓ̂ c
        let about_centre = body.inertia + l * body.h;
        let rest = [about_centre + l, about_centre - l];
        let d2: [f64; 3] = even_product(d, d);
        let c_d: [f64; 3] = even_product([l, -l], d);
        let centripetal: [f64; 3] = [c_d[0], c_d[1] + 4.0 * l * l, c_d[2]];
        let driven: [f64; 4] = even_product(centripetal, ONE);
        Self {
            normal: [even_product(d2, carried), driven.map(|x| -x)],
            friction: [d2.map(|x| -x), even_product(rest, ONE)],
        }
    }
}

/// The forms that must stay non-negative while the body rolls, in a frame where it moves towards larger angles.
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
    /// On the orbit with constant K.
    pub(super) fn new(hoop: &Hoop, law: &RollingLaw, k: f64) -> Self {
        let (l, mu) = (law.offset, hoop.mu_s());
        match hoop.body() {
            Body::Heavy(body) => {
                let Forces { normal: [inertial, driven], friction: [held, turned] } = Forces::new(&body, law);
                let normal = core::array::from_fn(|i| inertial[i] + k * driven[i]);
                let friction = core::array::from_fn(|i| k * turned[i] + held[i]);
                Self::Heavy(margins(mu, l, (normal, friction)))
            }
            Body::Massless(_) => {
                let d = [law.top, law.bottom];
                let lever = [1.0 + l, 1.0 - l];
                let cone = |sign: f64| Form([mu * lever[0], sign * 2.0 * l, mu * lever[1]]);
                // N D/(1 + ℓ̂c) = (1 + ℓ̂c) D − ℓ̂(ℓ̂ + c)(K − D)
                let pull = [l * (1.0 + l), -l * (1.0 - l)];
                let held: [f64; 3] = even_product([lever[0] + pull[0], lever[1] + pull[1]], d);
                let pulled: [f64; 3] = even_product(pull, ONE);
                let normal: [f64; 3] = core::array::from_fn(|i| held[i] - k * pulled[i]);
                Self::Massless([cone(1.0), cone(-1.0)], Form([normal[0], 0.0, normal[1], 0.0, normal[2]]))
            }
        }
    }

    /// The margins on an arc, each with what gives way when it becomes negative.
    pub(super) fn on_arc(
        &self,
        from: HalfAngle,
        to: HalfAngle,
    ) -> impl Iterator<Item = (Bernstein, RollingLimit)> + use<> {
        let negative = RollingLimit::Friction(Direction::Negative);
        let positive = RollingLimit::Friction(Direction::Positive);
        match self {
            Self::Heavy([minus, plus]) => {
                [Some((minus.on_arc(from, to), negative)), Some((plus.on_arc(from, to), positive)), None]
            }
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

/// The margins (μs N − F) D² and (μs N + F) D² as forms of degree six in (cos θ/2, sin θ/2): for each its parts A and B, of which it
/// is A + K B on the orbit with constant K; none for a massless hoop.
pub(crate) fn margin_forms(hoop: &Hoop) -> Option<[[Form<7>; 2]; 2]> {
    let Body::Heavy(body) = hoop.body() else { return None };
    let law = RollingLaw::new(hoop);
    let Forces { normal, friction } = Forces::new(&body, &law);
    // Each by itself: as a difference of two orbits the part B would lose its digits where D is large.
    let part = |i: usize| margins(hoop.mu_s(), law.offset, (normal[i], friction[i]));
    let ([minus, plus], [minus_driven, plus_driven]) = (part(0), part(1));
    Some([[minus, minus_driven], [plus, plus_driven]])
}
