//! The results of a sweep, column by column.

use littlewood::{PhaseSequence, Summary};

use crate::outcome::INVALID;

/// The result of one point: a [`Summary`] as numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Row {
    /// Code of the outcome; see [`crate::outcome`].
    pub outcome: u8,
    /// Sequence of phases.
    pub sequence: PhaseSequence,
    /// Number of transitions.
    pub transitions: u32,
    /// Time τ at the end, in √(R/g); where the last phase lasts for ever, the time at which it begins.
    pub end_time: f64,
    /// Angle θ there, in radians.
    pub end_theta: f64,
    /// Rate θ′ there, in √(g/R).
    pub end_theta_rate: f64,
    /// Slip velocity η′ there, in √(gR).
    pub end_slip: f64,
    /// Position x of the geometric centre there, in R.
    pub end_x: f64,
    /// Energy there, in m2 g R.
    pub energy: f64,
    /// Time of the first slip out of rolling, in √(R/g); NaN if none.
    pub first_slip_time: f64,
    /// Time of lift-off, in √(R/g); NaN if none.
    pub lift_off_time: f64,
    /// Length of the jump, in R; NaN without landing.
    pub jump_length: f64,
    /// Height of the jump, in R; NaN without landing.
    pub jump_height: f64,
    /// Whether the motion met a Painlevé paradox.
    pub painleve: bool,
}

impl Row {
    /// The row of a hoop without physical meaning.
    pub(crate) const INVALID: Self = Self {
        outcome: INVALID,
        sequence: PhaseSequence::from_bits(0),
        transitions: 0,
        end_time: f64::NAN,
        end_theta: f64::NAN,
        end_theta_rate: f64::NAN,
        end_slip: f64::NAN,
        end_x: f64::NAN,
        energy: f64::NAN,
        first_slip_time: f64::NAN,
        lift_off_time: f64::NAN,
        jump_length: f64::NAN,
        jump_height: f64::NAN,
        painleve: false,
    };
}

/// One NaN for all: the sign and payload of a NaN that arithmetic makes are not specified.
fn quiet(value: f64) -> f64 {
    if value.is_nan() { f64::NAN } else { value }
}

impl From<&Summary> for Row {
    fn from(summary: &Summary) -> Self {
        Self {
            outcome: summary.outcome as u8,
            sequence: summary.sequence,
            transitions: summary.transitions,
            end_time: quiet(summary.end.time),
            end_theta: quiet(summary.end.theta),
            end_theta_rate: quiet(summary.end.theta_rate),
            end_slip: quiet(summary.end.slip),
            end_x: quiet(summary.end.x),
            energy: quiet(summary.energy),
            first_slip_time: quiet(summary.first_slip_time),
            lift_off_time: quiet(summary.lift_off_time),
            jump_length: quiet(summary.jump_length),
            jump_height: quiet(summary.jump_height),
            painleve: summary.painleve,
        }
    }
}

/// The results of many points: one vector a quantity, all of the same length, in the order of the points.
///
/// Units are those of [`Row`].
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Columns {
    /// Codes of the outcomes.
    pub outcome: Vec<u8>,
    /// [`PhaseSequence::bits`] of the sequences of phases.
    pub sequence: Vec<u64>,
    /// Numbers of transitions.
    pub transitions: Vec<u32>,
    /// Painlevé flags, 0 or 1.
    pub painleve: Vec<u8>,
    /// The real columns, in the order of [`Real::ALL`].
    pub reals: [Vec<f64>; Real::ALL.len()],
}

/// A column of real numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Real {
    /// [`Row::end_time`].
    EndTime,
    /// [`Row::end_theta`].
    EndTheta,
    /// [`Row::end_theta_rate`].
    EndThetaRate,
    /// [`Row::end_slip`].
    EndSlip,
    /// [`Row::end_x`].
    EndX,
    /// [`Row::energy`].
    Energy,
    /// [`Row::first_slip_time`].
    FirstSlipTime,
    /// [`Row::lift_off_time`].
    LiftOffTime,
    /// [`Row::jump_length`].
    JumpLength,
    /// [`Row::jump_height`].
    JumpHeight,
}

impl Real {
    /// All real columns, in the order in which files have them.
    pub const ALL: [Self; 10] = [
        Self::EndTime,
        Self::EndTheta,
        Self::EndThetaRate,
        Self::EndSlip,
        Self::EndX,
        Self::Energy,
        Self::FirstSlipTime,
        Self::LiftOffTime,
        Self::JumpLength,
        Self::JumpHeight,
    ];

