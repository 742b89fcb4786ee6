//! Many starts in, columns out.

use std::collections::HashMap;

use littlewood::tables::{Class, Group, PhaseSequence, Quantity, Setup, SummaryColumn, SummaryValue};
use littlewood::{Engine, Hoop, Limits, OutcomeKind, ParameterError, RestitutionLaw, Summary};
use littlewood_sweep::MOST_THREADS;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;

use crate::error::{refuse, too_large};
use crate::record::{LawName, law, limits, setup};
use crate::samples::with_room;
use crate::waiting::{self, Cancelled, Signals};

/// Points of a call at most: with more their summaries outgrow memory.
const MOST_POINTS: usize = 100_000_000;

/// Starts of a task: short enough to share the work evenly, long enough to pay for the task.
const TASK: usize = 256;

/// What a point is given by.
const AXES: [Quantity; Quantity::AXES.len()] = Quantity::AXES;

/// One quantity of all points: one value for all, or one for each.
struct Column(Vec<f64>);

impl Column {
    fn get(&self, i: usize) -> f64 {
        if self.0.len() == 1 { self.0[0] } else { self.0[i] }
    }
}

/// The points, by their [`AXES`]; none for a quantity that all of them lack.
struct Points {
    columns: [Option<Column>; AXES.len()],
    law: Option<RestitutionLaw>,
    count: usize,
}

impl Points {
    fn setup(&self, i: usize) -> Setup {
        let values = self.columns.iter().map(|column| column.as_ref().map(|column| column.get(i)));
        setup(AXES.into_iter().zip(values), self.law)
    }

    fn have_one_hoop(&self) -> bool {
        AXES.iter()
            .zip(&self.columns)
            .filter(|(axis, _)| axis.group() == Group::Hoop)
            .all(|(_, column)| column.as_ref().is_none_or(|column| column.0.len() == 1))
    }

