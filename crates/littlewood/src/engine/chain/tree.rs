//! The maps of 2^k links on one curve of slips, by polynomials on pieces that are made when they
//! are needed, and halved where a phase begins to appear or vanishes.

use std::sync::OnceLock;

use crate::walk::PhaseSequence;

use super::super::interpolant::{Basis, Interpolant, NODES, Tolerance};
use super::curve::{CurvePoint, Curves};
use super::value::{Itinerary, SlipMapValue};

/// Polynomials have converged when their last coefficients are below this part of the largest
/// value, times what rounding in a link is amplified by.
pub(super) const TOLERANCE: f64 = 2e-15;

/// Most halvings of a part for a heavy hoop. The finest structure of a light one is finer by as
/// much as it amplifies rounding. What is left is narrow, and followed phase by phase in less time
/// than finer pieces would take.
pub(super) const MAX_HALVINGS: u32 = 12;

/// CurvePart of the tolerance to which the level of an orbit is known: a few units in its last place.
const LEVEL_ROUNDING: f64 = 0.25;

/// Halvings after which an interval without links at its ends and its middle is taken to have none.
const MIN_HALVINGS_SEARCHED: u32 = 3;

/// To this the length of slides is told.
const LENGTH_TOLERANCE: f64 = 1e-9;

/// By how many tolerances the polynomials may miss the links between the nodes.
const MAX_MISS: f64 = 8.0;

#[derive(Clone, Debug)]
pub(super) struct FittedMap {
    route: Itinerary,
    pub(super) phases: PhaseSequence,
    numbers: Interpolant<4>,
}

impl FittedMap {
    #[inline]
    pub(super) fn from(&self, at: f64) -> SlipMapValue {
        SlipMapValue::with_numbers(self.route, self.numbers.at(at))
    }
}

#[derive(Clone, Debug)]
enum Fit {
    Found(Box<FittedMap>),
    Divided(Box<[Tree; 2]>),
    Nothing,
}

/// A part of a curve of slips, divided as far as it was needed, or an interval of it.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    left: f64,
    right: f64,
    /// Halvings of the part that led to it.
    halvings: u32,
    fit: OnceLock<Fit>,
}

pub(super) struct FitContext<'a> {
    pub(super) basis: &'a Basis,
    pub(super) curves: &'a Curves,
    /// To which part of a value the polynomials tell it.
    pub(super) tolerance: f64,
    pub(super) halvings: u32,
    /// The least coordinate, if chains end there: next to it links are looked for in narrower
    /// intervals.
    pub(super) end: Option<f64>,
    /// The links from a coordinate.
    pub(super) value: &'a dyn Fn(f64) -> Option<(SlipMapValue, PhaseSequence)>,
}

impl Tree {
    /// Between two coordinates, after so many halvings.
    pub(super) const fn new(left: f64, right: f64, halvings: u32) -> Self {
        Self {
            left,
            right,
            halvings,
            fit: OnceLock::new(),
        }
    }

    pub(super) fn find(&self, at: f64, context: &FitContext<'_>) -> Option<&FittedMap> {
        let mut node = Some(self).filter(|root| root.left <= at && at <= root.right)?;
        loop {
            match node.fit.get_or_init(|| fit(node, context)) {
                Fit::Found(fitted) => return Some(fitted),
                Fit::Nothing => return None,
                Fit::Divided(halves) => node = &halves[usize::from(at > halves[0].right)],
            }
        }
    }
}

fn fit(tree: &Tree, context: &FitContext<'_>) -> Fit {
    let Tree {
        left,
        right,
        halvings,
        ..
    } = *tree;
    let FitContext {
        halvings: most,
        end,
        value,
        ..
    } = context;
    let middle = 0.5 * (left + right);
    let divided = || {
        if halvings < *most {
            Fit::Divided(Box::new([
                Tree::new(left, middle, halvings + 1),
                Tree::new(middle, right, halvings + 1),
            ]))
        } else {
            Fit::Nothing
        }
    };
    let [first, second, last] = [left, middle, right].map(value);
    let (Some(first), Some(second), Some(last)) = (&first, &second, &last) else {
        let nothing = first.is_none() && second.is_none() && last.is_none();
        let searched = halvings >= MIN_HALVINGS_SEARCHED && *end != Some(left);
        return if nothing && searched {
            Fit::Nothing
        } else {
            divided()
        };
    };
    let (route, phases) = (first.0.route, first.1);
    let same = |(passage, other): &(SlipMapValue, PhaseSequence)| {
        (passage.route == route && *other == phases).then(|| passage.numbers())
    };
    if same(second).is_none() || same(last).is_none() {
        return divided();
    }
    match interpolate(tree, context, first, &last.0) {
        Some(fitted) => Fit::Found(Box::new(fitted)),
        None => divided(),
    }
}

/// The tolerances of the numbers of links that end between two points.
fn tolerances(context: &FitContext<'_>, first: &CurvePoint, last: &CurvePoint) -> [Tolerance; 4] {
    let FitContext {
        curves, tolerance, ..
    } = context;
    // The rounding of the level of an orbit decides where and when it slips, and how far the hoop
    // has come.
    let least = LEVEL_ROUNDING * tolerance * curves.amplification(last.part, first.at, last.at);
    let relative = Tolerance {
        relative: *tolerance,
        least,
    };
    // x comes back to where it was, unlike time; the length of slides is only counted.
    let moved = Tolerance {
        least: least.max(*tolerance),
        ..relative
    };
    let counted = Tolerance {
        relative: LENGTH_TOLERANCE,
        least: LENGTH_TOLERANCE,
    };
    [relative, relative, moved, counted]
}

/// Polynomials through links from the nodes of an interval with the phases of the first, if they
/// agree with the links from between the nodes.
fn interpolate(
    tree: &Tree,
    context: &FitContext<'_>,
    first: &(SlipMapValue, PhaseSequence),
    last: &SlipMapValue,
) -> Option<FittedMap> {
    let Tree { left, right, .. } = *tree;
    let FitContext { basis, value, .. } = context;
    let (first, phases) = (&first.0, first.1);
    let route = first.route;
    let same = |(passage, other): &(SlipMapValue, PhaseSequence)| {
        (passage.route == route && *other == phases).then(|| passage.numbers())
    };
    let nodes = basis.nodes(left, right);
    let mut numbers = [[0.0; 4]; NODES];
    for (at, numbers) in nodes.iter().zip(&mut numbers) {
        match value(*at).as_ref().and_then(same) {
            Some(fitted) => *numbers = fitted,
            None => return None,
        }
    }
    let tolerances = tolerances(context, &first.end, &last.end);
    let interpolant = basis.through(left, right, &numbers, &tolerances)?;
    let agrees = |at: f64, expected: [f64; 4]| {
        let values = interpolant
            .at(at)
            .into_iter()
            .zip(expected)
            .zip(&tolerances);
        values.into_iter().all(|((value, expected), tolerance)| {
            (value - expected).abs() <= MAX_MISS * tolerance.of(expected)
        })
    };
    let between = nodes
        .windows(2)
        .map(|pair| 0.5 * (pair[0] + pair[1]))
        .chain([left, right]);
    for at in between {
        if !value(at)
            .as_ref()
            .and_then(same)
            .is_some_and(|expected| agrees(at, expected))
        {
            return None;
        }
    }
    Some(FittedMap {
        route,
        phases,
        numbers: interpolant,
    })
}
