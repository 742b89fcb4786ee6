//! Rolling on a slope: the kinetic energy as a function of the angle, time as a quadrature, and the end of rolling.
//!
//! In the direction of motion, in which the angle ϑ increases, with T = ± tan α, D θ′² obeys
//!
//! ```text
//! G = D ϑ′² = G0 + 2 [ℓ̂ (cos ϑ0 − cos ϑ) + T (m (ϑ − ϑ0) + ℓ̂ (sin ϑ − sin ϑ0))],
//! N D² = D [m Î + (m + ℓ̂c)² − T ℓ̂ s (m + ℓ̂c)] − G ℓ̂ (ℓ̂ s² + c D),
//! F D² = ℓ̂ s [G (Î + ℓ̂(h + c)) − (m + ℓ̂c) D] + T (m Î + ℓ̂² s²) D,
//! ```
//!
//! and dτ = √(D/G) dϑ. G changes by 4π m T in a turn. Its extrema, the equilibria, are at sin(ϑ + atan T) = −sin(atan T)/h, so each turning
//! point is the only root between two of them. The margins μs N ± F are Taylor polynomials that converge to rounding on an eighth of a
//! half turn, whose sign changes [`crate::math::bernstein`] isolates.
//!
//! *Many turns.* At each angle the margins are linear in G. A margin that falls with G is negative on a set of angles that grows from turn to
//! turn downhill, one that rises with G on a set that grows uphill. So the turns in which rolling ends follow those in which it does not, and
//! bisection finds the first. The time of n turns is the quadrature of one turn with Σ (G + k δ)^(−½) in place of G^(−½), a sum of
//! Euler and Maclaurin.

use core::f64::consts::{FRAC_PI_8, PI, TAU};

use crate::math::bracket::{Bracket, Step};
use crate::math::panel::{NODES, Rule, largest};
use crate::math::series::{DEGREE, Series, convolve, crossing};
use crate::math::trig::{above_bottom, sincos, without_turns};
use crate::mechanics::RollingLaw;
use crate::model::{Direction, Hoop};

use super::boundary::{Hold, RollingEnd, RollingLimit, in_body_frame};
use super::recurrence::Recurrence;

/// Largest angle of an end of rolling, as of a start: doubles resolve 1e-7 there.
const MAX_ANGLE: f64 = 1e9;

/// Largest relative tail of an integrand on a panel: the rule is exact to twice the degree.
const TAIL_TOLERANCE: f64 = 1e-8;

/// Largest number of halvings of a panel: its width is then one unit in the last place.
const MAX_HALVINGS: u32 = 52;

/// Largest number of panels. Where rounding, and not the width, is what a panel does not resolve, more would not help.
const MAX_PANELS: u32 = 1024;

/// How often a panel is halved before its series are computed, which cost some ten times as much as a look at the margins.
const SCREENINGS: u32 = 3;

/// Number of terms summed one by one before the formula of Euler and Maclaurin: its first omitted term is then below 1e-16 of a term.
const SINGLE_TERMS: u32 = 32;

/// The rolling orbit of a hoop on a slope through a state.
#[derive(Clone, Copy, Debug)]
pub(super) struct Incline {
    /// Direction of motion at the start.
    travel: f64,
    /// Up to the first turning point.
    first: Leg,
    /// From there, the other way.
    back: Option<Leg>,
    /// Whether it stays where it is.
    rests: bool,
}

/// A part of an orbit in one direction, in which its angle increases.
#[derive(Clone, Copy, Debug)]
struct Leg {
    law: RollingLaw,
    limits: Limits,
    /// tan α, positive downhill.
    pull: f64,
    /// ϑ at the beginning, without whole turns, and these.
    angle: f64,
    turned: f64,
    /// G at the beginning; 0 at a turning point.
    kinetic: f64,
    /// The turning point, if any.
    reach: Option<Distance>,
}

/// A distance in whole turns and a rest: each number is computed from the rest, which resolves it however many turns there are.
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
struct Place {
    passed: Distance,
    left: f64,
}

/// What bounds rolling.
#[derive(Clone, Copy, Debug)]
struct Limits {
    mu: f64,
    /// Î; a hoop without has a contact force that points at the particle.
    inertia: f64,
}

