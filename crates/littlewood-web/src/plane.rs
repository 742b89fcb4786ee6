//! The (θ, θ′) plane of rolling as curves.

use littlewood::Direction;
use littlewood::theory::{Body, PhasePlane, RollingLaw, Stability, closed_form};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::polyline::trace;
use crate::problem::Problem;

/// The plane of one hoop. Every curve is θ′ ≥ 0 over θ, and has its mirror image −θ′.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Plane {
    plane: PhasePlane,
    law: RollingLaw,
    body: Body,
    mu_s: f64,
}

#[wasm_bindgen]
impl Plane {
    /// Of the hoop of a problem.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new(problem: &Problem) -> Self {
        Self {
            plane: PhasePlane::new(&problem.hoop),
            law: RollingLaw::new(&problem.hoop),
            body: problem.hoop.body(),
            mu_s: problem.hoop.mu_s(),
        }
    }

    /// The curve n, N = 0 in rolling, as points θ, θ′ with NaN between arcs.
    #[must_use]
    pub fn normal(&self, from: f64, to: f64, count: usize) -> Vec<f64> {
        trace(from, to, count, |theta| self.plane.normal_force_rate(theta))
    }

    /// The curve f, |F| = μs N, where the slip that follows is positive or negative.
    #[must_use]
    pub fn friction(&self, positive: bool, from: f64, to: f64, count: usize) -> Vec<f64> {
        let direction = if positive { Direction::Positive } else { Direction::Negative };
        trace(from, to, count, |theta| self.plane.slip_rate(theta, direction))
    }

    /// The curve on which the body leaves the plane, 1 = h cos θ θ′².
    #[wasm_bindgen(js_name = liftOff)]
    #[must_use]
    pub fn lift_off(&self, from: f64, to: f64, count: usize) -> Vec<f64> {
        trace(from, to, count, |theta| self.plane.lift_off_rate(theta))
    }

    /// The orbit of energy E.
    #[must_use]
    pub fn level(&self, energy: f64, from: f64, to: f64, count: usize) -> Vec<f64> {
        trace(from, to, count, |theta| self.plane.level_rate(theta, energy))
    }

    /// The separatrix through the unstable equilibrium.
    #[must_use]
    pub fn separatrix(&self, from: f64, to: f64, count: usize) -> Vec<f64> {
        trace(from, to, count, |theta| Some(self.plane.separatrix_rate(theta)))
    }

    /// Energy of rolling through a point, to draw its level.
    #[must_use]
    pub fn energy(&self, theta: f64, theta_rate: f64) -> f64 {
        self.law.energy(theta, theta_rate)
    }

    /// θ_s of a massless hoop, where f is a vertical line (3.9); none for a hoop with inertia, or where friction always
    /// suffices.
    #[wasm_bindgen(js_name = slipAngle)]
    #[must_use]
    pub fn slip_angle(&self) -> Option<f64> {
        match &self.body {
            Body::Massless(body) => closed_form::slip_angle(body, self.mu_s),
            Body::Heavy(_) => None,
        }
    }

    /// Region 𝓡 (2.14): for each of `count` angles the least and the largest θ′ ≥ 0 in it, up to `rate`; NaN where no
    /// rate is. Over one angle N and F are linear in θ′², so that what lies in 𝓡 is one interval of θ′².
    #[must_use]
    pub fn region(&self, from: f64, to: f64, count: usize, rate: f64) -> Vec<f64> {
        let intervals = count.max(2) - 1;
        let mut bounds = Vec::with_capacity(2 * (intervals + 1));
        for i in 0..=intervals {
            let theta = from + (to - from) * (i as f64 / intervals as f64);
            let mut edges = vec![0.0, rate];
            edges.extend(
                [
                    self.plane.normal_force_rate(theta),
                    self.plane.slip_rate(theta, Direction::Negative),
                    self.plane.slip_rate(theta, Direction::Positive),
                ]
                .into_iter()
                .flatten()
                .filter(|edge| *edge < rate),
            );
            edges.sort_by(f64::total_cmp);
            let inside = |pair: &&[f64]| self.plane.in_rolling_region(theta, 0.5 * (pair[0] + pair[1]));
            let within: Vec<&[f64]> = edges.windows(2).filter(inside).collect();
            match (within.first(), within.last()) {
                (Some(first), Some(last)) => bounds.extend([first[0], last[1]]),
                _ => bounds.extend([f64::NAN, f64::NAN]),
            }
        }
        bounds
    }

    /// Angles of the equilibria in (−π, π], each followed by 1 if it is stable, −1 if unstable, 0 if neutral.
    #[must_use]
    pub fn equilibria(&self) -> Vec<f64> {
        self.plane
            .equilibria()
            .into_iter()
            .flat_map(|equilibrium| {
                let stability = match equilibrium.stability {
                    Stability::Stable { .. } => 1.0,
                    Stability::Unstable { .. } => -1.0,
                    Stability::Neutral => 0.0,
                };
                [equilibrium.theta, stability]
            })
            .collect()
    }
}
