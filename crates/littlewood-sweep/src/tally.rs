//! How many points there are of each class.

use core::ops::AddAssign;

use littlewood::tables::Class;

use crate::columns::Columns;

/// Numbers of points, class by class.
///
/// ```
/// use littlewood::tables::Class;
/// use littlewood_sweep::Tally;
///
/// let mut tally = Tally::default();
/// tally.add(Class::RollsForever, 3);
/// assert_eq!((tally.of(Class::RollsForever), tally.total()), (3, 3));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tally([u64; Class::ALL.len()]);

impl Tally {
    /// The tally of some results.
    #[must_use]
    pub fn of_columns(columns: &Columns) -> Self {
        let mut tally = Self::default();
        for &class in columns.classes() {
            tally.add(class, 1);
        }
        tally
    }

    /// Number of points of a class.
    pub const fn of(&self, class: Class) -> u64 {
        self.0[class as usize]
    }

    /// Adds points of a class.
    pub const fn add(&mut self, class: Class, count: u64) {
        self.0[class as usize] += count;
    }

    /// Number of all points.
    pub fn total(&self) -> u64 {
        self.0.iter().sum()
    }

    /// The classes that occur, in the order of [`Class::ALL`].
    pub fn iter(&self) -> impl Iterator<Item = (Class, u64)> + '_ {
        Class::ALL
            .into_iter()
            .zip(self.0)
            .filter(|(_, count)| *count > 0)
    }
}

impl AddAssign for Tally {
    fn add_assign(&mut self, other: Self) {
        for (count, more) in self.0.iter_mut().zip(other.0) {
            *count += more;
        }
    }
}
