//! Conversion between SI units and the dimensionless quantities of (2.9).

use crate::model::{
    Bound, Dimension, Hoop, HoopParameters, ParameterError, Quantity, RestitutionLaw,
    STANDARD_GRAVITY, Setup, Start, State, Units, within,
};

/// A hoop in SI units.
///
/// ```
/// use littlewood::si::SiParameters;
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
///     ..SiParameters::default()
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
    /// Coefficient of rolling resistance, m.
    pub rolling_resistance_m: f64,
    /// Slope α of the plane, rad.
    pub slope: f64,
    /// Coefficient of restitution e; without one a motion ends at a landing.
    pub restitution: Option<f64>,
    /// Law of restitution; `None` with a coefficient is the energetic law.
    pub restitution_law: Option<RestitutionLaw>,
}

/// A start, or a state, in SI units.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SiState {
    /// Time t, s.
    pub time_s: f64,
    /// Angle θ, rad.
    pub theta_rad: f64,
    /// Rate dθ/dt, rad/s.
    pub theta_rate_rad_per_s: f64,
    /// Slip velocity dη/dt, m/s.
    pub slip_m_per_s: f64,
    /// Gap rate of a start, m/s; zero in a state, also in flight.
    pub gap_rate_m_per_s: f64,
    /// Position x of the geometric centre, m.
    pub x_m: f64,
}

/// Standard gravity, zero for all other numbers, no restitution. Masses and lengths must be set.
impl Default for SiParameters {
    fn default() -> Self {
        Self {
            disc_mass_kg: 0.0,
            particle_mass_kg: 0.0,
            radius_m: 0.0,
            offset_m: 0.0,
            inertia_kg_m2: 0.0,
            gravity_m_per_s2: STANDARD_GRAVITY,
            mu_s: 0.0,
            mu_k: 0.0,
            rolling_resistance_m: 0.0,
            slope: 0.0,
            restitution: None,
            restitution_law: None,
        }
    }
}

impl SiParameters {
    /// The units of (2.9) from m2, R and g.
    ///
    /// # Errors
    /// m2, R or g not finite or not positive.
    pub fn units(&self) -> Result<Units, ParameterError> {
        let mass_kg = Quantity::ParticleMassKg.check(self.particle_mass_kg)?;
        let length_m = Quantity::RadiusM.check(self.radius_m)?;
        let gravity = Quantity::GravityMPerS2.check(self.gravity_m_per_s2)?;
        Ok(Units {
            mass_kg,
            length_m,
            time_s: (length_m / gravity).sqrt(),
            gravity_m_per_s2: gravity,
        })
    }

    /// The dimensionless hoop and the units of its motion.
    ///
    /// # Errors
    /// Unless m2, R, g > 0, m1, `I_zz` ≥ 0, 0 ≤ ℓ ≤ R, 0 ≤ μk ≤ μs, χ ≥ 0, all finite; and as
    /// [`Hoop::new`].
    pub fn to_hoop(&self) -> Result<(Hoop, Units), ParameterError> {
        let mass = Quantity::DiscMassKg.check(self.disc_mass_kg)?;
        let radius = Quantity::RadiusM.check(self.radius_m)?;
        let offset = Quantity::OffsetM.check(self.offset_m)?;
        let at_most = Bound::AtMost(Quantity::RadiusM, radius);
        within(Quantity::OffsetM, offset, at_most)?;
        let inertia = Quantity::InertiaKgM2.check(self.inertia_kg_m2)?;
        let resistance = Quantity::RollingResistanceM.check(self.rolling_resistance_m)?;
        let units = self.units()?;
        let plain = |quantity: Quantity, value| units.from_si(quantity.dimension(), value);
        let parameters = HoopParameters {
            mass_ratio: plain(Quantity::DiscMassKg, mass),
            offset: plain(Quantity::OffsetM, offset),
            inertia: plain(Quantity::InertiaKgM2, inertia),
            mu_s: self.mu_s,
            mu_k: self.mu_k,
            rolling_resistance: plain(Quantity::RollingResistanceM, resistance),
            slope: self.slope,
            restitution: self.restitution,
            restitution_law: self.restitution_law,
        };
        Ok((Hoop::new(parameters)?, units))
    }

    /// The parameters of a hoop in SI units, unchecked.
    #[must_use]
    pub fn new(hoop: &HoopParameters, units: &Units) -> Self {
        let si = |quantity: Quantity, value| units.to_si(quantity.dimension(), value);
        Self {
            disc_mass_kg: si(Quantity::DiscMassKg, hoop.mass_ratio),
            particle_mass_kg: units.mass_kg,
            radius_m: units.length_m,
            offset_m: si(Quantity::OffsetM, hoop.offset),
            inertia_kg_m2: si(Quantity::InertiaKgM2, hoop.inertia),
            gravity_m_per_s2: units.gravity_m_per_s2,
            mu_s: hoop.mu_s,
            mu_k: hoop.mu_k,
            rolling_resistance_m: si(Quantity::RollingResistanceM, hoop.rolling_resistance),
            slope: hoop.slope,
            restitution: hoop.restitution,
            restitution_law: hoop.restitution_law,
        }
    }
}

/// A hoop and a start in SI units, with access by quantity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SiSetup {
    /// The hoop.
    pub hoop: SiParameters,
    /// The start.
    pub start: SiState,
}

impl SiSetup {
    /// A setup in SI units.
    #[must_use]
    pub fn new(setup: &Setup, units: &Units) -> Self {
        let gap_rate = units.to_si(Quantity::GapRateMPerS.dimension(), setup.start.gap_rate);
        let start = SiState {
            gap_rate_m_per_s: gap_rate,
            ..units.state(&setup.start.into())
        };
        Self {
            hoop: SiParameters::new(&setup.hoop, units),
            start,
        }
    }

