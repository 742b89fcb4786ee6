//! The columns of samples and summaries: name, dimension, description and value.

use core::fmt;
use core::str::FromStr;

use thiserror::Error;

use crate::model::{Dimension, Mode, Quantity, SlipDirection, State, getters, named};
use crate::modes::Sample;
use crate::motion::derivatives::differentiable;
use crate::motion::summary::Summary;
use crate::walk::{OutcomeKind, PhaseSequence};

named! {
    /// A column of the samples of a motion, in the order of records.
    pub enum SampleColumn, "column of a sample",
    /// Dimension, if any; symbol; description.
    row: (Option<Dimension>, &'static str, &'static str) {
        /// Time τ.
        Time = 0, "time" => (Some(Dimension::Time), "τ", "time");
        /// Mode of motion.
        Mode = 1, "mode" => (None, "", "mode of motion");
        /// Direction of slip.
        Direction = 2, "direction" => (None, "σ", "sign of the slip velocity; 0 for rolling, rest and flight");
        /// Angle θ.
        Theta = 3, "theta" => (Some(Dimension::Angle), "θ", "angle of the particle from the upward vertical");
        /// Rate θ′.
        ThetaRate = 4, "theta_rate" => (Some(Dimension::AngularRate), "θ′", "rate of the angle");
        /// Slip velocity η′.
        Slip = 5, "slip" => (Some(Dimension::Velocity), "η′", "slip velocity of the contact point");
        /// Position x of the geometric centre.
        X = 6, "x" => (Some(Dimension::Length), "x", "position of the geometric centre along the plane");
        /// Angular acceleration θ″.
        ThetaAcceleration = 7, "theta_acceleration" => (Some(Dimension::AngularAcceleration), "θ″", "angular acceleration");
        /// Acceleration η″ of the slip.
        SlipAcceleration = 8, "slip_acceleration" => (Some(Dimension::Acceleration), "η″", "acceleration of the slip");
        /// Normal force N.
        Normal = 9, "normal" => (Some(Dimension::Force), "N", "normal force");
        /// Friction force F.
        Friction = 10, "friction" => (Some(Dimension::Force), "F", "friction force");
        /// Couple M of rolling resistance.
        Couple = 11, "couple" => (Some(Dimension::Moment), "M", "couple of rolling resistance");
        /// Gap between the rim and the plane.
        Gap = 12, "gap" => (Some(Dimension::Length), "gap", "distance of the rim from the plane");
        /// Rate of the gap.
        GapRate = 13, "gap_rate" => (Some(Dimension::Velocity), "gap′", "rate of the gap");
        /// Energy E (2.8).
        Energy = 14, "energy" => (Some(Dimension::Energy), "E", "kinetic and potential energy");
        /// Distance of the geometric centre from the plane.
        CentreY = 15, "centre_y" => (Some(Dimension::Length), "y", "distance of the geometric centre from the plane");
        /// Position of the mass centre along the plane.
        MassCentreX = 16, "mass_centre_x" => (Some(Dimension::Length), "x̄", "position of the mass centre along the plane");
        /// Distance of the mass centre from the plane.
        MassCentreY = 17, "mass_centre_y" => (Some(Dimension::Length), "ȳ", "distance of the mass centre from the plane");
        /// Position of the particle along the plane.
        ParticleX = 18, "particle_x" => (Some(Dimension::Length), "x₂", "position of the particle along the plane");
        /// Distance of the particle from the plane.
        ParticleY = 19, "particle_y" => (Some(Dimension::Length), "y₂", "distance of the particle from the plane");
    }
}

impl State {
    /// The columns that make a state, in the order of records.
    pub const COLUMNS: [SampleColumn; 5] = [
        SampleColumn::Time,
        SampleColumn::Theta,
        SampleColumn::ThetaRate,
        SampleColumn::Slip,
        SampleColumn::X,
    ];

