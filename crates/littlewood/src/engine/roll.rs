//! Rolling of one body, for every orbit at once.
//!
//! The margins (μs N ∓ F) D² of an orbit are linear in its constant K: A(ϑ) + K B(ϑ). The level K*(ϑ) = −A/B at which
//! a margin vanishes belongs to the body. Between its extrema and poles it is monotone, so that on such a piece a margin
//! changes sign at most once *whatever the orbit*: its signs at the ends of the pieces show all slips of an orbit, or
//! prove that there is none. The time is a Gauss sum.
//!
//! Everything is seen in the direction of motion, as in [`crate::modes::rolling`].

use core::f64::consts::{PI, TAU};

use crate::math::bracket::Bracket;
use crate::math::form::{Form, Trigonometric};
use crate::math::trig::sincos;
use crate::mechanics::equations::RollingLaw;
use crate::model::hoop::Hoop;
use crate::model::mode::Direction;
use crate::model::state::State;
use crate::modes::rolling::margin_forms;

use super::duration::duration;

/// A margin, a form of degree six in (cos ϑ/2, sin ϑ/2).
type Margin = Form<7>;

/// Where rolling has slipped, in the frame of motion: on which side, and the angle reduced to a turn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlipPoint {
    pub(super) side: usize,
    pub(super) angle: f64,
}

/// A piece of a turn on which orbits pass from a positive to a negative margin of a side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlipPiece {
    pub(super) left: f64,
    pub(super) right: f64,
    /// The stop at its right end.
    stop: usize,
}

impl SlipPoint {
    /// Of a state at which a hoop slips.
    pub(super) fn of(state: &State, direction: Direction) -> Self {
        let travel = if state.theta_rate < 0.0 { -1.0 } else { 1.0 };
        let theta = travel * state.theta;
        Self { side: side_of(direction, travel), angle: theta - TAU * (theta / TAU).floor() }
    }
}

/// The side of a slip in the frame of motion, of a hoop that travels in the direction `travel`, 1 or −1.
pub(super) fn side_of(direction: Direction, travel: f64) -> usize {
    usize::from((direction == Direction::Positive) == travel.is_sign_positive())
}

/// The direction of a slip to a side.
pub(super) fn direction_of(side: usize, travel: f64) -> Direction {
    if (side == 1) == travel.is_sign_positive() { Direction::Positive } else { Direction::Negative }
}

/// A margin within this part of its terms of zero is solved exactly.
const UNCERTAIN_MARGIN: f64 = 1e-12;

/// The end of a piece.
#[derive(Clone, Copy, Debug)]
struct Stop {
    angle: f64,
    x: f64,
    y: f64,
    /// A and B of the margins of friction to the negative and to the positive side.
    margins: [[f64; 2]; 2],
    /// Constants K of the orbits that hold here on both sides by more than the uncertainty.
    holds: (f64, f64),
}

/// The rolling orbits of one body.
#[derive(Clone, Debug)]
pub(super) struct RollTable {
    law: RollingLaw,
    forms: [[Margin; 2]; 2],
    /// From 0 to 2π, ends included.
    stops: Vec<Stop>,
}

/// End of an orbit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum RollEnd {
    /// Slips at the angle, in the frame of motion.
    Slip { elapsed: f64, theta: f64, theta_rate: f64, point: SlipPoint, stop: usize, direction: (f64, f64) },
    /// Never slips.
    Never,
}

/// The roll that follows a slide, known beforehand but for the proof that the slip is the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct RollAhead {
    /// The stop before which it slips, and the side.
    pub(super) stop: usize,
    pub(super) side: usize,
    /// Angle and time up to the slip.
    pub(super) turned: f64,
    pub(super) elapsed: f64,
}

/// Where an orbit is at the start: its constant, the angle reduced to a turn, and the turns.
#[derive(Clone, Copy, Debug)]
struct Orbit {
    k: f64,
    angle: f64,
    turns: f64,
}

impl Stop {
    fn surely_holds(&self, k: f64) -> bool {
        k > self.holds.0 && k < self.holds.1
    }
}

