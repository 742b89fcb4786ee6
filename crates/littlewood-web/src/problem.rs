//! A hoop and a start, in either system of units.

use littlewood::{
    Bound, Hoop, HoopParameters, Limits, ParameterError, Quantity, SiParameters, SiState, Start, State, Units,
};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::refusal::Refusal;

/// A hoop, a start and a time limit that have been checked.
#[wasm_bindgen]
#[derive(Clone, Debug)]
pub struct Problem {
    pub(crate) hoop: Hoop,
    pub(crate) start: Start,
    pub(crate) limits: Limits,
    pub(crate) units: Option<Units>,
}

#[wasm_bindgen]
impl Problem {
    /// Without dimension (2.9): m̂1, ℓ̂, Î_zz, μs, μk, then θ, θ′, η′, x, τ. `until` limits the time; none to follow
    /// the motion to its end.
    ///
    /// # Errors
    /// Values without physical meaning.
    pub fn dimensionless(numbers: &[f64], until: Option<f64>) -> Result<Self, Refusal> {
        let [mass_ratio, offset, inertia, mu_s, mu_k, theta, theta_rate, slip, x, time] = take(numbers);
        let hoop = Hoop::new(HoopParameters { mass_ratio, offset, inertia, mu_s, mu_k })?;
        let start = Start { time, theta, theta_rate, slip, x };
        Self::checked(hoop, start, until, None)
    }

    /// In SI units: m1, m2, R, ℓ, Izz, g, μs, μk, then θ, dθ/dt, dη/dt, x, t. Converted just as the command line does.
    ///
    /// # Errors
    /// Values without physical meaning.
    pub fn si(numbers: &[f64], until_s: Option<f64>) -> Result<Self, Refusal> {
        let [
            disc_mass_kg,
            particle_mass_kg,
            radius_m,
            offset_m,
            inertia_kg_m2,
            gravity_m_per_s2,
            mu_s,
            mu_k,
            ..,
        ] = take::<13>(numbers);
        let [theta_rad, theta_rate_rad_per_s, slip_m_per_s, x_m, time_s] =
            take(numbers.get(8..).unwrap_or(&[]));
        let si = SiParameters {
            disc_mass_kg,
            particle_mass_kg,
            radius_m,
            offset_m,
            inertia_kg_m2,
            gravity_m_per_s2,
            mu_s,
            mu_k,
        };
        let (hoop, units) = si.to_hoop()?;
        let start = units.start(&SiState { time_s, theta_rad, theta_rate_rad_per_s, slip_m_per_s, x_m })?;
        let until = until_s.map(|until_s| limit(&units, &start, until_s)).transpose()?;
        Self::checked(hoop, start, until, Some(units))
    }

    /// The ten dimensionless numbers, in the order of [`Problem::dimensionless`].
    #[wasm_bindgen(js_name = toDimensionless)]
    #[must_use]
    pub fn to_dimensionless(&self) -> Vec<f64> {
        let HoopParameters { mass_ratio, offset, inertia, mu_s, mu_k } = self.hoop.parameters();
        let Start { time, theta, theta_rate, slip, x } = self.start;
        vec![mass_ratio, offset, inertia, mu_s, mu_k, theta, theta_rate, slip, x, time]
    }

    /// The thirteen numbers in SI units, in the order of [`Problem::si`], for m2, R and g.
    ///
    /// # Errors
    /// Units that are not greater than zero.
    #[wasm_bindgen(js_name = toSi)]
    pub fn to_si(
        &self,
        particle_mass_kg: f64,
        radius_m: f64,
        gravity_m_per_s2: f64,
    ) -> Result<Vec<f64>, Refusal> {
        let units = Units::new(particle_mass_kg, radius_m, gravity_m_per_s2)?;
        let hoop = SiParameters::from_hoop(&self.hoop, &units);
        let Start { time, theta, theta_rate, slip, x } = self.start;
        let start = units.state(&State { time, theta, theta_rate, slip, x });
        Ok(vec![
            hoop.disc_mass_kg,
            hoop.particle_mass_kg,
            hoop.radius_m,
            hoop.offset_m,
            hoop.inertia_kg_m2,
            hoop.gravity_m_per_s2,
            hoop.mu_s,
            hoop.mu_k,
            start.theta_rad,
            start.theta_rate_rad_per_s,
            start.slip_m_per_s,
            start.x_m,
            start.time_s,
        ])
    }

    /// Whether the hoop has no inertia: it rolls and glides (§3).
    #[wasm_bindgen(getter, js_name = isMassless)]
    #[must_use]
    pub fn is_massless(&self) -> bool {
        matches!(self.hoop.body(), littlewood::Body::Massless(_))
    }

    /// h, the distance of the mass centre from the geometric centre (2.4).
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn h(&self) -> f64 {
        self.hoop.h()
    }
}

impl Problem {
    fn checked(hoop: Hoop, start: Start, until: Option<f64>, units: Option<Units>) -> Result<Self, Refusal> {
        // A start has its own bounds, which only a use of it checks.
        hoop.classify(start)?;
        Ok(Self { hoop, start, limits: Limits { until, ..Limits::default() }, units })
    }
}

/// A time limit in seconds, refused in seconds.
fn limit(units: &Units, start: &Start, until_s: f64) -> Result<f64, ParameterError> {
    let until = units.until(until_s)?;
    if until < start.time {
        let bound = Bound::AtLeast(Quantity::TimeS, start.time * units.time_s);
        return Err(ParameterError::OutOfBounds { quantity: Quantity::UntilS, value: until_s, bound });
    }
    Ok(until)
}

/// The first numbers; NaN, which is refused, where there are too few.
fn take<const N: usize>(numbers: &[f64]) -> [f64; N] {
    core::array::from_fn(|i| numbers.get(i).copied().unwrap_or(f64::NAN))
}
