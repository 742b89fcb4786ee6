//! A cell, its sides with what crosses them, and the boundaries in it.

use super::{Ask, Place};

/// Crossings of a side at most: more are taken as one.
const CROSSINGS: usize = 3;

/// A place at which the key changes along a side.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing {
    pub(super) node: usize,
    /// Its coordinate along the side.
    pub(super) at: f64,
    /// The keys before and after it, as the coordinate grows.
    pub(super) keys: [u64; 2],
}

/// A side of a cell, in the direction in which its coordinate grows.
#[derive(Clone, Debug)]
pub(super) struct Side {
    /// The keys of its ends.
    pub(super) keys: [u64; 2],
    pub(super) crossings: Vec<Crossing>,
}

impl Side {
    fn key_at(&self, at: f64) -> u64 {
        self.crossings
            .iter()
            .rev()
            .find(|crossing| crossing.at < at)
            .map_or(self.keys[0], |last| last.keys[1])
    }

    fn cut(&self, at: f64) -> [Self; 2] {
        let key = self.key_at(at);
        let (before, after) = self.crossings.iter().partition(|crossing| crossing.at < at);
        [
            Self {
                keys: [self.keys[0], key],
                crossings: before,
            },
            Self {
                keys: [key, self.keys[1]],
                crossings: after,
            },
        ]
    }
}

/// The ends of a side and their keys.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) ends: [Place; 2],
    pub(super) keys: [u64; 2],
}

impl Span {
    fn axis(&self) -> usize {
        usize::from(self.ends[0][0] == self.ends[1][0])
    }
}

/// What is looked for between two places of a side that differ.
struct Search {
    side: usize,
    range: [f64; 2],
    keys: [u64; 2],
}

/// The sides of cells while it is found where keys change along them.
struct Crossings<'a> {
    spans: &'a [Span],
    width: f64,
    sides: Vec<Side>,
    nodes: &'a mut Vec<Place>,
}

impl Crossings<'_> {
    fn place(&self, side: usize, at: f64) -> Place {
        let mut place = self.spans[side].ends[0];
        place[self.spans[side].axis()] = at;
        place
    }

    /// Ends a search, and returns what is still to be searched on its side.
    fn end(&mut self, search: &Search) -> Option<Search> {
        let Search {
            side,
            range,
            keys: [before, mut after],
        } = *search;
        let span = self.spans[side];
        let (end, last) = (span.ends[1][span.axis()], span.keys[1]);
        // The keys of a side lead to that of its end.
        if self.sides[side].crossings.len() + 1 == CROSSINGS || range[1] + self.width >= end {
            after = last;
        }
        if before != after {
            let at = middle(range);
            self.sides[side].crossings.push(Crossing {
                node: self.nodes.len(),
                at,
                keys: [before, after],
            });
            self.nodes.push(self.place(side, at));
        }
        (after != last).then(|| Search {
            side,
            range: [range[1], end],
            keys: [after, last],
        })
    }
}

/// Finds where keys change along sides, by bisection of all of them at once. Where nothing is
/// answered any more, they change in the middle of what is left.
pub(super) fn crossed<E>(
    spans: &[Span],
    nodes: &mut Vec<Place>,
    width: f64,
    ask: &mut Ask<'_, E>,
) -> Result<Vec<Side>, E> {
    let side = |span: &Span| Side {
        keys: span.keys,
        crossings: Vec::new(),
    };
    let mut crossings = Crossings {
        spans,
        width,
        sides: spans.iter().map(side).collect(),
        nodes,
    };
    let mut searches: Vec<Search> = spans
        .iter()
        .enumerate()
        .filter(|(_, span)| span.keys[0] != span.keys[1])
        .map(|(side, span)| Search {
            side,
            range: span.ends.map(|end| end[span.axis()]),
            keys: span.keys,
        })
        .collect();
    while !searches.is_empty() {
        let middles: Vec<Place> = searches
            .iter()
            .map(|search| crossings.place(search.side, middle(search.range)))
            .collect();
        let Some(keys) = ask(&middles)? else {
            while !searches.is_empty() {
                searches = searches
                    .iter()
                    .filter_map(|search| crossings.end(search))
                    .collect();
            }
            break;
        };
        let mut next = Vec::new();
        for (mut search, key) in searches.into_iter().zip(keys) {
            let at = middle(search.range);
            if key == search.keys[0] {
                search.range[0] = at;
            } else {
                search.range[1] = at;
                search.keys[1] = key;
            }
            if search.range[1] - search.range[0] > width {
                next.push(search);
            } else {
                next.extend(crossings.end(&search));
            }
        }
        searches = next;
    }
    Ok(crossings.sides)
}

fn middle(range: [f64; 2]) -> f64 {
    0.5 * (range[0] + range[1])
}

