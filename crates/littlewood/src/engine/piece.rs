//! A piece of a slide, on which u = θ′² is a polynomial: where contact, or the slip, ends on it.

use crate::math::bracket::Bracket;
use crate::mechanics::equations::{SlidingLaw, contact};
use crate::model::hoop::Heavy;

/// A slower end of slip is left to the Taylor series: η′ comes from the first integral to ε (1 + |θ′|), so that below this
/// part of 1 + |θ′| in η″ the time of η′ = 0 is not known to 2e-13.
const MIN_SLIP_ACCELERATION: f64 = 2e-3;

/// Rounding of η′ by light hoops, which amplify it by (Î/m)^(−1/2) at each passage of the bottom, as a part of that.
const AMPLIFIED: f64 = 0.1;

/// Newton's method for a place at a time ends with a shorter step: its error is of the second order.
const LAST_STEP: f64 = 1e-8;

/// The same for the place at which η′ vanishes.
const LAST_STEP_TO_REST: f64 = 1e-7;

/// A step by which Simpson's rule for the time is exact to rounding, if dτ/dz changes by no more than this part of itself: the error is the fourth
/// power of that over 2880.
const SHORT_STEP: f64 = 1e-3;

/// Where dτ/dz changes in a step, the time of the step must be so short beside the inverse of that part: Newton's method takes it for fixed.
const LAST_TIME: f64 = 1e-14;

/// The place of a minimum of η′ is known to this: the value to the second order.
const LEAST_WIDTH: f64 = 1e-7;

/// So many halvings, with two steps of a secant for each, take a way to that.
const MOST_HALVINGS: usize = 80;

/// A number within this part of its terms of zero may have either sign in the simulation: rounding, as much as passages of the bottom of a light hoop and a small P
/// amplify it. The exact solver tells.
pub(super) const UNCERTAIN: f64 = 1e-9;

/// Where η″ vanishes at an end of a way its sign is told so far inside, as a part of the way.
const INSIDE: f64 = 1e-6;

/// Whether η″ may rise through zero on a way, from η″ at its beginning and at its end and from the larger u. It may vanish at either, as at the bottom without
/// kinetic friction.
pub(super) fn may_rise(first: f64, last: f64, u: f64) -> bool {
    let uncertain = UNCERTAIN * (1.0 + u);
    last >= -uncertain && first <= uncertain
}

/// A part of a slide on which u is known as a function of a coordinate z, along which the slide goes up or down.
pub(super) trait Piece {
    /// u at z.
    fn u(&self, z: f64) -> f64;
    /// θ′ at z, from u there.
    fn rate(&self, z: f64, u: f64) -> f64;
    /// sin ϑ and cos ϑ at z.
    fn direction(&self, z: f64) -> (f64, f64);
    /// The same at z + `step`, a short step from z, from that at z.
    fn turned(&self, direction: (f64, f64), z: f64, step: f64) -> (f64, f64);
    /// dϑ/dz.
    fn turning(&self, z: f64) -> f64;
    /// The derivative by z at z, where u is known, of what has this derivative by time.
    fn by_coordinate(&self, z: f64, u: f64, by_time: f64) -> f64;
    /// Time from one place to another, each with its u. None where it is not known to rounding.
    fn time(&self, here: (f64, f64), there: (f64, f64)) -> Option<f64>;
}

/// A point on the way through a piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Waypoint {
    pub(super) z: f64,
    pub(super) u: f64,
    pub(super) elapsed: f64,
    /// σ η′ and σ η″.
    pub(super) slip: f64,
    pub(super) slip_acceleration: f64,
    /// sin ϑ and cos ϑ, where the way may end.
    pub(super) direction: (f64, f64),
}

/// How a part of a slide ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum End {
    /// The slide goes on.
    Open,
    /// η′ = 0.
    Rest,
    /// w = 0.
    LiftOff,
    /// By a limit of time.
    Cut,
}

