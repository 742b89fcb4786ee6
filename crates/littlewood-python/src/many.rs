//! Many starts in, columns out.

use std::collections::HashMap;

use littlewood::{
    Bound as Limit, Engine, Hoop, HoopParameters, Limits, ParameterError, Quantity, Start, Summary,
};
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;

use crate::error::refuse;
use crate::waiting::{self, Cancelled, Signals};

/// Outcome of a hoop whose parameters contradict each other, such as μk > μs, as the stores of the command line have it.
const INVALID: u8 = 255;

/// Starts of a task: short enough to share the work evenly, long enough to pay for the task.
const TASK: usize = 256;

/// One of the eight quantities of a point: one value for all points, or one for each.
struct Column(Vec<f64>);

impl Column {
    fn get(&self, i: usize) -> f64 {
        if self.0.len() == 1 { self.0[0] } else { self.0[i] }
    }
}

/// The points: mass_ratio, offset, inertia, mu_s, mu_k; theta, theta_rate, slip.
struct Points {
    columns: [Column; 8],
    count: usize,
}

impl Points {
    fn hoop(&self, i: usize) -> HoopParameters {
        let [mass_ratio, offset, inertia, mu_s, mu_k] = core::array::from_fn(|k| self.columns[k].get(i));
        HoopParameters { mass_ratio, offset, inertia, mu_s, mu_k }
    }

    fn start(&self, i: usize) -> Start {
        let [theta, theta_rate, slip] = core::array::from_fn(|k| self.columns[5 + k].get(i));
        Start::at(theta, theta_rate).with_slip(slip)
    }

    /// The places of the points of each hoop, hoops in the order in which they first occur.
    fn groups(&self, signals: &Signals) -> Result<Vec<Vec<usize>>, Cancelled> {
        if self.count > 0 && self.columns[..5].iter().all(|column| column.0.len() == 1) {
            return Ok(vec![(0..self.count).collect()]);
        }
        let mut groups: Vec<Vec<usize>> = Vec::new();
        let mut places: HashMap<[u64; 5], usize> = HashMap::new();
        for i in 0..self.count {
            signals.check()?;
            let bits = core::array::from_fn(|k| self.columns[k].get(i).to_bits());
            let place = *places.entry(bits).or_insert_with(|| {
                groups.push(Vec::new());
                groups.len() - 1
            });
            groups[place].push(i);
        }
        Ok(groups)
    }
}

/// A point that was refused, by its place.
struct Refused(usize, ParameterError);

/// A summary, or nothing for an invalid hoop, with its place.
type Row = (usize, Option<Summary>);

/// Rows, unless a point among them was refused; nothing if the work was cancelled.
type Rows<T> = Result<Result<Vec<T>, Refused>, Cancelled>;

fn rows_of_hoop(
    points: &Points,
    indices: &[usize],
    limits: Limits,
    prepare: bool,
    signals: &Signals,
) -> Rows<Vec<Row>> {
    signals.check()?;
    let first = indices[0];
    let hoop = match Hoop::new(points.hoop(first)) {
        Ok(hoop) => Some(hoop),
        Err(error) if is_relation(&error) => None,
        Err(error) => return Ok(Err(Refused(first, error))),
    };
    let engine = hoop.map(|hoop| if prepare { Engine::new(&hoop) } else { Engine::unprepared(&hoop) });
    let rows_of_task = |task: &[usize]| {
        let mut rows = Vec::with_capacity(task.len());
        for &i in task {
            signals.check()?;
            match engine.as_ref().map(|engine| engine.summary(points.start(i), limits)).transpose() {
                Ok(summary) => rows.push((i, summary)),
                Err(error) => return Ok(Err(Refused(i, error))),
            }
        }
        signals.add(task.len());
        Ok(Ok(rows))
    };
    let tasks = indices.par_chunks(TASK).map(rows_of_task).collect::<Result<Vec<_>, Cancelled>>()?;
    Ok(gather(tasks))
}

/// Whether two values contradict each other that have a meaning each by itself.
const fn is_relation(error: &ParameterError) -> bool {
    matches!(
        error,
        ParameterError::NoMotion { .. }
            | ParameterError::OutOfBounds { quantity: Quantity::MuK, bound: Limit::AtMost(..), .. }
    )
}