/// A rectangle, with its sides below, on the right, above and on the left.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    pub(super) low: Place,
    pub(super) high: Place,
    pub(super) sides: [Side; 4],
}

/// A straight part of a boundary, between two nodes, with the keys on its left and on its right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Segment {
    pub(super) nodes: [usize; 2],
    pub(super) sides: [u64; 2],
}

impl Cell {
    /// The nodes of its sides counterclockwise from the lower left corner, each with the keys
    /// before and after it.
    pub(super) fn around(&self) -> Vec<(usize, [u64; 2])> {
        let [below, right, above, left] = &self.sides;
        let forward = |side: &Side| {
            side.crossings
                .iter()
                .map(|one| (one.node, one.keys))
                .collect::<Vec<_>>()
        };
        let back = |side: &Side| {
            side.crossings
                .iter()
                .rev()
                .map(|one| (one.node, [one.keys[1], one.keys[0]]))
                .collect::<Vec<_>>()
        };
        [forward(below), forward(right), back(above), back(left)].concat()
    }

    fn centre(&self) -> Place {
        [0, 1].map(|k| middle([self.low[k], self.high[k]]))
    }

    /// The sides between its quarters, from a key in the middle: left, right, lower, upper.
    fn cross(&self, key: u64) -> [Span; 4] {
        let [x, y] = self.centre();
        let [below, right, above, left] = &self.sides;
        [
            Span {
                ends: [[self.low[0], y], [x, y]],
                keys: [left.key_at(y), key],
            },
            Span {
                ends: [[x, y], [self.high[0], y]],
                keys: [key, right.key_at(y)],
            },
            Span {
                ends: [[x, self.low[1]], [x, y]],
                keys: [below.key_at(x), key],
            },
            Span {
                ends: [[x, y], [x, self.high[1]]],
                keys: [key, above.key_at(x)],
            },
        ]
    }

    fn quarters(&self, cross: &[Side]) -> [Self; 4] {
        let [x, y] = self.centre();
        let [below, right, above, left] = &self.sides;
        let ([below_left, below_right], [above_left, above_right]) = (below.cut(x), above.cut(x));
        let ([left_low, left_high], [right_low, right_high]) = (left.cut(y), right.cut(y));
        let inner = |i: usize| cross[i].clone();
        let cell = |low: Place, high: Place, sides: [Side; 4]| Self { low, high, sides };
        [
            cell(self.low, [x, y], [below_left, inner(2), inner(0), left_low]),
            cell(
                [x, self.low[1]],
                [self.high[0], y],
                [below_right, right_low, inner(1), inner(2)],
            ),
            cell(
                [self.low[0], y],
                [x, self.high[1]],
                [inner(0), inner(3), above_left, left_high],
            ),
            cell(
                [x, y],
                self.high,
                [inner(1), right_high, above_right, inner(3)],
            ),
        ]
    }
}

/// Cells that are halved at once, at most: boundaries meet in few places, or everywhere.
const MEETING: usize = 1_000;

/// The boundaries in cells. A cell in which they meet is halved so many times; in the last one they
/// meet in its middle.
pub(super) fn segments<E>(
    cells: Vec<Cell>,
    halvings: u32,
    nodes: &mut Vec<Place>,
    width: f64,
    ask: &mut Ask<'_, E>,
) -> Result<Vec<Segment>, E> {
    let mut segments = Vec::new();
    let mut level = cells;
    for left in (0..=halvings).rev() {
        let is_meeting = |cell: &&Cell| cell.around().len() > 2;
        let centres: Vec<Place> = level.iter().filter(is_meeting).map(Cell::centre).collect();
        let is_halved = left > 0 && (1..=MEETING).contains(&centres.len());
        let keys = if is_halved { ask(&centres)? } else { None };
        let mut meeting = Vec::new();
        for cell in level {
            match cell.around()[..] {
                [] | [_] => {}
                // The second key is to the left on the way back to the first crossing.
                [(first, sides), (second, _)] => {
                    segments.push(Segment {
                        nodes: [second, first],
                        sides: [sides[1], sides[0]],
                    });
                }
                ref around if keys.is_none() => {
                    let hub = nodes.len();
                    nodes.push(cell.centre());
                    segments.extend(around.iter().map(|&(node, [before, after])| Segment {
                        nodes: [hub, node],
                        sides: [after, before],
                    }));
                }
                _ => meeting.push(cell),
            }
        }
        let Some(keys) = keys else { break };
        let spans: Vec<Span> = meeting
            .iter()
            .zip(keys)
            .flat_map(|(cell, key)| cell.cross(key))
            .collect();
        let inner = crossed(&spans, nodes, width, ask)?;
        level = meeting
            .iter()
            .zip(inner.chunks(4))
            .flat_map(|(cell, cross)| cell.quarters(cross))
            .collect();
    }
    Ok(segments)
}
