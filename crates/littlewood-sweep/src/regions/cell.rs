//! Where keys change along the sides of the cells of a lattice, and the boundaries in the cells.

use std::collections::{BTreeMap, BTreeSet};

use super::{Ask, Lattice, MIXED, Place};

/// A corner of the lattice, counted from the lower left, or the cell to the right of it and above it.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Corner {
    pub(super) x: usize,
    pub(super) y: usize,
}

impl Corner {
    pub(super) const fn new(x: usize, y: usize) -> Self {
        Self { x, y }
    }
}

/// Crossings of a side at most.
const CROSSINGS: usize = 3;

/// A side of a cell by its first corner and the axis along which it runs.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    corner: Corner,
    axis: usize,
}

impl Side {
    const fn new(corner: Corner, axis: usize) -> Self {
        Self { corner, axis }
    }

    const fn ends(self) -> [Corner; 2] {
        let Corner { x, y } = self.corner;
        [
            self.corner,
            if self.axis == 0 {
                Corner::new(x + 1, y)
            } else {
                Corner::new(x, y + 1)
            },
        ]
    }

    /// All sides of a lattice with this right upper corner.
    fn all(last: Corner) -> impl Iterator<Item = Self> {
        let corners = (0..=last.y).flat_map(move |y| (0..=last.x).map(move |x| Corner { x, y }));
        corners
            .flat_map(|corner| [0, 1].map(|axis| Self::new(corner, axis)))
            .filter(move |side| {
                let [_, Corner { x, y }] = side.ends();
                x <= last.x && y <= last.y
            })
    }

    /// The cells on either side of it, of a lattice with this right upper corner.
    fn beside(self, last: Corner) -> impl Iterator<Item = Corner> {
        let Corner { x, y } = self.corner;
        let other = if self.axis == 0 {
            y.checked_sub(1).map(|y| Corner { x, y })
        } else {
            x.checked_sub(1).map(|x| Corner { x, y })
        };
        other
            .into_iter()
            .chain([self.corner])
            .filter(move |cell| cell.x < last.x && cell.y < last.y)
    }
}

/// A side on a walk around a cell or the border.
#[derive(Clone, Copy)]
struct Step {
    side: Side,
    /// Whether the walk goes against the direction in which the coordinate grows.
    is_back: bool,
}

/// A step along the side from a corner.
const fn step(x: usize, y: usize, axis: usize, is_back: bool) -> Step {
    Step {
        side: Side::new(Corner { x, y }, axis),
        is_back,
    }
}

/// The sides of a cell counterclockwise from its lower left corner.
const fn around(Corner { x, y }: Corner) -> [Step; 4] {
    [
        step(x, y, 0, false),
        step(x + 1, y, 1, false),
        step(x, y + 1, 0, true),
        step(x, y, 1, true),
    ]
}

/// A place at which the key changes along a side.
#[derive(Clone, Copy)]
struct Crossing {
    node: usize,
    /// The keys before it and after it.
    keys: [u64; 2],
}

/// A straight part of a boundary, between two nodes, with the keys on its left and on its right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Segment {
    pub(super) nodes: [usize; 2],
    pub(super) sides: [u64; 2],
}

/// A node of the border of the plane, and the key from there on.
#[derive(Clone, Copy)]
pub(super) struct Stop {
    pub(super) node: usize,
    pub(super) key: u64,
}

/// A part of a side along which it is looked for where its first key ends.
struct Search {
    side: Side,
    range: [f64; 2],
    keys: [u64; 2],
}

impl Search {
    fn middle(&self) -> f64 {
        0.5 * (self.range[0] + self.range[1])
    }
}

/// The sides of a lattice along which keys change.
pub(super) struct Crossings<'a> {
    lattice: &'a Lattice,
    pub(super) nodes: Vec<Place>,
    /// Of each side as its coordinate grows.
    crossings: BTreeMap<Side, Vec<Crossing>>,
}

