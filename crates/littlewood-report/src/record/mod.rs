//! The records that programs read, with the names of the core's tables. A number that is not finite
//! becomes `null` in JSON.

mod classification;
mod derivatives;
mod fields;
mod impact;
mod instant;
mod outcome;
mod phase;
mod setup;
mod transition;
mod uncertainty;

pub(crate) use classification::ClassificationRecord;
pub(crate) use derivatives::derivative_columns;
pub(crate) use fields::{Fields, Value};
pub(crate) use impact::{jump, si_jump};
pub(crate) use instant::{sample, si_sample, si_state, state};
pub(crate) use outcome::OutcomeRecord;
pub(crate) use phase::PhaseRecord;
pub use setup::RESTITUTION_LAW;
pub(crate) use setup::{CaseRecord, SiRecord, StartRecord, hoop, opening};
pub(crate) use transition::{TransitionRecord, digit_columns, digits_of, edge, edge_of};
pub(crate) use uncertainty::UncertaintyRecord;
