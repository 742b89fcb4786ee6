//! The figures of the paper, one after the other.

pub(crate) mod loci;
