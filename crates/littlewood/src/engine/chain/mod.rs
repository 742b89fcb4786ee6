//! SlipMaps of slips (docs/engine.md): whole powers of the map from one slip out of rolling to the
//! next, a *link*.
//!
//! The map of 2^k links is that of 2^(k−1) links, twice; its polynomials go through these values at
//! Chebyshev nodes ([`tree`]), and n links take some 2 log₂ n of them. Pieces are made when a
//! motion first needs them, and are the same whichever motion that is.

mod curve;
mod slip_curves;
mod tree;
mod value;

use crate::model::{Heavy, Hoop, SlipDirection, State};
use crate::modes::Levels;
use crate::walk::PhaseSequence;

use super::interpolant::Basis;
use super::model::HoopModel;
use super::roll::{Margins, margins_of};
use curve::{CurvePoint, Curves};
use tree::{FitContext, FittedMap, Tree};

pub(super) use slip_curves::{SlipCurves, SlipPoint};
pub(super) use value::SlipMapValue;

/// Powers of two: most limits of transitions are below 2^14.
const LEVELS: usize = 14;

/// Successes on a exponent after which a higher one is tried that has failed.
const SUCCESSES_BEFORE_RETRY: usize = 2;

pub(super) trait LinkSolver {
    /// The state at the end of the link that begins at a slip with this rate, travelling to
    /// positive angles from x = 0 at τ = 0 in the frame of the chains, with the direction of the
    /// slip there, the length of the slides, and the phases; none where the motion comes to another
    /// end, or it may be known there that it slips for ever.
    fn link(
        &self,
        maps: &SlipMaps,
        slip: SlipPoint,
        theta_rate: f64,
    ) -> Option<(State, SlipDirection, f64, PhaseSequence)>;
}

/// The maps from slip to slip of one body.
#[derive(Clone, Debug)]
pub(super) struct SlipMaps {
    curves: Curves,
    basis: Basis,
    /// By the power of two, and the part of the curves at which the links begin.
    levels: Vec<Vec<Tree>>,
    /// By how much more than the smallest part rounding is seen in a link.
    noise: f64,
    /// With μs = μk, towards which orbits slips lead.
    grazing: Option<Levels>,
    /// On a slope, the direction of motion in which all slips are.
    heading: Option<f64>,
}

impl SlipMaps {
    /// Of a hoop with these equations: for all slips, or on a slope for those in each direction of
    /// motion. Nothing is computed yet.
    pub(super) fn new(hoop: &Hoop, model: &HoopModel) -> Vec<Self> {
        let travels: &[Option<f64>] = if hoop.slope() == 0.0 {
            &[None]
        } else {
            &[Some(1.0), Some(-1.0)]
        };
        let margins =
            |heading: &Option<f64>| Some((*heading, margins_of(hoop, heading.unwrap_or(1.0))?));
        travels
            .iter()
            .filter_map(margins)
            .map(|(heading, margins)| Self::of(hoop, model, heading, margins))
            .collect()
    }

    fn of(hoop: &Hoop, model: &HoopModel, heading: Option<f64>, margins: Margins) -> Self {
        let Heavy { mass, inertia, .. } = model.body;
        let curves = Curves::new(SlipCurves::new(margins, model.rolling));
        let exponent = curves
            .bounds()
            .map(|(left, right)| Tree::new(left, right, 0))
            .collect();
        Self {
            curves,
            basis: Basis::new(),
            levels: vec![exponent; LEVELS],
            noise: (mass / inertia).sqrt().max(1.0),
            grazing: if hoop.mu_s() == hoop.mu_k() && hoop.slope() == 0.0 {
                Levels::new(hoop)
            } else {
                None
            },
            heading,
        }
    }

    /// −1 if the frame of the maps is mirrored, else 1.
    pub(super) fn mirror(&self) -> f64 {
        self.heading.unwrap_or(1.0)
    }

    /// The point of the curves at which a slip in this direction begins. On a slope each direction
    /// of motion has its own curves; for a state that moves the other way the result is `None`.
    pub(super) fn point(&self, state: &State, direction: SlipDirection) -> Option<CurvePoint> {
        if self.heading.is_some() && state.theta_rate < 0.0 {
            return None;
        }
        self.curves
            .point(SlipPoint::of(state, direction), state.theta_rate)
    }

    /// The slip at a point, and |θ′|.
    pub(super) fn slip(&self, point: CurvePoint) -> Option<(SlipPoint, f64)> {
        self.curves.slip(point)
    }