impl Incline {
    pub(super) fn new(hoop: &Hoop, law: RollingLaw, theta: f64, theta_rate: f64) -> Self {
        let (sin, cos) = libm::sincos(theta);
        let kinetic = law.denominator(theta) * theta_rate * theta_rate;
        // At a turning point gravity decides the direction of motion.
        let pulled = law.offset * sin + law.tilt * (law.mass + law.offset * cos);
        let moving = if kinetic == 0.0 { pulled } else { theta_rate };
        let travel = Direction::of_sign(moving).map_or(1.0, Direction::sign);
        let limits = Limits { mu: hoop.mu_s(), inertia: hoop.body().inertia_about_mass_centre() };
        let pull = travel * law.tilt;
        let first = Leg::new((law, limits), pull, [0.0, travel * theta], kinetic);
        let back = first.reach.map(|reach| {
            let turned = first.turned + TAU * reach.turns;
            Leg::new((law, limits), -pull, [-turned, -(first.angle + reach.rest)], 0.0)
        });
        // Both turning points round to the angle of the start.
        let width = back.and_then(|back| back.reach).map_or(f64::INFINITY, |reach| reach.total());
        let rests = moving == 0.0 || width <= f64::EPSILON * theta.abs();
        Self { travel, first, back, rests }
    }

    /// Whether the hoop is unbalanced and rolls down without end: it ends beyond the bounds of θ if nowhere else.
    pub(super) fn descends(&self) -> bool {
        !self.rests
            && self.first.law.offset > 0.0
            && self.back.map_or(self.first.reach.is_none(), |back| back.reach.is_none())
    }

    /// Time to the first turning point.
    fn outward(&self) -> f64 {
        self.first.whole()
    }

    pub(super) fn position(&self, elapsed: f64) -> (f64, f64) {
        if self.rests {
            return (self.travel * self.first.start(), 0.0);
        }
        let (leg, place, way) = self.at(elapsed);
        let rate = (leg.kinetic_at(place) / leg.denominator(place)).sqrt();
        let frame = self.frame(&leg);
        (frame * leg.angle_at(place), frame * way * rate)
    }

    /// The sign of θ in the frame of a leg.
    fn frame(&self, leg: &Leg) -> f64 {
        if leg.pull == self.first.pull { self.travel } else { -self.travel }
    }

    /// The leg and the place after a time, and the direction of motion in the frame of the leg.
    fn at(&self, elapsed: f64) -> (Leg, Place, f64) {
        let Some(back) = self.back else { return (self.first, self.first.place_at(elapsed), 1.0) };
        let outward = self.outward();
        if elapsed <= outward {
            return (self.first, self.first.place_at(elapsed), 1.0);
        }
        let since = elapsed - outward;
        if back.reach.is_none() {
            return (back, back.place_at(since), 1.0);
        }
        let half = back.whole();
        let within = since - 2.0 * half * (since / (2.0 * half)).floor();
        if within <= half {
            (back, back.place_at(within), 1.0)
        } else {
            (back, back.place_at(2.0 * half - within), -1.0)
        }
    }

    pub(super) fn time_to(&self, theta: f64) -> Option<f64> {
        if self.rests {
            return (theta == self.travel * self.first.start()).then_some(0.0);
        }
        let ahead = |leg: &Leg| {
            let passed = self.frame(leg) * theta - leg.start();
            let is_on = passed >= 0.0 && leg.reach.is_none_or(|reach| passed <= reach.total());
            let turns = (passed / TAU).floor();
            is_on.then(|| leg.time(leg.place(turns, passed - TAU * turns)))
        };
        ahead(&self.first).or_else(|| Some(self.outward() + ahead(&self.back?)?))
    }

    pub(super) fn end(&self) -> Option<RollingEnd> {
        if self.rests {
            return None;
        }
        let (leg, before, (place, limit)) = match self.first.end() {
            Some(end) => (self.first, 0.0, end),
            None => {
                let back = self.back?;
                (back, self.outward(), back.end()?)
            }
        };
        let frame = self.frame(&leg);
        let rate = (leg.kinetic_at(place) / leg.denominator(place)).sqrt();
        Some(RollingEnd {
            elapsed: before + leg.time(place),
            theta: frame * leg.angle_at(place),
            theta_rate: frame * rate,
            limit: in_body_frame(limit, frame),
        })
    }

