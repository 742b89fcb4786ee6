//! The first rest of the slip of a glide on a slope, as in [`super::rest`] with v = v0 − τ tan α:
//! there Q = v² a b − z² L² is a polynomial of degree six in the time. The signs of its terms are
//! constant between the zeros of v and of z. For ℓ̂ = 1, L = b, and Q/b is of degree four. It is
//! expanded about both ends of each piece, in the time from that end: about the bottom and the top
//! without cancelling terms.

use crate::model::SlipDirection;

use super::particle::{Particle, ParticleState, signed_product};
use super::rest::{Along, GlideEntry, Slip, first_rest};

/// Slips less than this have squares that underflow.
const LEAST_RESOLVED_SLIP: f64 = 1e-150;

/// A polynomial of degree at most six, lowest power first.
type Polynomial = [f64; 7];

fn times(a: &Polynomial, b: &Polynomial) -> Polynomial {
    core::array::from_fn(|n| (0..=n).fold(0.0, |sum, k| sum + a[k] * b[n - k]))
}

/// Q about a place with the drift v, in the time after it (`pace` 1) or before it (−1).
fn condition(particle: &Particle, at: &ParticleState, drift: f64, pace: f64) -> Polynomial {
    let f: Polynomial = [0.0, pace * at.fall_rate, 0.5, 0.0, 0.0, 0.0, 0.0];
    let plus = |constant: f64, sign: f64| -> Polynomial {
        core::array::from_fn(|n| sign * f[n] + if n == 0 { constant } else { 0.0 })
    };
    let linear =
        |constant: f64, slope: f64| -> Polynomial { [constant, slope, 0.0, 0.0, 0.0, 0.0, 0.0] };
    let (below, above) = (plus(at.below_top, 1.0), plus(at.above_bottom, -1.0));
    let (drift, fall) = (
        linear(drift, -pace * particle.pull),
        linear(at.fall_rate, pace),
    );
    let (drift_square, fall_square) = (times(&drift, &drift), times(&fall, &fall));
    let (first, second) = if particle.inside == 0.0 {
        (times(&drift_square, &below), times(&fall_square, &above))
    } else {
        let levers = plus(particle.inside + at.above_bottom, -1.0);
        (
            times(&drift_square, &times(&below, &above)),
            times(&fall_square, &times(&levers, &levers)),
        )
    };
    core::array::from_fn(|n| first[n] - second[n])
}

/// The slip of a glide on a slope that starts with the slip velocity `slip`.
pub(super) fn slip(particle: &Particle, slip: f64, entry: GlideEntry) -> Slip {
    let tilt = particle.pull;
    let (l, inside, side) = (particle.offset, particle.inside, particle.side);
    let (a, b, rise) = (particle.below_top, particle.above_bottom, particle.rise);
    let (rate, spin) = particle.spin();
    let lever = inside + b;
    let arm = side * (a * b).sqrt();
    // G = ℓ̂ sin θ η″ at η′ = 0; N of rolling has its sign.
    let level = b * ((1.0 - rate) * (1.0 + rate)) + inside * (1.0 + l * spin);
    let (begun, pull) = entry.begun(slip, level - tilt * arm);
    let start = ParticleState {
        elapsed: 0.0,
        below_top: a,
        above_bottom: b,
        fall_rate: -rise,
    };
    let mut q = condition(particle, &start, particle.momentum, 1.0);
    // The first coefficients, without cancellation.
    let product = if inside == 0.0 { a } else { a * b };
    let is_unresolved = begun.is_none() || slip.abs() < LEAST_RESOLVED_SLIP;
    q[0] = if is_unresolved {
        0.0
    } else {
        signed_product([product, slip, slip - 2.0 * rate * lever])
    };
    if is_unresolved {
        let levers = if inside == 0.0 { 1.0 } else { lever };
        q[1] = signed_product([2.0 * rise, pull, levers]);
    }
    let direction = begun.unwrap_or_else(|| {
        let next = q.iter().find(|c| **c != 0.0).map_or(0.0, |c| c.signum());
        let fall = if rise > 0.0 { -1.0 } else { 1.0 };
        let towards = if pull == 0.0 {
            -side * fall * next
        } else {
            side * pull
        };
        if towards < 0.0 {
            SlipDirection::Negative
        } else {
            SlipDirection::Positive
        }
    });
    if slip != 0.0 && is_unresolved && direction.sign() * side * pull < 0.0 {
        // η″ against so small a slip ends it at once.
        return Slip {
            direction,
            rest: Some(particle.place(0.0)),
        };
    }
    let end = particle.end();
    let mut cuts = vec![0.0];
    cuts.extend(
        [rise, particle.momentum / tilt]
            .into_iter()
            .filter(|at| *at > 0.0 && *at < end.elapsed),
    );
    cuts.push(end.elapsed);
    cuts.sort_by(f64::total_cmp);
    let rest = cuts.windows(2).find_map(|piece| {
        let (from, to) = (piece[0], piece[1]);
        let middle = 0.5 * (from + to);
        let drift = particle.momentum - tilt * middle;
        if signed_product([drift, side, middle - rise]) >= 0.0 {
            return None;
        }
        let is_last = to == end.elapsed;
        let place = if is_last { end } else { particle.place(to) };
        let before = condition(particle, &place, particle.momentum - tilt * to, -1.0);
        // Not the polynomial about the start shifted to here: its terms would cancel.
        let after = if from == 0.0 {
            q
        } else {
            let place = particle.place(from);
            condition(particle, &place, particle.momentum - tilt * from, 1.0)
        };
        let sign = direction.sign() * drift.signum();
        Some(match first_rest((after, before, to - from), sign)? {
            Along::FromBegin(at) => particle.place(from + at),
            Along::ToEnd(left) => place.before(left),
        })
    });
    Slip { direction, rest }
}