/// The constants K for which all sums A + K B are positive, narrowed by what is in doubt.
pub(super) fn holds(sums: impl IntoIterator<Item = [f64; 2]>) -> (f64, f64) {
    let mut bounds = (0.0, f64::INFINITY);
    for [a, b] in sums {
        let level = -a / b;
        if b > 0.0 {
            bounds.0 = f64::max(bounds.0, level + 4.0 * UNCERTAIN_MARGIN * level.abs());
        } else if b < 0.0 {
            bounds.1 = f64::min(bounds.1, level - 4.0 * UNCERTAIN_MARGIN * level.abs());
        } else if a <= 0.0 {
            bounds.1 = 0.0;
        }
    }
    bounds
}

/// Which of two margins A + K B is negative, if one is. None where one is in doubt, or both are negative.
pub(super) fn breaks(k: f64, margins: &[[f64; 2]; 2]) -> Option<Option<usize>> {
    let mut broken = None;
    for (side, [a, b]) in margins.iter().enumerate() {
        let margin = a + k * b;
        if margin.abs() <= UNCERTAIN_MARGIN * (a.abs() + (k * b).abs()) {
            return None;
        }
        if margin < 0.0 {
            if broken.is_some() {
                return None;
            }
            broken = Some(side);
        }
    }
    Some(broken)
}

impl RollTable {
    /// Prepares the orbits of a heavy hoop; none of a massless one.
    pub(super) fn new(hoop: &Hoop) -> Option<Self> {
        let forms = margin_forms(hoop)?;
        let mut angles = vec![0.0, 0.5 * PI, PI, 1.5 * PI, TAU];
        for form in &forms {
            // The poles of −A/B, and its extrema, the zeros of A′B − AB′.
            let [a, b] = [0, 1].map(|k: usize| Trigonometric::from_form(&form[k]));
            angles.extend(b.sign_changes());
            angles.extend(a.derivative().times(&b).minus(&a.times(&b.derivative())).sign_changes());
        }
        angles.sort_by(f64::total_cmp);
        angles.dedup_by(|a, b| *a - *b < 1e-9);
        let stops = angles
            .into_iter()
            .map(|angle| {
                let (y, x) = sincos(0.5 * angle);
                let margins = [0, 1].map(|i: usize| [0, 1].map(|k: usize| forms[i][k].value([x, y])));
                Stop { angle, x, y, margins, holds: holds(margins) }
            })
            .collect();
        let law = RollingLaw::new(hoop);
        Some(Self { law, forms, stops })
    }

    /// The equations.
    pub(super) const fn law(&self) -> &RollingLaw {
        &self.law
    }

    /// θ′² where the margin of a side vanishes on the orbit that reaches it at this angle.
    pub(super) fn limit(&self, side: usize, angle: f64) -> Option<f64> {
        let (y, x) = libm::sincos(0.5 * angle);
        let [a, b] = &self.forms[side];
        let k = -a.value([x, y]) / b.value([x, y]);
        let d = self.law.denominator(angle);
        k.is_finite().then_some((k - d) / d)
    }

    /// The same with its derivative by the angle.
    pub(super) fn limit_and_slope(&self, side: usize, angle: f64) -> (f64, f64) {
        let (y, x) = libm::sincos(0.5 * angle);
        let [(a, a_slope), (b, b_slope)] =
            [0, 1].map(|i: usize| self.forms[side][i].value_and_slope([x, y], [-0.5 * y, 0.5 * x]));
        let d = self.law.denominator(angle);
        let d_slope = -4.0 * self.law.offset * x * y;
        let k = -a / b;
        let k_slope = -(a_slope + k * b_slope) / b;
        let u = (k - d) / d;
        (u, (k_slope - (1.0 + u) * d_slope) / d)
    }

    /// The angles at which θ′² of [`RollTable::limit`] vanishes, and those at which it has an extremum.
    pub(super) fn rests_and_extrema(&self, side: usize) -> (Vec<f64>, Vec<f64>) {
        let [a, b] = [0, 1].map(|i: usize| Trigonometric::from_form(&self.forms[side][i]));
        let b = b.times(&self.law.denominator_polynomial());
        let extrema = a.derivative().times(&b).minus(&a.times(&b.derivative()));
        (a.plus(&b).sign_changes(), extrema.sign_changes())
    }

