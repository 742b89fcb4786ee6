//! Cells of slides and octants of rolling, kept once they have been computed: they depend on the hoop alone.

use std::sync::OnceLock;

use crate::mechanics::equations::SlidingLaw;

use super::roll::{Margins, OCTANTS, Octant};
use super::slide::{CELLS, Cell};

/// What is kept of one hoop. It is filled where motions come, and is the same whichever motion that is.
#[derive(Clone, Debug, Default)]
pub(super) struct Atlas {
    /// For σ = −1 and σ = +1 in the frame of motion; none where there is no cell.
    cells: [[OnceLock<Option<Box<Cell>>>; CELLS]; 2],
    octants: [OnceLock<Box<Octant>>; OCTANTS],
    /// The constants K of the orbits that certainly hold everywhere.
    levels: OnceLock<(f64, f64)>,
}

impl Atlas {
    /// A cell of slides, if there is one.
    pub(super) fn cell(&self, law: &SlidingLaw, sigma: f64, number: usize) -> Option<&Cell> {
        let cells = &self.cells[usize::from(sigma > 0.0)];
        cells[number].get_or_init(|| Cell::new(law, sigma, number).map(Box::new)).as_deref()
    }

    /// Whether the orbit with constant K holds everywhere.
    pub(super) fn holds(&self, margins: &Margins, k: f64) -> bool {
        let (low, high) = *self.levels.get_or_init(|| {
            let levels = (0..OCTANTS).map(|number| self.octant(margins, number).levels());
            levels.fold((0.0, f64::INFINITY), |all, one| (all.0.max(one.0), all.1.min(one.1)))
        });
        k > low && k < high
    }

    /// An octant of rolling.
    pub(super) fn octant(&self, margins: &Margins, number: usize) -> &Octant {
        self.octants[number].get_or_init(|| Box::new(Octant::new(margins, number)))
    }
}
