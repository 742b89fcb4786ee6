//! Gliding of a massless hoop (§3c–e): in contact with the plane, without any force from it, N = F = 0.
//!
//! The particle falls freely (3.19) and the hoop, which has no mass, follows: ȳ = 1 + ℓ̂ cos θ, x̄′ = η′ − θ′(1 + ℓ̂c).
//! Everything is algebraic in the time: with V = ȳ′ = V0 − Δτ,
//!
//! ```text
//! ℓ̂ (1 − cos θ) = 2 ℓ̂ sin²(θ0/2) − V0 Δτ + Δτ²/2,    θ′ = −V/(ℓ̂ sin θ),    η′ = v + θ′ (1 + ℓ̂ cos θ).
//! ```
//!
//! Conserved are the vertical energy of the particle w = ½ ℓ̂² sin²θ θ′² + ℓ̂ cos θ (the w printed in (3.18) is not
//! conserved by (3.17)), the energy e_s and the horizontal momentum v.

use core::f64::consts::{PI, TAU};

use crate::bernstein::{Bernstein, Bracket};
use crate::hoop::{Hoop, Massless};
use crate::mode::{Direction, Mode};
use crate::sample::{Instant, Sample};
use crate::state::State;

/// A phase of gliding in one direction of slip.
#[derive(Clone, Copy, Debug)]
pub struct Gliding {
    offset: f64,
    start: State,
    direction: Option<Direction>,
    particle: Particle,
    duration: f64,
    limit_of_small_inertia: bool,
}

/// Integrals of gliding (3.18), with the first one corrected.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GlidingIntegrals {
    /// Vertical energy of the particle about the centre, w = ½ ℓ̂² sin²θ θ′² + ℓ̂ cos θ.
    pub w: f64,
    /// Total energy e_s.
    pub energy: f64,
    /// Horizontal momentum v = η′ − θ′ (1 + ℓ̂ cos θ).
    pub momentum: f64,
}

impl GlidingIntegrals {
    /// At a state of a massless hoop.
    #[must_use]
    pub fn at(hoop: &Massless, theta: f64, theta_rate: f64, slip: f64) -> Self {
        let (sin, cos) = libm::sincos(theta);
        let l = hoop.offset;
        let rise = l * sin * theta_rate;
        let momentum = slip - theta_rate * (1.0 + l * cos);
        Self {
            w: 0.5 * rise * rise + l * cos,
            energy: 0.5 * (rise * rise + momentum * momentum) + l * cos,
            momentum,
        }
    }
}

/// Accelerations θ″ and η″ of gliding (3.17), for a particle at 0 < ℓ̂ ≤ 1. Not defined at θ = 0, ±π.
#[must_use]
pub fn gliding_accelerations(hoop: &Massless, theta: f64, theta_rate: f64) -> (f64, f64) {
    let (sin, cos) = libm::sincos(theta);
    let l = hoop.offset;
    let u = theta_rate * theta_rate;
    ((1.0 - l * cos * u) / (l * sin), (1.0 + l * cos - u * l * (l + cos)) / (l * sin))
}

/// How a phase of gliding ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum GlidingEnd {
    /// η′ = 0.
    Rest(State),
    /// The particle comes down to its lowest place under the centre, θ = ±π, with unbounded θ′ (3.20). The state has
    /// an infinite rate.
    Bottom(State),
    /// The particle comes up to its highest place with velocity to spare: it would lift the hoop.
    Top(State),
    /// The time limit.
    TimeLimit(State),
}

/// The falling particle.
#[derive(Clone, Copy, Debug)]
struct Particle {
    offset: f64,
    /// Multiple of 2π nearest to the angle, and the side of the vertical on which the particle is.
    turns: f64,
    side: f64,
    /// ℓ̂(1 − cos θ) and ℓ̂(1 + cos θ) at the start.
    below_top: f64,
    above_bottom: f64,
    /// V0.
    rise: f64,
    /// v.
    momentum: f64,
}

