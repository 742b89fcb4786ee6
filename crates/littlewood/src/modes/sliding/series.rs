//! Taylor series of a sliding motion about an instant.
//!
//! Automatic differentiation by recurrence: every product is a convolution of coefficients. The
//! series are those of θ, θ′, η′ and of the two quantities whose signs limit sliding, w and P. They
//! solve the equations of [`SlidingLaw`].

use crate::math::number::Number;
use crate::math::series::{DEGREE, Series, convolve_pairs, value};
use crate::mechanics::{SlidingLaw, contact};
use crate::model::Heavy;

/// Largest truncation error of a step, relative to θ′ and θ″: below the rounding.
pub(crate) const TRUNCATION_TOLERANCE: f64 = f64::EPSILON / 4.0;

/// Maximum of the first steps: the series of a body at rest has no time scale.
pub(super) const INITIAL_MAX_STEP: f64 = 16.0;

/// Least degree of series whose further coefficients overflow.
const MIN_DEGREE: usize = 8;

/// A point of the (θ, θ′) plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PhasePoint<T = f64> {
    pub(crate) theta: T,
    pub(crate) rate: T,
}

#[derive(Clone, Copy, Debug)]
pub(crate) struct SlideSeries<T = f64> {
    pub(crate) theta: Series<T>,
    pub(crate) theta_rate: Series<T>,
    pub(crate) slip: Series<T>,
    /// w = 1 − h cos θ θ′², proportional to the normal force: N = Î m w/P.
    pub(crate) contact: Series<T>,
    /// P = Î + m h s q: sliding has a unique solution while P > 0 (Painlevé).
    pub(crate) painleve: Series<T>,
}

impl<T: Number> SlideSeries<T> {
    /// Series about (θ, θ′, η′).
    pub(crate) fn new(law: &SlidingLaw<T>, place: PhasePoint<T>, slip: T) -> Self {
        Self::to_order(law, place, slip, DEGREE)
    }

    /// Their coefficients up to an order; the others are zero.
    pub(crate) fn to_order(
        law: &SlidingLaw<T>,
        PhasePoint { theta, rate }: PhasePoint<T>,
        slip: T,
        highest: usize,
    ) -> Self {
        let Heavy {
            mass: m,
            h,
            inertia,
            ..
        } = law.body;
        let friction = law.friction;
        let zero = [T::constant(0.0); DEGREE + 1];
        let mut s = Self {
            theta: zero,
            theta_rate: zero,
            slip: zero,
            contact: zero,
            painleve: zero,
        };
        s.theta[0] = theta;
        s.theta_rate[0] = rate;
        if h.value() == 0.0 {
            // The accelerations are constant; powers of those of a hoop of tiny inertia overflow.
            let acceleration = m * (-friction - law.resistance) / inertia;
            (s.theta[1], s.theta[2]) = (rate, acceleration * 0.5);
            s.theta_rate[1] = acceleration;
            (s.contact[0], s.painleve[0]) = (T::constant(1.0), inertia);
            (s.slip[0], s.slip[1]) = (slip, acceleration - law.mean_slip_loss());
            return s;
        }
        let pairs = [[T::constant(0.0); 2]; DEGREE + 1];
        // Factors of products: j θ_j, the coefficients of dθ in sin θ = ∫ cos θ dθ and cos θ = −∫ sin
        // θ dθ, and θ′, twice each; cos θ and sin θ; q.
        let (mut increments, mut rates, mut angles, mut q) = (pairs, pairs, pairs, zero);
        // From the last to the first, as far as they are known: cos θ and sin θ; θ′ and its
        // coefficient in the first integral; u = θ′² and q; w; θ″.
        let (mut angles_back, mut factors_back, mut drives_back) = (pairs, pairs, pairs);
        let (mut contact_back, mut acceleration_back) = (zero, zero);
        let angle = theta.angle();
        angles[0] = [angle.cos, angle.sin];
        let mut order = 0.0;
        for n in 0..=highest.min(DEGREE) {
            let last = DEGREE - n;
            if n > 0 {
                s.theta_rate[n] = acceleration_back[last + 1] / order;
                s.theta[n] = s.theta_rate[n - 1] / order;
                increments[n] = [s.theta[n] * order; 2];
                let [forth, back] = convolve_pairs(&increments[..=n], &angles_back[last..]);
                angles[n] = [-(back / order), forth / order];
            }
            let [cos, sin] = angles[n];
            angles_back[last] = angles[n];
            rates[n] = [s.theta_rate[n]; 2];
            let constant = if n == 0 { 1.0 } else { 0.0 };
            let slip_coefficient = h * cos + constant + friction * h * sin;
            factors_back[last] = [s.theta_rate[n], slip_coefficient];
            let [square, coefficient_rate] = convolve_pairs(&rates[..=n], &factors_back[last..]);
            q[n] = law.q(constant, sin, cos);
            drives_back[last] = [square, q[n]];
            let [cos_u, sin_q] = convolve_pairs(&angles[..=n], &drives_back[last..]);
            s.contact[n] = contact(constant, h, cos_u);
            contact_back[last] = s.contact[n];
            s.painleve[n] = inertia * constant + m * h * sin_q;
            s.slip[n] = coefficient_rate;
            let mut driven = T::constant(0.0);
            for (q, contact) in q[..=n].iter().zip(&contact_back[last..]) {
                driven = driven + *q * *contact;
            }
            let mut remainder = m * driven;
            let before = &acceleration_back[last + 1..];
            for (p, acceleration) in s.painleve[1..=n].iter().zip(before) {
                remainder = remainder - *p * *acceleration;
            }
            acceleration_back[last] = remainder / s.painleve[0];
            order += 1.0;
        }
        // First integral of sliding: η′ = const − (μk σ + tan α) τ + θ′ (1 + h cos θ + μk σ h sin
        // θ).
        s.slip[0] = slip;
        s.slip[1] = s.slip[1] - law.mean_slip_loss();
        s
    }

