//! The freely falling particle of a gliding hoop.
//!
//! With its depth a = ℓ̂(1 − cos θ) below the top, its height b = ℓ̂(1 + cos θ) above the bottom,
//! and z = −V = Δτ − V0,
//!
//! ```text
//! a = a0 + f,   b = b0 − f,   z² = V0² + 2f,   f = Δτ (Δτ/2 − V0).
//! ```
//!
//! Each is computed from terms that do not cancel: near the end of the glide from the time left,
//! and at the end exactly.

use core::f64::consts::TAU;

use crate::model::{Massless, State};

/// Least angle from the top. Nearer to it squares of the angle could underflow.
const LEAST_ANGLE: f64 = 1e-60;

/// Least depth at which the particle is no longer next to the top, where the angle is less than
/// 1e-40 or so.
const DEPTH_BESIDE_TOP: f64 = 1e-80;

/// A product that keeps its sign where it underflows: signs of such products decide.
pub(super) fn signed_product<const N: usize>(factors: [f64; N]) -> f64 {
    let product = factors
        .into_iter()
        .fold(1.0, |product, factor| product * factor);
    if product != 0.0 || factors.contains(&0.0) {
        product
    } else {
        f64::from_bits(1).copysign(product)
    }
}

/// The power of two by which a glide is followed from a larger angle. Next to the top θ² (1 − ℓ̂
/// θ′²) is constant, so that angles, heights of the turning points over θ and times have no scale
/// of their own.
pub(super) fn magnification(theta: f64) -> f64 {
    let mut factor = 1.0;
    // Exact, also of the smallest numbers.
    while theta != 0.0 && (theta * factor).abs() < LEAST_ANGLE {
        factor *= 4_294_967_296.0;
    }
    factor
}

/// The motion of the particle from the start of a glide.
#[derive(Clone, Copy, Debug)]
pub(super) struct Particle {
    start: State,
    pub(super) offset: f64,
    pub(super) pull: f64,
    /// 1 − ℓ̂.
    pub(super) inside: f64,
    /// Multiple of 2π to which the angle belongs, and the side of the vertical on which the
    /// particle is.
    turns: f64,
    pub(super) side: f64,
    /// a0 and b0.
    pub(super) below_top: f64,
    pub(super) above_bottom: f64,
    /// V0.
    pub(super) rise: f64,
    pub(super) momentum: f64,
    /// Position of the mass centre along the plane at the start.
    mass_centre: f64,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct ParticleState {
    pub(super) elapsed: f64,
    /// a and b.
    pub(super) below_top: f64,
    pub(super) above_bottom: f64,
    /// z.
    pub(super) fall_rate: f64,
}

impl ParticleState {
    /// Whether the particle is so near to the top that a glide has no scale there.
    pub(super) fn is_beside_top(&self) -> bool {
        self.below_top < DEPTH_BESIDE_TOP
    }

    /// |ℓ̂ sin θ|.
    pub(super) fn arm(&self) -> f64 {
        let square = self.below_top * self.above_bottom;
        // Next to the top of a small ℓ̂ the square underflows.
        if square < f64::MIN_POSITIVE {
            self.below_top.sqrt() * self.above_bottom.sqrt()
        } else {
            square.sqrt()
        }
    }

    /// The place at this time before.
    pub(super) fn before(&self, time: f64) -> Self {
        let fallen = time * (self.fall_rate - 0.5 * time);
        Self {
            elapsed: self.elapsed - time,
            below_top: self.below_top - fallen,
            above_bottom: self.above_bottom + fallen,
            fall_rate: self.fall_rate - time,
        }
    }
}

impl Particle {
    pub(super) fn new(body: &Massless, start: &State) -> Self {
        let l = body.offset;
        let (sin, cos) = libm::sincos(0.5 * start.theta);
        let sine = libm::sin(start.theta);
        // At the top the direction of motion decides the side.
        let side = if sine < 0.0 || (sine == 0.0 && start.theta_rate < 0.0) {
            -1.0
        } else {
            1.0
        };
        let inside = 1.0 - l;
        let above_bottom = 2.0 * l * cos * cos;
        Self {
            start: *start,
            offset: l,
            pull: body.pull(),
            inside,
            // The side fixes the number of turns; next to the bottom the angle alone would be
            // ambiguous.
            turns: (start.theta / TAU - 0.25 * side).round(),
            side,
            below_top: 2.0 * l * sin * sin,
            above_bottom,
            rise: signed_product([-l, sine, start.theta_rate]),
            momentum: start.slip - start.theta_rate * (inside + above_bottom),
            mass_centre: start.x - l * sine,
        }
    }

