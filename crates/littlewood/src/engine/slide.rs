//! Sliding of one body in one direction, for every motion at once.
//!
//! u = θ′² obeys the linear equation du/dϑ = a(ϑ) (1 − h cos ϑ u), a = 2 m q/P, whatever the motion. On a cell of
//! angles every slide is u = p(z) + u_c h(z), with two polynomials in z that belong to the body and one number u_c that
//! belongs to the motion. The cells end where the signs that matter can change whatever the motion: at multiples of π,
//! at the zeros of q, at the poles and at the extrema of the level on which η″ = 0. Within a cell, therefore,
//!
//! - u is monotone;
//! - 1 − h cos ϑ u falls through zero at most once, and then stays (its derivative there is h sin ϑ u);
//! - η″ changes sign at most once, so that η′ has at most one extremum.
//!
//! The ends of a cell then tell what happens inside; the one doubtful shape, η′ with a minimum inside, is handed back.
//! The time is a Gauss sum of dϑ/√u, and η′ follows from it by the first integral of sliding.
//!
//! Everything is seen in the frame in which σ = +1 (mirrored for σ = −1).

use core::f64::consts::{PI, TAU};

use crate::hoop::Heavy;
use crate::state::Direction;
use crate::trig::{sincos, sincos_small};

use super::quadrature::{NODE, NODES, WEIGHT};

/// Degree of the polynomials of a cell.
const DEGREE: usize = 18;

/// Widest cell; a cell whose series has not converged is halved.
const WIDEST: f64 = PI / 16.0;

/// With more cells than this the preparation is given up: a body of very small inertia.
const MOST_CELLS: usize = 600;

/// A series has converged when its last coefficients are below this part of the largest.
const CONVERGED: f64 = 1e-17;

/// Ratio of the ends of u up to which the Gauss sum of 1/√u is exact to rounding.
const SMOOTH: f64 = 1.5;

type Polynomial = [f64; DEGREE + 1];

/// What belongs to the body at the end of a cell.
#[derive(Clone, Copy, Debug)]
struct Edge {
    p: f64,
    h: f64,
    cos: f64,
    /// 1 + h cos ϑ + μk h sin ϑ.
    lever: f64,
    /// η″ = α + β u.
    alpha: f64,
    beta: f64,
}

#[derive(Clone, Debug)]
struct Cell {
    left: f64,
    centre: f64,
    half: f64,
    /// sin ϑ and cos ϑ at the centre.
    direction: (f64, f64),
    p: Polynomial,
    h: Polynomial,
    p_nodes: [f64; NODES],
    h_nodes: [f64; NODES],
    /// At z = −1 and z = 1.
    edges: [Edge; 2],
}

/// The slides of one body with one coefficient of friction.
#[derive(Clone, Debug)]
pub(super) struct SlideTable {
    law: Law,
    cells: Vec<Cell>,
    /// Index of the cell that holds the left end of each slot of a turn.
    slots: Vec<u16>,
}

/// A slide that begins, in the frame with σ = +1.
#[derive(Clone, Copy, Debug)]
pub(super) struct SlideStart {
    pub(super) theta: f64,
    pub(super) theta_rate: f64,
    pub(super) slip: f64,
    /// sin ϑ and cos ϑ.
    pub(super) direction: (f64, f64),
}

/// The event that ends a slide.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlideEvent {
    pub(super) elapsed: f64,
    pub(super) theta: f64,
    pub(super) theta_rate: f64,
    pub(super) slip: f64,
    /// sin ϑ and cos ϑ.
    pub(super) direction: (f64, f64),
    pub(super) lifts_off: bool,
}

/// Formulas of sliding with σ = +1.
#[derive(Clone, Copy, Debug)]
struct Law {
    body: Heavy,
    mu: f64,
}

impl Law {
    fn q(&self, sin: f64, cos: f64) -> f64 {
        self.body.h * sin - self.mu * (1.0 + self.body.h * cos)
    }

