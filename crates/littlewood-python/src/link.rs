//! Links of the laboratory.

use littlewood::tables::Setup;
use littlewood_report::link::{Link, Problem, Refusal};
use pyo3::prelude::*;

use crate::error::refuse;
use crate::record::{
    ByName, GivenHoop, StartNumbers, hoop, hoop_by_name, law_name, start, start_by_name,
};
use crate::units::UnitsDict;

/// What cannot be read of a link.
#[derive(IntoPyObject)]
pub(crate) struct RefusalDict {
    key: String,
    text: String,
    reason: String,
}

/// What cannot be read of a link first, if anything; whether the link says anything of a motion;
/// its instant.
#[derive(IntoPyObject)]
pub(crate) struct LinkDict {
    refusal: Option<RefusalDict>,
    has_problem: bool,
    at: Option<f64>,
}

#[pyfunction]
pub(crate) fn read_link(link: &str) -> LinkDict {
    let read = Link::read(link, "");
    let refusal = read.refusals.into_iter().next();
    LinkDict {
        refusal: refusal.map(|Refusal { key, text, reason }| RefusalDict { key, text, reason }),
        has_problem: read.has_problem,
        at: read.link.at,
    }
}

/// The motion of a link, with the units of its hoop if it has some.
#[derive(IntoPyObject)]
pub(crate) struct ProblemDict {
    hoop: ByName<Option<f64>>,
    restitution_law: Option<&'static str>,
    units: Option<UnitsDict>,
    start: ByName<f64>,
    until: Option<f64>,
}

#[pyfunction]
pub(crate) fn problem_of_link(py: Python<'_>, link: &str) -> PyResult<ProblemDict> {
    let problem = Link::read(link, "").link.problem;
    let (setup, units, until) = problem
        .to_setup()
        .map_err(|error| refuse(py, &error, None))?;
    Ok(ProblemDict {
        hoop: hoop_by_name(setup.hoop),
        restitution_law: law_name(setup.hoop),
        units: units.map(UnitsDict::from),
        start: start_by_name(setup.start),
        until,
    })
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
