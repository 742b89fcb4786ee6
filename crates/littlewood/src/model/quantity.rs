//! The quantities that a user can set: one table from which flags, scenario files, records, axes, messages and the
//! fields of the laboratory derive.
//!
//! A new quantity of a hoop or a start is one row here, one field of [`crate::HoopParameters`] or
//! [`crate::Start`], and one line of [`crate::tables::Setup::place`].

use core::fmt;

use crate::model::{Dimension, Dimension as D, System, named};

named! {
    /// A quantity that a user can set.
    pub enum Quantity, "quantity",
    /// Its row of the table.
    pub row: QuantityRow {
        /// Mass ratio m̂1 = m1/m2 of (2.9).
        MassRatio = 0, "mass_ratio" => row((PLAIN, Group::Hoop, D::Mass, Some(Self::DiscMassKg)), ["m1/m2", "m₁/m₂"],
            (PARAMETER, Presence::Required, [0.0, 5.0]), "mass of the disc over mass of the particle",
            "Mass of the disc over that of the particle, m1/m2 >= 0");
        /// Offset ℓ̂ = ℓ/R of (2.9).
        Offset = 1, "offset" => row((PLAIN, Group::Hoop, D::Length, Some(Self::OffsetM)), ["l/R", "ℓ/R"],
            (PART, Presence::Required, [0.0, 1.0]), "distance of the particle from the centre over the radius",
            "Distance of the particle from the centre, l/R, 0 to 1");
        /// Moment of inertia Î_zz = I_zz/(m2 R²) of (2.9).
        Inertia = 2, "inertia" => row((PLAIN, Group::Hoop, D::Inertia, Some(Self::InertiaKgM2)), ["Izz/(m2 R^2)", "Izz/(m₂R²)"],
            (PARAMETER, Presence::Required, [0.0, 5.0]), "moment of inertia of the disc about its centre over m2 R^2",
            "Moment of inertia of the disc about its centre, Izz/(m2 R^2) >= 0; 0 together with --mass-ratio 0 \
             is Littlewood's massless hoop");
        /// Coefficient of static friction μs of (2.13).
        MuS = 3, "mu_s" => row((PLAIN, Group::Hoop, D::Ratio, None), ["mu_s", "μₛ"],
            (PARAMETER, Presence::Required, [0.0, 1.5]), "coefficient of static friction",
            "Coefficient of static friction (2.13), with SI parameters too");
        /// Coefficient of kinetic friction μk of (2.15).
        MuK = 4, "mu_k" => row((PLAIN, Group::Hoop, D::Ratio, None), ["mu_k", "μₖ"],
            (PARAMETER, Presence::Required, [0.0, 1.5]), "coefficient of kinetic friction",
            "Coefficient of kinetic friction (2.15), from 0 to that of static friction, with SI parameters too");
        /// Angle θ of the particle from the upward vertical.
        Theta = 5, "theta" => row((PLAIN, Group::Start, D::Angle, None), ["theta", "θ"],
            (COORDINATE, Presence::Required, [-3.1, 6.2]), "angle of the particle from the upward vertical",
            "Angle theta of the particle from the upward vertical, counterclockwise, with SI parameters too");
        /// Rate θ′ = dθ/dτ.
        ThetaRate = 6, "theta_rate" => row((PLAIN, Group::Start, D::AngularRate, Some(Self::ThetaRateRadPerS)), ["theta'", "θ′"],
            (RATE, Presence::Required, [-4.0, 4.0]), "rate of the angle",
            "Rate theta' in sqrt(g/R) rad");
        /// Slip velocity η′ of (2.7).
        Slip = 7, "slip" => row((PLAIN, Group::Start, D::Velocity, Some(Self::SlipMPerS)), ["eta'", "η′"],
            (RATE, Presence::Default(0.0), [-2.0, 2.0]), "slip velocity of the contact point",
            "Slip velocity eta' of the contact point (2.7) in sqrt(g R)");
        /// Horizontal position x of the geometric centre.
        X = 8, "x" => row((PLAIN, Group::Place, D::Length, Some(Self::XM)), ["x", "x"],
            (COORDINATE, Presence::Default(0.0), [-10.0, 10.0]), "horizontal position of the geometric centre",
            "Horizontal position of the centre in R");
        /// Time τ.
        Time = 9, "time" => row((PLAIN, Group::Place, D::Time, Some(Self::TimeS)), ["tau", "τ"],
            (COORDINATE, Presence::Default(0.0), [-10.0, 10.0]), "time",
            "Time of the start, tau, in sqrt(R/g)");
        /// Time limit of a simulation.
        Until = 10, "until" => row((PLAIN, Group::Run, D::Time, Some(Self::UntilS)), ["tau", "τ"],
            (FINITE, Presence::Optional, [0.0, 50.0]), "time limit",
            "Stop at this time tau, in sqrt(R/g) [default: run to a final outcome]");
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
            "Rate d theta/dt, rad/s");
        /// Slip velocity dη/dt in metres per second.
        SlipMPerS = 18, "slip_m_per_s" => row((SI, Group::Start, D::Velocity, Some(Self::Slip)), ["d eta/dt", "dη/dt"],
            (FINITE, Presence::Default(0.0), [-5.0, 5.0]), "slip velocity of the contact point",
            "Slip velocity of the contact point, m/s");
        /// Horizontal position in metres.
        XM = 19, "x_m" => row((SI, Group::Place, D::Length, Some(Self::X)), ["x", "x"],
            (FINITE, Presence::Default(0.0), [-10.0, 10.0]), "horizontal position of the geometric centre",
            "Horizontal position of the centre, m");
        /// Time in seconds.
        TimeS = 20, "time_s" => row((SI, Group::Place, D::Time, Some(Self::Time)), ["t", "t"],
            (FINITE, Presence::Default(0.0), [-10.0, 10.0]), "time",
            "Time of the start, s");
        /// Time limit in seconds.
        UntilS = 21, "until_s" => row((SI, Group::Run, D::Time, Some(Self::Until)), ["t", "t"],
            (FINITE, Presence::Optional, [0.0, 10.0]), "time limit",
            "Stop at this time in SI units, s");
        /// Coefficient of restitution e of an impact.
        Restitution = 22, "restitution" => row((PLAIN, Group::Hoop, D::Ratio, None), ["e", "e"],
            (PART, Presence::Optional, [0.0, 1.0]), "coefficient of restitution",
            "Coefficient of restitution of the impact of the rim on the plane, 0 to 1, with SI parameters too; \
             without it the motion ends where the rim lands");
        /// Rate at which the gap under the rim opens.
        GapRate = 23, "gap_rate" => row((PLAIN, Group::Start, D::Velocity, Some(Self::GapRateMPerS)), ["gap'", "gap′"],
            (OPENING, Presence::Default(0.0), [0.0, 3.0]), "rate at which the gap under the rim opens",
            "Rate at which the rim leaves the plane, in sqrt(g R)");
        /// Rate at which the gap opens in metres per second.
        GapRateMPerS = 24, "gap_rate_m_per_s" => row((SI, Group::Start, D::Velocity, Some(Self::GapRate)), ["d gap/dt", "d gap/dt"],
            (NON_NEGATIVE, Presence::Default(0.0), [0.0, 5.0]), "rate at which the gap under the rim opens",
            "Rate at which the rim leaves the plane, m/s");
    }
}

