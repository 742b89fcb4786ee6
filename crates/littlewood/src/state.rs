//! Starts, states, and all that is known of an instant.

use crate::columns::SampleColumn;
use crate::equations::energy;
use crate::error::ParameterError;
use crate::hoop::Hoop;
use crate::mode::{Direction, Mode};
use crate::quantity::Quantity;

/// A start in contact with the plane: dimensionless time, angle, rate, slip velocity and position.
///
/// ```
/// let start = littlewood::Start::at(0.5, -1.0).with_slip(0.25);
/// assert_eq!(start.slip, 0.25);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[non_exhaustive]
pub struct Start {
    /// Time τ.
    pub time: f64,
    /// Angle θ of the particle from the upward vertical, counterclockwise, not reduced.
    pub theta: f64,
    /// Rate θ′.
    pub theta_rate: f64,
    /// Slip velocity η′ of the contact point (2.7).
    pub slip: f64,
    /// Horizontal position x of the geometric centre.
    pub x: f64,
}

impl Start {
    /// A start at τ = 0, x = 0 without slip.
    #[must_use]
    pub const fn at(theta: f64, theta_rate: f64) -> Self {
        Self { time: 0.0, theta, theta_rate, slip: 0.0, x: 0.0 }
    }

    /// The same start with a slip velocity η′.
    #[must_use]
    pub const fn with_slip(self, slip: f64) -> Self {
        Self { slip, ..self }
    }

    /// The same start at another time τ.
    #[must_use]
    pub const fn with_time(self, time: f64) -> Self {
        Self { time, ..self }
    }

    /// The same start at another position x.
    #[must_use]
    pub const fn with_x(self, x: f64) -> Self {
        Self { x, ..self }
    }

    /// Refuses what is not finite, and what a double no longer resolves.
    ///
    /// # Errors
    /// Names the first value that breaks a bound of [`Quantity::START`].
    pub fn check(self) -> Result<State, ParameterError> {
        Ok(State {
            time: Quantity::Time.check(self.time)?,
            theta: Quantity::Theta.check(self.theta)?,
            theta_rate: Quantity::ThetaRate.check(self.theta_rate)?,
            slip: Quantity::Slip.check(self.slip)?,
            x: Quantity::X.check(self.x)?,
        })
    }
}

impl From<State> for Start {
    fn from(state: State) -> Self {
        let State { time, theta, theta_rate, slip, x } = state;
        Self { time, theta, theta_rate, slip, x }
    }
}

/// The state of the body at an instant. In flight `slip` is the horizontal velocity of the lowest point of the
/// rim, which is the slip velocity that a landing there would have.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct State {
    /// Time τ.
    pub time: f64,
    /// Angle θ, not reduced.
    pub theta: f64,
    /// Rate θ′.
    pub theta_rate: f64,
    /// Slip velocity η′.
    pub slip: f64,
    /// Horizontal position x of the geometric centre.
    pub x: f64,
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
    #[must_use]
    pub const fn numbers(&self) -> [f64; 5] {
        let Self { time, theta, theta_rate, slip, x } = *self;
        [time, theta, theta_rate, slip, x]
    }
}

/// A start that has not been checked, as a state.
impl From<Start> for State {
    fn from(start: Start) -> Self {
        let Start { time, theta, theta_rate, slip, x } = start;
        Self { time, theta, theta_rate, slip, x }
    }
}

/// Everything about one instant of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Sample {
    /// State.
    pub state: State,
    /// Mode of motion.
    pub mode: Mode,
    /// Direction of slip; none for rolling and flight.
    pub direction: Option<Direction>,
    /// Angular acceleration θ″.
    pub theta_acceleration: f64,
    /// Acceleration η″ of the slip.
    pub slip_acceleration: f64,
    /// Normal force N/(m2 g).
    pub normal: f64,
    /// Friction force F/(m2 g), positive along E1.
    pub friction: f64,
    /// Height of the lowest point of the rim over the plane; zero in contact.
    pub gap: f64,
    /// Rate of the gap; zero in contact.
    pub gap_rate: f64,
    /// Total energy E = T + U over m2 g R (2.8); the potential energy is ℓ̂ cos θ + m gap.
    pub energy: f64,
    /// Geometric centre C.
    pub centre: Position,
    /// Mass centre X̄ = C + h e2.
    pub mass_centre: Position,
    /// Particle, C + ℓ̂ e2.
    pub particle: Position,
}

/// A point of the plane of motion, in radii.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Position {
    /// Horizontal coordinate along E1.
    pub x: f64,
    /// Height over the plane.
    pub y: f64,
}

/// What a mode of motion knows of an instant besides the state; the rest follows for all modes alike.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Instant {
    pub(crate) mode: Mode,
    pub(crate) direction: Option<Direction>,
    /// θ″ and η″.
    pub(crate) accelerations: (f64, f64),
    /// N and F.
    pub(crate) forces: (f64, f64),
    /// The gap and its rate.
    pub(crate) gap: (f64, f64),
}

impl Instant {
    pub(crate) fn sample(self, hoop: &Hoop, state: State) -> Sample {
        let (gap, gap_rate) = self.gap;
        let (sin, cos) = libm::sincos(state.theta);
        let centre = Position { x: state.x, y: 1.0 + gap };
        let along_radius =
            |distance: f64| Position { x: centre.x - distance * sin, y: centre.y + distance * cos };
        Sample {
            state,
            mode: self.mode,
            direction: self.direction,
            theta_acceleration: self.accelerations.0,
            slip_acceleration: self.accelerations.1,
            normal: self.forces.0,
            friction: self.forces.1,
            gap,
            gap_rate,
            energy: energy(hoop, &state, gap, gap_rate),
            centre,
            mass_centre: along_radius(hoop.h()),
            particle: along_radius(hoop.offset()),
        }
    }
}
