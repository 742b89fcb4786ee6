//! The regions of what becomes of motions in the plane of a grid.

use littlewood::{Limits, ParameterError, Summary};

use super::{Detail, Lattice, Place, Regions};
use crate::compute::Workers;
use crate::grid::Grid;

/// Points of the grid that are followed before somebody is told.
const AT_ONCE: usize = 512;

impl Regions {
    /// The regions of the plane of a grid by keys of the summaries of its motions, each of which is followed to the limits.
    /// `told` is told of the motions that have been followed. The result does not depend on the number of threads.
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
        detail: &Detail,
        workers: &Workers,
        told: &mut dyn FnMut(u64),
    ) -> Result<Self, ParameterError> {
        assert!(grid.axes().len() == 2, "a plane has two axes, not {}", grid.axes().len());
        let count = [0, 1].map(|k| grid.axes()[k].count());
        assert!(count.iter().all(|count| *count > 1), "a plane has two points or more to either side");
        let mut ask = workers.keys_of_places(grid, limits, key, told);
        let mut lattice = Lattice::even(count, |_| 0);
        let [columns, rows] = &lattice.places;
        let places: Vec<Place> = rows.iter().flat_map(|&y| columns.iter().map(move |&x| [x, y])).collect();
        let mut keys = Vec::with_capacity(places.len());
        for some in places.chunks(AT_ONCE) {
            keys.extend(ask(some)?);
        }
        lattice.keys = keys;
        Self::find(&lattice, detail, &mut ask)
    }
}