impl Particle {
    fn new(body: &Massless, start: &State) -> Self {
        let l = body.offset;
        let (sin, cos) = libm::sincos(0.5 * start.theta);
        let turns = (start.theta / TAU).round();
        let sine = libm::sin(start.theta);
        // Through the top the particle passes to the side it moves to.
        let side = if sine == 0.0 { start.theta_rate } else { sine };
        Self {
            offset: l,
            turns,
            side: if side < 0.0 { -1.0 } else { 1.0 },
            below_top: 2.0 * l * sin * sin,
            above_bottom: 2.0 * l * cos * cos,
            rise: -l * sine * start.theta_rate,
            momentum: start.slip - start.theta_rate * (1.0 + l * libm::cos(start.theta)),
        }
    }

    /// ℓ̂(1 − cos θ) and ℓ̂(1 + cos θ).
    fn heights(&self, elapsed: f64) -> (f64, f64) {
        let fall = elapsed * (0.5 * elapsed - self.rise);
        (self.below_top + fall, self.above_bottom - fall)
    }

    /// θ, θ′, η′.
    fn position(&self, elapsed: f64) -> (f64, f64, f64) {
        let (below_top, above_bottom) = self.heights(elapsed);
        let (below_top, above_bottom) = (below_top.max(0.0), above_bottom.max(0.0));
        let theta = TAU * self.turns + self.side * 2.0 * libm::atan2(below_top.sqrt(), above_bottom.sqrt());
        // |ℓ̂ sin θ|
        let arm = (below_top * above_bottom).sqrt();
        let rate = self.side * (elapsed - self.rise) / arm;
        (theta, rate, self.momentum + rate * (1.0 - self.offset + above_bottom))
    }

    /// Time to θ = ±π (3.20): ȳ = 1 − ℓ̂.
    fn time_to_bottom(&self) -> f64 {
        let root = (self.rise * self.rise + 2.0 * self.above_bottom).sqrt();
        if self.rise >= 0.0 { self.rise + root } else { 2.0 * self.above_bottom / (root - self.rise) }
    }

    /// Time to θ = 0 if the particle comes up with velocity to spare.
    fn time_to_top(&self) -> Option<f64> {
        let spare = self.rise * self.rise - 2.0 * self.below_top;
        (self.rise > 0.0 && spare > 0.0).then(|| 2.0 * self.below_top / (self.rise + spare.sqrt()))
    }

    /// η′ as θ → ±π or 0: θ′ is unbounded there, but with the particle on the rim its lever 1 + ℓ̂c vanishes at θ = ±π.
    fn final_slip(&self, at_top: bool) -> f64 {
        if at_top {
            -self.side * f64::INFINITY
        } else if self.offset < 1.0 {
            self.side * f64::INFINITY
        } else {
            self.momentum
        }
    }

    /// Times in (0, end) at which η″ changes sign, from (1 + ℓ̂c) (ℓ̂ sin θ)² = V² ℓ̂ (ℓ̂ + c), a polynomial of degree
    /// six in Δτ. `from_extremum` divides out the root at the start.
    fn slip_extrema(&self, end: f64, from_extremum: bool) -> Vec<f64> {
        let l = self.offset;
        let below_top = [self.below_top, -self.rise, 0.5];
        let above_bottom = [self.above_bottom, self.rise, -0.5];
        let velocity = [-self.rise, 1.0];
        let mut lever = above_bottom;
        lever[0] += 1.0 - l;
        // ℓ̂(ℓ̂ + c)
        let mut pull = above_bottom;
        pull[0] -= l * (1.0 - l);
        let arm: [f64; 5] = product(&below_top, &above_bottom);
        let square: [f64; 3] = product(&velocity, &velocity);
        let polynomial = if l == 1.0 {
            // Both sides have the factor 1 + cos θ, which vanishes at the end: sin²θ = V².
            difference(&arm, &square).to_vec()
        } else {
            let held: [f64; 7] = product(&arm, &lever);
            let pulled: [f64; 5] = product(&square, &pull);
            difference(&held, &pulled).to_vec()
        };
        sign_changes(if from_extremum { &polynomial[1..] } else { &polynomial[..] }, end)
    }
}

