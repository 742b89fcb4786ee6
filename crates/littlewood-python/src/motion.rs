//! One hoop, one start, one motion.

use littlewood::{
    Candidates, Classification, Detail, Direction, Hoop, HoopParameters, Limits, Mode, RollingType, Start,
    Trajectory as Core,
};
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::refuse;
use crate::record::{HoopNumbers, StartNumbers, StateNumbers, hoop, start};
use crate::samples::Samples;

/// Checks the parameters of a hoop; returns its mass m, h and its moment of inertia about the mass centre.
#[pyfunction]
fn check_hoop(py: Python<'_>, numbers: HoopNumbers) -> PyResult<(f64, f64, f64)> {
    let hoop = hoop(py, numbers)?;
    Ok((hoop.mass(), hoop.h(), hoop.body().inertia_about_mass_centre()))
}

/// Checks a time limit for a start at τ = 0, before anything is computed.
#[pyfunction]
fn check_until(py: Python<'_>, until: f64) -> PyResult<()> {
    // The simulation has the rule: a thin hoop at rest is soon simulated.
    Hoop::new(HoopParameters::thin(1.0))
        .and_then(|hoop| hoop.simulate(Start::default(), Limits::until(until).with_transitions(0)))
        .map(drop)
        .map_err(|error| refuse(py, &error, None))
}

/// A simulated motion.
#[pyclass(frozen, module = "littlewood._core")]
struct Trajectory(Core);

/// Simulates a motion, with the interpreter released.
#[pyfunction]
fn simulate(
    py: Python<'_>,
    hoop_numbers: HoopNumbers,
    start_numbers: StartNumbers,
    until: Option<f64>,
    max_transitions: usize,
) -> PyResult<Trajectory> {
    let hoop = hoop(py, hoop_numbers)?;
    let limits = Limits::default().with_until(until).with_transitions(max_transitions);
    let motion = py.detach(|| hoop.simulate(start(start_numbers), limits));
    motion.map(Trajectory).map_err(|error| refuse(py, &error, None))
}

/// Before, after, the impulse upwards and along E1, mode that ends, mode that begins, its direction, cause.
type TransitionRow =
    (StateNumbers, StateNumbers, Option<(f64, f64)>, &'static str, Option<&'static str>, i8, &'static str);

#[pymethods]
impl Trajectory {
    /// The phases: mode, direction, start and end state, energy at the start, energy lost, and whether a glide is a
    /// limit of small inertia.
    #[expect(clippy::type_complexity, reason = "a row of a table, read in one place of the package")]
    fn phases(&self) -> Vec<(&'static str, i8, StateNumbers, Option<StateNumbers>, f64, f64, bool)> {
        self.0
            .phases()
            .iter()
            .map(|phase| {
                (
                    phase.mode().name(),
                    Direction::code(phase.direction()),
                    phase.start().numbers(),
                    phase.end().map(|end| end.numbers()),
                    phase.first().energy,
                    phase.energy_lost(),
                    !phase.is_outside_small_inertia_limit(),
                )
            })
            .collect()
    }

    /// The transitions.
    fn transitions(&self) -> Vec<TransitionRow> {
        self.0
            .transitions()
            .iter()
            .map(|transition| {
                (
                    transition.before.numbers(),
                    transition.after.numbers(),
                    transition.impulse.map(|impulse| (impulse.normal, impulse.friction)),
                    transition.from.name(),
                    transition.to.map(Mode::name),
                    Direction::code(transition.direction),
                    transition.cause.name(),
                )
            })
            .collect()
    }

    /// How the motion ended: kind, state, and what is known besides.
    fn outcome<'py>(&self, py: Python<'py>) -> PyResult<(&'static str, StateNumbers, Bound<'py, PyDict>)> {
        let outcome = self.0.outcome();
        let details = PyDict::new(py);
        add_details(&details, outcome.details())?;
        add_candidates(&details, outcome.candidates())?;
        Ok((outcome.kind().name(), outcome.state().numbers(), details))
    }

    fn end_time(&self) -> f64 {
        self.0.end_time()
    }

    fn energy_lost(&self) -> f64 {
        self.0.energy_lost()
    }

    fn sequence(&self) -> String {
        self.0.summary().sequence.to_string()
    }

    /// The instants `times`.
    fn at<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Bound<'py, PyDict>> {
        let times: Vec<f64> = times.as_array().iter().copied().collect();
        let samples = py.detach(|| {
            let mut samples = Samples::with_capacity(times.len());
            for time in times {
                match self.0.at(time) {
                    Some(sample) => samples.push(&sample),
                    None => samples.push_nothing(time),
                }
            }
            samples
        });
        samples.into_dict(py)
    }

    /// `count` instants evenly spaced up to `until`, and both sides of each transition.
    fn sample_evenly<'py>(&self, py: Python<'py>, count: usize, until: f64) -> PyResult<Bound<'py, PyDict>> {
        let samples = py.detach(|| {
            let mut samples = Samples::with_capacity(count + 2 * self.0.transitions().len());
            for sample in self.0.sample_evenly(count, until) {
                samples.push(&sample);
            }
            samples
        });
        samples.into_dict(py)
    }
}

