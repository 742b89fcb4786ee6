//! Instants of a motion, column by column.

use littlewood::{Hoop, Mode, Sample};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::record::sign;

/// Code of the mode where there is no instant: before the start or after the end.
const NO_MODE: i8 = -1;

/// The real columns, by the names that the command line gives them.
const REALS: [&str; 17] = [
    "time",
    "theta",
    "theta_rate",
    "slip",
    "x",
    "theta_acceleration",
    "slip_acceleration",
    "normal",
    "friction",
    "gap",
    "gap_rate",
    "energy",
    "centre_y",
    "mass_centre_x",
    "mass_centre_y",
    "particle_x",
    "particle_y",
];

/// Columns that grow by one instant after the other.
pub(crate) struct Samples {
    mode: Vec<i8>,
    direction: Vec<i8>,
    reals: [Vec<f64>; REALS.len()],
}

impl Samples {
    pub(crate) fn with_capacity(capacity: usize) -> Self {
        Self {
            mode: Vec::with_capacity(capacity),
            direction: Vec::with_capacity(capacity),
            reals: core::array::from_fn(|_| Vec::with_capacity(capacity)),
        }
    }

    pub(crate) fn push(&mut self, hoop: &Hoop, sample: &Sample) {
        self.mode.push(code(sample.mode));
        self.direction.push(sign(sample.direction));
        let (mass_centre, particle) = (sample.mass_centre(hoop), sample.particle(hoop));
        let values = [
            sample.state.time,
            sample.state.theta,
            sample.state.theta_rate,
            sample.state.slip,
            sample.state.x,
            sample.theta_acceleration,
            sample.slip_acceleration,
            sample.normal,
            sample.friction,
            sample.gap,
            sample.gap_rate,
            sample.energy,
            sample.centre().y,
            mass_centre.x,
            mass_centre.y,
            particle.x,
            particle.y,
        ];
        for (column, value) in self.reals.iter_mut().zip(values) {
            column.push(value);
        }
    }

    /// An instant outside the motion: the time that was asked for, and nothing else.
    pub(crate) fn push_nothing(&mut self, time: f64) {
        self.mode.push(NO_MODE);
        self.direction.push(0);
        for (i, column) in self.reals.iter_mut().enumerate() {
            column.push(if i == 0 { time } else { f64::NAN });
        }
    }

    /// Hands the columns over to Python; nothing is copied.
    pub(crate) fn into_dict(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let dict = PyDict::new(py);
        dict.set_item("mode", self.mode.into_pyarray(py))?;
        dict.set_item("direction", self.direction.into_pyarray(py))?;
        for (name, column) in REALS.into_iter().zip(self.reals) {
            dict.set_item(name, column.into_pyarray(py))?;
        }
        Ok(dict)
    }
}

/// Place of a mode in [`Mode::ALL`].
pub(crate) const fn code(mode: Mode) -> i8 {
    match mode {
        Mode::Rolling => 0,
        Mode::Sliding => 1,
        Mode::Gliding => 2,
        Mode::Flight => 3,
    }
}
