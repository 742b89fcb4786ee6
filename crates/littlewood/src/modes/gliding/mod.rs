//! Gliding of a massless hoop (§3c–e): contact with N = F = 0 (docs/theory/massless.md).
//!
//! The particle falls freely (3.19) and the massless hoop follows. With V = ȳ′ = V0 − Δτ and the
//! momentum v, which decreases by τ tan α on a slope,
//!
//! ```text
//! ℓ̂ (1 − cos θ) = 2 ℓ̂ sin²(θ0/2) − V0 Δτ + Δτ²/2,    θ′ = −V/(ℓ̂ sin θ),    η′ = v + θ′ (1 + ℓ̂ cos θ).
//! ```

mod particle;
mod rest;
mod tilted;

use crate::math::number::Number;
use crate::math::trig::Angle;
use crate::mechanics::{Accelerations, Clearance, ContactForces, Loads, energy};
use crate::model::{Friction, Hoop, Massless, Mode, SlipDirection, State};
use crate::modes::{Instant, Sample};

use self::particle::{Particle, ParticleState, magnification, signed_product};
pub(crate) use self::rest::GlideEntry;
use self::rest::Slip;

/// A phase of gliding in one direction of slip.
#[derive(Clone, Copy, Debug)]
pub struct Gliding {
    body: Massless,
    start: State,
    direction: SlipDirection,
    /// Followed from the angle of the start times `magnification`.
    particle: Particle,
    magnification: f64,
    /// The magnification of a glide that ends next to the top; 1 of others.
    scale: f64,
    limit_of_small_inertia: bool,
}

/// First integrals of gliding (3.18), with w corrected.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlidingIntegrals {
    /// Energy of the particle normal to the plane about the centre, w = ½ ℓ̂² sin²θ θ′² + ℓ̂ cos θ
    /// cos α.
    pub w: f64,
    /// Total energy e_s; on a slope without that of the fall along the plane.
    pub energy: f64,
    /// Momentum along the plane v = η′ − θ′ (1 + ℓ̂ cos θ), which decreases by sin α in a unit of
    /// time.
    pub momentum: f64,
}

impl GlidingIntegrals {
    /// At a state of a massless hoop.
    #[must_use]
    pub fn at(hoop: &Massless, state: &State) -> Self {
        let State {
            theta,
            theta_rate,
            slip,
            ..
        } = *state;
        let (sin, cos) = libm::sincos(theta);
        let l = hoop.offset;
        let rise = l * sin * theta_rate;
        let momentum = slip - theta_rate * (1.0 + l * cos);
        let height = hoop.weight() * (l * cos);
        let energy = 0.5 * (rise * rise + momentum * momentum) + height;
        Self {
            w: 0.5 * rise * rise + height,
            energy,
            momentum,
        }
    }
}

/// Accelerations θ″ and η″ of gliding (3.17), for a particle at 0 < ℓ̂ ≤ 1. Not defined at θ = 0,
/// ±π.
pub fn gliding_accelerations(hoop: &Massless, theta: f64, theta_rate: f64) -> (f64, f64) {
    let loads = Loads {
        gravity: hoop.weight(),
        u: theta_rate * theta_rate,
    };
    let accelerations = accelerations(hoop.offset, hoop.pull(), loads, theta.angle());
    (accelerations.theta, accelerations.slip)
}

