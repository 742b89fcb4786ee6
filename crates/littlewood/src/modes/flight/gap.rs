//! The gap under the rim in flight: its extrema and its first zero.

use core::f64::consts::{PI, TAU};

use crate::math::bracket::{Bracket, RootStep};
use crate::math::trig::{Angle, TruncatedSeries, taylor, without_turns};

/// The gap as a function of an argument p: the angle φ, or the time if the gap is concave (h θ′² ≤
/// 1).
#[derive(Clone, Copy, Debug)]
pub(super) struct Gap {
    pub(super) h: f64,
    pub(super) sin: f64,
    pub(super) cos: f64,
    /// Rate of the gap in p at the start.
    pub(super) rise: f64,
    /// Second derivative at the start, h c0 − weight; exactly zero at a lift-off from sliding.
    pub(super) opening: f64,
    /// Contribution of the parabola to the second derivative: 1/θ′², or 1 in time.
    pub(super) weight: f64,
    /// dφ/dp.
    pub(super) spin: f64,
    /// θ0 in the direction of rotation.
    pub(super) theta: f64,
}

#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bound {
    pub(super) at: f64,
    pub(super) gap: f64,
    pub(super) slope: f64,
}

impl Bound {
    /// Gap at the intersection of the tangents at two points.
    fn tangents_meet(&self, other: &Self) -> f64 {
        let way = (other.gap - self.gap - other.slope * (other.at - self.at))
            / (self.slope - other.slope);
        self.gap + self.slope * way
    }

    /// Estimate of the extremum between two inflections: the slope is modelled by the cubic 3 t² −
    /// 2 t³.
    fn about_turning(&self, other: &Self) -> f64 {
        let part = self.slope / (self.slope - other.slope);
        let way = 0.5 - libm::sin(libm::asin(1.0 - 2.0 * part) / 3.0);
        self.at + (other.at - self.at) * way
    }

    /// Estimate of the zero before `other`, on the parabola through both points with the slope at
    /// this one.
    fn about_touchdown(&self, other: &Self) -> f64 {
        let width = other.at - self.at;
        let bend = (other.gap - self.gap - self.slope * width) / (width * width);
        let root = (self.slope * self.slope - 4.0 * bend * self.gap)
            .max(0.0)
            .sqrt();
        self.at + 2.0 * self.gap / (root - self.slope)
    }
}

/// Polynomial expansion of the gap about an argument; its evaluation needs no further sine or
/// cosine.
///
/// From the third on, the derivatives are those of −h cos(θ0 + φ). A step s turns the hoop by y =
/// spin s and adds jerk s³ (y − sin y)/y³ + snap s⁴ (cos y − 1 + y²/2)/y⁴ to the parabola.
#[derive(Clone, Copy, Debug)]
struct Expansion {
    at: f64,
    gap: f64,
    slope: f64,
    curvature: f64,
    jerk: f64,
    snap: f64,
    spin: f64,
}

/// Largest step of an expansion, in φ: the neglected terms of gap and slope, y¹¹/11! and y¹⁰/10!,
/// are then below 3e-16.
const MAX_EXPANSION_TURN: f64 = 0.125;

/// Largest step of an expansion as a fraction of the argument: at the start gap, slope and
/// curvature may vanish together.
const MAX_EXPANSION_FRACTION: f64 = 0.125;

/// Coefficients of (sin y)/y, (1 − cos y)/y², (y − sin y)/y³ and (cos y − 1 + y²/2)/y⁴. Within
/// [`MAX_EXPANSION_TURN`] the neglected terms are below the rounding of the gap and of its slope.
const TRIG_COEFFICIENTS: [[f64; 4]; 4] = [
    taylor(1, 1.0),
    taylor(2, 1.0),
    taylor(3, 1.0),
    taylor(4, 1.0),
];

