//! The falling particle that a gliding hoop follows.
//!
//! With a = ℓ̂(1 − cos θ) and b = ℓ̂(1 + cos θ), the heights below the top and above the bottom of its way, and z = −V = Δτ − V0,
//!
//! ```text
//! a = a0 + f,   b = b0 − f,   z² = V0² + 2f,   f = Δτ (Δτ/2 − V0).
//! ```
//!
//! Each is computed from terms that do not cancel: next to the end of the glide from the time that is left, at the end itself
//! exactly.

use core::f64::consts::TAU;

use crate::model::{Massless, State};

/// The particle from the start of a glide.
#[derive(Clone, Copy, Debug)]
pub(super) struct Particle {
    start: State,
    pub(super) offset: f64,
    /// 1 − ℓ̂.
    pub(super) inside: f64,
    /// Multiple of 2π to which the angle belongs, and the side of the vertical on which the particle is.
    turns: f64,
    pub(super) side: f64,
    /// a0 and b0.
    pub(super) below_top: f64,
    pub(super) above_bottom: f64,
    /// V0.
    pub(super) rise: f64,
    /// v.
    pub(super) momentum: f64,
    /// Place of the mass centre.
    mass_centre: f64,
}

/// Where the particle is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    pub(super) elapsed: f64,
    /// a and b.
    pub(super) below_top: f64,
    pub(super) above_bottom: f64,
    /// z.
    pub(super) fall_rate: f64,
}

impl Place {
    /// |ℓ̂ sin θ|.
    pub(super) fn arm(&self) -> f64 {
        (self.below_top * self.above_bottom).sqrt()
    }
}

impl Particle {
    pub(super) fn new(body: &Massless, start: &State) -> Self {
        let l = body.offset;
        let (sin, cos) = libm::sincos(0.5 * start.theta);
        let sine = libm::sin(start.theta);
        // Through the top the particle passes to the side it moves to.
        let side = if sine < 0.0 || (sine == 0.0 && start.theta_rate < 0.0) { -1.0 } else { 1.0 };
        let inside = 1.0 - l;
        let above_bottom = 2.0 * l * cos * cos;
        Self {
            start: *start,
            offset: l,
            inside,
            // On its side the angle is within (0, π) of the top, which next to the bottom only the side tells.
            turns: (start.theta / TAU - 0.25 * side).round(),
            side,
            below_top: 2.0 * l * sin * sin,
            above_bottom,
            rise: -l * sine * start.theta_rate,
            momentum: start.slip - start.theta_rate * (inside + above_bottom),
            mass_centre: start.x - l * sine,
        }
    }

    /// Rate θ′ at the start, and its square.
    pub(super) fn spin(&self) -> (f64, f64) {
        (self.start.theta_rate, self.start.theta_rate * self.start.theta_rate)
    }

    /// z² at the bottom, V0² + 2 b0.
    pub(super) fn square_at_bottom(&self) -> f64 {
        self.above_bottom * (self.below_top * self.spin().1 + 2.0)
    }

    /// z² at the top, V0² − 2 a0: negative if the particle turns back before.
    pub(super) fn square_at_top(&self) -> f64 {
        self.below_top * (self.above_bottom * self.spin().1 - 2.0)
    }

    /// Time to θ = ±π (3.20): ȳ = 1 − ℓ̂.
    fn time_to_bottom(&self) -> f64 {
        let root = self.square_at_bottom().sqrt();
        if self.rise >= 0.0 { self.rise + root } else { 2.0 * self.above_bottom / (root - self.rise) }
    }

    /// Whether the particle comes up to the top with velocity to spare.
    pub(super) fn reaches_top(&self) -> bool {
        self.rise > 0.0 && self.square_at_top() > 0.0
    }

    /// Times to θ = 0, going up and coming down again, if the particle gets there.
    fn times_to_top(&self) -> Option<(f64, f64)> {
        self.reaches_top().then(|| {
            let late = self.rise + self.square_at_top().sqrt();
            (2.0 * self.below_top / late, late)
        })
    }

    /// Where the glide ends if the slip does not end it before.
    pub(super) fn end(&self) -> Place {
        let height = 2.0 * self.offset;
        match self.times_to_top() {
            Some((elapsed, _)) => Place {
                elapsed,
                below_top: 0.0,
                above_bottom: height,
                fall_rate: -self.square_at_top().sqrt(),
            },
            None => Place {
                elapsed: self.time_to_bottom(),
                below_top: height,
                above_bottom: 0.0,
                fall_rate: self.square_at_bottom().sqrt(),
            },
        }
    }

    /// Where the particle is after a time before the end.
    pub(super) fn place(&self, elapsed: f64) -> Place {
        let fall_rate = elapsed - self.rise;
        let below_top = match self.times_to_top() {
            Some((early, late)) => 0.5 * (early - elapsed) * (late - elapsed),
            None if self.rise > 0.0 => 0.5 * (fall_rate * fall_rate - self.square_at_top()),
            None => self.below_top + elapsed * (0.5 * elapsed - self.rise),
        };
        let to_bottom = self.time_to_bottom();
        let above_bottom = 0.5 * (to_bottom - elapsed) * (elapsed + 2.0 * self.above_bottom / to_bottom);
        Place { elapsed, below_top: below_top.max(0.0), above_bottom: above_bottom.max(0.0), fall_rate }
    }

    /// The state there.
    pub(super) fn state(&self, place: &Place) -> State {
        let arm = place.arm();
        let half_angle = libm::atan2(place.below_top.sqrt(), place.above_bottom.sqrt());
        let rate = self.side * place.fall_rate / arm;
        let lever = self.inside + place.above_bottom;
        State {
            time: self.start.time + place.elapsed,
            theta: TAU * self.turns + self.side * 2.0 * half_angle,
            theta_rate: rate,
            // On the rim the lever of the unbounded rate vanishes at the bottom.
            slip: if lever == 0.0 { self.momentum } else { self.momentum + rate * lever },
            x: self.mass_centre + self.momentum * place.elapsed + self.side * arm,
        }
    }
}
