//! Rolling along one orbit, to its slip, in the direction of motion (docs/engine.md): a zero of the
//! forms of [`crate::modes::rolling`] on the arcs ahead, isolated in Bernstein form.

use core::f64::consts::TAU;
use std::sync::OnceLock;

use crate::math::bracket::Bracket;
use crate::math::form::{Form, HalfAngle, on_arc};
use crate::model::Direction;

use super::fallback::Fallback;
use super::orbit::{Orbit, OrbitPass};

/// The side of a slip in the frame of motion, of a hoop that travels in the direction `travel`, 1
/// or −1.
pub(super) fn side_of(direction: Direction, travel: f64) -> usize {
    usize::from((direction == Direction::Positive) == travel.is_sign_positive())
}

pub(super) fn direction_of(side: usize, travel: f64) -> Direction {
    if (side == 1) == travel.is_sign_positive() {
        Direction::Positive
    } else {
        Direction::Negative
    }
}

/// A margin within this part of its terms of zero is solved exactly.
pub(super) const MARGIN_TOLERANCE: f64 = 1e-12;

/// Slower slips are solved exactly: an angle reduced to a turn is known to 4e-16, and at this rate
/// the time to 1e-13.
pub(super) const MIN_RATE: f64 = 4e-3;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum RollEnd {
    /// Slips at the angle, in the frame of motion, to a side.
    Slip {
        elapsed: f64,
        theta: f64,
        theta_rate: f64,
        side: usize,
        direction: (f64, f64),
    },
    /// Never slips.
    Never,
}

const OCTANTS: usize = 8;

/// Directions of the half angle at the ends of the octants.
const OCTANT_ENDS: [HalfAngle; OCTANTS + 1] = {
    const COS: f64 = 0.923_879_532_511_286_7;
    const SIN: f64 = 0.382_683_432_365_089_8;
    const BOTH: f64 = core::f64::consts::FRAC_1_SQRT_2;
    [
        [1.0, 0.0],
        [COS, SIN],
        [BOTH, BOTH],
        [SIN, COS],
        [0.0, 1.0],
        [-SIN, COS],
        [-BOTH, BOTH],
        [-COS, SIN],
        [-1.0, 0.0],
    ]
};

/// The margins of one body as A + L B with the level L = K − D(π), side by side.
pub(super) type Margins = [[Form<7>; 2]; 2];

/// The forms X^(6−k) Y^k in the barycentric coordinates of each octant, by the power of these, then
/// by k.
const POWERS: [[[f64; 7]; 7]; OCTANTS] = {
    let mut table = [[[0.0; 7]; 7]; OCTANTS];
    let mut octant = 0;
    while octant < OCTANTS {
        let mut k = 0;
        while k < 7 {
            let mut form = [0.0; 7];
            form[0] = 1.0;
            let mut factor = 0;
            while factor < 6 {
                let axis = if factor < k { 1 } else { 0 };
                let mut i = 6;
                while i > 0 {
                    form[i] = form[i] * OCTANT_ENDS[octant][axis]
                        + form[i - 1] * OCTANT_ENDS[octant + 1][axis];
                    i -= 1;
                }
                form[0] *= OCTANT_ENDS[octant][axis];
                factor += 1;
            }
            let mut i = 0;
            while i < 7 {
                table[octant][i][k] = form[i];
                i += 1;
            }
            k += 1;
        }
        octant += 1;
    }
    table
};

/// The levels L ≥ `least` for which all sums A + L B are positive, narrowed by what is in doubt,
/// from A and B with the sizes of their terms.
pub(super) fn holds(least: f64, sums: impl IntoIterator<Item = [(f64, f64); 2]>) -> (f64, f64) {
    let mut bounds = (least, f64::INFINITY);
    for [(a, a_size), (b, b_size)] in sums {
        let level = -a / b;
        let doubt = 4.0 * MARGIN_TOLERANCE * (a_size + level.abs() * b_size) / b.abs();
        if b > 0.0 {
            bounds.0 = f64::max(bounds.0, level + doubt);
        } else if b < 0.0 {
            bounds.1 = f64::min(bounds.1, level - doubt);
        } else if a <= MARGIN_TOLERANCE * a_size {
            bounds.1 = f64::NEG_INFINITY;
        }
    }
    bounds
}