    pub(super) fn recurrence(&self) -> Recurrence {
        if self.rests {
            return Recurrence::Rest;
        }
        let Some((back, reach)) = self.back.and_then(|back| Some((back, back.reach?))) else {
            // The centre moves by −θ.
            let law = self.first.law;
            return Recurrence::Downhill { acceleration: -law.mass * law.tilt / law.mean_denominator() };
        };
        let frame = self.frame(&back);
        // From rest the motion comes back to its start.
        let far = if self.first.kinetic == 0.0 { -self.first.start() } else { back.start() + reach.total() };
        let [from, to] = [back.start(), far].map(|angle| frame * angle);
        Recurrence::Libration { period: 2.0 * back.whole(), theta_min: from.min(to), theta_max: from.max(to) }
    }

    pub(super) fn hold(&self) -> Hold {
        let leg = &self.first;
        let d = leg.denominator(leg.place(0.0, 0.0));
        let mut hold = Hold::Holds;
        for (margin, limit) in leg.margins(leg.place(0.0, 0.0)).into_iter().flatten() {
            let first = if self.rests { Some(&margin[0]) } else { margin.iter().find(|c| **c != 0.0) };
            if first.is_none_or(|first| *first >= 0.0) {
                continue;
            }
            hold = match (hold, in_body_frame(limit, self.travel)) {
                // Both margins are negative only where N < 0.
                (Hold::Slips { .. } | Hold::NoNormalForce, _) | (_, RollingLimit::NormalForce) => {
                    Hold::NoNormalForce
                }
                (Hold::Holds, RollingLimit::Friction(direction)) => {
                    Hold::Slips { direction, excess: -margin[0] / (d * d) }
                }
            };
        }
        hold
    }
}

impl Leg {
    /// 2 [ℓ̂ (cos a − cos b) + T (m (b − a) + ℓ̂ (sin b − sin a))] for b = a + `by`.
    fn gain(&self, from: f64, by: f64) -> f64 {
        let (sin, cos) = sincos(from + 0.5 * by);
        let chord = 2.0 * libm::sin(0.5 * by);
        2.0 * (self.law.offset * chord * (sin + self.pull * cos) + self.pull * self.law.mass * by)
    }

    /// The angle at the beginning is the sum of whole turns and a rest.
    fn new((law, limits): (RollingLaw, Limits), pull: f64, [turned, rest]: [f64; 2], kinetic: f64) -> Self {
        let angle = without_turns(rest);
        let leg = Self { law, limits, pull, angle, turned: turned + (rest - angle), kinetic, reach: None };
        Self { reach: leg.turning_point(), ..leg }
    }

    /// ϑ at the beginning.
    fn start(&self) -> f64 {
        self.turned + self.angle
    }

    fn angle_at(&self, place: Place) -> f64 {
        (self.turned + TAU * place.passed.turns) + (self.angle + place.passed.rest)
    }

    /// The gain of G in a turn.
    fn fall(&self) -> f64 {
        4.0 * PI * self.law.mass * self.pull
    }

    /// Half the slope of G.
    fn slope(&self, rest: f64) -> f64 {
        let (sin, cos) = sincos(self.angle + rest);
        self.law.offset * sin + self.pull * (self.law.mass + self.law.offset * cos)
    }

    fn place(&self, turns: f64, rest: f64) -> Place {
        let left = |reach: Distance| TAU * (reach.turns - turns) + (reach.rest - rest);
        Place { passed: Distance { turns, rest }, left: self.reach.map_or(f64::INFINITY, left) }
    }

    fn denominator(&self, place: Place) -> f64 {
        self.law.denominator_of(sincos(self.angle + place.passed.rest))
    }