    /// With μs = μk, the levels of the orbits towards which slips lead.
    pub(super) const fn levels(&self) -> Option<&Levels> {
        self.grazing.as_ref()
    }

    /// Whether a link, which has one slide, leads to a grazing orbit for sure: such a slip may end
    /// a motion, and is no link.
    pub(super) fn is_last(
        &self,
        hoop: &Hoop,
        slip: &State,
        end: &State,
        phases: PhaseSequence,
    ) -> bool {
        let Some(levels) = &self.grazing else {
            return false;
        };
        let [before, after] = [slip, end].map(|state| levels.energy(state));
        phases.len() == 2 && levels.attracting(hoop, before, after).is_some()
    }

    /// Links from a slip one by one, as many as a motion has room for and a sequence holds the
    /// phases of.
    pub(super) fn links(
        &self,
        point: CurvePoint,
        follow: &impl LinkSolver,
        has_room: impl Fn(&SlipMapValue) -> bool,
    ) -> Option<(SlipMapValue, PhaseSequence)> {
        let mut passed: Option<(SlipMapValue, PhaseSequence)> = None;
        loop {
            let here = passed.map_or(point, |(total, _)| total.end);
            let Some(found) = self.found(0, here, follow) else {
                return passed;
            };
            let link = found.from(here.at);
            let next = match passed {
                None => (link, found.phases),
                Some((total, mut phases)) => {
                    // A link is seen in the frame of motion where it begins.
                    phases.append(if total.is_back() {
                        found.phases.mirrored()
                    } else {
                        found.phases
                    });
                    (total.then(&link), phases)
                }
            };
            if next.1.is_truncated() || !has_room(&next.0) {
                return passed;
            }
            passed = Some(next);
        }
    }

    /// As many links from a slip as a motion has room for.
    pub(super) fn pass(
        &self,
        point: CurvePoint,
        follow: &impl LinkSolver,
        has_room: impl Fn(&SlipMapValue) -> bool,
    ) -> Option<SlipMapValue> {
        let mut total: Option<SlipMapValue> = None;
        let mut exponent = 0;
        // Links passed on this exponent since it was found to be the highest: enough of them, and a
        // higher one is tried again.
        let mut passed = SUCCESSES_BEFORE_RETRY;
        loop {
            let here = total.map_or(point, |passage| passage.end);
            let next = self
                .found(exponent, here, follow)
                .map(|found| found.from(here.at))
                .map(|next| total.map_or(next, |total| total.then(&next)))
                .filter(&has_room);
            match next {
                Some(passage) => {
                    total = Some(passage);
                    passed += 1;
                    if passed >= SUCCESSES_BEFORE_RETRY && exponent + 1 < LEVELS {
                        exponent += 1;
                    }
                }
                None if exponent == 0 => return total,
                None => {
                    exponent -= 1;
                    passed = 0;
                }
            }
        }
    }

    /// The piece of a exponent that holds a slip.
    fn found(
        &self,
        exponent: usize,
        point: CurvePoint,
        follow: &impl LinkSolver,
    ) -> Option<&FittedMap> {
        let (more, end) = self.curves.more_halvings(point.part);
        let making = FitContext {
            basis: &self.basis,
            curves: &self.curves,
            tolerance: tree::TOLERANCE * self.noise * (1_u64 << exponent) as f64,
            halvings: tree::MAX_HALVINGS + (self.noise as u32).ilog2() + more,
            end,
            value: &|at| self.value(exponent, CurvePoint { at, ..point }, follow),
        };
        self.levels[exponent][point.part].find(point.at, &making)
    }

    /// What a piece of a exponent is made from.
    fn value(
        &self,
        exponent: usize,
        point: CurvePoint,
        follow: &impl LinkSolver,
    ) -> Option<(SlipMapValue, PhaseSequence)> {
        let Some(below) = exponent.checked_sub(1) else {
            let (slip, rate) = self.curves.slip(point)?;
            let (end, direction, slid, phases) = follow.link(self, slip, rate)?;
            return Some((
                SlipMapValue::to(&end, self.point(&end, direction)?, slid, phases),
                phases,
            ));
        };
        let first = self.found(below, point, follow)?.from(point.at);
        let second = self.found(below, first.end, follow)?.from(first.end.at);
        Some((first.then(&second), PhaseSequence::default()))
    }
}
