//! First integrals of slides without kinetic friction, and the zeros of η′ that they determine.

use crate::math::trig::{Angle, above_bottom};
use crate::mechanics::contact;
use crate::model::{Heavy, State};

/// Longest first step of Newton's method, rad: a longer one may lead to another zero.
const MAX_FIRST_STEP: f64 = 1e-3;

/// Largest ratio of successive steps. Near a double zero Newton's method has the ratio ½.
const MAX_STEP_RATIO: f64 = 0.75;

/// Longest last step of a converged iteration, rad. Rounding moves a double zero by about √ε =
/// 1.5e-8.
const MAX_LAST_STEP: f64 = 1e-7;

/// Maximum number of steps: 53 halvings reach the last digit.
const MAX_STEPS: usize = 53;

/// First integrals of a slide without friction. With c = cos ϑ, s = sin ϑ, u = ϑ′² and J = Î + m h²
/// s²,
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
    /// The integrals at a state, with the sine and cosine of its angle.
    pub(crate) fn new(body: &Heavy, state: &State, Angle { sin, cos }: Angle) -> Self {
        let rate = state.theta_rate;
        Self {
            energy: spin(body, sin) * rate * rate + 2.0 * body.offset * cos,
            momentum: state.slip - rate * (1.0 + body.h * cos),
        }
    }

    /// A² J − (C − 2 m h c) (1 + h c)², which vanishes with η′, in powers of c − `cos`. Each
    /// coefficient is given as its two terms.
    pub(crate) fn standstills(&self, body: &Heavy, cos: f64) -> [[f64; 2]; 4] {
        let (h, offset) = (body.h, body.offset);
        let (square, product) = (self.momentum * self.momentum, body.mass * h * h);
        let height = 1.0 + h * cos;
        let [kinetic, slope] = [self.energy - 2.0 * offset * cos, -2.0 * offset];
        [
            [
                square * (body.inertia + product * (1.0 - cos) * (1.0 + cos)),
                -kinetic * height * height,
            ],
            [
                -2.0 * square * product * cos,
                -(kinetic * 2.0 * h + slope * height) * height,
            ],
            [-square * product, -(kinetic * h + slope * 2.0 * height) * h],
            [0.0, -slope * h * h],
        ]
    }

    /// The distances of the other two zeros of the cubic from its zero at `cos`, by deflation; NaN
    /// where they are not real.
    pub(crate) fn other_standstills(&self, body: &Heavy, cos: f64) -> [f64; 2] {
        let [_, slope, square, cube] = self
            .standstills(body, cos)
            .map(|[first, second]| first + second);
        let root = (square * square - 4.0 * cube * slope).sqrt();
        let larger = -0.5 * (square + root.copysign(square));
        [larger / cube, slope / larger]
    }

    /// Whether deflation gives a zero at this distance more accurately than the cubic does. The
    /// error of deflation is that of the slope at `cos` times the distance; the error of the cubic
    /// is that of its value at the zero.
    pub(crate) fn deflation_is_better(&self, body: &Heavy, cos: f64, distance: f64) -> bool {
        let size = |[first, second]: [f64; 2]| first.abs() + second.abs();
        let [_, slope, ..] = self.standstills(body, cos);
        let [value, ..] = self.standstills(body, cos + distance);
        size(slope) * distance.abs() < size(value)
    }

    /// Angle near `theta`, and rate, at which η′ vanishes: Newton's method for C, with θ′ from A.
    /// `None` without convergence.
    pub(crate) fn standstill_near(&self, body: &Heavy, theta: f64) -> Option<(f64, f64)> {
        let Heavy { h, offset, .. } = *body;
        let theta = converge(theta, |theta| {
            let angle = Angle::of(theta);
            let Angle { sin, cos } = angle;
            let height = mass_centre_height(h, angle);
            let u = (self.momentum / height) * (self.momentum / height);
            let kinetic = spin(body, sin) * u;
            let slope = 2.0 * sin * (body.mass * h * h * cos * u + kinetic * h / height - offset);
            (kinetic + 2.0 * offset * cos - self.energy) / slope
        })?;
        Some((theta, self.rate_at_rest(body, Angle::of(theta))))
    }

    /// θ′ where η′ vanishes. Next to the bottom A, over a height that is small for a particle near
    /// the rim, magnifies the rounding of the angle; at a turning point C does so.
    pub(crate) fn rate_at_rest(&self, body: &Heavy, angle: Angle) -> f64 {
        let Angle { sin, cos } = angle;
        let height = mass_centre_height(body.h, angle);
        let from_momentum = -self.momentum / height;
        let potential = 2.0 * body.offset * cos;
        let kinetic = self.energy - potential;
        if (self.energy.abs() + potential.abs()) * height < 2.0 * kinetic * (body.h * sin).abs() {
            let rate = (kinetic / spin(body, sin)).sqrt();
            rate.copysign(from_momentum)
        } else {
            from_momentum
        }
    }
}

