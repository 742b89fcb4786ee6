//! The table of quantities that a user can set, the source of flags, scenario files, records, axes,
//! messages and the fields of the laboratory.
//!
//! A new quantity of a hoop or a start takes one row here, one field of [`crate::HoopParameters`]
//! or [`crate::Start`], and one line of [`crate::tables::Setup::field`].

use core::fmt;

use crate::model::{Dimension, Dimension as D, System, getters, named};

named! {
    /// A quantity that a user can set.
    pub enum Quantity, "quantity",
    /// Its row of the table.
    pub row: QuantityRow {
        /// Mass ratio m̂1 = m1/m2 of (2.9).
        MassRatio = 0, "mass_ratio" => row((DIMENSIONLESS, Group::Hoop, D::Mass, Some(Self::DiscMassKg)), ["m1/m2", "m₁/m₂"],
            (PARAMETER, Presence::Required, [0.0, 5.0]), "mass of the disc over mass of the particle",
            "Mass of the disc over that of the particle, m1/m2 >= 0")
            .with_hint("a massless hoop has mass 0; less is not possible");
        /// Offset ℓ̂ = ℓ/R of (2.9).
        Offset = 1, "offset" => row((DIMENSIONLESS, Group::Hoop, D::Length, Some(Self::OffsetM)), ["l/R", "ℓ/R"],
            (FRACTION, Presence::Required, [0.0, 1.0]), "distance of the particle from the centre over the radius",
            "Distance of the particle from the centre, l/R, 0 to 1")
            .with_hint("the particle sits on the rim or inside it: 0 <= offset <= radius");
        /// Moment of inertia Î_zz = I_zz/(m2 R²) of (2.9).
        Inertia = 2, "inertia" => row((DIMENSIONLESS, Group::Hoop, D::Inertia, Some(Self::InertiaKgM2)), ["Izz/(m2 R^2)", "Izz/(m₂R²)"],
            (PARAMETER, Presence::Required, [0.0, 5.0]), "moment of inertia of the disc about its centre over m2 R^2",
            "Moment of inertia of the disc about its centre, Izz/(m2 R^2) >= 0; 0 together with --mass-ratio 0 \
             is Littlewood's massless hoop")
            .with_hint("a thin hoop of mass m1 has Izz = m1 R^2, a uniform disc m1 R^2 / 2, a massless hoop 0");
        /// Coefficient of static friction μs of (2.13).
        MuS = 3, "mu_s" => row((DIMENSIONLESS, Group::Hoop, D::Ratio, None), ["mu_s", "μₛ"],
            (PARAMETER, Presence::Required, [0.0, 1.5]), "coefficient of static friction",
            "Coefficient of static friction (2.13), also with SI parameters")
            .with_hint("coefficients of friction are not negative: 0 <= mu_k <= mu_s");
        /// Coefficient of kinetic friction μk of (2.15).
        MuK = 4, "mu_k" => row((DIMENSIONLESS, Group::Hoop, D::Ratio, None), ["mu_k", "μₖ"],
            (PARAMETER, Presence::Required, [0.0, 1.5]), "coefficient of kinetic friction",
            "Coefficient of kinetic friction (2.15), 0 <= mu_k <= mu_s, also with SI parameters")
            .with_hint("kinetic friction is never stronger than static friction: 0 <= mu_k <= mu_s");
        /// Angle θ of the particle from the upward vertical.
        Theta = 5, "theta" => row((DIMENSIONLESS, Group::Start, D::Angle, None), ["theta", "θ"],
            (COORDINATE, Presence::Required, [-3.1, 6.2]), "angle of the particle from the upward vertical",
            "Angle theta of the particle from the upward normal of the plane, counterclockwise, also with SI \
             parameters");
        /// Rate θ′ = dθ/dτ.
        ThetaRate = 6, "theta_rate" => row((DIMENSIONLESS, Group::Start, D::AngularRate, Some(Self::ThetaRateRadPerS)), ["theta'", "θ′"],
            (RATE, Presence::Required, [-4.0, 4.0]), "rate of the angle",
            "Angular velocity theta' in sqrt(g/R)");
        /// Slip velocity η′ of (2.7).
        Slip = 7, "slip" => row((DIMENSIONLESS, Group::Start, D::Velocity, Some(Self::SlipMPerS)), ["eta'", "η′"],
            (RATE, Presence::Default(0.0), [-2.0, 2.0]), "slip velocity of the contact point",
            "Slip velocity eta' of the contact point (2.7) in sqrt(g R)");
        /// Position x of the geometric centre along the plane.
        X = 8, "x" => row((DIMENSIONLESS, Group::Place, D::Length, Some(Self::XM)), ["x", "x"],
            (COORDINATE, Presence::Default(0.0), [-10.0, 10.0]), "position of the geometric centre along the plane",
            "Position of the centre along the plane, in R");
        /// Time τ.
        Time = 9, "time" => row((DIMENSIONLESS, Group::Place, D::Time, Some(Self::TimeS)), ["tau", "τ"],
            (COORDINATE, Presence::Default(0.0), [-10.0, 10.0]), "time",
            "Time of the start, tau, in sqrt(R/g)");
        /// Time limit of a simulation.
        Until = 10, "until" => row((DIMENSIONLESS, Group::Run, D::Time, Some(Self::UntilS)), ["tau", "τ"],
            (TIME_LIMIT, Presence::Optional, [0.0, 50.0]), "time limit",
            "Stop at this time tau, in sqrt(R/g) [default: run to a final outcome]")
            .with_hint("the time limit is absolute, at or after the start, and its square is a number");
        /// Mass m1 of the disc or hoop in kilograms.
        DiscMassKg = 11, "disc_mass_kg" => row((SI, Group::Hoop, D::Mass, Some(Self::MassRatio)), ["m1", "m₁"],
            (NON_NEGATIVE, Presence::Required, [0.0, 2.0]), "mass of the disc or hoop",
            "Mass m1 of the disc or hoop, kg");
        /// Mass m2 of the particle in kilograms.
        ParticleMassKg = 12, "particle_mass_kg" => row((SI, Group::Units, D::Mass, None), ["m2", "m₂"],
            (POSITIVE, Presence::Required, [0.01, 2.0]), "mass of the particle",
            "Mass m2 of the particle, kg");
        /// Outer radius R in metres.
        RadiusM = 13, "radius_m" => row((SI, Group::Units, D::Length, None), ["R", "R"],
            (POSITIVE, Presence::Required, [0.05, 1.0]), "outer radius",
            "Outer radius R, m");
        /// Distance ℓ of the particle from the geometric centre in metres.
        OffsetM = 14, "offset_m" => row((SI, Group::Hoop, D::Length, Some(Self::Offset)), ["l", "ℓ"],
            (NON_NEGATIVE, Presence::Required, [0.0, 1.0]), "distance of the particle from the centre",
            "Distance l of the particle from the centre, m, 0 to R");
        /// Moment of inertia I_zz in kilogram square metres.
        InertiaKgM2 = 15, "inertia_kg_m2" => row((SI, Group::Hoop, D::Inertia, Some(Self::Inertia)), ["Izz", "Izz"],
            (NON_NEGATIVE, Presence::Required, [0.0, 0.5]), "moment of inertia of the disc about its centre",
            "Moment of inertia Izz of the disc about its centre, kg m^2");
        /// Gravitational acceleration g in metres per second squared.
        GravityMPerS2 = 16, "gravity_m_per_s2" => row((SI, Group::Units, D::Acceleration, None), ["g", "g"],
            (POSITIVE, Presence::Default(STANDARD_GRAVITY), [0.5, 25.0]), "gravitational acceleration",
            "Gravitational acceleration g, m/s^2");
        /// Rate dθ/dt in radians per second.
        ThetaRateRadPerS = 17, "theta_rate_rad_per_s" => row((SI, Group::Start, D::AngularRate, Some(Self::ThetaRate)),
            ["d theta/dt", "dθ/dt"], (FINITE, Presence::Required, [-20.0, 20.0]), "rate of the angle",
            "Angular velocity d theta/dt, rad/s");
        /// Slip velocity dη/dt in metres per second.
        SlipMPerS = 18, "slip_m_per_s" => row((SI, Group::Start, D::Velocity, Some(Self::Slip)), ["d eta/dt", "dη/dt"],
            (FINITE, Presence::Default(0.0), [-5.0, 5.0]), "slip velocity of the contact point",
            "Slip velocity of the contact point, m/s");
        /// Position along the plane in metres.
        XM = 19, "x_m" => row((SI, Group::Place, D::Length, Some(Self::X)), ["x", "x"],
            (FINITE, Presence::Default(0.0), [-10.0, 10.0]), "position of the geometric centre along the plane",
            "Position of the centre along the plane, m");
        /// Time in seconds.
        TimeS = 20, "time_s" => row((SI, Group::Place, D::Time, Some(Self::Time)), ["t", "t"],
            (FINITE, Presence::Default(0.0), [-10.0, 10.0]), "time",
            "Time of the start, s");
        /// Time limit in seconds.
        UntilS = 21, "until_s" => row((SI, Group::Run, D::Time, Some(Self::Until)), ["t", "t"],
            (FINITE, Presence::Optional, [0.0, 10.0]), "time limit",
            "Stop at this time, s");
        /// Coefficient of restitution e of an impact.
        Restitution = 22, "restitution" => row((DIMENSIONLESS, Group::Hoop, D::Ratio, None), ["e", "e"],
            (FRACTION, Presence::Optional, [0.0, 1.0]), "coefficient of restitution",
            "Coefficient of restitution of the rim on the plane, 0 to 1, also with SI parameters; without it the \
             motion ends where the rim lands")
            .with_hint("0 is an impact without rebound, 1 one that gives everything back");
        /// Rate at which the gap under the rim opens.
        GapRate = 23, "gap_rate" => row((DIMENSIONLESS, Group::Start, D::Velocity, Some(Self::GapRateMPerS)), ["gap'", "gap′"],
            (NON_NEGATIVE_RATE, Presence::Default(0.0), [0.0, 3.0]), "rate at which the gap under the rim opens",
            "Rate at which the rim leaves the plane, in sqrt(g R)")
            .with_hint("the rim starts at the plane and can only leave it");
        /// Rate at which the gap opens in metres per second.
        GapRateMPerS = 24, "gap_rate_m_per_s" => row((SI, Group::Start, D::Velocity, Some(Self::GapRate)), ["d gap/dt", "d gap/dt"],
            (NON_NEGATIVE, Presence::Default(0.0), [0.0, 5.0]), "rate at which the gap under the rim opens",
            "Rate at which the rim leaves the plane, m/s");
        /// Angle α by which the plane rises to the right.
        Slope = 25, "slope" => row((DIMENSIONLESS, Group::Hoop, D::Angle, None), ["alpha", "α"],
            (SLOPE, Presence::Default(0.0), [-1.0, 1.0]), "angle by which the plane rises to the right",
            "Angle by which the plane rises to the right, in radians, between -pi/2 and pi/2, also with SI \
             parameters")
            .with_hint("a slope is an angle in radians: 30 degrees are 0.5236");
        /// Coefficient χ of rolling resistance, a length over the radius.
        RollingResistance = 26, "rolling_resistance" => row((DIMENSIONLESS, Group::Hoop, D::Length, Some(Self::RollingResistanceM)), ["chi", "χ"],
            (PARAMETER, Presence::Default(0.0), [0.0, 0.2]), "coefficient of rolling resistance over the radius",
            "Coefficient of rolling resistance, a length over R: the plane resists the rotation with a couple of \
             up to chi N")
            .with_hint("rolling resistance is not negative: 0 is a hoop that rolls for ever");
        /// Coefficient of rolling resistance in metres.
        RollingResistanceM = 27, "rolling_resistance_m" => row((SI, Group::Hoop, D::Length, Some(Self::RollingResistance)), ["chi", "χ"],
            (NON_NEGATIVE, Presence::Default(0.0), [0.0, 0.1]), "coefficient of rolling resistance",
            "Coefficient of rolling resistance, m");
    }
}

