//! What was examined where the motion that follows is not unique.

use littlewood::{Direction, Findings, Mode};
use serde::Serialize;

use super::direction::sign;

/// What was found where the motion that follows is not unique.
#[derive(Debug, Serialize)]
pub(crate) struct FindingsRecord {
    consistent: Vec<MotionRecord>,
    rolling_normal: f64,
    rolling_friction: f64,
    contact: f64,
    solvability_negative: f64,
    solvability_positive: f64,
}

#[derive(Debug, Serialize)]
struct MotionRecord {
    mode: &'static str,
    direction: i8,
}

impl From<&Findings> for FindingsRecord {
    fn from(findings: &Findings) -> Self {
        let motion = |(mode, direction): (Mode, Option<Direction>)| MotionRecord {
            mode: mode.name(),
            direction: sign(direction),
        };
        let [solvability_negative, solvability_positive] = findings.solvability;
        Self {
            consistent: findings.consistent().map(motion).collect(),
            rolling_normal: findings.rolling_forces.normal,
            rolling_friction: findings.rolling_forces.friction,
            contact: findings.contact,
            solvability_negative,
            solvability_positive,
        }
    }
}
