//! The module `littlewood._core` of the Python package: the core behind NumPy arrays.
//!
//! It is thin on purpose. Arrays and lists of numbers come in, arrays, dictionaries and tuples go out; classes,
//! broadcasting and documentation are those of the package `python/littlewood`, its only caller. Names, codes, labels,
//! units and colours come from the tables of the core and of `littlewood-style`. Arrays that are computed here are
//! handed over, not copied.

mod closed_form;
mod derivatives;
mod digest;
mod error;
mod link;
mod many;
mod motion;
mod palette;
mod plane;
mod program;
mod record;
mod samples;
mod table;
mod units;
mod waiting;

use pyo3::prelude::*;

/// The module.
#[pymodule(gil_used = false)]
fn _core(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    error::register(module)?;
    motion::register(module)?;
    units::register(module)?;
    link::register(module)?;
    many::register(module)?;
    plane::register(module)?;
    closed_form::register(module)?;
    palette::register(module)?;
    digest::register(module)?;
    program::register(module)?;
    table::register(module)
}
