//! A number or a word in a record, with what is needed to show it.

use crate::model::dimension::Dimension;

/// A number or a word that belongs to an outcome, under its name in records.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Detail {
    /// A number with its dimension.
    Real(f64, Dimension),
    /// A count.
    Count(usize),
    /// A word.
    Word(&'static str),
}