    /// Angle and rate after a time.
    #[inline]
    pub(crate) fn point(&self, at: f64) -> PhasePoint<T> {
        PhasePoint {
            theta: value(&self.theta, at),
            rate: value(&self.theta_rate, at),
        }
    }
}

impl SlideSeries {
    /// Step of a balanced hoop, ℓ = 0. Its accelerations are constant and the series finite, so one
    /// step covers the slide up to η′ = 0, or one turn without friction.
    pub(super) fn straight_step(&self) -> f64 {
        let time = |speed: f64, over: f64| {
            if speed == 0.0 {
                0.0
            } else {
                over / speed.abs()
            }
        };
        let rest = time(self.slip[1], self.slip[0].abs());
        let turn = if self.slip[1] == 0.0 {
            time(self.theta_rate[0], core::f64::consts::TAU)
        } else {
            0.0
        };
        INITIAL_MAX_STEP.max(1.5 * rest.max(turn))
    }

    /// Time until η′ vanishes at a constant rate, or θ′ before if it ends the slide: against rolling
    /// resistance it slows down.
    pub(super) fn time_to_zero(&self, resistance: f64) -> f64 {
        let to_zero = |velocity: &Series| (velocity[0] / velocity[1]).abs();
        let time_left = to_zero(&self.slip);
        if resistance * self.theta_rate[1] < 0.0 {
            time_left.min(to_zero(&self.theta_rate))
        } else {
            time_left
        }
    }

    /// Step on which the series converge to rounding; at most `max_radius`. Coefficients that overflow
    /// are dropped, but next to P = 0, where the end is known in closed form.
    pub(super) fn convergence_radius(&mut self, law: &SlidingLaw, max_radius: f64) -> f64 {
        let degree = finite_degree(self.deciding());
        if degree < DEGREE {
            if self.is_near_singularity(law) {
                return 0.0;
            }
            let Self {
                theta,
                theta_rate,
                slip,
                contact,
                painleve,
            } = self;
            for series in [theta, theta_rate, slip, contact, painleve] {
                series[degree + 1..].fill(0.0);
            }
        }
        convergence_radius(&self.theta_rate, self.deciding(), degree, max_radius)
    }

    const fn deciding(&self) -> [&Series; 4] {
        [&self.theta_rate, &self.slip, &self.contact, &self.painleve]
    }

    /// P ≥ Î except where it tends to zero.
    pub(super) fn is_near_singularity(&self, law: &SlidingLaw) -> bool {
        self.painleve[0] < 0.5 * law.body.inertia
    }
}

/// The degree up to which the coefficients of all series are finite: they grow like radius^−n, and
/// overflow where the radius is below some 1e-13.
pub(in crate::modes) fn finite_degree<const N: usize>(all: [&Series; N]) -> usize {
    let is_finite = |order: &usize| all.iter().all(|series| series[*order].is_finite());
    if is_finite(&DEGREE) {
        return DEGREE;
    }
    (0..DEGREE).take_while(is_finite).count().saturating_sub(1)
}

/// Step on which series of a degree converge to rounding, that of θ′ among them, from their last two
/// coefficients (À. Jorba and M. Zou, Experimental Mathematics 14, 2005); at most `max_radius`.
pub(in crate::modes) fn convergence_radius(
    theta_rate: &Series,
    all: [&Series; 4],
    degree: usize,
    max_radius: f64,
) -> f64 {
    let (rate, acceleration) = (theta_rate[0].abs(), theta_rate[1].abs());
    let mut radius = max_radius;
    if degree < MIN_DEGREE {
        return 0.0;
    }
    for order in [degree - 1, degree] {
        let size = all
            .iter()
            .fold(0.0_f64, |size, series| size.max(series[order].abs()));
        if size > 0.0 && rate.max(acceleration) > 0.0 {
            let of = |scale: f64, order: usize| {
                libm::exp(libm::log(TRUNCATION_TOLERANCE * scale / size) / order as f64)
            };
            // θ′ grows to θ″ times the step, which dominates next to P = 0 and where a fast
            // slip ends at once.
            let grown = of(acceleration, order - 1);
            let grown = if grown <= 1.0 {
                grown
            } else {
                of(acceleration, order)
            };
            radius = radius.min(of(rate, order).max(grown));
        }
    }
    radius
}
