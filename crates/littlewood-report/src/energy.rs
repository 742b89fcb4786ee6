//! The energy that an impact has to take from.

use littlewood::Hoop;
use littlewood::impact::ContactVelocities;
use littlewood::theory::Body;

/// The kinetic energy of a heavy hoop whose rim is at the plane, the angle and the velocities of the contact point given;
/// none for a massless hoop, whose rim has no velocity of its own.
pub fn kinetic_energy(hoop: &Hoop, theta: f64, velocities: &ContactVelocities) -> Option<f64> {
    let Body::Heavy(body) = hoop.body() else { return None };
    let ContactVelocities { theta_rate, slip, gap_rate } = *velocities;
    let (sin, cos) = libm::sincos(theta);
    let vx = slip - (1.0 + body.h * cos) * theta_rate;
    let vy = gap_rate - body.h * sin * theta_rate;
    Some(0.5 * (body.mass * (vx * vx + vy * vy) + body.inertia * (theta_rate * theta_rate)))
}
