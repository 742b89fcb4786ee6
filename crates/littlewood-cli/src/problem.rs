//! A hoop, a start and the limits of the run as they are meant: flags over scenario file over case, in one system of
//! units.

use littlewood::{
    Bound, CASES, Classification, Hoop, HoopParameters, Limits, NamedCase, ParameterError, Quantity,
    SiParameters, SiState, Start, Trajectory, Units, find_case,
};
use littlewood_report::Subject;

use crate::args::ProblemArgs;
use crate::error::Error;
use crate::scenario::Scenario;
use crate::values::{Given, Origin, Values, dimensionless, find_mixture, flag, si_twin};

/// Standard acceleration of free fall, m/s².
const STANDARD_GRAVITY: f64 = 9.80665;

/// What is to be simulated or classified.
#[derive(Debug)]
pub(crate) struct Problem {
    /// The case that it starts from.
    pub(crate) case: Option<&'static NamedCase>,
    /// The quantities that differ from those of the case.
    pub(crate) changed: Vec<Quantity>,
    /// Hoop.
    pub(crate) hoop: Hoop,
    /// Start.
    pub(crate) start: Start,
    /// Limits.
    pub(crate) limits: Limits,
    /// Units, if results are wanted in SI units too.
    pub(crate) units: Option<Units>,
    inputs: Inputs,
}

/// What was given, kept to say where a value comes from that turns out to be wrong.
#[derive(Debug)]
struct Inputs {
    values: Values,
    scenario: Option<Scenario>,
}

/// What a sweep puts above all that was given, in whichever units that is.
#[derive(Debug, Default)]
pub(crate) struct Above {
    /// Dimensionless numbers.
    pub(crate) given: Vec<Given>,
    /// Whether units are needed, although none of the numbers may have one.
    pub(crate) si: bool,
}

impl Problem {
    /// Puts the layers together and checks the result. `run` are the limits among the flags.
    ///
    /// # Errors
    /// An unknown case, a missing value, a value out of bounds, or a mixture of units.
    pub(crate) fn resolve(
        args: &ProblemArgs,
        run: Vec<Given>,
        above: Above,
        max_transitions: Option<u64>,
        scenario: Option<Scenario>,
    ) -> Result<Self, Error> {
        let case = find(args, scenario.as_ref())?;
        let mut values = case.map(|case| Values::of_case(&case.hoop, &case.start)).unwrap_or_default();
        if let Some(scenario) = &scenario {
            let layer = scenario.given();
            if let Some((plain, si)) = find_mixture(&layer) {
                return Err(mixed_in_file(scenario, plain, si));
            }
            values.cover(layer);
        }
        let mut layer = args.given();
        layer.extend(run);
        refuse_mixture(&layer, args.si.si)?;
        values.cover(layer);
        values.cover(above.given);

        let max_transitions = max_transitions.or(scenario.as_ref().and_then(Scenario::max_transitions));
        let is_si =
            above.si || args.si.si || values.any_si() || scenario.as_ref().is_some_and(Scenario::is_si);
        let inputs = Inputs { values, scenario };
        inputs.refuse_gaps(is_si)?;
        let (hoop, start, until, units) = inputs.convert(is_si).map_err(|error| inputs.blame(error))?;
        let transitions = max_transitions
            .and_then(|count| usize::try_from(count).ok())
            .unwrap_or(Limits::default().transitions);
        let changed = case.map(|_| inputs.changed()).unwrap_or_default();
        Ok(Self { case, changed, hoop, start, limits: Limits { until, transitions }, units, inputs })
    }

    /// Follows the motion.
    ///
    /// # Errors
    /// A start or a time limit that is out of bounds.
    pub(crate) fn simulate(&self) -> Result<Trajectory, Error> {
        self.hoop.simulate(self.start, self.limits).map_err(|error| self.inputs.blame(error))
    }

    /// Classifies the start.
    ///
    /// # Errors
    /// A start that is out of bounds.
    pub(crate) fn classify(&self) -> Result<Classification, Error> {
        self.hoop.classify(self.start).map_err(|error| self.inputs.blame(error))
    }

    /// What a report says beside the motion.
    pub(crate) const fn subject(&self) -> Subject<'_> {
        Subject { case: self.case, start: self.start, units: self.units.as_ref() }
    }

    /// The scenario file, if there is one.
    pub(crate) const fn scenario(&self) -> Option<&Scenario> {
        self.inputs.scenario.as_ref()
    }
}

