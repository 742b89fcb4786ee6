//! One hoop, one start, one motion.

use littlewood::{
    Bound as Limited, Classification, Findings, Limit, Limits, Mode, Outcome, ParameterError, Quantity,
    Recurrence, RollingType, SiParameters, SiState, Trajectory as Core, Units,
};
use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use pyo3::types::PyDict;

use crate::error::refuse;
use crate::record::{
    HoopNumbers, StateNumbers, hoop, hoop_numbers, sign, start, start_numbers, state_numbers,
};
use crate::samples::Samples;

/// Checks the parameters of a hoop; returns its mass m, h and its moment of inertia about the mass centre.
#[pyfunction]
fn check_hoop(py: Python<'_>, numbers: HoopNumbers) -> PyResult<(f64, f64, f64)> {
    let hoop = hoop(py, numbers)?;
    Ok((hoop.mass(), hoop.h(), hoop.body().inertia_about_mass_centre()))
}

/// From m1, m2, R, ℓ, I_zz, g in SI units and the coefficients of friction: the hoop, and m2, R, √(R/g), g.
#[pyfunction]
#[pyo3(signature = (disc_mass_kg, particle_mass_kg, radius_m, offset_m, inertia_kg_m2, gravity_m_per_s2, mu_s, mu_k))]
#[expect(clippy::too_many_arguments, reason = "they are named where a person writes them, in the package")]
fn hoop_from_si(
    py: Python<'_>,
    disc_mass_kg: f64,
    particle_mass_kg: f64,
    radius_m: f64,
    offset_m: f64,
    inertia_kg_m2: f64,
    gravity_m_per_s2: f64,
    mu_s: f64,
    mu_k: f64,
) -> PyResult<(HoopNumbers, (f64, f64, f64, f64))> {
    let (hoop, units) = SiParameters {
        disc_mass_kg,
        particle_mass_kg,
        radius_m,
        offset_m,
        inertia_kg_m2,
        gravity_m_per_s2,
        mu_s,
        mu_k,
    }
    .to_hoop()
    .map_err(|error| refuse(py, &error, None))?;
    let Units { mass_kg, length_m, time_s, gravity_m_per_s2 } = units;
    Ok((hoop_numbers(&hoop.parameters()), (mass_kg, length_m, time_s, gravity_m_per_s2)))
}

/// A start, and a time limit if there is one, from SI units. `units` are m2, R and g.
#[pyfunction]
fn start_from_si(
    py: Python<'_>,
    units: (f64, f64, f64),
    state: StateNumbers,
    until_s: Option<f64>,
) -> PyResult<(StateNumbers, Option<f64>)> {
    let (time_s, theta_rad, theta_rate_rad_per_s, slip_m_per_s, x_m) = state;
    let convert = || {
        let units = Units::new(units.0, units.1, units.2)?;
        let start = units.start(&SiState { time_s, theta_rad, theta_rate_rad_per_s, slip_m_per_s, x_m })?;
        let until = until_s.map(|until_s| units.until(until_s)).transpose()?;
        if let (Some(until), Some(value)) = (until, until_s)
            && until < start.time
        {
            // Said here in seconds, before it would be said without dimension.
            let bound = Limited::AtLeast(Quantity::TimeS, start.time * units.time_s);
            return Err(ParameterError::OutOfBounds { quantity: Quantity::UntilS, value, bound });
        }
        Ok((start_numbers(&start), until))
    };
    convert().map_err(|error| refuse(py, &error, None))
}

/// A simulated motion.
#[pyclass(frozen, module = "littlewood._core")]
struct Trajectory(Core);

/// Simulates a motion. Long ones do not hold the interpreter.
#[pyfunction]
fn simulate(
    py: Python<'_>,
    hoop_numbers: HoopNumbers,
    start_numbers: StateNumbers,
    until: Option<f64>,
    max_transitions: usize,
) -> PyResult<Trajectory> {
    let hoop = hoop(py, hoop_numbers)?;
    let limits = Limits { until, transitions: max_transitions };
    let motion = py.detach(|| hoop.simulate(start(start_numbers), limits));
    motion.map(Trajectory).map_err(|error| refuse(py, &error, None))
}

#[pymethods]
impl Trajectory {
    /// The phases: mode, direction, start and end state, energy at the start, energy lost, and whether a glide is a
    /// limit of small inertia.
    #[expect(clippy::type_complexity, reason = "a row of a table, read in one place of the package")]
    fn phases(&self) -> Vec<(&'static str, i8, StateNumbers, Option<StateNumbers>, f64, f64, bool)> {
        self.0
            .phases()
            .iter()
            .map(|phase| {
                (
                    phase.mode().name(),
                    sign(phase.direction()),
                    state_numbers(&phase.start()),
                    phase.end().map(|end| state_numbers(&end)),
                    phase.first().energy,
                    phase.energy_lost(),
                    !phase.is_outside_small_inertia_limit(),
                )
            })
            .collect()
    }

    /// The transitions: state, mode that ends, mode that begins, its direction, cause.
    fn transitions(&self) -> Vec<(StateNumbers, &'static str, Option<&'static str>, i8, &'static str)> {
        self.0
            .transitions()
            .iter()
            .map(|transition| {
                (
                    state_numbers(&transition.state),
                    transition.from.name(),
                    transition.to.map(Mode::name),
                    sign(transition.direction),
                    transition.cause.name(),
                )
            })
            .collect()
    }

