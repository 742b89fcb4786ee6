//! The end of a slide next to P = 0, where the steps shrink to the resolution of the time.
//!
//! For σ = +1, sin θ > 0 and q = −Î/(m h sin θ) < 0 at P = 0. There the normal force grows without
//! bound at a fixed angle, and θ′ decreases. η′ decreases with θ′, since η′ − θ′ L + μk τ is
//! constant, L = 1 + h (cos θ + μk sin θ) > 0. The limit of θ′ decides whether the slip or the
//! normal force vanishes first:
//!
//! - *From above*, θ′ < 0, w ~ C ξ^λ with the distance ξ and λ = 2 Î cos θ/(sin θ P_θ). If cos θ >
//!   0, then λ > 0, and w vanishes with ξ at θ′ = −1/√(h cos θ). If the first integral gives η′ < 0
//!   there, the slip ends before. If η′ > 0, the slide jams for λ < 1 and C > 0, and lifts off
//!   otherwise. If cos θ ≤ 0, then λ ≤ 0 and θ′ decreases without bound: the slip ends.
//! - *From below*, θ′ > 0, the slide turns back before P = 0 (λ < −1 if cos θ > 0, and w ≥ 1
//!   otherwise) and leaves with −θ′, unless the slip ends before. With rolling resistance it stops
//!   there, for either σ: ς has the sign of sin θ.
//!
//! Where the slip ends follows from ξ du/dξ = λ u − κ, κ = 2 Î/(h sin θ P_θ), λ = κ h cos θ, the
//! equation of u = θ′² to leading order: the terms left out are smaller by ξ.

use crate::mechanics::SlidingLaw;
use crate::model::Heavy;
use crate::modes::{Margin, Undecided};

use super::series::PhasePoint;

/// Relative rounding error of a sum of products and of sines: sixteen roundings of ε/2.
const SUM_ERROR: f64 = 8.0 * f64::EPSILON;

