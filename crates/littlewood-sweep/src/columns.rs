//! The results of a sweep, column by column.

use crate::getters::getters;
use littlewood::tables::{Class, ColumnType, DerivativeColumn, SummaryColumn, SummaryValue};
use littlewood::{OutcomeKind, Summary};

const COLUMNS: usize = SummaryColumn::ALL.len();

/// A column of results: of the summaries, or the derivative of one of their numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Column {
    /// Of the summaries.
    Summary(SummaryColumn),
    /// A derivative.
    Derivative(DerivativeColumn),
}

impl core::fmt::Display for Column {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Summary(column) => column.fmt(f),
            Self::Derivative(column) => column.fmt(f),
        }
    }
}

impl Column {
    /// The columns of results with these derivatives.
    pub fn all(
        derivatives: &[DerivativeColumn],
    ) -> impl ExactSizeIterator<Item = Self> + Clone + '_ {
        let place = |place: usize| match SummaryColumn::ALL.get(place) {
            Some(column) => Self::Summary(*column),
            None => Self::Derivative(derivatives[place - COLUMNS]),
        };
        (0..COLUMNS + derivatives.len()).map(place)
    }

    /// Type.
    pub const fn column_type(self) -> ColumnType {
        match self {
            Self::Summary(column) => column.column_type(),
            Self::Derivative(_) => ColumnType::Real,
        }
    }

    pub(crate) fn not_computed(self) -> SummaryValue {
        match self {
            Self::Summary(column) => column.of(&Summary::NOT_COMPUTED),
            Self::Derivative(_) => SummaryValue::F64(f64::NAN),
        }
    }
}

/// The results of many points: one vector for each [`Column`], all of the same length, in the order
/// of the points.
#[derive(Clone, Debug, PartialEq)]
pub struct Columns {
    /// In the order of [`Column::all`].
    columns: Vec<ColumnValues>,
    derivatives: Vec<DerivativeColumn>,
    /// The class of each point: pictures and counts need it, and it takes much longer to find from
    /// the columns.
    classes: Vec<Class>,
}

/// The values of a column.
#[derive(Clone, Debug, PartialEq)]
pub enum ColumnValues {
    /// 8 bits each.
    U8(Vec<u8>),
    /// 32 bits each.
    U32(Vec<u32>),
    /// 64 bits each.
    U64(Vec<u64>),
    /// In double precision.
    F64(Vec<f64>),
}

impl ColumnValues {
    pub(crate) fn repeat(value: SummaryValue, len: usize) -> Self {
        match value {
            SummaryValue::U8(value) => Self::U8(vec![value; len]),
            SummaryValue::U32(value) => Self::U32(vec![value; len]),
            SummaryValue::U64(value) => Self::U64(vec![value; len]),
            SummaryValue::F64(value) => Self::F64(vec![value; len]),
        }
    }

    /// Number of values.
    pub const fn len(&self) -> usize {
        match self {
            Self::U8(values) => values.len(),
            Self::U32(values) => values.len(),
            Self::U64(values) => values.len(),
            Self::F64(values) => values.len(),
        }
    }

    /// Whether there are none.
    pub const fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// A value below [`ColumnValues::len`].
    ///
    /// # Panics
    /// Beyond it.
    pub fn get(&self, i: usize) -> SummaryValue {
        match self {
            Self::U8(values) => SummaryValue::U8(values[i]),
            Self::U32(values) => SummaryValue::U32(values[i]),
            Self::U64(values) => SummaryValue::U64(values[i]),
            Self::F64(values) => SummaryValue::F64(values[i]),
        }
    }

    /// All values in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = SummaryValue> + '_ {
        (0..self.len()).map(|i| self.get(i))
    }

    /// The values in double precision; none for another type.
    pub fn as_f64(&self) -> Option<&[f64]> {
        match self {
            Self::F64(values) => Some(values),
            Self::U8(_) | Self::U32(_) | Self::U64(_) => None,
        }
    }

    fn set(&mut self, i: usize, value: SummaryValue) {
        match (self, value) {
            (Self::U8(values), SummaryValue::U8(value)) => values[i] = value,
            (Self::U32(values), SummaryValue::U32(value)) => values[i] = value,
            (Self::U64(values), SummaryValue::U64(value)) => values[i] = value,
            (Self::F64(values), SummaryValue::F64(value)) => values[i] = value,
            (Self::U8(_) | Self::U32(_) | Self::U64(_) | Self::F64(_), _) => {
                unreachable!("a column has values of one type")
            }
        }
    }

    /// Sets the values at some places to those of another column of the same type.
    pub(crate) fn spread(&mut self, places: impl Iterator<Item = usize>, values: &Self) {
        fn spread<T: Copy>(full: &mut [T], places: impl Iterator<Item = usize>, values: &[T]) {
            for (place, &value) in places.zip(values) {
                full[place] = value;
            }
        }
        match (self, values) {
            (Self::U8(full), Self::U8(values)) => spread(full, places, values),
            (Self::U32(full), Self::U32(values)) => spread(full, places, values),
            (Self::U64(full), Self::U64(values)) => spread(full, places, values),
            (Self::F64(full), Self::F64(values)) => spread(full, places, values),
            (Self::U8(_) | Self::U32(_) | Self::U64(_) | Self::F64(_), _) => {
                unreachable!("a column has values of one type")
            }
        }
    }
}

impl Default for Columns {
    fn default() -> Self {
        Self::not_computed(0, &[])
    }
}

getters! {
    Columns:
    /// Number of points.
    len(self) -> usize = self.classes.len();
    /// Whether there are no points.
    is_empty(self) -> bool = self.classes.is_empty();
    /// The classes of all points in order.
    classes(self) -> &[Class] = self.classes.as_slice();
}

