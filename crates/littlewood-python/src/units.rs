//! SI units: hoops and starts into the dimensionless system of (2.9), samples out of it.

use littlewood::si::{SiParameters, Units};
use littlewood::tables::{Dimension, Quantity, SampleColumn};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::error::refuse;
use crate::record::{
    HoopNumbers, LawName, SiHoopNumbers, SiStartNumbers, StartNumbers, given, law, si_setup,
    start_numbers,
};

/// m2, R and g in SI units.
pub(crate) type Scales = (f64, f64, f64);

pub(crate) fn units(py: Python<'_>, (mass_kg, length_m, gravity): Scales) -> PyResult<Units> {
    SiParameters {
        particle_mass_kg: mass_kg,
        radius_m: length_m,
        gravity_m_per_s2: gravity,
        ..SiParameters::default()
    }
    .units()
    .map_err(|error| refuse(py, &error, None))
}

/// A hoop in SI units: the dimensionless one, and m2, R, √(R/g), g.
#[pyfunction]
pub(crate) fn hoop_from_si(
    py: Python<'_>,
    numbers: SiHoopNumbers,
    law_name: LawName,
) -> PyResult<(HoopNumbers, (f64, f64, f64, f64))> {
    let values: Vec<_> = Quantity::SI_HOOP.into_iter().zip(numbers).collect();
    let si = si_setup(&values, law(py, &law_name)?);
    let (hoop, units) = si
        .hoop
        .to_hoop()
        .map_err(|error| refuse(py, &error, None))?;
    let (numbers, _) = given(hoop.parameters());
    Ok((
        numbers,
        (
            units.mass_kg,
            units.length_m,
            units.time_s,
            units.gravity_m_per_s2,
        ),
    ))
}

/// A start, and a time limit if there is one, from SI units.
#[pyfunction]
pub(crate) fn start_from_si(
    py: Python<'_>,
    scales: Scales,
    numbers: SiStartNumbers,
    until_s: Option<f64>,
) -> PyResult<(StartNumbers, Option<f64>)> {
    let units = units(py, scales)?;
    let values: Vec<_> = Quantity::SI_START
        .into_iter()
        .zip(numbers.map(Some))
        .collect();
    let si = si_setup(&values, None);
    let convert = || {
        let start = units.start(&si.start)?;
        let until = until_s
            .map(|until_s| units.until(until_s, &start))
            .transpose()?;
        Ok((start_numbers(start), until))
    };
    convert().map_err(|error| refuse(py, &error, None))
}

/// Values of a column of the samples in SI units. A column of codes has none.
#[pyfunction]
pub(crate) fn sample_in_si<'py>(
    py: Python<'py>,
    scales: Scales,
    column: &str,
    values: PyReadonlyArray1<'py, f64>,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let column: SampleColumn = column
        .parse()
        .map_err(|error| PyValueError::new_err(format!("{error}")))?;
    let Some(dimension) = column.dimension() else {
        return Err(PyValueError::new_err(format!(
            "{column} is a code, which has no unit"
        )));
    };
    let units = units(py, scales)?;
    let values: Vec<f64> = values
        .as_array()
        .iter()
        .map(|&value| units.to_si(dimension, value))
        .collect();
    Ok(values.into_pyarray(py))
}

/// The SI values of √(g/R), √(gR), m2 g, m2 g R and m2 R².
#[pyfunction]
pub(crate) fn derived_units(py: Python<'_>, scales: Scales) -> PyResult<(f64, f64, f64, f64, f64)> {
    let units = units(py, scales)?;
    Ok((
        units.unit(Dimension::AngularRate),
        units.unit(Dimension::Velocity),
        units.unit(Dimension::Force),
        units.unit(Dimension::Energy),
        units.unit(Dimension::Inertia),
    ))
}
