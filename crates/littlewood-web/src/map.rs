//! What becomes of every start of the plane, computed coarse to fine.

use core::f64::consts::PI;

use littlewood::tables::Class;
use littlewood::theory::Window;
use littlewood::{Engine, Hoop, Limits, Mode, Proof, Start, Summary};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::hops;
use crate::problem::Problem;

/// Largest number of transitions that a map follows: it has to be there while a person looks. With
/// bounces, with little friction and with light hoops there can be more.
const TRANSITIONS: usize = 200;

/// Where more than one motion of 64 has so many transitions and does not lift off, motions are
/// followed only until their energy proves that they never will.
const LONG: usize = 100;

/// What a map shows of each motion.
#[wasm_bindgen]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum MapSubject {
    /// Its class ([`Class`]).
    Outcome,
    /// The number of its landings.
    Hops,
}

impl MapSubject {
    const fn not_computed(self) -> u8 {
        match self {
            Self::Outcome => Class::NotComputed.code(),
            Self::Hops => hops::NOT_COMPUTED,
        }
    }
}

/// A square map of one turn, −π < θ < π, and of −r < θ′ < r, row by row from the top.
///
/// A level computes every `stride`-th start of every `stride`-th row, and none twice. One half is
/// enough where the other is its mirror image
/// ([`littlewood::tables::Setup::plane_is_its_mirror_image`]).
#[wasm_bindgen]
#[derive(Debug)]
pub struct OutcomeMap {
    subject: MapSubject,
    engine: Engine,
    /// Without restitution, where the hoop has one.
    until_landing: Option<Engine>,
    slip: f64,
    gap_rate: f64,
    rate: f64,
    limits: Limits,
    side: usize,
    cells: Vec<u8>,
    symmetric: bool,
}

#[wasm_bindgen]
impl OutcomeMap {
    /// An empty map of the hoop, the slip and the rate of the gap of a problem, with `side` starts
    /// each way and rates below `rate`.
    #[wasm_bindgen(constructor)]
    pub fn new(problem: &Problem, rate: f64, side: usize, subject: MapSubject) -> Self {
        let Start { slip, gap_rate, .. } = problem.start;
        let mut map = Self {
            subject,
            engine: map_engine(&problem.hoop),
            until_landing: problem
                .hoop
                .restitution()
                .map(|_| map_engine(&without_restitution(&problem.hoop))),
            slip,
            gap_rate,
            rate,
            limits: Limits::default().with_transitions(TRANSITIONS),
            side,
            cells: vec![subject.not_computed(); side * side],
            symmetric: side.is_multiple_of(2) && problem.setup().plane_is_its_mirror_image(),
        };
        // A motion that stays in contact has no more landings.
        if subject == MapSubject::Hops || map.has_long_motions() {
            map.limits = map.limits.with_proof(Proof::Contact);
        }
        map
    }

    /// Number of rows of starts that a level computes.
    pub fn rows(&self, stride: usize) -> usize {
        let side = if self.symmetric {
            self.side / 2
        } else {
            self.side
        };
        side.div_ceil(stride.max(1))
    }

    /// Computes rows `from..to` of a level.
    pub fn compute(&mut self, stride: usize, from: usize, to: usize) {
        let stride = stride.max(1);
        for row in from..to.min(self.rows(stride)) {
            for column in 0..self.side.div_ceil(stride) {
                let (x, y) = (column * stride, row * stride);
                let cell = y * self.side + x;
                if self.cells[cell] != self.subject.not_computed() {
                    continue;
                }
                let class = self.code_at(x, y);
                self.cells[cell] = class;
                if self.symmetric {
                    let mirrored = self.side * self.side - 1 - cell;
                    self.cells[mirrored] = class;
                }
            }
        }
    }

    /// Four numbers for each start of the rows `from..to`: the code of its class, and the times of
    /// the first slip, of the lift-off and of the end, NaN for an event that does not happen. The end
    /// is the first landing, or the start of a phase that lasts for ever.
    pub fn events(&self, from: usize, to: usize) -> Vec<f64> {
        let rows = from..to.min(self.side);
        rows.flat_map(|y| (0..self.side).flat_map(move |x| self.events_at(x, y)))
            .collect()
    }

    /// The codes of the classes, or the numbers of landings, of all cells, each as the nearest
    /// start of this level has it.
    pub fn classes(&self, stride: usize) -> Vec<u8> {
        let stride = stride.max(1);
        let snap = |i: usize| i - i % stride;
        let mut classes = Vec::with_capacity(self.cells.len());
        for y in 0..self.side {
            let folded = self.symmetric && y >= self.side / 2;
            for x in 0..self.side {
                let (x, y) = if folded {
                    (self.side - 1 - x, self.side - 1 - y)
                } else {
                    (x, y)
                };
                classes.push(self.cells[snap(y) * self.side + snap(x)]);
            }
        }
        classes
    }
}

impl OutcomeMap {
    fn code_at(&self, x: usize, y: usize) -> u8 {
        let start = self.start(x, y);
        match self.subject {
            MapSubject::Outcome => self.class_of(start).code(),
            MapSubject::Hops => {
                let summary = self.engine.summary(start, self.limits);
                summary.map_or(hops::NOT_COMPUTED, |summary| hops::code(summary.landings))
            }
        }
    }

    fn start(&self, x: usize, y: usize) -> Start {
        // Odd numbers over the side: exactly opposite for opposite cells.
        let centre = |i: usize| ((2 * i + 1) as f64 - self.side as f64) / self.side as f64;
        let start = Start::at(PI * centre(x), -self.rate * centre(y));
        start.with_slip(self.slip).with_gap_rate(self.gap_rate)
    }

    fn has_long_motions(&self) -> bool {
        let engine = self.until_landing.as_ref().unwrap_or(&self.engine);
        let window = Window {
            x: [-PI, PI],
            y: [-self.rate, self.rate],
        };
        let base = Start::default()
            .with_slip(self.slip)
            .with_gap_rate(self.gap_rate);
        let long = engine.long_motions(window, base, self.limits, LONG);
        long.filter(|summary| summary.lift_off_time.is_nan())
            .count()
            > 1
    }

    fn class_of(&self, start: Start) -> Class {
        Class::of(&self.decided(start))
    }

    /// The class is decided where the body first leaves the plane, so that bounces need not be
    /// followed for it. Only a jam comes before that.
    fn decided(&self, start: Start) -> Summary {
        let summary = |engine: &Engine| {
            engine
                .summary(start, self.limits)
                .unwrap_or(Summary::INVALID)
        };
        match self.until_landing.as_ref().map(summary) {
            Some(decided) if Class::of(&decided) != Class::Painleve => decided,
            Some(_) | None => summary(&self.engine),
        }
    }

    fn events_at(&self, x: usize, y: usize) -> [f64; 4] {
        let summary = self.decided(self.start(x, y));
        // The summary has the first slip out of rolling; some slip from the start.
        let slips = matches!(summary.sequence.first(), Some((Mode::Sliding, _)));
        let slip = if slips { 0.0 } else { summary.first_slip_time };
        let code = f64::from(Class::of(&summary).code());
        [code, slip, summary.lift_off_time, summary.end.time]
    }
}

/// Maps need the speed of interpolated slips.
fn map_engine(hoop: &Hoop) -> Engine {
    Engine::builder(hoop).interpolate_slips().build()
}

fn without_restitution(hoop: &Hoop) -> Hoop {
    let mut parameters = hoop.parameters();
    (parameters.restitution, parameters.restitution_law) = (None, None);
    // Nothing is refused that was not before.
    Hoop::new(parameters).unwrap_or(*hoop)
}