    /// 1/K of the orbit whose margin of a side vanishes at this angle.
    pub(super) fn inverse_level(&self, side: usize, angle: f64) -> f64 {
        let (y, x) = libm::sincos(0.5 * angle);
        let [a, b] = &self.forms[side];
        -b.value([x, y]) / a.value([x, y])
    }

    /// The pieces of a turn on which orbits pass from a positive to a negative margin of a side.
    pub(super) fn slips(&self, side: usize) -> Vec<SlipPiece> {
        let mut slips = Vec::new();
        for (stop, pair) in (1..).zip(self.stops.windows(2)) {
            let (left, right) = (pair[0].angle, pair[1].angle);
            let Some(u) = self.limit(side, 0.5 * (left + right)) else { continue };
            let k = self.law.denominator(0.5 * (left + right)) * (1.0 + u);
            // The margin for the level at the middle, before and behind: it falls through zero there or rises, as at all levels of the
            // piece, those among them that no orbit has (u < 0).
            let margin = |angle: f64| {
                let (y, x) = libm::sincos(0.5 * angle);
                let [a, b] = &self.forms[side];
                a.value([x, y]) + k * b.value([x, y])
            };
            if margin(left) > margin(right) {
                slips.push(SlipPiece { left, right, stop });
            }
        }
        slips
    }

    /// The angle on a piece at which the orbit with the constant K slips.
    pub(super) fn slip_on(&self, piece: &SlipPiece, side: usize, k: f64) -> Option<f64> {
        let stop = &self.stops[piece.stop];
        k.is_finite().then(|| self.slip(k, piece.left, stop, side).0)
    }

    /// Follows an orbit on which rolling holds at the start, perhaps just so (`on_limit`), from an angle ϑ that grows at a rate ϑ′. None where a
    /// margin is in doubt or the orbit comes close to a standstill before it slips. If the first slip is the one `ahead`,
    /// it need not be computed.
    pub(super) fn follow(
        &self,
        (theta, theta_rate): (f64, f64),
        cos: f64,
        on_limit: bool,
        ahead: Option<&RollAhead>,
    ) -> Option<RollEnd> {
        let turns = (theta / TAU).floor();
        let angle = theta - TAU * turns;
        let k = self.law.denominator_at(cos) * (1.0 + theta_rate * theta_rate);
        let over_top = k - self.law.top;
        let end = if over_top > 1e-9 * k {
            self.rotation(Orbit { k, angle, turns }, on_limit, ahead)
        } else if over_top < -1e-9 * k {
            self.libration(k)
        } else {
            None
        };
        // An orbit on the limit is beyond it on the other side.
        end.filter(|end| !(on_limit && *end == RollEnd::Never))
    }

    fn rotation(&self, orbit: Orbit, on_limit: bool, ahead: Option<&RollAhead>) -> Option<RollEnd> {
        let first = self.stops.partition_point(|stop| stop.angle <= orbit.angle);
        let laps =
            (first..self.stops.len()).map(|stop| (stop, 0.0)).chain((0..first).map(|stop| (stop, TAU)));
        for (stop, lap) in laps {
            if self.stops[stop].surely_holds(orbit.k) {
                continue;
            }
            if let Some(side) = breaks(orbit.k, &self.stops[stop].margins)? {
                // From the limit on a margin grows, and has no second zero on the same piece.
                if on_limit && stop == first && lap == 0.0 {
                    return None;
                }
                let (found, direction, elapsed) = match ahead {
                    Some(ahead) if ahead.stop == stop && ahead.side == side => {
                        let found = orbit.angle + ahead.turned - lap;
                        (found, sincos(found), ahead.elapsed)
                    }
                    _ => {
                        let begin = stop.checked_sub(1).map_or(0.0, |before| self.stops[before].angle);
                        let begin = if lap == 0.0 { begin.max(orbit.angle) } else { begin };
                        let (found, direction) = self.slip(orbit.k, begin, &self.stops[stop], side);
                        (found, direction, self.time(orbit.k, orbit.angle, found + lap)?)
                    }
                };
                let d = self.law.denominator_at(direction.1);
                return Some(RollEnd::Slip {
                    elapsed,
                    theta: TAU * orbit.turns + (found + lap),
                    theta_rate: ((orbit.k - d) / d).sqrt(),
                    point: SlipPoint { side, angle: found },
                    stop,
                    direction,
                });
            }
        }
        Some(RollEnd::Never)
    }

