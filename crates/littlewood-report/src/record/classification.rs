//! What is known of a start.

use littlewood::modes::RollingEnd;
use littlewood::tables::SampleColumn;
use littlewood::theory::{Candidates, Classification, RollingType};
use littlewood::{Mode, SlipDirection};
use serde::Serialize;

use super::fields::{Fields, Value};

#[derive(Debug, Serialize)]
pub(crate) struct ClassificationRecord {
    region: &'static str,
    energy: f64,
    rolling_normal: f64,
    rolling_friction: f64,
    /// `null` where N ≤ 0.
    friction_demand: f64,
    contact: f64,
    rolling_type: Option<&'static str>,
    rolling_end: Option<Fields>,
    rolls_forever: Option<Fields>,
    /// On a slope only: the ratio of successive bounces that grow out of rolling.
    #[serde(skip_serializing_if = "Option::is_none")]
    reverse_chatter: Option<f64>,
    #[serde(rename = "findings")]
    candidates: Option<CandidatesRecord>,
    #[serde(skip_serializing_if = "Option::is_none")]
    undecided: Option<Fields>,
}

fn rolling_end(end: RollingEnd) -> Fields {
    Fields::from_iter([
        ("elapsed", Value::Real(end.elapsed)),
        (SampleColumn::Theta.name(), Value::Real(end.theta)),
        (SampleColumn::ThetaRate.name(), Value::Real(end.theta_rate)),
        ("cause", Value::Word(Some(end.limit.cause().name()))),
        (SampleColumn::Direction.name(), end.limit.direction().into()),
    ])
}

impl From<&Classification> for ClassificationRecord {
    fn from(found: &Classification) -> Self {
        Self {
            region: found.region.name(),
            energy: found.energy,
            rolling_normal: found.rolling_forces.normal,
            rolling_friction: found.rolling_forces.friction,
            friction_demand: found.rolling_forces.demand(),
            contact: found.contact,
            rolling_type: found.rolling_type.map(RollingType::name),
            rolling_end: found.rolling_end.map(rolling_end),
            rolls_forever: found
                .recurrence
                .map(|recurrence| Fields::of_details(recurrence.details())),
            reverse_chatter: found.reverse_chatter,
            candidates: found.candidates.map(CandidatesRecord::from),
            undecided: found
                .undecided
                .map(|undecided| Fields::of_details(undecided.details())),
        }
    }
}

/// The motions that are consistent, and the numbers that decide.
#[derive(Debug, Serialize)]
pub(crate) struct CandidatesRecord {
    consistent: Vec<Fields>,
    #[serde(flatten)]
    details: Fields,
}

impl From<Candidates> for CandidatesRecord {
    fn from(candidates: Candidates) -> Self {
        let fields = |(mode, direction): (Mode, Option<SlipDirection>)| {
            Fields::from_iter([("mode", Some(mode).into()), ("direction", direction.into())])
        };
        Self {
            consistent: candidates.consistent().map(fields).collect(),
            details: Fields::of_details(candidates.details()),
        }
    }
}