    /// Name, as files and the command line write it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        self.description().0
    }

    /// The column of this name.
    #[must_use]
    pub fn find(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|column| column.name() == name)
    }

    /// Unit, as files write it.
    #[must_use]
    pub const fn unit(self) -> &'static str {
        self.description().1
    }

    /// What it is, in words.
    #[must_use]
    pub const fn long_name(self) -> &'static str {
        self.description().2
    }

    const fn description(self) -> (&'static str, &'static str, &'static str) {
        match self {
            Self::EndTime => {
                ("end_time", "sqrt(R/g)", "time at the end, or where the phase begins that lasts for ever")
            }
            Self::EndTheta => ("end_theta", "rad", "angle at the end"),
            Self::EndThetaRate => ("end_theta_rate", "sqrt(g/R)", "rate of the angle at the end"),
            Self::EndSlip => ("end_slip", "sqrt(g R)", "slip velocity at the end"),
            Self::EndX => ("end_x", "R", "position of the geometric centre at the end"),
            Self::Energy => ("energy", "m2 g R", "energy at the end"),
            Self::FirstSlipTime => ("first_slip_time", "sqrt(R/g)", "time of the first slip out of rolling"),
            Self::LiftOffTime => ("lift_off_time", "sqrt(R/g)", "time of lift-off"),
            Self::JumpLength => ("jump_length", "R", "length of the jump"),
            Self::JumpHeight => ("jump_height", "R", "height of the jump"),
        }
    }

    /// Its value in a row.
    #[must_use]
    pub const fn of(self, row: &Row) -> f64 {
        match self {
            Self::EndTime => row.end_time,
            Self::EndTheta => row.end_theta,
            Self::EndThetaRate => row.end_theta_rate,
            Self::EndSlip => row.end_slip,
            Self::EndX => row.end_x,
            Self::Energy => row.energy,
            Self::FirstSlipTime => row.first_slip_time,
            Self::LiftOffTime => row.lift_off_time,
            Self::JumpLength => row.jump_length,
            Self::JumpHeight => row.jump_height,
        }
    }
}

impl Columns {
    /// Columns of this many rows that are all invalid.
    pub(crate) fn blank(len: usize) -> Self {
        let row = Row::INVALID;
        Self {
            outcome: vec![row.outcome; len],
            sequence: vec![0; len],
            transitions: vec![0; len],
            painleve: vec![0; len],
            reals: core::array::from_fn(|_| vec![f64::NAN; len]),
        }
    }

    /// Number of rows.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.outcome.len()
    }

    /// Whether there are no rows.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.outcome.is_empty()
    }

    /// A real column.
    #[must_use]
    pub fn real(&self, column: Real) -> &[f64] {
        &self.reals[column as usize]
    }

    /// A row below [`Columns::len`].
    #[must_use]
    pub fn row(&self, i: usize) -> Row {
        let real = |column: Real| self.reals[column as usize][i];
        Row {
            outcome: self.outcome[i],
            sequence: PhaseSequence::from_bits(self.sequence[i]),
            transitions: self.transitions[i],
            end_time: real(Real::EndTime),
            end_theta: real(Real::EndTheta),
            end_theta_rate: real(Real::EndThetaRate),
            end_slip: real(Real::EndSlip),
            end_x: real(Real::EndX),
            energy: real(Real::Energy),
            first_slip_time: real(Real::FirstSlipTime),
            lift_off_time: real(Real::LiftOffTime),
            jump_length: real(Real::JumpLength),
            jump_height: real(Real::JumpHeight),
            painleve: self.painleve[i] != 0,
        }
    }

    /// All rows in order.
    pub fn rows(&self) -> impl ExactSizeIterator<Item = Row> + '_ {
        (0..self.len()).map(|i| self.row(i))
    }

    pub(crate) fn set(&mut self, i: usize, row: &Row) {
        self.outcome[i] = row.outcome;
        self.sequence[i] = row.sequence.bits();
        self.transitions[i] = row.transitions;
        self.painleve[i] = u8::from(row.painleve);
        for (column, values) in Real::ALL.into_iter().zip(&mut self.reals) {
            values[i] = column.of(row);
        }
    }
}
