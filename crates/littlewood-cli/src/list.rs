//! Lists of starts, or of hoops.

use std::path::Path;

use littlewood::tables::Quantity;
use littlewood_sweep::StartList;

use crate::axis::TypedAxis;
use crate::error::Error;
use crate::work::STAND_IN;

pub(crate) fn columns(path: &Path) -> Result<Vec<Quantity>, Error> {
    Ok(StartList::open(path, STAND_IN)?.columns().to_vec())
}

/// The columns of a list of hoops, all of them of the hoop and none on an axis, too.
pub(crate) fn hoop_columns(
    path: &Path,
    axes: &[TypedAxis],
    first_turn: bool,
) -> Result<Vec<Quantity>, Error> {
    let bad = |column: Quantity, reason: &str| Error::HoopColumn {
        path: path.to_owned(),
        column,
        reason: reason.to_owned(),
    };
    columns(path)?
        .into_iter()
        .map(|column| {
            if !Quantity::HOOP.contains(&column) {
                Err(bad(column, "is of the start, not of the hoop"))
            } else if axes.iter().any(|axis| axis.quantities().any(|varied| varied == column)) {
                Err(bad(column, "is an axis, too"))
            } else if first_turn && column == Quantity::MuK {
                Err(bad(column, "follows mu_s with --first-turn"))
            } else {
                Ok(column)
            }
        })
        .collect()
}
