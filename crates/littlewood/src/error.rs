//! What is wrong with a parameter: the quantity, its value, the bound it breaks and its unit.

use core::fmt;

use thiserror::Error;

/// A quantity that a user can set, with the name, symbol and unit that messages show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Quantity {
    /// Mass ratio m̂1 = m1/m2 of (2.9).
    MassRatio,
    /// Offset ℓ̂ = ℓ/R of (2.9).
    Offset,
    /// Moment of inertia Î_zz = I_zz/(m2 R²) of (2.9).
    Inertia,
    /// Coefficient of static friction μs of (2.13).
    MuS,
    /// Coefficient of kinetic friction μk of (2.15).
    MuK,
    /// Angle θ of the particle from the upward vertical.
    Theta,
    /// Rate θ′ = dθ/dτ.
    ThetaRate,
    /// Slip velocity η′ of (2.7).
    Slip,
    /// Horizontal position x of the geometric centre.
    X,
    /// Time τ.
    Time,
    /// Time limit of a simulation.
    Until,
    /// Mass m1 of the disc or hoop in kilograms.
    DiscMassKg,
    /// Mass m2 of the particle in kilograms.
    ParticleMassKg,
    /// Outer radius R in metres.
    RadiusM,
    /// Distance ℓ of the particle from the geometric centre in metres.
    OffsetM,
    /// Moment of inertia I_zz in kilogram square metres.
    InertiaKgM2,
    /// Gravitational acceleration g in metres per second squared.
    GravityMPerS2,
    /// Rate dθ/dt in radians per second.
    ThetaRateRadPerS,
    /// Slip velocity dη/dt in metres per second.
    SlipMPerS,
    /// Horizontal position in metres.
    XM,
    /// Time in seconds.
    TimeS,
    /// Time limit in seconds.
    UntilS,
}

impl Quantity {
    /// Name as it is written in files and flags (with underscores).
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.description().0
    }

    /// Symbol of the paper.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        self.description().1
    }

    /// Unit; empty for a ratio.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        self.description().2
    }

    const fn description(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::MassRatio => ("mass_ratio", "m1/m2", ""),
            Self::Offset => ("offset", "l/R", ""),
            Self::Inertia => ("inertia", "Izz/(m2 R^2)", ""),
            Self::MuS => ("mu_s", "mu_s", ""),
            Self::MuK => ("mu_k", "mu_k", ""),
            Self::Theta => ("theta", "theta", "rad"),
            Self::ThetaRate => ("theta_rate", "theta'", "sqrt(g/R) rad"),
            Self::Slip => ("slip", "eta'", "sqrt(g R)"),
            Self::X => ("x", "x", "R"),
            Self::Time => ("time", "tau", "sqrt(R/g)"),
            Self::Until => ("until", "tau", "sqrt(R/g)"),
            Self::DiscMassKg => ("disc_mass_kg", "m1", "kg"),
            Self::ParticleMassKg => ("particle_mass_kg", "m2", "kg"),
            Self::RadiusM => ("radius_m", "R", "m"),
            Self::OffsetM => ("offset_m", "l", "m"),
            Self::InertiaKgM2 => ("inertia_kg_m2", "Izz", "kg m^2"),
            Self::GravityMPerS2 => ("gravity_m_per_s2", "g", "m/s^2"),
            Self::ThetaRateRadPerS => ("theta_rate_rad_per_s", "d theta/dt", "rad/s"),
            Self::SlipMPerS => ("slip_m_per_s", "d eta/dt", "m/s"),
            Self::XM => ("x_m", "x", "m"),
            Self::TimeS => ("time_s", "t", "s"),
            Self::UntilS => ("until_s", "t", "s"),
        }
    }
}

impl fmt::Display for Quantity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The bound that a value breaks.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Bound {
    /// The value must be a finite number.
    Finite,
    /// The value must be greater than zero.
    Positive,
    /// The value must be zero or greater.
    NonNegative,
    /// The value must not exceed that of another quantity.
    AtMost(Quantity, f64),
    /// The value must not exceed a constant.
    AtMostConstant(f64),
    /// The magnitude must not exceed a constant.
    MagnitudeAtMost(f64),
    /// The value must not be less than that of another quantity.
    AtLeast(Quantity, f64),
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Finite => f.write_str("must be a finite number"),
            Self::Positive => f.write_str("must be greater than 0"),
            Self::NonNegative => f.write_str("must not be negative"),
            Self::AtMost(quantity, value) => write!(f, "must not exceed {}", Reading(*quantity, *value)),
            Self::AtMostConstant(value) => write!(f, "must not exceed {value}"),
            Self::MagnitudeAtMost(value) => write!(f, "must lie between {:e} and {value:e}", -value),
            Self::AtLeast(quantity, value) => {
                write!(f, "must not be less than {}", Reading(*quantity, *value))
            }
        }
    }
}

