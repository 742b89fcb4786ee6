//! Impacts.

use littlewood::impact::Impact;
use littlewood::si::Units;
use littlewood::tables::{Detail, Dimension, SampleColumn};
use serde::Serialize;

use super::fields::{Fields, Value};

/// A number of an impact: its name, its dimension, and how it is found.
type Number = (&'static str, Dimension, fn(&Impact) -> f64);

const NUMBERS: [Number; 3] = [
    ("normal_impulse", Dimension::Impulse, |impact| {
        impact.impulse.normal
    }),
    ("friction_impulse", Dimension::Impulse, |impact| {
        impact.impulse.friction
    }),
    ("energy_lost", Dimension::Energy, Impact::energy_lost),
];

/// An impact: its case, the impulse of the plane, the energy lost, the velocities before, and the
/// rate of the gap after.
#[derive(Debug, Serialize)]
pub(crate) struct ImpactRecord {
    #[serde(flatten)]
    whole: Fields,
    before: Fields,
    #[serde(flatten)]
    after: Fields,
}

impl ImpactRecord {
    pub(crate) fn new(impact: &Impact) -> Self {
        let case = Fields::from_iter([("case", Value::Word(Some(impact.case.name())))]);
        Self {
            whole: case.followed_by(Fields::of_details(whole(impact))),
            before: Fields::of_details(before(impact)),
            after: Fields::of_details(after(impact)),
        }
    }

    pub(crate) fn in_si(units: &Units, impact: &Impact) -> Self {
        Self {
            whole: Fields::of_si_details(units, whole(impact)),
            before: Fields::of_si_details(units, before(impact)),
            after: Fields::of_si_details(units, after(impact)),
        }
    }
}

fn whole(impact: &Impact) -> [(&'static str, Detail); NUMBERS.len()] {
    NUMBERS.map(|(name, dimension, of)| (name, Detail::Real(of(impact), dimension)))
}

/// A value of a column of samples.
pub(super) fn number(column: SampleColumn, value: f64) -> (&'static str, Detail) {
    let dimension = column.dimension().unwrap_or(Dimension::Ratio);
    (column.name(), Detail::Real(value, dimension))
}

fn before(impact: &Impact) -> [(&'static str, Detail); 3] {
    let before = impact.before;
    [
        number(SampleColumn::ThetaRate, before.theta_rate),
        number(SampleColumn::Slip, before.slip),
        number(SampleColumn::GapRate, before.gap_rate),
    ]
}

fn after(impact: &Impact) -> [(&'static str, Detail); 1] {
    [number(SampleColumn::GapRate, impact.after.gap_rate)]
}

/// The rate of the gap and the impact as columns, empty where there is no impact.
pub(crate) fn jump(gap_rate: f64, side: Option<&'static str>, impact: Option<&Impact>) -> Fields {
    let case = impact.map(|impact| impact.case.name());
    let first = [
        (SampleColumn::GapRate.name(), Value::Real(gap_rate)),
        ("side", Value::Word(side)),
        ("impact", Value::Word(case)),
    ];
    let numbers = NUMBERS.map(|(name, _, of)| (name, known(impact.map(of))));
    first.into_iter().chain(numbers).collect()
}

/// The same in SI units.
pub(crate) fn si_jump(units: &Units, gap_rate: f64, impact: Option<&Impact>) -> Fields {
    let first = (
        SampleColumn::GapRate.name(),
        Dimension::Velocity,
        Some(gap_rate),
    );
    let numbers = NUMBERS.map(|(name, dimension, of)| (name, dimension, impact.map(of)));
    [first]
        .into_iter()
        .chain(numbers)
        .map(|(name, dimension, value)| {
            let value = value.map(|value| units.to_si(dimension, value));
            (format!("{name}{}", dimension.si_suffix()), known(value))
        })
        .collect()
}

fn known(value: Option<f64>) -> Value {
    value.map_or(Value::Word(None), Value::Real)
}