impl Columns {
    /// Those of points that are not computed.
    pub fn not_computed(len: usize, derivatives: &[DerivativeColumn]) -> Self {
        let columns =
            Column::all(derivatives).map(|column| ColumnValues::repeat(column.not_computed(), len));
        let classes = vec![Class::of(&Summary::NOT_COMPUTED); len];
        Self {
            columns: columns.collect(),
            derivatives: derivatives.to_vec(),
            classes,
        }
    }

    pub(crate) fn set(&mut self, i: usize, summary: &Summary) {
        for (column, value) in self.columns.iter_mut().zip(&summary.values()) {
            column.set(i, *value);
        }
        self.classes[i] = Class::of(summary);
    }

    pub(crate) fn set_derivatives(&mut self, i: usize, values: &[f64]) {
        for (column, value) in self.columns[COLUMNS..].iter_mut().zip(values) {
            // The sign and the payload of a computed NaN are unspecified.
            column.set(
                i,
                SummaryValue::F64(if value.is_nan() { f64::NAN } else { *value }),
            );
        }
    }

    /// From the values of each of [`Column::all`].
    ///
    /// # Errors
    /// Says which column is of another type or length than it must be, or holds a number that is no
    /// code.
    pub(crate) fn from_values(
        columns: Vec<ColumnValues>,
        derivatives: &[DerivativeColumn],
    ) -> Result<Self, String> {
        let all = Column::all(derivatives);
        if columns.len() != all.len() {
            return Err(format!(
                "{} columns instead of {}",
                columns.len(),
                all.len()
            ));
        }
        let len = columns[0].len();
        for (column, values) in all.zip(&columns) {
            let blank = ColumnValues::repeat(column.not_computed(), 0);
            if core::mem::discriminant(&blank) != core::mem::discriminant(values) {
                return Err(format!("column {column} is of another type"));
            }
            if values.len() != len {
                return Err(format!(
                    "column {column} has {} values, others {len}",
                    values.len()
                ));
            }
            if let (ColumnType::Outcome, ColumnValues::U8(codes)) = (column.column_type(), values) {
                for &code in codes {
                    OutcomeKind::try_from(code)
                        .map_err(|error| format!("column {column}: {error}"))?;
                }
            }
        }
        let mut columns = Self {
            columns,
            derivatives: derivatives.to_vec(),
            classes: Vec::new(),
        };
        columns.classes = (0..len).map(|i| Class::of(&columns.summary(i))).collect();
        Ok(columns)
    }

    /// Sets the results of the points at some places to other results, which have the same columns.
    ///
    /// # Panics
    /// For places beyond [`Columns::len`], and other columns.
    pub fn spread(&mut self, places: impl Iterator<Item = usize> + Clone, results: &Self) {
        for (full, values) in self.columns.iter_mut().zip(&results.columns) {
            full.spread(places.clone(), values);
        }
        for (place, &class) in places.zip(&results.classes) {
            self.classes[place] = class;
        }
    }

    /// The values of a column.
    pub fn column(&self, column: SummaryColumn) -> &ColumnValues {
        &self.columns[column.code() as usize]
    }

    /// All columns with their values.
    pub fn columns(&self) -> impl ExactSizeIterator<Item = (Column, &ColumnValues)> + '_ {
        Column::all(&self.derivatives).zip(&self.columns)
    }

    /// All columns with their values, to keep.
    pub fn into_columns(self) -> Vec<(Column, ColumnValues)> {
        Column::all(&self.derivatives).zip(self.columns).collect()
    }

    /// The values of a derivative; none if it has not been computed.
    pub fn derivative(&self, column: DerivativeColumn) -> Option<&[f64]> {
        let place = self.derivatives.iter().position(|known| *known == column)?;
        self.columns[COLUMNS + place].as_f64()
    }

    /// The values of a column of real numbers; none for codes and counts.
    pub fn reals(&self, column: SummaryColumn) -> Option<&[f64]> {
        self.column(column).as_f64()
    }

    /// The summary of a point below [`Columns::len`].
    ///
    /// # Panics
    /// Beyond it.
    pub fn summary(&self, i: usize) -> Summary {
        let mut summary = Summary::NOT_COMPUTED;
        for (column, values) in SummaryColumn::ALL.into_iter().zip(&self.columns) {
            let taken = column.set(&mut summary, values.get(i));
            debug_assert!(taken, "{column} has been checked");
        }
        summary
    }

    /// All summaries in order.
    pub fn summaries(&self) -> impl ExactSizeIterator<Item = Summary> + '_ {
        (0..self.len()).map(|i| self.summary(i))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_that_are_no_columns_are_refused() {
        let good = Columns::not_computed(2, &[]);
        assert_eq!(
            Columns::from_values(good.columns.clone(), &[]).map(|columns| columns.len()),
            Ok(2)
        );
        let with = |column: SummaryColumn, values| {
            let mut columns = good.columns.clone();
            columns[usize::from(column.code())] = values;
            Columns::from_values(columns, &[]).map(drop)
        };
        assert!(with(SummaryColumn::Energy, ColumnValues::U8(vec![0; 2])).is_err());
        assert!(with(SummaryColumn::Energy, ColumnValues::F64(vec![0.0; 3])).is_err());
        assert!(with(SummaryColumn::Outcome, ColumnValues::U8(vec![0, 77])).is_err());
        assert!(with(SummaryColumn::Painleve, ColumnValues::U8(vec![0, 1])).is_ok());
    }
}
