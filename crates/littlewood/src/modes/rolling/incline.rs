//! Rolling on a slope (docs/theory/slope.md): the kinetic energy as a function of the angle, time
//! as a quadrature, and the end of rolling.
//!
//! In the direction of motion, in which the angle ϑ increases, with T = ± tan α, D θ′² obeys
//!
//! ```text
//! G = D ϑ′² = G0 + 2 [ℓ̂ (cos ϑ0 − cos ϑ) + T (m (ϑ − ϑ0) + ℓ̂ (sin ϑ − sin ϑ0))]
//! ```

use core::f64::consts::{FRAC_PI_8, PI, TAU};
use core::ops::Range;

use crate::math::bernstein::remove_rounding_at_start;
use crate::math::bracket::{Bracket, RootStep, last_of};
use crate::math::panel::{ROUNDING, TAIL_TOLERANCE, integral};
use crate::math::series::{Series, crossing};
use crate::math::trig::{Angle, sincos, without_turns};
use crate::mechanics::RollingLaw;
use crate::model::{Hoop, MAX_COORDINATE, SlipDirection};

use super::boundary::{RollingEnd, RollingLimit, Stiction, in_body_frame};
use super::margin_series::MarginSeries;
use super::recurrence::Recurrence;

/// How often a panel is halved before its series are computed, which cost some ten times as much as
/// a look at the margins.
const MAX_SCREEN_DEPTH: u32 = 3;

/// Number of terms summed one by one before the formula of Euler and Maclaurin: its first omitted
/// term is then below 1e-16 of a term.
const SINGLE_TERMS: u32 = 32;

/// A motion whose turning point is nearer begins there: on the way energies would underflow, and
/// their inverses overflow. Parts ε of ε of it are normal numbers.
const MIN_TURNING_DISTANCE: f64 = f64::MIN_POSITIVE / (f64::EPSILON * f64::EPSILON);

/// Turning points farther away are ignored. No motion reaches them: that would take a rate of 1e50 for
/// the longest time, 1e150. Beyond them the time may overflow, and the fall of a turn underflow.
const MAX_TURNING_DISTANCE: f64 = 1e200;

/// The rolling orbit of a hoop on a slope through a state.
#[derive(Clone, Copy, Debug)]
pub(super) struct Incline {
    /// Direction of motion at the start.
    heading: f64,
    /// Up to the first turning point.
    first: Leg,
    /// From there, the other way.
    back: Option<Leg>,
    rests: bool,
}

/// A part of an orbit in one direction, in which its angle increases.
#[derive(Clone, Copy, Debug)]
struct Leg {
    margins: MarginSeries,
    /// ϑ at the beginning, without whole turns, and these.
    angle: f64,
    turned: f64,
    /// G at the beginning; 0 at a turning point.
    kinetic: f64,
    /// The turning point, if any.
    turning_distance: Option<Distance>,
    /// The distance of the turning point behind the beginning, if it is in the same turn.
    behind: Option<f64>,
}

/// The beginning of a leg: its angle is the sum of whole turns, in rad, and a rest.
#[derive(Clone, Copy, Debug)]
struct LegStart {
    turned: f64,
    rest: f64,
    /// G.
    kinetic: f64,
}

/// A distance in whole turns and a rest: each number is computed from the rest, which resolves it
/// however many turns there are.
#[derive(Clone, Copy, Debug)]
struct Distance {
    turns: f64,
    rest: f64,
}

impl Distance {
    fn total(&self) -> f64 {
        TAU * self.turns + self.rest
    }
}

/// A point of a leg: the distances from its beginning and to its turning point.
#[derive(Clone, Copy, Debug)]
struct LegPoint {
    passed: Distance,
    left: f64,
}

impl Incline {
    pub(super) fn new(hoop: &Hoop, law: RollingLaw, theta: f64, theta_rate: f64) -> Self {
        let orbit = Self::with_rate(hoop, law, theta, theta_rate);
        let reach = orbit.first.turning_distance;
        if orbit.first.kinetic > 0.0 && reach.is_some_and(|it| it.total() < MIN_TURNING_DISTANCE) {
            return Self::with_rate(hoop, law, theta, 0.0);
        }
        orbit
    }

