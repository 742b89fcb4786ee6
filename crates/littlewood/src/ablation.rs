//! Parts of the solvers that a benchmark can switch off, to measure what each of them earns: the
//! feature `ablation`.
//!
//! Without the feature every part is on, and nothing is asked at run time. A part that is off is
//! done by the next slower solver; results stay the same to rounding.

/// A part that can be switched off.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Chains of slips, passed by whole links.
    Chains,
    /// Cells of slides and octants of rolling that a motion keeps.
    KeptCells,
    /// Sums over whole turns of a slide.
    WholeTurns,
    /// The table of jumps out of slides.
    Jumps,
}

impl Part {
    /// Every part.
    pub const ALL: [Self; 4] = [Self::Chains, Self::KeptCells, Self::WholeTurns, Self::Jumps];
}

#[cfg(feature = "ablation")]
mod switch {
    use core::sync::atomic::{AtomicU32, Ordering};

    use super::Part;

    static OFF: AtomicU32 = AtomicU32::new(0);

    /// Switches these parts off, and all others on, in the whole process.
    pub fn switch_off(parts: &[Part]) {
        OFF.store(
            parts.iter().fold(0, |off, part| off | 1 << *part as u32),
            Ordering::Relaxed,
        );
    }

    pub(crate) fn is_on(part: Part) -> bool {
        OFF.load(Ordering::Relaxed) & 1 << part as u32 == 0
    }
}

#[cfg(feature = "ablation")]
pub(crate) use switch::is_on;
#[cfg(feature = "ablation")]
pub use switch::switch_off;

#[cfg(not(feature = "ablation"))]
pub(crate) const fn is_on(_: Part) -> bool {
    true
}
