//! Kinematics, forces and energy at one instant of a motion.

use crate::mechanics::{Accelerations, Clearance, ContactForces, energy};
use crate::model::{Hoop, Mode, SlipDirection, State};

/// Kinematics, forces and energy at one instant of a motion.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[non_exhaustive]
pub struct Sample {
    /// State.
    pub state: State,
    /// Mode of motion.
    pub mode: Mode,
    /// Direction of slip; none for rolling, rest and flight.
    pub direction: Option<SlipDirection>,
    /// Angular acceleration θ″.
    pub theta_acceleration: f64,
    /// Acceleration η″ of the slip.
    pub slip_acceleration: f64,
    /// Normal force N/(m2 g).
    pub normal: f64,
    /// Friction force F/(m2 g), positive along E1.
    pub friction: f64,
    /// Couple M/(m2 g R) of rolling resistance, positive as θ″ is; zero without resistance.
    pub couple: f64,
    /// Distance of the rim from the plane; zero in contact.
    pub gap: f64,
    /// Rate of the gap; zero in contact.
    pub gap_rate: f64,
    /// Total energy E = T + U over m2 g R (2.8); U is [`Sample::potential_energy`].
    pub energy: f64,
    /// Geometric centre C.
    pub centre: Position,
    /// Mass centre X̄ = C + h e2.
    pub mass_centre: Position,
    /// Particle, C + ℓ̂ e2.
    pub particle: Position,
}

impl Sample {
    /// Potential energy U of (2.8), over m2 g R: zero with the particle as far from the plane as C
    /// and the rim at the plane, on a slope where x = 0. All energies have this zero.
    #[must_use]
    pub fn potential_energy(&self, hoop: &Hoop) -> f64 {
        let (along, across) = libm::sincos(hoop.slope());
        let above_centre = hoop.offset() * libm::cos(self.state.theta) + hoop.mass() * self.gap;
        across * above_centre + along * (hoop.mass() * self.mass_centre.x)
    }
}

/// A point of the plane of motion, in radii.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Position {
    /// Coordinate along the plane, along E1.
    pub x: f64,
    /// Distance from the plane.
    pub y: f64,
}

/// The quantities at an instant that depend on the mode; all others follow from the state.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Instant {
    pub(crate) mode: Mode,
    pub(crate) direction: Option<SlipDirection>,
    pub(crate) accelerations: Accelerations,
    pub(crate) forces: ContactForces,
    pub(crate) couple: f64,
    pub(crate) clearance: Clearance,
}

/// The couple −ς χ N of a hoop that turns, from ς χ; zero without resistance, wherever N may be
/// infinite.
pub(crate) fn couple_of_turning(resistance: f64, normal: f64) -> f64 {
    if resistance == 0.0 {
        0.0
    } else {
        -resistance * normal
    }
}

impl Instant {
    pub(crate) fn sample(self, hoop: &Hoop, state: State) -> Sample {
        let Clearance { gap, gap_rate } = self.clearance;
        let (sin, cos) = libm::sincos(state.theta);
        let centre = Position {
            x: state.x,
            y: 1.0 + gap,
        };
        let along_radius = |distance: f64| Position {
            x: centre.x - distance * sin,
            y: centre.y + distance * cos,
        };
        Sample {
            state,
            mode: self.mode,
            direction: self.direction,
            theta_acceleration: self.accelerations.theta,
            slip_acceleration: self.accelerations.slip,
            normal: self.forces.normal,
            friction: self.forces.friction,
            couple: self.couple,
            gap,
            gap_rate,
            energy: energy(hoop, &state, gap, gap_rate),
            centre,
            mass_centre: along_radius(hoop.h()),
            particle: along_radius(hoop.offset()),
        }
    }
}
