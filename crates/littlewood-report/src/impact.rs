//! What is known of an impact beside its record.

use littlewood::impact::{ContactVelocities, Impact};
use littlewood::theory::{Body, Classification};
use littlewood::{Hoop, Start, State};

/// The kinetic energy of a heavy hoop whose rim is at the plane, the angle and the velocities of
/// the contact point given; none for a massless hoop, whose rim has no velocity of its own.
pub fn kinetic_energy(hoop: &Hoop, theta: f64, velocities: &ContactVelocities) -> Option<f64> {
    let Body::Heavy(body) = hoop.body() else {
        return None;
    };
    let ContactVelocities {
        theta_rate,
        slip,
        gap_rate,
    } = *velocities;
    let (sin, cos) = libm::sincos(theta);
    let vx = slip - (1.0 + body.h * cos) * theta_rate;
    let vy = gap_rate - body.h * sin * theta_rate;
    Some(0.5 * (body.mass * (vx * vx + vy * vy) + body.inertia * (theta_rate * theta_rate)))
}

/// The impact with which a motion begins at a start that has been classified, if no motion is
/// consistent there and the hoop has a coefficient of restitution.
pub fn jam_of(hoop: &Hoop, start: Start, found: &Classification) -> Option<Impact> {
    found
        .candidates
        .filter(|candidates| candidates.count() == 0)?;
    hoop.jam(&State::from(start))
}