/// Whether a quantity must be given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Presence {
    /// Must be given.
    Required,
    /// Has a default.
    Default(f64),
    /// May be absent, without a default.
    Optional,
}

impl Presence {
    /// The default, if any.
    pub const fn default_value(self) -> Option<f64> {
        match self {
            Self::Default(value) => Some(value),
            Self::Required | Self::Optional => None,
        }
    }
}

named! {
    /// Group of a quantity.
    pub enum Group, "group of quantities" {
        /// The body and its friction.
        Hoop = 0, "hoop";
        /// The initial motion.
        Start = 1, "start";
        /// Position and time of the start, on which the motion does not depend.
        Place = 2, "place";
        /// The units of (2.9).
        Units = 3, "units";
        /// The time limit.
        Run = 4, "run";
    }
}

/// A row of the table of quantities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuantityRow {
    /// Group.
    pub group: Group,
    /// Dimension.
    pub dimension: Dimension,
    /// System of units. Angles and ratios have the same value in both systems and are listed as
    /// dimensionless.
    pub system: System,
    /// The quantity in the other system; `None` if its value is the same in both, or it exists in
    /// one only.
    pub twin: Option<Quantity>,
    /// Symbol in plain letters.
    pub symbol: &'static str,
    /// Typeset symbol.
    pub sign: &'static str,
    /// Description for files.
    pub long_name: &'static str,
    /// Help text of the flag.
    pub help: &'static str,
    /// Bounds in addition to finiteness, in the order of the checks.
    pub bounds: &'static [Bound],
    /// Whether it must be given.
    pub presence: Presence,
    /// Usual range, for controls.
    pub usual: [f64; 2],
    /// Advice for a value out of bounds.
    pub hint: &'static str,
}