    fn p(&self, sin: f64, cos: f64) -> f64 {
        self.body.inertia + self.body.mass * self.body.h * sin * self.q(sin, cos)
    }

    /// a of du/dϑ = a w.
    fn drive(&self, sin: f64, cos: f64) -> f64 {
        2.0 * self.body.mass * self.q(sin, cos) / self.p(sin, cos)
    }

    /// α and β of η″ = α + β u.
    fn slip_acceleration(&self, sin: f64, cos: f64) -> (f64, f64) {
        let Heavy { mass, h, inertia, .. } = self.body;
        let alpha = ((1.0 + h * cos) * mass * self.q(sin, cos) - self.mu * inertia) / self.p(sin, cos);
        (alpha, -h * cos * alpha - h * sin)
    }

    /// Its zeros are the extrema over ϑ of the level on which η″ = 0: α′β − β′α − a β h sin ϑ.
    fn level_slope(&self, theta: f64) -> f64 {
        let Heavy { mass, h, inertia, .. } = self.body;
        let (sin, cos) = sincos(theta);
        let (q, p) = (self.q(sin, cos), self.p(sin, cos));
        let q_slope = h * cos + self.mu * h * sin;
        let p_slope = mass * h * (cos * q + sin * q_slope);
        let top = (1.0 + h * cos) * mass * q - self.mu * inertia;
        let top_slope = mass * ((1.0 + h * cos) * q_slope - h * sin * q);
        let (alpha, beta) = self.slip_acceleration(sin, cos);
        let alpha_slope = (top_slope * p - top * p_slope) / (p * p);
        let beta_slope = -h * (cos * alpha_slope - sin * alpha) - h * cos;
        alpha_slope * beta - beta_slope * alpha - self.drive(sin, cos) * beta * h * sin
    }

    fn edge(&self, theta: f64, p: f64, h: f64) -> Edge {
        let (sin, cos) = sincos(theta);
        let (alpha, beta) = self.slip_acceleration(sin, cos);
        Edge { p, h, cos, lever: 1.0 + self.body.h * (cos + self.mu * sin), alpha, beta }
    }

    /// The cell about `left..right`, if its series converge.
    fn cell(&self, left: f64, right: f64) -> Option<Cell> {
        let Heavy { mass, h, inertia, .. } = self.body;
        let (centre, half) = (0.5 * (left + right), 0.5 * (right - left));
        let mut sin = [0.0; DEGREE + 1];
        let mut cos = [0.0; DEGREE + 1];
        (sin[0], cos[0]) = libm::sincos(centre);
        for k in 1..=DEGREE {
            let factor = half / k as f64;
            sin[k] = factor * cos[k - 1];
            cos[k] = -factor * sin[k - 1];
        }
        let mut q: Polynomial = core::array::from_fn(|k| h * (sin[k] - self.mu * cos[k]));
        q[0] -= self.mu;
        let mut solvability = product(&sin, &q).map(|c| mass * h * c);
        solvability[0] += inertia;
        let drive = quotient(&q.map(|c| 2.0 * mass * c), &solvability);
        let weight = product(&cos, &drive).map(|c| -h * c);
        let (mut u_p, mut u_h) = ([0.0; DEGREE + 1], [0.0; DEGREE + 1]);
        u_h[0] = 1.0;
        for k in 0..DEGREE {
            let factor = half / (k + 1) as f64;
            let (mut sum_p, mut sum_h) = (drive[k], 0.0);
            for j in 0..=k {
                sum_p += weight[j] * u_p[k - j];
                sum_h += weight[j] * u_h[k - j];
            }
            u_p[k + 1] = factor * sum_p;
            u_h[k + 1] = factor * sum_h;
        }
        let converged = |series: &Polynomial| {
            let largest = series.iter().fold(0.0_f64, |max, c| max.max(c.abs()));
            series[DEGREE - 2..].iter().all(|c| c.abs() <= CONVERGED * largest.max(1e-3))
        };
        if !(converged(&u_p) && converged(&u_h)) {
            return None;
        }
        let edge = |theta, z| self.edge(theta, value(&u_p, z), value(&u_h, z));
        Some(Cell {
            left,
            centre,
            half,
            direction: (sin[0], cos[0]),
            p_nodes: NODE.map(|z| value(&u_p, z)),
            h_nodes: NODE.map(|z| value(&u_h, z)),
            edges: [edge(left, -1.0), edge(right, 1.0)],
            p: u_p,
            h: u_h,
        })
    }
}

