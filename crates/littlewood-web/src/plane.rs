//! The (θ, θ′) plane of rolling as curves.

use littlewood::theory::{PhasePlane, RollingLaw, Stability, Window};
use littlewood_style::Curve;
use wasm_bindgen::prelude::wasm_bindgen;

use crate::problem::Problem;

/// The plane of one hoop in a window. Points are θ, θ′ one after the other, with NaN, NaN between
/// pieces.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Plane {
    plane: PhasePlane,
    law: RollingLaw,
    window: Window,
}

fn named(name: &str) -> Option<Curve> {
    Curve::ALL.into_iter().find(|curve| curve.name() == name)
}

fn points(pieces: Vec<Vec<[f64; 2]>>) -> Vec<f64> {
    pieces.join(&[f64::NAN; 2]).into_flattened()
}

#[wasm_bindgen]
impl Plane {
    /// Of the hoop of a problem, from one angle to another and of rates up to `rate` either way.
    #[wasm_bindgen(constructor)]
    pub fn new(problem: &Problem, from: f64, to: f64, rate: f64) -> Self {
        Self {
            plane: PhasePlane::new(&problem.hoop),
            law: RollingLaw::new(&problem.hoop),
            window: Window {
                x: [from, to],
                y: [-rate, rate],
            },
        }
    }

    /// The curve of a name ([`Curve`]).
    pub fn curve(&self, name: &str) -> Vec<f64> {
        points(named(name).map_or_else(Vec::new, |curve| curve.pieces(&self.plane, &self.window)))
    }

    /// Where the letter of this curve stands, if it has one and passes.
    #[wasm_bindgen(js_name = placeOfLetter)]
    pub fn place_of_letter(&self, name: &str) -> Option<Vec<f64>> {
        Some(
            named(name)?
                .place_of_letter(&self.plane, &self.window)?
                .to_vec(),
        )
    }

    /// Region 𝓡 (2.14) as polygons.
    pub fn region(&self) -> Vec<f64> {
        points(self.plane.rolling_region(&self.window))
    }

    /// Whether a point lies in 𝓡.
    #[wasm_bindgen(js_name = canRoll)]
    pub fn can_roll(&self, theta: f64, theta_rate: f64) -> bool {
        self.plane.in_rolling_region(theta, theta_rate)
    }

    /// Energy of rolling through a point.
    pub fn energy(&self, theta: f64, theta_rate: f64) -> f64 {
        self.law.energy(theta, theta_rate)
    }

    /// Normal and friction force that rolling would need at a point (2.12), be it possible or not.
    pub fn forces(&self, theta: f64, theta_rate: f64) -> Vec<f64> {
        let forces = self.law.forces(theta, theta_rate);
        vec![forces.normal, forces.friction]
    }

    /// Angles of the equilibria in (−π, π], each followed by 1 if it is stable, −1 if unstable, 0
    /// if neutral.
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