impl<'a> Crossings<'a> {
    /// Finds them by bisection of all sides at once, each to a width. Where that comes upon a third
    /// key, as of a narrow band between two regions, both its ends are looked for. Once nothing is
    /// answered any more, keys change in the middle of what is left.
    pub(super) fn find<E>(
        lattice: &'a Lattice,
        width: f64,
        ask: &mut Ask<'_, E>,
    ) -> Result<Self, E> {
        let place = |side: Side, at: f64| {
            let mut place = lattice.place(side.corner);
            place[side.axis] = at;
            place
        };
        let differs = |side: Side| {
            let keys = side.ends().map(|corner| lattice.key(corner));
            let ends = side.ends().map(|corner| lattice.place(corner)[side.axis]);
            // What is mixed ends half way to what is not.
            let middle = 0.5 * (ends[0] + ends[1]);
            let range = if keys.contains(&MIXED) {
                [middle; 2]
            } else {
                ends
            };
            (keys[0] != keys[1]).then_some(Search { side, range, keys })
        };
        let mut searches: Vec<Search> = Side::all(lattice.last()).filter_map(differs).collect();
        let mut counts: BTreeMap<Side, usize> = BTreeMap::new();
        loop {
            let mut open: Vec<&mut Search> = searches
                .iter_mut()
                .filter(|search| search.range[1] - search.range[0] > width)
                .collect();
            let middles: Vec<Place> = open
                .iter()
                .map(|search| place(search.side, search.middle()))
                .collect();
            if middles.is_empty() {
                break;
            }
            let Some(keys) = ask(&middles)? else { break };
            let mut more = Vec::new();
            for (search, key) in open.iter_mut().zip(keys) {
                let (side, middle, [first, last]) = (search.side, search.middle(), search.keys);
                if key != first && key != last {
                    let count = counts.entry(side).or_insert(1);
                    if *count < CROSSINGS {
                        *count += 1;
                        more.push(Search {
                            side,
                            range: [middle, search.range[1]],
                            keys: [key, last],
                        });
                        search.keys[1] = key;
                    }
                }
                search.range[usize::from(key != first)] = middle;
            }
            searches.extend(more);
        }
        searches.sort_by(|a, b| (a.side.cmp(&b.side)).then(a.range[0].total_cmp(&b.range[0])));
        let nodes = searches
            .iter()
            .map(|search| place(search.side, search.middle()))
            .collect();
        let mut crossings: BTreeMap<Side, Vec<Crossing>> = BTreeMap::new();
        for (node, Search { side, keys, .. }) in searches.into_iter().enumerate() {
            let found = crossings.entry(side).or_default();
            found.push(Crossing { node, keys });
        }
        Ok(Self {
            lattice,
            nodes,
            crossings,
        })
    }

    /// The crossings of a side in the order of a walk around a cell.
    fn on(&self, Step { side, is_back }: Step) -> Vec<Crossing> {
        let mut found = self.crossings.get(&side).cloned().unwrap_or_default();
        if is_back {
            found.reverse();
            found
                .iter_mut()
                .for_each(|crossing| crossing.keys.reverse());
        }
        found
    }

    fn add_node(&mut self, place: Place) -> usize {
        self.nodes.push(place);
        self.nodes.len() - 1
    }

    /// The boundaries in all cells: each from where a region begins on the walk around the cell to
    /// where it ends. Those of three regions and more meet in the middle.
    pub(super) fn segments(&mut self) -> Vec<Segment> {
        let last = self.lattice.last();
        let sides = self.crossings.keys();
        let crossed: BTreeSet<Corner> = sides.flat_map(|side| side.beside(last)).collect();
        let mut segments = Vec::new();
        for cell in crossed {
            let mut open: Vec<Crossing> = Vec::new();
            for crossing in around(cell).into_iter().flat_map(|step| self.on(step)) {
                let [before, after] = crossing.keys;
                match open.pop_if(|first| first.keys == [after, before]) {
                    // The key between them is to the left on the way back to the first.
                    Some(first) => segments.push(Segment {
                        nodes: [crossing.node, first.node],
                        sides: [before, after],
                    }),
                    None => open.push(crossing),
                }
            }
            if open.is_empty() {
                continue;
            }
            let [low, high] = [cell, Corner::new(cell.x + 1, cell.y + 1)]
                .map(|corner| self.lattice.place(corner));
            let hub = self.add_node([0, 1].map(|k| 0.5 * (low[k] + high[k])));
            segments.extend(open.into_iter().map(|Crossing { node, keys }| Segment {
                nodes: [hub, node],
                sides: [keys[1], keys[0]],
            }));
        }
        segments
    }

    /// The border counterclockwise: its corners and what crosses it.
    pub(super) fn border(&mut self) -> Vec<Stop> {
        let Corner { x: right, y: top } = self.lattice.last();
        let below = (0..right).map(|x| step(x, 0, 0, false));
        let beside = (0..top).map(|y| step(right, y, 1, false));
        let above = (0..right).rev().map(|x| step(x, top, 0, true));
        let left = (0..top).rev().map(|y| step(0, y, 1, true));
        let mut stops = Vec::new();
        for one in below.chain(beside).chain(above).chain(left) {
            let corner = one.side.ends()[usize::from(one.is_back)];
            if [0, right].contains(&corner.x) && [0, top].contains(&corner.y) {
                let key = self.lattice.key(corner);
                let node = self.add_node(self.lattice.place(corner));
                stops.push(Stop { node, key });
            }
            stops.extend(
                self.on(one)
                    .into_iter()
                    .map(|Crossing { node, keys }| Stop { node, key: keys[1] }),
            );
        }
        stops
    }
}
