//! From mode to mode: which motion is consistent, which event ends it, how the motion ends.

pub(crate) mod automaton;
pub(crate) mod candidates;
pub(crate) mod exact;
pub(crate) mod follow;
pub(crate) mod origin;
pub(crate) mod outcome;
pub(crate) mod proofs;
pub(crate) mod sequence;
pub(crate) mod slip;