    /// Rate θ′ at the start, and its square.
    pub(super) fn spin(&self) -> (f64, f64) {
        (
            self.start.theta_rate,
            self.start.theta_rate * self.start.theta_rate,
        )
    }

    /// z² at the bottom, V0² + 2 b0.
    pub(super) fn square_at_bottom(&self) -> f64 {
        self.above_bottom * (self.below_top * self.spin().1 + 2.0)
    }

    /// z² at the top, V0² − 2 a0: negative if the particle turns back before.
    pub(super) fn square_at_top(&self) -> f64 {
        signed_product([self.below_top, self.above_bottom * self.spin().1 - 2.0])
    }

    /// Time to θ = ±π (3.20), where ȳ = 1 − ℓ̂.
    fn time_to_bottom(&self) -> f64 {
        let root = self.square_at_bottom().sqrt();
        if self.rise >= 0.0 {
            self.rise + root
        } else {
            2.0 * self.above_bottom / (root - self.rise)
        }
    }

    /// Whether the particle reaches the top with upward velocity left.
    pub(super) fn reaches_top(&self) -> bool {
        self.rise > 0.0 && self.square_at_top() > 0.0
    }

    /// Times to θ = 0 on the way up and on the way down of the free fall, if the particle reaches
    /// the top.
    fn times_to_top(&self) -> Option<(f64, f64)> {
        self.reaches_top().then(|| {
            let late = self.rise + self.square_at_top().sqrt();
            (2.0 * self.below_top / late, late)
        })
    }

    /// The end of the glide if the slip does not vanish before.
    pub(super) fn end(&self) -> ParticleState {
        let height = 2.0 * self.offset;
        match self.times_to_top() {
            Some((elapsed, _)) => ParticleState {
                elapsed,
                below_top: 0.0,
                above_bottom: height,
                fall_rate: -self.square_at_top().sqrt(),
            },
            None => ParticleState {
                elapsed: self.time_to_bottom(),
                below_top: height,
                above_bottom: 0.0,
                fall_rate: self.square_at_bottom().sqrt(),
            },
        }
    }

    /// The particle after the time `elapsed`, before the end.
    pub(super) fn place(&self, elapsed: f64) -> ParticleState {
        let fall_rate = elapsed - self.rise;
        let below_top = match self.times_to_top() {
            Some((early, late)) => 0.5 * (early - elapsed) * (late - elapsed),
            None if self.rise > 0.0 => 0.5 * (fall_rate * fall_rate - self.square_at_top()),
            None => self.below_top + elapsed * (0.5 * elapsed - self.rise),
        };
        let to_bottom = self.time_to_bottom();
        let above_bottom =
            0.5 * (to_bottom - elapsed) * (elapsed + 2.0 * self.above_bottom / to_bottom);
        ParticleState {
            elapsed,
            below_top: below_top.max(0.0),
            above_bottom: above_bottom.max(0.0),
            fall_rate,
        }
    }

    pub(super) fn state(&self, place: &ParticleState) -> State {
        let arm = place.arm();
        let half_angle = libm::atan2(place.below_top.sqrt(), place.above_bottom.sqrt());
        let rate = if arm == 0.0 && place.fall_rate == 0.0 {
            // It comes to the top with no velocity left: z² = 2a there.
            -self.side / self.offset.sqrt()
        } else {
            self.side * place.fall_rate / arm
        };
        let lever = self.inside + place.above_bottom;
        let lost = self.pull * place.elapsed;
        let momentum = self.momentum - lost;
        State {
            time: self.start.time + place.elapsed,
            theta: TAU * self.turns + self.side * 2.0 * half_angle,
            theta_rate: rate,
            // For ℓ̂ = 1 the lever vanishes at the bottom, where the rate is infinite.
            slip: if lever == 0.0 {
                momentum
            } else {
                momentum + rate * lever
            },
            x: self.mass_centre + (self.momentum - 0.5 * lost) * place.elapsed + self.side * arm,
        }
    }
}
