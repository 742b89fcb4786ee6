//! Half swings with rolling resistance on a level plane: a family with one parameter.
//!
//! From a turning point outside of the band of rest the hoop rolls to the next one. The angle turned
//! and the time are functions of the angle at which it begins, and on parts of a turn polynomials
//! through half swings that [`RollTables`] has followed.
//!
//! That none of them slips is proved for all: orbits do not cross in the (ϑ, u) plane, so that u of
//! one that begins nearer to the bottom lies between zero and u of one that begins farther away. The
//! margins of static friction are linear in u. Where they are positive at rest, at every angle, and
//! on the widest orbit of a part, they are positive on all.

use core::f64::consts::PI;
use std::sync::OnceLock;

use crate::math::trig::{Angle, without_turns};

use super::interpolant::{Basis, Interpolant, NODES, Tolerance};
use super::slide::{RollStart, RollStop, RollTables};

/// Parts of the angles at which half swings begin, before they are halved.
const PARTS: usize = 16;

/// How often a part is halved where its polynomials have not converged, next to the top.
const HALVINGS: usize = 5;

/// Angle and time are told to a few units in the last place of the largest of a part, or of 1: so
/// much is rounding of the half swings at the nodes.
const TOLERANCE: Tolerance = Tolerance {
    relative: 2e-15,
    least: 2e-15,
};

/// By how many tolerances the polynomials may miss half swings that are not at nodes.
const MAX_MISS: f64 = 8.0;

/// Where half swings are compared with the polynomials, as parts of a part from its widest one on:
/// none is a node, and none begins at rest.
const PROBES: [f64; 3] = [1.0, 0.5, 1e-3];

/// The angle turned in a half swing, and its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct HalfSwing {
    pub(super) turned: f64,
    pub(super) elapsed: f64,
}

/// The half swings of a hoop, computed when a motion first needs them, and the same whichever motion
/// that is.
#[derive(Clone, Debug)]
pub(super) struct HalfSwings {
    basis: Basis,
    /// The angle at the edge of the lower band of rest, and from there to that of the upper band.
    edge: f64,
    range: f64,
    parts: [Box<[OnceLock<Fit>]>; HALVINGS + 1],
}

/// The half swings that begin on a part.
#[derive(Clone, Debug)]
enum Fit {
    Interpolated(Box<Interpolant<2>>),
    /// Its halves may do better.
    Halved,
    /// They are followed.
    Followed,
}

impl HalfSwings {
    /// None where a hoop rests anywhere, or slips at rest at some angle.
    pub(super) fn new(tables: &RollTables) -> Option<Self> {
        let lean = libm::asin(tables.band_of_rest()?);
        tables.holds_at_rest().then(|| Self {
            basis: Basis::new(),
            edge: PI - lean,
            range: PI - 2.0 * lean,
            parts: core::array::from_fn(|halvings| {
                (0..PARTS << halvings).map(|_| OnceLock::new()).collect()
            }),
        })
    }

    /// The half swing that begins at an angle, in the frame of motion; none where it has to be
    /// followed.
    pub(super) fn from(&self, theta: f64, tables: &RollTables) -> Option<HalfSwing> {
        let away = self.edge - without_turns(theta);
        let narrowest = away / self.range * (PARTS << HALVINGS) as f64;
        if away.is_nan() || narrowest < 0.0 {
            return None;
        }
        for (halvings, parts) in self.parts.iter().enumerate() {
            let number = narrowest as usize >> (HALVINGS - halvings);
            let part = parts
                .get(number)?
                .get_or_init(|| self.part(halvings, number, tables));
            match part {
                Fit::Interpolated(ends) => {
                    let [turned, elapsed] = ends.at(away);
                    return Some(HalfSwing { turned, elapsed });
                }
                Fit::Halved => {}
                Fit::Followed => return None,
            }
        }
        None
    }

