//! Derivatives of a motion, column by column.

use littlewood::derivatives::{NoDerivative, NotDifferentiable, differentiable};
use littlewood::modes::Recurrence;
use littlewood::tables::{Detail, Quantity, SampleColumn};
use littlewood::{State, Trajectory};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::{not_differentiable, unknown_quantity};
use crate::record::ByName;

/// The reason outside a motion.
const OUTSIDE: &str = "outside";

/// Derivatives row after row: the columns of the state, of instants that of the gap, too, and the
/// name of the reason for each row. A row without derivatives is NaN; a row that has them has an
/// empty reason.
#[derive(IntoPyObject)]
pub(crate) struct Rows<'py> {
    columns: ByName<Bound<'py, PyArray1<f64>>>,
    reasons: Vec<&'static str>,
}

struct Collected {
    columns: Vec<(SampleColumn, Vec<f64>)>,
    reasons: Vec<&'static str>,
}

impl Collected {
    /// No rows yet, of the columns of the state and these.
    fn with(others: &[SampleColumn]) -> Self {
        let columns = State::COLUMNS.iter().chain(others);
        Self {
            columns: columns.map(|column| (*column, Vec::new())).collect(),
            reasons: Vec::new(),
        }
    }

    /// A row: the derivatives of the columns, or why they do not exist.
    fn push<const N: usize>(&mut self, derivatives: Result<[f64; N], &'static str>) {
        for (place, (_, values)) in self.columns.iter_mut().enumerate() {
            let number = derivatives
                .ok()
                .and_then(|numbers| numbers.get(place).copied());
            values.push(number.unwrap_or(f64::NAN));
        }
        self.reasons.push(derivatives.err().unwrap_or_default());
    }

    fn into_rows(self, py: Python<'_>) -> Rows<'_> {
        let columns = self.columns.into_iter();
        Rows {
            columns: columns
                .map(|(column, values)| (column.name(), values.into_pyarray(py)))
                .collect(),
            reasons: self.reasons,
        }
    }
}

/// The quantities of these names, or all that the motion has.
fn quantities(
    py: Python<'_>,
    motion: &Trajectory,
    names: Option<Vec<String>>,
) -> PyResult<Vec<Quantity>> {
    let Some(names) = names else {
        let bounces = motion.hoop().restitution().is_some();
        return Ok(differentiable(bounces).collect());
    };
    let known = || Quantity::HOOP.into_iter().chain(Quantity::START);
    let find = |name: &String| known().find(|quantity| quantity.name() == name);
    names
        .iter()
        .map(|name| find(name).ok_or_else(|| unknown_quantity(py, name, known())))
        .collect()
}

/// The names of the quantities, the rows of all transitions, those of the outcome, and by their
/// names the numbers of its recurrence.
#[derive(IntoPyObject)]
pub(crate) struct OfMotion<'py> {
    quantities: Vec<&'static str>,
    transitions: Rows<'py>,
    outcome: Rows<'py>,
    recurrence: Bound<'py, PyDict>,
}

/// The names of the quantities, and the rows of all times.
#[derive(IntoPyObject)]
pub(crate) struct AtTimes<'py> {
    quantities: Vec<&'static str>,
    rows: Rows<'py>,
}

/// All derivatives of a motion with respect to these quantities, or to all that it has.
pub(crate) fn all<'py>(
    py: Python<'py>,
    motion: &Trajectory,
    names: Option<Vec<String>>,
) -> PyResult<OfMotion<'py>> {
    let quantities = quantities(py, motion, names)?;
    let found = py
        .detach(|| motion.derivatives(&quantities))
        .map_err(|error| not_differentiable(py, error))?;
    let (mut transitions, mut outcome) = (Collected::with(&[]), Collected::with(&[]));
    for derivative in found.transitions().iter().flatten() {
        let numbers = derivative.map(|event| event.after.numbers());
        transitions.push(numbers.map_err(NoDerivative::name));
    }
    let numbers = PyDict::new(py);
    for (place, derivative) in found.outcome().iter().enumerate() {
        let state = derivative.map(|end| end.state.numbers());
        outcome.push(state.map_err(NoDerivative::name));
        let recurrence = derivative.ok().and_then(|end| end.recurrence);
        for (name, detail) in recurrence.iter().flat_map(Recurrence::details) {
            let Detail::Real(value, _) = detail else {
                continue;
            };
            if !numbers.contains(name)? {
                numbers.set_item(name, vec![f64::NAN; quantities.len()])?;
            }
            if let Some(values) = numbers.get_item(name)? {
                values.set_item(place, value)?;
            }
        }
    }
    Ok(OfMotion {
        quantities: quantities.into_iter().map(Quantity::name).collect(),
        transitions: transitions.into_rows(py),
        outcome: outcome.into_rows(py),
        recurrence: numbers,
    })
}

/// The derivatives of the state and the gap at fixed times, time after time.
pub(crate) fn at<'py>(
    py: Python<'py>,
    motion: &Trajectory,
    times: &[f64],
    names: Option<Vec<String>>,
) -> PyResult<AtTimes<'py>> {
    let quantities = quantities(py, motion, names)?;
    let found = py.detach(|| -> Result<Collected, NotDifferentiable> {
        let mut rows = Collected::with(&[SampleColumn::Gap]);
        for each in motion.derivatives_at(times, &quantities)? {
            let Some(each) = each else {
                for _ in &quantities {
                    rows.push::<0>(Err(OUTSIDE));
                }
                continue;
            };
            for derivative in each {
                let numbers = derivative.map(|instant| {
                    let [time, theta, theta_rate, slip, x] = instant.state.numbers();
                    [time, theta, theta_rate, slip, x, instant.gap]
                });
                rows.push(numbers.map_err(NoDerivative::name));
            }
        }
        Ok(rows)
    });
    let rows = found.map_err(|error| not_differentiable(py, error))?;
    Ok(AtTimes {
        quantities: quantities.into_iter().map(Quantity::name).collect(),
        rows: rows.into_rows(py),
    })
}
