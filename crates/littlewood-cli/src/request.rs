//! What was asked for on the command line and in a scenario file, before it is put together.

use littlewood::{Proof, RestitutionLaw};

use crate::args::{ProblemArgs, RunArgs};
use crate::error::Error;
use crate::scenario::Scenario;
use crate::values::Given;

/// What was asked for: the name of a case, a scenario file, and by flags the rest.
#[derive(Debug)]
pub(crate) struct Request {
    pub(crate) case: Option<String>,
    pub(crate) scenario: Option<Scenario>,
    pub(crate) flags: Vec<Given>,
    pub(crate) law: Option<RestitutionLaw>,
    /// Whether a flag asks for SI units.
    pub(crate) si: bool,
    pub(crate) max_transitions: Option<u64>,
    pub(crate) max_slides: Option<u64>,
    pub(crate) proof: Option<Proof>,
    /// What a sweep sets itself.
    pub(crate) overrides: Overrides,
}

/// What a sweep sets, whatever was given, in whichever units that is.
#[derive(Debug, Default)]
pub(crate) struct Overrides {
    /// Dimensionless numbers.
    pub(crate) given: Vec<Given>,
    /// Whether units are needed, although none of the numbers may have one.
    pub(crate) si: bool,
}

impl Request {
    /// Reads the scenario file, if there is one.
    pub(crate) fn new<const PLACE: bool>(
        problem: &ProblemArgs<PLACE>,
        run: Option<&RunArgs>,
    ) -> Result<Self, Error> {
        let limits = run.map(|run| run.limits.given.clone()).unwrap_or_default();
        Ok(Self {
            case: problem.case.clone(),
            scenario: problem
                .scenario
                .as_deref()
                .map(Scenario::read)
                .transpose()?,
            flags: problem.setup.given.iter().cloned().chain(limits).collect(),
            law: problem.setup.law,
            si: problem.setup.si,
            max_transitions: run.and_then(|run| run.max_transitions),
            max_slides: run.and_then(|run| run.max_slides),
            proof: run.and_then(|run| run.proof),
            overrides: Overrides::default(),
        })
    }

    /// A motion beside another: the name of a case, or a scenario file, which ends in `.toml`. The
    /// limits are those of the other.
    #[cfg(feature = "film")]
    pub(crate) fn named(name: &str, run: &RunArgs) -> Result<Self, Error> {
        let path = std::path::Path::new(name);
        let is_file = path.extension().is_some_and(|ending| ending == "toml");
        Ok(Self {
            case: (!is_file).then(|| name.to_owned()),
            scenario: is_file.then(|| Scenario::read(path)).transpose()?,
            flags: run.limits.given.clone(),
            law: None,
            si: false,
            max_transitions: run.max_transitions,
            max_slides: run.max_slides,
            proof: run.proof,
            overrides: Overrides::default(),
        })
    }

    /// Whether anything was asked for that makes one motion another.
    #[cfg(feature = "figures")]
    pub(crate) fn is_about_a_motion(&self) -> bool {
        let Self {
            case,
            scenario,
            flags,
            law,
            si,
            max_transitions,
            max_slides,
            proof,
            overrides: _,
        } = self;
        let numbers = max_transitions.is_some() || max_slides.is_some();
        let words = law.is_some() || proof.is_some() || *si;
        case.is_some() || scenario.is_some() || !flags.is_empty() || numbers || words
    }

    /// Whether SI units are asked for other than by a number that has one.
    pub(crate) fn is_si(&self) -> bool {
        let in_file = self
            .scenario
            .as_ref()
            .is_some_and(|scenario| scenario.is_si);
        self.si || self.overrides.si || in_file
    }
}
