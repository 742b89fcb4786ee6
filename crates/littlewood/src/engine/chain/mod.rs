//! Chains of slips: whole powers of the map from one slip out of rolling to the next.
//!
//! Rolling slips on curves of the phase plane, so that all that follows a slip is a function of one number, its angle. From
//! slip to slip (a slide, perhaps reversals, a stick, a roll, perhaps through turning points) a motion follows a map
//! of such angles, a *link*. A light hoop, or one with μk close to μs, makes thousands of links, each of
//! which takes off a little energy. The map of 2^k links is that of 2^(k−1) links, twice; its polynomials go through these
//! values at Chebyshev nodes ([`tree`]), and n links take some 2 log₂ n of them.
//!
//! Pieces are made when a motion first needs them, and are the same whichever motion that is.

mod passage;
mod tree;

use core::f64::consts::TAU;

use crate::hoop::Heavy;
use crate::links::LinkPhases;

use super::interpolant::Basis;
use super::roll::{RollTable, SlipPoint};
use tree::{Found, Tree};

pub(super) use passage::{Link, Passage};

/// Powers of two: most limits of transitions are below 2^14.
const LEVELS: usize = 14;

/// Follows a motion from a slip to the next.
pub(super) trait Follow {
    /// The link that begins at a slip with this rate, travelling to positive angles; none where the motion comes to another end.
    fn link(&self, point: SlipPoint, theta_rate: f64) -> Option<Link>;
}

/// The maps from slip to slip of one body.
#[derive(Clone, Debug)]
pub(super) struct Chains {
    roll: RollTable,
    basis: Basis,
    /// By the power of two, and the side of the slip at which the links begin.
    levels: Vec<[Tree; 2]>,
    /// By how much more than the smallest part rounding is seen in a link.
    noise: f64,
}

impl Chains {
    /// Of a body with these orbits of rolling. Nothing is computed yet.
    pub(super) fn new(body: &Heavy, roll: &RollTable) -> Self {
        let level = [0, 1].map(|side| Tree::new(&roll.slips(side)));
        Self {
            roll: roll.clone(),
            basis: Basis::new(),
            levels: vec![level; LEVELS],
            noise: (body.mass / body.inertia).sqrt().max(1.0),
        }
    }

    /// One link from a slip, with its phases.
    pub(super) fn link(&self, point: SlipPoint, follow: &impl Follow) -> Option<(Passage, LinkPhases)> {
        let found = self.found(0, point, follow)?;
        Some((found.at(point.angle), found.phases))
    }

    /// As many links from a slip as a motion has room for.
    pub(super) fn pass(
        &self,
        point: SlipPoint,
        follow: &impl Follow,
        has_room: impl Fn(&Passage) -> bool,
    ) -> Option<Passage> {
        let mut total: Option<Passage> = None;
        let (mut level, mut rises) = (0, true);
        loop {
            let here = total.map_or(point, |passage| passage.end);
            let next = self
                .found(level, here, follow)
                .map(|found| found.at(here.angle))
                .map(|next| total.map_or(next, |total| total.then(&next)))
                .filter(&has_room);
            match next {
                Some(passage) => {
                    total = Some(passage);
                    rises &= level + 1 < LEVELS;
                    level += usize::from(rises);
                }
                None if level == 0 => return total,
                None => {
                    rises = false;
                    level -= 1;
                }
            }
        }
    }

    /// |θ′| at a slip.
    pub(super) fn rate(&self, point: SlipPoint) -> Option<f64> {
        let u = self.roll.limit(point.side, point.angle)?;
        (u > 0.0).then(|| u.sqrt())
    }

    /// The piece of a level that holds a slip.
    fn found(&self, level: usize, point: SlipPoint, follow: &impl Follow) -> Option<&Found> {
        let tolerance = tree::CONVERGED * self.noise * (1_u64 << level) as f64;
        let tree = &self.levels[level][point.side];
        tree.find(point.angle, &self.basis, tolerance, &|angle| {
            self.value(level, SlipPoint { angle, ..point }, follow)
        })
    }

    /// What a piece of a level is made from.
    fn value(&self, level: usize, point: SlipPoint, follow: &impl Follow) -> Option<(Passage, LinkPhases)> {
        let Some(below) = level.checked_sub(1) else {
            let Link { passage, phases } = follow.link(point, self.rate(point)?)?;
            return Some((passage, phases));
        };
        let first = self.found(below, point, follow)?.at(point.angle);
        let second = self.found(below, first.end, follow)?.at(first.end.angle);
        Some((first.then(&second), LinkPhases::default()))
    }
}

/// An angle reduced to a turn, and the turns.
fn reduced(theta: f64) -> (f64, f64) {
    let turns = (theta / TAU).floor();
    (theta - TAU * turns, turns)
}
