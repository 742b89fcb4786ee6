//! Named values in order: an object of JSON, or columns of CSV.

use std::borrow::Cow;

use littlewood::si::Units;
use littlewood::tables::{Detail, Dimension};
use littlewood::{Mode, SlipDirection};
use serde::ser::{Serialize, SerializeMap, Serializer};

#[derive(Clone, Copy, Debug)]
pub(crate) enum Value {
    /// A number; one that is not finite becomes `null` in JSON.
    Real(f64),
    Count(usize),
    /// A sign: −1, 0 or 1.
    Sign(i8),
    Flag(bool),
    /// A word, or nothing.
    Word(Option<&'static str>),
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match *self {
            Self::Real(value) => serializer.serialize_f64(value),
            Self::Count(value) => serializer.serialize_u64(value as u64),
            Self::Sign(value) => serializer.serialize_i8(value),
            Self::Flag(value) => serializer.serialize_bool(value),
            Self::Word(Some(word)) => serializer.serialize_str(word),
            Self::Word(None) => serializer.serialize_none(),
        }
    }
}

impl From<Option<Mode>> for Value {
    fn from(mode: Option<Mode>) -> Self {
        Self::Word(mode.map(Mode::name))
    }
}

/// σ; 0 where there is no slip.
impl From<Option<SlipDirection>> for Value {
    fn from(direction: Option<SlipDirection>) -> Self {
        Self::Sign(SlipDirection::code(direction))
    }
}

impl From<Detail> for Value {
    fn from(detail: Detail) -> Self {
        match detail {
            Detail::Real(value, _) => Self::Real(value),
            Detail::Count(count) => Self::Count(count),
            Detail::Word(word) => Self::Word(Some(word)),
        }
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct Fields(Vec<(Cow<'static, str>, Value)>);

impl Fields {
    pub(crate) fn names(&self) -> impl Iterator<Item = &str> {
        self.0.iter().map(|(name, _)| name.as_ref())
    }

    pub(crate) fn values(&self) -> impl Iterator<Item = Value> {
        self.0.iter().map(|(_, value)| *value)
    }

    pub(crate) fn extend(&mut self, others: Self) {
        self.0.extend(others.0);
    }

    pub(crate) fn followed_by(mut self, others: Self) -> Self {
        self.extend(others);
        self
    }

    /// Named details, as they are.
    pub(crate) fn of_details(details: impl IntoIterator<Item = (&'static str, Detail)>) -> Self {
        details
            .into_iter()
            .map(|(name, detail)| (name, Value::from(detail)))
            .collect()
    }

    /// Those of the details that are other numbers in SI units, in these units.
    pub(crate) fn of_si_details(
        units: &Units,
        details: impl IntoIterator<Item = (&'static str, Detail)>,
    ) -> Self {
        details
            .into_iter()
            .filter_map(|(name, detail)| match detail {
                Detail::Real(value, dimension)
                    if dimension.halves() != Dimension::Ratio.halves() =>
                {
                    Some((
                        format!("{name}{}", dimension.si_suffix()),
                        Value::Real(units.to_si(dimension, value)),
                    ))
                }
                Detail::Real(..) | Detail::Count(_) | Detail::Word(_) => None,
            })
            .collect()
    }
}

impl<N: Into<Cow<'static, str>>> FromIterator<(N, Value)> for Fields {
    fn from_iter<I: IntoIterator<Item = (N, Value)>>(fields: I) -> Self {
        Self(
            fields
                .into_iter()
                .map(|(name, value)| (name.into(), value))
                .collect(),
        )
    }
}

impl Serialize for Fields {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, value) in &self.0 {
            map.serialize_entry(name, value)?;
        }
        map.end()
    }
}