/// A bound on a value.
#[derive(Clone, Copy, Debug, PartialEq)]
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
    /// The magnitude must not exceed a constant, beyond which a double does not resolve the motion.
    MagnitudeAtMost(f64),
    /// The same of a value that is not negative.
    ResolvedAtMost(f64),
    /// The magnitude must be less than a constant.
    MagnitudeBelow(f64),
    /// The value must not be less than that of another quantity.
    AtLeast(Quantity, f64),
}

impl Bound {
    /// Whether a value satisfies the bound.
    #[inline(always)]
    pub const fn allows(&self, value: f64) -> bool {
        match *self {
            Self::Finite => value.is_finite(),
            Self::Positive => value > 0.0,
            Self::NonNegative => value >= 0.0,
            Self::AtMost(_, most) | Self::AtMostConstant(most) | Self::ResolvedAtMost(most) => {
                value <= most
            }
            Self::MagnitudeAtMost(most) => value.abs() <= most,
            Self::MagnitudeBelow(bound) => value.abs() < bound,
            Self::AtLeast(_, least) => value >= least,
        }
    }
}

impl fmt::Display for Bound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Finite => f.write_str("must be a finite number"),
            Self::Positive => f.write_str("must be greater than 0"),
            Self::NonNegative => f.write_str("must not be negative"),
            Self::AtMost(quantity, value) => {
                write!(f, "must not exceed {}", Reading(*quantity, *value))
            }
            Self::AtMostConstant(value) => write!(f, "must not exceed {}", Number(*value)),
            Self::MagnitudeAtMost(value) => {
                write!(f, "must lie between {:e} and {value:e}", -value)
            }
            Self::ResolvedAtMost(value) => write!(f, "must not exceed {value:e}"),
            Self::MagnitudeBelow(value) => {
                write!(f, "must lie between -{value} and {value}, exclusive")
            }
            Self::AtLeast(quantity, value) => {
                write!(f, "must not be less than {}", Reading(*quantity, *value))
            }
        }
    }
}