fn product(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let mut result = [0.0; DEGREE + 1];
    for k in 0..=DEGREE {
        for j in 0..=k {
            result[k] += a[j] * b[k - j];
        }
    }
    result
}

fn quotient(a: &Polynomial, b: &Polynomial) -> Polynomial {
    let mut result = [0.0; DEGREE + 1];
    for k in 0..=DEGREE {
        let mut rest = a[k];
        for j in 1..=k {
            rest -= b[j] * result[k - j];
        }
        result[k] = rest / b[0];
    }
    result
}

/// Value of a polynomial, even and odd powers apart: two short chains instead of a long one.
#[inline]
fn value(series: &Polynomial, z: f64) -> f64 {
    let square = z * z;
    let (mut even, mut odd) = (series[DEGREE], 0.0);
    let mut k = DEGREE;
    while k > 0 {
        odd = odd * square + series[k - 1];
        even = even * square + series[k - 2];
        k -= 2;
    }
    even + z * odd
}

/// Whether P > 0 at every angle.
pub(super) fn solvable(body: &Heavy, mu: f64) -> bool {
    let law = Law { body: *body, mu };
    let p = |theta: f64| {
        let (sin, cos) = sincos(theta);
        law.p(sin, cos)
    };
    p(0.0) > 0.0 && sign_changes(p).is_empty()
}

/// Sign changes of a smooth function on a turn, to rounding.
pub(super) fn sign_changes(function: impl Fn(f64) -> f64) -> Vec<f64> {
    const SAMPLES: u32 = 2880;
    let mut roots = Vec::new();
    let mut low = 0.0;
    let mut at_low = function(low);
    for i in 1..=SAMPLES {
        let high = TAU * f64::from(i) / f64::from(SAMPLES);
        let at_high = function(high);
        if at_low * at_high < 0.0 {
            let (mut a, mut b) = (low, high);
            while b - a > 4.0 * f64::EPSILON * b {
                let middle = 0.5 * (a + b);
                if function(middle) * at_low > 0.0 { a = middle } else { b = middle }
            }
            roots.push(0.5 * (a + b));
        }
        (low, at_low) = (high, at_high);
    }
    roots
}

impl Cell {
    /// sin ϑ and cos ϑ at z, by the addition theorems.
    fn direction(&self, z: f64) -> (f64, f64) {
        let ((sin, cos), (turn_sin, turn_cos)) = (self.direction, sincos_small(self.half * z));
        (sin * turn_cos + cos * turn_sin, cos * turn_cos - sin * turn_sin)
    }

    /// u_c of the motion that has u at z.
    fn level(&self, u: f64, z: f64) -> f64 {
        (u - value(&self.p, z)) / value(&self.h, z)
    }

    /// u of one motion as a polynomial in z.
    fn motion(&self, level: f64) -> Polynomial {
        core::array::from_fn(|k| self.p[k] + level * self.h[k])
    }

    /// ∫ dϑ/√u over the whole cell.
    fn whole_time(&self, level: f64) -> f64 {
        let mut sum = 0.0;
        for ((weight, p), h) in WEIGHT.iter().zip(&self.p_nodes).zip(&self.h_nodes) {
            sum += weight / (p + level * h).sqrt();
        }
        self.half * sum
    }

