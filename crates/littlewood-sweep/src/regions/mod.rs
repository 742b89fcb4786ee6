//! The regions of a plane: areas whose places have one key each, bounded by curves.
//!
//! Where neighbours on a lattice differ, the place between them at which the key changes is found by
//! bisection. In each cell of the lattice boundaries run straight from side to side; those of three
//! regions meet in the middle.

mod cell;
mod chain;

use cell::{Corner, Crossings};
use littlewood::{Limits, ParameterError, Summary};

use crate::compute::Workers;
use crate::grid::Grid;

/// Motions that [`Regions::of_grid`] follows for a point of its grid, at most.
pub const FOR_A_POINT: usize = 3;

/// Points of a grid that are followed before somebody is told.
const AT_ONCE: usize = 512;

/// The least width to which a boundary is located: the middle of two places that are nearer to each
/// other may be one of them.
const LEAST_WIDTH: f64 = 1e-12;

/// The key of places around which keys change more finely than a lattice tells: see
/// [`Lattice::mix`].
pub const MIXED: u64 = u64::MAX;

/// Half the side of the square of places around one by which it is known to be mixed, the part of
/// the sides in it along which keys then change, and how many of its places then have a key that
/// none of their neighbours has; of both a part each counts, too. Along a boundary one in six of the
/// sides changes, along a narrow band one in three, and neither has such places.
const AROUND: usize = 3;
const CHANGES: f64 = 0.35;
const ALONE: f64 = 3.0;
/// Columns and rows from which on a lattice tells that: between fewer there may be regions.
const FINE: usize = 24;
/// How often holes in what is mixed are closed, and half the side of the least square of one key that
/// is seen beside it.
const SMOOTHED: usize = 3;
const LEAST: usize = 2;

/// A place in the unit square: fractions of the way to the right and upwards.
pub type Place = [f64; 2];

/// What is asked for the keys of places, many at once; none where finding them would take too long.
pub type Ask<'a, E> = dyn FnMut(&[Place]) -> Result<Option<Vec<u64>>, E> + 'a;

/// A lattice on which the keys are known.
#[derive(Clone, Debug)]
pub struct Lattice {
    /// Places of its columns and of its rows, growing from 0 to 1.
    pub places: [Vec<f64>; 2],
    /// Row by row, the lowest first.
    pub keys: Vec<u64>,
}

/// All places of a key.
#[derive(Clone, Debug, PartialEq)]
pub struct Region {
    /// The key.
    pub key: u64,
    /// Closed curves that have the region to their left: those around its parts counterclockwise,
    /// those around holes clockwise.
    pub outlines: Vec<Vec<Place>>,
    /// Area in parts of the plane.
    pub area: f64,
}

/// A curve between two regions, or two of their parts.
#[derive(Clone, Debug, PartialEq)]
pub struct Boundary {
    /// The keys on its left and on its right.
    pub sides: [u64; 2],
    /// Its points, each between two places that differ and are next to each other.
    pub points: Vec<Place>,
}

/// The regions of a plane and the boundaries between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Regions {
    /// By their keys.
    pub regions: Vec<Region>,
    /// In an order that depends on nothing but them; the border of the plane is not among them.
    pub boundaries: Vec<Boundary>,
}

impl Regions {
    /// Finds the regions; `ask` is asked for the keys of places, many at once, until it is known to a
    /// width where they change along the sides of cells. Once it gives none, they change anywhere
    /// between what is known.
    ///
    /// ```
    /// use littlewood_sweep::{Lattice, Regions};
    ///
    /// let inside = |[x, y]: [f64; 2]| u64::from((x - 0.5) * (x - 0.5) + (y - 0.5) * (y - 0.5) < 0.16);
    /// let lattice = Lattice::even(41, 41, |place| inside(place));
    /// let mut ask = |places: &[[f64; 2]]| Ok::<_, ()>(Some(places.iter().map(|&place| inside(place)).collect()));
    /// let found = Regions::find(&lattice, 1e-6, &mut ask)?;
    /// assert!((found.regions[1].area - 0.16 * std::f64::consts::PI).abs() < 1e-3);
    /// # Ok::<(), ()>(())
    /// ```
    ///
    /// # Errors
    /// What `ask` returns.
    pub fn find<E>(lattice: &Lattice, width: f64, ask: &mut Ask<'_, E>) -> Result<Self, E> {
        let mut crossings = Crossings::find(lattice, width.max(LEAST_WIDTH), ask)?;
        let (segments, border) = (crossings.segments(), crossings.border());
        let (regions, boundaries) = chain::regions(&crossings.nodes, &segments, &border);
        Ok(Self {
            regions,
            boundaries,
        })
    }

