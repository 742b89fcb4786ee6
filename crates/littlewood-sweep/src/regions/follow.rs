//! Boundaries on a fine lattice, of which only the cells are looked at through which they run.

use std::collections::{BTreeMap, BTreeSet, HashMap};

use super::cell::{Cell, Crossing, Side, Span, crossed};
use super::{Ask, Detail, Lattice, Place};

/// A corner of the fine lattice, or the cell to the right of it and above it.
type Corner = [usize; 2];

/// A lattice between the places of another.
pub(super) struct Fine {
    lattice: Lattice,
    parts: usize,
    /// Cells to the right and upwards.
    cells: [usize; 2],
    /// The keys of corners between the places of the lattice, as far as they are known.
    between: HashMap<Corner, u64>,
}

/// The cells with boundaries.
pub(super) struct Followed {
    /// The places at which boundaries cross sides.
    pub(super) nodes: Vec<Place>,
    pub(super) cells: Vec<Cell>,
    /// The whole plane, with what crosses its sides.
    pub(super) frame: Cell,
}

/// A side of a cell by its first corner and the axis along which it runs.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct SideName {
    corner: Corner,
    axis: usize,
}

impl SideName {
    /// The sides of a cell: below, on the right, above, on the left.
    const fn of(cell: Corner) -> [Self; 4] {
        let [x, y] = cell;
        [
            Self::new([x, y], 0),
            Self::new([x + 1, y], 1),
            Self::new([x, y + 1], 0),
            Self::new([x, y], 1),
        ]
    }

    const fn new(corner: Corner, axis: usize) -> Self {
        Self { corner, axis }
    }

    const fn far_end(self) -> Corner {
        let [x, y] = self.corner;
        if self.axis == 0 {
            [x + 1, y]
        } else {
            [x, y + 1]
        }
    }
}

impl Fine {
    pub(super) fn new(lattice: Lattice, parts: usize) -> Self {
        Self {
            cells: lattice.cells().map(|count| parts * count),
            lattice,
            parts,
            between: HashMap::new(),
        }
    }

    /// With half as many cells to either side, and what is known of their corners.
    pub(super) fn coarser(self) -> Self {
        if self.parts == 1 {
            return Self::new(self.lattice.coarser(), 1);
        }
        let known = self.between.into_iter();
        let kept = known.filter(|(corner, _)| corner.iter().all(|k| k % 2 == 0));
        Self {
            between: kept.map(|([x, y], key)| ([x / 2, y / 2], key)).collect(),
            ..Self::new(self.lattice, self.parts / 2)
        }
    }

    /// Cells to the right and upwards.
    pub(super) const fn cells(&self) -> [usize; 2] {
        self.cells
    }

    /// Where a corner stands among the keys of the lattice, if it is one of its places.
    fn of_lattice(&self, [x, y]: Corner) -> Option<usize> {
        let columns = self.lattice.places[0].len();
        let is_one = x % self.parts == 0 && y % self.parts == 0;
        is_one.then(|| y / self.parts * columns + x / self.parts)
    }

    fn key(&self, corner: Corner) -> u64 {
        self.of_lattice(corner)
            .map_or_else(|| self.between[&corner], |place| self.lattice.keys[place])
    }

    fn is_known(&self, corner: Corner) -> bool {
        self.of_lattice(corner).is_some() || self.between.contains_key(&corner)
    }

    fn place(&self, corner: Corner) -> Place {
        [0, 1].map(|k| {
            let (places, whole, rest) = (
                &self.lattice.places[k],
                corner[k] / self.parts,
                corner[k] % self.parts,
            );
            if rest == 0 {
                return places[whole];
            }
            places[whole] + (places[whole + 1] - places[whole]) * rest as f64 / self.parts as f64
        })
    }

    /// Asks for the keys of corners that are not known; whether they are known then.
    fn learn<E>(
        &mut self,
        corners: impl IntoIterator<Item = Corner>,
        ask: &mut Ask<'_, E>,
    ) -> Result<bool, E> {
        let wanted: BTreeSet<Corner> = corners
            .into_iter()
            .filter(|corner| !self.is_known(*corner))
            .collect();
        if wanted.is_empty() {
            return Ok(true);
        }
        let places: Vec<Place> = wanted.iter().map(|&corner| self.place(corner)).collect();
        let keys = ask(&places)?;
        let is_known = keys.is_some();
        let known = wanted.into_iter().zip(keys.unwrap_or_default());
        self.between.extend(known);
        Ok(is_known)
    }

    fn differ(&self, side: SideName) -> bool {
        self.key(side.corner) != self.key(side.far_end())
    }

    fn beside(&self, side: SideName) -> impl Iterator<Item = Corner> + use<> {
        let cells = self.cells;
        let [x, y] = side.corner;
        let other = if side.axis == 0 {
            y.checked_sub(1).map(|y| [x, y])
        } else {
            x.checked_sub(1).map(|x| [x, y])
        };
        other
            .into_iter()
            .chain([[x, y]])
            .filter(move |[x, y]| *x < cells[0] && *y < cells[1])
    }