    /// ∫ dϑ/√u from z = from to z = to, not smaller.
    fn time(&self, motion: &Polynomial, from: f64, to: f64) -> f64 {
        let (middle, half) = (0.5 * (from + to), 0.5 * (to - from));
        let z = NODE.map(|node| middle + half * node);
        let mut u = [motion[DEGREE]; NODES];
        for c in motion[..DEGREE].iter().rev() {
            for j in 0..NODES {
                u[j] = u[j] * z[j] + c;
            }
        }
        let mut sum = 0.0;
        for (weight, u) in WEIGHT.iter().zip(u) {
            sum += weight / u.sqrt();
        }
        self.half * half * sum
    }
}

/// What a slide meets at the end of a cell.
#[derive(Clone, Copy, Debug)]
pub(super) struct Passing {
    /// The end of the cell, reduced to a turn.
    pub(super) angle: f64,
    /// Angle since the start.
    pub(super) turned: f64,
    /// η″.
    pub(super) slip_acceleration: f64,
    /// 1 − h cos ϑ u.
    pub(super) contact: f64,
}

/// A point on the way through a cell.
#[derive(Clone, Copy, Debug)]
struct Waypoint {
    z: f64,
    u: f64,
    elapsed: f64,
    slip: f64,
    slip_acceleration: f64,
    /// sin ϑ and cos ϑ, where the way may end.
    direction: (f64, f64),
}

impl SlideTable {
    /// Prepares the slides of a body; none where P is not positive everywhere or the cells would be too many.
    pub(super) fn new(body: &Heavy, mu: f64) -> Option<Self> {
        let law = Law { body: *body, mu };
        let mut bounds = vec![0.0, PI, TAU];
        let trigonometric = |f: &dyn Fn(f64, f64) -> f64| {
            sign_changes(|theta| {
                let (sin, cos) = sincos(theta);
                f(sin, cos)
            })
        };
        if !solvable(body, mu) {
            return None;
        }
        bounds.extend(trigonometric(&|sin, cos| law.q(sin, cos)));
        bounds.extend(trigonometric(&|sin, cos| law.slip_acceleration(sin, cos).1));
        bounds.extend(sign_changes(|theta| law.level_slope(theta)));
        bounds.sort_by(f64::total_cmp);
        bounds.dedup_by(|a, b| *a - *b < 1e-12);
        let mut cells: Vec<Cell> = Vec::new();
        for pair in bounds.windows(2) {
            let parts = ((pair[1] - pair[0]) / WIDEST).ceil().max(1.0);
            let mut part = 0.0;
            let mut left = pair[0];
            while part < parts {
                part += 1.0;
                let right =
                    if part == parts { pair[1] } else { pair[0] + (pair[1] - pair[0]) * part / parts };
                Self::fill(&law, left, right, &mut cells)?;
                left = right;
            }
        }
        let count = 4 * cells.len();
        let mut slots = Vec::with_capacity(count);
        for slot in 0..count {
            let angle = TAU * slot as f64 / count as f64;
            let index = cells.partition_point(|cell| cell.left <= angle).saturating_sub(1);
            slots.push(u16::try_from(index).ok()?);
        }
        Some(Self { law, cells, slots })
    }

    fn fill(law: &Law, left: f64, right: f64, cells: &mut Vec<Cell>) -> Option<()> {
        if let Some(cell) = law.cell(left, right) {
            cells.push(cell);
            return Some(());
        }
        if cells.len() >= MOST_CELLS || right - left < 1e-6 {
            return None;
        }
        let middle = 0.5 * (left + right);
        Self::fill(law, left, middle, cells)?;
        Self::fill(law, middle, right, cells)
    }

    /// Number of cells of a turn.
    pub(super) fn cells(&self) -> usize {
        self.cells.len()
    }

