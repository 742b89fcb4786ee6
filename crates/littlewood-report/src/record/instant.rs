//! States and samples, dimensionless and in SI units: the columns of the core.

use std::sync::LazyLock;

use littlewood::State;
use littlewood::si::Units;
use littlewood::tables::{SampleColumn, SampleValue};

use super::fields::{Fields, Value};
use crate::instants::Instant;

/// The names of the columns in SI units; none for a code.
static SI_NAMES: LazyLock<Vec<Option<String>>> = LazyLock::new(|| {
    SampleColumn::ALL
        .into_iter()
        .map(SampleColumn::si_name)
        .collect()
});

impl From<SampleValue> for Value {
    fn from(value: SampleValue) -> Self {
        match value {
            SampleValue::Mode(mode) => Some(mode).into(),
            SampleValue::Direction(direction) => direction.into(),
            SampleValue::Real(value) => Self::Real(value),
        }
    }
}

pub(crate) fn state(state: &State) -> Fields {
    let columns = State::COLUMNS.into_iter().zip(state.numbers());
    columns
        .map(|(column, value)| (column.name(), Value::Real(value)))
        .collect()
}

pub(crate) fn si_state(units: &Units, state: &State) -> Fields {
    let columns = State::COLUMNS.into_iter().zip(state.numbers());
    columns
        .filter_map(|(column, value)| in_si(units, column, value))
        .collect()
}

pub(crate) fn sample(instant: &Instant) -> Fields {
    let value = |column: SampleColumn| match column.of(&instant.sample) {
        SampleValue::Mode(_) => instant.mode.into(),
        value @ (SampleValue::Direction(_) | SampleValue::Real(_)) => value.into(),
    };
    SampleColumn::ALL
        .into_iter()
        .map(|column| (column.name(), value(column)))
        .collect()
}

/// An instant of a motion in SI units, without what has none.
pub(crate) fn si_sample(units: &Units, instant: &Instant) -> Fields {
    SampleColumn::ALL
        .into_iter()
        .filter_map(|column| in_si(units, column, column.of(&instant.sample).number()))
        .collect()
}

fn in_si(units: &Units, column: SampleColumn, value: f64) -> Option<(&'static str, Value)> {
    let name = SI_NAMES.get(usize::from(column.code()))?.as_deref()?;
    Some((name, Value::Real(units.to_si(column.dimension()?, value))))
}