    fn with_rate(hoop: &Hoop, law: RollingLaw, theta: f64, theta_rate: f64) -> Self {
        let (sin, cos) = libm::sincos(theta);
        let kinetic = law.denominator(theta) * theta_rate * theta_rate;
        // At a turning point gravity decides the direction of motion.
        let pulled = law.offset * sin + law.tilt * (law.mass + law.offset * cos);
        let moving = if kinetic == 0.0 { pulled } else { theta_rate };
        let heading = SlipDirection::of_sign(moving).map_or(1.0, SlipDirection::sign);
        let margins = MarginSeries::new(hoop, heading);
        let first = Leg::new(
            margins,
            LegStart {
                turned: 0.0,
                rest: heading * theta,
                kinetic,
            },
        );
        let back = first.turning_distance.map(|reach| {
            let turned = first.turned + TAU * reach.turns;
            Leg::new(
                margins.reversed(),
                LegStart {
                    turned: -turned,
                    rest: -(first.angle + reach.rest),
                    kinetic: 0.0,
                },
            )
        });
        // Both turning points round to the angle of the start.
        let width = back
            .and_then(|back| back.turning_distance)
            .map_or(f64::INFINITY, |reach| reach.total());
        let rests = moving == 0.0 || width <= f64::EPSILON * theta.abs();
        Self {
            heading,
            first,
            back,
            rests,
        }
    }

    /// Whether the hoop is unbalanced and leaves the bounds of θ: rolling ends beyond them if
    /// nowhere else.
    pub(super) fn leaves_bounds(&self) -> bool {
        !self.rests
            && (self.first.leaves_bounds() || self.back.is_some_and(|back| back.leaves_bounds()))
    }

    pub(super) fn position(&self, elapsed: f64) -> (f64, f64) {
        if self.rests {
            return (self.heading * self.first.start(), 0.0);
        }
        let (leg, point, way) = self.at(elapsed);
        let rate = (leg.kinetic_at(point) / leg.denominator(point)).sqrt();
        let frame = self.frame(&leg);
        (frame * leg.angle_at(point), frame * way * rate)
    }

    /// The sign of θ in the frame of a leg.
    fn frame(&self, leg: &Leg) -> f64 {
        if leg.law().tilt == self.first.law().tilt {
            self.heading
        } else {
            -self.heading
        }
    }

    /// The leg and the point after a time, and the direction of motion in the frame of the leg.
    fn at(&self, elapsed: f64) -> (Leg, LegPoint, f64) {
        let Some(back) = self.back else {
            return (self.first, self.first.point_at(elapsed), 1.0);
        };
        let outward = self.first.whole();
        if elapsed <= outward {
            return (self.first, self.first.point_at(elapsed), 1.0);
        }
        let since = elapsed - outward;
        if back.turning_distance.is_none() {
            return (back, back.point_at(since), 1.0);
        }
        let half = back.whole();
        let within = since - 2.0 * half * (since / (2.0 * half)).floor();
        if within <= half {
            (back, back.point_at(within), 1.0)
        } else {
            (back, back.point_at(2.0 * half - within), -1.0)
        }
    }

    /// `from_limit` if |F| = μs N at the start and static friction holds after it.
    pub(super) fn end(&self, from_limit: bool) -> Option<RollingEnd> {
        if self.rests {
            return None;
        }
        let (leg, before, (point, limit)) = match self.first.end(from_limit) {
            Some(end) => (self.first, 0.0, end),
            None => {
                let back = self.back.filter(|_| !self.first.leaves_bounds())?;
                (back, self.first.whole(), back.end(false)?)
            }
        };
        let frame = self.frame(&leg);
        let rate = (leg.kinetic_at(point) / leg.denominator(point)).sqrt();
        Some(RollingEnd {
            elapsed: before + leg.time(point),
            theta: frame * leg.angle_at(point),
            theta_rate: frame * rate,
            limit: in_body_frame(limit, frame),
        })
    }