    /// Index of the cell in which a motion from this angle, reduced to a turn, goes on in `travel`.
    fn find(&self, angle: f64, travel: f64) -> usize {
        let slot = (angle / TAU * self.slots.len() as f64) as usize;
        let mut index = usize::from(self.slots[slot.min(self.slots.len() - 1)]);
        while index + 1 < self.cells.len() && self.cells[index + 1].left <= angle {
            index += 1;
        }
        if travel < 0.0 && self.cells[index].left == angle {
            index = if index == 0 { self.cells.len() - 1 } else { index - 1 };
        }
        index
    }

    /// The angles at which cells end, in the frame of a direction of slip, over a turn.
    pub(super) fn bounds(&self, direction: Direction) -> Vec<f64> {
        let lefts = self.cells.iter().map(|cell| cell.left);
        match direction {
            Direction::Positive => lefts.collect(),
            Direction::Negative => lefts.rev().map(|left| TAU - left).collect(),
        }
    }

    /// u_c in the first cell of a slide: it orders the slides from one cell.
    pub(super) fn level(&self, start: &SlideStart) -> f64 {
        let (index, offset) = self.entrance(start);
        let cell = &self.cells[index];
        cell.level(start.theta_rate * start.theta_rate, (start.theta - offset - cell.centre) / cell.half)
    }

    /// What a slide, continued beyond its end, would meet at the ends of cells until it has turned by `reach`.
    pub(super) fn passings(&self, start: &SlideStart, reach: f64) -> Vec<Passing> {
        let forward = start.theta_rate > 0.0;
        let (mut index, mut offset) = self.entrance(start);
        let mut level = self.level(start);
        let mut passings = Vec::new();
        loop {
            let cell = &self.cells[index];
            let exit = &cell.edges[usize::from(forward)];
            let u = exit.p + level * exit.h;
            let end = cell.centre + if forward { cell.half } else { -cell.half };
            let turned = (end + offset - start.theta).abs();
            passings.push(Passing {
                angle: end,
                turned,
                slip_acceleration: exit.alpha + exit.beta * u,
                contact: 1.0 - self.law.body.h * exit.cos * u,
            });
            if turned >= reach || passings.len() > self.cells.len() {
                return passings;
            }
            (index, offset) = self.neighbour(index, offset, forward);
            let entry = &self.cells[index].edges[usize::from(!forward)];
            level = (u - entry.p) / entry.h;
        }
    }

    /// The cell in which a slide begins, and the multiple of a turn that its angles stand for.
    fn entrance(&self, start: &SlideStart) -> (usize, f64) {
        let turns = (start.theta / TAU).floor();
        let angle = start.theta - TAU * turns;
        let backward = start.theta_rate < 0.0;
        let index = self.find(angle, start.theta_rate);
        (index, if backward && angle == 0.0 { TAU * (turns - 1.0) } else { TAU * turns })
    }

    /// The next cell.
    fn neighbour(&self, index: usize, offset: f64, forward: bool) -> (usize, f64) {
        match (forward, index) {
            (true, index) if index + 1 == self.cells.len() => (0, offset + TAU),
            (true, index) => (index + 1, offset),
            (false, 0) => (self.cells.len() - 1, offset - TAU),
            (false, index) => (index - 1, offset),
        }
    }

