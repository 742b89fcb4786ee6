//! The outcome of a motion.

use littlewood::Outcome;
use littlewood::derivatives::Derivatives;
use littlewood::si::Units;
use serde::Serialize;

use super::classification::CandidatesRecord;
use super::derivatives::{DerivativesRecord, of_outcome};
use super::fields::Fields;
use super::instant::{si_state, state};

#[derive(Debug, Serialize)]
pub(crate) struct OutcomeRecord {
    kind: &'static str,
    #[serde(flatten)]
    fields: Fields,
    #[serde(flatten)]
    candidates: Option<CandidatesRecord>,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<Fields>,
    #[serde(skip_serializing_if = "Option::is_none")]
    derivatives: Option<DerivativesRecord>,
}

impl OutcomeRecord {
    pub(crate) fn new(
        outcome: &Outcome,
        units: Option<&Units>,
        derivatives: Option<&Derivatives>,
    ) -> Self {
        let end = outcome.state();
        let si = |units| {
            si_state(units, &end).followed_by(Fields::of_si_details(units, outcome.details()))
        };
        Self {
            kind: outcome.kind().name(),
            fields: state(&end).followed_by(Fields::of_details(outcome.details())),
            candidates: outcome.candidates().map(CandidatesRecord::from),
            si: units.map(si),
            derivatives: derivatives.map(of_outcome),
        }
    }
}