    /// The numbers, in the order of [`State::COLUMNS`].
    pub const fn numbers(&self) -> [f64; 5] {
        [self.time, self.theta, self.theta_rate, self.slip, self.x]
    }
}

/// A value of a sample.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SampleValue {
    /// A mode.
    Mode(Mode),
    /// A direction of slip.
    Direction(Option<SlipDirection>),
    /// A number.
    Real(f64),
}

impl SampleValue {
    /// As a number: the code of a mode, σ of a direction.
    pub fn number(self) -> f64 {
        match self {
            Self::Mode(mode) => f64::from(mode.code()),
            Self::Direction(direction) => f64::from(SlipDirection::code(direction)),
            Self::Real(value) => value,
        }
    }
}

getters! {
    SampleColumn, self:
    /// Dimension; none for a code.
    pub dimension: Option<Dimension> = self.row().0;
    /// Printed symbol.
    pub sign: &'static str = self.row().1;
    /// Description.
    pub long_name: &'static str = self.row().2;
}

impl SampleColumn {
    /// The value in a sample.
    pub const fn of(self, sample: &Sample) -> SampleValue {
        SampleValue::Real(match self {
            Self::Mode => return SampleValue::Mode(sample.mode),
            Self::Direction => return SampleValue::Direction(sample.direction),
            Self::Time => sample.state.time,
            Self::Theta => sample.state.theta,
            Self::ThetaRate => sample.state.theta_rate,
            Self::Slip => sample.state.slip,
            Self::X => sample.state.x,
            Self::ThetaAcceleration => sample.theta_acceleration,
            Self::SlipAcceleration => sample.slip_acceleration,
            Self::Normal => sample.normal,
            Self::Friction => sample.friction,
            Self::Couple => sample.couple,
            Self::Gap => sample.gap,
            Self::GapRate => sample.gap_rate,
            Self::Energy => sample.energy,
            Self::CentreY => sample.centre.y,
            Self::MassCentreX => sample.mass_centre.x,
            Self::MassCentreY => sample.mass_centre.y,
            Self::ParticleX => sample.particle.x,
            Self::ParticleY => sample.particle.y,
        })
    }

    /// Column name with the SI unit; none for a code.
    pub fn si_name(self) -> Option<String> {
        self.dimension()
            .map(|dimension| format!("{self}{}", dimension.si_suffix()))
    }
}

named! {
    /// A column of the results of a sweep, in the order of stores.
    pub enum SummaryColumn, "column of a summary",
    /// Type, dimension and description.
    row: (ColumnType, Dimension, &'static str) {
        /// [`Summary::outcome`].
        Outcome = 0, "outcome" => (ColumnType::Outcome, Dimension::Ratio, "outcome");
        /// [`Summary::sequence`].
        Sequence = 1, "sequence" => (ColumnType::Sequence, Dimension::Ratio, "sequence of phases");
        /// [`Summary::transitions`].
        Transitions = 2, "transitions" => (ColumnType::Count, Dimension::Ratio, "number of transitions");
        /// [`Summary::painleve`].
        Painleve = 3, "painleve" => (ColumnType::Flag, Dimension::Ratio, "whether the motion met a Painlevé paradox");
        /// Time at the end.
        EndTime = 4, "end_time" => (ColumnType::Real, Dimension::Time, "time at the end, or where the phase begins that lasts for ever");
        /// Angle at the end.
        EndTheta = 5, "end_theta" => (ColumnType::Real, Dimension::Angle, "angle at the end");
        /// Rate at the end.
        EndThetaRate = 6, "end_theta_rate" => (ColumnType::Real, Dimension::AngularRate, "rate of the angle at the end");
        /// Slip velocity at the end.
        EndSlip = 7, "end_slip" => (ColumnType::Real, Dimension::Velocity, "slip velocity at the end");
        /// Position at the end.
        EndX = 8, "end_x" => (ColumnType::Real, Dimension::Length, "position of the geometric centre at the end");
        /// [`Summary::energy`].
        Energy = 9, "energy" => (ColumnType::Real, Dimension::Energy, "energy at the end");
        /// [`Summary::first_slip_time`].
        FirstSlipTime = 10, "first_slip_time" => (ColumnType::Real, Dimension::Time, "time of the first slip out of rolling");
        /// [`Summary::lift_off_time`].
        LiftOffTime = 11, "lift_off_time" => (ColumnType::Real, Dimension::Time, "time of lift-off");
        /// [`Summary::jump_length`].
        JumpLength = 12, "jump_length" => (ColumnType::Real, Dimension::Length, "length of the first jump");
        /// [`Summary::jump_height`].
        JumpHeight = 13, "jump_height" => (ColumnType::Real, Dimension::Length, "height of the first jump");
        /// [`Summary::landings`].
        Landings = 14, "landings" => (ColumnType::Count, Dimension::Ratio, "number of landings");
        /// [`Summary::impact_energy_lost`].
        ImpactEnergyLost = 15, "impact_energy_lost" => (ColumnType::Real, Dimension::Energy, "energy lost in impacts");
        /// [`Summary::settle_time`].
        SettleTime = 16, "settle_time" => (ColumnType::Real, Dimension::Time, "time from which on the rim stays at the plane");
        /// [`Summary::half_swings`].
        HalfSwings = 17, "half_swings" => (ColumnType::Count, Dimension::Ratio, "number of half swings against rolling resistance");
    }
}