/// All results, or of several refusals that of the first point, whichever thread met it first.
fn gather<T>(results: Vec<Result<T, Refused>>) -> Result<Vec<T>, Refused> {
    let mut all = Vec::with_capacity(results.len());
    let mut first: Option<Refused> = None;
    for result in results {
        match (result, &first) {
            (Ok(one), None) => all.push(one),
            (Ok(_), Some(_)) => {}
            (Err(Refused(i, _)), Some(Refused(earlier, _))) if *earlier <= i => {}
            (Err(refused), _) => first = Some(refused),
        }
    }
    first.map_or(Ok(all), Err)
}

/// One NaN for all: the sign and payload of a NaN that arithmetic makes are not specified.
const fn quiet(value: f64) -> f64 {
    if value.is_nan() { f64::NAN } else { value }
}

/// The columns of the result, by the names that the stores of the command line have.
struct Columns {
    outcome: Vec<u8>,
    sequence: Vec<u64>,
    transitions: Vec<u32>,
    painleve: Vec<u8>,
    reals: [(&'static str, Vec<f64>); 10],
}

impl Columns {
    fn new(count: usize) -> Self {
        let names = [
            "end_time",
            "end_theta",
            "end_theta_rate",
            "end_slip",
            "end_x",
            "energy",
            "first_slip_time",
            "lift_off_time",
            "jump_length",
            "jump_height",
        ];
        Self {
            outcome: vec![INVALID; count],
            sequence: vec![0; count],
            transitions: vec![0; count],
            painleve: vec![0; count],
            reals: names.map(|name| (name, vec![f64::NAN; count])),
        }
    }

    fn set(&mut self, i: usize, summary: &Summary) {
        self.outcome[i] = summary.outcome as u8;
        self.sequence[i] = summary.sequence.bits();
        self.transitions[i] = summary.transitions;
        self.painleve[i] = u8::from(summary.painleve);
        let values = [
            summary.end.time,
            summary.end.theta,
            summary.end.theta_rate,
            summary.end.slip,
            summary.end.x,
            summary.energy,
            summary.first_slip_time,
            summary.lift_off_time,
            summary.jump_length,
            summary.jump_height,
        ];
        for ((_, column), value) in self.reals.iter_mut().zip(values) {
            column[i] = quiet(value);
        }
    }

    fn into_dict(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let dict = PyDict::new(py);
        dict.set_item("outcome", self.outcome.into_pyarray(py))?;
        dict.set_item("sequence", self.sequence.into_pyarray(py))?;
        dict.set_item("transitions", self.transitions.into_pyarray(py))?;
        dict.set_item("painleve", self.painleve.into_pyarray(py))?;
        for (name, column) in self.reals {
            dict.set_item(name, column.into_pyarray(py))?;
        }
        Ok(dict)
    }
}

fn compute(
    points: &Points,
    limits: Limits,
    prepare: bool,
    signals: &Signals,
) -> Result<Result<Columns, Refused>, Cancelled> {
    let results = points
        .groups(signals)?
        .par_iter()
        .map(|indices| rows_of_hoop(points, indices, limits, prepare, signals))
        .collect::<Result<Vec<_>, Cancelled>>()?;
    Ok(gather(results).map(|rows| {
        let mut columns = Columns::new(points.count);
        for (i, summary) in rows.into_iter().flatten().flatten() {
            if let Some(summary) = summary {
                columns.set(i, &summary);
            }
        }
        columns
    }))
}

/// Summaries of many motions.
///
/// `columns` are mass_ratio, offset, inertia, mu_s, mu_k, theta, theta_rate and slip, each of one value or of
/// `count` values. `prepare` makes tables of each hoop first, which pays from `REPAYS` starts of it.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "they are named where a person writes them, in the package")]
fn summaries<'py>(
    py: Python<'py>,
    columns: [PyReadonlyArray1<'py, f64>; 8],
    count: usize,
    until: Option<f64>,
    max_transitions: usize,
    prepare: bool,
    threads: usize,
    progress: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let columns = columns.map(|column| Column(column.as_array().iter().copied().collect()));
    if columns.iter().any(|column| column.0.len() != 1 && column.0.len() != count) {
        return Err(PyRuntimeError::new_err("columns of unequal length"));
    }
    let points = Points { columns, count };
    let limits = Limits { until, transitions: max_transitions };
    let result =
        waiting::run(py, threads, progress.as_ref(), |signals| compute(&points, limits, prepare, signals))?;
    match result {
        Ok(columns) => columns.into_dict(py),
        Err(Refused(i, error)) => Err(refuse(py, &error, Some(i))),
    }
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("INVALID", INVALID)?;
    module.add("REPAYS", Engine::REPAYS)?;
    module.add_function(wrap_pyfunction!(summaries, module)?)
}
