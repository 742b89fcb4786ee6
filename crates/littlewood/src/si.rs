//! Conversion between SI units and the dimensionless quantities of (2.9), both ways.

use crate::error::{Bound, ParameterError, Quantity, check, finite, non_negative, positive};
use crate::hoop::{Hoop, HoopParameters};
use crate::state::{Start, State};

/// A hoop in SI units.
///
/// ```
/// use littlewood::SiParameters;
///
/// // A hula hoop of 0.4 kg with a battery of 0.14 kg on the rim.
/// let (hoop, units) = SiParameters {
///     disc_mass_kg: 0.4,
///     particle_mass_kg: 0.14,
///     radius_m: 0.45,
///     offset_m: 0.45,
///     inertia_kg_m2: 0.4 * 0.45 * 0.45,
///     gravity_m_per_s2: 9.81,
///     mu_s: 0.5,
///     mu_k: 0.4,
/// }
/// .to_hoop()?;
/// assert!((hoop.mass_ratio() - 0.4 / 0.14).abs() < 1e-15);
/// assert!((units.time_s - (0.45_f64 / 9.81).sqrt()).abs() < 1e-16);
/// # Ok::<(), littlewood::ParameterError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SiParameters {
    /// Mass m1 of the disc or hoop, kg.
    pub disc_mass_kg: f64,
    /// Mass m2 of the particle, kg.
    pub particle_mass_kg: f64,
    /// Outer radius R, m.
    pub radius_m: f64,
    /// Distance ℓ of the particle from the geometric centre, m.
    pub offset_m: f64,
    /// Moment of inertia `I_zz` of the disc about its centre, kg m².
    pub inertia_kg_m2: f64,
    /// Gravitational acceleration g, m/s².
    pub gravity_m_per_s2: f64,
    /// Coefficient of static friction μs.
    pub mu_s: f64,
    /// Coefficient of kinetic friction μk.
    pub mu_k: f64,
}

/// The units of (2.9): SI value = dimensionless value × unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// Mass m2, kg.
    pub mass_kg: f64,
    /// Length R, m.
    pub length_m: f64,
    /// Time √(R/g), s.
    pub time_s: f64,
    /// Gravitational acceleration g, m/s².
    pub gravity_m_per_s2: f64,
}

/// A start, or a state, in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SiState {
    /// Time t, s.
    pub time_s: f64,
    /// Angle θ, rad.
    pub theta_rad: f64,
    /// Rate dθ/dt, rad/s.
    pub theta_rate_rad_per_s: f64,
    /// Slip velocity dη/dt, m/s.
    pub slip_m_per_s: f64,
    /// Position x of the geometric centre, m.
    pub x_m: f64,
}

impl SiParameters {
    /// The dimensionless hoop, and the units to convert its motion with.
    ///
    /// # Errors
    /// m2, R, g > 0; m1, `I_zz` ≥ 0; 0 ≤ ℓ ≤ R; 0 ≤ μk ≤ μs; all finite; and as [`Hoop::new`].
    pub fn to_hoop(&self) -> Result<(Hoop, Units), ParameterError> {
        non_negative(Quantity::DiscMassKg, self.disc_mass_kg)?;
        let radius = positive(Quantity::RadiusM, self.radius_m)?;
        non_negative(Quantity::OffsetM, self.offset_m)?;
        let bound = Bound::AtMost(Quantity::RadiusM, radius);
        check(self.offset_m <= radius, Quantity::OffsetM, self.offset_m, bound)?;
        non_negative(Quantity::InertiaKgM2, self.inertia_kg_m2)?;
        let units = Units::new(self.particle_mass_kg, radius, self.gravity_m_per_s2)?;
        let hoop = Hoop::new(HoopParameters {
            mass_ratio: self.disc_mass_kg / units.mass_kg,
            offset: self.offset_m / units.length_m,
            inertia: self.inertia_kg_m2 / units.inertia_kg_m2(),
            mu_s: self.mu_s,
            mu_k: self.mu_k,
        })?;
        Ok((hoop, units))
    }

    /// The hoop in SI units.
    #[must_use]
    pub fn from_hoop(hoop: &Hoop, units: &Units) -> Self {
        Self {
            disc_mass_kg: hoop.mass_ratio() * units.mass_kg,
            particle_mass_kg: units.mass_kg,
            radius_m: units.length_m,
            offset_m: hoop.offset() * units.length_m,
            inertia_kg_m2: hoop.inertia() * units.inertia_kg_m2(),
            gravity_m_per_s2: units.gravity_m_per_s2,
            mu_s: hoop.mu_s(),
            mu_k: hoop.mu_k(),
        }
    }
}

