//! The outcome of a motion.

use littlewood::{Outcome, Units};
use serde::Serialize;

use super::findings::FindingsRecord;
use super::recurrence::RecurrenceRecord;
use super::state::{SiStateRecord, StateRecord};

/// How a motion ended.
#[derive(Debug, Serialize)]
pub(crate) struct OutcomeRecord {
    kind: &'static str,
    #[serde(flatten)]
    state: StateRecord,
    #[serde(flatten)]
    details: Details,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<SiOutcomeRecord>,
}

#[derive(Debug, Serialize)]
#[serde(untagged)]
enum Details {
    Landing { gap_rate: f64 },
    Recurs(RecurrenceRecord),
    TransitionLimit { transitions: usize },
    Undecided(FindingsRecord),
    Singular { solvability: f64 },
    Nothing {},
}

#[derive(Debug, Serialize)]
struct SiOutcomeRecord {
    #[serde(flatten)]
    state: SiStateRecord,
    #[serde(skip_serializing_if = "Option::is_none")]
    gap_rate_m_per_s: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    period_s: Option<f64>,
}

impl OutcomeRecord {
    pub(crate) fn new(outcome: &Outcome, units: Option<&Units>) -> Self {
        let details = match outcome {
            Outcome::Landing { gap_rate, .. } => Details::Landing { gap_rate: *gap_rate },
            Outcome::RollsForever { recurrence, .. } | Outcome::SlidesForever { recurrence, .. } => {
                Details::Recurs(recurrence.into())
            }
            Outcome::TransitionLimit { transitions, .. } => {
                Details::TransitionLimit { transitions: *transitions }
            }
            Outcome::Inconsistent { findings, .. } | Outcome::Ambiguous { findings, .. } => {
                Details::Undecided(findings.into())
            }
            Outcome::Singular { solvability, .. } => Details::Singular { solvability: *solvability },
            _ => Details::Nothing {},
        };
        let si = units.map(|units| SiOutcomeRecord {
            state: SiStateRecord::new(units, &outcome.state()),
            gap_rate_m_per_s: match details {
                Details::Landing { gap_rate } => Some(gap_rate * units.velocity_m_per_s()),
                _ => None,
            },
            period_s: match &details {
                Details::Recurs(recurrence) => recurrence.period.map(|period| period * units.time_s),
                _ => None,
            },
        });
        Self { kind: outcome.kind(), state: outcome.state().into(), details, si }
    }
}