    /// G, from the nearer end.
    fn kinetic_at(&self, Place { passed: Distance { turns, rest }, left }: Place) -> f64 {
        let kinetic = match self.reach {
            Some(reach) if left < TAU * turns + rest => {
                let whole = (left / TAU).floor();
                self.gain(self.angle + reach.rest, TAU * whole - left) - whole * self.fall()
            }
            Some(_) | None => self.kinetic + self.gain(self.angle, rest) + turns * self.fall(),
        };
        kinetic.max(0.0)
    }

    /// The first zero of G ahead.
    fn turning_point(&self) -> Option<Distance> {
        let Self { law, pull, angle, kinetic, .. } = *self;
        let value = |turns: f64, rest: f64| kinetic + self.gain(angle, rest) + turns * self.fall();
        let root = |turns: f64, low: f64, high: f64| {
            let rest = Bracket { low, high }
                .iterate(high, |rest| Step::newton(rest, (value(turns, rest), 2.0 * self.slope(rest))));
            if rest < 0.0 {
                Distance { turns: turns - 1.0, rest: rest + TAU }
            } else {
                Distance { turns, rest }
            }
        };
        let Some([unstable, stable]) = (RollingLaw { tilt: pull, ..law }).equilibria() else {
            // G is monotone, within the swing of its periodic part of a straight line.
            let swing = 4.0 * law.offset * (1.0 + pull * pull).sqrt();
            let per = -2.0 * law.mass * pull;
            return (pull < 0.0).then(|| {
                let [low, high] = [((kinetic - swing) / per).max(0.0), (kinetic + swing) / per];
                let turns = (low / TAU).floor();
                root(turns, low - TAU * turns, high * (1.0 + 1e-15) - TAU * turns)
            });
        };
        let ahead = |of: f64| (of - angle).rem_euclid(TAU);
        let (lowest, highest) = (ahead(unstable), ahead(stable));
        // At a turning point G first rises to its maximum.
        let low = if kinetic == 0.0 { highest } else { 0.0 };
        if low > lowest {
            return Some(Distance { turns: 0.0, rest: 0.0 });
        }
        if value(0.0, lowest) < 0.0 {
            return Some(root(0.0, low, lowest));
        }
        if pull >= 0.0 {
            return None;
        }
        // Each minimum is lower than the one before by the fall of a turn.
        let mut turns = (value(0.0, lowest) / -self.fall()).floor() + 1.0;
        if value(turns - 1.0, lowest) < 0.0 {
            turns -= 1.0;
        } else if value(turns, lowest) >= 0.0 {
            turns += 1.0;
        }
        Some(root(turns, lowest - TAU, lowest))
    }

    /// Time from the beginning to the turning point; infinite without one.
    fn whole(&self) -> f64 {
        self.reach.map_or(f64::INFINITY, |passed| self.time(Place { passed, left: 0.0 }))
    }

    /// Time from the beginning to a place.
    fn time(&self, place: Place) -> f64 {
        let turns = place.passed.turns;
        if turns < 3.0 {
            let passed = Distance { turns: 0.0, rest: place.passed.total() };
            return self.time_between(0.0, Place { passed, ..place });
        }
        // The first turn, whose kinetic energy may vanish, then turns that differ by the gain of a turn, then the rest.
        let slowest = if self.pull < 0.0 { turns - 1.0 } else { 1.0 };
        let summed = integral([0.0, TAU], |rest| {
            let kinetic = self.kinetic_at(self.place(slowest, rest));
            self.denominator(self.place(slowest, rest)).sqrt()
                * sum_of_roots(kinetic, self.fall().abs(), turns - 1.0)
        });
        self.time_between(0.0, self.place(0.0, TAU)) + summed + self.time_between(0.0, place)
    }

    /// Time between a place in the same turn, at this rest, and a place.
    fn time_between(&self, from: f64, to: Place) -> f64 {
        let turns = to.passed.turns;
        let slowness = |place: Place| (self.denominator(place) / self.kinetic_at(place)).sqrt();
        let at = |rest: f64| slowness(self.place(turns, rest));
        // Next to a turning point the square root of the distance is the variable.
        let end = to.passed.rest + to.left;
        let middle = if end.is_finite() { 0.5 * (from + end) } else { f64::INFINITY };
        let first_end = to.passed.rest.min(middle);
        let mut time = if self.kinetic == 0.0 && turns == 0.0 && from == 0.0 {
            let near = first_end.min(PI);
            integral([0.0, near.sqrt()], |s| 2.0 * s * at(s * s)) + integral([near, first_end], at)
        } else {
            integral([from, first_end], at)
        };
        if to.passed.rest > middle {
            let near = (end - middle).min(PI).max(to.left);
            let back = |left: f64| slowness(Place { passed: Distance { turns, rest: end - left }, left });
            time += integral([middle, end - near], at);
            time += integral([to.left.sqrt(), near.sqrt()], |s| 2.0 * s * back(s * s));
        }
        time
    }

