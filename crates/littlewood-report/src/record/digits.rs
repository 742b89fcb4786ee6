//! How many digits of a transition can be trusted.

use littlewood::Digits;
use littlewood::tables::SampleColumn;

use super::fields::{Fields, Value};

/// The estimates with the numbers that they belong to; none where the start does not decide what happens.
fn named(digits: Option<&Digits>) -> [(SampleColumn, Option<u8>); 5] {
    [
        (SampleColumn::Time, digits.map(|digits| digits.time)),
        (SampleColumn::Theta, digits.map(|digits| digits.theta)),
        (SampleColumn::ThetaRate, digits.map(|digits| digits.theta_rate)),
        (SampleColumn::Slip, digits.map(|digits| digits.slip)),
        (SampleColumn::X, digits.map(|digits| digits.x)),
    ]
}

/// As an object, each under the name of its number.
pub(crate) fn object(digits: &Digits) -> Fields {
    named(Some(digits))
        .into_iter()
        .map(|(column, digits)| (column.name(), Value::Count(usize::from(digits.unwrap_or(0)))))
        .collect()
}

/// As columns; empty where there is no transition.
pub(crate) fn columns(digits: Option<&Option<Digits>>) -> Fields {
    named(digits.and_then(Option::as_ref))
        .into_iter()
        .map(|(column, estimate)| {
            let count = estimate.unwrap_or(0);
            let value = digits.map_or(Value::Word(None), |_| Value::Count(usize::from(count)));
            (format!("{}_digits", column.name()), value)
        })
        .collect()
}