    pub(super) fn recurrence(&self) -> Recurrence {
        if self.rests {
            return Recurrence::Rest;
        }
        let Some((back, reach)) = self
            .back
            .and_then(|back| Some((back, back.turning_distance?)))
        else {
            // The centre moves by −θ.
            let law = self.first.law();
            let acceleration = -law.mass * (self.heading * law.tilt) / law.mean_denominator();
            return Recurrence::Downhill { acceleration };
        };
        let frame = self.frame(&back);
        // From rest the motion comes back to its start.
        let far = if self.first.kinetic == 0.0 {
            -self.first.start()
        } else {
            back.start() + reach.total()
        };
        let [from, to] = [back.start(), far].map(|angle| frame * angle);
        Recurrence::Libration {
            period: 2.0 * back.whole(),
            theta_min: from.min(to),
            theta_max: from.max(to),
        }
    }

    pub(super) fn stiction(&self) -> Stiction {
        let leg = &self.first;
        let d = leg.denominator(leg.point(0.0, 0.0));
        let negative = leg
            .margins(leg.point(0.0, 0.0))
            .filter_map(|(margin, limit)| {
                let first = if self.rests {
                    Some(&margin[0])
                } else {
                    margin.iter().find(|c| **c != 0.0)
                };
                if first.is_none_or(|first| *first >= 0.0) {
                    None
                } else {
                    Some((margin[0] / (d * d), limit))
                }
            });
        Stiction::of(negative, self.heading)
    }
}

impl Leg {
    /// 2 [ℓ̂ (cos a − cos b) + T (m (b − a) + ℓ̂ (sin b − sin a))] for b = a + `by`.
    fn gain(&self, from: f64, by: f64) -> f64 {
        self.law()
            .gain(Angle::of(from + 0.5 * by), 2.0 * libm::sin(0.5 * by), by)
    }

    fn new(margins: MarginSeries, start: LegStart) -> Self {
        let LegStart {
            turned,
            rest,
            kinetic,
        } = start;
        let angle = without_turns(rest);
        let leg = Self {
            margins,
            angle,
            turned: turned + (rest - angle),
            kinetic,
            turning_distance: None,
            behind: Some(0.0),
        };
        let behind = || {
            let back = Self {
                margins: margins.reversed(),
                angle: -angle,
                ..leg
            };
            back.turning_point()
                .filter(|reach| reach.turns == 0.0)
                .map(|reach| reach.rest)
        };
        let behind = if kinetic == 0.0 { Some(0.0) } else { behind() };
        Self {
            turning_distance: leg.turning_point(),
            behind,
            ..leg
        }
    }

    /// The law, with tan α positive downhill.
    const fn law(&self) -> &RollingLaw {
        &self.margins.law
    }

    /// ϑ at the beginning.
    fn start(&self) -> f64 {
        self.turned + self.angle
    }

    /// How far it goes at least within the bounds of θ.
    fn distance_to_bounds(&self) -> f64 {
        MAX_COORDINATE - self.start().abs()
    }

    fn leaves_bounds(&self) -> bool {
        self.law().offset > 0.0
            && self
                .turning_distance
                .is_none_or(|reach| reach.total() > self.distance_to_bounds())
    }

    fn angle_at(&self, point: LegPoint) -> f64 {
        (self.turned + TAU * point.passed.turns) + (self.angle + point.passed.rest)
    }

    /// The gain of G in a turn.
    fn fall(&self) -> f64 {
        4.0 * PI * self.law().mass * self.law().tilt
    }

    /// Half the slope of G.
    fn slope(&self, rest: f64) -> f64 {
        let RollingLaw {
            offset, mass, tilt, ..
        } = *self.law();
        let (sin, cos) = sincos(self.angle + rest);
        offset * sin + tilt * (mass + offset * cos)
    }

