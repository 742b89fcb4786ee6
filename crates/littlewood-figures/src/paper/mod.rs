//! The figures of the paper, one after the other.

pub(crate) mod gliding;
pub(crate) mod loci;
pub(crate) mod portrait;
pub(crate) mod types;
