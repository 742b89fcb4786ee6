//! Free flight (§2e): the mass centre on a parabola, the rotation at constant rate, until the rim touches down.
//!
//! A flight begins with the rim at the plane: where a normal force has vanished, or with a rate v ≥ 0 of the gap, after an
//! impact or thrown. In the angle φ = ω Δτ since the start, ω = |θ′|, seen in the direction of rotation, the gap under the rim is
//!
//! ```text
//! gap = v φ/ω + b φ²/2 − h [c0 C(φ) + s0 S(φ)],   C = cos φ − 1 + φ²/2,   S = φ − sin φ,   b = h c0 − 1/θ′²,
//! ```
//!
//! with a simple root at the start for v > 0, a double one for v = 0 and b > 0, and a triple one where sliding lifts off
//! (v = b = 0). Those roots are never searched for. The second derivative b + h (cos(θ0 + φ) − c0) has known zeros, so that
//! gap″, then gap′, then gap are monotone between points that follow from each other, and the first sign change after the
//! start is the landing. Where h θ′² ≤ 1 it has none: the gap is concave in time, and there is one landing; the same
//! formula is then taken in time, which a hoop needs that does not turn.

use core::f64::consts::{PI, TAU};

use crate::bernstein::Bracket;
use crate::hoop::{Heavy, Hoop};
use crate::mode::Mode;
use crate::sample::{Instant, Sample};
use crate::state::State;
use crate::trig::sincos;

/// How the rim leaves the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum TakeOff {
    /// The normal force has just vanished: 1 = h cos θ θ′².
    Grazing,
    /// 1 < h cos θ θ′²: the plane cannot hold the rim.
    Unloaded,
    /// The gap opens at this rate.
    Rising { gap_rate: f64 },
}

/// A phase of flight.
#[derive(Clone, Copy, Debug)]
pub struct Flight {
    h: f64,
    start: State,
    /// Velocity of the mass centre.
    vx: f64,
    vy: f64,
    mass_centre_x: f64,
    gap: Gap,
    /// Rate of the argument of the gap in time: |θ′|, or 1.
    clock: f64,
    /// Argument at the landing.
    landing: f64,
    /// Argument at which the gap is largest; NaN where it has not been computed.
    apex: f64,
    /// Bounces without number, all together: a gap below 1e-14.
    settles: bool,
}

/// The gap as a function of its argument p: the angle φ, or the time where the hoop turns so slowly that the gap is concave.
#[derive(Clone, Copy, Debug)]
struct Gap {
    h: f64,
    sin: f64,
    cos: f64,
    /// Rate of the gap in p at the start.
    rise: f64,
    /// Its second derivative at the start; exactly zero at a lift-off from sliding.
    opening: f64,
    /// dφ/dp.
    spin: f64,
    /// θ0 in the direction of rotation.
    theta: f64,
}

/// The gap at one end of an interval of φ.
#[derive(Clone, Copy, Debug)]
struct Bound {
    phi: f64,
    gap: f64,
    slope: f64,
}

impl Bound {
    /// Gap where the tangents of two ends meet.
    fn tangents_meet(&self, other: &Self) -> f64 {
        let way = (other.gap - self.gap - other.slope * (other.phi - self.phi)) / (self.slope - other.slope);
        self.gap + self.slope * way
    }
}

/// The largest gap that has been found, and where.
#[derive(Clone, Copy, Debug, Default)]
struct Reach {
    apex: f64,
    height: f64,
}

/// Largest error of 1 − h cos θ θ′² at a lift-off from sliding for which the cosine of the angle is taken.
const LARGEST_ROUNDING: f64 = 1e-6;

/// Where tangents bound the gap by more than this part of the gaps they are computed from, it is open.
const MIN_CLEARANCE: f64 = 1e-9;

impl Gap {
    fn value_and_slope(&self, p: f64) -> (f64, f64) {
        let (value, slope, ..) = self.derivatives(p);
        (value, slope)
    }

    /// gap and its first three derivatives in p.
    #[inline]
    fn derivatives(&self, p: f64) -> (f64, f64, f64, f64) {
        let Self { h, spin, rise, opening, .. } = *self;
        let TruncatedSeries { sine, versine, odd, even } = TruncatedSeries::new(spin * p);
        (
            rise * p + (0.5 * opening * p * p - h * (self.cos * even + self.sin * odd)),
            rise + (opening * p - h * spin * (self.cos * odd + self.sin * versine)),
            opening - h * (spin * spin) * (self.cos * versine + self.sin * sine),
            -h * (spin * spin * spin) * (self.cos * sine + self.sin * (1.0 - versine)),
        )
    }

