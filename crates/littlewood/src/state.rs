//! Where the body is: the state, the mode it moves in, and what an instant of a motion looks like.

use core::fmt;

use crate::error::{ParameterError, Quantity, moderate};
use crate::hoop::Hoop;

/// Largest time, angle and position of a start: there doubles still resolve 1e-7.
const FARTHEST: f64 = 1e9;

/// Largest rate and slip velocity of a start: a flight at this rate turns 1e11 times.
const FASTEST: f64 = 1e6;

/// A start in contact with the plane: dimensionless time, angle, rate, slip velocity and position.
///
/// ```
/// let start = littlewood::Start::at(0.5, -1.0).with_slip(0.25);
/// assert_eq!(start.slip, 0.25);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
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

    pub(crate) fn checked(self) -> Result<State, ParameterError> {
        Ok(State {
            time: moderate(Quantity::Time, self.time, FARTHEST)?,
            theta: moderate(Quantity::Theta, self.theta, FARTHEST)?,
            theta_rate: moderate(Quantity::ThetaRate, self.theta_rate, FASTEST)?,
            slip: moderate(Quantity::Slip, self.slip, FASTEST)?,
            x: moderate(Quantity::X, self.x, FARTHEST)?,
        })
    }
}

/// The state of the body at an instant. In flight `slip` is the horizontal velocity of the lowest point of the
/// rim, which is the slip velocity that a landing there would have.
#[derive(Clone, Copy, Debug, PartialEq)]
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

/// The four modes of motion of the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Mode {
    /// η′ = 0, static friction (2.10).
    Rolling,
    /// η′ ≠ 0, kinetic friction (2.16).
    Sliding,
    /// In contact without any contact force, N = 0 (3.17).
    Gliding,
    /// Off the plane (§2e).
    Flight,
}

impl Mode {
    /// All modes.
    pub const ALL: [Self; 4] = [Self::Rolling, Self::Sliding, Self::Gliding, Self::Flight];

    /// Lower-case name, as files and the command line write it.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Rolling => "rolling",
            Self::Sliding => "sliding",
            Self::Gliding => "gliding",
            Self::Flight => "flight",
        }
    }
}

impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// Direction of slip, σ = sign(η′).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Direction {
    /// σ = −1.
    Negative,
    /// σ = +1.
    Positive,
}

impl Direction {
    /// σ as a number.
    #[must_use]
    pub const fn sign(self) -> f64 {
        match self {
            Self::Negative => -1.0,
            Self::Positive => 1.0,
        }
    }

    /// The sign of a number; none for zero (and NaN).
    #[must_use]
    pub fn of(value: f64) -> Option<Self> {
        if value > 0.0 {
            Some(Self::Positive)
        } else if value < 0.0 {
            Some(Self::Negative)
        } else {
            None
        }
    }

    /// The other direction.
    #[must_use]
    pub const fn reversed(self) -> Self {
        match self {
            Self::Negative => Self::Positive,
            Self::Positive => Self::Negative,
        }
    }
}

/// Everything about one instant of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
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
}

/// A point of the plane of motion, in radii.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Horizontal coordinate along E1.
    pub x: f64,
    /// Height over the plane.
    pub y: f64,
}

impl Sample {
    /// Geometric centre C.
    #[must_use]
    pub fn centre(&self) -> Point {
        Point { x: self.state.x, y: 1.0 + self.gap }
    }

    /// Mass centre X̄ = C + h e2.
    #[must_use]
    pub fn mass_centre(&self, hoop: &Hoop) -> Point {
        self.along_radius(hoop.h())
    }

    /// Particle, C + ℓ̂ e2.
    #[must_use]
    pub fn particle(&self, hoop: &Hoop) -> Point {
        self.along_radius(hoop.offset())
    }

    fn along_radius(&self, distance: f64) -> Point {
        let (sin, cos) = libm::sincos(self.state.theta);
        let centre = self.centre();
        Point { x: centre.x - distance * sin, y: centre.y + distance * cos }
    }
}

/// Kinetic plus potential energy of a body in contact or above the plane, from velocities alone (2.8).
pub(crate) fn energy(hoop: &Hoop, state: &State, gap: f64, gap_rate: f64) -> f64 {
    let (sin, cos) = libm::sincos(state.theta);
    let (m, h, rate) = (hoop.mass(), hoop.h(), state.theta_rate);
    let vx = state.slip - (1.0 + h * cos) * rate;
    let vy = gap_rate - h * sin * rate;
    let spin = hoop.body().inertia_about_mass_centre() * rate * rate;
    0.5 * (m * (vx * vx + vy * vy) + spin) + hoop.offset() * cos + m * gap
}
