//! Hoops, starts and units.

use littlewood::{
    Detail, Dimension, Direction, HoopParameters, Mode, Quantity, Setup, SiSetup, Start, State, Units,
};
use serde::Serialize;

use super::fields::{Fields, Value};
use super::instant::{si_state, state};

/// A hoop (2.9).
pub(crate) fn hoop(hoop: HoopParameters) -> Fields {
    let setup = Setup::new(hoop, Start::default());
    Quantity::HOOP
        .into_iter()
        .filter_map(|quantity| Some((quantity.name(), Value::Real(setup.get(quantity)?))))
        .collect()
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
        start: Start,
        mode: Option<Mode>,
        direction: Option<Direction>,
        units: Option<&Units>,
    ) -> Self {
        let start = State::from(start);
        let begins = [("mode", mode.into()), ("direction", direction.into())];
        Self {
            fields: state(&start).followed_by(begins.into_iter().collect()),
            si: units.map(|units| si_state(units, &start)),
        }
    }
}

/// The hoop and the units in SI.
#[derive(Debug, Serialize)]
pub(crate) struct SiRecord {
    hoop: Fields,
    units: Fields,
    #[serde(flatten)]
    energy_lost: Fields,
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
    pub(crate) fn new(hoop: HoopParameters, units: &Units, energy_lost: Option<f64>) -> Self {
        let si = SiSetup::new(&Setup::new(hoop, Start::default()), units);
        let unit = |(name, dimension): (&str, Dimension)| {
            (format!("{name}{}", dimension.si_suffix()), Value::Real(units.unit(dimension)))
        };
        let lost = energy_lost.map(|energy| ("energy_lost", Detail::Real(energy, Dimension::Energy)));
        Self {
            hoop: Quantity::SI_HOOP
                .into_iter()
                .filter_map(|quantity| Some((quantity.name(), Value::Real(si.get(quantity)?))))
                .collect(),
            units: UNITS.into_iter().map(unit).collect(),
            energy_lost: Fields::of_si_details(units, lost),
        }
    }
}
