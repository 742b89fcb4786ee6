//! SI units: hoops and starts into the dimensionless system of (2.9), samples out of it.

use littlewood::si::{SiParameters, Units};
use littlewood::tables::{Dimension, Quantity, SampleColumn};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;

use crate::error::refuse;
use crate::record::{
    ByName, LawName, SiHoopNumbers, SiStartNumbers, hoop_by_name, law, si_setup, start_by_name,
};

/// m2, R and g in SI units, as the package has them, in this order.
#[derive(FromPyObject)]
pub(crate) struct Scales {
    #[pyo3(item(0))]
    mass_kg: f64,
    #[pyo3(item(1))]
    length_m: f64,
    #[pyo3(item(2))]
    gravity_m_per_s2: f64,
}

pub(crate) fn units(py: Python<'_>, scales: Scales) -> PyResult<Units> {
    SiParameters {
        particle_mass_kg: scales.mass_kg,
        radius_m: scales.length_m,
        gravity_m_per_s2: scales.gravity_m_per_s2,
        ..SiParameters::default()
    }
    .units()
    .map_err(|error| refuse(py, &error, None))
}

/// The units of (2.9) in SI, as a dictionary.
#[derive(IntoPyObject)]
pub(crate) struct UnitsDict {
    mass_kg: f64,
    length_m: f64,
    time_s: f64,
    gravity_m_per_s2: f64,
}

impl From<Units> for UnitsDict {
    fn from(units: Units) -> Self {
        Self {
            mass_kg: units.mass_kg,
            length_m: units.length_m,
            time_s: units.time_s,
            gravity_m_per_s2: units.gravity_m_per_s2,
        }
    }
}

/// A hoop that was given in SI units: the dimensionless one without its law, and its units.
#[derive(IntoPyObject)]
pub(crate) struct HoopFromSi {
    hoop: ByName<Option<f64>>,
    units: UnitsDict,
}

/// A start that was given in SI units, and a time limit if there is one, without dimension.
#[derive(IntoPyObject)]
pub(crate) struct StartFromSi {
    start: ByName<f64>,
    until: Option<f64>,
}

/// The SI values of √(g/R), √(gR), m2 g, m2 g R and m2 R².
#[derive(IntoPyObject)]
pub(crate) struct DerivedUnits {
    rate_rad_per_s: f64,
    velocity_m_per_s: f64,
    force_n: f64,
    energy_j: f64,
    inertia_kg_m2: f64,
}

#[pyfunction]
pub(crate) fn hoop_from_si(
    py: Python<'_>,
    numbers: SiHoopNumbers,
    law_name: LawName,
) -> PyResult<HoopFromSi> {
    let values: Vec<_> = Quantity::SI_HOOP.into_iter().zip(numbers).collect();
    let si = si_setup(&values, law(py, &law_name)?);
    let (hoop, units) = si
        .hoop
        .to_hoop()
        .map_err(|error| refuse(py, &error, None))?;
    Ok(HoopFromSi {
        hoop: hoop_by_name(hoop.parameters()),
        units: units.into(),
    })
}

#[pyfunction]
pub(crate) fn start_from_si(
    py: Python<'_>,
    scales: Scales,
    numbers: SiStartNumbers,
    until_s: Option<f64>,
) -> PyResult<StartFromSi> {
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
        Ok(StartFromSi {
            start: start_by_name(start),
            until,
        })
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

#[pyfunction]
pub(crate) fn derived_units(py: Python<'_>, scales: Scales) -> PyResult<DerivedUnits> {
    let units = units(py, scales)?;
    Ok(DerivedUnits {
        rate_rad_per_s: units.unit(Dimension::AngularRate),
        velocity_m_per_s: units.unit(Dimension::Velocity),
        force_n: units.unit(Dimension::Force),
        energy_j: units.unit(Dimension::Energy),
        inertia_kg_m2: units.unit(Dimension::Inertia),
    })
}