/// Which of two margins is negative, if one is, from them with the sizes of their terms. None where
/// one is in doubt, or both are negative.
pub(super) fn breaks(margins: &[(f64, f64); 2]) -> Option<Option<usize>> {
    let mut broken = None;
    for (side, (margin, size)) in margins.iter().enumerate() {
        if margin.abs() <= MARGIN_TOLERANCE * size {
            return None;
        }
        if *margin < 0.0 {
            if broken.is_some() {
                return None;
            }
            broken = Some(side);
        }
    }
    Some(broken)
}

#[derive(Clone, Debug)]
struct MarginTable {
    /// In its barycentric coordinates.
    margins: Margins,
    /// The constants K of the orbits that certainly hold everywhere on it.
    levels: (f64, f64),
}

impl MarginTable {
    fn new(parts: &Margins, octant: usize) -> Self {
        let powers = &POWERS[octant];
        let margins = parts.map(|parts| {
            parts.map(|Form(part)| {
                Form(powers.map(|powers| powers.iter().zip(part).map(|(power, c)| power * c).sum()))
            })
        });
        let sizes = parts.map(|parts| {
            parts.map(|Form(part)| {
                powers.map(|powers| {
                    powers
                        .iter()
                        .zip(part)
                        .map(|(power, c)| (power * c).abs())
                        .sum::<f64>()
                })
            })
        });
        let sums = margins.iter().zip(&sizes).flat_map(|(forms, sizes)| {
            (0..7).map(move |k| [0, 1].map(|part: usize| (forms[part].0[k], sizes[part][k])))
        });
        Self {
            levels: holds(0.0, sums),
            margins,
        }
    }

    fn holds(&self, level: f64) -> bool {
        level > self.levels.0 && level < self.levels.1
    }

    /// The margin of a side on the orbit with a level, and what is known of it in this direction.
    fn margin(&self, side: usize, level: f64, is_up: bool) -> (Form<7>, MarginSigns) {
        let form = on_orbit(&self.margins[side], level);
        let mut passed = form.0;
        if !is_up {
            passed.reverse();
        }
        (form, MarginSigns::of(&passed))
    }
}

/// The octants of one hoop, made where orbits come, and the same whichever orbit that is.
#[derive(Clone, Debug, Default)]
pub(super) struct MarginTables {
    octants: [OnceLock<Box<MarginTable>>; OCTANTS],
    /// The levels of the orbits that certainly hold everywhere.
    levels: OnceLock<(f64, f64)>,
}

impl MarginTables {
    /// Whether the orbit with a level certainly holds everywhere.
    fn hold(&self, margins: &Margins, level: f64) -> bool {
        let (low, high) = *self.levels.get_or_init(|| {
            let levels = (0..OCTANTS).map(|number| self.get(margins, number).levels);
            levels.fold((0.0, f64::INFINITY), |all, one| {
                (all.0.max(one.0), all.1.min(one.1))
            })
        });
        level > low && level < high
    }

    fn get(&self, margins: &Margins, number: usize) -> &MarginTable {
        self.octants[number].get_or_init(|| Box::new(MarginTable::new(margins, number)))
    }
}

/// What the signs of the Bernstein coefficients of a margin tell.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum MarginSigns {
    /// It is positive.
    Holds,
    /// It falls through zero once.
    Falls,
    Nothing,
}

impl MarginSigns {
    /// From the coefficients in order of passage.
    pub(super) fn of(coefficients: &[f64]) -> Self {
        let (above, rest) =
            coefficients.split_at(coefficients.iter().take_while(|c| **c > 0.0).count());
        match rest.last() {
            None => Self::Holds,
            Some(last) if !above.is_empty() && *last < 0.0 && rest.iter().all(|c| *c <= 0.0) => {
                Self::Falls
            }
            Some(_) => Self::Nothing,
        }
    }
}

