//! Links of the laboratory.

use littlewood::tables::Setup;
use littlewood_report::link::{Link, Problem, Refusal};
use pyo3::prelude::*;

use crate::error::refuse;
use crate::record::{GivenHoop, HoopNumbers, StartNumbers, given, hoop, start, start_numbers};

/// m2, R, √(R/g) and g in SI units.
type UnitNumbers = (f64, f64, f64, f64);

/// Hoop, law of restitution, units if it has some, start and limit.
type ProblemRow = (
    HoopNumbers,
    Option<&'static str>,
    Option<UnitNumbers>,
    StartNumbers,
    Option<f64>,
);

/// What cannot be read of a link first, key, text and reason, if anything; whether the link says
/// anything of a motion; its instant.
#[pyfunction]
pub(crate) fn read_link(link: &str) -> (Option<(String, String, String)>, bool, Option<f64>) {
    let read = Link::read(link, "");
    let refusal = read.refusals.into_iter().next();
    (
        refusal.map(|Refusal { key, text, reason }| (key, text, reason)),
        read.has_problem,
        read.link.at,
    )
}

#[pyfunction]
pub(crate) fn problem_of_link(py: Python<'_>, link: &str) -> PyResult<ProblemRow> {
    let problem = Link::read(link, "").link.problem;
    let (setup, units, until) = problem
        .to_setup()
        .map_err(|error| refuse(py, &error, None))?;
    let (numbers, law) = given(setup.hoop);
    let units = units.map(|it| (it.mass_kg, it.length_m, it.time_s, it.gravity_m_per_s2));
    Ok((numbers, law, units, start_numbers(setup.start), until))
}

/// The link of a motion and an instant, with the view of the link `shown`.
#[pyfunction]
pub(crate) fn write_link(
    py: Python<'_>,
    given: GivenHoop,
    start_numbers: StartNumbers,
    until: Option<f64>,
    at: Option<f64>,
    shown: &str,
) -> PyResult<String> {
    let setup = Setup::new(hoop(py, &given)?.parameters(), start(start_numbers));
    let problem = Problem::of_setup(&setup, until);
    Ok(Link {
        problem,
        at,
        view: Link::read(shown, "").link.view,
    }
    .to_string())
}
