//! Hoops, starts and units.

use littlewood::cases::NamedCase;
use littlewood::si::{SiSetup, Units};
use littlewood::tables::{Detail, Dimension, Quantity, Setup};
use littlewood::{HoopParameters, Mode, Phase, SlipDirection, Start, Trajectory};
use serde::Serialize;

use super::fields::{Fields, Value};
use super::instant::{si_state, state};

/// The name of the law of restitution in records, in scenario files and, with hyphens, as a flag.
pub const RESTITUTION_LAW: &str = "restitution_law";

/// A hoop (2.9).
pub(crate) fn hoop(hoop: HoopParameters) -> Fields {
    let setup = Setup::new(hoop, Start::default());
    numbers(Quantity::HOOP, |quantity| setup.said(quantity)).followed_by(law(&hoop))
}

/// The quantities that have a value.
fn numbers(
    quantities: impl IntoIterator<Item = Quantity>,
    value: impl Fn(Quantity) -> Option<f64>,
) -> Fields {
    let number = |quantity: Quantity| Some((quantity.name(), Value::Real(value(quantity)?)));
    quantities.into_iter().filter_map(number).collect()
}

/// The law of restitution, wherever there is restitution: also where e was given alone.
fn law(hoop: &HoopParameters) -> Fields {
    let law = hoop
        .restitution
        .map(|_| hoop.restitution_law.unwrap_or_default());
    law.map(|law| (RESTITUTION_LAW, Value::Word(Some(law.name()))))
        .into_iter()
        .collect()
}

fn start(start: Start) -> Fields {
    let setup = Setup::new(HoopParameters::default(), start);
    state(&start.into()).followed_by(numbers([Quantity::GapRate], |it| setup.said(it)))
}

fn si_start(units: &Units, start: Start) -> Fields {
    let si = SiSetup::new(&Setup::new(HoopParameters::default(), start), units);
    si_state(units, &start.into()).followed_by(numbers([Quantity::GapRateMPerS], |quantity| {
        si.said(quantity)
    }))
}

/// A start with the motion that begins there.
#[derive(Debug, Serialize)]
pub(crate) struct StartRecord {
    #[serde(flatten)]
    fields: Fields,
    #[serde(skip_serializing_if = "Option::is_none")]
    si: Option<Fields>,
}

impl StartRecord {
    pub(crate) fn new(
        at: Start,
        mode: Option<Mode>,
        direction: Option<SlipDirection>,
        units: Option<&Units>,
    ) -> Self {
        let begins = [("mode", mode.into()), ("direction", direction.into())];
        Self {
            fields: start(at).followed_by(begins.into_iter().collect()),
            si: units.map(|units| si_start(units, at)),
        }
    }

    /// The start of a motion.
    pub(crate) fn of(trajectory: &Trajectory, at: Start, units: Option<&Units>) -> Self {
        let (mode, direction) = opening(trajectory);
        Self::new(at, mode, direction, units)
    }
}

/// The mode and the direction of slip with which a motion begins. Where the start jams, none begins
/// before the impact.
pub(crate) fn opening(trajectory: &Trajectory) -> (Option<Mode>, Option<SlipDirection>) {
    let jams = trajectory
        .transitions()
        .first()
        .is_some_and(|first| first.from.is_none());
    let first = trajectory.phases().first().filter(|_| !jams);
    (first.map(Phase::mode), first.and_then(Phase::direction))
}

/// The hoop and the units in SI.
#[derive(Debug, Serialize)]
pub(crate) struct SiRecord {
    hoop: Fields,
    units: Fields,
    #[serde(flatten)]
    details: Fields,
}

/// The units of (2.9) that a record has.
const UNITS: [(&str, Dimension); 6] = [
    ("mass", Dimension::Mass),
    ("length", Dimension::Length),
    ("time", Dimension::Time),
    ("velocity", Dimension::Velocity),
    ("force", Dimension::Force),
    ("energy", Dimension::Energy),
];

impl SiRecord {
    /// The hoop and the units, and what else is known.
    pub(crate) fn new(
        hoop: HoopParameters,
        units: &Units,
        details: impl IntoIterator<Item = (&'static str, Detail)>,
    ) -> Self {
        let si = SiSetup::new(&Setup::new(hoop, Start::default()), units);
        let unit = |(name, dimension): (&str, Dimension)| {
            (
                format!("{name}{}", dimension.si_suffix()),
                Value::Real(units.unit(dimension)),
            )
        };
        Self {
            hoop: numbers(Quantity::SI_HOOP, |quantity| si.said(quantity)).followed_by(law(&hoop)),
            units: UNITS.into_iter().map(unit).collect(),
            details: Fields::of_si_details(units, details),
        }
    }
}

#[derive(Debug, Serialize)]
pub(crate) struct CaseRecord {
    name: &'static str,
    title: &'static str,
    source: &'static str,
    hoop: Fields,
    start: Fields,
}

impl From<&NamedCase> for CaseRecord {
    fn from(case: &NamedCase) -> Self {
        let NamedCase {
            name,
            title,
            source,
            setup,
        } = *case;
        Self {
            name,
            title,
            source,
            hoop: hoop(setup.hoop),
            start: start(setup.start),
        }
    }
}