fn on_orbit([a, b]: &[Form<7>; 2], level: f64) -> Form<7> {
    Form(core::array::from_fn(|i| a.0[i] + level * b.0[i]))
}

/// Positive where the second direction lies ahead of the first.
fn cross([x0, y0]: HalfAngle, [x1, y1]: HalfAngle) -> f64 {
    x0 * y1 - y0 * x1
}

/// Part of an orbit between two directions of the half angle.
#[derive(Clone, Copy, Debug)]
struct OrbitArc {
    from: HalfAngle,
    to: HalfAngle,
    pass: OrbitPass,
}

impl OrbitArc {
    fn parts(self) -> impl Iterator<Item = (usize, Self)> {
        let Self { from, to, pass } = self;
        let is_up = cross(from, to) > 0.0;
        let is_behind = |edge: &HalfAngle| {
            let side = cross(*edge, from);
            side > 0.0 || (is_up && side == 0.0)
        };
        let mut octant = OCTANT_ENDS[1..OCTANTS]
            .iter()
            .filter(|edge| is_behind(edge))
            .count();
        let mut left = Some(from);
        core::iter::from_fn(move || {
            let from = left?;
            let edge = OCTANT_ENDS[if is_up { octant + 1 } else { octant }];
            let ahead = cross(edge, to);
            let goes_on = if is_up {
                ahead > 0.0 && octant + 1 < OCTANTS
            } else {
                ahead < 0.0 && octant > 0
            };
            let number = octant;
            if goes_on {
                left = Some(edge);
                octant = if is_up { octant + 1 } else { octant - 1 };
            } else {
                left = None;
            }
            Some((
                number,
                Self {
                    from,
                    to: if goes_on { edge } else { to },
                    pass,
                },
            ))
        })
    }
}

/// The first of two crossings, the second of a side.
fn earlier(first: Option<(f64, usize)>, at: Option<f64>, side: usize) -> Option<(f64, usize)> {
    match (first, at) {
        (Some((before, _)), Some(at)) if at >= before => first,
        (_, Some(at)) => Some((at, side)),
        (_, None) => first,
    }
}

