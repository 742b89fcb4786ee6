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
//! The ends of a cell then tell what happens inside; the one doubtful shape, η′ with a minimum inside, is solved by Taylor series.
//! The time is a Gauss sum of dϑ/√u, and η′ follows from it by the first integral of sliding.
//!
//! Arcs on which P ≤ 0, and their ends, are left out.
//!
//! Everything is seen in the frame in which σ = +1 (mirrored for σ = −1).

mod cell;
mod crossing;
mod follow;
mod turning;

use core::f64::consts::{PI, TAU};

use crate::math::form::Trigonometric;
use crate::mechanics::equations::{SlidingLaw, contact};
use crate::mechanics::solvability::solvability;
use crate::model::hoop::Heavy;
use crate::model::mode::Direction;

use self::cell::Cell;

/// Widest cell; a cell whose series has not converged is halved.
const WIDEST: f64 = PI / 8.0;

/// A hoop with cells that are narrower than this is not prepared.
const NARROWEST: f64 = 1e-6;

/// So narrow a cell next to a zero of P is left out: motions hardly ever come there, and are followed directly.
const NARROWEST_AT_POLE: f64 = 1e-3;

/// With more cells than this the preparation is given up: a body of very small inertia.
const MOST_CELLS: usize = 600;

/// The slides of one body with one coefficient of friction.
#[derive(Clone, Debug)]
pub(super) struct SlideTable {
    /// With σ = +1.
    law: SlidingLaw,
    cells: Vec<Cell>,
    /// Index of the cell that holds the left end of each slot of a turn.
    slots: Vec<u16>,
    /// Index of the cell that begins at the bottom, ϑ = π.
    bottom: usize,
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

/// Turning points on the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Turns {
    /// Smallest and largest angle of them.
    low: f64,
    high: f64,
    /// How many they are.
    count: f64,
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
    pub(super) turns: Option<Turns>,
}

/// Why a slide is to be followed otherwise.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Unknown {
    /// The sign of η′ is in doubt, or turning points are close to each other.
    Doubt,
    /// It takes many turns.
    Long,
}

/// Where a slide ends, or is cut by a limit of time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum SlideEnd {
    Event(SlideEvent),
    /// Not an event: where it is then.
    Cut(SlideEvent),
    /// Never: without kinetic friction a whole period has passed without an event.
    Never,
}

impl SlideEnd {
    /// The same with what is said of where it is.
    pub(super) fn map(self, seen: impl FnOnce(SlideEvent) -> SlideEvent) -> Self {
        match self {
            Self::Event(event) => Self::Event(seen(event)),
            Self::Cut(event) => Self::Cut(seen(event)),
            Self::Never => Self::Never,
        }
    }
}

impl Turns {
    /// Those so far, and another one.
    pub(super) fn another(turns: Option<Self>, angle: f64) -> Self {
        turns.map_or(Self { low: angle, high: angle, count: 1.0 }, |Self { low, high, count }| Self {
            low: low.min(angle),
            high: high.max(angle),
            count: count + 1.0,
        })
    }

    /// The same after so many periods of a libration more.
    fn after(self, periods: f64) -> Self {
        Self { count: self.count + 2.0 * periods, ..self }
    }

    /// The same in the frame that is mirrored for −1.
    fn mirrored(self, sign: f64) -> Self {
        if sign < 0.0 { Self { low: -self.high, high: -self.low, ..self } } else { self }
    }
}

impl SlideEvent {
    /// Smallest and largest angle of the slide, with the angle at its start.
    pub(super) fn range_from(&self, start: f64) -> (f64, f64) {
        let (low, high) = self.turns.map_or((start, start), |turns| (turns.low, turns.high));
        (low.min(start).min(self.theta), high.max(start).max(self.theta))
    }

    /// Whether a whole period has passed since the start, if energy is conserved: a turn, or the way from the first turning point to the third.
    pub(super) fn is_behind_a_period(&self, start: f64) -> bool {
        (self.theta - start).abs() >= TAU || self.turns.is_some_and(|turns| turns.count >= 3.0)
    }

    /// The same in the frame that is mirrored for −1.
    #[inline]
    pub(super) fn mirrored(self, sign: f64) -> Self {
        let (sin, cos) = self.direction;
        Self {
            turns: self.turns.map(|turns| turns.mirrored(sign)),
            theta: sign * self.theta,
            theta_rate: sign * self.theta_rate,
            // Adding zero makes −0 a 0.
            slip: sign * self.slip + 0.0,
            direction: (sign * sin, cos),
            ..self
        }
    }
}

/// State of a slide at the end of a cell.
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

