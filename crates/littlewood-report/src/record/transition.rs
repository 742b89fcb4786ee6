//! Transitions.

use littlewood::{Mode, Transition, Units};
use serde::Serialize;

use super::direction::sign;
use super::state::{SiStateRecord, StateRecord};

/// What changes at a transition.
#[derive(Debug, Serialize)]
pub(crate) struct EdgeRecord {
    /// Mode that ends.
    pub(crate) from: Option<&'static str>,
    /// Mode that begins.
    pub(crate) to: Option<&'static str>,
    /// σ of the motion that begins.
    pub(crate) direction: i8,
    /// Event.
    pub(crate) cause: &'static str,
}

impl From<&Transition> for EdgeRecord {
    fn from(transition: &Transition) -> Self {
        Self {
            from: Some(transition.from.name()),
            to: transition.to.map(Mode::name),
            direction: sign(transition.direction),
            cause: transition.cause.name(),
        }
    }
}

/// A transition.
#[derive(Debug, Serialize)]
pub(crate) struct TransitionRecord {
    #[serde(flatten)]
    state: StateRecord,
    #[serde(flatten)]
    edge: EdgeRecord,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<SiStateRecord>,
}

impl TransitionRecord {
    pub(crate) fn new(transition: &Transition, units: Option<&Units>) -> Self {
        Self {
            state: transition.state.into(),
            edge: transition.into(),
            si: units.map(|units| SiStateRecord::new(units, &transition.state)),
        }
    }
}
