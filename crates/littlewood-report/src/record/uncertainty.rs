//! Standard errors of a motion, dimensionless.

use serde::Serialize;

use super::fields::{Fields, Value};
use super::instant::state;
use crate::{Spread, Uncertainty};

#[derive(Debug, Serialize)]
pub(crate) struct UncertaintyRecord {
    given: Fields,
    motions: usize,
    alike: usize,
    transitions: Vec<SpreadRecord>,
    outcome: Option<SpreadRecord>,
}

/// The standard errors of a state. They are `null` where a derivative does not exist, or where
/// fewer than two motions of the sample get there.
#[derive(Debug, Serialize)]
struct SpreadRecord {
    first_order: Option<Fields>,
    sample: Option<Fields>,
    motions: usize,
}

impl UncertaintyRecord {
    pub(crate) fn new(uncertainty: &Uncertainty) -> Self {
        let record = |spread: &Spread| SpreadRecord {
            first_order: spread.first_order.as_ref().map(state),
            sample: spread.sample.as_ref().map(state),
            motions: spread.motions,
        };
        let given = uncertainty
            .given
            .iter()
            .map(|(quantity, error)| (quantity.name(), Value::Real(*error)));
        let mut transitions: Vec<SpreadRecord> = uncertainty.spreads.iter().map(record).collect();
        let outcome = transitions.pop();
        Self {
            given: given.collect(),
            motions: uncertainty.motions,
            alike: uncertainty.alike,
            transitions,
            outcome,
        }
    }
}
