//! What is known of a start.

use littlewood::{Classification, Limit, RollingEnd, RollingType};
use serde::Serialize;

use super::direction::sign;
use super::findings::FindingsRecord;
use super::recurrence::RecurrenceRecord;

/// What is known of a start.
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
    rolling_end: Option<RollingEndRecord>,
    rolls_forever: Option<RecurrenceRecord>,
    findings: Option<FindingsRecord>,
}

#[derive(Debug, Serialize)]
struct RollingEndRecord {
    elapsed: f64,
    theta: f64,
    theta_rate: f64,
    cause: &'static str,
    direction: i8,
}

impl From<&RollingEnd> for RollingEndRecord {
    fn from(end: &RollingEnd) -> Self {
        let (cause, direction) = match end.limit {
            Limit::Friction(direction) => ("slip", Some(direction)),
            Limit::NormalForce => ("normal_force_zero", None),
        };
        Self {
            elapsed: end.elapsed,
            theta: end.theta,
            theta_rate: end.theta_rate,
            cause,
            direction: sign(direction),
        }
    }
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
            rolling_end: found.rolling_end.as_ref().map(RollingEndRecord::from),
            rolls_forever: found.recurrence.as_ref().map(RecurrenceRecord::from),
            findings: found.findings.as_ref().map(FindingsRecord::from),
        }
    }
}
