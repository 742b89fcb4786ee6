//! Lists of starts, or of hoops.

use std::path::Path;

use littlewood::{HoopParameters, Quantity, Start};
use littlewood_sweep::{Coordinate, Point, StartList};

use crate::axis::TypedAxis;
use crate::error::Error;

/// A point that is good for finding out which columns there are.
const STAND_IN: Point = Point {
    hoop: HoopParameters { mass_ratio: 1.0, offset: 0.5, inertia: 1.0, mu_s: 1.0, mu_k: 0.0 },
    start: Start { time: 0.0, theta: 0.0, theta_rate: 0.0, slip: 0.0, x: 0.0 },
};

/// The columns of a list.
///
/// # Errors
/// As [`StartList::open`].
pub(crate) fn columns(path: &Path) -> Result<Vec<Quantity>, Error> {
    Ok(StartList::open(path, STAND_IN)?.columns().to_vec())
}

/// The columns of a list of hoops.
///
/// # Errors
/// As [`StartList::open`]; a column that is not of the hoop, or that an axis has already.
pub(crate) fn hoop_columns(
    path: &Path,
    axes: &[TypedAxis],
    first_turn: bool,
) -> Result<Vec<Coordinate>, Error> {
    let bad = |column: Quantity, reason: &str| Error::HoopColumn {
        path: path.to_owned(),
        column: column.name().to_owned(),
        reason: reason.to_owned(),
    };
    columns(path)?
        .into_iter()
        .map(|column| match Coordinate::of(column).filter(|coordinate| coordinate.is_of_the_hoop()) {
            None => Err(bad(column, "is of the start, not of the hoop")),
            Some(coordinate) if axes.iter().any(|axis| axis.coordinate() == coordinate) => {
                Err(bad(column, "is an axis, too"))
            }
            Some(Coordinate::MuK) if first_turn => Err(bad(column, "follows mu_s with --first-turn")),
            Some(coordinate) => Ok(coordinate),
        })
        .collect()
}
