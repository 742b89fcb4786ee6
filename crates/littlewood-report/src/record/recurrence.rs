//! How a motion without an end comes back.

use littlewood::Recurrence;
use serde::Serialize;

/// How a motion that lasts for ever comes back.
#[derive(Debug, Serialize)]
pub(crate) struct RecurrenceRecord {
    recurrence: &'static str,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) period: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    theta_min: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    theta_max: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    theta_limit: Option<f64>,
}

impl From<&Recurrence> for RecurrenceRecord {
    fn from(recurrence: &Recurrence) -> Self {
        let blank =
            Self { recurrence: "rest", period: None, theta_min: None, theta_max: None, theta_limit: None };
        match *recurrence {
            Recurrence::Rest => blank,
            Recurrence::Libration { period, theta_min, theta_max } => Self {
                recurrence: "libration",
                period: Some(period),
                theta_min: Some(theta_min),
                theta_max: Some(theta_max),
                ..blank
            },
            Recurrence::Rotation { period } => Self { recurrence: "rotation", period: Some(period), ..blank },
            Recurrence::Asymptotic { theta } => {
                Self { recurrence: "asymptotic", theta_limit: Some(theta), ..blank }
            }
        }
    }
}