/// The way of a slide through a piece.
#[derive(Clone, Copy, Debug)]
pub(super) struct Way<'a, P> {
    pub(super) law: &'a SlidingLaw,
    pub(super) piece: &'a P,
    /// Sign of dz/dτ.
    pub(super) forward: f64,
    /// Sign of η′.
    pub(super) sigma: f64,
    /// The constant of the first integral, η′ − θ′ (1 + h cos ϑ + μk σ h sin ϑ) + μk σ τ.
    pub(super) integral: f64,
}

impl<P: Piece> Way<'_, P> {
    /// σ η′ by the first integral.
    #[inline]
    pub(super) fn slip(&self, rate: f64, lever: f64, elapsed: f64) -> f64 {
        self.sigma * (self.integral + rate * lever - self.law.friction * elapsed)
    }

    /// The size of the terms of η′ at a waypoint, in the first integral.
    pub(super) fn size_of_slip(&self, at: &Waypoint) -> f64 {
        1.0 + at.u.sqrt() + self.integral.abs()
    }

    /// Everything at z, from the way since `here`.
    pub(super) fn at(&self, here: &Waypoint, z: f64) -> Option<Waypoint> {
        let u = self.piece.u(z);
        let elapsed = here.elapsed + self.piece.time((here.z, here.u), (z, u))?;
        Some(self.waypoint(z, u, elapsed))
    }

    /// The same a short step away; none if it is longer.
    fn beside(&self, here: &Waypoint, z: f64) -> Option<Waypoint> {
        let (middle, u) = (0.5 * (here.z + z), self.piece.u(z));
        let (first, last) = (self.slowness(here.z, here.u), self.slowness(z, u));
        if !((z - here.z).abs() <= SHORT_STEP && (last - first).abs() <= SHORT_STEP * first.abs()) {
            return None;
        }
        let sum = first + 4.0 * self.slowness(middle, self.piece.u(middle)) + last;
        Some(self.waypoint(z, u, here.elapsed + (z - here.z) / 6.0 * sum))
    }

    /// dτ/dz.
    fn slowness(&self, z: f64, u: f64) -> f64 {
        self.piece.by_coordinate(z, u, 1.0)
    }

    /// Everything at z, where u and the time are known.
    fn waypoint(&self, z: f64, u: f64, elapsed: f64) -> Waypoint {
        let (sin, cos) = self.piece.direction(z);
        let (alpha, beta) = self.law.slip_acceleration(sin, cos);
        let lever = self.law.lever(sin, cos);
        Waypoint {
            z,
            u,
            elapsed,
            slip: self.slip(self.piece.rate(z, u), lever, elapsed),
            slip_acceleration: self.sigma * (alpha + beta * u),
            direction: (sin, cos),
        }
    }

    /// Where 1 − h cos ϑ u falls through zero between `here` and `end`.
    pub(super) fn lift_off(&self, here: &Waypoint, end: f64) -> Option<Waypoint> {
        let (h, forward) = (self.law.body.h, self.forward);
        let z = Bracket { low: here.z.min(end), high: here.z.max(end) }.refine_from_secant(|z| {
            let (sin, cos) = self.piece.direction(z);
            let u = self.piece.u(z);
            let w = contact(1.0, h, cos * u);
            let slope = self.piece.turning(z) * (h * sin * u - h * cos * self.law.drive(sin, cos) * w);
            (forward * w, forward * slope)
        });
        self.at(here, z)
    }

    /// η″ at a waypoint, or, where it vanishes there, a little nearer to another: where, and its value.
    fn slip_acceleration_towards(&self, here: &Waypoint, there: &Waypoint) -> (f64, f64) {
        if here.slip_acceleration.abs() > UNCERTAIN * (1.0 + here.u) {
            return (here.z, here.slip_acceleration);
        }
        let z = here.z + INSIDE * (there.z - here.z);
        let (sin, cos) = self.piece.direction(z);
        let (alpha, beta) = self.law.slip_acceleration(sin, cos);
        (z, self.sigma * (alpha + beta * self.piece.u(z)))
    }

    /// Where η′ is least between two waypoints, between which η″ changes its sign at most once; none where it is so at one of them.
    pub(super) fn least(&self, here: &Waypoint, there: &Waypoint) -> Option<Option<Waypoint>> {
        let (mut low, mut at_low) = self.slip_acceleration_towards(here, there);
        let (mut high, mut at_high) = self.slip_acceleration_towards(there, here);
        if at_low > 0.0 || at_high < 0.0 {
            return Some(None);
        }
        let short = 0.5 * LEAST_WIDTH * self.forward;
        // On which side the last place was, and how often in a row.
        let (mut is_below, mut repeats) = (true, 0);
        for _ in 0..MOST_HALVINGS {
            if (high - low).abs() <= LEAST_WIDTH {
                break;
            }
            // The secant, and a little beyond, so that the other end comes close, too; and no closer to an end, where η″ may be next to zero.
            let secant = (low * at_high - high * at_low) / (at_high - at_low);
            let beyond = if is_below { secant + short } else { secant - short };
            let is_inside =
                (beyond - low - short) * self.forward > 0.0 && (high - short - beyond) * self.forward > 0.0;
            let z = if repeats < 2 && is_inside { beyond } else { 0.5 * (low + high) };
            let (sin, cos) = self.piece.direction(z);
            let (alpha, beta) = self.law.slip_acceleration(sin, cos);
            let value = self.sigma * (alpha + beta * self.piece.u(z));
            repeats = if (value < 0.0) == is_below { repeats + 1 } else { 1 };
            is_below = value < 0.0;
            if is_below {
                (low, at_low) = (z, value);
            } else {
                (high, at_high) = (z, value);
            }
        }
        let z = 0.5 * (low + high);
        self.at(here, z).map(Some)
    }

    /// u behind a step, and the time of the step, if it is short enough to be the last of Newton's method.
    fn last_step(&self, z: f64, u: f64, step: f64, longest: f64) -> Option<(f64, f64)> {
        if step.abs() >= longest {
            return None;
        }
        let next = self.piece.u(z + step);
        let (here, there) = (self.slowness(z, u), self.slowness(z + step, next));
        let time = 0.5 * step * (here + there);
        ((time * (there - here)).abs() < LAST_TIME * here.abs()).then_some((next, time))
    }

    /// Where the slide is at a time between those of two waypoints: Newton's method in a bracket.
    pub(super) fn at_time(&self, here: &Waypoint, there: &Waypoint, elapsed: f64) -> Option<Waypoint> {
        let Self { piece, forward, .. } = *self;
        let (mut low, mut high) = (here.z, there.z);
        let part = (elapsed - here.elapsed) / (there.elapsed - here.elapsed);
        let mut z = low + part * (high - low);
        for _ in 0..60 {
            let at = self.at(here, z)?;
            if at.elapsed > elapsed {
                high = z;
            } else {
                low = z;
            }
            let step = (elapsed - at.elapsed) / self.slowness(z, at.u);
            let next = z + step;
            let inside = (next - low) * forward >= 0.0 && (high - next) * forward >= 0.0;
            if let Some((u, _)) = self.last_step(z, at.u, step, LAST_STEP) {
                let (sin, cos) = piece.direction(next);
                let slip = self.slip(piece.rate(next, u), self.law.lever(sin, cos), elapsed);
                return Some(Waypoint { z: next, u, elapsed, slip, direction: (sin, cos), ..at });
            }
            z = if inside { next } else { 0.5 * (low + high) };
        }
        None
    }

    /// Where η′ falls through zero between two waypoints: a cubic for a guess, then Newton's method with the exact time.
    pub(super) fn rest(&self, here: &Waypoint, there: &Waypoint) -> Option<Waypoint> {
        let Self { piece, forward, .. } = *self;
        let span = there.z - here.z;
        // dη′/ds with s from 0 at `here` to 1 at `there`.
        let slope = |at: &Waypoint| piece.by_coordinate(at.z, at.u, at.slip_acceleration) * span;
        let guess = cubic_root(here.slip, slope(here), there.slip, slope(there));
        // η′ is positive at `low` and behind it, and negative at `high`.
        let (mut low, mut high) = (here.z, there.z);
        let mut z = here.z + guess * span;
        let mut near: Option<Waypoint> = None;
        for _ in 0..40 {
            let at = match near.and_then(|near| self.beside(&near, z)) {
                Some(at) => at,
                None => *near.insert(self.at(here, z)?),
            };
            if at.slip > 0.0 {
                low = z;
            } else {
                high = z;
            }
            let rate = piece.by_coordinate(z, at.u, at.slip_acceleration);
            let step = -at.slip / rate;
            let next = z + step;
            let inside = (next - low) * forward >= 0.0 && (high - next) * forward >= 0.0;
            if !inside || rate * forward >= 0.0 {
                z = 0.5 * (low + high);
                continue;
            }
            if let Some((u, time)) = self.last_step(z, at.u, step, LAST_STEP_TO_REST) {
                let Heavy { mass, inertia, .. } = self.law.body;
                let amplified = (AMPLIFIED * (mass / inertia).sqrt()).max(1.0);
                if at.slip_acceleration.abs() < MIN_SLIP_ACCELERATION * amplified * (1.0 + at.u.sqrt()) {
                    return None;
                }
                return Some(Waypoint {
                    z: next,
                    u,
                    elapsed: at.elapsed + time,
                    slip: 0.0,
                    slip_acceleration: at.slip_acceleration,
                    direction: piece.turned(at.direction, z, step),
                });
            }
            z = next;
        }
        None
    }
}