    /// Only the proof that nothing slips between the turning points: a slip on the way is solved exactly.
    fn libration(&self, k: f64) -> Option<RollEnd> {
        // cos of the turning angle, where K = D.
        let cos = (k - self.law.mean_denominator()) / (2.0 * self.law.offset);
        if !(cos > -1.0 && cos < 1.0) {
            return None;
        }
        let (x, y) = ((0.5 * (1.0 + cos)).sqrt(), (0.5 * (1.0 - cos)).sqrt());
        for x in [x, -x] {
            let margins = [0, 1].map(|i: usize| [0, 1].map(|k: usize| self.forms[i][k].value([x, y])));
            if breaks(k, &margins)?.is_some() {
                return None;
            }
        }
        // The arc between the turning points is where cos ϑ is below that of them.
        for stop in &self.stops {
            let inside = stop.x * stop.x < x * x;
            if inside && !stop.surely_holds(k) && breaks(k, &stop.margins)?.is_some() {
                return None;
            }
        }
        Some(RollEnd::Never)
    }

    /// The slip between `begin` and the end of the piece at `stop`, as a root in the half angle: the angle, its sine
    /// and its cosine.
    fn slip(&self, k: f64, begin: f64, stop: &Stop, side: usize) -> (f64, (f64, f64)) {
        let [a, b] = &self.forms[side];
        let form: [f64; 7] = core::array::from_fn(|i| a.0[i] + k * b.0[i]);
        // In a chart of the half angle without a pole on the piece: pieces end at odd multiples of π/2.
        let middle = 0.5 * (begin + stop.angle);
        let steep = middle > 0.5 * PI && middle < 1.5 * PI;
        let (y0, x0) = sincos(0.5 * begin);
        let (low, high) = if steep { (x0 / y0, stop.x / stop.y) } else { (y0 / x0, stop.y / stop.x) };
        let horner = |t: f64| {
            let fold = |(value, slope): (f64, f64), c: &f64| (value * t + c, slope * t + value);
            if steep { form.iter().fold((0.0, 0.0), fold) } else { form.iter().rev().fold((0.0, 0.0), fold) }
        };
        // The margin has the sign of the form, or the other, and may be seen from behind.
        let falls = if (horner(high).0 < 0.0) == (low < high) { 1.0 } else { -1.0 };
        let t = Bracket { low: low.min(high), high: low.max(high) }.refine_from_secant(|t| {
            let (value, slope) = horner(t);
            (falls * value, falls * slope)
        });
        let (x, y) = if steep { (t, 1.0) } else { (1.0, t) };
        let (x, y) = if y < 0.0 || (y == 0.0 && x < 0.0) { (-x, -y) } else { (x, y) };
        let length = x * x + y * y;
        (2.0 * libm::atan2(y, x), (2.0 * x * y / length, (x * x - y * y) / length))
    }