/// The derivative of a number of a summary by a quantity; its name is `jump_length_by_mu_k`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DerivativeColumn {
    /// The number, one of [`SummaryColumn::reals`].
    pub number: SummaryColumn,
    /// The quantity, one that is [`differentiable`].
    pub quantity: Quantity,
}

/// A name that is not that of a derivative.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error(
    "there is no derivative named '{name}': it is NUMBER_by_QUANTITY, with one of {}, and one of {}",
    SummaryColumn::reals().map(SummaryColumn::name).collect::<Vec<_>>().join(", "),
    differentiable(true).map(Quantity::name).collect::<Vec<_>>().join(", ")
)]
pub struct UnknownDerivative {
    /// The name.
    pub name: String,
}

impl fmt::Display for DerivativeColumn {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(&format!("{}_by_{}", self.number, self.quantity))
    }
}

impl FromStr for DerivativeColumn {
    type Err = UnknownDerivative;

    fn from_str(name: &str) -> Result<Self, Self::Err> {
        let parts = name.split_once("_by_").and_then(|(number, quantity)| {
            let number = SummaryColumn::reals().find(|column| column.name() == number)?;
            Some((
                number,
                differentiable(true).find(|known| known.name() == quantity)?,
            ))
        });
        let (number, quantity) = parts.ok_or_else(|| UnknownDerivative {
            name: name.to_owned(),
        })?;
        Ok(Self { number, quantity })
    }
}

/// The type of a column of a summary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ColumnType {
    /// The code of an [`OutcomeKind`], 8 bits.
    Outcome,
    /// The bits of a [`PhaseSequence`], 64 bits.
    Sequence,
    /// A count, 32 bits.
    Count,
    /// Yes or no, 8 bits.
    Flag,
    /// A number in double precision; NaN if absent.
    Real,
}

/// A value of a summary, as stored in arrays.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SummaryValue {
    /// 8 bits.
    U8(u8),
    /// 32 bits.
    U32(u32),
    /// 64 bits.
    U64(u64),
    /// Double precision.
    F64(f64),
}

