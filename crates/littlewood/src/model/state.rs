//! The start of a motion and the state at an instant.

use crate::model::{ParameterError, Quantity, setters};

/// The initial condition of a motion, with the rim at the plane; dimensionless.
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
    /// Gap rate, zero or positive: the rate at which the rim leaves the plane.
    #[cfg_attr(feature = "serde", serde(default))]
    pub gap_rate: f64,
    /// Position x of the geometric centre along the plane.
    pub x: f64,
}

impl Start {
    /// A start at τ = 0, x = 0 without slip.
    #[must_use]
    pub const fn at(theta: f64, theta_rate: f64) -> Self {
        Self {
            time: 0.0,
            theta,
            theta_rate,
            slip: 0.0,
            gap_rate: 0.0,
            x: 0.0,
        }
    }

    /// The state, without the gap rate.
    pub(crate) const fn state(&self) -> State {
        State {
            time: self.time,
            theta: self.theta,
            theta_rate: self.theta_rate,
            slip: self.slip,
            x: self.x,
        }
    }

    /// The state, if all values are within the bounds of [`Quantity::START`].
    ///
    /// # Errors
    /// The first value that violates a bound.
    pub fn check(self) -> Result<State, ParameterError> {
        Quantity::GapRate.check(self.gap_rate)?;
        Ok(State {
            time: Quantity::Time.check(self.time)?,
            theta: Quantity::Theta.check(self.theta)?,
            theta_rate: Quantity::ThetaRate.check(self.theta_rate)?,
            slip: Quantity::Slip.check(self.slip)?,
            x: Quantity::X.check(self.x)?,
        })
    }
}

setters! {
    Start:
    /// The same start with a slip velocity η′.
    with_slip(slip: f64);
    /// The same start with this gap rate.
    with_gap_rate(gap_rate: f64);
    /// The same start at another time τ.
    with_time(time: f64);
    /// The same start at another position x.
    with_x(x: f64);
}

impl From<State> for Start {
    fn from(state: State) -> Self {
        Self {
            time: state.time,
            theta: state.theta,
            theta_rate: state.theta_rate,
            slip: state.slip,
            gap_rate: 0.0,
            x: state.x,
        }
    }
}

/// The state of the body at an instant. In flight `slip` is the velocity along the plane of the
/// point of the rim next to it.
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
    /// Position x of the geometric centre along the plane.
    pub x: f64,
}

/// The state of an unchecked start, without its gap rate.
impl From<Start> for State {
    fn from(start: Start) -> Self {
        start.state()
    }
}