/// A quantity with its value and unit.
pub(crate) struct Reading(pub(crate) Quantity, pub(crate) f64);

impl fmt::Display for Reading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(quantity, value) = self;
        match quantity.unit() {
            "" => write!(f, "{quantity} = {}", Number(*value)),
            unit => write!(f, "{quantity} = {} {unit}", Number(*value)),
        }
    }
}

/// A number in messages: all digits, with an exponent for very small and very large values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Number(pub f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = self;
        if *value == 0.0 || !value.is_finite() || (1e-5..1e15).contains(&value.abs()) {
            write!(f, "{value}")
        } else {
            write!(f, "{value:e}")
        }
    }
}

/// Standard acceleration of free fall, m/s².
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Largest parameter of a hoop: products of larger ones lose accuracy.
const MAX_PARAMETER: f64 = 1e9;

/// Largest time, angle and position of a start: doubles resolve 1e-7 there.
pub(crate) const MAX_COORDINATE: f64 = 1e9;

/// Largest rate and slip velocity of a start: a flight at this rate turns 1e11 times.
const MAX_RATE: f64 = 1e6;

const PARAMETER: &[Bound] = &[Bound::NonNegative, Bound::ResolvedAtMost(MAX_PARAMETER)];
const COORDINATE: &[Bound] = &[Bound::MagnitudeAtMost(MAX_COORDINATE)];
/// Longest time that is followed: the position of a slide grows with its square, which is a number.
pub(crate) const MAX_TIME: f64 = 1e150;
const TIME_LIMIT: &[Bound] = &[Bound::MagnitudeAtMost(MAX_TIME)];
const RATE: &[Bound] = &[Bound::MagnitudeAtMost(MAX_RATE)];
/// |slope| < π/2, up to the last double below: the plane is not vertical.
const SLOPE: &[Bound] = &[Bound::MagnitudeBelow(core::f64::consts::FRAC_PI_2)];
const FRACTION: &[Bound] = &[Bound::NonNegative, Bound::AtMostConstant(1.0)];
const NON_NEGATIVE_RATE: &[Bound] = &[Bound::NonNegative, Bound::ResolvedAtMost(MAX_RATE)];
const POSITIVE: &[Bound] = &[Bound::Positive];
const NON_NEGATIVE: &[Bound] = &[Bound::NonNegative];
const FINITE: &[Bound] = &[];