impl Inputs {
    /// Refuses a hoop or a start that is not complete.
    fn refuse_gaps(&self, is_si: bool) -> Result<(), Error> {
        const REQUIRED: [Quantity; 7] = [
            Quantity::MassRatio,
            Quantity::Offset,
            Quantity::Inertia,
            Quantity::MuS,
            Quantity::MuK,
            Quantity::Theta,
            Quantity::ThetaRate,
        ];
        let units: &[Quantity] = if is_si { &[Quantity::ParticleMassKg, Quantity::RadiusM] } else { &[] };
        let missing: Vec<Quantity> = REQUIRED
            .iter()
            .chain(units)
            .filter(|quantity| self.values.find(**quantity).is_none())
            .map(|quantity| if is_si { si_twin(*quantity).unwrap_or(*quantity) } else { *quantity })
            .collect();
        if missing.is_empty() {
            return Ok(());
        }
        let names = missing.iter().map(|quantity| quantity.name().to_owned()).collect();
        let flags = missing.iter().map(|quantity| flag(*quantity)).collect();
        Err(Error::Missing { names, flags })
    }

    /// The dimensionless problem. A value that was given without dimension is taken as it is, to the last bit.
    fn convert(&self, is_si: bool) -> Result<(Hoop, Start, Option<f64>, Option<Units>), ParameterError> {
        let plain = |quantity| self.values.get(quantity);
        if !is_si {
            let hoop = Hoop::new(self.hoop_parameters(None))?;
            return Ok((hoop, self.start(None), plain(Quantity::Until), None));
        }
        let units = Units::new(
            plain(Quantity::ParticleMassKg).unwrap_or(f64::NAN),
            plain(Quantity::RadiusM).unwrap_or(f64::NAN),
            plain(Quantity::GravityMPerS2).unwrap_or(STANDARD_GRAVITY),
        )?;
        let converted = self.convert_hoop(&units)?;
        let hoop = Hoop::new(self.hoop_parameters(converted))?;
        let or_zero = |quantity| plain(quantity).unwrap_or(0.0);
        let converted = units.start(&SiState {
            time_s: or_zero(Quantity::TimeS),
            theta_rad: or_zero(Quantity::Theta),
            theta_rate_rad_per_s: or_zero(Quantity::ThetaRateRadPerS),
            slip_m_per_s: or_zero(Quantity::SlipMPerS),
            x_m: or_zero(Quantity::XM),
        })?;
        let start = self.start(Some(converted));
        let until = match plain(Quantity::UntilS) {
            Some(until_s) => {
                let until = units.until(until_s)?;
                if until < start.time {
                    // Said here in seconds, before it would be said without dimension.
                    let bound = Bound::AtLeast(Quantity::TimeS, start.time * units.time_s);
                    let quantity = Quantity::UntilS;
                    return Err(ParameterError::OutOfBounds { quantity, value: until_s, bound });
                }
                Some(until)
            }
            None => plain(Quantity::Until),
        };
        Ok((hoop, start, until, Some(units)))
    }

    /// The hoop by way of SI units; none if no value of it was given in SI units.
    fn convert_hoop(&self, units: &Units) -> Result<Option<HoopParameters>, ParameterError> {
        let masses = [Quantity::DiscMassKg, Quantity::OffsetM, Quantity::InertiaKgM2];
        if masses.iter().all(|quantity| self.values.get(*quantity).is_none()) {
            return Ok(None);
        }
        let below = self.hoop_parameters(None);
        let or = |quantity, otherwise| self.values.get(quantity).unwrap_or(otherwise);
        let (hoop, _) = SiParameters {
            disc_mass_kg: or(Quantity::DiscMassKg, below.mass_ratio * units.mass_kg),
            particle_mass_kg: units.mass_kg,
            radius_m: units.length_m,
            offset_m: or(Quantity::OffsetM, below.offset * units.length_m),
            inertia_kg_m2: or(Quantity::InertiaKgM2, below.inertia * units.inertia_kg_m2()),
            gravity_m_per_s2: units.gravity_m_per_s2,
            mu_s: below.mu_s,
            mu_k: below.mu_k,
        }
        .to_hoop()?;
        Ok(Some(hoop.parameters()))
    }

    fn hoop_parameters(&self, converted: Option<HoopParameters>) -> HoopParameters {
        let pick = |quantity, field: fn(HoopParameters) -> f64| {
            self.values.get(quantity).unwrap_or_else(|| converted.map_or(f64::NAN, field))
        };
        HoopParameters {
            mass_ratio: pick(Quantity::MassRatio, |hoop| hoop.mass_ratio),
            offset: pick(Quantity::Offset, |hoop| hoop.offset),
            inertia: pick(Quantity::Inertia, |hoop| hoop.inertia),
            mu_s: pick(Quantity::MuS, |hoop| hoop.mu_s),
            mu_k: pick(Quantity::MuK, |hoop| hoop.mu_k),
        }
    }

