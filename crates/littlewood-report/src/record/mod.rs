//! The records that programs read, with the names of the core's tables. A number that is not finite becomes `null` in
//! JSON.

mod candidates;
mod case;
mod classification;
mod fields;
mod instant;
mod outcome;
mod phase;
mod setup;
mod transition;

pub(crate) use case::CaseRecord;
pub(crate) use classification::ClassificationRecord;
pub(crate) use fields::{Fields, Value};
pub(crate) use instant::{sample, si_sample, si_state, state};
pub(crate) use outcome::OutcomeRecord;
pub(crate) use phase::PhaseRecord;
pub(crate) use setup::{SiRecord, StartRecord, hoop};
pub(crate) use transition::{TransitionRecord, edge, edge_of};
