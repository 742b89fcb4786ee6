//! The results as text: for a person ([`table`]) and for programs ([`json`], [`csv`]).

pub(crate) mod sweep;
pub(crate) mod table;

pub(crate) use littlewood_report::{Sampling, csv, json};
