//! What the colours of a map show.

use littlewood::tables::{Setup, SummaryColumn, SummaryValue};
use littlewood::{Hoop, Summary};

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
}

impl Shade {
    /// All that can be drawn.
    pub fn all() -> impl Iterator<Item = Self> {
        let numbers = SummaryColumn::numbers().map(Self::Column);
        [Self::Class, Self::Sequence, Self::EnergyLost].into_iter().chain(numbers)
    }

    /// Lower-case name: that of the column, where there is one.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Class => SummaryColumn::Outcome.name(),
            Self::Sequence => SummaryColumn::Sequence.name(),
            Self::EnergyLost => "energy_lost",
            Self::Column(column) => column.name(),
        }
    }

    /// Whether its colours are a scale of numbers.
    #[must_use]
    pub const fn is_on_a_scale(self) -> bool {
        match self {
            Self::Class | Self::Sequence => false,
            Self::EnergyLost | Self::Column(_) => true,
        }
    }

    /// The number that a point has; NaN where there is none, and for what is not on a scale.
    pub(super) fn number(self, point: &Setup, summary: &Summary) -> f64 {
        match self {
            Self::Class | Self::Sequence => f64::NAN,
            Self::EnergyLost => {
                let start = Hoop::new(point.hoop).map_or(f64::NAN, |hoop| hoop.energy_of(&point.start));
                start - summary.energy
            }
            Self::Column(column) => match column.of(summary) {
                SummaryValue::F64(value) => value,
                SummaryValue::U32(count) => f64::from(count),
                SummaryValue::U8(_) | SummaryValue::U64(_) => f64::NAN,
            },
        }
    }
}