/// θ″ and η″ from ℓ̂ and the pull of the slope.
pub(crate) fn accelerations<T: Number>(
    offset: T,
    pull: T,
    Loads { gravity, u }: Loads<T>,
    Angle { sin, cos }: Angle<T>,
) -> Accelerations<T> {
    let offset_sin = offset * sin;
    Accelerations {
        theta: (gravity - offset * cos * u) / offset_sin,
        slip: (gravity * (offset * cos + 1.0) - u * offset * (offset + cos)) / offset_sin
            - pull * gravity,
    }
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum GlidingEnd {
    /// η′ = 0; `presses` if the normal force of rolling is positive there.
    Rest { state: State, presses: bool },
    /// θ′ = 0, with rolling resistance: the particle is at its highest point.
    TurningPoint(State),
    /// The particle reaches its lowest point, θ = ±π, with unbounded θ′ (3.20). The rate of the
    /// state is infinite.
    Bottom(State),
    /// The particle reaches its highest point with upward velocity left: it would lift the hoop.
    Top(State),
    /// The time limit.
    TimeLimit(State),
}

impl Gliding {
    /// Follows the glide to its end, or for the time `allowed`.
    pub(crate) fn run(
        body: &Massless,
        friction: Friction,
        start: State,
        entry: GlideEntry,
        allowed: Option<f64>,
    ) -> (Self, GlidingEnd) {
        let magnification = magnification(start.theta);
        let particle = Particle::new(
            body,
            &State {
                theta: start.theta * magnification,
                ..start
            },
        );
        let slip = if particle.pull == 0.0 {
            Slip::of(&particle, start.slip, entry)
        } else {
            tilted::slip(&particle, start.slip, entry)
        };
        let mut last = slip.rest.unwrap_or_else(|| particle.end());
        let rise = particle.rise;
        let turns = friction.rolling_resistance > 0.0 && rise > 0.0 && rise < last.elapsed;
        if turns {
            last = particle.place(rise);
        }
        let scale = if last.is_beside_top() {
            magnification
        } else {
            1.0
        };
        let is_stopped = allowed.is_some_and(|allowed| allowed < last.elapsed / scale);
        let place = match allowed {
            Some(allowed) if is_stopped => particle.place(allowed * scale),
            Some(_) | None => last,
        };
        let mut glide = Self {
            body: *body,
            start,
            direction: slip.direction,
            particle,
            magnification,
            scale,
            limit_of_small_inertia: true,
        };
        glide.limit_of_small_inertia = glide.is_limit_of_small_inertia(friction, &place);
        let state = glide.state_at(&place);
        let end = if is_stopped {
            GlidingEnd::TimeLimit(if place.elapsed == 0.0 { start } else { state })
        } else if turns {
            GlidingEnd::TurningPoint(State {
                theta_rate: 0.0,
                ..state
            })
        } else if slip.rest.is_some() {
            // N of rolling has the sign of η″ towards the particle, and η″ the sign of the slip
            // that follows.
            GlidingEnd::Rest {
                state: State { slip: 0.0, ..state },
                presses: slip.direction.sign() * particle.side < 0.0,
            }
        } else if particle.reaches_top() {
            GlidingEnd::Top(state)
        } else {
            GlidingEnd::Bottom(state)
        };
        (glide, end)
    }

    /// Direction of slip.
    pub const fn direction(&self) -> Option<SlipDirection> {
        Some(self.direction)
    }

    /// Whether this phase is the limit of sliding of a heavy hoop as its inertia vanishes. The
    /// limit does not exist where μk σ sin θ > 0 and |sin θ|ℓ̂ < μk (1 + ℓ̂ cos θ) (Painlevé); with
    /// rolling resistance where |sin θ|ℓ̂ < sign(sin θ) (μk σ (1 + ℓ̂ cos θ) + ς χ).
    pub const fn is_small_inertia_limit(&self) -> bool {
        self.limit_of_small_inertia
    }

    fn is_limit_of_small_inertia(&self, friction: Friction, end: &ParticleState) -> bool {
        let particle = &self.particle;
        let mut mu_k = friction.mu_k;
        let mut drag = 0.0;
        if friction.rolling_resistance > 0.0 {
            // A glide begins to turn, and ends where θ′ vanishes; the particle rises where the angle
            // from the top falls.
            let rises = particle.rise > 0.0;
            drag = if rises {
                -friction.rolling_resistance
            } else {
                friction.rolling_resistance
            };
            mu_k *= self.direction.sign() * particle.side;
        } else if self.direction.sign() * particle.side < 0.0 {
            return true;
        }
        // ℓ̂|sin θ|/(1 + ℓ̂ cos θ) has one maximum on a side, so its minimum lies at an end or
        // where θ′ = 0.
        let turning = particle.rise;
        let turns = (turning > 0.0 && turning < end.elapsed).then(|| particle.place(turning));
        let start = [Some(particle.place(0.0)), turns];
        start
            .into_iter()
            .flatten()
            .map(|place| (place, self.magnification))
            .chain([(*end, self.scale)])
            .all(|(place, scale)| {
                place.arm() / scale >= mu_k * (particle.inside + place.above_bottom) + drag
            })
    }

    /// The state at a place of the particle.
    fn state_at(&self, place: &ParticleState) -> State {
        let state = self.particle.state(place);
        if self.scale == 1.0 {
            return state;
        }
        State {
            time: self.start.time + place.elapsed / self.scale,
            // The particle stays on its side.
            theta: signed_product([state.theta, 1.0 / self.scale]),
            x: self.start.x + (state.x - self.start.x) / self.scale,
            ..state
        }
    }

    /// State after the time `elapsed`.
    pub fn state(&self, elapsed: f64) -> State {
        if elapsed == 0.0 {
            self.start
        } else {
            self.state_at(&self.particle.place(elapsed * self.scale))
        }
    }

    pub(crate) fn sample(&self, hoop: &Hoop, state: State) -> Sample {
        let instant = Instant {
            mode: Mode::Gliding,
            direction: Some(self.direction),
            accelerations: accelerations(
                self.body.offset,
                self.body.pull(),
                Loads::of(state.theta_rate * state.theta_rate),
                state.theta.angle(),
            ),
            forces: ContactForces::NONE,
            couple: 0.0,
            clearance: Clearance::NONE,
        };
        let mut sample = instant.sample(hoop, state);
        let is_infinite = state.theta_rate.is_infinite();
        if is_infinite || hoop.undecided_place(state.theta).is_some() {
            // At the bottom the particle has its velocity, but no arm, or next to it one that the
            // angle does not tell: the energy is that of the whole glide.
            sample.energy = energy(hoop, &self.start, 0.0, 0.0);
        }
        if is_infinite {
            // The accelerations tend to infinity.
            sample.theta_acceleration = self.particle.side * f64::INFINITY;
            let towards = if self.particle.inside > 0.0 {
                1.0
            } else {
                -1.0
            };
            sample.slip_acceleration = towards * sample.theta_acceleration;
        }
        sample
    }
}