    /// Follows a slide to its event. None where the shape of η′ is in doubt, θ′ comes close to zero, or the slide takes
    /// longer than a few turns: the caller then follows it by Taylor series.
    pub(super) fn follow(&self, start: SlideStart) -> Option<SlideEvent> {
        let travel = if start.theta_rate > 0.0 {
            1.0
        } else if start.theta_rate < 0.0 {
            -1.0
        } else {
            return None;
        };
        let (mut index, mut offset) = self.entrance(&start);
        let first = &self.cells[index];
        let z = ((start.theta - offset - first.centre) / first.half).clamp(-1.0, 1.0);
        let (sin, cos) = start.direction;
        let (alpha, beta) = self.law.slip_acceleration(sin, cos);
        let u = start.theta_rate * start.theta_rate;
        let lever = 1.0 + self.law.body.h * (cos + self.law.mu * sin);
        let integral = start.slip - start.theta_rate * lever;
        let slip_acceleration = alpha + beta * u;
        let mut here =
            Waypoint { z, u, elapsed: 0.0, slip: start.slip, slip_acceleration, direction: (sin, cos) };
        let mut whole = false;
        for _ in 0..4 * self.cells.len() {
            let cell = &self.cells[index];
            let level = if whole {
                let entry = &cell.edges[usize::from(travel < 0.0)];
                (here.u - entry.p) / entry.h
            } else {
                cell.level(here.u, here.z)
            };
            let exit = &cell.edges[usize::from(travel > 0.0)];
            let exit_u = exit.p + level * exit.h;
            let lifts_off = 1.0 - self.law.body.h * exit.cos * exit_u < 0.0;
            let there = if lifts_off {
                self.lift_off(cell, &cell.motion(level), &here, (travel, integral))?
            } else {
                let ratio = exit_u / here.u;
                if !(ratio > 1.0 / SMOOTH && ratio < SMOOTH) {
                    return None;
                }
                let time = if whole {
                    cell.whole_time(level)
                } else {
                    cell.time(&cell.motion(level), here.z.min(travel), here.z.max(travel))
                };
                let elapsed = here.elapsed + time;
                let rate = travel * exit_u.sqrt();
                Waypoint {
                    z: travel,
                    u: exit_u,
                    elapsed,
                    slip: integral + rate * exit.lever - self.law.mu * elapsed,
                    slip_acceleration: exit.alpha + exit.beta * exit_u,
                    direction: (0.0, exit.cos),
                }
            };
            if there.slip <= 0.0 {
                let rest = self.rest(cell, &cell.motion(level), &here, &there, (travel, integral))?;
                return Some(Self::event(cell, offset, &rest, travel, false));
            }
            if here.slip_acceleration <= 0.0 && there.slip_acceleration >= 0.0 && here.slip > 0.0 {
                // η′ may have a minimum inside; it may also touch zero there.
                return None;
            }
            if lifts_off {
                return Some(Self::event(cell, offset, &there, travel, true));
            }
            here = Waypoint { z: -travel, ..there };
            whole = true;
            (index, offset) = self.neighbour(index, offset, travel > 0.0);
        }
        None
    }

    fn event(cell: &Cell, offset: f64, at: &Waypoint, travel: f64, lifts_off: bool) -> SlideEvent {
        SlideEvent {
            elapsed: at.elapsed,
            theta: offset + (cell.centre + cell.half * at.z),
            theta_rate: travel * at.u.sqrt(),
            slip: if lifts_off { at.slip } else { 0.0 },
            direction: at.direction,
            lifts_off,
        }
    }

    /// Everything at z, from the way since `here`.
    fn at(
        &self,
        cell: &Cell,
        motion: &Polynomial,
        here: &Waypoint,
        z: f64,
        (travel, integral): (f64, f64),
    ) -> Option<Waypoint> {
        let u = value(motion, z);
        let ratio = u / here.u;
        if !(ratio > 1.0 / SMOOTH && ratio < SMOOTH) {
            return None;
        }
        let elapsed = here.elapsed + cell.time(motion, here.z.min(z), here.z.max(z));
        let (sin, cos) = cell.direction(z);
        let (alpha, beta) = self.law.slip_acceleration(sin, cos);
        let lever = 1.0 + self.law.body.h * (cos + self.law.mu * sin);
        Some(Waypoint {
            z,
            u,
            elapsed,
            slip: integral + travel * u.sqrt() * lever - self.law.mu * elapsed,
            slip_acceleration: alpha + beta * u,
            direction: (sin, cos),
        })
    }