    /// From the values of [`Quantity::SI_HOOP`] and [`Quantity::SI_START`]. A missing value is NaN,
    /// an error in
    /// [`SiSetup::to_setup`].
    pub fn from_values(
        value: impl Fn(Quantity) -> Option<f64>,
        restitution_law: Option<RestitutionLaw>,
    ) -> Self {
        let hoop = SiParameters {
            restitution: value(Quantity::Restitution),
            restitution_law,
            ..Default::default()
        };
        let mut setup = Self {
            hoop,
            start: SiState::default(),
        };
        for quantity in Quantity::SI_HOOP.into_iter().chain(Quantity::SI_START) {
            if let Some(field) = setup.field(quantity) {
                *field = value(quantity).unwrap_or(f64::NAN);
            }
        }
        setup
    }

    /// The value of a quantity; `None` for a limit and for dimensionless quantities with an SI
    /// twin.
    pub fn get(&self, quantity: Quantity) -> Option<f64> {
        let mut copy = *self;
        if quantity == Quantity::Restitution {
            self.hoop.restitution
        } else {
            copy.field(quantity).copied()
        }
    }

    /// The value of a quantity, if it has one that does not go without saying
    /// ([`Quantity::goes_without_saying`]).
    pub fn said(&self, quantity: Quantity) -> Option<f64> {
        self.get(quantity)
            .filter(|value| !quantity.goes_without_saying(*value))
    }

    /// The field of a quantity; `None` for the coefficient of restitution, too, which may be
    /// absent.
    const fn field(&mut self, quantity: Quantity) -> Option<&mut f64> {
        let Self { hoop, start } = self;
        Some(match quantity {
            Quantity::DiscMassKg => &mut hoop.disc_mass_kg,
            Quantity::ParticleMassKg => &mut hoop.particle_mass_kg,
            Quantity::RadiusM => &mut hoop.radius_m,
            Quantity::OffsetM => &mut hoop.offset_m,
            Quantity::InertiaKgM2 => &mut hoop.inertia_kg_m2,
            Quantity::GravityMPerS2 => &mut hoop.gravity_m_per_s2,
            Quantity::MuS => &mut hoop.mu_s,
            Quantity::MuK => &mut hoop.mu_k,
            Quantity::RollingResistanceM => &mut hoop.rolling_resistance_m,
            Quantity::Slope => &mut hoop.slope,
            Quantity::Theta => &mut start.theta_rad,
            Quantity::ThetaRateRadPerS => &mut start.theta_rate_rad_per_s,
            Quantity::SlipMPerS => &mut start.slip_m_per_s,
            Quantity::GapRateMPerS => &mut start.gap_rate_m_per_s,
            Quantity::XM => &mut start.x_m,
            Quantity::TimeS => &mut start.time_s,
            Quantity::Restitution
            | Quantity::MassRatio
            | Quantity::Offset
            | Quantity::Inertia
            | Quantity::RollingResistance
            | Quantity::ThetaRate
            | Quantity::Slip
            | Quantity::GapRate
            | Quantity::X
            | Quantity::Time
            | Quantity::Until
            | Quantity::UntilS => return None,
        })
    }

    /// The dimensionless setup, with the hoop checked, and the units of the motion.
    ///
    /// # Errors
    /// As [`SiParameters::to_hoop`] and [`Units::start`].
    pub fn to_setup(&self) -> Result<(Setup, Units), ParameterError> {
        let (hoop, units) = self.hoop.to_hoop()?;
        Ok((
            Setup::new(hoop.parameters(), units.start(&self.start)?),
            units,
        ))
    }
}

impl Units {
    /// The dimensionless start.
    ///
    /// # Errors
    /// A value that is not finite; an angle out of bounds; a negative gap rate.
    pub fn start(&self, si: &SiState) -> Result<Start, ParameterError> {
        let plain = |quantity: Quantity, value: f64| -> Result<f64, ParameterError> {
            Ok(self.from_si(quantity.dimension(), quantity.check(value)?))
        };
        Ok(Start {
            time: plain(Quantity::TimeS, si.time_s)?,
            theta: plain(Quantity::Theta, si.theta_rad)?,
            theta_rate: plain(Quantity::ThetaRateRadPerS, si.theta_rate_rad_per_s)?,
            slip: plain(Quantity::SlipMPerS, si.slip_m_per_s)?,
            gap_rate: plain(Quantity::GapRateMPerS, si.gap_rate_m_per_s)?,
            x: plain(Quantity::XM, si.x_m)?,
        })
    }

    /// The dimensionless time limit of a motion from `start`.
    ///
    /// # Errors
    /// A limit that is not finite or before the start, in seconds.
    pub fn until(&self, until_s: f64, start: &Start) -> Result<f64, ParameterError> {
        let until = self.from_si(Dimension::Time, Quantity::UntilS.check(until_s)?);
        if until < start.time {
            let bound = Bound::AtLeast(Quantity::TimeS, self.to_si(Dimension::Time, start.time));
            return Err(ParameterError::OutOfBounds {
                quantity: Quantity::UntilS,
                value: until_s,
                bound,
            });
        }
        Ok(until)
    }

    /// A state in SI units.
    pub fn state(&self, state: &State) -> SiState {
        let si = |quantity: Quantity, value| self.to_si(quantity.dimension(), value);
        SiState {
            time_s: si(Quantity::TimeS, state.time),
            theta_rad: state.theta,
            theta_rate_rad_per_s: si(Quantity::ThetaRateRadPerS, state.theta_rate),
            slip_m_per_s: si(Quantity::SlipMPerS, state.slip),
            gap_rate_m_per_s: 0.0,
            x_m: si(Quantity::XM, state.x),
        }
    }
}
