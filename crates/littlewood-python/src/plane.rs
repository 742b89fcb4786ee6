//! The (θ, θ′) plane of rolling over arrays. What is not there is NaN.

use littlewood::theory::{PhasePlane as Core, RollingLaw, Stability, Window};
use littlewood::{Direction, Hoop, Start};
use littlewood_style::Curve;
use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;

use crate::error::refuse;
use crate::record::{GivenHoop, hoop};

type Reals<'py> = Bound<'py, PyArray1<f64>>;
/// Lines, or outlines, as points.
type Pieces = Vec<Vec<[f64; 2]>>;

/// The phase plane of a hoop.
#[pyclass(frozen, module = "littlewood._core")]
struct PhasePlane {
    hoop: Hoop,
    plane: Core,
}

fn over<'py, T: numpy::Element>(
    py: Python<'py>,
    theta: &PyReadonlyArray1<'py, f64>,
    value: impl Fn(f64) -> T,
) -> Bound<'py, PyArray1<T>> {
    theta.as_array().iter().map(|&theta| value(theta)).collect::<Vec<T>>().into_pyarray(py)
}

fn over_two<'py, T: numpy::Element>(
    py: Python<'py>,
    a: &PyReadonlyArray1<'py, f64>,
    b: &PyReadonlyArray1<'py, f64>,
    value: impl Fn(f64, f64) -> T,
) -> Bound<'py, PyArray1<T>> {
    let pairs = a.as_array();
    let values: Vec<T> = pairs.iter().zip(b.as_array()).map(|(&a, &b)| value(a, b)).collect();
    values.into_pyarray(py)
}

#[pymethods]
impl PhasePlane {
    #[new]
    fn new(py: Python<'_>, given: GivenHoop) -> PyResult<Self> {
        let hoop = hoop(py, &given)?;
        Ok(Self { hoop, plane: Core::new(&hoop) })
    }

    fn normal<'py>(
        &self,
        py: Python<'py>,
        theta: PyReadonlyArray1<'py, f64>,
        theta_rate: PyReadonlyArray1<'py, f64>,
    ) -> Reals<'py> {
        over_two(py, &theta, &theta_rate, |theta, rate| self.plane.forces(theta, rate).normal)
    }

    fn friction<'py>(
        &self,
        py: Python<'py>,
        theta: PyReadonlyArray1<'py, f64>,
        theta_rate: PyReadonlyArray1<'py, f64>,
    ) -> Reals<'py> {
        over_two(py, &theta, &theta_rate, |theta, rate| self.plane.forces(theta, rate).friction)
    }

    fn energy<'py>(
        &self,
        py: Python<'py>,
        theta: PyReadonlyArray1<'py, f64>,
        theta_rate: PyReadonlyArray1<'py, f64>,
    ) -> Reals<'py> {
        let law = RollingLaw::new(&self.hoop);
        over_two(py, &theta, &theta_rate, |theta, rate| law.energy(theta, rate))
    }

    fn in_contact_region<'py>(
        &self,
        py: Python<'py>,
        theta: PyReadonlyArray1<'py, f64>,
        theta_rate: PyReadonlyArray1<'py, f64>,
    ) -> Bound<'py, PyArray1<bool>> {
        over_two(py, &theta, &theta_rate, |theta, rate| self.plane.in_contact_region(theta, rate))
    }

    fn in_rolling_region<'py>(
        &self,
        py: Python<'py>,
        theta: PyReadonlyArray1<'py, f64>,
        theta_rate: PyReadonlyArray1<'py, f64>,
    ) -> Bound<'py, PyArray1<bool>> {
        over_two(py, &theta, &theta_rate, |theta, rate| self.plane.in_rolling_region(theta, rate))
    }

    fn normal_force_rate<'py>(&self, py: Python<'py>, theta: PyReadonlyArray1<'py, f64>) -> Reals<'py> {
        over(py, &theta, |theta| self.plane.normal_force_rate(theta).unwrap_or(f64::NAN))
    }

    /// `direction` is −1 or +1.
    fn slip_rate<'py>(
        &self,
        py: Python<'py>,
        theta: PyReadonlyArray1<'py, f64>,
        direction: f64,
    ) -> Reals<'py> {
        let direction = Direction::of_sign(direction);
        over(py, &theta, |theta| {
            direction.and_then(|direction| self.plane.slip_rate(theta, direction)).unwrap_or(f64::NAN)
        })
    }

    fn lift_off_rate<'py>(&self, py: Python<'py>, theta: PyReadonlyArray1<'py, f64>) -> Reals<'py> {
        over(py, &theta, |theta| self.plane.lift_off_rate(theta).unwrap_or(f64::NAN))
    }

    fn separatrix_rate<'py>(&self, py: Python<'py>, theta: PyReadonlyArray1<'py, f64>) -> Reals<'py> {
        over(py, &theta, |theta| self.plane.separatrix_rate(theta))
    }

    fn level_rate<'py>(
        &self,
        py: Python<'py>,
        theta: PyReadonlyArray1<'py, f64>,
        energy: PyReadonlyArray1<'py, f64>,
    ) -> Reals<'py> {
        over_two(py, &theta, &energy, |theta, energy| {
            self.plane.level_rate(theta, energy).unwrap_or(f64::NAN)
        })
    }

    /// The pieces of a curve in a window, which is [from, to] of θ and of θ′, and where its letter stands; none of a name that is none.
    fn curve(&self, name: &str, theta: [f64; 2], theta_rate: [f64; 2]) -> (Pieces, Option<[f64; 2]>) {
        let window = Window { x: theta, y: theta_rate };
        let curve = Curve::ALL.into_iter().find(|curve| curve.name() == name);
        curve.map_or((Vec::new(), None), |curve| {
            (curve.pieces(&self.plane, &window), curve.place_of_letter(&self.plane, &window))
        })
    }

    /// The pieces of the orbit of an energy in a window.
    fn level(&self, energy: f64, theta: [f64; 2], theta_rate: [f64; 2]) -> Pieces {
        self.plane.level_curve(energy, &Window { x: theta, y: theta_rate })
    }

    /// Region R as polygons in a window that reaches as far down as up.
    fn rolling_region(&self, theta: [f64; 2], theta_rate: [f64; 2]) -> Pieces {
        self.plane.rolling_region(&Window { x: theta, y: theta_rate })
    }

    /// Angle, kind and frequency (or exponent) of each equilibrium.
    fn equilibria(&self) -> Vec<(f64, &'static str, f64)> {
        self.plane
            .equilibria()
            .into_iter()
            .map(|equilibrium| match equilibrium.stability {
                Stability::Stable { frequency } => (equilibrium.theta, "stable", frequency),
                Stability::Unstable { exponent } => (equilibrium.theta, "unstable", exponent),
                Stability::Neutral => (equilibrium.theta, "neutral", 0.0),
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

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<PhasePlane>()
}