/// Root in (0, 1] of the cubic with these values and slopes at 0 and 1, the value at 1 not positive.
fn cubic_root(start: f64, start_slope: f64, end: f64, end_slope: f64) -> f64 {
    let c2 = 3.0 * (end - start) - 2.0 * start_slope - end_slope;
    let c3 = 2.0 * (start - end) + start_slope + end_slope;
    let mut s = 1.0;
    for _ in 0..8 {
        let value = start + s * (start_slope + s * (c2 + s * c3));
        let slope = start_slope + s * (2.0 * c2 + 3.0 * s * c3);
        if slope >= 0.0 {
            break;
        }
        let next: f64 = s - value / slope;
        if !(next > 0.0 && next <= 1.0) {
            break;
        }
        if (next - s).abs() < 1e-6 {
            return next;
        }
        s = next;
    }
    s
}

#[cfg(test)]
pub(super) mod check {
    use super::*;

    /// A piece that counts how often its time is asked for.
    pub(in crate::engine) struct Counted<P> {
        pub(in crate::engine) piece: P,
        pub(in crate::engine) times: core::cell::Cell<u32>,
    }

    impl<P: Piece> Piece for Counted<P> {
        fn u(&self, z: f64) -> f64 {
            self.piece.u(z)
        }

        fn rate(&self, z: f64, u: f64) -> f64 {
            self.piece.rate(z, u)
        }

