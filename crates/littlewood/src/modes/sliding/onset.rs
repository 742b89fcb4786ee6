//! How a slide without kinetic friction begins at η′ = 0: by the first derivative of η′ that does
//! not vanish (docs/theory/contact.md).
//!
//! η″ = h s [m (1 + hc) − u (m h c + m h² + Î)]/(Î + m h² s²) on a level plane vanishes at the top
//! and at the bottom, on a curve between them, and for a particle on a thin rim, with Î + m h² = m,
//! at u = 1 whatever the angle. Computed there it is rounding, and its sign tells nothing. So a
//! coefficient of the series of η′ counts only if it exceeds the rounding of its terms.

use crate::math::series::{DEGREE, Series, convolve};
use crate::math::trig::Angle;
use crate::mechanics::SlidingLaw;
use crate::model::{Direction, Heavy};

use super::series::{PhasePoint, SlideSeries};

/// The first derivative of η′ that does not vanish.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Onset {
    /// 1 for η″.
    pub(crate) order: usize,
    /// Its sign: the direction of the slip that begins.
    pub(crate) direction: Direction,
}

impl Onset {
    /// Of a slide without kinetic friction; none if rounding decides all coefficients, as at rest
    /// in an equilibrium.
    pub(crate) fn of(law: &SlidingLaw, place: PhasePoint) -> Option<Self> {
        // Nearly always η″ decides.
        let acceleration = law.accelerations(place.theta, place.rate).slip;
        if acceleration.abs() > Sizes::new(law, place, 1).rounding(1) {
            let direction = Direction::of_sign(acceleration)?;
            return Some(Self {
                order: 1,
                direction,
            });
        }
        let slip = SlideSeries::new(law, place, 0.0).slip;
        let sizes = Sizes::new(law, place, DEGREE);
        let order = (2..=DEGREE).find(|n| slip[*n].abs() > sizes.rounding(*n))?;
        let direction = Direction::of_sign(slip[order])?;
        Some(Self { order, direction })
    }
}

/// Sums of the sizes of the terms of the coefficients of η′.
struct Sizes {
    terms: Series,
    /// The same with the largest values of sine and cosine: the change with the angle.
    turned: Series,
    /// The rounding of the angle, and the relative change of P with the angle.
    angle: f64,
    steepness: f64,
}

impl Sizes {
    fn new(law: &SlidingLaw, place: PhasePoint, max_order: usize) -> Self {
        let (sin, cos) = libm::sincos(place.theta);
        let (sin, cos) = (sin.abs(), cos.abs());
        let Heavy { mass, h, .. } = law.body;
        let p = law.p(sin, h * sin);
        let sum = |angle| sum_of_sizes(law, p, angle, place.rate.abs(), max_order);
        Self {
            terms: sum(Angle { sin, cos }),
            turned: sum(Angle {
                sin: sin + cos,
                cos: sin + cos,
            }),
            angle: 0.5 * f64::EPSILON * place.theta.abs(),
            steepness: 2.0 * mass * h * h * sin * cos / p,
        }
    }

    /// Bound of the rounding of coefficient n. A term of η″ has at most 24 roundings: 14 of its
    /// products and sums, 7 of m, h and Î, 3 of θ′. Each order adds as many to those before it, and
    /// sums of one more term. A term has at most n + 2 sines and cosines, and divides by P n times.
    fn rounding(&self, n: usize) -> f64 {
        let order = n as f64;
        let roundings = 12.0 * order * (order + 1.0);
        let by_angle = (order + 2.0) + order * self.steepness;
        0.5 * f64::EPSILON * roundings * self.terms[n] + self.angle * by_angle * self.turned[n]
    }
}

/// The recurrence of [`SlideSeries`], of the sizes of its terms, up to `max_order`; from P.
fn sum_of_sizes(law: &SlidingLaw, p: f64, angle: Angle, rate0: f64, max_order: usize) -> Series {
    let Heavy {
        mass, h, inertia, ..
    } = law.body;
    let zero: Series = [0.0; DEGREE + 1];
    let (mut sin, mut cos, mut turn, mut rate) = (zero, zero, zero, zero);
    let (mut u, mut contact, mut painleve, mut acceleration) = (zero, zero, zero, zero);
    let (mut height, mut slip) = (zero, zero);
    (sin[0], cos[0], rate[0]) = (angle.sin, angle.cos, rate0);
    for n in 0..=max_order {
        let order = n as f64;
        if n > 0 {
            rate[n] = acceleration[n - 1] / order;
            // n θ_n.
            turn[n] = rate[n - 1];
            let [forth, back] = convolve([(&turn, &cos), (&turn, &sin)], n);
            (sin[n], cos[n]) = (forth / order, back / order);
        }
        let one = if n == 0 { 1.0 } else { 0.0 };
        [u[n]] = convolve([(&rate, &rate)], n);
        height[n] = one + h * cos[n];
        let [cos_u, square, height_rate] =
            convolve([(&cos, &u), (&sin, &sin), (&rate, &height)], n);
        contact[n] = one + h * cos_u;
        painleve[n] = inertia * one + mass * h * h * square;
        slip[n] = height_rate;
        let [driven] = convolve([(&sin, &contact)], n);
        let mut sum = mass * h * driven;
        for j in 1..=n {
            sum += painleve[j] * acceleration[n - j];
        }
        acceleration[n] = sum / p;
    }
    slip[1] += law.mean_slip_loss().abs();
    slip
}