struct Reading(Quantity, f64);

impl fmt::Display for Reading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(quantity, value) = self;
        match quantity.unit() {
            "" => write!(f, "{quantity} = {value}"),
            unit => write!(f, "{quantity} = {value} {unit}"),
        }
    }
}

/// A parameter of a hoop or of a start that has no physical meaning.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
#[non_exhaustive]
pub enum ParameterError {
    /// One value breaks one bound.
    #[error("{} {bound}", Reading(*quantity, *value))]
    OutOfBounds {
        /// The quantity that was given.
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// The bound it breaks.
        bound: Bound,
    },
    /// A single point mass at the centre: nothing resists or drives a rotation, so there is no motion.
    #[error(
        "offset = 0 and moment of inertia = 0 (mass_ratio = {mass_ratio}, inertia = 0): \
         a point mass at the centre of the hoop has no equation of motion"
    )]
    NoMotion {
        /// The mass ratio that was given.
        mass_ratio: f64,
    },
}

impl ParameterError {
    /// Advice for the person who typed the value.
    #[must_use]
    pub fn hint(&self) -> &'static str {
        match self {
            Self::NoMotion { .. } => "give the disc a moment of inertia, or move the particle off the centre",
            Self::OutOfBounds { bound: Bound::Finite, .. } => {
                "NaN and infinities are not numbers to start from"
            }
            Self::OutOfBounds { bound: Bound::MagnitudeAtMost(_), .. } => {
                "beyond this bound a double no longer resolves the motion"
            }
            Self::OutOfBounds { quantity, .. } => match quantity {
                Quantity::MuK => "kinetic friction is never stronger than static friction: 0 <= mu_k <= mu_s",
                Quantity::MuS => "coefficients of friction are not negative: 0 <= mu_k <= mu_s",
                Quantity::Offset | Quantity::OffsetM => {
                    "the particle sits on the rim or inside it: 0 <= offset <= radius"
                }
                Quantity::Inertia | Quantity::InertiaKgM2 => {
                    "a thin hoop of mass m1 has Izz = m1 R^2, a uniform disc m1 R^2 / 2, a massless hoop 0"
                }
                Quantity::MassRatio | Quantity::DiscMassKg => {
                    "a massless hoop has mass 0; less is not possible"
                }
                Quantity::Until | Quantity::UntilS => {
                    "the time limit is absolute: it lies at or after the start"
                }
                _ => {
                    "see the units in the message; every value is dimensionless unless its name ends in a unit"
                }
            },
        }
    }
}

/// Refuses NaN and infinities.
pub(crate) fn finite(quantity: Quantity, value: f64) -> Result<f64, ParameterError> {
    check(value.is_finite(), quantity, value, Bound::Finite)
}

/// Refuses everything but finite numbers greater than zero.
pub(crate) fn positive(quantity: Quantity, value: f64) -> Result<f64, ParameterError> {
    finite(quantity, value)?;
    check(value > 0.0, quantity, value, Bound::Positive)
}

/// Refuses everything but finite numbers that are zero or greater.
pub(crate) fn non_negative(quantity: Quantity, value: f64) -> Result<f64, ParameterError> {
    finite(quantity, value)?;
    check(value >= 0.0, quantity, value, Bound::NonNegative)
}

/// Refuses NaN and magnitudes at which doubles no longer resolve the motion.
pub(crate) fn moderate(quantity: Quantity, value: f64, limit: f64) -> Result<f64, ParameterError> {
    finite(quantity, value)?;
    check(value.abs() <= limit, quantity, value, Bound::MagnitudeAtMost(limit))
}

/// Passes `value` on when the condition holds.
pub(crate) fn check(
    holds: bool,
    quantity: Quantity,
    value: f64,
    bound: Bound,
) -> Result<f64, ParameterError> {
    if holds { Ok(value) } else { Err(ParameterError::OutOfBounds { quantity, value, bound }) }
}
