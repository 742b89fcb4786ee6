//! What is given: quantities and their units, the hoop, its start, the limits of a simulation.

pub(crate) mod dimension;
pub(crate) mod error;
pub(crate) mod hoop;
pub(crate) mod limits;
pub(crate) mod mode;
pub(crate) mod named;
pub(crate) mod quantity;
pub(crate) mod restitution;
pub(crate) mod setup;
pub(crate) mod si;
pub(crate) mod state;
pub(crate) mod units;
