//! The figures: those of the paper, one after the other, then more of the same hoop.

pub(crate) mod bounces;
pub(crate) mod gliding;
pub(crate) mod histories;
pub(crate) mod impact;
pub(crate) mod loci;
pub(crate) mod outcomes;
pub(crate) mod overview;
pub(crate) mod painleve;
pub(crate) mod paths;
pub(crate) mod phase_path;
pub(crate) mod portrait;
pub(crate) mod schematic;
pub(crate) mod state_space;
pub(crate) mod stroboscope;
pub(crate) mod types;
