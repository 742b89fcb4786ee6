//! What a motion has computed on its way, for when it comes there again: a hoop that swings slips at nearly the same angles a hundred times.

use core::cell::{self, OnceCell};

use crate::ablation::{Part, is_on};
use crate::mechanics::equations::SlidingLaw;

use super::cell::{CELLS, Cell};
use super::roll::{Margins, OCTANTS, Octant};

/// Phases that are computed directly before anything is kept: few motions have more, and those go on for long.
const PHASES_WITHOUT: u32 = 4;

/// What belongs to one hoop and one motion. What is kept depends on the hoop alone, and when it is used on the number of phases of the
/// motion: the same motion has the same bits wherever it is computed.
#[derive(Clone, Debug, Default)]
pub(in super::super) struct Memory {
    /// Phases that have been computed directly.
    phases: cell::Cell<u32>,
    contents: OnceCell<Box<Contents>>,
}

/// What is known.
#[derive(Clone, Debug, Default)]
pub(super) struct Contents {
    /// For σ = −1 and σ = +1 in the frame of motion; none where there is no cell.
    cells: [[OnceCell<Option<Box<Cell>>>; CELLS]; 2],
    octants: [OnceCell<Box<Octant>>; OCTANTS],
}

impl Memory {
    /// With a phase that begins: what is known, if the motion is so long that it pays.
    pub(super) fn recall(&self) -> Option<&Contents> {
        let phases = self.phases.get();
        if phases < PHASES_WITHOUT || !is_on(Part::KeptCells) {
            self.phases.set(phases + 1);
            return None;
        }
        Some(self.contents.get_or_init(Box::default))
    }
}

impl Contents {
    /// A cell of slides, if there is one.
    pub(super) fn cell(&self, law: &SlidingLaw, sigma: f64, number: usize) -> Option<&Cell> {
        let cells = &self.cells[usize::from(sigma > 0.0)];
        cells[number].get_or_init(|| Cell::new(law, sigma, number).map(Box::new)).as_deref()
    }

    /// An octant of rolling.
    pub(super) fn octant(&self, margins: &Margins, number: usize) -> &Octant {
        self.octants[number].get_or_init(|| Box::new(Octant::new(margins, number)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_known_is_asked_for_in_long_motions_only() {
        let memory = Memory::default();
        for phase in 0..20 {
            assert_eq!(memory.recall().is_some(), phase >= PHASES_WITHOUT);
        }
    }
}