    fn point(&self, turns: f64, rest: f64) -> LegPoint {
        let left = |reach: Distance| TAU * (reach.turns - turns) + (reach.rest - rest);
        LegPoint {
            passed: Distance { turns, rest },
            left: self.turning_distance.map_or(f64::INFINITY, left),
        }
    }

    fn denominator(&self, point: LegPoint) -> f64 {
        self.law()
            .denominator_of(Angle::of(self.angle + point.passed.rest))
    }

    /// G, from the nearer end.
    fn kinetic_at(&self, point: LegPoint) -> f64 {
        self.kinetic_and_terms(point).0
    }

    /// G, and the sum of the sizes of its terms.
    fn kinetic_and_terms(
        &self,
        LegPoint {
            passed: Distance { turns, rest },
            left,
        }: LegPoint,
    ) -> (f64, f64) {
        let RollingLaw {
            offset, mass, tilt, ..
        } = *self.law();
        let (begins, from, by, turns) = match self.turning_distance {
            Some(reach) if left < TAU * turns + rest => {
                let whole = (left / TAU).floor();
                (0.0, self.angle + reach.rest, TAU * whole - left, -whole)
            }
            Some(_) | None => (self.kinetic, self.angle, rest, turns),
        };
        let fall = turns * self.fall();
        let kinetic = begins + self.gain(from, by) + fall;
        let swing = offset * (1.0 + tilt.abs()) * by.abs().min(2.0) + (tilt * mass * by).abs();
        (kinetic.max(0.0), begins + 2.0 * swing + fall.abs())
    }

    /// √(D/G) at a point, and its rounding as a part of it.
    fn slowness(&self, point: LegPoint) -> (f64, f64) {
        let (kinetic, terms) = self.kinetic_and_terms(point);
        let angle = self.angle + point.passed.rest;
        let direction = Angle::of(angle);
        let d = self.law().denominator_of(direction);
        // The angle itself is rounded, which tells next to the bottom of a light hoop.
        let of_angle = angle.abs() * (self.law().offset * direction.sin).abs() / d;
        (
            (d / kinetic).sqrt(),
            ROUNDING * (terms / kinetic + of_angle),
        )
    }

    /// The first zero of G ahead.
    fn turning_point(&self) -> Option<Distance> {
        let Self {
            margins: MarginSeries { law, .. },
            angle,
            kinetic,
            ..
        } = *self;
        let pull = law.tilt;
        let value = |turns: f64, rest: f64| kinetic + self.gain(angle, rest) + turns * self.fall();
        let root = |turns: f64, low: f64, high: f64| {
            let rest = Bracket { low, high }.iterate(high, |rest| {
                RootStep::newton(rest, (value(turns, rest), 2.0 * self.slope(rest)))
            });
            if rest < 0.0 {
                Distance {
                    turns: turns - 1.0,
                    rest: rest + TAU,
                }
            } else {
                Distance { turns, rest }
            }
        };
        let Some([unstable, stable]) = law.equilibria() else {
            // G is monotone, within the swing of its periodic part of a straight line.
            let swing = 4.0 * law.offset * (1.0 + pull * pull).sqrt();
            let per = -2.0 * law.mass * pull;
            let [low, high] = [((kinetic - swing) / per).max(0.0), (kinetic + swing) / per];
            return (pull < 0.0 && high < MAX_TURNING_DISTANCE).then(|| {
                let turns = (low / TAU).floor();
                // Of 2⁵³ turns and more, doubles do not tell the point in the last.
                let rest = (low - TAU * turns).clamp(0.0, TAU);
                root(turns, rest, rest + (high - low) + (1e-15 * high).min(TAU))
            });
        };
        let ahead = |of: f64| (of - angle).rem_euclid(TAU);
        let (lowest, highest) = (ahead(unstable), ahead(stable));
        // At a turning point G first rises to its maximum.
        let low = if kinetic == 0.0 { highest } else { 0.0 };
        if low > lowest {
            return Some(Distance {
                turns: 0.0,
                rest: 0.0,
            });
        }
        if value(0.0, lowest) < 0.0 {
            return Some(root(0.0, low, lowest));
        }
        if pull >= 0.0 {
            return None;
        }
        // Each minimum is lower than the one before by the fall of a turn.
        let mut turns = (value(0.0, lowest) / -self.fall()).floor() + 1.0;
        if TAU * turns >= MAX_TURNING_DISTANCE {
            return None;
        }
        if value(turns - 1.0, lowest) < 0.0 {
            turns -= 1.0;
        } else if value(turns, lowest) >= 0.0 {
            turns += 1.0;
        }
        Some(root(turns, lowest - TAU, lowest))
    }

