//! Many starts in, columns out.

use littlewood::tables::{
    Class, DerivativeColumn, Group, PhaseSequence, Quantity, Setup, UnknownDerivative,
};
use littlewood::{OutcomeKind, RestitutionLaw, Summary};
use littlewood_sweep::{ColumnValues, Lattice, MIXED, Points, Refused, of_derivative};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::{refuse, too_large};
use crate::record::{CountLimits, LawName, law, limits, setup};
use crate::samples::with_room;
use crate::waiting;

/// Points of a call at most: with more their summaries outgrow memory.
pub(crate) const MOST_POINTS: usize = 100_000_000;

/// What a point is given by.
const AXES: [Quantity; Quantity::AXES.len()] = Quantity::AXES;

/// One quantity of all points: one value for all, or one for each.
struct Column(Vec<f64>);

impl Column {
    fn get(&self, i: usize) -> f64 {
        if self.0.len() == 1 {
            self.0[0]
        } else {
            self.0[i]
        }
    }
}

/// The points, by their [`AXES`]; none for a quantity that all of them lack.
struct Given {
    columns: [Option<Column>; AXES.len()],
    law: Option<RestitutionLaw>,
}

impl Given {
    fn setup(&self, i: usize) -> Setup {
        let values = self
            .columns
            .iter()
            .map(|column| column.as_ref().map(|column| column.get(i)));
        setup(AXES.into_iter().zip(values), self.law)
    }

    fn have_one_hoop(&self) -> bool {
        AXES.iter()
            .zip(&self.columns)
            .filter(|(axis, _)| axis.group() == Group::Hoop)
            .all(|(_, column)| column.as_ref().is_none_or(|column| column.0.len() == 1))
    }
}

/// Summaries of many motions.
///
/// `columns` are the axes of the table, each of one value or of `count` values, or none if no point
/// has it. `starts` is the number of starts of each hoop that are expected in all.
#[pyfunction]
#[expect(
    clippy::too_many_arguments,
    reason = "they are named where a person writes them, in the package"
)]
pub(crate) fn summaries<'py>(
    py: Python<'py>,
    columns: [Option<PyReadonlyArray1<'py, f64>>; AXES.len()],
    law_name: LawName,
    count: usize,
    until: Option<f64>,
    max_transitions: usize,
    max_slides: usize,
    proof: &str,
    starts: u64,
    threads: usize,
    progress: Option<Py<PyAny>>,
    derivatives: Vec<String>,
) -> PyResult<Bound<'py, PyDict>> {
    let columns = columns.map(|column| {
        column.map(|column| Column(column.as_array().iter().copied().collect::<Vec<_>>()))
    });
    if columns
        .iter()
        .flatten()
        .any(|column| column.0.len() != 1 && column.0.len() != count)
    {
        return Err(PyRuntimeError::new_err("columns of unequal length"));
    }
    if count > MOST_POINTS {
        let message = format!("{count} points at once: there can be {MOST_POINTS}");
        return Err(PyValueError::new_err(message));
    }
    // What is needed at once, at least: without it the process would end.
    with_room::<(usize, Summary)>(count).map_err(|error| too_large(&error))?;
    with_room::<f64>(count.saturating_mul(derivatives.len())).map_err(|error| too_large(&error))?;
    let given = Given {
        columns,
        law: law(py, &law_name)?,
    };
    let counts = CountLimits {
        transitions: max_transitions,
        slides: max_slides,
    };
    let limits = limits(py, until, counts, proof)?;
    let derivatives = derivatives
        .iter()
        .map(|name| derivative(name))
        .collect::<PyResult<Vec<_>>>()?;
    let points = Points {
        count,
        at: &|i| given.setup(i),
        share_hoop: given.have_one_hoop(),
        derivatives: &derivatives,
    };
    let columns = waiting::run(py, threads, progress.as_ref(), |workers, options| {
        workers.follow(points, Some(starts), limits, options)
    })?
    .map_err(|Refused { index, error }| refuse(py, &error, Some(index)))?;
    let dict = PyDict::new(py);
    for (column, values) in columns.into_columns() {
        let name = column.to_string();
        match values {
            ColumnValues::U8(values) => dict.set_item(name, values.into_pyarray(py))?,
            ColumnValues::U32(values) => dict.set_item(name, values.into_pyarray(py))?,
            ColumnValues::U64(values) => dict.set_item(name, values.into_pyarray(py))?,
            ColumnValues::F64(values) => dict.set_item(name, values.into_pyarray(py))?,
        }
    }
    Ok(dict)
}

fn derivative(name: &str) -> PyResult<DerivativeColumn> {
    name.parse()
        .map_err(|error: UnknownDerivative| PyValueError::new_err(error.to_string()))
}

/// A column of derivatives: the quantity by which, and its attributes.
#[derive(IntoPyObject)]
pub(crate) struct DerivativeDict {
    quantity: &'static str,
    long_name: String,
    unit: String,
    scale: String,
}

/// The quantity, and the long name, the unit and the scale of a derivative.
#[pyfunction]
pub(crate) fn derivative_column(name: &str) -> PyResult<DerivativeDict> {
    let column = derivative(name)?;
    let [long_name, unit, scale] = of_derivative(column);
    Ok(DerivativeDict {
        quantity: column.quantity.name(),
        long_name,
        unit,
        scale,
    })
}

/// The class of each motion, from the columns of its summary that decide it.
#[pyfunction]
pub(crate) fn classes<'py>(
    py: Python<'py>,
    outcome: PyReadonlyArray1<'py, u8>,
    sequence: PyReadonlyArray1<'py, u64>,
    lift_off_time: PyReadonlyArray1<'py, f64>,
) -> PyResult<Bound<'py, PyArray1<u8>>> {
    let (outcome, sequence, lift_off_time) = (
        outcome.as_array(),
        sequence.as_array(),
        lift_off_time.as_array(),
    );
    let mut codes = Vec::with_capacity(outcome.len());
    for ((&outcome, &sequence), &lift_off_time) in outcome.iter().zip(sequence).zip(lift_off_time) {
        let mut summary = Summary::NOT_COMPUTED;
        summary.outcome = OutcomeKind::try_from(outcome)
            .map_err(|error| PyValueError::new_err(error.to_string()))?;
        summary.sequence = PhaseSequence::from_bits(sequence);
        summary.lift_off_time = lift_off_time;
        codes.push(Class::of(&summary).code());
    }
    Ok(codes.into_pyarray(py))
}

/// Of each place of a map, row by row, whether keys around it change more finely than the map tells.
#[pyfunction]
pub(crate) fn mixed<'py>(
    py: Python<'py>,
    keys: PyReadonlyArray1<'py, u8>,
    columns: usize,
) -> Bound<'py, PyArray1<bool>> {
    let keys: Vec<u64> = keys.as_array().iter().map(|&key| key.into()).collect();
    let rows = keys.len() / columns.max(1);
    // A line of places has no neighbours above and below.
    if columns < 2 || rows < 2 {
        return vec![false; keys.len()].into_pyarray(py);
    }
    let mut lattice = Lattice {
        keys,
        ..Lattice::even(columns, rows, |_| 0)
    };
    lattice.mix();
    let mixed: Vec<bool> = lattice.keys.iter().map(|&key| key == MIXED).collect();
    mixed.into_pyarray(py)
}
