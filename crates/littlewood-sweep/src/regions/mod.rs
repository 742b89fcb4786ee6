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
    /// followed to the limits. Boundaries are located to a width, or as closely as
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