/// Product of two polynomials.
fn product<const P: usize, const Q: usize, const R: usize>(p: &[f64; P], q: &[f64; Q]) -> [f64; R] {
    let mut result = [0.0; R];
    for (i, a) in p.iter().enumerate() {
        for (j, b) in q.iter().enumerate() {
            result[i + j] += a * b;
        }
    }
    result
}

/// Difference of two polynomials, the second not of higher degree.
fn difference<const P: usize, const Q: usize>(p: &[f64; P], q: &[f64; Q]) -> [f64; P] {
    let mut result = *p;
    for (a, b) in result.iter_mut().zip(q) {
        *a -= b;
    }
    result
}

/// All points of (0, end) at which a polynomial changes sign.
fn sign_changes(coefficients: &[f64], end: f64) -> Vec<f64> {
    let mut roots: Vec<f64> = Vec::new();
    let mut taylor = coefficients.to_vec();
    let mut origin = 0.0;
    loop {
        let width = end - origin;
        let mut rest = Bernstein::from_taylor(&taylor, width);
        if rest.initial_sign() < 0.0 {
            rest = rest.negated();
        }
        let Some(bracket) = rest.first_crossing() else { return roots };
        let root = origin + width * bracket.refine(|x| rest.value_and_slope(x));
        if root <= origin || root >= end {
            return roots;
        }
        roots.push(root);
        taylor = shifted(coefficients, root);
        // The root itself must not be found again: what follows is judged by the next coefficient.
        taylor[0] = 0.0;
        origin = root;
    }
}

/// Coefficients about another centre.
fn shifted(coefficients: &[f64], by: f64) -> Vec<f64> {
    let mut work = coefficients.to_vec();
    for level in 0..work.len() {
        for i in (level..work.len() - 1).rev() {
            work[i] += by * work[i + 1];
        }
    }
    work
}

impl Gliding {
    /// Follows the glide to its end, or for the time `allowed`. `from_extremum` where η″ = 0 at the start because
    /// the phase begins on N = 0 of rolling, and η′ = 0.
    pub(crate) fn run(
        body: &Massless,
        mu_k: f64,
        start: State,
        from_extremum: bool,
        allowed: Option<f64>,
    ) -> (Self, GlidingEnd) {
        let particle = Particle::new(body, &start);
        let to_top = particle.time_to_top();
        let limit = to_top.unwrap_or_else(|| particle.time_to_bottom());
        let rest = Rest::find(&particle, start.slip, from_extremum, limit, to_top.is_some());
        let mut glide = Self {
            offset: body.offset,
            start,
            direction: rest.direction,
            particle,
            duration: 0.0,
            limit_of_small_inertia: true,
        };
        let (duration, event) = match rest.at {
            Some(at) => (at, Some(true)),
            None => (limit, Some(false)),
        };
        let (duration, event) = match allowed {
            Some(allowed) if allowed < duration => (allowed, None),
            _ => (duration, event),
        };
        glide.duration = duration;
        glide.limit_of_small_inertia = glide.is_limit_of_small_inertia(mu_k);
        let state = glide.state(duration);
        let end = match event {
            None => GlidingEnd::TimeLimit(state),
            Some(true) => GlidingEnd::Rest(State { slip: 0.0, ..state }),
            Some(false) if to_top.is_some() => GlidingEnd::Top(State {
                theta: TAU * particle.turns,
                theta_rate: -particle.side * f64::INFINITY,
                slip: particle.final_slip(true),
                ..state
            }),
            Some(false) => GlidingEnd::Bottom(State {
                theta: TAU * particle.turns + particle.side * PI,
                theta_rate: particle.side * f64::INFINITY,
                slip: particle.final_slip(false),
                ..state
            }),
        };
        (glide, end)
    }