/// What holds where a quantity is not given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Presence {
    /// It must be given.
    Required,
    /// It is this.
    Default(f64),
    /// There is none, which has a meaning of its own.
    Optional,
}

impl Presence {
    /// The value that is assumed, if there is one.
    #[must_use]
    pub const fn default_value(self) -> Option<f64> {
        match self {
            Self::Default(value) => Some(value),
            Self::Required | Self::Optional => None,
        }
    }
}

named! {
    /// What a quantity belongs to.
    pub enum Group, "group of quantities" {
        /// The body and its friction.
        Hoop = 0, "hoop";
        /// The motion with which it starts.
        Start = 1, "start";
        /// Where and when it starts, which no motion depends on.
        Place = 2, "place";
        /// The units of (2.9).
        Units = 3, "units";
        /// When to stop.
        Run = 4, "run";
    }
}

/// A row of the table of quantities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct QuantityRow {
    /// What it belongs to.
    pub group: Group,
    /// Its dimension.
    pub dimension: Dimension,
    /// The system that a number of this name is in. An angle and a ratio are the same number in both, and are listed
    /// as dimensionless.
    pub system: System,
    /// The same quantity in the other system; none where the number is the same in both, or exists in one only.
    pub twin: Option<Quantity>,
    /// Symbol in plain letters.
    pub symbol: &'static str,
    /// Symbol as it is printed.
    pub sign: &'static str,
    /// What it is, as files say it.
    pub long_name: &'static str,
    /// What it is, as the help of a flag says it.
    pub help: &'static str,
    /// Bounds besides being a finite number, in the order in which they are checked.
    pub bounds: &'static [Bound],
    /// What holds where it is not given.
    pub presence: Presence,
    /// Range in which a person usually sets it.
    pub usual: [f64; 2],
}

