//! The cells of a map: one for each pixel at most, whatever the number of points.

use littlewood::Class;

/// What the cells of a map hold.
#[derive(Clone, Debug)]
pub(super) enum Cells {
    Class(Vec<Class>),
    /// None where it is not computed.
    Real(Vec<Option<f64>>),
}

/// The cell that shows a place of an axis; none where the axis has been thinned.
pub(super) fn cell(index: usize, count: usize, cells: usize) -> Option<usize> {
    // Cell j shows the place in the middle of its share of the axis. Where cells are hardly wider than places, that place
    // may begin in the share before.
    let shown = |j: usize| (2 * j + 1) * count / (2 * cells);
    let share = index * cells / count;
    [share, share + 1].into_iter().find(|&j| j < cells && shown(j) == index)
}

#[cfg(test)]
mod tests {
    use super::cell;

    #[test]
    fn every_cell_shows_one_place_in_order() {
        for count in (1..900).step_by(7) {
            for cells in (1..=count).step_by(3).chain([count]) {
                let shown: Vec<usize> = (0..count).filter_map(|index| cell(index, count, cells)).collect();
                assert_eq!(shown, (0..cells).collect::<Vec<usize>>(), "{count} places in {cells} cells");
            }
        }
    }
}
