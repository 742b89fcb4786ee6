//! The maps of 2^k links on one curve of slips, by polynomials on pieces that are made when they are needed.
//!
//! A piece is accepted if the links from its ends, from its nodes and from between these go through the same phases and turns, and if
//! its polynomials have converged. Where a phase begins to appear or vanishes, what follows is discontinuous or has a singular
//! derivative; there pieces are halved until they are too narrow, and motions are followed one by one.

use std::sync::OnceLock;

use crate::links::LinkPhases;

use super::super::interpolant::{Basis, Interpolant, NODES, Tolerance};
use super::passage::{Passage, Route};

/// Polynomials have converged when their last coefficients are below this part of the largest value, times what rounding in a link is
/// amplified by.
pub(super) const CONVERGED: f64 = 2e-15;

/// Pieces are not halved below this width.
const NARROWEST: f64 = 1.0 / 8192.0;

/// An interval without links is not searched further below this width.
const SEARCHED: f64 = 1.0 / 16.0;

/// By how many tolerances the polynomials may miss the links between the nodes.
const MISSED: f64 = 8.0;

/// One piece.
#[derive(Clone, Debug)]
pub(super) struct Found {
    route: Route,
    pub(super) phases: LinkPhases,
    numbers: Interpolant<3>,
}

impl Found {
    /// The links from an angle of the piece.
    #[inline]
    pub(super) fn at(&self, angle: f64) -> Passage {
        Passage::with_numbers(self.route, self.numbers.at(angle))
    }
}

/// What has been found on an interval.
#[derive(Clone, Debug)]
enum Fit {
    Found(Box<Found>),
    Divided(Box<[Node; 2]>),
    Nothing,
}

#[derive(Clone, Debug)]
struct Node {
    left: f64,
    right: f64,
    fit: OnceLock<Fit>,
}

/// Intervals of a curve of slips, each divided as far as it was needed.
#[derive(Clone, Debug)]
pub(super) struct Tree {
    roots: Vec<Node>,
}

impl Node {
    const fn new(left: f64, right: f64) -> Self {
        Self { left, right, fit: OnceLock::new() }
    }
}

impl Tree {
    pub(super) fn new(intervals: &[(f64, f64)]) -> Self {
        Self { roots: intervals.iter().map(|(left, right)| Node::new(*left, *right)).collect() }
    }

    /// The piece that holds an angle, of links that `value` follows.
    pub(super) fn find(
        &self,
        angle: f64,
        basis: &Basis,
        tolerance: f64,
        value: &impl Fn(f64) -> Option<(Passage, LinkPhases)>,
    ) -> Option<&Found> {
        let root = self.roots.partition_point(|root| root.right < angle);
        let mut node = self.roots.get(root).filter(|root| root.left <= angle)?;
        loop {
            match node.fit.get_or_init(|| fit((node.left, node.right), basis, tolerance, value)) {
                Fit::Found(found) => return Some(found),
                Fit::Nothing => return None,
                Fit::Divided(halves) => node = &halves[usize::from(angle > halves[0].right)],
            }
        }
    }
}

fn fit(
    (left, right): (f64, f64),
    basis: &Basis,
    tolerance: f64,
    value: &impl Fn(f64) -> Option<(Passage, LinkPhases)>,
) -> Fit {
    let middle = 0.5 * (left + right);
    let divided = || {
        if right - left > 2.0 * NARROWEST {
            Fit::Divided(Box::new([Node::new(left, middle), Node::new(middle, right)]))
        } else {
            Fit::Nothing
        }
    };
    let [first, second, last] = [left, middle, right].map(value);
    let (Some(first), Some(second), Some(last)) = (&first, &second, &last) else {
        let nothing = first.is_none() && second.is_none() && last.is_none();
        return if nothing && right - left < SEARCHED { Fit::Nothing } else { divided() };
    };
    let (route, phases) = (first.0.route, first.1);
    let same = |(passage, other): &(Passage, LinkPhases)| {
        (passage.route == route && *other == phases).then(|| passage.numbers())
    };
    if same(second).is_none() || same(last).is_none() {
        return divided();
    }
    let nodes = basis.nodes(left, right);
    let mut numbers = [[0.0; 3]; NODES];
    for (angle, numbers) in nodes.iter().zip(&mut numbers) {
        match value(*angle).as_ref().and_then(same) {
            Some(found) => *numbers = found,
            None => return divided(),
        }
    }
    let tolerance = Tolerance { relative: tolerance, least: tolerance };
    let Some(interpolant) = basis.through(left, right, &numbers, tolerance) else { return divided() };
    let agrees = |angle: f64, expected: [f64; 3]| {
        interpolant
            .at(angle)
            .iter()
            .zip(expected)
            .all(|(value, expected)| (value - expected).abs() <= MISSED * tolerance.of(expected))
    };
    let between = nodes.windows(2).map(|pair| 0.5 * (pair[0] + pair[1])).chain([left, right]);
    for angle in between {
        if !value(angle).as_ref().and_then(same).is_some_and(|expected| agrees(angle, expected)) {
            return divided();
        }
    }
    Fit::Found(Box::new(Found { route, phases, numbers: interpolant }))
}
