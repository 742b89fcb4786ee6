//! Segments of boundaries, put together to curves and to outlines of regions.

use std::collections::{BTreeMap, BTreeSet};

use super::cell::{Segment, Stop};
use super::{Boundary, Place, Region};

/// A boundary between two nodes at which others end, or a closed one.
struct Arc {
    nodes: [usize; 2],
    sides: [u64; 2],
    points: Vec<Place>,
}

/// A segment in one of its directions.
#[derive(Clone, Copy)]
struct Step<'a> {
    number: usize,
    segment: &'a Segment,
    forward: bool,
}

impl Step<'_> {
    const fn from(self) -> usize {
        self.segment.nodes[if self.forward { 0 } else { 1 }]
    }

    const fn to(self) -> usize {
        self.segment.nodes[if self.forward { 1 } else { 0 }]
    }

    const fn sides(self) -> [u64; 2] {
        let [left, right] = self.segment.sides;
        if self.forward {
            [left, right]
        } else {
            [right, left]
        }
    }
}

/// How far a curve may be from its chords.
const FLAT: f64 = 1.5e-4;

/// The regions and boundaries of segments between nodes, and of the border counterclockwise.
pub(super) fn regions(
    nodes: &[Place],
    segments: &[Segment],
    border: &[Stop],
) -> (Vec<Region>, Vec<Boundary>) {
    let arcs: Vec<Arc> = arcs(nodes, segments)
        .into_iter()
        .map(|arc| Arc {
            points: thinned(&arc.points, FLAT),
            ..arc
        })
        .filter(|arc| arc.nodes[0] != arc.nodes[1] || arc.points.len() > 3)
        .collect();
    let mut pieces: BTreeMap<u64, Vec<Piece>> = BTreeMap::new();
    for arc in &arcs {
        let [from, to] = arc.nodes;
        let back = arc.points.iter().rev().copied().collect();
        pieces.entry(arc.sides[0]).or_default().push(Piece {
            nodes: [from, to],
            points: arc.points.clone(),
        });
        pieces.entry(arc.sides[1]).or_default().push(Piece {
            nodes: [to, from],
            points: back,
        });
    }
    for (from, to) in border.iter().zip(border.iter().cycle().skip(1)) {
        pieces.entry(from.key).or_default().push(Piece {
            nodes: [from.node, to.node],
            points: vec![nodes[from.node], nodes[to.node]],
        });
    }
    let regions = pieces
        .into_iter()
        .map(|(key, pieces)| {
            let outlines = outlines(pieces);
            let area = outlines.iter().map(|outline| area(outline)).sum();
            Region {
                key,
                outlines,
                area,
            }
        })
        .collect();
    let boundaries = arcs
        .into_iter()
        .map(|Arc { sides, points, .. }| Boundary { sides, points })
        .collect();
    (regions, boundaries)
}

/// Chains of segments between nodes at which more or fewer than two of them end, then closed ones.
fn arcs(nodes: &[Place], segments: &[Segment]) -> Vec<Arc> {
    let mut leaving: Vec<Vec<Step<'_>>> = vec![Vec::new(); nodes.len()];
    for (number, segment) in segments.iter().enumerate() {
        for forward in [true, false] {
            let step = Step {
                number,
                segment,
                forward,
            };
            leaving[step.from()].push(step);
        }
    }
    let mut used: BTreeSet<usize> = BTreeSet::new();
    let mut arcs = Vec::new();
    let mut walk = |first: Step<'_>, used: &mut BTreeSet<usize>| {
        let mut points = vec![nodes[first.from()], nodes[first.to()]];
        let mut last = first;
        used.insert(first.number);
        while let [a, b] = leaving[last.to()][..] {
            let next = if a.number == last.number { b } else { a };
            if !used.insert(next.number) {
                break;
            }
            points.push(nodes[next.to()]);
            last = next;
        }
        arcs.push(Arc {
            nodes: [first.from(), last.to()],
            sides: first.sides(),
            points,
        });
    };
    let ends = leaving.iter().filter(|steps| steps.len() != 2).flatten();
    for &first in ends {
        if !used.contains(&first.number) {
            walk(first, &mut used);
        }
    }
    for (number, segment) in segments.iter().enumerate() {
        if !used.contains(&number) {
            walk(
                Step {
                    number,
                    segment,
                    forward: true,
                },
                &mut used,
            );
        }
    }
    arcs
}

/// The points of a curve that its chords need to be no farther from it than this.
fn thinned(points: &[Place], flat: f64) -> Vec<Place> {
    let last = points.len() - 1;
    let mut kept: BTreeSet<usize> = [0, last].into();
    let mut spans = vec![[0, last]];
    while let Some([from, to]) = spans.pop() {
        let (a, b) = (points[from], points[to]);
        let farthest = (from + 1..to)
            .map(|i| (distance(points[i], a, b), i))
            .max_by(|(a, i), (b, j)| a.total_cmp(b).then(j.cmp(i)));
        if let Some((far, i)) = farthest
            && far > flat
        {
            kept.insert(i);
            spans.extend([[from, i], [i, to]]);
        }
    }
    kept.into_iter().map(|i| points[i]).collect()
}

fn distance(place: Place, a: Place, b: Place) -> f64 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let to = [place[0] - a[0], place[1] - a[1]];
    let length = libm::sqrt(along[0] * along[0] + along[1] * along[1]);
    if length == 0.0 {
        return libm::sqrt(to[0] * to[0] + to[1] * to[1]);
    }
    (along[0] * to[1] - along[1] * to[0]).abs() / length
}

/// A part of an outline, with the region to its left.
struct Piece {
    nodes: [usize; 2],
    points: Vec<Place>,
}

/// Closed curves of pieces, of which as many end in each node as begin there.
fn outlines(pieces: Vec<Piece>) -> Vec<Vec<Place>> {
    let mut beginning: BTreeMap<usize, Vec<Piece>> = BTreeMap::new();
    for piece in pieces.into_iter().rev() {
        beginning.entry(piece.nodes[0]).or_default().push(piece);
    }
    let mut outlines = Vec::new();
    while let Some((&start, _)) = beginning.iter().next() {
        let (mut outline, mut at) = (Vec::new(), start);
        while let Some(waiting) = beginning.get_mut(&at) {
            let Some(piece) = waiting.pop() else { break };
            if waiting.is_empty() {
                beginning.remove(&at);
            }
            let count = piece.points.len() - 1;
            outline.extend_from_slice(&piece.points[..count]);
            at = piece.nodes[1];
            if at == start {
                break;
            }
        }
        outlines.push(outline);
    }
    outlines
}

/// Area to the left of a closed curve.
fn area(outline: &[Place]) -> f64 {
    let next = outline.iter().cycle().skip(1);
    outline
        .iter()
        .zip(next)
        .map(|(a, b)| 0.5 * (a[0] * b[1] - a[1] * b[0]))
        .sum()
}