    /// The landing of a gap that is concave: between zero, where the gap rises, and the landing of a gap that is wider.
    fn only_landing(&self) -> f64 {
        // With the time as p, gap″ = −1 + h θ′² cos(θ0 + φ): the gap falls faster than with h θ′² − 1, and than the
        // parabola of the mass centre with a rim 2 h lower.
        let fast = self.h * self.spin * self.spin;
        let drift = self.rise - self.h * self.sin * self.spin;
        let widest = drift + (drift * drift + 4.0 * self.h).sqrt();
        let high = if fast < 1.0 { (2.0 * self.rise / (1.0 - fast)).min(widest) } else { widest };
        // The parabola at the start, then one with the third derivative there.
        let weight = -self.opening;
        let flat = 2.0 * self.rise / weight;
        let jerk = self.h * self.sin * self.spin * self.spin * self.spin / 3.0;
        let guess = if weight > 0.0 { flat * weight / (weight + jerk * flat) } else { high };
        // gap/p, which falls: a convex combination of the slopes up to p. It has no root at zero.
        Bracket { low: 0.0, high: high * (1.0 + 8.0 * f64::EPSILON) }.refine_from(guess, |p| {
            let (gap, slope, curvature, _) = self.derivatives(p);
            let (value, fall) = (gap / p, slope / p);
            (value, fall - value / p, (curvature - 2.0 * (fall - value / p)) / p)
        })
    }

    /// The largest gap of one that is concave, before the landing.
    fn only_apex(&self, landing: f64) -> f64 {
        let guess = if self.opening < 0.0 { self.rise / -self.opening } else { 0.5 * landing };
        Bracket { low: 0.0, high: landing }.refine_from(guess, |p| {
            let (_, slope, curvature, jerk) = self.derivatives(p);
            (slope, curvature, jerk)
        })
    }

    /// The zeros of gap″, at cos(θ0 + φ) = c0 − b/h, where it turns from + to − and back. The first is ahead of the start if
    /// gap″ ≥ 0 there. Otherwise it is the second turn ahead, behind the one from − to +.
    fn inflections(&self) -> Inflections {
        let from_top = self.theta - TAU * (self.theta / TAU).round();
        // A lift-off from sliding starts on the inflection −level itself.
        let level = if self.opening == 0.0 {
            from_top.abs()
        } else {
            let half = libm::sin(0.5 * self.theta);
            let versine = (2.0 * half * half + self.opening / self.h).min(2.0);
            2.0 * libm::atan2(versine.sqrt(), (2.0 - versine).sqrt())
        };
        // level − |θ0| without cancellation: cos θ0 − cos(level) = b/h.
        let ahead = || {
            let sine = self.opening / (2.0 * self.h * libm::sin(0.5 * (level + from_top.abs())));
            2.0 * libm::asin(sine.min(1.0))
        };
        let fall = 2.0 * (PI - level);
        if self.opening >= 0.0 {
            let first = if from_top > 0.0 { ahead() } else { level - from_top };
            Inflections { first, fall }
        } else {
            let turn = if from_top > 0.0 { fall + ahead() } else { -ahead() };
            Inflections { first: turn + 2.0 * level, fall }
        }
    }

    /// Where gap′ vanishes between two inflections at which it has these values of different sign.
    fn turning(&self, from: &Bound, to: &Bound) -> f64 {
        let sign = from.slope.signum();
        let secant = from.phi + (to.phi - from.phi) * from.slope / (from.slope - to.slope);
        Bracket { low: from.phi, high: to.phi }.refine_from(secant, |phi| {
            let (_, slope, curvature, jerk) = self.derivatives(phi);
            (sign * slope, sign * curvature, sign * jerk)
        })
    }

