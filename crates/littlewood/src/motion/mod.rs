//! A simulated motion: its trajectory, samples, summary, and significant digits.

pub(crate) mod class;
pub(crate) mod classify;
pub(crate) mod columns;
pub(crate) mod derivatives;
pub(crate) mod digits;
pub(crate) mod energy;
pub(crate) mod simulate;
pub(crate) mod summary;
pub(crate) mod threshold;
pub(crate) mod trajectory;