/// Follows an orbit on which rolling holds where it is entered, perhaps just so (`on_limit`).
/// `kept` are the octants of long motions.
pub(super) fn follow(
    orbit: &Orbit<'_>,
    margins: &Margins,
    on_limit: bool,
    kept: Option<&MarginTables>,
) -> Result<RollEnd, Fallback> {
    let level = orbit.level();
    if let (Some(kept), false) = (kept, on_limit)
        && kept.hold(margins, level)
    {
        return Ok(RollEnd::Never);
    }
    let here = margins.map(|parts| {
        let direction = [-orbit.z, orbit.y];
        let [a, b] = parts.map(|part| part.value(direction));
        let [a_size, b_size] = parts.map(|part| part.size(direction));
        (a + level * b, a_size + level * b_size)
    });
    let limit = on_limit.then(|| usize::from(here[1].0.abs() < here[0].0.abs()));
    // So close to the limit, rounding would decide whether the hoop slips at once.
    if breaks(&limit.map_or(here, |side| [here[1 - side]; 2])) != Some(None) {
        return Err(Fallback::FrictionLimit);
    }
    let slip_on = |arc: &OrbitArc, starts_at_zero: Option<usize>, holds: &dyn Fn(usize) -> bool| {
        let mut first: Option<(f64, usize)> = None;
        for (side, parts) in margins.iter().enumerate() {
            if holds(side) {
                continue;
            }
            let margin = on_orbit(parts, level).restricted(arc.from, arc.to);
            if starts_at_zero == Some(side) {
                let margin = margin.bernstein().starting_at_zero();
                let at = margin
                    .first_crossing()
                    .map(|bracket| bracket.refine(|t| margin.value_and_slope(t)));
                first = earlier(first, at, side);
                continue;
            }
            // No crossing without a change of sign.
            if margin.0.iter().all(|c| *c > 0.0) {
                continue;
            }
            let at = margin.bernstein().first_crossing().map(|bracket| {
                bracket.refine_from_secant(|t| margin.value_and_slope([1.0 - t, t], [-1.0, 1.0]))
            });
            first = earlier(first, at, side);
        }
        first
    };
    let Some(kept) = kept else {
        for (number, arc) in arcs(orbit).enumerate() {
            if let Some((at, side)) = slip_on(&arc, limit.filter(|_| number == 0), &|_| false) {
                return slip(orbit, &arc, at, side);
            }
        }
        return Ok(RollEnd::Never);
    };
    for (passed, (number, arc)) in arcs(orbit).flat_map(OrbitArc::parts).enumerate() {
        let octant = kept.get(margins, number);
        if octant.holds(level) {
            continue;
        }
        let is_up = cross(arc.from, arc.to) > 0.0;
        let starts_at_zero = limit.filter(|_| passed == 0);
        let known = [0, 1].map(|side| octant.margin(side, level, is_up));
        let falling = match &known {
            [(form, MarginSigns::Falls), (_, MarginSigns::Holds)] => Some((form, 0)),
            [(_, MarginSigns::Holds), (form, MarginSigns::Falls)] => Some((form, 1)),
            _ => None,
        };
        // The margin is positive where the arc begins: it falls ahead.
        let (begin, end) = (OCTANT_ENDS[number], OCTANT_ENDS[number + 1]);
        if let (Some((form, side)), None, true) = (
            falling,
            starts_at_zero,
            arc.to == if is_up { end } else { begin },
        ) {
            let (from, to) = if is_up { (begin, end) } else { (end, begin) };
            let at = Bracket {
                low: 0.0,
                high: 1.0,
            }
            .refine_from_secant(|t| {
                if is_up {
                    form.value_and_slope([1.0 - t, t], [-1.0, 1.0])
                } else {
                    form.value_and_slope([t, 1.0 - t], [1.0, -1.0])
                }
            });
            return slip(orbit, &OrbitArc { from, to, ..arc }, at, side);
        }
        if let Some((at, side)) = slip_on(&arc, starts_at_zero, &|side| {
            known[side].1 == MarginSigns::Holds
        }) {
            return slip(orbit, &arc, at, side);
        }
    }
    Ok(RollEnd::Never)
}

/// The arcs that lie ahead, until every point of the orbit has been passed.
fn arcs(orbit: &Orbit<'_>) -> impl Iterator<Item = OrbitArc> {
    let here = [-orbit.z, orbit.y];
    let bottom = [0.0, 1.0];
    let past_bottom = orbit.z >= 0.0;
    let arc = |from, to, pass| OrbitArc { from, to, pass };
    let farthest = if orbit.rotates {
        [-1.0, 0.0]
    } else {
        let four_l = 4.0 * orbit.law.offset;
        [
            -(orbit.swing / four_l).sqrt(),
            (orbit.excess / four_l).sqrt(),
        ]
    };
    let first = (!past_bottom).then(|| arc(here, bottom, OrbitPass::First));
    let second = arc(
        if past_bottom { here } else { bottom },
        farthest,
        OrbitPass::First,
    );
    let (third, fourth) = if orbit.rotates {
        let third = arc(
            [1.0, 0.0],
            if past_bottom { bottom } else { here },
            OrbitPass::NextTurn,
        );
        (
            third,
            past_bottom.then(|| arc(bottom, here, OrbitPass::NextTurn)),
        )
    } else {
        let [x, y] = farthest;
        (
            arc(farthest, bottom, OrbitPass::WayBack),
            Some(arc(bottom, [-x, y], OrbitPass::WayBack)),
        )
    };
    [first, Some(second), Some(third), fourth]
        .into_iter()
        .flatten()
        .filter(|arc| arc.from != arc.to)
}

