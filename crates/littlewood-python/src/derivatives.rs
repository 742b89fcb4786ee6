//! Derivatives of a motion, as flat arrays.

use littlewood::derivatives::{Derivative, NoDerivative, NotDifferentiable};
use littlewood::modes::Recurrence;
use littlewood::tables::{Detail, Quantity};
use littlewood::{State, Trajectory};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::{not_differentiable, unknown_quantity};

/// The reason outside a motion.
const OUTSIDE: &str = "outside";

/// The derivatives of states, one row for each state with its numbers in the order of
/// [`State::COLUMNS`], and the name of the reason for each row. A row without derivatives is NaN; a
/// row that has them has an empty reason.
#[derive(IntoPyObject)]
pub(crate) struct Rows<'py> {
    values: Bound<'py, PyArray1<f64>>,
    reasons: Vec<&'static str>,
}

#[derive(Default)]
struct Collected {
    values: Vec<f64>,
    reasons: Vec<&'static str>,
}

impl Collected {
    fn push(&mut self, derivative: Result<State, &'static str>) {
        match derivative {
            Ok(state) => self.values.extend(state.numbers()),
            Err(_) => self.values.extend([f64::NAN; State::COLUMNS.len()]),
        }
        self.reasons.push(derivative.err().unwrap_or_default());
    }

    fn into_rows(self, py: Python<'_>) -> Rows<'_> {
        Rows {
            values: self.values.into_pyarray(py),
            reasons: self.reasons,
        }
    }
}

fn named<T: Copy>(
    derivative: &Derivative<T>,
    state: impl Fn(T) -> State,
) -> Result<State, &'static str> {
    derivative.map(state).map_err(NoDerivative::name)
}

/// The quantities of these names, or all that the motion has.
fn quantities(
    py: Python<'_>,
    motion: &Trajectory,
    names: Option<Vec<String>>,
) -> PyResult<Vec<Quantity>> {
    let known = || Quantity::HOOP.into_iter().chain(Quantity::START);
    let Some(names) = names else {
        let bounces = motion.hoop().restitution().is_some();
        return Ok(known()
            .filter(|quantity| bounces || *quantity != Quantity::Restitution)
            .collect());
    };
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
    let (mut transitions, mut outcome) = (Collected::default(), Collected::default());
    for derivative in found.transitions().iter().flatten() {
        transitions.push(named(derivative, |event| event.after));
    }
    let numbers = PyDict::new(py);
    for (place, derivative) in found.outcome().iter().enumerate() {
        outcome.push(named(derivative, |end| end.state));
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

/// The derivatives of the state at fixed times, time after time.
pub(crate) fn at<'py>(
    py: Python<'py>,
    motion: &Trajectory,
    times: &[f64],
    names: Option<Vec<String>>,
) -> PyResult<AtTimes<'py>> {
    let quantities = quantities(py, motion, names)?;
    let found = py.detach(|| -> Result<Collected, NotDifferentiable> {
        let mut rows = Collected::default();
        for each in motion.derivatives_at(times, &quantities)? {
            match each {
                Some(each) => each
                    .iter()
                    .for_each(|derivative| rows.push(named(derivative, |state| state))),
                None => quantities.iter().for_each(|_| rows.push(Err(OUTSIDE))),
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