/// The bound that a value breaks.
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
    /// The magnitude must not exceed a constant.
    MagnitudeAtMost(f64),
    /// The value must not be less than that of another quantity.
    AtLeast(Quantity, f64),
}

impl Bound {
    /// Whether a value keeps it.
    #[inline(always)]
    #[must_use]
    pub const fn allows(&self, value: f64) -> bool {
        match *self {
            Self::Finite => value.is_finite(),
            Self::Positive => value > 0.0,
            Self::NonNegative => value >= 0.0,
            Self::AtMost(_, most) | Self::AtMostConstant(most) => value <= most,
            Self::MagnitudeAtMost(most) => value.abs() <= most,
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
            Self::AtMost(quantity, value) => write!(f, "must not exceed {}", Reading(*quantity, *value)),
            Self::AtMostConstant(value) => write!(f, "must not exceed {}", Number(*value)),
            Self::MagnitudeAtMost(value) => write!(f, "must lie between {:e} and {value:e}", -value),
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

/// A number as messages show it: with all its digits, and with an exponent where it would fill the line with zeros.
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

/// Largest parameter of a hoop: beyond it products of parameters leave the range in which they are exact to rounding.
const LARGEST_PARAMETER: f64 = 1e9;

/// Largest time, angle and position of a start: there doubles still resolve 1e-7.
const LARGEST_COORDINATE: f64 = 1e9;

/// Largest rate and slip velocity of a start: a flight at this rate turns 1e11 times.
const LARGEST_RATE: f64 = 1e6;

const PARAMETER: &[Bound] = &[Bound::NonNegative, Bound::MagnitudeAtMost(LARGEST_PARAMETER)];
const COORDINATE: &[Bound] = &[Bound::MagnitudeAtMost(LARGEST_COORDINATE)];
const RATE: &[Bound] = &[Bound::MagnitudeAtMost(LARGEST_RATE)];
const PART: &[Bound] = &[Bound::NonNegative, Bound::AtMostConstant(1.0)];
const OPENING: &[Bound] = &[Bound::NonNegative, Bound::MagnitudeAtMost(LARGEST_RATE)];
const POSITIVE: &[Bound] = &[Bound::Positive];
const NON_NEGATIVE: &[Bound] = &[Bound::NonNegative];
const FINITE: &[Bound] = &[];

const PLAIN: System = System::Dimensionless;
const SI: System = System::Si;

/// A row: place in the table, symbols, bounds with presence and usual range, and what the quantity is for files and for help.
const fn row(
    (system, group, dimension, twin): (System, Group, Dimension, Option<Quantity>),
    [symbol, sign]: [&'static str; 2],
    (bounds, presence, usual): (&'static [Bound], Presence, [f64; 2]),
    long_name: &'static str,
    help: &'static str,
) -> QuantityRow {
    QuantityRow { group, dimension, system, twin, symbol, sign, long_name, help, bounds, presence, usual }
}

impl Quantity {
    /// The parameters of a hoop, without dimension.
    pub const HOOP: [Self; 6] =
        [Self::MassRatio, Self::Offset, Self::Inertia, Self::MuS, Self::MuK, Self::Restitution];

    /// The numbers of a start, without dimension.
    pub const START: [Self; 6] =
        [Self::Theta, Self::ThetaRate, Self::Slip, Self::GapRate, Self::X, Self::Time];

    /// What a motion depends on, and what a sweep can therefore vary, in the order in which tables have it.
    pub const AXES: [Self; 10] = [
        Self::Theta,
        Self::ThetaRate,
        Self::Slip,
        Self::GapRate,
        Self::MassRatio,
        Self::Offset,
        Self::Inertia,
        Self::MuS,
        Self::MuK,
        Self::Restitution,
    ];

    /// The numbers of a hoop in SI units, with the units of (2.9) among them.
    pub const SI_HOOP: [Self; 9] = [
        Self::DiscMassKg,
        Self::ParticleMassKg,
        Self::RadiusM,
        Self::OffsetM,
        Self::InertiaKgM2,
        Self::GravityMPerS2,
        Self::MuS,
        Self::MuK,
        Self::Restitution,
    ];

    /// The numbers of a start in SI units.
    pub const SI_START: [Self; 6] =
        [Self::Theta, Self::ThetaRateRadPerS, Self::SlipMPerS, Self::GapRateMPerS, Self::XM, Self::TimeS];

    /// Bounds besides being a finite number, in the order in which they are checked.
    #[inline(always)]
    #[must_use]
    pub const fn bounds(self) -> &'static [Bound] {
        self.row().bounds
    }

    /// What it belongs to.
    #[must_use]
    pub const fn group(self) -> Group {
        self.row().group
    }

    /// Its dimension.
    #[must_use]
    pub const fn dimension(self) -> Dimension {
        self.row().dimension
    }

    /// Symbol of the paper, in plain letters.
    #[must_use]
    pub const fn symbol(self) -> &'static str {
        self.row().symbol
    }

    /// Symbol of the paper, as it is printed.
    #[must_use]
    pub const fn sign(self) -> &'static str {
        self.row().sign
    }

    /// What it is, in words.
    #[must_use]
    pub const fn long_name(self) -> &'static str {
        self.row().long_name
    }

    /// Whether a number of this name is in SI units. θ, μs and μk are the same numbers in both systems and count for
    /// neither.
    #[must_use]
    pub const fn is_si(self) -> bool {
        matches!(self.row().system, System::Si)
    }

    /// Whether the number is a ratio: the parameters of (2.9) are quotients by m2, R and m2 R².
    const fn is_ratio(self) -> bool {
        match self.row().group {
            Group::Hoop => !self.is_si(),
            Group::Start | Group::Place | Group::Units | Group::Run => false,
        }
    }

    /// Unit, in plain letters; empty for a ratio.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        self.of_units(self.dimension().scale(), self.dimension().si_unit())
    }