    /// Arguments of the largest gap and of the landing.
    fn extent(&self) -> (f64, f64) {
        let inflections = self.inflections();
        let (opens, closes) = self.clear();
        let mut reach = Reach::default();
        let mut index = 0;
        let mut from = self.bound(inflections.first);
        if self.opening < 0.0 {
            // The gap is concave at first. It is convex from the turn before the first.
            let turn = self.bound(inflections.first - (TAU - inflections.fall));
            let start = Bound { phi: 0.0, gap: 0.0, slope: self.rise };
            for (start, end) in [(start, turn), (turn, from)] {
                if let Some(landing) = self.advance(start, &end, &mut reach) {
                    return (reach.apex, landing);
                }
            }
        }
        // Otherwise gap′ and gap grow from the start to the first inflection.
        let mut skipped = false;
        loop {
            let last = inflections.last_before(closes);
            if from.phi >= opens && from.phi < closes && last > index {
                // Many turns may pass before the parabola comes down; none of them needs a look.
                skipped = true;
                index = last;
                from = self.bound(inflections.at(index));
            }
            let to = self.bound(inflections.at(index + 1));
            if let Some(landing) = self.advance(from, &to, &mut reach) {
                return (if skipped { self.apex(landing) } else { reach.apex }, landing);
            }
            index += 1;
            from = to;
        }
    }

    /// The landing between two inflections, if there is one; the largest gap so far is kept.
    fn advance(&self, mut from: Bound, to: &Bound, reach: &mut Reach) -> Option<f64> {
        // Between inflections the gap is concave or convex: the tangents at the ends bound its extremum.
        let bound = from.tangents_meet(to);
        if from.slope > 0.0 && to.slope <= 0.0 && bound > reach.height {
            let highest = self.turning(&from, to);
            let height = self.value_and_slope(highest).0;
            if height > reach.height {
                *reach = Reach { apex: highest, height };
            }
            from = Bound { phi: highest, gap: height, slope: 0.0 };
        } else if from.slope < 0.0 && to.slope > 0.0 && bound <= MIN_CLEARANCE * (from.gap + to.gap) {
            let lowest = self.turning(&from, to);
            let at_lowest = self.bound(lowest);
            if at_lowest.gap <= 0.0 {
                return Some(self.touchdown(&from, &at_lowest));
            }
            from = at_lowest;
        }
        // Where an inflection rounds to the start itself, the gap has only begun to open.
        let has_only_opened = from.gap == 0.0 && from.slope > 0.0 && to.slope > 0.0;
        (to.gap <= 0.0 && !has_only_opened).then(|| self.touchdown(&from, to))
    }

    /// Gap and slope at φ.
    fn bound(&self, phi: f64) -> Bound {
        let (gap, slope) = self.value_and_slope(phi);
        Bound { phi, gap, slope }
    }

    /// Where the gap, which falls from `from` to `to`, closes. The parabola through the near end with the slope there and
    /// the gap at the far end is the first guess.
    fn touchdown(&self, from: &Bound, to: &Bound) -> f64 {
        let width = to.phi - from.phi;
        let bend = (to.gap - from.gap - from.slope * width) / (width * width);
        let root = (from.slope * from.slope - 4.0 * bend * from.gap).max(0.0).sqrt();
        let guess = from.phi + 2.0 * from.gap / (root - from.slope);
        Bracket { low: from.phi, high: to.phi }.refine_from(guess, |phi| {
            let (gap, slope, curvature, _) = self.derivatives(phi);
            (gap, slope, curvature)
        })
    }

    /// φ of the largest gap of a flight of many turns: within half a turn of the top of the parabola.
    fn apex(&self, landing: f64) -> f64 {
        let inflections = self.inflections();
        let top = ((self.rise - self.h * self.sin) / self.weight()).max(0.0);
        let mut index = inflections.last_before(top - TAU);
        let mut best = (0.0, 0.0);
        loop {
            // Maxima lie where gap″ < 0, between an inflection of even index and the next.
            let (from, to) = (inflections.at(index), inflections.at(index + 1));
            if from >= landing || from > top + TAU {
                return best.0;
            }
            let (start, end) = (self.bound(from), self.bound(to));
            if start.slope > 0.0 && end.slope <= 0.0 {
                let highest = self.turning(&start, &end);
                let height = self.value_and_slope(highest).0;
                if height > best.1 && highest < landing {
                    best = (highest, height);
                }
            }
            index += 2;
        }
    }

    /// 1/θ′² = h c0 − b, the weight in units of the centripetal force.
    fn weight(&self) -> f64 {
        self.h * self.cos - self.opening
    }

    /// Where the parabola alone proves that the gap is open: gap ≥ h (c0 − 1) + (v/ω − h s0) φ − φ²/(2θ′²).
    fn clear(&self) -> (f64, f64) {
        let slope = self.rise - self.h * self.sin;
        let discriminant = slope * slope - 2.0 * self.weight() * self.h * (1.0 - self.cos);
        if slope <= 0.0 || discriminant <= 0.0 {
            return (f64::INFINITY, 0.0);
        }
        let root = discriminant.sqrt();
        ((slope - root) / self.weight(), (slope + root) / self.weight())
    }
}