impl Expansion {
    fn reach(&self) -> f64 {
        (MAX_EXPANSION_TURN / self.spin).min(MAX_EXPANSION_FRACTION * self.at)
    }

    /// The gap and its first three derivatives after a step.
    #[inline]
    fn derivatives(&self, step: f64) -> [f64; 4] {
        let turn = self.spin * step;
        let square = turn * turn;
        let [first, second, third, fourth] =
            TRIG_COEFFICIENTS.map(|[a, b, c, d]| ((a * square + b) * square + c) * square + d);
        let (jerk, snap) = (self.jerk * step, self.snap * step * step);
        [
            self.gap
                + step
                    * (self.slope + step * (0.5 * self.curvature + (jerk * third + snap * fourth))),
            self.slope + step * (self.curvature + (jerk * second + snap * third)),
            self.curvature + (jerk * first + snap * second),
            self.jerk * (1.0 - square * second) + self.snap * (step * first),
        ]
    }
}

/// Whether sin θ at a lift-off is more accurate from θ′ than from θ. Rounding of θ changes sin θ by
/// cos θ ε |θ|/2; the four roundings from θ′ to cos θ change it by 4 (ε/2) cos² θ/sin θ.
pub(crate) fn sine_follows_from_rate(theta: f64, Angle { sin, cos }: Angle) -> bool {
    (sin * theta).abs() > 4.0 * cos
}

/// Largest angle at which the gap uses the difference b; beyond it the rounding of b, times φ²/2,
/// would dominate.
const MAX_ANGLE_WITH_DIFFERENCE: f64 = 1.0;

/// Largest angle of a flight, rad: its turns can still be counted. The landing of a longer flight
/// is not computed.
pub(super) const MAX_RESOLVED_ANGLE: f64 = 4.6e18;

/// Largest rise of a flight whose landing is that of the parabola. The squares of arguments
/// underflow from a rise of 1e-154 on.
const MAX_PARABOLIC_RISE: f64 = 1e-120;

/// Largest error of a bound by tangents, relative to the terms of the gap: a dozen operations round
/// by ε/2 each.
const TANGENT_BOUND_ERROR: f64 = 16.0 * f64::EPSILON;

impl Gap {
    /// The gap at a lift-off from sliding, where 1 = h c0 θ′² holds to the rounding of θ0 and θ′:
    /// sets b = 0 and c0 = 1/(h θ′²), and takes s0 from the more accurate of θ0 and θ′.
    pub(super) fn at_lift_off(self) -> Self {
        let cos = self.weight / self.h;
        let sin = if sine_follows_from_rate(
            self.theta,
            Angle {
                sin: self.sin,
                cos: self.cos,
            },
        ) {
            -((1.0 - cos) * (1.0 + cos)).max(0.0).sqrt()
        } else {
            self.sin
        };
        Self {
            cos,
            sin,
            opening: 0.0,
            ..self
        }
    }

    pub(super) fn bound(&self, at: f64) -> Bound {
        let Expansion { gap, slope, .. } = self.expansion(at);
        Bound { at, gap, slope }
    }

    #[inline]
    fn expansion(&self, at: f64) -> Expansion {
        let Self {
            h,
            sin,
            cos,
            spin,
            rise,
            opening,
            weight,
            ..
        } = *self;
        let turned = spin * at;
        let TruncatedSeries {
            sine,
            versine,
            odd,
            even,
        } = TruncatedSeries::new(turned);
        let (square, lever) = (spin * spin, h * (spin * spin));
        let (gap, slope) = if turned <= MAX_ANGLE_WITH_DIFFERENCE {
            (
                rise * at + (0.5 * opening * at * at - h * (cos * even + sin * odd)),
                rise + (opening * at - h * spin * (cos * odd + sin * versine)),
            )
        } else {
            // Avoids b, a difference whose rounding error grows with the square of the angle.
            (
                at * (rise - 0.5 * weight * at) + h * (cos * versine - sin * odd),
                (rise - weight * at) + h * spin * (cos * sine - sin * versine),
            )
        };
        Expansion {
            at,
            gap,
            slope,
            curvature: opening - lever * (cos * versine + sin * sine),
            jerk: -lever * spin * (cos * sine + sin * (1.0 - versine)),
            snap: -lever * square * (cos * (1.0 - versine) - sin * sine),
            spin,
        }
    }