/// Largest number of Newton steps to the zero of P. They start next to it and converge
/// quadratically.
const MAX_NEWTON_STEPS: usize = 8;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum SingularFate {
    /// Reaches P = 0 with η′ ≠ 0 and unbounded N.
    Jams,
    /// The normal force vanishes before.
    LiftsOff,
    /// The slip ends before.
    Sticks,
    /// The rotation stops before, with rolling resistance.
    Stops,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct SingularEnd {
    pub(super) fate: SingularFate,
    /// The limit of θ′.
    pub(super) rate: f64,
    /// The angle and the time from the approach to the end; zero where they are below the
    /// resolution of the time.
    pub(super) delta_theta: f64,
    pub(super) delta_time: f64,
}

impl SingularEnd {
    const fn at_once(fate: SingularFate, rate: f64) -> Self {
        Self {
            fate,
            rate,
            delta_theta: 0.0,
            delta_time: 0.0,
        }
    }
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Approach<'a> {
    pub(super) law: &'a SlidingLaw,
    pub(super) place: PhasePoint,
    /// η′ − θ′ L.
    pub(super) integral: f64,
    /// Error bound of `integral`.
    pub(super) error: f64,
}

#[derive(Clone, Copy, Debug)]
struct Zero {
    /// Angle relative to that of the approach.
    delta_theta: f64,
    sin: f64,
    cos: f64,
    /// P_θ and P_θθ.
    slope: f64,
    bend: f64,
    /// Error bound of the angle.
    error: f64,
}

impl Zero {
    fn near(law: &SlidingLaw, theta: f64) -> Option<Self> {
        let Heavy {
            mass, h, inertia, ..
        } = law.body;
        let (sin, cos) = libm::sincos(theta);
        let reduced = libm::atan2(sin, cos);
        let at = |delta_theta: f64| {
            let (sin, cos) = libm::sincos(reduced + delta_theta);
            let (q, turned) = (law.q(1.0, sin, cos), h * (cos + law.friction * sin));
            let slope = mass * h * (cos * q + sin * turned);
            let bend = mass * h * (sin * (h * (law.friction * cos - sin) - q) + 2.0 * cos * turned);
            let levers = h * sin.abs() + law.friction.abs() * (1.0 + h * cos);
            let size = inertia + mass * h * sin.abs() * (levers + law.resistance.abs());
            let error = SUM_ERROR * (size / slope.abs() + reduced.abs());
            (
                law.p(sin, q),
                Self {
                    delta_theta,
                    sin,
                    cos,
                    slope,
                    bend,
                    error,
                },
            )
        };
        let (mut p, mut zero) = at(0.0);
        for _ in 0..MAX_NEWTON_STEPS {
            if p.abs() <= zero.error * zero.slope.abs() {
                break;
            }
            (p, zero) = at(zero.delta_theta - p / zero.slope);
        }
        // Rejects NaN, too.
        (p.abs() <= zero.error * zero.slope.abs()).then_some(zero)
    }
}

impl Approach<'_> {
    /// The end, from an earlier angle and rate at which the leading-order terms hold. An error if
    /// rounding decides, with what it decides, or if P = 0 is not the cause.
    pub(super) fn end(&self, earlier: PhasePoint) -> Result<SingularEnd, Option<Undecided>> {
        let Self {
            law,
            place: PhasePoint { theta, rate },
            integral,
            error,
        } = *self;
        let (h, sigma) = (law.body.h, law.friction.signum());
        let zero = Zero::near(law, theta).filter(|zero| zero.slope * rate < 0.0);
        let zero = zero.ok_or(None)?;
        let Zero { sin, cos, .. } = zero;
        let slip_coefficient = law.slip_coefficient(sin, cos);
        // Without rolling resistance sin θ has the sign of σ.
        let is_from_above = sin * rate < 0.0;
        let stops = law.resistance != 0.0 && !is_from_above;
        if is_from_above && cos <= 0.0 {
            return Ok(self.end_of_slip(&zero));
        }
        let last = if is_from_above {
            -sigma / (h * cos).sqrt()
        } else if stops {
            0.0
        } else {
            -rate
        };
        let slip = sigma * (last * slip_coefficient + integral);
        let tilt = if is_from_above { 0.5 * sin / cos } else { 0.0 };
        let by_angle = (last * (slip_coefficient * tilt + h * (law.friction * cos - sin))).abs();
        let uncertainty =
            error + SUM_ERROR * (last * slip_coefficient).abs() + by_angle * zero.error;
        if slip < -uncertainty {
            Ok(self.end_of_slip(&zero))
        } else if slip <= uncertainty {
            Err(Some(Undecided::Rounding {
                margin: Margin::SlipAtSingularity,
                value: slip,
                bound: uncertainty,
            }))
        } else if stops {
            Ok(SingularEnd::at_once(SingularFate::Stops, last))
        } else if is_from_above {
            let fate = self.without_force(&zero, earlier)?;
            Ok(SingularEnd::at_once(fate, last))
        } else {
            Err(None)
        }
    }

    /// The end of the slip, where θ′ L = −(η′ − θ′ L).
    fn end_of_slip(&self, zero: &Zero) -> SingularEnd {
        let Self {
            law,
            place: PhasePoint { theta, rate },
            integral,
            ..
        } = *self;
        let scale = 2.0 * law.body.inertia / (law.body.h * zero.sin * zero.slope);
        let exponent = scale * law.body.h * zero.cos;
        // u after the distance has become e^y times that of the approach, and its inverse.
        let u_at = |y: f64| {
            let lost = if exponent == 0.0 {
                y
            } else {
                libm::expm1(exponent * y) / exponent
            };
            rate * rate * libm::exp(exponent * y) - scale * lost
        };
        let y_of = |u: f64| {
            let (gained, slope) = (u - rate * rate, exponent * rate * rate - scale);
            if exponent == 0.0 {
                gained / slope
            } else {
                libm::log1p(exponent * gained / slope) / exponent
            }
        };
        let mut end = SingularEnd::at_once(
            SingularFate::Sticks,
            -integral / law.slip_coefficient(zero.sin, zero.cos),
        );
        // The coefficient L changes by the distance, so that each round gains its digits.
        for _ in 0..3 {
            let y = y_of(end.rate * end.rate);
            // Rounding puts the end before the approach.
            if y > 0.0 || y.is_nan() {
                return SingularEnd::at_once(SingularFate::Sticks, end.rate);
            }
            end.delta_theta = -zero.delta_theta * libm::expm1(y);
            let (sin, cos) = libm::sincos(theta + end.delta_theta);
            end.rate = -integral / law.slip_coefficient(sin, cos);
            // Simpson's rule in the distance; a slide that turns back passes θ′ = 0, in a time that
            // is not resolved.
            let between = libm::log1p(0.5 * libm::expm1(y));
            let slowness = 1.0 / rate + 4.0 / u_at(between).sqrt().copysign(rate) + 1.0 / end.rate;
            let is_ahead = end.rate * rate > 0.0 && slowness.is_finite();
            end.delta_time = if is_ahead {
                end.delta_theta * slowness / 6.0
            } else {
                0.0
            };
        }
        end
    }

    /// Jam or lift-off, from λ and C.
    fn without_force(&self, zero: &Zero, earlier: PhasePoint) -> Result<SingularFate, Undecided> {
        let law = self.law;
        let Zero {
            sin,
            cos,
            slope,
            bend,
            ..
        } = *zero;
        let exponent = 2.0 * law.body.inertia * cos / (sin * slope);
        let distance = (earlier.theta - self.place.theta - zero.delta_theta).abs();
        // The regular part of w, to first order.
        let tangent = sin.abs() / cos;
        let smooth = tangent / (1.0 - exponent);
        let force = law.contact(earlier.theta, earlier.rate);
        let next = distance * ((bend / slope).abs() + tangent + 1.0 / tangent);
        let uncertainty =
            SUM_ERROR * (1.0 + (1.0 - force).abs()) + smooth * (zero.error + distance * next);
        let singular_part = force - smooth * distance;
        if exponent >= 1.0 || singular_part < -uncertainty {
            Ok(SingularFate::LiftsOff)
        } else if singular_part > uncertainty {
            Ok(SingularFate::Jams)
        } else {
            Err(Undecided::Rounding {
                margin: Margin::ContactAtSingularity,
                value: singular_part,
                bound: uncertainty,
            })
        }
    }
}