fn slip(orbit: &Orbit<'_>, arc: &OrbitArc, at: f64, side: usize) -> Result<RollEnd, Fallback> {
    let [x, y] = on_arc(arc.from, arc.to, at);
    let z = -x;
    let four_l = 4.0 * orbit.law.offset;
    let d = orbit.law.bottom + four_l * z * z;
    // K − D changes by 4ℓ̂ (z0² − z²).
    let kinetic = if orbit.rotates {
        orbit.excess + four_l * y * y
    } else {
        (orbit.kinetic + four_l * (orbit.z - z) * (orbit.z + z)).max(0.0)
    };
    let rate = (kinetic / d).sqrt();
    if rate < MIN_RATE {
        return Err(Fallback::Standstill);
    }
    let (lap, rate) = match arc.pass {
        OrbitPass::First => (orbit.lap, rate),
        OrbitPass::NextTurn => (orbit.lap + 1.0, rate),
        OrbitPass::WayBack => (orbit.lap, -rate),
    };
    let angle = 2.0 * libm::atan2(y, -z);
    Ok(RollEnd::Slip {
        elapsed: orbit.time(orbit.phase(z, y, kinetic), arc.pass),
        theta: TAU * lap + angle,
        theta_rate: rate,
        side,
        direction: (-2.0 * y * z, z * z - y * y),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::chain::SlipCurves;
    use crate::mechanics::RollingLaw;
    use crate::model::{Hoop, HoopParameters, State};
    use crate::modes::Rolling;
    use crate::modes::rolling::margin_forms;

    fn half_angle(theta: f64) -> HalfAngle {
        let (y, x) = libm::sincos(0.5 * theta);
        [x, y]
    }

    /// Where a margin vanishes and grows behind, on both sides of the body, forth and back: the
    /// exact solver's slip, by the orbit alone and by what is kept of it.
    #[test]
    fn an_orbit_on_the_limit_slips_where_it_does_for_the_exact_solver() {
        let mut slips = 0;
        for (mass_ratio, inertia, mu_s) in [(1.0, 1.0, 0.5), (2.0, 0.5, 0.2), (0.1, 0.07, 0.9)] {
            let hoop = HoopParameters::thin(mass_ratio)
                .with_offset(0.9)
                .with_inertia(inertia)
                .with_friction(mu_s, 0.0);
            let hoop = Hoop::new(hoop).unwrap();
            let (margins, law) = (margin_forms(&hoop, 1.0).unwrap(), RollingLaw::of(&hoop));
            let curve = SlipCurves::new(margins, law);
            for (step, side) in (0..300).flat_map(|step| [0, 1].map(|side| (step, side))) {
                let theta = 0.021 * f64::from(step) - 3.1;
                let Some(u) = curve.limit(side, theta).filter(|u| *u > 1e-2) else {
                    continue;
                };
                let rate = u.sqrt();
                let Some(orbit) = Orbit::enter(&law, theta, rate) else {
                    continue;
                };
                let ahead = on_orbit(&margins[side], orbit.level()).value(half_angle(theta + 1e-4));
                if ahead < 1e-9 {
                    continue;
                }
                let start = State {
                    time: 0.0,
                    theta,
                    theta_rate: rate,
                    slip: 0.0,
                    x: 0.0,
                };
                let expected = Rolling::new(&hoop, start).orbit().end_from_limit();
                let octants = MarginTables::default();
                for kept in [None, Some(&octants)] {
                    let found = follow(&orbit, &margins, true, kept);
                    match (found, expected) {
                        (
                            Ok(RollEnd::Slip {
                                elapsed,
                                theta,
                                theta_rate,
                                ..
                            }),
                            Some(end),
                        ) => {
                            for (found, expected) in [
                                (elapsed, end.elapsed),
                                (theta, end.theta),
                                (theta_rate, end.theta_rate),
                            ] {
                                let allowed = 1e-12 * (1.0 + expected.abs());
                                assert!(
                                    (found - expected).abs() < allowed,
                                    "{orbit:?}: {found} {expected}"
                                );
                            }
                            slips += 1;
                        }
                        (Ok(RollEnd::Never), _) | (Ok(_), None) => {
                            panic!("{orbit:?} {found:?} {expected:?}")
                        }
                        (Err(_), _) => {}
                    }
                }
            }
        }
        assert!(slips > 500, "{slips}");
    }

    #[test]
    fn the_parts_of_an_arc_are_the_arc() {
        let at = |turns: f64| {
            let (y, x) = libm::sincos(core::f64::consts::PI * turns);
            [x, y]
        };
        // From octants 0.8 to 5.3, back, inside one, and from edge to edge.
        for (from, to, octants) in [
            (at(0.1), at(0.66), vec![0, 1, 2, 3, 4, 5]),
            (at(0.66), at(0.1), vec![5, 4, 3, 2, 1, 0]),
            (at(0.3), at(0.35), vec![2]),
            (at(0.35), at(0.3), vec![2]),
            (OCTANT_ENDS[0], OCTANT_ENDS[4], vec![0, 1, 2, 3]),
            (OCTANT_ENDS[4], OCTANT_ENDS[8], vec![4, 5, 6, 7]),
            (OCTANT_ENDS[4], OCTANT_ENDS[2], vec![3, 2]),
            ([-1.0, 0.0], OCTANT_ENDS[4], vec![7, 6, 5, 4]),
        ] {
            let parts: Vec<(usize, OrbitArc)> = OrbitArc {
                from,
                to,
                pass: OrbitPass::First,
            }
            .parts()
            .collect();
            assert_eq!(parts.iter().map(|part| part.0).collect::<Vec<_>>(), octants);
            assert_eq!((parts[0].1.from, parts[parts.len() - 1].1.to), (from, to));
            assert!(parts.windows(2).all(|pair| pair[0].1.to == pair[1].1.from));
            for (octant, OrbitArc { from, to, .. }) in parts {
                let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
                assert!(
                    cross(OCTANT_ENDS[octant], middle) > 0.0
                        && cross(middle, OCTANT_ENDS[octant + 1]) > 0.0
                );
            }
        }
    }

    #[test]
    fn the_margin_that_is_negative_is_told_where_it_is_clear() {
        // 1 − L and 3 + L, with levels next to the zero of the first.
        let margins = |level: f64| [(1.0 - level, 1.0 + level), (3.0 + level, 3.0 + level)];
        for (level, broken) in [
            (0.5, Some(None)),
            (1.0 - 1e-11, Some(None)),
            (1.0 - 1e-12, None),
            (1.0 + 1e-12, None),
            (1.0 + 1e-11, Some(Some(0))),
            (2.0, Some(Some(0))),
        ] {
            let [first, second] = margins(level);
            assert_eq!(breaks(&[first, second]), broken, "{level}");
            let swapped = broken.map(|broken| broken.map(|side: usize| 1 - side));
            assert_eq!(breaks(&[second, first]), swapped, "{level}");
        }
        assert_eq!(breaks(&[(-1.0, 3.0), (-1.0, 3.0)]), None, "both");
    }

    #[test]
    fn an_orbit_on_the_limit_is_not_said_to_hold() {
        let of = |margins: [[f64; 2]; 2]| {
            holds(
                0.0,
                margins.map(|parts| parts.map(|part| (part, part.abs()))),
            )
        };
        // Margins L − 2 and 6 − 2 L, both positive for 2 < L < 3.
        let (least, most) = of([[-2.0, 1.0], [6.0, -2.0]]);
        assert!(
            least > 2.0 * (1.0 + MARGIN_TOLERANCE) && least < 2.0 + 1e-10,
            "{least:e}"
        );
        assert!(
            most < 3.0 * (1.0 - MARGIN_TOLERANCE) && most > 3.0 - 1e-10,
            "{most:e}"
        );
        // A margin that no orbit changes.
        assert_eq!(of([[1.0, 0.0], [1.0, 0.0]]), (0.0, f64::INFINITY));
        assert_eq!(of([[1.0, 0.0], [-1.0, 0.0]]).1, f64::NEG_INFINITY);
    }
}
