//! Ticks of axes, those of all pictures.

use littlewood_style::ticks::{Tick, angular, round};
use wasm_bindgen::prelude::wasm_bindgen;

/// Ticks of an axis.
#[wasm_bindgen]
#[derive(Clone, Debug)]
pub struct Ticks(Vec<Tick>);

#[wasm_bindgen]
impl Ticks {
    /// At round numbers from `a` to `b` > `a`, at most about `most` of them.
    pub fn round(a: f64, b: f64, most: usize) -> Self {
        Self(round(a, b, most.max(1)))
    }

    /// At multiples of a fraction of π, for angles.
    pub fn angular(a: f64, b: f64, most: usize) -> Self {
        Self(angular(a, b, most.max(1)))
    }

    /// Positions on the axis.
    pub fn values(&self) -> Vec<f64> {
        self.0.iter().map(|tick| tick.value).collect()
    }

    /// Labels.
    pub fn labels(&self) -> Vec<String> {
        self.0.iter().map(|tick| tick.label.clone()).collect()
    }
}
