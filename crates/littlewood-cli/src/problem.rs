//! A hoop, a start and the limits of the run as they are meant: flags over scenario file over case,
//! in one system of units.

use littlewood::cases::{CASES, NamedCase, find_case};
use littlewood::si::{SiParameters, SiSetup, Units};
use littlewood::tables::{Group, Presence, Quantity, Setup};
use littlewood::theory::Classification;
use littlewood::{Digits, Hoop, HoopParameters, Limits, ParameterError, Proof, Start, Trajectory};
use littlewood_report::{RESTITUTION_LAW, SAMPLE, Subject, Uncertainty};

use crate::error::{Error, mixed};
use crate::nearest;
use crate::progress::{Bar, Count};
use crate::request::Request;
use crate::scenario::Scenario;
use crate::values::{Given, GivenLaw, Origin, Values, find_mixture, flag};

/// What is to be simulated or classified.
#[derive(Debug)]
pub(crate) struct Problem {
    pub(crate) case: Option<&'static NamedCase>,
    /// What differs from the case.
    pub(crate) changes: Changes,
    pub(crate) hoop: Hoop,
    pub(crate) start: Start,
    pub(crate) limits: Limits,
    /// Units, if results are wanted in SI units too.
    pub(crate) units: Option<Units>,
    inputs: Inputs,
}

/// What a problem has other than its case: the names.
#[derive(Debug, Default)]
pub(crate) struct Changes {
    /// What the case has, too.
    pub(crate) replaced: Vec<&'static str>,
    /// What it has not.
    pub(crate) added: Vec<&'static str>,
}

/// What was given, kept to say where a value comes from that turns out to be wrong.
#[derive(Debug)]
struct Inputs {
    values: Values,
    law: Option<GivenLaw>,
    scenario: Option<Scenario>,
}

impl Problem {
    /// Puts the layers together and checks the result.
    pub(crate) fn resolve(request: Request) -> Result<Self, Error> {
        let case = find(request.case.as_deref(), request.scenario.as_ref())?;
        let values = layered(case, &request)?;
        let asked = AskedLimits::of(&request);
        let is_si = request.is_si() || values.any_si();
        let inputs = Inputs {
            values,
            law: law_of(&request, case),
            scenario: request.scenario,
        };
        inputs.refuse_gaps(is_si)?;
        let Converted {
            hoop,
            start,
            until,
            units,
        } = inputs.convert(is_si).map_err(|error| inputs.blame(error))?;
        let changes = case
            .map(|case| inputs.changes(&case.setup))
            .unwrap_or_default();
        Ok(Self {
            case,
            changes,
            hoop,
            start,
            limits: asked.limits(until),
            units,
            inputs,
        })
    }

    pub(crate) fn simulate(&self) -> Result<Trajectory, Error> {
        self.hoop
            .simulate(self.start, self.limits)
            .map_err(|error| self.inputs.blame(error))
    }

    pub(crate) fn digits(&self) -> Result<Vec<Option<Digits>>, Error> {
        self.hoop
            .digits(self.start, self.limits)
            .map_err(|error| self.inputs.blame(error))
    }

    /// The standard errors of the motion, from those of its numbers. A quantity with two errors is
    /// refused.
    pub(crate) fn uncertainty(
        &self,
        motion: &Trajectory,
        given: Vec<(Quantity, f64)>,
    ) -> Result<Uncertainty, Error> {
        for (index, (quantity, _)) in given.iter().enumerate() {
            if given[..index]
                .iter()
                .any(|(earlier, _)| earlier == quantity)
            {
                return Err(Error::TwoErrors {
                    quantity: *quantity,
                });
            }
        }
        let setup = Setup::new(self.hoop.parameters(), self.start);
        let bar = Bar::new();
        let progress = |done: usize| {
            bar.show(
                "motions",
                Count {
                    done: done as u64,
                    total: SAMPLE as u64,
                },
            );
        };
        Uncertainty::new(&setup, self.limits, motion, given, progress)
            .map_err(Error::NotDifferentiable)
    }