    /// The place after a time, by inversion of the increasing function of the time.
    fn place_at(&self, time: f64) -> Place {
        if time <= 0.0 {
            return self.place(0.0, 0.0);
        }
        let most = self.reach.map_or(f64::INFINITY, |reach| reach.turns);
        let begins = |turns: f64| self.time(self.place(turns, 0.0));
        let (mut turns, mut beyond) = (0.0, 1.0);
        while beyond <= most && begins(beyond) <= time && beyond < f64::MAX / 4.0 {
            (turns, beyond) = (beyond, 2.0 * beyond);
        }
        beyond = beyond.min(most + 1.0);
        while beyond - turns > 1.0 {
            let middle = (0.5 * (turns + beyond)).floor();
            if middle <= turns {
                break;
            }
            if begins(middle) <= time { turns = middle } else { beyond = middle }
        }
        // The variable p with the rest as a smooth function of it: its square after a turning point, the square from the far
        // side before one, and the width times sin²(p/2) between two.
        let begins_at_rest = self.kinetic == 0.0 && turns == 0.0;
        let last = self.reach.filter(|reach| reach.turns <= turns).map(|reach| reach.rest);
        let place = |p: f64| match (begins_at_rest, last) {
            (true, Some(rest)) => {
                let (sin, cos) = sincos(0.5 * p);
                let passed = Distance { turns, rest: rest * sin * sin };
                (Place { passed, left: rest * cos * cos }, rest * sin * cos)
            }
            (false, Some(rest)) => {
                let root = rest.sqrt() - p;
                (
                    Place { passed: Distance { turns, rest: rest - root * root }, left: root * root },
                    2.0 * root,
                )
            }
            (true, None) => (self.place(turns, p * p), 2.0 * p),
            (false, None) => (self.place(turns, p), 1.0),
        };
        let high = match (begins_at_rest, last) {
            (true, Some(_)) => PI,
            (false, Some(rest)) => rest.sqrt(),
            (true, None) => TAU.sqrt(),
            (false, None) => TAU,
        };
        let p = Bracket { low: 0.0, high }.iterate(0.5 * high, |p| {
            let (place, stretch) = place(p);
            let value = time - self.time(place);
            let rate = (self.kinetic_at(place) / self.denominator(place)).sqrt() / stretch;
            Step { value, step: value * rate, last: f64::EPSILON * p.abs() }
        });
        place(p).0
    }