    /// Time from the beginning to the turning point; infinite without one.
    fn whole(&self) -> f64 {
        self.turning_distance.map_or(f64::INFINITY, |passed| {
            self.time(LegPoint { passed, left: 0.0 })
        })
    }

    /// Time from the beginning to a point.
    fn time(&self, point: LegPoint) -> f64 {
        let turns = point.passed.turns;
        if turns < 3.0 {
            let passed = Distance {
                turns: 0.0,
                rest: point.passed.total(),
            };
            return self.time_between(0.0, LegPoint { passed, ..point });
        }
        // The first turn, whose kinetic energy may vanish, then turns that differ by the gain of a
        // turn, then the rest.
        let slowest = if self.law().tilt < 0.0 {
            turns - 1.0
        } else {
            1.0
        };
        let summed = integral(TAIL_TOLERANCE, 0.0..TAU, |rest| {
            let point = self.point(slowest, rest);
            let (slowness, rounding) = self.slowness(point);
            let kinetic = self.kinetic_at(point);
            let sum = sum_of_roots(kinetic, self.fall().abs(), turns - 1.0);
            (slowness * kinetic.sqrt() * sum, rounding)
        });
        self.time_between(0.0, self.point(0.0, TAU)) + summed + self.time_between(0.0, point)
    }

    /// Time between a point in the same turn, at this rest, and a point.
    fn time_between(&self, from: f64, to: LegPoint) -> f64 {
        let turns = to.passed.turns;
        let at = |rest: f64| self.slowness(self.point(turns, rest));
        let at_root = |s: f64, (slowness, rounding): (f64, f64)| (2.0 * s * slowness, rounding);
        // Next to a turning point the square root of the distance is the variable.
        let end = to.passed.rest + to.left;
        let middle = if end.is_finite() {
            0.5 * (from + end)
        } else {
            f64::INFINITY
        };
        let first_end = to.passed.rest.min(middle);
        let mut time = match self.behind {
            Some(behind) if turns == 0.0 && from == 0.0 && behind <= first_end => {
                let near = first_end.min(PI);
                let roots = behind.sqrt()..(behind + near).sqrt();
                integral(TAIL_TOLERANCE, roots, |s| at_root(s, at(s * s - behind)))
                    + integral(TAIL_TOLERANCE, near..first_end, at)
            }
            Some(_) | None => integral(TAIL_TOLERANCE, from..first_end, at),
        };
        if to.passed.rest > middle {
            let near = (end - middle).min(PI).max(to.left);
            let back = |left: f64| {
                self.slowness(LegPoint {
                    passed: Distance {
                        turns,
                        rest: end - left,
                    },
                    left,
                })
            };
            time += integral(TAIL_TOLERANCE, middle..end - near, at);
            time += integral(TAIL_TOLERANCE, to.left.sqrt()..near.sqrt(), |s| {
                at_root(s, back(s * s))
            });
        }
        time
    }

