//! Instants of a motion, dimensionless and in SI units.

use littlewood::{Hoop, Sample, Units};
use serde::Serialize;

use super::direction::sign;

/// An instant of a motion.
#[derive(Debug, Serialize)]
pub(crate) struct SampleRecord {
    /// Time.
    pub(crate) time: f64,
    mode: &'static str,
    direction: i8,
    theta: f64,
    theta_rate: f64,
    slip: f64,
    x: f64,
    theta_acceleration: f64,
    slip_acceleration: f64,
    normal: f64,
    friction: f64,
    gap: f64,
    gap_rate: f64,
    energy: f64,
    centre_y: f64,
    mass_centre_x: f64,
    mass_centre_y: f64,
    particle_x: f64,
    particle_y: f64,
}

impl SampleRecord {
    pub(crate) fn new(hoop: &Hoop, sample: &Sample) -> Self {
        let (mass_centre, particle) = (sample.mass_centre(hoop), sample.particle(hoop));
        Self {
            time: sample.state.time,
            mode: sample.mode.name(),
            direction: sign(sample.direction),
            theta: sample.state.theta,
            theta_rate: sample.state.theta_rate,
            slip: sample.state.slip,
            x: sample.state.x,
            theta_acceleration: sample.theta_acceleration,
            slip_acceleration: sample.slip_acceleration,
            normal: sample.normal,
            friction: sample.friction,
            gap: sample.gap,
            gap_rate: sample.gap_rate,
            energy: sample.energy,
            centre_y: sample.centre().y,
            mass_centre_x: mass_centre.x,
            mass_centre_y: mass_centre.y,
            particle_x: particle.x,
            particle_y: particle.y,
        }
    }
}

/// An instant of a motion in SI units.
#[derive(Debug, Serialize)]
pub(crate) struct SiSampleRecord {
    time_s: f64,
    theta_rad: f64,
    theta_rate_rad_per_s: f64,
    slip_m_per_s: f64,
    x_m: f64,
    theta_acceleration_rad_per_s2: f64,
    slip_acceleration_m_per_s2: f64,
    normal_n: f64,
    friction_n: f64,
    gap_m: f64,
    gap_rate_m_per_s: f64,
    energy_j: f64,
    centre_y_m: f64,
    mass_centre_x_m: f64,
    mass_centre_y_m: f64,
    particle_x_m: f64,
    particle_y_m: f64,
}

impl SiSampleRecord {
    pub(crate) fn new(units: &Units, hoop: &Hoop, sample: &Sample) -> Self {
        let state = units.state(&sample.state);
        let (mass_centre, particle) = (sample.mass_centre(hoop), sample.particle(hoop));
        let length = |radii: f64| radii * units.length_m;
        Self {
            time_s: state.time_s,
            theta_rad: state.theta_rad,
            theta_rate_rad_per_s: state.theta_rate_rad_per_s,
            slip_m_per_s: state.slip_m_per_s,
            x_m: state.x_m,
            theta_acceleration_rad_per_s2: sample.theta_acceleration / (units.time_s * units.time_s),
            slip_acceleration_m_per_s2: sample.slip_acceleration * units.gravity_m_per_s2,
            normal_n: sample.normal * units.force_n(),
            friction_n: sample.friction * units.force_n(),
            gap_m: length(sample.gap),
            gap_rate_m_per_s: sample.gap_rate * units.velocity_m_per_s(),
            energy_j: sample.energy * units.energy_j(),
            centre_y_m: length(sample.centre().y),
            mass_centre_x_m: length(mass_centre.x),
            mass_centre_y_m: length(mass_centre.y),
            particle_x_m: length(particle.x),
            particle_y_m: length(particle.y),
        }
    }
}
