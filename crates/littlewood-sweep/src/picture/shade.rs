//! What the colours of a map show.

use std::borrow::Cow;

use littlewood::Hoop;
use littlewood::tables::{DerivativeColumn, Setup, SummaryColumn, SummaryValue};

use crate::columns::Columns;

/// What the colours show.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shade {
    /// The class of the outcome.
    Class,
    /// The sequence of phases: the most frequent ones have a colour each.
    Sequence,
    /// The energy that the whole motion loses, by sliding and in impacts.
    EnergyLost,
    /// A column of numbers, on a scale; grey where it has no value.
    Column(SummaryColumn),
    /// The size of a derivative, on a scale.
    Derivative(DerivativeColumn),
}

impl Shade {
    /// All that can be drawn but derivatives.
    pub fn all() -> impl Iterator<Item = Self> {
        let numbers = SummaryColumn::numbers().map(Self::Column);
        [Self::Class, Self::Sequence, Self::EnergyLost]
            .into_iter()
            .chain(numbers)
    }

    /// Lower-case name: that of the column, where there is one.
    pub fn name(self) -> Cow<'static, str> {
        match self {
            Self::Class => SummaryColumn::Outcome.name().into(),
            Self::Sequence => SummaryColumn::Sequence.name().into(),
            Self::EnergyLost => "energy_lost".into(),
            Self::Column(column) => column.name().into(),
            Self::Derivative(column) => column.to_string().into(),
        }
    }

    /// Whether its colours are a scale of numbers.
    pub const fn is_on_a_scale(self) -> bool {
        match self {
            Self::Class | Self::Sequence => false,
            Self::EnergyLost | Self::Column(_) | Self::Derivative(_) => true,
        }
    }

    /// The number that a point has; NaN where there is none, and for what is not on a scale.
    pub(super) fn number(
        self,
        point: impl FnOnce() -> Setup,
        columns: &Columns,
        place: usize,
    ) -> f64 {
        match self {
            Self::Class | Self::Sequence => f64::NAN,
            Self::EnergyLost => {
                let point = point();
                let start =
                    Hoop::new(point.hoop).map_or(f64::NAN, |hoop| hoop.energy_of(&point.start));
                start
                    - columns
                        .reals(SummaryColumn::Energy)
                        .map_or(f64::NAN, |energy| energy[place])
            }
            Self::Column(column) => match columns.column(column).get(place) {
                SummaryValue::F64(value) => value,
                SummaryValue::U32(count) => f64::from(count),
                SummaryValue::U8(_) | SummaryValue::U64(_) => f64::NAN,
            },
            Self::Derivative(column) => columns
                .derivative(column)
                .map_or(f64::NAN, |values| values[place].abs()),
        }
    }
}