    /// The time from angle to angle on an orbit over the top.
    fn time(&self, k: f64, from: f64, to: f64) -> Option<f64> {
        let (y, x) = sincos(0.5 * from);
        duration(self.law.bottom, (k - self.law.top, 4.0 * self.law.offset), (-x, y), 0.5 * (to - from))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::hoop::HoopParameters;

    #[test]
    fn the_limit_has_its_slope_its_zeros_and_its_extrema() {
        let mut found = (0, 0);
        for (mass_ratio, inertia, mu_s) in [(1.0, 1.0, 0.5), (2.0, 0.5, 0.2), (0.1, 0.07, 0.09)] {
            let hoop = HoopParameters::new(mass_ratio, 0.9, inertia).with_friction(mu_s, mu_s);
            let roll = RollTable::new(&Hoop::new(hoop).unwrap()).unwrap();
            for side in [0, 1] {
                let mut compared = 0;
                for k in 1..200 {
                    let angle = TAU / 200.0 * f64::from(k);
                    let (u, slope) = roll.limit_and_slope(side, angle);
                    assert_eq!(roll.limit(side, angle), Some(u));
                    let [before, after] = [-1e-6, 1e-6].map(|step| roll.limit(side, angle + step).unwrap());
                    let quotient = (after - before) / 2e-6;
                    if quotient.abs() < 100.0 {
                        assert!(
                            (slope - quotient).abs() < 1e-6 * (1.0 + u * u),
                            "{angle}: {slope} {quotient}"
                        );
                        compared += 1;
                    }
                }
                assert!(compared > 100, "{compared}");
                let (rests, extrema) = roll.rests_and_extrema(side);
                found = (found.0 + rests.len(), found.1 + extrema.len());
                for angle in rests {
                    assert!(roll.limit(side, angle).unwrap().abs() < 1e-12, "{angle}");
                }
                for angle in extrema {
                    let (u, slope) = roll.limit_and_slope(side, angle);
                    assert!(slope.abs() < 1e-11 * (1.0 + u * u), "{angle}: {u} {slope}");
                }
            }
        }
        assert!(found.0 > 4 && found.1 > 4, "{found:?}");
    }

    #[test]
    fn a_slip_that_is_known_beforehand_is_taken_only_at_its_stop_and_side() {
        let roll = RollTable::new(&Hoop::figure_2(0.5, 0.4).unwrap()).unwrap();
        let mut slips = 0;
        for k in 0..60 {
            let (theta, rate) = (0.1 * f64::from(k), 1.9);
            let follow = |ahead: Option<RollAhead>| {
                roll.follow((theta, rate), libm::cos(theta), false, ahead.as_ref())
            };
            let found = follow(None);
            let Some(RollEnd::Slip { stop, point, .. }) = found else { continue };
            slips += 1;
            let known = RollAhead { stop, side: point.side, turned: 0.25, elapsed: 7.0 };
            assert_eq!(follow(Some(RollAhead { stop: stop + 1, ..known })), found);
            assert_eq!(follow(Some(RollAhead { side: 1 - known.side, ..known })), found);
            let Some(RollEnd::Slip { elapsed, .. }) = follow(Some(known)) else { panic!("{theta}") };
            assert_eq!(elapsed, 7.0);
        }
        assert!(slips > 20, "{slips}");
    }

    #[test]
    fn the_margin_that_is_negative_is_told_where_it_is_clear() {
        // 1 − K and 3 + K, with levels next to the zero of the first.
        let margins = [[1.0, -1.0], [3.0, 1.0]];
        for (k, broken) in [
            (0.5, Some(None)),
            (1.0 - 1e-11, Some(None)),
            (1.0 - 1e-12, None),
            (1.0 + 1e-12, None),
            (1.0 + 1e-11, Some(Some(0))),
            (2.0, Some(Some(0))),
        ] {
            assert_eq!(breaks(k, &margins), broken, "{k}");
            let [first, second] = margins;
            let swapped = broken.map(|broken| broken.map(|side: usize| 1 - side));
            assert_eq!(breaks(k, &[second, first]), swapped, "{k}");
        }
        assert_eq!(breaks(2.0, &[[1.0, -1.0], [1.0, -1.0]]), None, "both");
    }

    #[test]
    fn an_orbit_on_the_limit_is_not_said_to_hold() {
        // Margins K − 2 and 6 − 2 K, both positive for 2 < K < 3.
        let (least, most) = holds([[-2.0, 1.0], [6.0, -2.0]]);
        assert!(least > 2.0 * (1.0 + UNCERTAIN_MARGIN) && least < 2.0 + 1e-10, "{least:e}");
        assert!(most < 3.0 * (1.0 - UNCERTAIN_MARGIN) && most > 3.0 - 1e-10, "{most:e}");
        // A margin that no orbit changes.
        assert_eq!(holds([[1.0, 0.0], [1.0, 0.0]]), (0.0, f64::INFINITY));
        assert_eq!(holds([[1.0, 0.0], [-1.0, 0.0]]).1, 0.0);
    }
}
