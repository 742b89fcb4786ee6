//! What is known of an impact beside its record.

use littlewood::impact::{ContactVelocities, Impact, Impulse};
use littlewood::theory::{Body, Classification};
use littlewood::{Hoop, Start, State, Transition};

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

/// An impact as a person sees it: what is less than its own rounding is zero.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShownImpact {
    /// Velocities before it.
    pub before: ContactVelocities,
    /// Velocities after it.
    pub after: ContactVelocities,
    /// Impulse on the body.
    pub impulse: Impulse,
    /// Energy lost, negative where Newton's law has gained some.
    pub energy_lost: f64,
}

impl ShownImpact {
    /// The impact of a transition with so many transitions before it; none without an impact.
    pub fn of(hoop: &Hoop, earlier: usize, event: &Transition) -> Option<Self> {
        const EPSILON: f64 = f64::EPSILON;
        let (impact, Body::Heavy(body)) = (event.impact?, hoop.body()) else {
            return None;
        };
        let ContactVelocities {
            theta_rate,
            slip,
            gap_rate,
        } = impact.before;
        let [spin, slip, gap_rate] = [theta_rate, slip, gap_rate].map(f64::abs);
        // A velocity of the contact point is a sum of four terms, none of which is more than twice
        // these, and each transition passes on what those before it have left.
        let velocity = 8.0 * EPSILON * (earlier + 1) as f64 * (spin + gap_rate);
        // A velocity is changed by an impulse over the mass or more, and each impulse is a sum of
        // up to four pieces of this size.
        let Impulse { normal, friction } = impact.impulse;
        let impulse = body.mass * velocity + 4.0 * EPSILON * libm::hypot(normal, friction);
        // The energies before and after, whose difference is lost, have three squares each, of
        // sums of terms of these sizes. Friction works on the slip, rounding and all.
        let across = slip + (1.0 + body.h) * spin;
        let up = gap_rate + body.h * spin;
        let size = body.mass * (across * across + up * up) + body.inertia * spin * spin;
        let energy = 4.0 * EPSILON * size + friction.abs() * velocity;

        let seen = |value: f64, rounding: f64| if value.abs() > rounding { value } else { 0.0 };
        let velocities = |it: ContactVelocities| ContactVelocities {
            theta_rate: it.theta_rate,
            slip: seen(it.slip, velocity),
            gap_rate: seen(it.gap_rate, velocity),
        };
        Some(Self {
            before: velocities(impact.before),
            after: velocities(impact.after),
            impulse: Impulse {
                normal: seen(normal, impulse),
                friction: seen(friction, impulse),
            },
            energy_lost: seen(impact.energy_lost(), energy),
        })
    }
}

/// The impact with which a motion begins at a start that has been classified, if no motion is
/// consistent there and the hoop has a coefficient of restitution.
pub fn jam_of(hoop: &Hoop, start: Start, found: &Classification) -> Option<Impact> {
    found
        .candidates
        .filter(|candidates| candidates.count() == 0)?;
    hoop.jam(&State::from(start))
}
