//! Instants of a motion, column by column.

use std::collections::TryReserveError;

use littlewood::tables::{SampleColumn, SampleValue};
use littlewood::{Mode, Sample, SlipDirection};
use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// Code of the mode where there is no motion: before the start, after the end, and just before a
/// jam.
pub(crate) const OUTSIDE: i8 = -1;

/// The values of a column.
enum Values {
    Code(Vec<i8>),
    Real(Vec<f64>),
}

/// An empty list with room for so many values.
pub(crate) fn with_room<T>(count: usize) -> Result<Vec<T>, TryReserveError> {
    let mut values = Vec::new();
    values.try_reserve_exact(count)?;
    Ok(values)
}

/// Columns to which instants are added.
pub(crate) struct Samples(Vec<(SampleColumn, Values)>);

impl Samples {
    /// Columns with room for so many instants.
    ///
    /// # Errors
    /// If there is not so much memory.
    pub(crate) fn with_room(count: usize) -> Result<Self, TryReserveError> {
        let column = |column: SampleColumn| {
            let values = match column.dimension() {
                None => with_room(count).map(Values::Code),
                Some(_) => with_room(count).map(Values::Real),
            };
            values.map(|values| (column, values))
        };
        SampleColumn::ALL
            .into_iter()
            .map(column)
            .collect::<Result<_, _>>()
            .map(Self)
    }

    /// An instant; of one just before a jam there is no mode.
    pub(crate) fn push(&mut self, sample: &Sample, mode: Option<Mode>) {
        for (column, values) in &mut self.0 {
            let value = column.of(sample);
            match values {
                Values::Code(codes) if *column == SampleColumn::Mode => {
                    codes.push(mode.map_or(OUTSIDE, |mode| mode.code().cast_signed()));
                }
                Values::Code(codes) => codes.push(code(value)),
                Values::Real(reals) => reals.push(value.number()),
            }
        }
    }

    /// An instant outside the motion: the time that was asked for, and nothing else.
    pub(crate) fn push_nothing(&mut self, time: f64) {
        for (column, values) in &mut self.0 {
            match values {
                Values::Code(codes) if *column == SampleColumn::Mode => codes.push(OUTSIDE),
                Values::Code(codes) => codes.push(SlipDirection::code(None)),
                Values::Real(reals) => {
                    reals.push(if *column == SampleColumn::Time {
                        time
                    } else {
                        f64::NAN
                    });
                }
            }
        }
    }

    /// The columns as NumPy arrays, without a copy.
    pub(crate) fn into_dict(self, py: Python<'_>) -> PyResult<Bound<'_, PyDict>> {
        let dict = PyDict::new(py);
        for (column, values) in self.0 {
            match values {
                Values::Code(codes) => dict.set_item(column.name(), codes.into_pyarray(py))?,
                Values::Real(reals) => dict.set_item(column.name(), reals.into_pyarray(py))?,
            }
        }
        Ok(dict)
    }
}

/// A value that is a code. A number is none.
fn code(value: SampleValue) -> i8 {
    match value {
        SampleValue::Mode(mode) => mode.code().cast_signed(),
        SampleValue::Direction(direction) => SlipDirection::code(direction),
        SampleValue::Real(_) => OUTSIDE,
    }
}
