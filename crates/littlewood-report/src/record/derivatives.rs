//! Derivatives, dimensionless: an object for each quantity, with the derivatives of the state or
//! why they do not exist.

use littlewood::State;
use littlewood::derivatives::{Derivative, Derivatives, EventDerivative, OutcomeDerivative};
use littlewood::tables::Quantity;
use serde::Serialize;

use super::fields::{Fields, Value};
use super::instant::state;

/// The name of the reason among the fields of a derivative that does not exist.
const REASON: &str = "reason";

/// An object with a field for each quantity.
#[derive(Debug)]
pub(crate) struct DerivativesRecord(Vec<(Quantity, Fields)>);

impl Serialize for DerivativesRecord {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(
            self.0
                .iter()
                .map(|(quantity, fields)| (quantity.name(), fields)),
        )
    }
}

fn record<T: Copy>(
    derivatives: &Derivatives,
    each: &[Derivative<T>],
    fields: impl Fn(T) -> Fields,
) -> DerivativesRecord {
    let fields = |derivative: &Derivative<T>| match derivative {
        Ok(numbers) => fields(*numbers),
        Err(reason) => Fields::from_iter([(REASON, Value::Word(Some(reason.name())))]),
    };
    DerivativesRecord(
        derivatives
            .quantities()
            .iter()
            .copied()
            .zip(each.iter().map(fields))
            .collect(),
    )
}

/// The derivatives of the time of a transition and of the state after it.
pub(crate) fn of_transition(derivatives: &Derivatives, index: usize) -> Option<DerivativesRecord> {
    let each = derivatives.transitions().get(index)?;
    Some(record(
        derivatives,
        each,
        |EventDerivative { after, .. }| state(&after),
    ))
}

/// The derivatives of the state and of the recurrence of the outcome.
pub(crate) fn of_outcome(derivatives: &Derivatives) -> DerivativesRecord {
    record(
        derivatives,
        derivatives.outcome(),
        |OutcomeDerivative {
             state: end,
             recurrence,
             ..
         }| {
            let numbers = recurrence
                .iter()
                .flat_map(littlewood::modes::Recurrence::details);
            let numbers = numbers.map(|(name, detail)| (name, Value::from(detail)));
            state(&end).followed_by(
                numbers
                    .filter(|(_, value)| matches!(value, Value::Real(_)))
                    .collect(),
            )
        },
    )
}

/// The derivatives of the state after a transition as columns of CSV. They are empty in rows that
/// are no transition, and where a derivative does not exist.
pub(crate) fn derivative_columns(derivatives: &Derivatives, index: Option<usize>) -> Fields {
    let each = index.and_then(|index| derivatives.transitions().get(index));
    let quantities = derivatives.quantities().iter().enumerate();
    let columns = quantities.flat_map(|(k, quantity)| {
        let known = each
            .and_then(|each| each[k].ok())
            .map(|derivative| derivative.after);
        State::COLUMNS
            .into_iter()
            .enumerate()
            .map(move |(n, column)| {
                let value =
                    known.map_or(Value::Word(None), |known| Value::Real(known.numbers()[n]));
                (format!("d_{}_d_{}", column.name(), quantity.name()), value)
            })
    });
    columns.collect()
}