    pub(crate) fn classify(&self) -> Result<Classification, Error> {
        self.hoop
            .classify(self.start)
            .map_err(|error| self.inputs.blame(error))
    }

    /// What a report says beside the motion.
    pub(crate) const fn subject(&self) -> Subject<'_> {
        Subject {
            case: self.case,
            units: self.units.as_ref(),
            ..Subject::of_start(self.start)
        }
    }

    pub(crate) const fn scenario(&self) -> Option<&Scenario> {
        self.inputs.scenario.as_ref()
    }
}

/// The dimensionless problem, and units if it was given in SI units.
struct Converted {
    hoop: Hoop,
    start: Start,
    until: Option<f64>,
    units: Option<Units>,
}

/// The limits besides the time limit that were asked for, flags over the scenario.
struct AskedLimits {
    transitions: Option<u64>,
    slides: Option<u64>,
    proof: Option<Proof>,
}

impl AskedLimits {
    fn of(request: &Request) -> Self {
        let in_file = request.scenario.as_ref().map(|scenario| &scenario.run);
        Self {
            transitions: request.max_transitions.or_else(|| in_file?.max_transitions),
            slides: request.max_slides.or_else(|| in_file?.max_slides),
            proof: request.proof.or_else(|| in_file?.proof),
        }
    }

    fn limits(&self, until: Option<f64>) -> Limits {
        let default = Limits::default();
        let count = |asked: Option<u64>, default: usize| {
            asked.map_or(default, |count| {
                usize::try_from(count).unwrap_or(usize::MAX)
            })
        };
        default
            .with_until(until)
            .with_transitions(count(self.transitions, default.transitions))
            .with_slides(count(self.slides, default.slides))
            .with_proof(self.proof.unwrap_or(default.proof))
    }
}

/// The numbers of the case, under those of the scenario, the flags and what a sweep sets.
fn layered(case: Option<&NamedCase>, request: &Request) -> Result<Values, Error> {
    let mut values = case
        .map(|case| Values::of_case(&case.setup))
        .unwrap_or_default();
    if let Some(scenario) = &request.scenario {
        if let Some((plain, si)) = find_mixture(&scenario.given) {
            return Err(mixed_in_file(scenario, plain, si));
        }
        values.cover(scenario.given.clone());
    }
    refuse_mixture(&request.flags, request.si)?;
    values.cover(request.flags.clone());
    values.cover(request.overrides.given.clone());
    Ok(values)
}

/// The law of restitution of the flags, else of the scenario, else of the case.
fn law_of(request: &Request, case: Option<&NamedCase>) -> Option<GivenLaw> {
    let by_flag = request.law.map(|law| GivenLaw {
        law,
        origin: Origin::Flag,
    });
    let in_file = || request.scenario.as_ref()?.law.clone();
    let of_case = || {
        Some(GivenLaw {
            law: case?.setup.hoop.restitution_law?,
            origin: Origin::Case,
        })
    };
    by_flag.or_else(in_file).or_else(of_case)
}

impl Inputs {
    fn refuse_gaps(&self, is_si: bool) -> Result<(), Error> {
        let setup = Quantity::HOOP.into_iter().chain(Quantity::START);
        let units = Quantity::SI_HOOP
            .into_iter()
            .filter(|quantity| is_si && quantity.group() == Group::Units);
        let missing: Vec<Quantity> = setup
            .chain(units)
            .map(|quantity| {
                if is_si {
                    quantity.si_twin().unwrap_or(quantity)
                } else {
                    quantity
                }
            })
            .filter(|quantity| {
                quantity.row().presence == Presence::Required
                    && self.values.find(*quantity).is_none()
            })
            .collect();
        if missing.is_empty() {
            return Ok(());
        }
        let names = missing
            .iter()
            .map(|quantity| quantity.name().to_owned())
            .collect();
        let flags = missing.iter().map(|quantity| flag(*quantity)).collect();
        Err(Error::Missing { names, flags })
    }