fn add_details(
    dict: &Bound<'_, PyDict>,
    details: impl IntoIterator<Item = (&'static str, Detail)>,
) -> PyResult<()> {
    for (name, detail) in details {
        match detail {
            Detail::Real(value, _) => dict.set_item(name, value)?,
            Detail::Count(count) => dict.set_item(name, count)?,
            Detail::Word(word) => dict.set_item(name, word)?,
        }
    }
    Ok(())
}

/// The motions that are consistent, and the numbers that decide.
fn add_candidates(dict: &Bound<'_, PyDict>, candidates: Option<Candidates>) -> PyResult<()> {
    let Some(candidates) = candidates else { return Ok(()) };
    let consistent: Vec<(&str, i8)> =
        candidates.consistent().map(|(mode, direction)| (mode.name(), Direction::code(direction))).collect();
    dict.set_item("consistent", consistent)?;
    add_details(dict, candidates.details())
}

/// Where a start lies, as a dictionary.
#[pyfunction]
fn classify(
    py: Python<'_>,
    hoop_numbers: HoopNumbers,
    start_numbers: StartNumbers,
) -> PyResult<Bound<'_, PyDict>> {
    let found: Classification =
        hoop(py, hoop_numbers)?.classify(start(start_numbers)).map_err(|error| refuse(py, &error, None))?;
    let dict = PyDict::new(py);
    dict.set_item("region", found.region.name())?;
    dict.set_item("mode", found.mode.map(Mode::name))?;
    dict.set_item("direction", Direction::code(found.direction))?;
    dict.set_item("energy", found.energy)?;
    dict.set_item("rolling_normal", found.rolling_forces.normal)?;
    dict.set_item("rolling_friction", found.rolling_forces.friction)?;
    dict.set_item("contact", found.contact)?;
    dict.set_item("rolling_type", found.rolling_type.map(RollingType::name))?;
    let end = found.rolling_end.map(|end| (end.elapsed, end.theta, end.theta_rate, end.limit.cause().name()));
    dict.set_item("rolling_end", end)?;
    let details = PyDict::new(py);
    if let Some(recurrence) = &found.recurrence {
        add_details(&details, recurrence.details())?;
    }
    add_candidates(&details, found.candidates)?;
    dict.set_item("details", details)?;
    Ok(dict)
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Trajectory>()?;
    module.add_function(wrap_pyfunction!(check_hoop, module)?)?;
    module.add_function(wrap_pyfunction!(check_until, module)?)?;
    module.add_function(wrap_pyfunction!(simulate, module)?)?;
    module.add_function(wrap_pyfunction!(classify, module)?)
}