impl Units {
    /// From m2, R and g.
    ///
    /// # Errors
    /// All three must be finite and greater than zero.
    pub fn new(particle_mass_kg: f64, radius_m: f64, gravity_m_per_s2: f64) -> Result<Self, ParameterError> {
        let mass_kg = positive(Quantity::ParticleMassKg, particle_mass_kg)?;
        let length_m = positive(Quantity::RadiusM, radius_m)?;
        let gravity = positive(Quantity::GravityMPerS2, gravity_m_per_s2)?;
        Ok(Self { mass_kg, length_m, time_s: (length_m / gravity).sqrt(), gravity_m_per_s2: gravity })
    }

    /// Velocity √(g R), m/s.
    #[must_use]
    pub fn velocity_m_per_s(&self) -> f64 {
        self.length_m / self.time_s
    }

    /// Force m2 g, N.
    #[must_use]
    pub fn force_n(&self) -> f64 {
        self.mass_kg * self.gravity_m_per_s2
    }

    /// Energy m2 g R, J.
    #[must_use]
    pub fn energy_j(&self) -> f64 {
        self.force_n() * self.length_m
    }

    /// Moment of inertia m2 R², kg m².
    #[must_use]
    pub fn inertia_kg_m2(&self) -> f64 {
        self.mass_kg * self.length_m * self.length_m
    }

    /// A start given in SI units.
    ///
    /// # Errors
    /// All values must be finite.
    pub fn start(&self, si: &SiState) -> Result<Start, ParameterError> {
        Ok(Start {
            time: self.time(Quantity::TimeS, si.time_s)?,
            theta: finite(Quantity::Theta, si.theta_rad)?,
            theta_rate: finite(Quantity::ThetaRateRadPerS, si.theta_rate_rad_per_s)? * self.time_s,
            slip: finite(Quantity::SlipMPerS, si.slip_m_per_s)? / self.velocity_m_per_s(),
            x: finite(Quantity::XM, si.x_m)? / self.length_m,
        })
    }

    /// A time limit given in seconds.
    ///
    /// # Errors
    /// It must be finite.
    pub fn until(&self, until_s: f64) -> Result<f64, ParameterError> {
        self.time(Quantity::UntilS, until_s)
    }

    fn time(&self, quantity: Quantity, seconds: f64) -> Result<f64, ParameterError> {
        Ok(finite(quantity, seconds)? / self.time_s)
    }

    /// A state in SI units.
    #[must_use]
    pub fn state(&self, state: &State) -> SiState {
        SiState {
            time_s: state.time * self.time_s,
            theta_rad: state.theta,
            theta_rate_rad_per_s: state.theta_rate / self.time_s,
            slip_m_per_s: state.slip * self.velocity_m_per_s(),
            x_m: state.x * self.length_m,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn conversion_goes_both_ways(
            m1 in 0.0..5.0_f64, m2 in 0.01..5.0_f64, radius in 0.01..3.0_f64, part in 0.01..1.0_f64,
            inertia in 0.001..4.0_f64, g in 0.1..30.0_f64, time in -9.0..9.0_f64, slip in -9.0..9.0_f64,
        ) {
            let si = SiParameters {
                disc_mass_kg: m1, particle_mass_kg: m2, radius_m: radius, offset_m: part * radius,
                inertia_kg_m2: inertia, gravity_m_per_s2: g, mu_s: 0.5, mu_k: 0.25,
            };
            let (hoop, units) = si.to_hoop().unwrap();
            let back = SiParameters::from_hoop(&hoop, &units);
            for (a, b) in [
                (si.disc_mass_kg, back.disc_mass_kg), (si.offset_m, back.offset_m),
                (si.inertia_kg_m2, back.inertia_kg_m2), (si.radius_m, back.radius_m),
            ] {
                prop_assert!((a - b).abs() <= 4.0 * f64::EPSILON * a.abs());
            }
            let state = SiState { time_s: time, theta_rad: 1.0, theta_rate_rad_per_s: -time, slip_m_per_s: slip, x_m: slip };
            let start = units.start(&state).unwrap();
            let again = units.state(&start.checked().unwrap());
            for (a, b) in [
                (state.time_s, again.time_s), (state.theta_rate_rad_per_s, again.theta_rate_rad_per_s),
                (state.slip_m_per_s, again.slip_m_per_s), (state.x_m, again.x_m),
            ] {
                prop_assert!((a - b).abs() <= 4.0 * f64::EPSILON * a.abs());
            }
        }
    }

    #[test]
    fn a_particle_outside_the_hoop_is_refused_in_metres() {
        let si = SiParameters {
            disc_mass_kg: 1.0,
            particle_mass_kg: 1.0,
            radius_m: 0.5,
            offset_m: 0.6,
            inertia_kg_m2: 0.25,
            gravity_m_per_s2: 9.81,
            mu_s: 0.5,
            mu_k: 0.4,
        };
        let error = si.to_hoop().unwrap_err();
        assert_eq!(error.to_string(), "offset_m = 0.6 m must not exceed radius_m = 0.5 m");
    }
}