    /// The regions of the plane of a grid by keys of the summaries of its motions, each of which is
    /// followed to the limits; where keys change from point to point they are [`MIXED`]. Boundaries are located to a width, or as closely as
    /// [`FOR_A_POINT`] motions for a point of the grid allow, those of the grid among them. `told`
    /// is told of the motions that have been followed. The result does not depend on the number of
    /// threads.
    ///
    /// # Errors
    /// The first value that has no physical meaning by itself.
    ///
    /// # Panics
    /// If the grid has not two axes of two points or more.
    pub fn of_grid(
        grid: &Grid,
        key: &dyn Fn(&Summary) -> u64,
        limits: Limits,
        width: f64,
        workers: &Workers,
        told: &mut dyn FnMut(u64),
    ) -> Result<Self, ParameterError> {
        assert!(
            grid.axes().len() == 2,
            "a plane has two axes, not {}",
            grid.axes().len()
        );
        let [columns, rows] = [0, 1].map(|k| grid.axes()[k].count());
        assert!(
            columns > 1 && rows > 1,
            "a plane has two points or more to either side"
        );
        let mut ask = workers.keys_of_places(grid, limits, key, told);
        let mut lattice = Lattice::even(columns, rows, |_| 0);
        let places = lattice.all_places();
        let mut keys = Vec::with_capacity(places.len());
        for some in places.chunks(AT_ONCE) {
            keys.extend(ask(some)?.unwrap_or_default());
        }
        lattice.keys = keys;
        lattice.mix();
        let mut left = (FOR_A_POINT - 1) * lattice.keys.len();
        Self::find(
            &lattice,
            width,
            &mut |places| match left.checked_sub(places.len()) {
                None => Ok(None),
                Some(rest) => {
                    left = rest;
                    ask(places)
                }
            },
        )
    }
}

impl Lattice {
    /// Evenly spaced columns and rows, two at least of each, with the keys of their places.
    pub fn even(columns: usize, rows: usize, key: impl Fn(Place) -> u64) -> Self {
        let places = [columns, rows].map(|count| {
            let last = count.max(2) - 1;
            (0..=last)
                .map(|i| i as f64 / last as f64)
                .collect::<Vec<f64>>()
        });
        let lattice = Self {
            places,
            keys: Vec::new(),
        };
        let keys = lattice.all_places().into_iter().map(key).collect();
        Self { keys, ..lattice }
    }

    /// Gives the key [`MIXED`] to places around which keys change more finely than the lattice tells,
    /// so that no boundary is looked for between them.
    pub fn mix(&mut self) {
        if self.places.iter().any(|places| places.len() < FINE) {
            return;
        }
        let mixed = self.changing();
        if !mixed.contains(&true) {
            return;
        }
        let mixed = self.with_fringe(&self.closed(mixed));
        let keys = self.keys.iter().zip(mixed);
        let keys = keys.map(|(key, is_mixed)| if is_mixed { MIXED } else { *key });
        self.keys = keys.collect();
    }

