//! Phases of motion.

use littlewood::Phase;
use littlewood::si::Units;
use littlewood::tables::{Detail, Dimension};
use serde::Serialize;

use super::fields::{Fields, Value};

#[derive(Debug, Serialize)]
pub(crate) struct PhaseRecord {
    #[serde(flatten)]
    fields: Fields,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<Fields>,
}

impl PhaseRecord {
    /// The duration of a phase that lasts for ever is `null` in JSON.
    pub(crate) fn new(phase: &Phase, units: Option<&Units>) -> Self {
        let details = [
            (
                "start_time",
                Detail::Real(phase.start().time, Dimension::Time),
            ),
            ("duration", Detail::Real(phase.duration(), Dimension::Time)),
            (
                "energy_start",
                Detail::Real(phase.first().energy, Dimension::Energy),
            ),
            (
                "energy_lost",
                Detail::Real(phase.energy_lost(), Dimension::Energy),
            ),
        ];
        let motion = [
            ("mode", Some(phase.mode()).into()),
            ("direction", phase.direction().into()),
        ];
        let mark = [(
            "small_inertia_limit",
            Value::Flag(!phase.is_outside_small_inertia_limit()),
        )];
        Self {
            fields: Fields::from_iter(motion)
                .followed_by(Fields::of_details(details))
                .followed_by(mark.into_iter().collect()),
            si: units.map(|units| Fields::of_si_details(units, details)),
        }
    }
}
