//! Hoops, starts, states and setups in SI units. Numbers come in in the order of the tables of the
//! core, and go out by their names.

use std::collections::BTreeMap;

use littlewood::si::SiSetup;
use littlewood::tables::{Quantity, Setup, UnknownName};
use littlewood::{Hoop, HoopParameters, Limits, Proof, RestitutionLaw, Start, State};
use pyo3::prelude::*;

use crate::error::{refuse, unknown};

/// The values of [`Quantity::HOOP`]; none for one that is absent.
pub(crate) type HoopNumbers = [Option<f64>; Quantity::HOOP.len()];

/// The name of a law of restitution, if one is given.
pub(crate) type LawName = Option<String>;

/// A hoop as the package has it, a pair: its numbers and its law of restitution.
#[derive(FromPyObject)]
pub(crate) struct GivenHoop {
    #[pyo3(item(0))]
    numbers: HoopNumbers,
    #[pyo3(item(1))]
    law: LawName,
}

/// The values of [`Quantity::START`].
pub(crate) type StartNumbers = [f64; Quantity::START.len()];

/// Values by the names of their quantities.
pub(crate) type ByName<T> = BTreeMap<&'static str, T>;

/// A state as a dictionary.
#[derive(IntoPyObject)]
pub(crate) struct StateDict {
    time: f64,
    theta: f64,
    theta_rate: f64,
    slip: f64,
    x: f64,
}

impl From<State> for StateDict {
    fn from(state: State) -> Self {
        let State {
            time,
            theta,
            theta_rate,
            slip,
            x,
        } = state;
        Self {
            time,
            theta,
            theta_rate,
            slip,
            x,
        }
    }
}

/// The values of [`Quantity::SI_HOOP`]; none for one that is absent.
pub(crate) type SiHoopNumbers = [Option<f64>; Quantity::SI_HOOP.len()];

/// The values of [`Quantity::SI_START`].
pub(crate) type SiStartNumbers = [f64; Quantity::SI_START.len()];

pub(crate) fn law(py: Python<'_>, name: &LawName) -> PyResult<Option<RestitutionLaw>> {
    let parse = |name: &String| {
        name.parse().map_err(|error: UnknownName| {
            unknown(
                py,
                &error,
                "restitution_law",
                &format!("the {} law", RestitutionLaw::default()),
            )
        })
    };
    name.as_ref().map(parse).transpose()
}

/// The limits of a motion that are counted.
#[derive(Clone, Copy)]
pub(crate) struct CountLimits {
    pub(crate) transitions: usize,
    pub(crate) slides: usize,
}

pub(crate) fn limits(
    py: Python<'_>,
    until: Option<f64>,
    counts: CountLimits,
    proof: &str,
) -> PyResult<Limits> {
    let default = || format!("'{}'", Proof::default());
    let proof = proof
        .parse()
        .map_err(|error: UnknownName| unknown(py, &error, "proof", &default()))?;
    Ok(Limits::default()
        .with_until(until)
        .with_transitions(counts.transitions)
        .with_slides(counts.slides)
        .with_proof(proof))
}

/// A setup with these values; the quantities that are not given are zero, or absent if they can be.
pub(crate) fn setup(
    values: impl IntoIterator<Item = (Quantity, Option<f64>)>,
    law: Option<RestitutionLaw>,
) -> Setup {
    let mut setup = Setup::new(HoopParameters::default(), Start::default());
    setup.hoop.restitution_law = law;
    for (quantity, value) in values {
        if let Some(value) = value {
            setup.set(quantity, value);
        }
    }
    setup
}

pub(crate) fn hoop(py: Python<'_>, given: &GivenHoop) -> PyResult<Hoop> {
    let values = Quantity::HOOP.into_iter().zip(given.numbers);
    let setup = setup(values, law(py, &given.law)?);
    Hoop::new(setup.hoop).map_err(|error| refuse(py, &error, None))
}

/// The values of [`Quantity::HOOP`] by their names; none for one that is absent.
pub(crate) fn hoop_by_name(parameters: HoopParameters) -> ByName<Option<f64>> {
    let setup = Setup::new(parameters, Start::default());
    Quantity::HOOP
        .into_iter()
        .map(|quantity| (quantity.name(), setup.get(quantity)))
        .collect()
}

/// The name of the law of restitution of a hoop, if it has one.
pub(crate) fn law_name(parameters: HoopParameters) -> Option<&'static str> {
    parameters.restitution_law.map(RestitutionLaw::name)
}

pub(crate) fn start(numbers: StartNumbers) -> Start {
    setup(Quantity::START.into_iter().zip(numbers.map(Some)), None).start
}

/// The values of [`Quantity::START`] by their names.
pub(crate) fn start_by_name(start: Start) -> ByName<f64> {
    let values = Setup::new(HoopParameters::default(), start).values(Quantity::START);
    Quantity::START
        .into_iter()
        .map(Quantity::name)
        .zip(values)
        .collect()
}

/// A setup in SI units.
pub(crate) fn si_setup(values: &[(Quantity, Option<f64>)], law: Option<RestitutionLaw>) -> SiSetup {
    let value = |wanted| values.iter().find(|(quantity, _)| *quantity == wanted)?.1;
    SiSetup::from_values(value, law)
}
