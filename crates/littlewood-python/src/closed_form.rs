//! The closed forms of §3 over arrays of equal length. Undefined values are NaN.

use littlewood::theory::{Body, RollingType, closed_form};
use littlewood::{Hoop, HoopParameters, Start};
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::error::refuse;

type Reals<'py> = Bound<'py, PyArray1<f64>>;

/// Functions of one, two or three reals, element by element.
macro_rules! elementwise {
    ($($name:ident($($argument:ident),+) -> $output:ty = $value:expr;)+) => {
        $(
            #[pyfunction]
            pub(crate) fn $name<'py>(
                py: Python<'py>,
                $($argument: PyReadonlyArray1<'py, f64>),+
            ) -> Bound<'py, PyArray1<$output>> {
                let value = $value;
                $(let mut $argument = $argument.as_array().into_iter().copied();)+
                let mut values = Vec::<$output>::new();
                while let ($(Some($argument),)+) = ($($argument.next(),)+) {
                    values.push(value($($argument),+));
                }
                values.into_pyarray(py)
            }
        )+
    };
}

elementwise! {
    rolling_energy(theta, theta_rate) -> f64 = closed_form::rolling_energy;
    alpha(theta, theta_rate) -> f64 = closed_form::alpha;
    rolling_half_sine(theta, theta_rate, elapsed) -> f64 = |theta, theta_rate, elapsed| {
        closed_form::rolling_half_sine(&Start::at(theta, theta_rate), elapsed)
    };
    rolling_angle(theta, theta_rate, elapsed) -> f64 = |theta, theta_rate, elapsed| {
        closed_form::rolling_angle(&Start::at(theta, theta_rate), elapsed).unwrap_or(f64::NAN)
    };
    rolling_time_to_plane(theta, theta_rate) -> f64 = |theta, theta_rate| {
        closed_form::rolling_time_to_plane(theta, theta_rate).unwrap_or(f64::INFINITY)
    };
    stable_manifold_rate(theta) -> f64 = closed_form::stable_manifold_rate;
    unstable_manifold_rate(theta) -> f64 = closed_form::unstable_manifold_rate;
    rolling_normal(theta, theta_rate) -> f64 = closed_form::rolling_normal;
    rolling_friction(theta, theta_rate) -> f64 = closed_form::rolling_friction;
    in_rolling_region(theta, theta_rate, mu_s) -> bool = |theta, theta_rate, mu_s| {
        closed_form::in_rolling_region(&Start::at(theta, theta_rate), mu_s)
    };
    rolling_type(energy, mu_s) -> u8 = |energy, mu_s| {
        RollingType::of_energy(energy, mu_s).map_or(0, RollingType::code)
    };
    slip_time_from_top(theta_rate, mu_s) -> f64 = closed_form::slip_time_from_top;
    unloading_time_from_top(theta_rate) -> f64 = closed_form::unloading_time_from_top;
    gliding_time_to_plane(theta, theta_rate) -> f64 = closed_form::gliding_time_to_plane;
}

/// Angle at which static friction gives way, for each μs and offset.
#[pyfunction]
pub(crate) fn slip_angle<'py>(
    py: Python<'py>,
    mu_s: PyReadonlyArray1<'py, f64>,
    offset: PyReadonlyArray1<'py, f64>,
) -> PyResult<Reals<'py>> {
    let mut angles = Vec::with_capacity(mu_s.as_array().len());
    for (i, (&mu_s, &offset)) in mu_s.as_array().iter().zip(offset.as_array()).enumerate() {
        let hoop = Hoop::new(
            HoopParameters::thin(0.0)
                .with_offset(offset)
                .with_friction(mu_s, 0.0),
        )
        .map_err(|error| refuse(py, &error, Some(i)))?;
        angles.push(match hoop.body() {
            Body::Massless(body) => closed_form::slip_angle(&body, mu_s).unwrap_or(f64::NAN),
            Body::Heavy(_) => f64::NAN,
        });
    }
    Ok(angles.into_pyarray(py))
}

/// Horizontal and vertical coordinate of the particle of a gliding hoop.
#[pyfunction]
pub(crate) fn gliding_path<'py>(
    py: Python<'py>,
    theta: PyReadonlyArray1<'py, f64>,
    theta_rate: PyReadonlyArray1<'py, f64>,
    slip: PyReadonlyArray1<'py, f64>,
    elapsed: PyReadonlyArray1<'py, f64>,
) -> (Reals<'py>, Reals<'py>) {
    let starts = theta.as_array().into_iter().zip(theta_rate.as_array());
    let others = slip.as_array().into_iter().zip(elapsed.as_array());
    let (x, y): (Vec<f64>, Vec<f64>) = starts
        .zip(others)
        .map(|((&theta, &theta_rate), (&slip, &elapsed))| {
            closed_form::gliding_path(&Start::at(theta, theta_rate).with_slip(slip), elapsed)
        })
        .unzip();
    (x.into_pyarray(py), y.into_pyarray(py))
}