    /// The places of the points of each hoop, hoops in the order in which they first occur.
    fn groups(&self, signals: &Signals) -> Result<Vec<Vec<usize>>, Cancelled> {
        if self.count > 0 && self.have_one_hoop() {
            return Ok(vec![(0..self.count).collect()]);
        }
        let mut groups: Vec<Vec<usize>> = Vec::new();
        let mut places: HashMap<[Option<u64>; Quantity::HOOP.len()], usize> = HashMap::new();
        for i in 0..self.count {
            signals.check()?;
            let setup = self.setup(i);
            let bits = Quantity::HOOP.map(|quantity| setup.get(quantity).map(f64::to_bits));
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

/// A summary with its place.
type Row = (usize, Summary);

/// Rows, unless a point among them was refused; nothing if the work was cancelled.
type Rows<T> = Result<Result<Vec<T>, Refused>, Cancelled>;

fn rows_of_hoop(
    points: &Points,
    indices: &[usize],
    limits: Limits,
    starts: u64,
    signals: &Signals,
) -> Rows<Vec<Row>> {
    signals.check()?;
    let first = indices[0];
    let hoop = match Hoop::new(points.setup(first).hoop) {
        Ok(hoop) => Some(hoop),
        Err(error) if error.is_contradiction() => None,
        Err(error) => return Ok(Err(Refused(first, error))),
    };
    let engine = hoop.map(|hoop| Engine::builder(&hoop).expected_starts(starts).build());
    let rows_of_task = |task: &[usize]| {
        let mut rows = Vec::with_capacity(task.len());
        for &i in task {
            signals.check()?;
            let summary = match &engine {
                Some(engine) => engine.summary(points.setup(i).start, limits),
                None => Ok(Summary::INVALID),
            };
            match summary {
                Ok(summary) => rows.push((i, summary)),
                Err(error) if error.is_contradiction() => rows.push((i, Summary::INVALID)),
                Err(error) => return Ok(Err(Refused(i, error))),
            }
        }
        signals.add(task.len());
        Ok(Ok(rows))
    };
    let tasks = indices.par_chunks(TASK).map(rows_of_task).collect::<Result<Vec<_>, Cancelled>>()?;
    Ok(gather(tasks))
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

/// The values of a column of the result.
enum Values {
    U8(Vec<u8>),
    U32(Vec<u32>),
    U64(Vec<u64>),
    F64(Vec<f64>),
}

impl Values {
    fn new(value: SummaryValue, count: usize) -> Self {
        match value {
            SummaryValue::U8(value) => Self::U8(vec![value; count]),
            SummaryValue::U32(value) => Self::U32(vec![value; count]),
            SummaryValue::U64(value) => Self::U64(vec![value; count]),
            SummaryValue::F64(value) => Self::F64(vec![value; count]),
        }
    }

    /// A column has values of one type: one of another is not taken.
    fn set(&mut self, i: usize, value: SummaryValue) {
        match (self, value) {
            (Self::U8(values), SummaryValue::U8(value)) => values[i] = value,
            (Self::U32(values), SummaryValue::U32(value)) => values[i] = value,
            (Self::U64(values), SummaryValue::U64(value)) => values[i] = value,
            (Self::F64(values), SummaryValue::F64(value)) => values[i] = value,
            (Self::U8(_) | Self::U32(_) | Self::U64(_) | Self::F64(_), _) => {}
        }
    }

    fn put(self, dict: &Bound<'_, PyDict>, name: &str) -> PyResult<()> {
        let py = dict.py();
        match self {
            Self::U8(values) => dict.set_item(name, values.into_pyarray(py)),
            Self::U32(values) => dict.set_item(name, values.into_pyarray(py)),
            Self::U64(values) => dict.set_item(name, values.into_pyarray(py)),
            Self::F64(values) => dict.set_item(name, values.into_pyarray(py)),
        }
    }
}

/// The columns of the result, in the order of the table.
type Columns = Vec<(SummaryColumn, Values)>;

fn compute(
    points: &Points,
    limits: Limits,
    starts: u64,
    signals: &Signals,
) -> Result<Result<Columns, Refused>, Cancelled> {
    let results = points
        .groups(signals)?
        .par_iter()
        .map(|indices| rows_of_hoop(points, indices, limits, starts, signals))
        .collect::<Result<Vec<_>, Cancelled>>()?;
    Ok(gather(results).map(|hoops| {
        let spread = |column: SummaryColumn| {
            let mut values = Values::new(column.of(&Summary::NOT_COMPUTED), points.count);
            for (i, summary) in hoops.iter().flatten().flatten() {
                values.set(*i, column.of(summary));
            }
            (column, values)
        };
        SummaryColumn::ALL.into_par_iter().map(spread).collect()
    }))
}

/// Summaries of many motions.
///
/// `columns` are the axes of the table, each of one value or of `count` values, or none if no point has it. `starts`
/// is the number of starts of each hoop that are expected in all.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "they are named where a person writes them, in the package")]
fn summaries<'py>(
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
) -> PyResult<Bound<'py, PyDict>> {
    let columns = columns
        .map(|column| column.map(|column| Column(column.as_array().iter().copied().collect::<Vec<_>>())));
    if columns.iter().flatten().any(|column| column.0.len() != 1 && column.0.len() != count) {
        return Err(PyRuntimeError::new_err("columns of unequal length"));
    }
    if count > MOST_POINTS {
        let message = format!("{count} points at once: there can be {MOST_POINTS}");
        return Err(PyValueError::new_err(message));
    }
    // What is needed at once, at least: without it the process would end.
    with_room::<Row>(count).map_err(|error| too_large(&error))?;
    let points = Points { columns, law: law(py, &law_name)?, count };
    let limits = limits(py, until, (max_transitions, max_slides), proof)?;
    let result =
        waiting::run(py, threads, progress.as_ref(), |signals| compute(&points, limits, starts, signals))?;
    match result {
        Ok(columns) => {
            let dict = PyDict::new(py);
            for (column, values) in columns {
                values.put(&dict, column.name())?;
            }
            Ok(dict)
        }
        Err(Refused(i, error)) => Err(refuse(py, &error, Some(i))),
    }
}

/// The class of each motion, from the columns of its summary that decide it.
#[pyfunction]
fn classes<'py>(
    py: Python<'py>,
    outcome: PyReadonlyArray1<'py, u8>,
    sequence: PyReadonlyArray1<'py, u64>,
    lift_off_time: PyReadonlyArray1<'py, f64>,
) -> PyResult<Bound<'py, PyArray1<u8>>> {
    let (outcome, sequence, lift_off_time) =
        (outcome.as_array(), sequence.as_array(), lift_off_time.as_array());
    let mut codes = Vec::with_capacity(outcome.len());
    for ((&outcome, &sequence), &lift_off_time) in outcome.iter().zip(sequence).zip(lift_off_time) {
        let mut summary = Summary::NOT_COMPUTED;
        summary.outcome =
            OutcomeKind::try_from(outcome).map_err(|error| PyValueError::new_err(error.to_string()))?;
        summary.sequence = PhaseSequence::from_bits(sequence);
        summary.lift_off_time = lift_off_time;
        codes.push(Class::of(&summary).code());
    }
    Ok(codes.into_pyarray(py))
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("MOST_POINTS", MOST_POINTS)?;
    module.add("MOST_THREADS", MOST_THREADS)?;
    module.add_function(wrap_pyfunction!(summaries, module)?)?;
    module.add_function(wrap_pyfunction!(classes, module)?)
}