enum Field<'a> {
    Outcome(&'a mut OutcomeKind),
    Sequence(&'a mut PhaseSequence),
    Count(&'a mut u32),
    Flag(&'a mut bool),
    Real(&'a mut f64),
}

getters! {
    SummaryColumn, self:
    /// Type.
    pub column_type: ColumnType = self.row().0;
    /// Dimension; [`Dimension::Ratio`] for counts and codes.
    pub dimension: Dimension = self.row().1;
    /// Description.
    pub long_name: &'static str = self.row().2;
}

impl SummaryColumn {
    const fn field(self, summary: &mut Summary) -> Field<'_> {
        Field::Real(match self {
            Self::Outcome => return Field::Outcome(&mut summary.outcome),
            Self::Sequence => return Field::Sequence(&mut summary.sequence),
            Self::Transitions => return Field::Count(&mut summary.transitions),
            Self::Painleve => return Field::Flag(&mut summary.painleve),
            Self::EndTime => &mut summary.end.time,
            Self::EndTheta => &mut summary.end.theta,
            Self::EndThetaRate => &mut summary.end.theta_rate,
            Self::EndSlip => &mut summary.end.slip,
            Self::EndX => &mut summary.end.x,
            Self::Energy => &mut summary.energy,
            Self::FirstSlipTime => &mut summary.first_slip_time,
            Self::LiftOffTime => &mut summary.lift_off_time,
            Self::JumpLength => &mut summary.jump_length,
            Self::JumpHeight => &mut summary.jump_height,
            Self::Landings => return Field::Count(&mut summary.landings),
            Self::ImpactEnergyLost => &mut summary.impact_energy_lost,
            Self::SettleTime => &mut summary.settle_time,
            Self::HalfSwings => return Field::Count(&mut summary.half_swings),
        })
    }

    /// The columns of real numbers and counts.
    pub fn numbers() -> impl Iterator<Item = Self> {
        Self::ALL
            .into_iter()
            .filter(|column| match column.column_type() {
                ColumnType::Real | ColumnType::Count => true,
                ColumnType::Outcome | ColumnType::Sequence | ColumnType::Flag => false,
            })
    }

    /// The columns of real numbers.
    pub fn reals() -> impl Iterator<Item = Self> {
        Self::ALL
            .into_iter()
            .filter(|column| column.column_type() == ColumnType::Real)
    }

    /// The value in a summary. Every NaN becomes [`f64::NAN`], since the sign and payload of a
    /// computed NaN are unspecified.
    pub fn of(self, summary: &Summary) -> SummaryValue {
        self.field(&mut { *summary }).value()
    }

    /// Sets the value in a summary. Returns false, and changes nothing, for a value of another type
    /// or an unknown code.
    pub fn set(self, summary: &mut Summary, value: SummaryValue) -> bool {
        match (self.field(summary), value) {
            (Field::Outcome(outcome), SummaryValue::U8(code)) => {
                match OutcomeKind::try_from(code) {
                    Ok(kind) => *outcome = kind,
                    Err(_) => return false,
                }
            }
            (Field::Sequence(sequence), SummaryValue::U64(bits)) => {
                *sequence = PhaseSequence::from_bits(bits);
            }
            (Field::Count(count), SummaryValue::U32(value)) => *count = value,
            (Field::Flag(flag), SummaryValue::U8(value)) => *flag = value != 0,
            (Field::Real(real), SummaryValue::F64(value)) => *real = value,
            (
                Field::Outcome(_)
                | Field::Sequence(_)
                | Field::Count(_)
                | Field::Flag(_)
                | Field::Real(_),
                _,
            ) => {
                return false;
            }
        }
        true
    }
}

impl Field<'_> {
    const fn value(self) -> SummaryValue {
        match self {
            Self::Outcome(outcome) => SummaryValue::U8(outcome.code()),
            Self::Sequence(sequence) => SummaryValue::U64(sequence.bits()),
            Self::Count(count) => SummaryValue::U32(*count),
            Self::Flag(flag) => SummaryValue::U8(*flag as u8),
            Self::Real(value) => SummaryValue::F64(if value.is_nan() { f64::NAN } else { *value }),
        }
    }
}

impl Summary {
    /// The values of all columns, in the order of [`SummaryColumn::ALL`].
    pub fn values(&self) -> [SummaryValue; SummaryColumn::ALL.len()] {
        let mut copy = *self;
        SummaryColumn::ALL.map(|column| column.field(&mut copy).value())
    }
}