    /// Bound of the terms of the gap up to an argument.
    fn size(&self, at: f64) -> f64 {
        at * (self.rise + self.weight * at) + self.h * (2.0 + self.spin * at)
    }

    /// The root of a quantity in a bracket, from a guess. `quantity` maps the argument, and the gap
    /// with its first three derivatives there, to the quantity and its first two derivatives.
    fn root(
        &self,
        bracket: Bracket,
        guess: f64,
        quantity: impl Fn(f64, [f64; 4]) -> (f64, f64, f64) + Copy,
    ) -> Bound {
        let mut last = None;
        let root = bracket.iterate(guess, |at| {
            let near = self.expansion(at);
            last = Some(near);
            let here = quantity(at, [near.gap, near.slope, near.curvature, near.jerk]);
            let model = |step| quantity(at + step, near.derivatives(step));
            RootStep::by_model(at, here, near.reach(), 1.0 / near.spin, model)
        });
        match last {
            Some(near) if (root - near.at).abs() <= near.reach() => {
                let [gap, slope, ..] = near.derivatives(root - near.at);
                Bound {
                    at: root,
                    gap,
                    slope,
                }
            }
            Some(_) | None => self.bound(root),
        }
    }

    /// Whether the gap lands so soon that it is the parabola at its start: the next term, relative
    /// to it, is at most h spin³ p/(3 w) at p = 2 rise/w, with w = −opening.
    pub(super) fn is_parabola(&self) -> bool {
        let Self {
            h,
            spin,
            rise,
            opening,
            ..
        } = *self;
        rise < MAX_PARABOLIC_RISE
            && opening < 0.0
            && h * spin * spin * spin * rise <= 0.25 * f64::EPSILON * (opening * opening)
    }

    /// The landing of a concave gap: between zero and the landing of a larger gap.
    pub(super) fn only_landing(&self) -> Bound {
        if self.is_parabola() {
            return Bound {
                at: 2.0 * self.rise / -self.opening,
                gap: 0.0,
                slope: -self.rise,
            };
        }
        let (guess, high) = self.about_only_landing();
        let bracket = Bracket {
            low: 0.0,
            high: high * (1.0 + 8.0 * f64::EPSILON),
        };
        // gap/p has no root at zero, and decreases: it is the mean of the slopes up to p.
        self.root(bracket, guess, |p, [gap, slope, curvature, _]| {
            let (value, fall) = (gap / p, slope / p);
            (
                value,
                fall - value / p,
                (curvature - 2.0 * (fall - value / p)) / p,
            )
        })
    }

    /// An estimate of the landing of a concave gap, and an upper bound: the landing of a larger
    /// gap.
    fn about_only_landing(&self) -> (f64, f64) {
        // With the time as p, gap″ = −1 + h θ′² cos(θ0 + φ): the gap falls faster than with h θ′² −
        // 1, and than the parabola of the mass centre with a rim 2 h lower.
        let fast = self.h * self.spin * self.spin;
        let drift = self.rise - self.h * self.sin * self.spin;
        let widest = drift + (drift * drift + 4.0 * self.h).sqrt();
        let high = if fast < 1.0 {
            (2.0 * self.rise / (1.0 - fast)).min(widest)
        } else {
            widest
        };
        // The parabola at the start, then one with the third derivative there.
        let weight = -self.opening;
        let flat = 2.0 * self.rise / weight;
        let jerk = self.h * self.sin * self.spin * self.spin * self.spin / 3.0;
        (
            if weight > 0.0 {
                flat * weight / (weight + jerk * flat)
            } else {
                high
            },
            high,
        )
    }