    /// Direction of slip; none if the contact point stays at rest throughout.
    #[must_use]
    pub const fn direction(&self) -> Option<Direction> {
        self.direction
    }

    /// Whether this phase is the limit of the motions of a heavy hoop as its inertia vanishes. It is not where μk σ sin θ is positive
    /// and |sin θ|ℓ̂ < μk (1 + ℓ̂ cos θ): a sliding hoop of small inertia has no such motion (Painlevé).
    #[must_use]
    pub const fn is_small_inertia_limit(&self) -> bool {
        self.limit_of_small_inertia
    }

    fn is_limit_of_small_inertia(&self, mu_k: f64) -> bool {
        let Some(direction) = self.direction else { return true };
        if direction.sign() * self.particle.side < 0.0 {
            return true;
        }
        // ℓ̂|sin θ|/(1 + ℓ̂ cos θ) has one maximum on a side, so it is least at the ends and where θ turns back.
        let turning = self.particle.rise;
        let turns = (turning > 0.0 && turning < self.duration).then_some(turning);
        [0.0, self.duration].into_iter().chain(turns).all(|elapsed| {
            let (below_top, above_bottom) = self.particle.heights(elapsed);
            let arm = (below_top.max(0.0) * above_bottom.max(0.0)).sqrt();
            arm >= mu_k * (1.0 - self.offset + above_bottom)
        })
    }

    /// State after the time `elapsed`.
    #[must_use]
    pub fn state(&self, elapsed: f64) -> State {
        if elapsed == 0.0 {
            return self.start;
        }
        let (theta, theta_rate, slip) = self.particle.position(elapsed);
        let l = self.offset;
        let mass_centre = self.start.x - l * libm::sin(self.start.theta) + self.particle.momentum * elapsed;
        State {
            time: self.start.time + elapsed,
            theta,
            theta_rate,
            slip,
            x: mass_centre + l * libm::sin(theta),
        }
    }

    pub(crate) fn sample(&self, hoop: &Hoop, state: State) -> Sample {
        let body = Massless { offset: self.offset };
        let instant = Instant {
            mode: Mode::Gliding,
            direction: self.direction,
            accelerations: gliding_accelerations(&body, state.theta, state.theta_rate),
            forces: (0.0, 0.0),
            gap: (0.0, 0.0),
        };
        instant.sample(hoop, state)
    }
}

/// Direction of slip and the first time in (0, end) at which η′ = 0, if any.
struct Rest {
    direction: Option<Direction>,
    at: Option<f64>,
}

impl Rest {
    /// η′ is monotone between the zeros of η″, and its sign at the end is known.
    fn find(particle: &Particle, slip: f64, from_extremum: bool, end: f64, to_top: bool) -> Self {
        let mut direction = Direction::of_sign(slip);
        let mut from = 0.0;
        let extrema = particle.slip_extrema(end, from_extremum);
        for to in extrema.into_iter().chain([end]) {
            let value = if to < end { particle.position(to).2 } else { particle.final_slip(to_top) };
            match direction {
                None => direction = Direction::of_sign(value),
                Some(known) if value * known.sign() < 0.0 => {
                    let at = Bracket { low: from, high: to }.refine(|elapsed| {
                        let (theta, theta_rate, slip) = particle.position(elapsed);
                        let body = Massless { offset: particle.offset };
                        let slope = gliding_accelerations(&body, theta, theta_rate).1;
                        (known.sign() * slip, known.sign() * slope)
                    });
                    return Self { direction, at: Some(at) };
                }
                Some(_) => {}
            }
            from = to;
        }
        Self { direction, at: None }
    }
}