    fn part(&self, halvings: usize, number: usize, tables: &RollTables) -> Fit {
        let width = self.range / (PARTS << halvings) as f64;
        let left = number as f64 * width;
        let probes = PROBES.map(|part| left + part * width);
        let solved = probes.map(|away| self.solved(away, tables));
        if solved.iter().all(Option::is_none) {
            return Fit::Followed;
        }
        self.fitted(left, left + width, tables)
            .filter(|ends| {
                probes.iter().zip(&solved).all(|(away, solved)| {
                    let pairs = solved.map(|solved| ends.at(*away).into_iter().zip(solved));
                    pairs.is_some_and(|mut pairs| {
                        pairs.all(|(a, b)| (a - b).abs() <= MAX_MISS * TOLERANCE.of(b))
                    })
                })
            })
            .map_or(Fit::Halved, |ends| Fit::Interpolated(Box::new(ends)))
    }

    fn fitted(&self, left: f64, right: f64, tables: &RollTables) -> Option<Interpolant<2>> {
        let mut values = [[0.0; 2]; NODES];
        for (value, away) in values.iter_mut().zip(self.basis.nodes(left, right)) {
            *value = self.solved(away, tables)?;
        }
        self.basis.through(left, right, &values, &[TOLERANCE; 2])
    }

    /// Angle turned and time of the half swing from a distance from the lower band of rest, if it
    /// ends at a turning point.
    fn solved(&self, away: f64, tables: &RollTables) -> Option<[f64; 2]> {
        let theta = self.edge - away;
        let start = RollStart {
            mirror: 1.0,
            theta,
            angle: Angle::of(theta),
            u: 0.0,
            time_left: f64::INFINITY,
            uses_tables: true,
        };
        let end = tables.solve(&start).ok()?;
        matches!(end.stop, RollStop::Turn { .. }).then_some([end.theta - theta, end.elapsed])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Hoop, HoopParameters};

    /// From angles all over the way between the bands of rest, next to the lower one, too. Next to the
    /// upper one a half swing takes for ever, and polynomials do not converge.
    #[test]
    fn interpolated_half_swings_are_those_that_are_followed() {
        for (mass_ratio, inertia, mu_s, chi) in [
            (1.0, 1.0, 0.5, 1e-6),
            (1.0, 1.0, 0.5, 0.01),
            (1.0, 1.0, 0.5, 0.2),
            (0.2, 0.4, 0.9, 0.05),
            (0.05, 0.05, 2.0, 0.02),
        ] {
            let parameters = HoopParameters::thin(mass_ratio)
                .with_inertia(inertia)
                .with_friction(mu_s, 0.8 * mu_s)
                .with_rolling_resistance(chi);
            let hoop = Hoop::new(parameters).unwrap();
            let tables = RollTables::new(&hoop, &hoop.rigid_body());
            let half_swings = HalfSwings::new(&tables).expect("it holds at rest");
            let (mut interpolated, count) = (0, 1_000);
            for k in 1..count {
                let part = f64::from(k) / f64::from(count);
                let away = half_swings.range * part * part;
                let theta = half_swings.edge - away;
                let Some(HalfSwing { turned, elapsed }) = half_swings.from(theta, &tables) else {
                    continue;
                };
                let expected = half_swings.solved(away, &tables).expect("it turns back");
                // h sin ϑ − χ, which drives it, is known to ε, and so the time to ε over the distance.
                let known = f64::EPSILON * expected[1] / away;
                for (found, expected) in [turned, elapsed].into_iter().zip(expected) {
                    let error = (found - expected).abs();
                    let tolerance = 4e-14 * (1.0 + expected) + known;
                    assert!(error <= tolerance, "{chi} {theta}: {error:e}");
                }
                interpolated += 1;
            }
            assert!(3 * interpolated > 2 * count, "{chi}: {interpolated}");
        }
    }

    /// A hoop that slips from rest at some angle, or rests anywhere, has no half swings of this kind.
    #[test]
    fn half_swings_that_slip_are_followed() {
        for (mu_s, chi) in [(0.1, 0.01), (0.5, 0.6)] {
            let level = Hoop::equal_masses(mu_s, mu_s).unwrap();
            let hoop = Hoop::new(level.parameters().with_rolling_resistance(chi)).unwrap();
            let tables = RollTables::new(&hoop, &hoop.rigid_body());
            assert!(HalfSwings::new(&tables).is_none(), "{mu_s} {chi}");
        }
    }
}