    pub(super) fn only_apex(&self, landing: f64) -> Bound {
        let guess = if self.opening < 0.0 {
            self.rise / -self.opening
        } else {
            0.5 * landing
        };
        self.root(
            Bracket {
                low: 0.0,
                high: landing,
            },
            guess,
            |_, [_, slope, curvature, jerk]| (slope, curvature, jerk),
        )
    }

    /// The zeros of gap″, cos(θ0 + φ) = c0 − b/h. At `first` gap″ changes from + to −. This is the
    /// first zero after the start if gap″ ≥ 0 at the start, and the second zero otherwise.
    fn inflections(&self) -> Inflections {
        let (from_top, level) = if self.opening == 0.0 {
            // A lift-off from sliding starts on the inflection −level itself.
            let from_top = libm::atan2(self.sin, self.cos);
            (from_top, from_top.abs())
        } else {
            let half = libm::sin(0.5 * self.theta);
            let versine = (2.0 * half * half + self.opening / self.h).min(2.0);
            (
                without_turns(self.theta),
                2.0 * libm::atan2(versine.sqrt(), (2.0 - versine).sqrt()),
            )
        };
        // level − |θ0| without cancellation: cos θ0 − cos(level) = b/h.
        let ahead = || {
            let sine = self.opening / (2.0 * self.h * libm::sin(0.5 * (level + from_top.abs())));
            2.0 * libm::asin(sine.min(1.0))
        };
        let fall = 2.0 * (PI - level);
        if self.opening >= 0.0 {
            let first = if from_top > 0.0 {
                ahead()
            } else {
                level - from_top
            };
            Inflections { first, fall }
        } else {
            let turn = if from_top > 0.0 {
                fall + ahead()
            } else {
                -ahead()
            };
            Inflections {
                first: turn + 2.0 * level,
                fall,
            }
        }
    }

    /// The zero of gap′ between two inflections where it has opposite signs.
    fn turning(&self, from: &Bound, to: &Bound) -> Bound {
        let sign = from.slope.signum();
        let bracket = Bracket {
            low: from.at,
            high: to.at,
        };
        self.root(
            bracket,
            from.about_turning(to),
            |_, [_, slope, curvature, jerk]| (sign * slope, sign * curvature, sign * jerk),
        )
    }

    /// The maximum of the gap, and the landing.
    pub(super) fn extent(&self) -> (Bound, Bound) {
        let inflections = self.inflections();
        let (opens, closes) = self.open_interval();
        if closes >= MAX_RESOLVED_ANGLE {
            return (
                self.bound(0.5 * (opens + closes)),
                Bound {
                    at: closes,
                    ..Bound::default()
                },
            );
        }
        let mut highest = Bound::default();
        let mut index = 0;
        let mut known = None;
        if self.opening < 0.0 {
            // The gap is concave at first, and convex from the inflection before `first` on.
            let turn = self.bound(inflections.first - (TAU - inflections.fall));
            let first = self.bound(inflections.first);
            let start = Bound {
                at: 0.0,
                gap: 0.0,
                slope: self.rise,
            };
            known = Some(first);
            for (start, end) in [(start, turn), (turn, first)] {
                if let Some(landing) = self.advance(start, &end, &mut highest) {
                    return (highest, landing);
                }
            }
        }
        // Otherwise gap′ and gap grow from the start to the first inflection.
        let mut skipped = false;
        loop {
            let last = inflections.last_before(closes);
            let at = inflections.at(index);
            if at >= opens && at < closes && last > index {
                // The parabola proves that the gap stays open for many turns.
                (skipped, index, known) = (true, last, None);
            }
            let from = known.unwrap_or_else(|| self.bound(inflections.at(index)));
            let to = self.bound(inflections.at(index + 1));
            if let Some(landing) = self.advance(from, &to, &mut highest) {
                return (
                    if skipped {
                        self.apex(landing.at)
                    } else {
                        highest
                    },
                    landing,
                );
            }
            index += 1;
            known = Some(to);
        }
    }

