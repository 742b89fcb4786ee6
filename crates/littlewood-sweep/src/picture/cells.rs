//! The cells of a map: one for each pixel at most, whatever the number of points.

use littlewood::tables::Class;

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cell {
    /// What has a colour of its own: a class, or a sequence.
    pub(super) key: u64,
    /// The number of the shade; NaN if it has none.
    pub(super) number: f64,
}

impl Cell {
    pub(super) const NOT_COMPUTED: Self = Self {
        key: of_class(Class::NotComputed),
        number: f64::NAN,
    };

    pub(super) fn class(self) -> Option<Class> {
        class_of(self.key)
    }
}

/// Above all sequences that fit, so that a map of sequences can tell what has none.
const CLASSES: u64 = u64::MAX - 0xff;

pub(super) const fn of_class(class: Class) -> u64 {
    CLASSES + class.code() as u64
}

/// The class of a key; none for a sequence.
pub(super) fn class_of(key: u64) -> Option<Class> {
    let code = u8::try_from(key.checked_sub(CLASSES)?).ok()?;
    Class::try_from(code).ok()
}

/// The place of an axis that cell `j` of `cells` shows: the ends at the ends, the others evenly
/// between them.
pub(super) const fn place(j: usize, count: usize, cells: usize) -> usize {
    if cells < 2 {
        0
    } else {
        (2 * j * (count - 1) + cells - 1) / (2 * (cells - 1))
    }
}

/// The cell that shows a place of an axis; none where the axis has been thinned.
pub(super) fn cell(index: usize, count: usize, cells: usize) -> Option<usize> {
    let near = if count < 2 {
        0
    } else {
        index * (cells - 1) / (count - 1)
    };
    (near.saturating_sub(1)..=near + 1).find(|&j| j < cells && place(j, count, cells) == index)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_cell_shows_one_place_in_order_and_the_ends_are_shown() {
        for count in (1..900).step_by(7) {
            for cells in (2..=count).step_by(3).chain([1, count]) {
                let shown: Vec<usize> = (0..count)
                    .filter_map(|index| cell(index, count, cells))
                    .collect();
                assert_eq!(
                    shown,
                    (0..cells).collect::<Vec<usize>>(),
                    "{count} places in {cells} cells"
                );
                if cells > 1 {
                    assert_eq!(
                        (place(0, count, cells), place(cells - 1, count, cells)),
                        (0, count - 1)
                    );
                }
            }
        }
    }

    #[test]
    fn a_class_comes_back_from_its_key() {
        for class in Class::ALL {
            assert_eq!(class_of(of_class(class)), Some(class));
        }
        assert_eq!(class_of(0x71), None);
    }
}