    /// The dimensionless problem. A value that was given without dimension is taken as it is, to
    /// the last bit.
    fn convert(&self, is_si: bool) -> Result<Converted, ParameterError> {
        if !is_si {
            let Setup { hoop, start } = self.over(|_| None);
            return Ok(Converted {
                hoop: Hoop::new(self.with_law(hoop))?,
                start,
                until: self.values.get(Quantity::Until),
                units: None,
            });
        }
        let units = SiParameters {
            particle_mass_kg: self.or_default(Quantity::ParticleMassKg),
            radius_m: self.or_default(Quantity::RadiusM),
            gravity_m_per_s2: self.or_default(Quantity::GravityMPerS2),
            ..SiParameters::default()
        }
        .units()?;
        let si = self.in_si(&units);
        // A hoop whose numbers are all dimensionless does not go by way of SI units, which would
        // round them.
        let has_si_hoop = self
            .values
            .iter()
            .any(|given| given.quantity.is_si() && given.quantity.group() == Group::Hoop);
        let hoop = if has_si_hoop {
            Some(si.hoop.to_hoop()?.0.parameters())
        } else {
            None
        };
        let Setup { hoop, .. } = self.over(|quantity| {
            hoop.and_then(|hoop: HoopParameters| Setup::new(hoop, Start::default()).get(quantity))
        });
        let hoop = Hoop::new(self.with_law(hoop))?;
        let converted = Setup::new(hoop.parameters(), units.start(&si.start)?);
        let Setup { start, .. } = self.over(|quantity| converted.get(quantity));
        let until = match self.values.get(Quantity::UntilS) {
            Some(until_s) => Some(units.until(until_s, &start)?),
            None => self.values.get(Quantity::Until),
        };
        Ok(Converted {
            hoop,
            start,
            until,
            units: Some(units),
        })
    }

    /// The number that was given for a quantity, or its default; NaN, which no check lets through,
    /// if it has none.
    fn or_default(&self, quantity: Quantity) -> f64 {
        self.values
            .get(quantity)
            .or(quantity.row().presence.default_value())
            .unwrap_or(f64::NAN)
    }

    /// The dimensionless numbers that were given, over those of another setup, over the defaults.
    fn over(&self, below: impl Fn(Quantity) -> Option<f64>) -> Setup {
        let mut setup = Setup::new(HoopParameters::default(), Start::default());
        for quantity in Quantity::HOOP.into_iter().chain(Quantity::START) {
            let given = self.values.get(quantity).or_else(|| below(quantity));
            if given.is_some() || quantity.row().presence != Presence::Optional {
                setup.set(quantity, given.unwrap_or_else(|| self.or_default(quantity)));
            }
        }
        setup
    }

    /// All in SI units: what was given so, and the hoop that was not. Of a start that was not given
    /// so the numbers do not count.
    fn in_si(&self, units: &Units) -> SiSetup {
        let hoop = SiSetup::new(&self.over(|_| None), units);
        let value = |quantity: Quantity| match quantity.group() {
            Group::Hoop => self.values.get(quantity).or(hoop.get(quantity)),
            Group::Units => Some(self.or_default(quantity)),
            Group::Start | Group::Place => self
                .values
                .get(quantity)
                .or(quantity.row().presence.default_value())
                .or(Some(0.0)),
            Group::Run => None,
        };
        SiSetup::from_values(value, self.law.as_ref().map(|given| given.law))
    }

    fn with_law(&self, hoop: HoopParameters) -> HoopParameters {
        let mut hoop = hoop;
        hoop.restitution_law = self.law.as_ref().map(|given| given.law);
        hoop
    }