    /// The landing between two inflections, if any; updates the maximum.
    fn advance(&self, mut from: Bound, to: &Bound, highest: &mut Bound) -> Option<Bound> {
        // Between inflections the gap is concave or convex, so the tangents at the ends bound its
        // extremum.
        let bound = from.tangents_meet(to);
        if from.slope > 0.0 && to.slope <= 0.0 && bound > highest.gap {
            from = self.turning(&from, to);
            if from.gap > highest.gap {
                *highest = from;
            }
        } else if from.slope < 0.0
            && to.slope > 0.0
            && bound <= TANGENT_BOUND_ERROR * self.size(to.at)
        {
            let lowest = self.turning(&from, to);
            if lowest.gap <= 0.0 {
                return Some(self.touchdown(&from, &lowest));
            }
            from = lowest;
        }
        // An inflection may round to the start, where the gap has not opened yet.
        let has_only_opened = from.gap == 0.0 && from.slope > 0.0 && to.slope > 0.0;
        (to.gap <= 0.0 && !has_only_opened).then(|| self.touchdown(&from, to))
    }

    /// The zero of a gap that decreases from `from` to `to`.
    fn touchdown(&self, from: &Bound, to: &Bound) -> Bound {
        let bracket = Bracket {
            low: from.at,
            high: to.at,
        };
        self.root(
            bracket,
            from.about_touchdown(to),
            |_, [gap, slope, curvature, _]| (gap, slope, curvature),
        )
    }

    /// The maximum of the gap in a flight of many turns: within half a turn of the apex of the
    /// parabola.
    fn apex(&self, landing: f64) -> Bound {
        let inflections = self.inflections();
        let top = ((self.rise - self.h * self.sin) / self.weight).max(0.0);
        let mut index = inflections.last_before(top - TAU);
        let mut best = Bound::default();
        loop {
            // Maxima lie where gap″ < 0, between an inflection of even index and the next.
            let (from, to) = (inflections.at(index), inflections.at(index + 1));
            if from >= landing || from > top + TAU {
                return best;
            }
            let (start, end) = (self.bound(from), self.bound(to));
            if start.slope > 0.0 && end.slope <= 0.0 {
                let highest = self.turning(&start, &end);
                if highest.gap > best.gap && highest.at < landing {
                    best = highest;
                }
            }
            index += 2;
        }
    }

    /// The interval on which the parabola proves that the gap is open: gap ≥ h (c0 − 1) + (v/ω − h
    /// s0) φ − φ²/(2θ′²).
    fn open_interval(&self) -> (f64, f64) {
        let slope = self.rise - self.h * self.sin;
        let discriminant = slope * slope - 2.0 * self.weight * self.h * (1.0 - self.cos);
        if slope <= 0.0 || discriminant <= 0.0 {
            return (f64::INFINITY, 0.0);
        }
        let root = discriminant.sqrt();
        ((slope - root) / self.weight, (slope + root) / self.weight)
    }
}

/// The zeros of gap″: angles with two alternating distances that add up to a turn.
#[derive(Clone, Copy, Debug)]
struct Inflections {
    first: f64,
    fall: f64,
}

impl Inflections {
    fn at(&self, index: u64) -> f64 {
        let odd = if index % 2 == 1 { self.fall } else { 0.0 };
        self.first + (index / 2) as f64 * TAU + odd
    }

    /// Index of the last inflection from + to − at or before an angle, at least the first.
    fn last_before(&self, angle: f64) -> u64 {
        let turns = ((angle - self.first) / TAU).floor();
        if turns > 0.0 { 2 * turns as u64 } else { 0 }
    }
}