        fn direction(&self, z: f64) -> (f64, f64) {
            self.piece.direction(z)
        }

        fn turned(&self, direction: (f64, f64), z: f64, step: f64) -> (f64, f64) {
            self.piece.turned(direction, z, step)
        }

        fn turning(&self, z: f64) -> f64 {
            self.piece.turning(z)
        }

        fn by_coordinate(&self, z: f64, u: f64, by_time: f64) -> f64 {
            self.piece.by_coordinate(z, u, by_time)
        }

        fn time(&self, here: (f64, f64), there: (f64, f64)) -> Option<f64> {
            self.times.set(self.times.get() + 1);
            self.piece.time(here, there)
        }
    }

    /// Between its ends, along which it travels forward, a slide comes to rest where it is made to, and is at a time where it is then, and
    /// few times are asked for. How often it came to rest, where η′ falls all the way, and how many times were asked for then.
    pub(in crate::engine) fn finds_places(
        piece: impl Piece,
        law: &SlidingLaw,
        (from, to): (f64, f64),
    ) -> (u32, u32) {
        let counted = Counted { piece, times: core::cell::Cell::new(0) };
        let way =
            |integral: f64| Way { law, piece: &counted, forward: (to - from).signum(), sigma: 1.0, integral };
        let asked = || counted.times.replace(0);
        let mut rests = (0, 0);
        for part in [0.1, 0.4, 0.7, 0.95] {
            let z = from + part * (to - from);
            let place = |way: &Way<'_, _>, z: f64| {
                let here = way.waypoint(from, counted.u(from), 0.0);
                way.at(&here, z).unwrap()
            };
            // η′ vanishes there.
            let integral = -place(&way(0.0), z).slip;
            let way = way(integral);
            let [here, at, there] = [from, z, to].map(|z| place(&way, z));
            asked();
            let found = way.at_time(&here, &there, at.elapsed).unwrap();
            assert!((found.z - z).abs() < 1e-12 && (found.u - at.u).abs() < 1e-12 * at.u, "{z}: {found:?}");
            let times = asked();
            assert!(times <= 4, "{z}: {times}");
            let falls = [&here, &at, &there].iter().all(|at| at.slip_acceleration < -0.05);
            if falls && here.slip > 0.0 && there.slip < 0.0 {
                let found = way.rest(&here, &there).unwrap();
                assert!(
                    (found.z - z).abs() < 1e-12 && (found.elapsed - at.elapsed).abs() < 1e-12,
                    "{z}: {found:?}"
                );
                rests = (rests.0 + 1, rests.1 + asked());
            }
        }
        rests
    }

    /// A piece from one coordinate to another, between which contact lasts, is a slide of its law.
    pub(in crate::engine) fn is_a_slide(piece: &impl Piece, law: &SlidingLaw, (from, to): (f64, f64)) {
        const STEP: f64 = 1e-5;
        let slowness = |z: f64| piece.by_coordinate(z, piece.u(z), 1.0);
        let close = |one: f64, other: f64, what: &str, z: f64| {
            assert!((one - other).abs() < 1e-7 * (1.0 + other.abs()), "{what} at {z}: {one} {other}");
        };
        for k in 1..20 {
            let z = from + (to - from) * f64::from(k) / 20.0;
            let (u, (sin, cos)) = (piece.u(z), piece.direction(z));
            assert!((sin * sin + cos * cos - 1.0).abs() < 1e-15, "{z}");
            let [before, after] = [z - STEP, z + STEP].map(|z| piece.direction(z));
            let turned = before.1 * after.0 - before.0 * after.1;
            close(turned / (2.0 * STEP), piece.turning(z), "turning", z);
            let rate = piece.rate(z, u);
            close(piece.turning(z) / slowness(z), rate, "rate", z);
            assert!((rate * rate - u).abs() <= 4.0 * f64::EPSILON * u, "{z}");
            let steeper = (piece.u(z + STEP) - piece.u(z - STEP)) / (2.0 * STEP);
            let contact = contact(1.0, law.body.h, cos * u);
            close(steeper, piece.turning(z) * law.drive(sin, cos) * contact, "u", z);
            let there = piece.turned((sin, cos), z, 1e-6);
            let expected = piece.direction(z + 1e-6);
            assert!((there.0 - expected.0).abs() < 1e-15 && (there.1 - expected.1).abs() < 1e-15, "{z}");
        }
        // Simpson's rule for the time.
        let parts = 2000;
        let width = (to - from) / f64::from(parts);
        let sum: f64 = (0..=parts)
            .map(|k| {
                let weight = if k == 0 || k == parts { 1.0 } else { 2.0 + 2.0 * f64::from(k % 2) };
                weight * slowness(from + width * f64::from(k))
            })
            .sum();
        let time = piece.time((from, piece.u(from)), (to, piece.u(to))).unwrap();
        assert!((time - width / 3.0 * sum).abs() < 1e-11 * time.abs(), "{time} {}", width / 3.0 * sum);
        assert!(time > 0.0, "{time}");
    }
}