    fn start(&self, converted: Option<Start>) -> Start {
        let pick = |quantity, field: fn(Start) -> f64| {
            self.values.get(quantity).unwrap_or_else(|| converted.map_or(0.0, field))
        };
        Start {
            time: pick(Quantity::Time, |start| start.time),
            theta: pick(Quantity::Theta, |start| start.theta),
            theta_rate: pick(Quantity::ThetaRate, |start| start.theta_rate),
            slip: pick(Quantity::Slip, |start| start.slip),
            x: pick(Quantity::X, |start| start.x),
        }
    }

    /// The quantities of the hoop and the start that do not come from the case.
    fn changed(&self) -> Vec<Quantity> {
        let of_motion = |quantity| {
            let units = [Quantity::ParticleMassKg, Quantity::RadiusM, Quantity::GravityMPerS2];
            dimensionless(quantity) != Quantity::Until && !units.contains(&quantity)
        };
        self.values
            .iter()
            .filter(|given| given.origin != Origin::Case && of_motion(given.quantity))
            .map(|given| given.quantity)
            .collect()
    }

    /// Says where the value comes from that an error is about.
    fn blame(&self, error: ParameterError) -> Error {
        let quantity = match error {
            ParameterError::OutOfBounds { quantity, .. } => quantity,
            _ => Quantity::Offset,
        };
        match (self.values.find(quantity), &self.scenario) {
            (Some(Given { origin: Origin::File(span), .. }), Some(scenario)) => {
                let source_code = scenario.source_code();
                Error::ScenarioValue { error, source_code, span: span.clone().into() }
            }
            _ => Error::Value { error },
        }
    }
}

fn find(args: &ProblemArgs, scenario: Option<&Scenario>) -> Result<Option<&'static NamedCase>, Error> {
    if let Some(name) = &args.case {
        let unknown = || Error::UnknownCase { name: name.clone(), hint: nearest(name) };
        return find_case(name).map(Some).ok_or_else(unknown);
    }
    let Some((scenario, (name, span))) = scenario.and_then(|scenario| Some((scenario, scenario.case()?)))
    else {
        return Ok(None);
    };
    let unknown = || scenario.complain(format!("there is no case named '{name}'"), nearest(name), span);
    find_case(name).map(Some).ok_or_else(unknown)
}

/// The names that look most like this one.
fn nearest(name: &str) -> String {
    let wanted = name.to_lowercase().replace([' ', '_'], "-");
    let mut ranked: Vec<(f64, &str)> = CASES
        .iter()
        .map(|case| (strsim::jaro_winkler(&wanted, case.name), case.name))
        .filter(|(likeness, _)| *likeness > 0.75)
        .collect();
    ranked.sort_by(|a, b| b.0.total_cmp(&a.0));
    let names: Vec<String> = ranked.iter().take(3).map(|(_, name)| format!("'{name}'")).collect();
    if names.is_empty() {
        "`littlewood cases` lists the names".to_owned()
    } else {
        format!("did you mean {}? `littlewood cases` lists the names", names.join(" or "))
    }
}

/// Flags in both systems, or dimensionless ones together with `--si`.
fn refuse_mixture(layer: &[Given], si_switch: bool) -> Result<(), Error> {
    let (plain, si) = match (find_mixture(layer), si_switch) {
        (Some((plain, si)), _) => (plain.quantity, flag(si.quantity)),
        (None, true) => match layer.iter().find(|given| si_twin(given.quantity).is_some()) {
            Some(plain) => (plain.quantity, "--si".to_owned()),
            None => return Ok(()),
        },
        (None, false) => return Ok(()),
    };
    let hint = si_twin(plain).map(flag).map_or_else(String::new, |twin| {
        format!("in SI units {} is {twin}; or leave out the flags in SI units", flag(plain))
    });
    Err(Error::Mixed { plain: flag(plain), si, hint })
}

fn mixed_in_file(scenario: &Scenario, plain: &Given, si: &Given) -> Error {
    let span = match &plain.origin {
        Origin::File(span) => span.clone(),
        Origin::Case | Origin::Flag => 0..0,
    };
    let message = format!(
        "{} has no dimension, {} is in SI units: the two do not go together",
        plain.quantity.name(),
        si.quantity.name()
    );
    let twin = si_twin(plain.quantity).map_or("", |twin| twin.name());
    scenario.complain(message, format!("in SI units it is {twin}; or leave out the [si] tables"), span)
}