    /// Where 1 − h cos ϑ u falls through zero on the way to the end of the cell: Newton's method in a bracket.
    fn lift_off(
        &self,
        cell: &Cell,
        motion: &Polynomial,
        here: &Waypoint,
        (travel, integral): (f64, f64),
    ) -> Option<Waypoint> {
        let h = self.law.body.h;
        let (mut low, mut high) = (here.z, travel);
        let mut z = 0.5 * (low + high);
        for _ in 0..60 {
            let (sin, cos) = cell.direction(z);
            let u = value(motion, z);
            let w = 1.0 - h * cos * u;
            if w > 0.0 {
                low = z;
            } else {
                high = z;
            }
            let slope = cell.half * (h * sin * u - h * cos * self.law.drive(sin, cos) * w);
            let newton = z - w / slope;
            let inside = (newton - low) * travel > 0.0 && (high - newton) * travel > 0.0;
            let next = if inside { newton } else { 0.5 * (low + high) };
            let step = (next - z).abs();
            z = next;
            if step < 1e-9 && inside {
                return self.at(cell, motion, here, z, (travel, integral));
            }
            if (high - low).abs() < 1e-15 {
                return self.at(cell, motion, here, z, (travel, integral));
            }
        }
        None
    }

    /// Where η′ falls through zero between two waypoints: a cubic for a guess, then Newton's method with the exact time.
    fn rest(
        &self,
        cell: &Cell,
        motion: &Polynomial,
        here: &Waypoint,
        there: &Waypoint,
        (travel, integral): (f64, f64),
    ) -> Option<Waypoint> {
        let span = there.z - here.z;
        // dη′/ds with s from 0 at `here` to 1 at `there`.
        let slope = |at: &Waypoint| at.slip_acceleration / at.u.sqrt() * cell.half * span.abs();
        let guess = cubic_root(here.slip, slope(here), there.slip, slope(there));
        let mut z = here.z + guess * span;
        for _ in 0..6 {
            let at = self.at(cell, motion, here, z, (travel, integral))?;
            let rate = at.slip_acceleration / at.u.sqrt() * cell.half * travel;
            let step = -at.slip / rate;
            let next = z + step;
            if !((next - here.z) * travel > 0.0 && (there.z - next) * travel >= 0.0) || rate * travel >= 0.0 {
                return None;
            }
            if step.abs() < 1e-7 {
                let u = value(motion, next);
                // Over a step this short the direction turns by its derivative.
                let (sin, cos) = at.direction;
                let turn = step * cell.half;
                let direction =
                    (sin + turn * cos - 0.5 * turn * turn * sin, cos - turn * sin - 0.5 * turn * turn * cos);
                // The step may go back: the trapezoid is signed.
                let slowness = 0.5 * (1.0 / at.u.sqrt() + 1.0 / u.sqrt());
                let elapsed = at.elapsed + step * travel * cell.half * slowness;
                return Some(Waypoint {
                    z: next,
                    u,
                    elapsed,
                    slip: 0.0,
                    slip_acceleration: at.slip_acceleration,
                    direction,
                });
            }
            z = next;
        }
        None
    }
}

/// Root in (0, 1] of the cubic with these values and slopes at 0 and 1, the value at 1 not positive.
fn cubic_root(start: f64, start_slope: f64, end: f64, end_slope: f64) -> f64 {
    let c2 = 3.0 * (end - start) - 2.0 * start_slope - end_slope;
    let c3 = 2.0 * (start - end) + start_slope + end_slope;
    let mut s = 1.0;
    for _ in 0..8 {
        let value = start + s * (start_slope + s * (c2 + s * c3));
        let slope = start_slope + s * (2.0 * c2 + 3.0 * s * c3);
        if slope >= 0.0 {
            break;
        }
        let next: f64 = s - value / slope;
        if !(next > 0.0 && next <= 1.0) {
            break;
        }
        if (next - s).abs() < 1e-6 {
            return next;
        }
        s = next;
    }
    s
}