/// The zeros of gap″: a sequence of angles with two alternating distances that add up to a turn.
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

/// 1/(k(k + 1)) and 1/((k + 1)(k + 2)) for k = 20, 18, …, 4: the ratios of terms of the series of `TruncatedSeries`.
const RECIPROCALS: [(f64, f64); 9] = {
    let mut table = [(0.0, 0.0); 9];
    let mut i = 0;
    while i < 9 {
        let k = (20 - 2 * i) as f64;
        table[i] = (1.0 / (k * (k + 1.0)), 1.0 / ((k + 1.0) * (k + 2.0)));
        i += 1;
    }
    table
};

/// sin φ, 1 − cos φ, φ − sin φ and cos φ − 1 + φ²/2, the latter without cancellation.
#[derive(Clone, Copy, Debug)]
struct TruncatedSeries {
    sine: f64,
    versine: f64,
    odd: f64,
    even: f64,
}

impl TruncatedSeries {
    // Within its callers the sums are not computed side by side.
    #[inline(never)]
    fn new(phi: f64) -> Self {
        let square = phi * phi;
        if phi.abs() > 1.0 {
            let (sine, cosine) = sincos(phi);
            let versine = 1.0 - cosine;
            return Self { sine, versine, odd: phi - sine, even: 0.5 * square - versine };
        }
        // φ³/3! − φ⁵/5! + … and φ⁴/4! − φ⁶/6! + …; the terms left out are below 1/23!.
        let (mut odd, mut even) = (1.0, 1.0);
        for (a, b) in RECIPROCALS {
            odd = 1.0 - odd * (square * a);
            even = 1.0 - even * (square * b);
        }
        let (odd, even) = (phi * square / 6.0 * odd, square * square / 24.0 * even);
        Self { sine: phi - odd, versine: 0.5 * square - even, odd, even }
    }
}

impl Flight {
    /// From a state with the rim at the plane. The cosine is that of the decision on flight, so that its sign of
    /// 1 − h cos θ θ′² is found again.
    pub(crate) fn new(body: &Heavy, start: State, take_off: TakeOff) -> Self {
        Self::from_direction(body, start, take_off, libm::sincos(start.theta))
    }

    /// The same with the sine and cosine of the angle.
    pub(crate) fn from_direction(
        body: &Heavy,
        start: State,
        take_off: TakeOff,
        (sin, cos): (f64, f64),
    ) -> Self {
        let flight = Self::with_angles(body, start, take_off, (sin, cos), [f64::NAN; 2]);
        if flight.is_concave() {
            return Self { landing: flight.gap.only_landing(), ..flight };
        }
        let (apex, landing) = flight.gap.extent();
        Self { landing, apex, ..flight }
    }

    /// The same where the angles φ of the landing and of the largest gap are known.
    pub(crate) fn with_angles(
        body: &Heavy,
        start: State,
        take_off: TakeOff,
        (sin, cos): (f64, f64),
        [landing, apex]: [f64; 2],
    ) -> Self {
        let h = body.h;
        let rate = start.theta_rate;
        let travel = if rate < 0.0 { -1.0 } else { 1.0 };
        // −w, of the w that decided on flight.
        let opening = h * (cos * (rate * rate)) - 1.0;
        // The cosine of a large angle may not resolve 1 = h cos θ θ′² at a large rate; the parabola must come down all the same.
        let cos = match take_off {
            TakeOff::Grazing if opening.abs() > LARGEST_ROUNDING => 1.0 / (h * (rate * rate)),
            TakeOff::Grazing | TakeOff::Unloaded | TakeOff::Rising { .. } => cos,
        };
        let gap_rate = match take_off {
            TakeOff::Rising { gap_rate } => gap_rate,
            TakeOff::Grazing | TakeOff::Unloaded => 0.0,
        };
        let in_time = gap_rate > 0.0 && h * (rate * rate) <= 1.0;
        let (clock, spin, opening) = match (in_time, take_off) {
            (true, _) => (1.0, rate.abs(), opening),
            (false, TakeOff::Grazing) => (rate.abs(), 1.0, 0.0),
            (false, TakeOff::Unloaded | TakeOff::Rising { .. }) => (rate.abs(), 1.0, opening / (rate * rate)),
        };
        Self {
            h,
            start,
            vx: start.slip - (1.0 + h * cos) * rate,
            vy: gap_rate - h * sin * rate,
            mass_centre_x: start.x - h * sin,
            gap: Gap {
                h,
                sin: travel * sin,
                cos,
                rise: gap_rate / clock,
                opening,
                spin,
                theta: travel * start.theta,
            },
            clock,
            landing,
            apex,
            settles: false,
        }
    }

