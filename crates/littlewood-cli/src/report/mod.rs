//! The results as text: for a person ([`table`]) and for programs ([`json`], [`csv`]).

pub(crate) mod atlas;
pub(crate) mod csv;
pub(crate) mod json;
mod number;
mod record;
mod scale;
mod sheet;
pub(crate) mod sweep;
pub(crate) mod table;

/// Which instants to sample.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sampling {
    /// Number of evenly spaced instants.
    pub(crate) count: usize,
    /// The last instant.
    pub(crate) until: f64,
}
