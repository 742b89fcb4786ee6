//! Parameters without physical meaning, as a Python exception.

use std::collections::TryReserveError;

use littlewood::ParameterError as Refusal;
use littlewood::derivatives::NotDifferentiable;
use littlewood::tables::{Quantity, UnknownName};
use pyo3::exceptions::{PyMemoryError, PyValueError};
use pyo3::prelude::*;

pyo3::create_exception!(
    littlewood,
    ParameterError,
    PyValueError,
    "A parameter without physical meaning.\n\nThe message names the value, the bound it breaks and the unit; it is that of the command line.\n\nAttributes\n----------\nquantity : str\n    Name of the parameter.\nhint : str\n    What to do about it.\nindex : int or None\n    Place of the start among many."
);

/// The exception of an error, with the sentence of the command line; `index` is the place of the
/// start in an array.
pub(crate) fn refuse(py: Python<'_>, error: &Refusal, index: Option<usize>) -> PyErr {
    exception(
        py,
        error.to_string(),
        error.quantity().name(),
        error.hint(),
        index,
    )
}

/// The exception of a word that there is not, of a parameter that has a default.
pub(crate) fn unknown(
    py: Python<'_>,
    error: &UnknownName,
    parameter: &str,
    default: &str,
) -> PyErr {
    exception(
        py,
        error.to_string(),
        parameter,
        &format!("leave it out for {default}"),
        None,
    )
}

/// The exception of a quantity that neither a hoop nor a start has; these have the known ones.
pub(crate) fn unknown_quantity(
    py: Python<'_>,
    name: &str,
    known: impl Iterator<Item = Quantity>,
) -> PyErr {
    let hint = format!(
        "quantities are {}",
        Vec::from_iter(known.map(Quantity::name)).join(", ")
    );
    exception(
        py,
        format!("there is no quantity of a hoop or a start named '{name}'"),
        name,
        &hint,
        None,
    )
}

/// The exception of a quantity with respect to which a motion has no derivatives.
pub(crate) fn not_differentiable(py: Python<'_>, error: NotDifferentiable) -> PyErr {
    let hint = "leave it out, or give the hoop a coefficient of restitution";
    exception(py, error.to_string(), error.quantity.name(), hint, None)
}

/// The exception of arrays for which there is no memory.
pub(crate) fn too_large(error: &TryReserveError) -> PyErr {
    PyMemoryError::new_err(error.to_string())
}

fn exception(
    py: Python<'_>,
    message: String,
    quantity: &str,
    hint: &str,
    index: Option<usize>,
) -> PyErr {
    let exception = ParameterError::new_err(message);
    let value = exception.value(py);
    let told = value
        .setattr("quantity", quantity)
        .and_then(|()| value.setattr("hint", hint))
        .and_then(|()| value.setattr("index", index))
        .and_then(|()| {
            // Python 3.10 has no notes.
            if value.hasattr("add_note")? {
                value.call_method1("add_note", (format!("help: {hint}"),))?;
            }
            Ok(())
        });
    match told {
        Ok(()) => exception,
        Err(failure) => failure,
    }
}