    /// Unit, as it is printed; empty for a ratio.
    #[must_use]
    pub const fn unit_sign(self) -> &'static str {
        self.of_units(self.dimension().scale_sign(), self.dimension().si_sign())
    }

    /// The one of two units that it has, of (2.9) and in SI units; empty for a ratio.
    const fn of_units(self, scale: &'static str, si: &'static str) -> &'static str {
        if self.is_ratio() || matches!(self.dimension(), Dimension::Ratio) {
            ""
        } else if self.is_si() || matches!(self.dimension(), Dimension::Angle) {
            si
        } else {
            scale
        }
    }

    /// The same quantity without dimension, by (2.9); itself where there is none, or it has none.
    #[must_use]
    pub const fn dimensionless(self) -> Self {
        match (self.is_si(), self.row().twin) {
            (true, Some(twin)) => twin,
            (true, None) | (false, _) => self,
        }
    }

    /// The same quantity in SI units; none for one that is the same in both systems, or is in SI units.
    #[must_use]
    pub const fn si_twin(self) -> Option<Self> {
        if self.is_si() { None } else { self.row().twin }
    }

    /// Advice for the person who typed a value out of bounds.
    pub(crate) const fn hint(self) -> &'static str {
        match self.dimensionless() {
            Self::MuK => "kinetic friction is never stronger than static friction: 0 <= mu_k <= mu_s",
            Self::MuS => "coefficients of friction are not negative: 0 <= mu_k <= mu_s",
            Self::Offset => "the particle sits on the rim or inside it: 0 <= offset <= radius",
            Self::Inertia => {
                "a thin hoop of mass m1 has Izz = m1 R^2, a uniform disc m1 R^2 / 2, a massless hoop 0"
            }
            Self::MassRatio => "a massless hoop has mass 0; less is not possible",
            Self::Until => "the time limit is absolute: it lies at or after the start",
            Self::Restitution => "0 is an impact without rebound, 1 one that gives everything back",
            Self::GapRate => "the rim is at the plane at the start: it can leave it, not enter it",
            Self::Theta
            | Self::ThetaRate
            | Self::Slip
            | Self::X
            | Self::Time
            | Self::DiscMassKg
            | Self::ParticleMassKg
            | Self::RadiusM
            | Self::OffsetM
            | Self::InertiaKgM2
            | Self::GravityMPerS2
            | Self::ThetaRateRadPerS
            | Self::SlipMPerS
            | Self::GapRateMPerS
            | Self::XM
            | Self::TimeS
            | Self::UntilS => {
                "see the units in the message; every value is dimensionless unless its name ends in a unit"
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lists_have_every_quantity_of_their_groups() {
        let sorted = |quantities: &[Quantity]| {
            let mut quantities = quantities.to_vec();
            quantities.sort_unstable();
            quantities
        };
        let those = |groups: &[Group], is_listed: fn(Quantity) -> bool| -> Vec<Quantity> {
            let in_groups = |quantity: &Quantity| groups.contains(&quantity.group()) && is_listed(*quantity);
            Quantity::ALL.into_iter().filter(in_groups).collect()
        };
        let is_plain = |quantity: Quantity| !quantity.is_si();
        let in_si = |quantity: Quantity| quantity.is_si() || quantity.si_twin().is_none();
        assert_eq!(sorted(&Quantity::HOOP), those(&[Group::Hoop], is_plain));
        assert_eq!(sorted(&Quantity::START), those(&[Group::Start, Group::Place], is_plain));
        assert_eq!(sorted(&Quantity::AXES), those(&[Group::Hoop, Group::Start], is_plain));
        assert_eq!(sorted(&Quantity::SI_HOOP), those(&[Group::Hoop, Group::Units], in_si));
        assert_eq!(sorted(&Quantity::SI_START), those(&[Group::Start, Group::Place], in_si));
    }

    #[test]
    fn twins_are_each_others_and_names_in_si_units_end_in_the_unit() {
        for quantity in Quantity::ALL {
            if let Some(twin) = quantity.row().twin {
                assert_eq!(twin.row().twin, Some(quantity));
                assert_eq!(twin.dimension(), quantity.dimension());
                assert_ne!(twin.is_si(), quantity.is_si());
            }
            let suffix = quantity.dimension().si_suffix();
            assert_eq!(
                quantity.is_si(),
                !suffix.is_empty() && quantity.name().ends_with(suffix),
                "{quantity}"
            );
            let [least, most] = quantity.row().usual;
            assert!(least < most && quantity.check(least).is_ok() && quantity.check(most).is_ok());
        }
    }
}
