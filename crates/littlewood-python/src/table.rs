//! Tables of the core: named cases, edges of the automaton, codes.

use littlewood::{BodyClass, CASES, EDGES, Mode, OutcomeCode, PhaseSequence};
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;

use crate::plane::REGIONS;
use crate::record::{HoopNumbers, StateNumbers, hoop_numbers, start_numbers};

/// The named cases: name, title, source, hoop, start.
#[pyfunction]
fn cases() -> Vec<(&'static str, &'static str, &'static str, HoopNumbers, StateNumbers)> {
    CASES
        .iter()
        .map(|case| {
            (case.name, case.title, case.source, hoop_numbers(&case.hoop), start_numbers(&case.start))
        })
        .collect()
}

/// The edges of the automaton: body, from, cause, guard, reset, to, source.
#[pyfunction]
#[expect(clippy::type_complexity, reason = "a row of a table, read in one place of the package")]
fn edges() -> Vec<(
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    &'static str,
    Option<&'static str>,
    &'static str,
)> {
    EDGES
        .iter()
        .map(|edge| {
            let body = match edge.body {
                BodyClass::Heavy => "heavy",
                BodyClass::Massless => "massless",
            };
            let to = edge.to.map(Mode::name);
            (body, edge.from.name(), edge.cause.name(), edge.guard, edge.reset, to, edge.source)
        })
        .collect()
}

/// Sequences of phases, one letter a phase.
#[pyfunction]
fn sequence_names(bits: PyReadonlyArray1<'_, u64>) -> Vec<String> {
    bits.as_array().iter().map(|&bits| PhaseSequence::from_bits(bits).to_string()).collect()
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("MODES", Mode::ALL.map(Mode::name).to_vec())?;
    module.add("OUTCOMES", OutcomeCode::ALL.map(OutcomeCode::name).to_vec())?;
    module.add("REGIONS", REGIONS.map(littlewood::StartRegion::name).to_vec())?;
    module.add_function(wrap_pyfunction!(cases, module)?)?;
    module.add_function(wrap_pyfunction!(edges, module)?)?;
    module.add_function(wrap_pyfunction!(sequence_names, module)?)
}