    /// Sides of the fine lattice that a boundary crosses, within those of the lattice whose ends
    /// differ; nothing if that takes too long.
    fn seeds<E>(&mut self, ask: &mut Ask<'_, E>) -> Result<Option<Vec<SideName>>, E> {
        let [columns, rows] = self.lattice.cells();
        let parts = self.parts;
        let mut spans: Vec<(Corner, Corner)> = Vec::new();
        for y in 0..=rows {
            for x in 0..=columns {
                let from = [parts * x, parts * y];
                let right = (x < columns).then(|| [from[0] + parts, from[1]]);
                let up = (y < rows).then(|| [from[0], from[1] + parts]);
                let ends = right.into_iter().chain(up);
                spans.extend(
                    ends.filter(|to| self.key(from) != self.key(*to))
                        .map(|to| (from, to)),
                );
            }
        }
        let mut size = parts;
        while size > 1 {
            size /= 2;
            let middle =
                |(from, to): (Corner, Corner)| [0, 1].map(|k| usize::midpoint(from[k], to[k]));
            if !self.learn(spans.iter().map(|&span| middle(span)), ask)? {
                return Ok(None);
            }
            let halves = spans
                .iter()
                .flat_map(|&span| [(span.0, middle(span)), (middle(span), span.1)]);
            spans = halves
                .filter(|half| self.key(half.0) != self.key(half.1))
                .collect();
        }
        let names = spans
            .into_iter()
            .map(|(from, to)| SideName::new(from, usize::from(from[0] == to[0])));
        Ok(Some(names.collect()))
    }

    /// Follows all boundaries; nothing if that takes too long, or too many cells.
    pub(super) fn follow<E>(
        &mut self,
        detail: &Detail,
        ask: &mut Ask<'_, E>,
    ) -> Result<Option<Followed>, E> {
        let Some(cells) = self.crossed_cells(detail, ask)? else {
            return Ok(None);
        };
        let names: BTreeSet<SideName> = cells.iter().copied().flat_map(SideName::of).collect();
        let spans: Vec<Span> = names
            .iter()
            .map(|&name| {
                let corners = [name.corner, name.far_end()];
                Span {
                    ends: corners.map(|corner| self.place(corner)),
                    keys: corners.map(|at| self.key(at)),
                }
            })
            .collect();
        let mut nodes = Vec::new();
        let sides = crossed(&spans, &mut nodes, detail.width, ask)?;
        let sides: BTreeMap<SideName, Side> = names.into_iter().zip(sides).collect();
        let frame = self.frame(&sides);
        let cells = cells
            .into_iter()
            .map(|[x, y]| Cell {
                low: self.place([x, y]),
                high: self.place([x + 1, y + 1]),
                sides: SideName::of([x, y]).map(|name| sides[&name].clone()),
            })
            .collect();
        Ok(Some(Followed {
            nodes,
            cells,
            frame,
        }))
    }

    /// The cells through which boundaries run, from neighbour to neighbour; nothing if they are too
    /// many, or take too long.
    fn crossed_cells<E>(
        &mut self,
        detail: &Detail,
        ask: &mut Ask<'_, E>,
    ) -> Result<Option<BTreeSet<Corner>>, E> {
        let Some(seeds) = self.seeds(ask)? else {
            return Ok(None);
        };
        let is_coarse = self.parts == 1 && self.cells.iter().all(|count| *count < 4);
        let mut seen: BTreeSet<Corner> = seeds
            .into_iter()
            .flat_map(|side| self.beside(side))
            .collect();
        let mut cells: BTreeSet<Corner> = BTreeSet::new();
        let mut front: Vec<Corner> = seen.iter().copied().collect();
        while !front.is_empty() {
            let corners = |[x, y]: Corner| [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]];
            if !self.learn(front.iter().copied().flat_map(corners), ask)? {
                return Ok(None);
            }
            let mut next = Vec::new();
            for cell in front {
                let crossed: Vec<SideName> = SideName::of(cell)
                    .into_iter()
                    .filter(|side| self.differ(*side))
                    .collect();
                if !crossed.is_empty() {
                    cells.insert(cell);
                }
                next.extend(
                    crossed
                        .into_iter()
                        .flat_map(|side| self.beside(side))
                        .filter(|cell| seen.insert(*cell)),
                );
            }
            if cells.len() > detail.most && !is_coarse {
                return Ok(None);
            }
            next.sort_unstable();
            front = next;
        }
        Ok(Some(cells))
    }

    fn frame(&self, sides: &BTreeMap<SideName, Side>) -> Cell {
        let [right, top] = self.cells;
        let side = |from: Corner, axis: usize| {
            let on_it =
                |name: &SideName| name.axis == axis && name.corner[1 - axis] == from[1 - axis];
            let mut crossings: Vec<Crossing> = sides
                .iter()
                .filter(|(name, _)| on_it(name))
                .flat_map(|(_, side)| side.crossings.iter().copied())
                .collect();
            crossings.sort_by(|a, b| a.at.total_cmp(&b.at));
            let to = if axis == 0 {
                [right, from[1]]
            } else {
                [from[0], top]
            };
            Side {
                keys: [self.key(from), self.key(to)],
                crossings,
            }
        };
        let sides = [
            side([0, 0], 0),
            side([right, 0], 1),
            side([0, top], 0),
            side([0, 0], 1),
        ];
        Cell {
            low: [0.0; 2],
            high: [1.0; 2],
            sides,
        }
    }
}
