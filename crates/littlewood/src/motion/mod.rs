//! A motion that has been simulated: its trajectory, samples, summary, and trusted digits.

pub(crate) mod class;
pub(crate) mod classify;
pub(crate) mod columns;
pub(crate) mod digits;
pub(crate) mod simulate;
pub(crate) mod summary;
pub(crate) mod trajectory;
