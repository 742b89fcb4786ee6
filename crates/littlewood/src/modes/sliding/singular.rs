//! The end of a slide next to P = 0, where its steps shrink to the resolution of the clock.
//!
//! Seen with σ = +1, so that sin θ > 0: where P = 0, q = −Î/(m h sin θ) < 0. The normal force there is as large as it takes, while the
//! angle does not change any more: θ′ falls and η′ with it, for η′ − θ′ L + μk τ is constant, L = 1 + h (cos θ + μk sin θ) > 0. How far θ′
//! can fall tells what comes first, the end of the slip or that of the force:
//!
//! - *From above*, θ′ < 0, w ~ C ξ^λ with the distance ξ and λ = 2 Î cos θ/(sin θ P_θ). Where cos θ > 0, λ > 0 and w vanishes with ξ, at
//!   θ′ = −1/√(h cos θ): if there η′ < 0 by the first integral, the slip has ended before. If η′ > 0, the slide jams where λ < 1 and C > 0,
//!   and lifts off otherwise. Where cos θ ≤ 0, λ ≤ 0 and θ′ falls without bound: the slip ends.
//! - *From below*, θ′ > 0, the slide turns back before P = 0 (λ < −1 where cos θ > 0, and w ≥ 1 where not) and leaves with −θ′, unless the
//!   slip has ended before.

use crate::mechanics::SlidingLaw;
use crate::model::Heavy;

/// Errors of a sum of products and of sines, in units of its largest terms.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

/// Newton steps to the zero of P, from where P is a few last digits.
const NEWTON_STEPS: usize = 8;

/// What a slide does next to P = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Fate {
    /// Arrives with slip left, with N beyond all bounds.
    Jams,
    /// The normal force has vanished before.
    LiftsOff,
    /// The slip has ended before.
    Sticks,
}

/// A slide next to P = 0.
#[derive(Clone, Copy, Debug)]
pub(super) struct Approach<'a> {
    pub(super) law: &'a SlidingLaw,
    pub(super) theta: f64,
    pub(super) theta_rate: f64,
    /// η′ = θ′ L + this.
    pub(super) rest: f64,
    /// What `rest` may be wrong by.
    pub(super) error: f64,
}

/// Where P = 0.
#[derive(Clone, Copy, Debug)]
struct Zero {
    /// From the angle of the approach.
    ahead: f64,
    sin: f64,
    cos: f64,
    /// P_θ and P_θθ.
    slope: f64,
    bend: f64,
    /// What the angle may be wrong by.
    error: f64,
}

impl Zero {
    fn near(law: &SlidingLaw, theta: f64) -> Option<Self> {
        let Heavy { mass, h, inertia, .. } = law.body;
        let (sin, cos) = libm::sincos(theta);
        let reduced = libm::atan2(sin, cos);
        let at = |ahead: f64| {
            let (sin, cos) = libm::sincos(reduced + ahead);
            let (q, turned) = (law.q(1.0, sin, cos), h * (cos + law.friction * sin));
            let slope = mass * h * (cos * q + sin * turned);
            let bend = mass * h * (sin * (h * (law.friction * cos - sin) - q) + 2.0 * cos * turned);
            let size =
                inertia + mass * h * sin.abs() * (h * sin.abs() + law.friction.abs() * (1.0 + h * cos));
            let error = ROUNDING * (size / slope.abs() + reduced.abs());
            (law.p(sin, q), Self { ahead, sin, cos, slope, bend, error })
        };
        let (mut p, mut zero) = at(0.0);
        for _ in 0..NEWTON_STEPS {
            if p.abs() <= zero.error * zero.slope.abs() {
                break;
            }
            (p, zero) = at(zero.ahead - p / zero.slope);
        }
        // Also where it is no number.
        (p.abs() <= zero.error * zero.slope.abs()).then_some(zero)
    }
}

impl Approach<'_> {
    /// What follows, with θ′ there, from an earlier angle and rate of the slide, at which the first terms in the distance from P = 0
    /// hold. None where the rounding of the numbers decides, or P = 0 is not the cause.
    pub(super) fn fate(&self, earlier: (f64, f64)) -> Option<(Fate, f64)> {
        let Self { law, theta, theta_rate, rest, error } = *self;
        let (h, sigma) = (law.body.h, law.friction.signum());
        let zero = Zero::near(law, theta).filter(|zero| zero.slope * theta_rate < 0.0)?;
        let Zero { sin, cos, .. } = zero;
        let lever = law.lever(sin, cos);
        let sticks = Some((Fate::Sticks, -rest / lever));
        let is_from_above = sigma * theta_rate < 0.0;
        if is_from_above && cos <= 0.0 {
            return sticks;
        }
        let last = if is_from_above { -sigma / (h * cos).sqrt() } else { -theta_rate };
        let slip = sigma * (last * lever + rest);
        let tilt = if is_from_above { 0.5 * sin / cos } else { 0.0 };
        let by_angle = (last * (lever * tilt + h * (law.friction * cos - sin))).abs();
        let doubt = error + ROUNDING * (last * lever).abs() + by_angle * zero.error;
        if slip < -doubt {
            sticks
        } else if slip > doubt && is_from_above {
            Some((self.without_force(&zero, earlier)?, last))
        } else {
            None
        }
    }

    /// Jam or lift-off, by λ and C.
    fn without_force(&self, zero: &Zero, earlier: (f64, f64)) -> Option<Fate> {
        let law = self.law;
        let Zero { sin, cos, slope, bend, .. } = *zero;
        let exponent = 2.0 * law.body.inertia * cos / (sin * slope);
        let (theta, rate) = earlier;
        let distance = (theta - self.theta - zero.ahead).abs();
        // The smooth part of w, to the first order.
        let tangent = sin.abs() / cos;
        let smooth = tangent / (1.0 - exponent);
        let force = law.contact(theta, rate);
        let next = distance * ((bend / slope).abs() + tangent + 1.0 / tangent);
        let doubt = ROUNDING * (1.0 + (1.0 - force).abs()) + smooth * (zero.error + distance * next);
        if exponent >= 1.0 || force - smooth * distance < -doubt {
            Some(Fate::LiftsOff)
        } else {
            (force - smooth * distance > doubt).then_some(Fate::Jams)
        }
    }
}
