//! States and starts, dimensionless and in SI units.

use littlewood::{Direction, Mode, Start, State, Units};
use serde::Serialize;

use super::direction::sign;

/// A state.
#[derive(Debug, Serialize)]
pub(crate) struct StateRecord {
    time: f64,
    theta: f64,
    theta_rate: f64,
    slip: f64,
    x: f64,
}

impl From<State> for StateRecord {
    fn from(state: State) -> Self {
        let State { time, theta, theta_rate, slip, x } = state;
        Self { time, theta, theta_rate, slip, x }
    }
}

impl From<Start> for StateRecord {
    fn from(start: Start) -> Self {
        let Start { time, theta, theta_rate, slip, x } = start;
        Self { time, theta, theta_rate, slip, x }
    }
}

/// A state in SI units.
#[derive(Debug, Serialize)]
pub(crate) struct SiStateRecord {
    time_s: f64,
    theta_rad: f64,
    theta_rate_rad_per_s: f64,
    slip_m_per_s: f64,
    x_m: f64,
}

impl SiStateRecord {
    pub(crate) fn new(units: &Units, state: &State) -> Self {
        let si = units.state(state);
        Self {
            time_s: si.time_s,
            theta_rad: si.theta_rad,
            theta_rate_rad_per_s: si.theta_rate_rad_per_s,
            slip_m_per_s: si.slip_m_per_s,
            x_m: si.x_m,
        }
    }
}

/// A start with the motion that begins there.
#[derive(Debug, Serialize)]
pub(crate) struct StartRecord {
    #[serde(flatten)]
    state: StateRecord,
    mode: Option<&'static str>,
    direction: i8,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<SiStateRecord>,
}

impl StartRecord {
    pub(crate) fn new(
        start: &Start,
        mode: Option<Mode>,
        direction: Option<Direction>,
        units: Option<&Units>,
    ) -> Self {
        let Start { time, theta, theta_rate, slip, x } = *start;
        let state = State { time, theta, theta_rate, slip, x };
        Self {
            state: state.into(),
            mode: mode.map(Mode::name),
            direction: sign(direction),
            si: units.map(|units| SiStateRecord::new(units, &state)),
        }
    }
}
