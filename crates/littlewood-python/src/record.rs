//! Numbers of a hoop, a start and a state as Python has them.

use littlewood::{Direction, Hoop, HoopParameters, Start, State};
use pyo3::prelude::*;

use crate::error::refuse;

/// mass_ratio, offset, inertia, mu_s, mu_k.
pub(crate) type HoopNumbers = (f64, f64, f64, f64, f64);

/// time, theta, theta_rate, slip, x.
pub(crate) type StateNumbers = (f64, f64, f64, f64, f64);

pub(crate) const fn parameters(numbers: HoopNumbers) -> HoopParameters {
    let (mass_ratio, offset, inertia, mu_s, mu_k) = numbers;
    HoopParameters { mass_ratio, offset, inertia, mu_s, mu_k }
}

pub(crate) const fn hoop_numbers(hoop: &HoopParameters) -> HoopNumbers {
    let HoopParameters { mass_ratio, offset, inertia, mu_s, mu_k } = *hoop;
    (mass_ratio, offset, inertia, mu_s, mu_k)
}

pub(crate) fn hoop(py: Python<'_>, numbers: HoopNumbers) -> PyResult<Hoop> {
    Hoop::new(parameters(numbers)).map_err(|error| refuse(py, &error, None))
}

pub(crate) const fn start(numbers: StateNumbers) -> Start {
    let (time, theta, theta_rate, slip, x) = numbers;
    Start { time, theta, theta_rate, slip, x }
}

pub(crate) const fn start_numbers(start: &Start) -> StateNumbers {
    let Start { time, theta, theta_rate, slip, x } = *start;
    (time, theta, theta_rate, slip, x)
}

pub(crate) const fn state_numbers(state: &State) -> StateNumbers {
    let State { time, theta, theta_rate, slip, x } = *state;
    (time, theta, theta_rate, slip, x)
}

/// σ as a number; 0 where there is no slip.
pub(crate) const fn sign(direction: Option<Direction>) -> i8 {
    match direction {
        Some(Direction::Negative) => -1,
        Some(Direction::Positive) => 1,
        None => 0,
    }
}
