//! The four modes of motion, each with its solution and its events.

pub(crate) mod flight;
pub(crate) mod gliding;
pub(crate) mod rolling;
pub(crate) mod sliding;