    /// How the motion ended: kind, state, whether it is final, and what is known besides.
    fn outcome<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(&'static str, StateNumbers, bool, Bound<'py, PyDict>)> {
        let outcome = self.0.outcome();
        let details = PyDict::new(py);
        match &outcome {
            Outcome::Landing { gap_rate, .. } => details.set_item("gap_rate", gap_rate)?,
            Outcome::RollsForever { recurrence, .. } | Outcome::SlidesForever { recurrence, .. } => {
                recur(&details, recurrence)?;
            }
            Outcome::Inconsistent { findings, .. } | Outcome::Ambiguous { findings, .. } => {
                find(&details, findings)?;
            }
            Outcome::Singular { solvability, .. } => details.set_item("solvability", solvability)?,
            _ => {}
        }
        Ok((outcome.kind(), state_numbers(&outcome.state()), outcome.is_final(), details))
    }

    fn end_time(&self) -> f64 {
        self.0.end_time()
    }

    fn energy_lost(&self) -> f64 {
        self.0.energy_lost()
    }

    fn sequence(&self) -> String {
        self.0.summary().sequence.to_string()
    }

    /// The instants `times`.
    fn at<'py>(&self, py: Python<'py>, times: PyReadonlyArray1<'py, f64>) -> PyResult<Bound<'py, PyDict>> {
        let times: Vec<f64> = times.as_array().iter().copied().collect();
        let samples = py.detach(|| {
            let mut samples = Samples::with_capacity(times.len());
            for time in times {
                match self.0.at(time) {
                    Some(sample) => samples.push(self.0.hoop(), &sample),
                    None => samples.push_nothing(time),
                }
            }
            samples
        });
        samples.into_dict(py)
    }

    /// `count` instants evenly spaced up to `until`, and both sides of each transition.
    fn sample_evenly<'py>(&self, py: Python<'py>, count: usize, until: f64) -> PyResult<Bound<'py, PyDict>> {
        let samples = py.detach(|| {
            let mut samples = Samples::with_capacity(count + 2 * self.0.transitions().len());
            for sample in self.0.sample_evenly(count, until) {
                samples.push(self.0.hoop(), &sample);
            }
            samples
        });
        samples.into_dict(py)
    }
}

fn recur(details: &Bound<'_, PyDict>, recurrence: &Recurrence) -> PyResult<()> {
    match *recurrence {
        Recurrence::Rest => details.set_item("recurrence", "rest"),
        Recurrence::Libration { period, theta_min, theta_max } => {
            details.set_item("recurrence", "libration")?;
            details.set_item("period", period)?;
            details.set_item("theta_min", theta_min)?;
            details.set_item("theta_max", theta_max)
        }
        Recurrence::Rotation { period } => {
            details.set_item("recurrence", "rotation")?;
            details.set_item("period", period)
        }
        Recurrence::Asymptotic { theta } => {
            details.set_item("recurrence", "asymptotic")?;
            details.set_item("theta_limit", theta)
        }
    }
}

fn find(details: &Bound<'_, PyDict>, findings: &Findings) -> PyResult<()> {
    let consistent: Vec<(&str, i8)> =
        findings.consistent().map(|(mode, direction)| (mode.name(), sign(direction))).collect();
    details.set_item("consistent", consistent)?;
    details.set_item("rolling_normal", findings.rolling_forces.normal)?;
    details.set_item("rolling_friction", findings.rolling_forces.friction)?;
    details.set_item("contact", findings.contact)?;
    details.set_item("solvability_negative", findings.solvability[0])?;
    details.set_item("solvability_positive", findings.solvability[1])
}

/// Where a start lies, as a dictionary.
#[pyfunction]
fn classify(
    py: Python<'_>,
    hoop_numbers: HoopNumbers,
    start_numbers: StateNumbers,
) -> PyResult<Bound<'_, PyDict>> {
    let found: Classification =
        hoop(py, hoop_numbers)?.classify(start(start_numbers)).map_err(|error| refuse(py, &error, None))?;
    let dict = PyDict::new(py);
    dict.set_item("region", found.region.name())?;
    dict.set_item("mode", found.mode.map(Mode::name))?;
    dict.set_item("direction", sign(found.direction))?;
    dict.set_item("energy", found.energy)?;
    dict.set_item("rolling_normal", found.rolling_forces.normal)?;
    dict.set_item("rolling_friction", found.rolling_forces.friction)?;
    dict.set_item("contact", found.contact)?;
    dict.set_item("rolling_type", found.rolling_type.map(RollingType::name))?;
    let end = found.rolling_end.map(|end| {
        let cause = match end.limit {
            Limit::Friction(_) => "slip",
            Limit::NormalForce => "normal_force_zero",
        };
        (end.elapsed, end.theta, end.theta_rate, cause)
    });
    dict.set_item("rolling_end", end)?;
    let details = PyDict::new(py);
    if let Some(recurrence) = &found.recurrence {
        recur(&details, recurrence)?;
    }
    if let Some(findings) = &found.findings {
        find(&details, findings)?;
    }
    dict.set_item("details", details)?;
    Ok(dict)
}

pub(crate) fn register(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add_class::<Trajectory>()?;
    module.add_function(wrap_pyfunction!(check_hoop, module)?)?;
    module.add_function(wrap_pyfunction!(hoop_from_si, module)?)?;
    module.add_function(wrap_pyfunction!(start_from_si, module)?)?;
    module.add_function(wrap_pyfunction!(simulate, module)?)?;
    module.add_function(wrap_pyfunction!(classify, module)?)
}