    /// The margins about a place, each with the limit that is reached when it becomes negative.
    fn margins(&self, place: Place) -> [Option<(Series, RollingLimit)>; 3] {
        let Self { law, pull, limits: Limits { mu, inertia }, .. } = *self;
        let (l, m) = (law.offset, law.mass);
        let (sin0, cos0) = sincos(self.angle + place.passed.rest);
        let (mut sin, mut cos) = ([0.0; DEGREE + 1], [0.0; DEGREE + 1]);
        (sin[0], cos[0]) = (sin0, cos0);
        for n in 1..=DEGREE {
            (sin[n], cos[n]) = (cos[n - 1] / n as f64, -sin[n - 1] / n as f64);
        }
        let over_bottom = above_bottom((sin0, cos0));
        let scaled = |lead: f64, factor: f64, series: &Series| -> Series {
            core::array::from_fn(|n| if n == 0 { lead } else { factor * series[n] })
        };
        let d = scaled(law.bottom + 2.0 * l * over_bottom, 2.0 * l, &cos);
        let carried = scaled((m - l) + l * over_bottom, l, &cos);
        let kinetic: Series = core::array::from_fn(|n| match n {
            0 => self.kinetic_at(place),
            1 => 2.0 * (l * sin0 + pull * (m + l * cos0)),
            _ => 2.0 * l * (pull * sin[n] - cos[n]),
        });
        let negative = RollingLimit::Friction(Direction::Negative);
        let positive = RollingLimit::Friction(Direction::Positive);
        if inertia == 0.0 {
            // N D²/(1 + ℓ̂c) = D (1 + ℓ̂c − T ℓ̂ s) − G ℓ̂ (ℓ̂ + c); the force points at the particle.
            let held: Series = core::array::from_fn(|n| carried[n] - pull * l * sin[n]);
            let arm = scaled((l - 1.0) + over_bottom, 1.0, &cos);
            let normal = product(&d, &held);
            let pulled = product(&kinetic, &arm);
            let cone =
                |sign: f64| -> Series { core::array::from_fn(|n| mu * carried[n] + sign * l * sin[n]) };
            return [
                Some((core::array::from_fn(|n| normal[n] - l * pulled[n]), RollingLimit::NormalForce)),
                Some((cone(1.0), negative)),
                Some((cone(-1.0), positive)),
            ];
        }
        let square = product(&sin, &sin);
        let carried_square = product(&carried, &carried);
        let lever = product(&sin, &carried);
        let own = m * inertia;
        let weighed: Series = core::array::from_fn(|n| {
            carried_square[n] - pull * l * lever[n] + if n == 0 { own } else { 0.0 }
        });
        let c_d = product(&cos, &d);
        let centripetal: Series = core::array::from_fn(|n| l * square[n] + c_d[n]);
        let [held, pulled] = [product(&d, &weighed), product(&kinetic, &centripetal)];
        let beyond_mass = scaled(law.beyond_mass[1] + l * over_bottom, l, &cos);
        let [driven, loaded] = [product(&kinetic, &beyond_mass), product(&d, &carried)];
        let net: Series = core::array::from_fn(|n| driven[n] - loaded[n]);
        let across = product(&sin, &net);
        let along: Series = core::array::from_fn(|n| l * l * square[n] + if n == 0 { own } else { 0.0 });
        let along = product(&d, &along);
        let margin = |sign: f64| -> Series {
            core::array::from_fn(|n| {
                let normal = held[n] - l * pulled[n];
                let friction = l * across[n] + pull * along[n];
                mu * normal + sign * friction
            })
        };
        [Some((margin(-1.0), negative)), Some((margin(1.0), positive)), None]
    }

    /// Whether the margins of a heavy hoop are positive within a distance of a place, by their values there and bounds of their slopes, the sums
    /// of the sizes of all terms. Where that does not tell, the two halves are tried, `depth` times.
    fn holds_about(&self, turns: f64, rest: f64, reach: f64, depth: u32) -> bool {
        let Self { law, limits: Limits { mu, inertia }, .. } = *self;
        let (l, m, pull) = (law.offset, law.mass, self.pull);
        if inertia == 0.0 {
            return false;
        }
        let (sin, cos) = sincos(self.angle + rest);
        let place = self.place(turns, rest);
        let (g, d) = (self.kinetic_at(place), law.denominator_of((sin, cos)));
        let carried = m + l * cos;
        let arm = l * sin;
        let normal =
            d * (law.own + carried * carried - pull * arm * carried) - g * l * (l * sin * sin + cos * d);
        let beyond = law.beyond_mass[1] + l * above_bottom((sin, cos));
        let friction = arm * (g * beyond - carried * d) + pull * (law.own + arm * arm) * d;
        let [top, most, tilt] = [law.top, m + l, pull.abs()];
        let rise = 2.0 * (l + tilt * most);
        let energy = g + rise * reach;
        let spare = law.beyond_mass[0].abs().max(law.beyond_mass[1].abs());
        let weighed = law.own + most * most + tilt * l * most;
        let normal_slope = 2.0 * l * weighed
            + top * l * (2.0 * most + tilt * (most + l))
            + l * (rise * (l + top) + energy * (4.0 * l + top));
        let friction_slope = l
            * (energy * (spare + l) + rise * spare + most * top + l * top + 2.0 * l * most)
            + 2.0 * tilt * l * (l * top + law.own + l * l);
        // The bounds exceed the slopes by far more than rounding the values.
        let least = mu * normal - friction.abs();
        least > (mu * normal_slope + friction_slope) * reach
            || (depth > 0
                && [-0.5, 0.5]
                    .into_iter()
                    .all(|side| self.holds_about(turns, rest + side * reach, 0.5 * reach, depth - 1)))
    }

