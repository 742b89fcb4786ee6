//! The records that programs read, with their fixed names. A number that is not finite becomes `null` in JSON.

mod case;
mod classification;
mod direction;
mod findings;
mod hoop;
mod outcome;
mod phase;
mod recurrence;
mod sample;
mod state;
mod transition;
mod units;

pub(crate) use case::CaseRecord;
pub(crate) use classification::ClassificationRecord;
pub(crate) use direction::sign;
pub(crate) use hoop::HoopRecord;
pub(crate) use outcome::OutcomeRecord;
pub(crate) use phase::PhaseRecord;
pub(crate) use sample::{SampleRecord, SiSampleRecord};
pub(crate) use state::{SiStateRecord, StartRecord, StateRecord};
pub(crate) use transition::{EdgeRecord, TransitionRecord};
pub(crate) use units::SiRecord;
