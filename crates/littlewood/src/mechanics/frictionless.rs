//! What slides without kinetic friction conserve, and where it lets η′ vanish.

use crate::math::trig::{above_bottom, sincos};
use crate::model::{Heavy, State};

/// A first step that is longer leads to another angle.
const LONGEST_STEP: f64 = 1e-3;

/// Newton's method goes on as long as each step is shorter than the one before by this factor.
const CONVERGES: f64 = 0.75;

/// It has converged with a step shorter than this: rounding leaves half the digits of two zeros next to each other.
const LAST_STEP: f64 = 1e-7;

/// So many halvings take an angle to its last digit.
const MOST_STEPS: usize = 53;

/// First integrals of a slide without friction. With c = cos ϑ, s = sin ϑ, u = ϑ′² and J = Î + m h² s²,
///
/// ```text
/// J u + 2 m h c = C,    η′ − ϑ′ (1 + h c) = A.
/// ```
pub(crate) struct FrictionlessIntegrals {
    /// C, twice the energy.
    pub(crate) energy: f64,
    /// A, the horizontal momentum.
    pub(crate) momentum: f64,
}

impl FrictionlessIntegrals {
    /// At a state, of whose angle sine and cosine are given.
    pub(crate) fn new(body: &Heavy, state: &State, (sin, cos): (f64, f64)) -> Self {
        let Heavy { mass, h, inertia, offset } = *body;
        let rate = state.theta_rate;
        Self {
            energy: (inertia + mass * (h * sin) * (h * sin)) * rate * rate + 2.0 * offset * cos,
            momentum: state.slip - rate * (1.0 + h * cos),
        }
    }

    /// A² J − (C − 2 m h c) (1 + h c)², which vanishes with η′, in powers of the distance of c from a cosine, each coefficient as the sum of its two
    /// terms.
    pub(crate) fn standstills(&self, body: &Heavy, cos: f64) -> [[f64; 2]; 4] {
        let Heavy { mass, h, inertia, offset } = *body;
        let (square, product) = (self.momentum * self.momentum, mass * h * h);
        let lever = 1.0 + h * cos;
        let [kinetic, slope] = [self.energy - 2.0 * offset * cos, -2.0 * offset];
        [
            [square * (inertia + product * (1.0 - cos) * (1.0 + cos)), -kinetic * lever * lever],
            [-2.0 * square * product * cos, -(kinetic * 2.0 * h + slope * lever) * lever],
            [-square * product, -(kinetic * h + slope * 2.0 * lever) * h],
            [0.0, -slope * h * h],
        ]
    }

    /// The distances of the other two from a cosine at which η′ vanishes, with that zero divided out; not a number where they are not real.
    pub(crate) fn other_standstills(&self, body: &Heavy, cos: f64) -> [f64; 2] {
        let [_, slope, square, cube] = self.standstills(body, cos).map(|[first, second]| first + second);
        let root = (square * square - 4.0 * cube * slope).sqrt();
        let larger = -0.5 * (square + root.copysign(square));
        [larger / cube, slope / larger]
    }

    /// Whether one of them, at this distance, has more digits so than as a zero of the cubic: there rounding of the slope at the first zero tells, times the distance, and
    /// that of the value where it is in the other case.
    pub(crate) fn is_known_from(&self, body: &Heavy, cos: f64, distance: f64) -> bool {
        let size = |[first, second]: [f64; 2]| first.abs() + second.abs();
        let [_, slope, ..] = self.standstills(body, cos);
        let [value, ..] = self.standstills(body, cos + distance);
        size(slope) * distance.abs() < size(value)
    }

    /// The angle next to one, and the rate, at which η′ vanishes: Newton's method for C, with θ′ from A. None where it does not converge.
    pub(crate) fn standstill_near(&self, body: &Heavy, theta: f64) -> Option<(f64, f64)> {
        let Heavy { mass, h, inertia, offset } = *body;
        let theta = converge(theta, |theta| {
            let (sin, cos) = sincos(theta);
            let lever = lever(h, (sin, cos));
            let u = (self.momentum / lever) * (self.momentum / lever);
            let kinetic = (inertia + mass * (h * sin) * (h * sin)) * u;
            let slope = 2.0 * sin * (mass * h * h * cos * u + kinetic * h / lever - offset);
            (kinetic + 2.0 * offset * cos - self.energy) / slope
        })?;
        Some((theta, self.rate_at_rest(body, sincos(theta))))
    }

    /// θ′ where η′ vanishes.
    pub(crate) fn rate_at_rest(&self, body: &Heavy, direction: (f64, f64)) -> f64 {
        -self.momentum / lever(body.h, direction)
    }
}

/// Newton's method for an angle next to one, with a step that is subtracted. None where it does not converge.
pub(crate) fn converge(mut theta: f64, step: impl Fn(f64) -> f64) -> Option<f64> {
    let mut shortest = LONGEST_STEP / CONVERGES;
    // Two zeros next to each other halve each step; rounding ends that.
    for _ in 0..MOST_STEPS {
        let step = step(theta);
        if step.is_nan() || step.abs() >= CONVERGES * shortest {
            break;
        }
        theta -= step;
        shortest = step.abs();
    }
    (shortest < LAST_STEP).then_some(theta)
}

/// 1 + h c with all digits near the bottom, where it is small for a particle near the rim.
fn lever(h: f64, direction: (f64, f64)) -> f64 {
    (1.0 - h) + h * above_bottom(direction)
}