    /// The first crossing of a limit in a turn, between two rests.
    fn crossing(&self, turns: f64, [from, to]: [f64; 2]) -> Option<(Place, RollingLimit)> {
        let pieces = ((to - from) / FRAC_PI_8).ceil().max(1.0);
        let width = (to - from) / pieces;
        (0..pieces as u32).find_map(|piece| {
            let begin = from + width * f64::from(piece);
            if self.holds_about(turns, begin + 0.5 * width, 0.5 * width, SCREENINGS) {
                return None;
            }
            let margins = self.margins(self.place(turns, begin)).into_iter().flatten();
            let crossings = margins.filter_map(|(margin, limit)| Some((crossing(&margin, width)?, limit)));
            let (at, limit) = crossings.min_by(|a, b| a.0.total_cmp(&b.0))?;
            Some((self.place(turns, (begin + at).min(to)), limit))
        })
    }

    /// The first point at which rolling ends.
    fn end(&self) -> Option<(Place, RollingLimit)> {
        if self.law.offset == 0.0 {
            // The forces are constant.
            return None;
        }
        let reach = self.reach.map_or(f64::INFINITY, |reach| reach.total());
        if let Some(end) = self.crossing(0.0, [0.0, reach.min(2.0 * TAU)]) {
            return Some(end);
        }
        let turn = |turns: f64| self.crossing(turns, [0.0, TAU]);
        let whole = (reach.min(MAX_ANGLE - self.start().abs()) / TAU).floor();
        // Rolling holds in turn `low` and before.
        let mut low = 1.0;
        while low < whole - 1.0 {
            let mut high = (2.0 * low).min(whole - 1.0);
            if turn(high).is_none() {
                low = high;
                continue;
            }
            while high - low > 1.0 {
                let middle = (0.5 * (low + high)).floor();
                if turn(middle).is_some() { high = middle } else { low = middle }
            }
            return turn(high);
        }
        let is_last = reach > 2.0 * TAU && reach <= MAX_ANGLE;
        is_last.then(|| self.crossing(whole, [0.0, reach - TAU * whole])).flatten()
    }
}

fn product(a: &Series, b: &Series) -> Series {
    core::array::from_fn(|n| convolve([(a, b)], n)[0])
}

/// The integral of a function over an interval, on panels that are halved until the rule resolves it.
fn integral([from, to]: [f64; 2], f: impl Fn(f64) -> f64) -> f64 {
    let rule = Rule::get();
    let pieces = (to - from).ceil().max(1.0);
    let width = (to - from) / pieces;
    if width.is_nan() || width <= 0.0 {
        return 0.0;
    }
    let (mut sum, mut panels) = (0.0, 0);
    let mut pending: Vec<(f64, f64, u32)> = (0..pieces as u32)
        .rev()
        .map(|k| (from + width * f64::from(k), from + width * f64::from(k + 1), 0))
        .collect();
    while let Some((low, high, halvings)) = pending.pop() {
        let (centre, half) = (0.5 * (low + high), 0.5 * (high - low));
        let values: [f64; NODES] = rule.nodes.map(|x| f(centre + half * x));
        panels += 1;
        if halvings < MAX_HALVINGS
            && panels < MAX_PANELS
            && rule.tail(&values) > TAIL_TOLERANCE * largest(&values)
        {
            pending.extend([(centre, high, halvings + 1), (low, centre, halvings + 1)]);
        } else {
            sum += half * rule.integral(&values);
        }
    }
    sum
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
        let series =
            1.0 / 24.0 - square * (1.0 / 384.0 - square * (1.0 / 1024.0 - square * (143.0 / 163_840.0)));
        ratio * series / root(x)
    };
    sum + odd(first) - odd(last)
}