const DIMENSIONLESS: System = System::Dimensionless;
const SI: System = System::Si;

/// A row: system, group, dimension and twin; symbols; bounds, presence and usual range; texts for
/// files and help.
const fn row(
    (system, group, dimension, twin): (System, Group, Dimension, Option<Quantity>),
    [symbol, sign]: [&'static str; 2],
    (bounds, presence, usual): (&'static [Bound], Presence, [f64; 2]),
    long_name: &'static str,
    help: &'static str,
) -> QuantityRow {
    let hint =
        "see the units in the message; every value is dimensionless unless its name ends in a unit";
    QuantityRow {
        group,
        dimension,
        system,
        twin,
        symbol,
        sign,
        long_name,
        help,
        bounds,
        presence,
        usual,
        hint,
    }
}

impl QuantityRow {
    const fn with_hint(self, hint: &'static str) -> Self {
        Self { hint, ..self }
    }
}

getters! {
    Quantity, self:
    /// Bounds in addition to finiteness, in the order of the checks.
    #[inline(always)]
    pub bounds: &'static [Bound] = self.row().bounds;
    /// Group.
    pub group: Group = self.row().group;
    /// Dimension.
    pub dimension: Dimension = self.row().dimension;
    /// Symbol of the paper, in plain letters.
    pub symbol: &'static str = self.row().symbol;
    /// Symbol of the paper, typeset.
    pub sign: &'static str = self.row().sign;
    /// Description.
    pub long_name: &'static str = self.row().long_name;
    /// Whether the quantity is in SI units. False for θ, μs and μk, which have the same values in
    /// both systems.
    pub is_si: bool = matches!(self.row().system, System::Si);
}

impl Quantity {
    /// The dimensionless parameters of a hoop.
    pub const HOOP: [Self; 8] = [
        Self::MassRatio,
        Self::Offset,
        Self::Inertia,
        Self::MuS,
        Self::MuK,
        Self::RollingResistance,
        Self::Slope,
        Self::Restitution,
    ];

    /// The dimensionless quantities of a start.
    pub const START: [Self; 6] = [
        Self::Theta,
        Self::ThetaRate,
        Self::Slip,
        Self::GapRate,
        Self::X,
        Self::Time,
    ];

    /// The quantities that determine a motion and that a sweep can vary, in the order of tables.
    pub const AXES: [Self; 12] = [
        Self::Theta,
        Self::ThetaRate,
        Self::Slip,
        Self::GapRate,
        Self::MassRatio,
        Self::Offset,
        Self::Inertia,
        Self::MuS,
        Self::MuK,
        Self::RollingResistance,
        Self::Slope,
        Self::Restitution,
    ];

    /// The quantities of a hoop in SI units, including the units of (2.9).
    pub const SI_HOOP: [Self; 11] = [
        Self::DiscMassKg,
        Self::ParticleMassKg,
        Self::RadiusM,
        Self::OffsetM,
        Self::InertiaKgM2,
        Self::GravityMPerS2,
        Self::MuS,
        Self::MuK,
        Self::RollingResistanceM,
        Self::Slope,
        Self::Restitution,
    ];

    /// The quantities of a start in SI units.
    pub const SI_START: [Self; 6] = [
        Self::Theta,
        Self::ThetaRateRadPerS,
        Self::SlipMPerS,
        Self::GapRateMPerS,
        Self::XM,
        Self::TimeS,
    ];

    /// Whether a value goes without saying, and is left out of records and captions: no rolling
    /// resistance, no slope, no opening gap.
    pub const fn goes_without_saying(self, value: f64) -> bool {
        matches!(
            self,
            Self::RollingResistance
                | Self::RollingResistanceM
                | Self::Slope
                | Self::GapRate
                | Self::GapRateMPerS
        ) && value.to_bits() == 0
    }

    /// Whether the quantity is a ratio, as the parameters of (2.9) are.
    const fn is_ratio(self) -> bool {
        match self.row().group {
            Group::Hoop => !self.is_si() && !matches!(self.dimension(), Dimension::Angle),
            Group::Start | Group::Place | Group::Units | Group::Run => false,
        }
    }

    /// Unit, in plain letters; empty for a ratio.
    pub const fn unit(self) -> &'static str {
        self.of_units(self.dimension().scale(), self.dimension().si_unit())
    }

    /// Typeset unit; empty for a ratio.
    pub const fn unit_sign(self) -> &'static str {
        self.of_units(self.dimension().scale_sign(), self.dimension().si_sign())
    }

    /// The unit of (2.9) or the SI unit, by the system of the quantity; empty for a ratio.
    const fn of_units(self, scale: &'static str, si: &'static str) -> &'static str {
        if self.is_ratio() || matches!(self.dimension(), Dimension::Ratio) {
            ""
        } else if self.is_si() || matches!(self.dimension(), Dimension::Angle) {
            si
        } else {
            scale
        }
    }

    /// The dimensionless quantity of (2.9); `self` if it is dimensionless or has no twin.
    #[must_use]
    pub const fn dimensionless(self) -> Self {
        match (self.is_si(), self.row().twin) {
            (true, Some(twin)) => twin,
            (true, None) | (false, _) => self,
        }
    }

    /// The quantity in SI units; `None` if `self` is in SI units, or the same in both systems.
    pub const fn si_twin(self) -> Option<Self> {
        if self.is_si() { None } else { self.row().twin }
    }

    /// Advice for a value out of bounds.
    pub(crate) const fn hint(self) -> &'static str {
        self.dimensionless().row().hint
    }
}
