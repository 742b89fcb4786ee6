//! The (θ, θ′) plane of rolling over arrays. What is not there is NaN.

use littlewood::theory::{PhasePlane as Core, RollingLaw, Stability, Window};
use littlewood::{Hoop, SlipDirection, Start};
use littlewood_style::Curve;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::error::refuse;
use crate::record::{GivenHoop, hoop};

/// A curve of the plane in a window: its pieces, and the place of its letter, if it has one.
#[derive(IntoPyObject)]
pub(crate) struct DrawnCurve {
    pieces: Pieces,
    place_of_letter: Option<[f64; 2]>,
}

/// An equilibrium: its angle, its kind, and its frequency or exponent.
#[derive(IntoPyObject)]
pub(crate) struct EquilibriumDict {
    theta: f64,
    stability: &'static str,
    rate: f64,
}

/// Lines, or outlines, as points.
type Pieces = Vec<Vec<[f64; 2]>>;

/// From one value to another, as the package has it, a pair.
#[derive(FromPyObject)]
struct Interval {
    #[pyo3(item(0))]
    from: f64,
    #[pyo3(item(1))]
    to: f64,
}

fn window(theta: &Interval, theta_rate: &Interval) -> Window {
    Window {
        x: [theta.from, theta.to],
        y: [theta_rate.from, theta_rate.to],
    }
}

#[pyclass(frozen, module = "littlewood._core")]
pub(crate) struct PhasePlane {
    hoop: Hoop,
    plane: Core,
}

/// The methods of the class: functions of the plane and one or two reals, element by element, and
/// others as they stand.
macro_rules! methods {
    ($($name:ident($plane:ident, $($argument:ident),+) -> $output:ty = $value:expr;)+ { $($others:tt)* }) => {
        #[pymethods]
        impl PhasePlane {
            $(
                fn $name<'py>(
                    &self,
                    py: Python<'py>,
                    $($argument: PyReadonlyArray1<'py, f64>),+
                ) -> Bound<'py, PyArray1<$output>> {
                    let $plane = &self.plane;
                    $(let mut $argument = $argument.as_array().into_iter().copied();)+
                    let mut values = Vec::<$output>::new();
                    while let ($(Some($argument),)+) = ($($argument.next(),)+) {
                        values.push($value);
                    }
                    values.into_pyarray(py)
                }
            )+

            $($others)*
        }
    };
}

methods! {
    normal(plane, theta, theta_rate) -> f64 = plane.forces(theta, theta_rate).normal;
    friction(plane, theta, theta_rate) -> f64 = plane.forces(theta, theta_rate).friction;
    in_contact_region(plane, theta, theta_rate) -> bool = plane.in_contact_region(theta, theta_rate);
    in_rolling_region(plane, theta, theta_rate) -> bool = plane.in_rolling_region(theta, theta_rate);
    normal_force_rate(plane, theta) -> f64 = plane.normal_force_rate(theta).unwrap_or(f64::NAN);
    positive_slip_rate(plane, theta) -> f64 = plane.slip_rate(theta, SlipDirection::Positive).unwrap_or(f64::NAN);
    negative_slip_rate(plane, theta) -> f64 = plane.slip_rate(theta, SlipDirection::Negative).unwrap_or(f64::NAN);
    lift_off_rate(plane, theta) -> f64 = plane.lift_off_rate(theta).unwrap_or(f64::NAN);
    separatrix_rate(plane, theta) -> f64 = plane.separatrix_rate(theta);
    reverse_chatter(plane, theta, theta_rate) -> f64 = plane.reverse_chatter(theta, theta_rate).unwrap_or(f64::NAN);
    level_rate(plane, theta, energy) -> f64 = plane.level_rate(theta, energy).unwrap_or(f64::NAN);
    {
    #[new]
    fn new(py: Python<'_>, given: GivenHoop) -> PyResult<Self> {
        let hoop = hoop(py, &given)?;
        Ok(Self { hoop, plane: Core::new(&hoop) })
    }

    fn energy<'py>(
        &self,
        py: Python<'py>,
        theta: PyReadonlyArray1<'py, f64>,
        theta_rate: PyReadonlyArray1<'py, f64>,
    ) -> Bound<'py, PyArray1<f64>> {
        let law = RollingLaw::new(&self.hoop);
        let (theta, rates) = (theta.as_array(), theta_rate.as_array());
        let energies: Vec<f64> = theta.iter().zip(rates).map(|(&theta, &rate)| law.energy(theta, rate)).collect();
        energies.into_pyarray(py)
    }

    /// The curve of this name in a window, [from, to] of θ and of θ′; none for an unknown name.
    fn curve(&self, name: &str, theta: Interval, theta_rate: Interval) -> Option<DrawnCurve> {
        let window = window(&theta, &theta_rate);
        let curve = Curve::ALL.into_iter().find(|curve| curve.name() == name)?;
        Some(DrawnCurve {
            pieces: curve.pieces(&self.plane, &window),
            place_of_letter: curve.place_of_letter(&self.plane, &window),
        })
    }

    /// The pieces of orbits in a window: so many from rest in a turn, and so many over a top.
    fn orbits(&self, theta: Interval, theta_rate: Interval, from_rest: u32, over_top: u32) -> Pieces {
        self.plane.orbits(&window(&theta, &theta_rate), from_rest, over_top)
    }

    /// Region R as polygons in a window that reaches as far down as up.
    fn rolling_region(&self, theta: Interval, theta_rate: Interval) -> Pieces {
        self.plane.rolling_region(&window(&theta, &theta_rate))
    }

    fn equilibria(&self) -> Vec<EquilibriumDict> {
        self.plane
            .equilibria()
            .into_iter()
            .map(|equilibrium| {
                let (stability, rate) = match equilibrium.stability {
                    Stability::Stable { frequency } => ("stable", frequency),
                    Stability::Unstable { exponent } => ("unstable", exponent),
                    Stability::Neutral => ("neutral", 0.0),
                };
                EquilibriumDict { theta: equilibrium.theta, stability, rate }
            })
            .collect()
    }

    /// Code of the region of each start.
    fn regions<'py>(
        &self,
        py: Python<'py>,
        theta: PyReadonlyArray1<'py, f64>,
        theta_rate: PyReadonlyArray1<'py, f64>,
        slip: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Bound<'py, PyArray1<u8>>> {
        let starts = theta.as_array();
        let others = theta_rate.as_array();
        let mut codes = Vec::with_capacity(starts.len());
        for (i, ((&theta, &rate), &slip)) in starts.iter().zip(others).zip(slip.as_array()).enumerate() {
            let start = Start::at(theta, rate).with_slip(slip);
            let found = self.hoop.classify(start).map_err(|error| refuse(py, &error, Some(i)))?;
            codes.push(found.region.code());
        }
        Ok(codes.into_pyarray(py))
    }
    }
}