/// w at the top of a slide without kinetic friction, where it is least.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MarginAtTop {
    pub(crate) value: f64,
    /// The sum of the sizes of its terms besides 1.
    pub(crate) terms: f64,
    /// Its change with the angle, times the angle.
    by_angle: f64,
}

impl MarginAtTop {
    /// 1 − h u − (m h²/Î) (h s² u − 2 (1 − c)) with the u of the state, since C is conserved: on a
    /// slope, too, whose pull along the plane does not turn a hoop.
    pub(crate) fn new(body: &Heavy, state: &State, angle: Angle) -> Self {
        let Heavy {
            mass, h, inertia, ..
        } = *body;
        let Angle { sin, cos } = angle;
        let below_top = above_bottom(Angle { sin, cos: -cos });
        let u = state.theta_rate * state.theta_rate;
        let coupling = mass * h * h / inertia;
        let (outward, turning, fallen) = (
            h * u,
            coupling * h * sin * sin * u,
            2.0 * coupling * below_top,
        );
        let w = contact(1.0, h, cos * u);
        Self {
            value: 1.0 - outward - (turning - fallen),
            terms: outward + turning + fallen,
            by_angle: 2.0 * coupling * (sin * w * state.theta).abs(),
        }
    }

    /// Whether the hoop leaves the plane before the top. Where w vanishes there, but for rounding,
    /// it only touches zero, since w″ > 0; and after each turn w is the same number.
    ///
    /// A term has at most 34 roundings: 12 of m h²/Î, 2 of h, 5 of a squared sine, 9 of θ′², with
    /// the unit of time of a slope, 3 products and 3 sums. A state that has itself been computed has
    /// as many, from the energy. The angle is rounded, too.
    pub(crate) fn leaves_plane(&self) -> bool {
        self.value < -0.5 * f64::EPSILON * (68.0 * self.terms + self.by_angle)
    }
}

/// Newton's method for an angle near `theta`; `step` is subtracted. `None` without convergence.
pub(crate) fn converge(mut theta: f64, step: impl Fn(f64) -> f64) -> Option<f64> {
    let mut shortest = MAX_FIRST_STEP / MAX_STEP_RATIO;
    // Near a double zero each step is half the previous one, until rounding dominates.
    for _ in 0..MAX_STEPS {
        let step = step(theta);
        if step.is_nan() || step.abs() >= MAX_STEP_RATIO * shortest {
            break;
        }
        theta -= step;
        shortest = step.abs();
    }
    (shortest < MAX_LAST_STEP).then_some(theta)
}

/// J = Î + m h² s².
fn spin(body: &Heavy, sin: f64) -> f64 {
    let arm = body.h * sin;
    body.inertia + body.mass * arm * arm
}

/// 1 + h c without cancellation near the bottom, where it is small for a particle near the rim.
fn mass_centre_height(h: f64, angle: Angle) -> f64 {
    (1.0 - h) + h * above_bottom(angle)
}