    /// The point after a time, by inversion of the increasing function of the time.
    fn point_at(&self, time: f64) -> LegPoint {
        if time <= 0.0 {
            return self.point(0.0, 0.0);
        }
        let most = self
            .turning_distance
            .map_or(f64::INFINITY, |reach| reach.turns);
        let begins = |turns: f64| self.time(self.point(turns, 0.0));
        let (mut turns, mut beyond) = (0.0, 1.0);
        while beyond <= most && begins(beyond) <= time && beyond < f64::MAX / 4.0 {
            (turns, beyond) = (beyond, 2.0 * beyond);
        }
        let turns = last_of(turns, beyond.min(most + 1.0), |turns| begins(turns) <= time);
        let is_behind = self.kinetic == 0.0 && turns == 0.0;
        let ahead = self
            .turning_distance
            .filter(|reach| reach.turns <= turns)
            .map(|reach| reach.rest);
        let variable = Variable::new(is_behind, ahead);
        let point = |p: f64| {
            let Stretched {
                rest,
                left,
                stretch,
            } = variable.at(p);
            let point = match left {
                Some(left) => LegPoint {
                    passed: Distance { turns, rest },
                    left,
                },
                None => self.point(turns, rest),
            };
            (point, stretch)
        };
        let high = variable.end();
        let p = Bracket { low: 0.0, high }.iterate(0.5 * high, |p| {
            let (point, stretch) = point(p);
            let value = time - self.time(point);
            let rate = (self.kinetic_at(point) / self.denominator(point)).sqrt() / stretch;
            RootStep {
                value,
                step: value * rate,
                last: f64::EPSILON * p.abs(),
            }
        });
        point(p).0
    }

    /// The margins about a point, each with the limit that is reached when it becomes negative.
    fn margins(&self, point: LegPoint) -> impl Iterator<Item = (Series, RollingLimit)> {
        let direction = Angle::of(self.angle + point.passed.rest);
        self.margins
            .at(direction, self.kinetic_at(point))
            .into_iter()
            .flatten()
    }

    /// Whether no limit is reached within a distance of a point, as far as [`MarginSeries::holds_about`]
    /// tells of it, or of its halves, `depth` times.
    fn holds_about(&self, turns: f64, rest: f64, reach: f64, depth: u32) -> bool {
        let kinetic = self.kinetic_at(self.point(turns, rest));
        self.margins
            .holds_about(Angle::of(self.angle + rest), kinetic, reach)
            || (depth > 0
                && [-0.5, 0.5].into_iter().all(|side| {
                    self.holds_about(turns, rest + side * reach, 0.5 * reach, depth - 1)
                }))
    }

    /// The first crossing of a limit in a turn, between two rests; `from_limit` if that nearest to
    /// zero at the first is zero there.
    fn crossing(
        &self,
        turns: f64,
        rests: Range<f64>,
        from_limit: bool,
    ) -> Option<(LegPoint, RollingLimit)> {
        let Range {
            start: from,
            end: to,
        } = rests;
        let pieces = ((to - from) / FRAC_PI_8).ceil().max(1.0);
        let width = (to - from) / pieces;
        (0..pieces as u32).find_map(|piece| {
            let begin = from + width * f64::from(piece);
            if self.holds_about(turns, begin + 0.5 * width, 0.5 * width, MAX_SCREEN_DEPTH) {
                return None;
            }
            let mut margins: Vec<_> = self.margins(self.point(turns, begin)).collect();
            if from_limit && piece == 0 {
                let nearest = margins
                    .iter_mut()
                    .min_by(|a, b| a.0[0].abs().total_cmp(&b.0[0].abs()));
                if let Some((margin, _)) = nearest {
                    margin[0] = 0.0;
                }
                for (margin, _) in &mut margins {
                    remove_rounding_at_start(margin);
                }
            }
            let crossings = margins
                .into_iter()
                .filter_map(|(margin, limit)| Some((crossing(&margin, width)?, limit)));
            let (at, limit) = crossings.min_by(|a, b| a.0.total_cmp(&b.0))?;
            Some((self.point(turns, (begin + at).min(to)), limit))
        })
    }

