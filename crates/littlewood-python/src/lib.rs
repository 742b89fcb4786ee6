//! The module `littlewood._core` of the Python package: the core behind NumPy arrays.
//!
//! It is thin on purpose. Arrays and lists of numbers come in, arrays and dictionaries by name go
//! out; classes, broadcasting and documentation are those of the package `python/littlewood`, its
//! only caller. Names, codes, labels, units and colours come from the tables of the core and of
//! `littlewood-style`. Arrays that are computed here are handed over, not copied.

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

/// The module.
#[pyo3::pymodule(gil_used = false)]
mod _core {
    use littlewood_draw::{LEAST_WIDTH_MM, MOST_WIDTH_MM};
    use littlewood_sweep::MOST_THREADS;
    use pyo3::prelude::*;

    use crate::error::ParameterError;
    use crate::many::MOST_POINTS;
    use crate::table;

    #[pymodule_export]
    use crate::{
        closed_form::{
            alpha, gliding_path, gliding_time_to_plane, in_rolling_region, rolling_angle,
            rolling_energy, rolling_friction, rolling_half_sine, rolling_normal,
            rolling_time_to_plane, rolling_type, slip_angle, slip_time_from_top,
            stable_manifold_rate, unloading_time_from_top, unstable_manifold_rate,
        },
        digest::digest_line,
        link::{problem_of_link, read_link, write_link},
        many::{classes, derivative_column, mixed, summaries},
        motion::{
            Trajectory, bouncing_orbit, check_hoop, check_proof, check_until, classify, simulate,
            threshold,
        },
        palette::{curves, dashes, font, lengths, marked, swatches_of, ticks_of, unicode},
        plane::PhasePlane,
        program::run_program,
        table::{
            cases, edges, name_of_case, quantities, sample_columns, sequence_names, summary_columns,
        },
        units::{derived_units, hoop_from_si, sample_in_si, start_from_si},
    };

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))?;
        module.add("ParameterError", module.py().get_type::<ParameterError>())?;
        module.add("MOST_POINTS", MOST_POINTS)?;
        module.add("MOST_THREADS", MOST_THREADS)?;
        module.add("PRINT_WIDTHS_MM", (LEAST_WIDTH_MM, MOST_WIDTH_MM))?;
        table::register(module)
    }
}
