//! What becomes of every start of the plane, computed coarse to fine.

use core::f64::consts::PI;

use littlewood::{Class, Engine, Limits, Start};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::problem::Problem;

/// Largest number of transitions that a map follows. Only with μs = μk can there be more.
const TRANSITIONS: usize = 200;

/// A square map of one turn, −π < θ < π, and of −r < θ′ < r, row by row from the top.
///
/// A level computes every `stride`-th start of every `stride`-th row, and none twice. Without slip the map is its own
/// image under (θ, θ′) → (−θ, −θ′), bit for bit, and one half is enough.
#[wasm_bindgen]
#[derive(Debug)]
pub struct OutcomeMap {
    engine: Engine,
    slip: f64,
    rate: f64,
    side: usize,
    cells: Vec<u8>,
    symmetric: bool,
}

#[wasm_bindgen]
impl OutcomeMap {
    /// An empty map of the hoop and the slip of a problem, with `side` starts each way and rates below `rate`.
    #[wasm_bindgen(constructor)]
    #[must_use]
    pub fn new(problem: &Problem, rate: f64, side: usize) -> Self {
        let slip = problem.start.slip;
        Self {
            engine: Engine::new(&problem.hoop),
            slip,
            rate,
            side,
            cells: vec![Class::NotComputed.code(); side * side],
            symmetric: slip == 0.0 && side.is_multiple_of(2),
        }
    }

    /// Number of rows of starts that a level computes.
    #[must_use]
    pub fn rows(&self, stride: usize) -> usize {
        let side = if self.symmetric { self.side / 2 } else { self.side };
        side.div_ceil(stride.max(1))
    }

    /// Computes rows `from..to` of a level.
    pub fn compute(&mut self, stride: usize, from: usize, to: usize) {
        let stride = stride.max(1);
        for row in from..to.min(self.rows(stride)) {
            for column in 0..self.side.div_ceil(stride) {
                let (x, y) = (column * stride, row * stride);
                let cell = y * self.side + x;
                if self.cells[cell] != Class::NotComputed.code() {
                    continue;
                }
                let class = self.class_at(x, y).code();
                self.cells[cell] = class;
                if self.symmetric {
                    let mirrored = self.side * self.side - 1 - cell;
                    self.cells[mirrored] = class;
                }
            }
        }
    }

    /// The codes of the classes of all cells, each as the nearest start of this level has it.
    #[must_use]
    pub fn classes(&self, stride: usize) -> Vec<u8> {
        let stride = stride.max(1);
        let snap = |i: usize| i - i % stride;
        let mut classes = Vec::with_capacity(self.cells.len());
        for y in 0..self.side {
            let folded = self.symmetric && y >= self.side / 2;
            for x in 0..self.side {
                let (x, y) = if folded { (self.side - 1 - x, self.side - 1 - y) } else { (x, y) };
                classes.push(self.cells[snap(y) * self.side + snap(x)]);
            }
        }
        classes
    }
}

impl OutcomeMap {
    fn class_at(&self, x: usize, y: usize) -> Class {
        // Odd numbers over the side: exactly opposite for opposite cells.
        let centre = |i: usize| ((2 * i + 1) as f64 - self.side as f64) / self.side as f64;
        let start = Start::at(PI * centre(x), -self.rate * centre(y)).with_slip(self.slip);
        let limits = Limits::default().with_transitions(TRANSITIONS);
        self.engine.summary(start, limits).map_or(Class::Invalid, |summary| Class::of(&summary))
    }
}

#[cfg(test)]
mod tests {
    use littlewood::Hoop;

    use super::*;

    fn figure_2(slip: f64) -> Problem {
        let hoop = Hoop::figure_2(0.5, 0.4).unwrap();
        Problem { hoop, start: Start::default().with_slip(slip), limits: Limits::default(), units: None }
    }

    #[test]
    fn levels_end_with_every_start_and_the_folded_half_is_right() {
        let mut folded = OutcomeMap::new(&figure_2(0.0), 4.0, 64);
        assert!(folded.symmetric);
        for stride in [8, 4, 2, 1] {
            folded.compute(stride, 0, folded.rows(stride));
        }
        let mut whole = OutcomeMap::new(&figure_2(0.0), 4.0, 64);
        whole.symmetric = false;
        whole.compute(1, 0, 64);
        assert_eq!(folded.classes(1), whole.classes(1));
        assert!(!whole.classes(1).contains(&Class::NotComputed.code()));
    }

    #[test]
    fn a_coarse_level_fills_the_map() {
        for slip in [0.0, 0.5] {
            let mut map = OutcomeMap::new(&figure_2(slip), 4.0, 32);
            map.compute(8, 0, map.rows(8));
            assert!(!map.classes(8).contains(&Class::NotComputed.code()));
        }
    }

    #[test]
    fn footnote_3_leaves_at_once_and_the_bottom_rolls_for_ever() {
        let mut map = OutcomeMap::new(&figure_2(0.0), 4.2, 101);
        map.compute(1, 0, 101);
        let classes = map.classes(1);
        assert_eq!(classes[2 * 101 + 50], Class::LeavesAtOnce.code());
        assert_eq!(classes[50 * 101], Class::RollsForever.code());
    }
}