/// The angles at which the signs change that matter for slides of any speed: those of q, of β and of the slope of the
/// level −α/β on which η″ = α + β u vanishes. With α = A/P and β = B/P,
///
/// ```text
/// A = m (1 + h c) q − μk Î,    B = −h (c A + s P),    level slope ∝ A′B − A B′ − 2 m h s q B,
/// ```
///
/// trigonometric polynomials of degrees two, three and five.
fn cuts(body: &Heavy, mu: f64) -> Vec<f64> {
    let Heavy { mass, h, inertia, .. } = *body;
    let (p, q) = solvability(body, mu);
    let (sin, cos) = (Trigonometric::sin(), Trigonometric::cos());
    let a = Trigonometric::linear(1.0, 0.0, h).times(&q).scaled(mass).minus(&Trigonometric::linear(
        mu * inertia,
        0.0,
        0.0,
    ));
    let b = cos.times(&a).plus(&sin.times(&p)).scaled(-h);
    let turning = a.derivative().times(&b).minus(&a.times(&b.derivative()));
    let level_slope = turning.minus(&sin.times(&q).times(&b).scaled(2.0 * mass * h));
    [q, b, level_slope].iter().flat_map(Trigonometric::sign_changes).collect()
}

impl SlideTable {
    /// Prepares the slides of a body on the arcs where P > 0; none where the cells would be too many.
    pub(super) fn new(body: &Heavy, mu: f64) -> Option<Self> {
        let law = SlidingLaw::of_body(*body, mu, Direction::Positive);
        let mut bounds = vec![0.0, PI, TAU];
        bounds.extend(cuts(body, mu));
        let poles = solvability(body, mu).0.sign_changes();
        bounds.extend(&poles);
        bounds.sort_by(f64::total_cmp);
        bounds.dedup_by(|a, b| *a - *b < 1e-12);
        let mut cells: Vec<Cell> = Vec::new();
        for pair in bounds.windows(2) {
            if law.solvability(0.5 * (pair[0] + pair[1])) <= 0.0 {
                cells.push(Cell::gap(&law, pair[0], pair[1]));
                continue;
            }
            let ends_at_pole = pair.iter().any(|end| poles.iter().any(|pole| (pole - end).abs() < 1e-12));
            let narrowest = if ends_at_pole { NARROWEST_AT_POLE } else { 0.0 };
            let parts = ((pair[1] - pair[0]) / WIDEST).ceil().max(1.0);
            let mut part = 0.0;
            let mut left = pair[0];
            while part < parts {
                part += 1.0;
                let right =
                    if part == parts { pair[1] } else { pair[0] + (pair[1] - pair[0]) * part / parts };
                Self::fill(&law, (left, right), narrowest, &mut cells)?;
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
        let bottom = cells.partition_point(|cell| cell.left < PI);
        Some(Self { law, cells, slots, bottom })
    }

    /// Cells whose series converge; narrower ones than this are left out.
    fn fill(
        law: &SlidingLaw,
        (left, right): (f64, f64),
        narrowest: f64,
        cells: &mut Vec<Cell>,
    ) -> Option<()> {
        if let Some(cell) = Cell::new(law, left, right) {
            cells.push(cell);
            return Some(());
        }
        if right - left < narrowest {
            cells.push(Cell::gap(law, left, right));
            return Some(());
        }
        if cells.len() >= MOST_CELLS || right - left < NARROWEST {
            return None;
        }
        let middle = 0.5 * (left + right);
        Self::fill(law, (left, middle), narrowest, cells)?;
        Self::fill(law, (middle, right), narrowest, cells)
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

    /// What a slide, continued beyond its end, would meet at the ends of cells until it has turned by `reach`; none where P comes too close
    /// to zero.
    pub(super) fn passings(&self, start: &SlideStart, reach: f64) -> Option<Vec<Passing>> {
        let forward = start.theta_rate > 0.0;
        let (mut index, mut offset) = self.entrance(start);
        let mut level = self.level(start);
        let mut passings = Vec::new();
        loop {
            let cell = &self.cells[index];
            if cell.is_gap {
                return None;
            }
            let exit = &cell.edges[usize::from(forward)];
            let u = exit.p + level * exit.h;
            let end = cell.centre + if forward { cell.half } else { -cell.half };
            let turned = (end + offset - start.theta).abs();
            passings.push(Passing {
                angle: end,
                turned,
                slip_acceleration: exit.alpha + exit.beta * u,
                contact: contact(1.0, self.law.body.h, exit.cos * u),
            });
            if turned >= reach || passings.len() > self.cells.len() {
                return Some(passings);
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::trig::sincos;
    use crate::model::hoop::{Body, Hoop, HoopParameters};

    /// du/dϑ = 2 m q (1 − h c u)/P from one angle to another, by the classical Runge–Kutta method.
    fn continued(law: &SlidingLaw, from: f64, to: f64, mut u: f64) -> f64 {
        let Heavy { mass, h, .. } = law.body;
        let slope = |theta: f64, u: f64| {
            let (sin, cos) = libm::sincos(theta);
            2.0 * mass * law.q(1.0, sin, cos) * (1.0 - h * cos * u) / law.solvability(theta)
        };
        let steps = 200;
        let step = (to - from) / f64::from(steps);
        for i in 0..steps {
            let theta = from + step * f64::from(i);
            let first = slope(theta, u);
            let second = slope(theta + 0.5 * step, u + 0.5 * step * first);
            let third = slope(theta + 0.5 * step, u + 0.5 * step * second);
            let fourth = slope(theta + step, u + step * third);
            u += step / 6.0 * (first + 2.0 * (second + third) + fourth);
        }
        u
    }

    #[test]
    fn the_range_of_a_slide_has_its_ends_and_its_turning_points() {
        let direction = (0.0, 1.0);
        let event = SlideEvent {
            elapsed: 1.0,
            theta: 2.0,
            theta_rate: 1.0,
            slip: 0.0,
            direction,
            lifts_off: false,
            turns: None,
        };
        assert_eq!(event.range_from(-0.5), (-0.5, 2.0));
        assert_eq!(event.range_from(3.5), (2.0, 3.5));
        let turns =
            [0.5, 2.5, -1.0].into_iter().fold(None, |turns, angle| Some(Turns::another(turns, angle)));
        let event = SlideEvent { turns, ..event };
        assert_eq!(event.range_from(0.5), (-1.0, 2.5));
        assert_eq!(event.mirrored(-1.0).range_from(0.5), (-2.5, 1.0));
        assert_eq!(event.range_from(4.0), (-1.0, 4.0));
    }

    #[test]
    fn cells_are_left_out_only_where_p_is_not_positive_or_next_to_its_zeros() {
        for (mass_ratio, inertia, mu) in
            [(0.2, 0.1, 1.4), (0.0, 0.001, 0.4), (0.01, 0.01, 0.5), (1.0, 1.0, 0.4)]
        {
            let hoop =
                Hoop::new(HoopParameters::new(mass_ratio, 1.0, inertia).with_friction(mu, mu)).unwrap();
            let Body::Heavy(body) = hoop.body() else { unreachable!("it has mass") };
            let table = SlideTable::new(&body, mu).unwrap();
            let poles = solvability(&body, mu).0.sign_changes();
            let mut end = 0.0;
            for cell in &table.cells {
                assert!((cell.left - end).abs() < 1e-12, "{} {end}", cell.left);
                end = cell.left + 2.0 * cell.half;
                let p = [0.01, 0.3, 0.7, 0.99]
                    .map(|part| table.law.solvability(cell.left + part * (end - cell.left)));
                if !cell.is_gap {
                    assert!(p.into_iter().all(|p| p > 0.0), "{mass_ratio} {inertia}: {p:?}");
                } else if p.into_iter().all(|p| p > 0.0) {
                    let near = |angle: &f64| (cell.left - 0.01..end + 0.01).contains(angle);
                    assert!(cell.half < NARROWEST_AT_POLE && poles.iter().any(near), "{} {end}", cell.left);
                }
            }
            assert!((end - TAU).abs() < 1e-12, "{end}");
            assert_eq!(table.cells.iter().any(|cell| cell.is_gap), !poles.is_empty());
            // From a gap nothing is followed, and nothing is passed.
            for gap in table.cells.iter().filter(|cell| cell.is_gap) {
                let direction = sincos(gap.centre);
                let start = SlideStart { theta: gap.centre, theta_rate: 1.0, slip: 1.0, direction };
                assert_eq!(table.follow(start, f64::INFINITY), Err(Unknown::Doubt));
                assert!(table.passings(&start, 1.0).is_none());
            }
        }
    }

    #[test]
    fn passings_are_the_states_of_a_slide_at_the_ends_of_cells_as_far_as_is_asked() {
        for (mass_ratio, inertia, mu) in [(1.0, 1.0, 0.4), (0.3, 0.2, 0.2), (3.0, 1.5, 0.7)] {
            let hoop =
                Hoop::new(HoopParameters::new(mass_ratio, 1.0, inertia).with_friction(mu, mu)).unwrap();
            let Body::Heavy(body) = hoop.body() else { unreachable!("it has mass") };
            let table = SlideTable::new(&body, mu).unwrap();
            for (theta, theta_rate) in [(0.4, 3.0), (0.4, -2.5), (5.9, 2.8), (-1.0, -3.5)] {
                let start = SlideStart { theta, theta_rate, slip: 0.0, direction: libm::sincos(theta) };
                let (mut here, mut u) = (theta, theta_rate * theta_rate);
                let passings = table.passings(&start, 2.5).unwrap();
                for passing in &passings {
                    let there = theta + passing.turned.copysign(theta_rate);
                    u = continued(&table.law, here, there, u);
                    let turns = (there - passing.angle) / TAU;
                    assert!((turns - turns.round()).abs() < 1e-12, "{passing:?} {there}");
                    let contact = 1.0 - body.h * libm::cos(there) * u;
                    assert!((passing.contact - contact).abs() < 1e-8, "{passing:?} {contact}");
                    let slip_acceleration = table.law.accelerations(there, u.sqrt()).slip;
                    assert!((passing.slip_acceleration - slip_acceleration).abs() < 1e-8, "{passing:?}");
                    here = there;
                }
                assert!(passings.windows(2).all(|pair| pair[0].turned < pair[1].turned));
                assert!(passings.last().is_some_and(|last| last.turned >= 2.5));
            }
        }
    }
}
