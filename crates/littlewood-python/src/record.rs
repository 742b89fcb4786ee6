//! Numbers of a hoop, a start, a state and a setup in SI units, in the order of the tables of the core.

use littlewood::{Hoop, HoopParameters, Quantity, Setup, SiSetup, Start, State};
use pyo3::prelude::*;

use crate::error::refuse;

/// The values of [`Quantity::HOOP`].
pub(crate) type HoopNumbers = [f64; Quantity::HOOP.len()];

/// The values of [`Quantity::START`].
pub(crate) type StartNumbers = [f64; Quantity::START.len()];

/// The values of [`State::COLUMNS`].
pub(crate) type StateNumbers = [f64; State::COLUMNS.len()];

/// The values of [`Quantity::SI_HOOP`].
pub(crate) type SiHoopNumbers = [f64; Quantity::SI_HOOP.len()];

/// The values of [`Quantity::SI_START`].
pub(crate) type SiStartNumbers = [f64; Quantity::SI_START.len()];

/// A setup with these values; the quantities that are not among them are zero.
pub(crate) fn setup(values: impl IntoIterator<Item = (Quantity, f64)>) -> Setup {
    let mut setup = Setup::new(HoopParameters::default(), Start::default());
    for (quantity, value) in values {
        setup.set(quantity, value);
    }
    setup
}

pub(crate) fn parameters(numbers: HoopNumbers) -> HoopParameters {
    setup(Quantity::HOOP.into_iter().zip(numbers)).hoop
}

pub(crate) fn hoop(py: Python<'_>, numbers: HoopNumbers) -> PyResult<Hoop> {
    Hoop::new(parameters(numbers)).map_err(|error| refuse(py, &error, None))
}

pub(crate) fn start(numbers: StartNumbers) -> Start {
    setup(Quantity::START.into_iter().zip(numbers)).start
}

/// A setup in SI units; the quantities that are not among the values are zero.
pub(crate) fn si_setup(values: &[(Quantity, f64)]) -> SiSetup {
    SiSetup::from_values(|wanted| {
        values.iter().find(|(quantity, _)| *quantity == wanted).map_or(0.0, |(_, value)| *value)
    })
}