    /// What of the hoop and the start does not come from the case.
    fn changes(&self, case: &Setup) -> Changes {
        let is_of_motion = |quantity: Quantity| match quantity.group() {
            Group::Hoop | Group::Start | Group::Place => true,
            Group::Units | Group::Run => false,
        };
        let given = self
            .values
            .iter()
            .filter(|given| given.origin != Origin::Case && is_of_motion(given.quantity))
            .map(|given| {
                (
                    given.quantity.name(),
                    case.get(given.quantity.dimensionless()).is_some(),
                )
            });
        let law = self.law.iter().filter(|given| given.origin != Origin::Case);
        let law = law.map(|_| (RESTITUTION_LAW, case.hoop.restitution_law.is_some()));
        let (replaced, added): (Vec<_>, Vec<_>) = given.chain(law).partition(|(_, has)| *has);
        let names =
            |list: Vec<(&'static str, bool)>| list.into_iter().map(|(name, _)| name).collect();
        Changes {
            replaced: names(replaced),
            added: names(added),
        }
    }

    /// Says where the value comes from that an error is about.
    fn blame(&self, error: ParameterError) -> Error {
        let origin = match error {
            ParameterError::LawAlone { .. } => self.law.as_ref().map(|given| &given.origin),
            error => self
                .values
                .find(error.quantity())
                .map(|given| &given.origin),
        };
        match (origin, &self.scenario) {
            (Some(Origin::File(span)), Some(scenario)) => Error::ScenarioValue {
                error,
                excerpt: scenario.source.excerpt(span),
            },
            (Some(Origin::File(_) | Origin::Case | Origin::Flag) | None, _) => {
                Error::Value { error }
            }
        }
    }
}

fn find(
    case: Option<&str>,
    scenario: Option<&Scenario>,
) -> Result<Option<&'static NamedCase>, Error> {
    if let Some(name) = case {
        let unknown = || Error::UnknownCase {
            name: name.to_owned(),
            hint: nearest_case(name),
        };
        return find_case(name).map(Some).ok_or_else(unknown);
    }
    let Some((scenario, (name, span))) = scenario.and_then(|it| Some((it, it.case.as_ref()?)))
    else {
        return Ok(None);
    };
    let unknown = || {
        scenario.source.complain(
            format!("there is no case named '{name}'"),
            nearest_case(name),
            span.clone(),
        )
    };
    find_case(name).map(Some).ok_or_else(unknown)
}

fn nearest_case(name: &str) -> String {
    nearest::hint(
        name,
        CASES.iter().map(|case| case.name),
        "`littlewood cases` lists the names",
    )
}

/// Flags in both systems, or dimensionless ones together with `--si`.
fn refuse_mixture(layer: &[Given], si_switch: bool) -> Result<(), Error> {
    let (plain, si) = match (find_mixture(layer), si_switch) {
        (Some((plain, si)), _) => (plain.quantity, flag(si.quantity)),
        (None, true) => match layer
            .iter()
            .find(|given| given.quantity.si_twin().is_some())
        {
            Some(plain) => (plain.quantity, "--si".to_owned()),
            None => return Ok(()),
        },
        (None, false) => return Ok(()),
    };
    let hint = plain.si_twin().map(flag).map_or_else(String::new, |twin| {
        format!(
            "in SI units {} is {twin}; or leave out the flags in SI units",
            flag(plain)
        )
    });
    Err(Error::Mixed {
        plain: flag(plain),
        si,
        hint,
    })
}

fn mixed_in_file(scenario: &Scenario, plain: &Given, si: &Given) -> Error {
    let span = match &plain.origin {
        Origin::File(span) => span.clone(),
        Origin::Case | Origin::Flag => 0..0,
    };
    let message = mixed(plain.quantity, si.quantity);
    let twin = plain.quantity.si_twin().map_or("", Quantity::name);
    scenario.source.complain(
        message,
        format!("in SI units it is {twin}; or leave out the [si] tables"),
        span,
    )
}
