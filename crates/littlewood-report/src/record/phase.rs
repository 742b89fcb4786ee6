//! Phases of motion.

use littlewood::{Phase, Units};
use serde::Serialize;

use super::direction::sign;

/// A phase of motion.
#[derive(Debug, Serialize)]
pub(crate) struct PhaseRecord {
    mode: &'static str,
    direction: i8,
    start_time: f64,
    /// `null` for ever.
    duration: f64,
    energy_start: f64,
    energy_lost: f64,
    small_inertia_limit: bool,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<SiPhaseRecord>,
}

#[derive(Debug, Serialize)]
struct SiPhaseRecord {
    start_time_s: f64,
    duration_s: f64,
    energy_start_j: f64,
    energy_lost_j: f64,
}

impl PhaseRecord {
    pub(crate) fn new(phase: &Phase, units: Option<&Units>) -> Self {
        let start_time = phase.start().time;
        let duration = phase.duration();
        let energy_start = phase.first().energy;
        let energy_lost = phase.energy_lost();
        Self {
            mode: phase.mode().name(),
            direction: sign(phase.direction()),
            start_time,
            duration,
            energy_start,
            energy_lost,
            small_inertia_limit: !phase.is_outside_small_inertia_limit(),
            si: units.map(|units| SiPhaseRecord {
                start_time_s: start_time * units.time_s,
                duration_s: duration * units.time_s,
                energy_start_j: energy_start * units.energy_j(),
                energy_lost_j: energy_lost * units.energy_j(),
            }),
        }
    }
}