    fn end(&self, from_limit: bool) -> Option<(LegPoint, RollingLimit)> {
        if self.law().offset == 0.0 {
            // The forces are constant.
            return None;
        }
        let reach = self
            .turning_distance
            .map_or(f64::INFINITY, |reach| reach.total());
        if let Some(end) = self.crossing(0.0, 0.0..reach.min(2.0 * TAU), from_limit) {
            return Some(end);
        }
        let turn = |turns: f64| self.crossing(turns, 0.0..TAU, false);
        let whole = (reach.min(self.distance_to_bounds()) / TAU).floor();
        // Rolling holds in turn `low` and before.
        let mut low = 1.0;
        while low < whole - 1.0 {
            let high = (2.0 * low).min(whole - 1.0);
            if turn(high).is_some() {
                return turn(last_of(low, high, |turns| turn(turns).is_none()) + 1.0);
            }
            low = high;
        }
        let is_last = reach > 2.0 * TAU && reach <= self.distance_to_bounds();
        is_last
            .then(|| self.crossing(whole, 0.0..reach - TAU * whole, false))
            .flatten()
    }
}

/// The variable p in which the rest within a turn is a smooth function of time, by the turning points
/// next to it.
#[derive(Clone, Copy)]
enum Variable {
    /// The rest itself.
    Free,
    /// Behind a turning point: the root of the rest.
    Behind,
    /// Before one at this rest: the root of the distance to it, counted from the start on.
    Before { rest: f64 },
    /// Between two, the second at this rest: the part of the way that is passed is sin²(p/2).
    Between { rest: f64 },
}

/// A rest, what is left to the turning point ahead, and how much the rest grows with p.
struct Stretched {
    rest: f64,
    left: Option<f64>,
    stretch: f64,
}

impl Variable {
    const fn new(is_behind: bool, ahead: Option<f64>) -> Self {
        match (is_behind, ahead) {
            (true, Some(rest)) => Self::Between { rest },
            (true, None) => Self::Behind,
            (false, Some(rest)) => Self::Before { rest },
            (false, None) => Self::Free,
        }
    }

    /// p at the turning point ahead, or at the end of the turn; it begins at 0.
    fn end(self) -> f64 {
        match self {
            Self::Free => TAU,
            Self::Behind => TAU.sqrt(),
            Self::Before { rest } => rest.sqrt(),
            Self::Between { .. } => PI,
        }
    }

    fn at(self, p: f64) -> Stretched {
        let (rest, left, stretch) = match self {
            Self::Free => (p, None, 1.0),
            Self::Behind => (p * p, None, 2.0 * p),
            Self::Before { rest } => {
                let root = rest.sqrt() - p;
                (rest - root * root, Some(root * root), 2.0 * root)
            }
            Self::Between { rest } => {
                let (sin, cos) = sincos(0.5 * p);
                (rest * sin * sin, Some(rest * cos * cos), rest * sin * cos)
            }
        };
        Stretched {
            rest,
            left,
            stretch,
        }
    }
}

/// Σ (g + k δ)^(−½) for k = 0 … n − 1.
fn sum_of_roots(g: f64, step: f64, count: f64) -> f64 {
    let single = count.min(f64::from(SINGLE_TERMS));
    let mut sum = 0.0;
    let mut k = 0.0;
    while k < single {
        sum += 1.0 / (g + k * step).sqrt();
        k += 1.0;
    }
    if count <= single {
        return sum;
    }
    let [first, last] = [g + single * step, g + count * step];
    let root = |x: f64| x.sqrt();
    sum += 2.0 * (count - single) / (root(first) + root(last));
    sum += 0.5 * (1.0 / root(first) - 1.0 / root(last));
    // B_2j/(2j)! times the odd derivatives of x^(−½), −½ δ x^(−3/2), −15/8 δ³ x^(−7/2), …
    let odd = |x: f64| {
        let ratio = step / x;
        let square = ratio * ratio;
        let series = 1.0 / 24.0
            - square * (1.0 / 384.0 - square * (1.0 / 1024.0 - square * (143.0 / 163_840.0)));
        ratio * series / root(x)
    };
    sum + odd(first) - odd(last)
}