    /// Bounces without number that take so much time together, as one flight.
    pub(crate) fn settling(body: &Heavy, start: State, gap_rate: f64, duration: f64) -> Self {
        let (sin, cos) = libm::sincos(start.theta);
        let rate = start.theta_rate;
        let take_off = TakeOff::Rising { gap_rate };
        let flight = Self::with_angles(body, start, take_off, (sin, cos), [duration, 0.0]);
        let opening = body.h * (cos * (rate * rate)) - 1.0;
        let gap = Gap { rise: gap_rate, opening, spin: rate.abs(), ..flight.gap };
        Self { gap, clock: 1.0, settles: true, ..flight }
    }

    /// Whether the gap is concave, and taken in time.
    fn is_concave(&self) -> bool {
        self.gap.rise > 0.0 && self.h * (self.start.theta_rate * self.start.theta_rate) <= 1.0
    }

    /// Whether it stands for bounces without number, by which the hoop settles.
    #[must_use]
    pub const fn settles(&self) -> bool {
        self.settles
    }

    /// Angles φ of the landing and of the largest gap.
    pub(crate) fn angles(&self) -> [f64; 2] {
        [self.landing, self.apex]
    }

    /// Rate of the gap at the start.
    #[must_use]
    pub fn take_off_rate(&self) -> f64 {
        self.gap.rise * self.clock
    }

    /// Time from the start of the flight to the landing.
    #[must_use]
    pub fn duration(&self) -> f64 {
        self.landing / self.clock
    }

    /// Time since the start, and height, of the largest gap between the rim and the plane. Of bounces by which the hoop
    /// settles it is not resolved: zero.
    #[must_use]
    pub fn apex(&self) -> (f64, f64) {
        if self.settles {
            return (0.0, 0.0);
        }
        let apex = if self.is_concave() { self.gap.only_apex(self.landing) } else { self.apex };
        (apex / self.clock, self.gap.value_and_slope(apex).0)
    }

    /// State after the time `elapsed`.
    #[must_use]
    pub fn state(&self, elapsed: f64) -> State {
        let rate = self.start.theta_rate;
        let theta = self.start.theta + rate * elapsed;
        let (sin, cos) = sincos(theta);
        State {
            time: self.start.time + elapsed,
            theta,
            theta_rate: rate,
            slip: self.vx + (1.0 + self.h * cos) * rate,
            x: self.mass_centre_x + self.vx * elapsed + self.h * sin,
        }
    }

    /// Gap under the rim and its rate after the time `elapsed`. Where bounces settle the gap is zero, and its rate that of a
    /// flight without impacts, whose impulses come together at the end.
    #[must_use]
    pub fn gap(&self, elapsed: f64) -> (f64, f64) {
        let (gap, slope) = self.gap.value_and_slope(self.clock * elapsed);
        (if self.settles { 0.0 } else { gap }, self.clock * slope)
    }

    /// Velocity (x̄′, ȳ′) of the mass centre after the time `elapsed`; x̄′ is conserved.
    #[must_use]
    pub fn mass_centre_velocity(&self, elapsed: f64) -> (f64, f64) {
        (self.vx, self.vy - elapsed)
    }

    pub(crate) fn sample(&self, hoop: &Hoop, state: State, gap: (f64, f64)) -> Sample {
        let rate = state.theta_rate;
        let instant = Instant {
            mode: Mode::Flight,
            direction: None,
            accelerations: (0.0, -self.h * libm::sin(state.theta) * rate * rate),
            forces: (0.0, 0.0),
            gap,
        };
        instant.sample(hoop, state)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tangents_of_a_parabola_meet_half_way() {
        // Those of p² at a and b meet at (a + b)/2, where they are a b.
        for (a, b) in [(-1.0, 2.0), (0.5, 3.0), (-4.0, -0.5)] {
            let [from, to] = [a, b].map(|phi: f64| Bound { phi, gap: phi * phi, slope: 2.0 * phi });
            assert!((from.tangents_meet(&to) - a * b).abs() < 1e-14, "{a} {b}");
        }
    }
}