    /// Of each place whether keys change around it from place to place.
    fn changing(&self) -> Vec<bool> {
        let [columns, rows] = [0, 1].map(|k| self.places[k].len());
        let key = |x: usize, y: usize| self.keys[y * columns + x];
        let near =
            |at: usize, by: usize, count: usize| at.saturating_sub(by)..=(at + by).min(count - 1);
        let beside = |x: usize, y: usize| {
            near(y, 1, rows).flat_map(move |v| near(x, 1, columns).map(move |u| (u, v)))
        };
        let is_alone = |x: usize, y: usize| {
            let mut same = beside(x, y).filter(|&(u, v)| key(u, v) == key(x, y));
            same.nth(1).is_none()
        };
        let alone: Vec<bool> = (0..rows)
            .flat_map(|y| (0..columns).map(move |x| (x, y)))
            .map(|(x, y)| is_alone(x, y))
            .collect();
        let is_mixed = |x: usize, y: usize| {
            // Next to what is mixed all may be of one key.
            if beside(x, y).all(|(u, v)| key(u, v) == key(x, y)) {
                return false;
            }
            let (mut sides, mut changes, mut lonely) = (0_u32, 0_u32, 0_u32);
            for v in near(y, AROUND, rows) {
                for u in near(x, AROUND, columns) {
                    lonely += u32::from(alone[v * columns + u]);
                    for (right, up) in [(u + 1, v), (u, v + 1)] {
                        if right <= (x + AROUND).min(columns - 1)
                            && up <= (y + AROUND).min(rows - 1)
                        {
                            sides += 1;
                            changes += u32::from(key(u, v) != key(right, up));
                        }
                    }
                }
            }
            f64::from(lonely) / ALONE + f64::from(changes) / (CHANGES * f64::from(sides)) >= 1.0
        };
        let places = (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y)));
        places.map(|(x, y)| is_mixed(x, y)).collect()
    }

    /// The numbers of the places so near to one.
    fn around(&self, place: usize, by: usize) -> impl Iterator<Item = usize> {
        let [columns, rows] = [0, 1].map(|k| self.places[k].len());
        let near = |at: usize, count: usize| at.saturating_sub(by)..=(at + by).min(count - 1);
        let across = near(place % columns, columns);
        near(place / columns, rows).flat_map(move |y| across.clone().map(move |x| y * columns + x))
    }

    /// Without small holes, which are no regions: what is mixed around most of them is mixed.
    fn closed(&self, mut mixed: Vec<bool>) -> Vec<bool> {
        for _ in 0..SMOOTHED {
            let most = |place: usize| {
                let (mut all, mut of_them) = (0_u32, 0_u32);
                for other in self.around(place, AROUND) {
                    all += 1;
                    of_them += u32::from(mixed[other]);
                }
                2 * of_them > all
            };
            let places = 0..mixed.len();
            mixed = places.map(|place| mixed[place] || most(place)).collect();
        }
        mixed
    }

    /// With what is beside it but for the squares of one key: a fringe is no region.
    fn with_fringe(&self, mixed: &[bool]) -> Vec<bool> {
        let is_of_one = |place: usize| {
            let mut around = self.around(place, LEAST);
            around.all(|other| !mixed[other] && self.keys[other] == self.keys[place])
        };
        let of_one: Vec<bool> = (0..mixed.len()).map(is_of_one).collect();
        let is_fringe = |place: usize| {
            self.around(place, AROUND).any(|other| mixed[other])
                && !self.around(place, LEAST).any(|other| of_one[other])
        };
        let places = 0..mixed.len();
        places
            .map(|place| mixed[place] || is_fringe(place))
            .collect()
    }

    /// All its places, row by row, the lowest first.
    pub(crate) fn all_places(&self) -> Vec<Place> {
        let [columns, rows] = &self.places;
        rows.iter()
            .flat_map(|&y| columns.iter().map(move |&x| [x, y]))
            .collect()
    }

    /// Its right upper corner: as many cells are to the left of it and below it.
    fn last(&self) -> Corner {
        let [columns, rows] = &self.places;
        Corner::new(columns.len() - 1, rows.len() - 1)
    }

    /// The place of a corner.
    fn place(&self, corner: Corner) -> Place {
        let [columns, rows] = &self.places;
        [columns[corner.x], rows[corner.y]]
    }

    fn key(&self, corner: Corner) -> u64 {
        self.keys[corner.y * self.places[0].len() + corner.x]
    }
}
