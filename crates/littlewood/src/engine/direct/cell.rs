//! All slides of a body in one direction about an angle.
//!
//! There every slide is u = p + u_c h, with two series and one number u_c that belongs to the slide. They reach to both sides, twice as
//! far as the series of one slide from where it begins, and serve every slide of a motion that comes there.

use core::f64::consts::TAU;

use crate::math::trig::sincos;
use crate::mechanics::equations::SlidingLaw;

use super::super::piece::Waypoint;
use super::super::polynomial::value;
use super::expansion::{
    CONVERGED, Low, Polynomials, Series, Signs, bernstein, from_both_sides, least, pattern, reach, scaled,
};
use super::step::Step;

/// Cells of a turn, evenly spaced. They overlap, wherever P is not close to zero.
pub(super) const CELLS: usize = 16;

/// Largest z of a cell: in wider ones u changes more than the time allows.
const WIDEST: f64 = 0.2;

/// A slide that is farther ahead in a cell begins anew: what is left of the cell is not worth a step.
const LATEST: f64 = 0.6;

/// All slides in one direction about an angle, with the coordinate t = z/width from −1 to 1.
#[derive(Clone, Debug)]
pub(super) struct Cell {
    /// sin ϑ and cos ϑ at the centre.
    direction: (f64, f64),
    /// z at the end.
    width: f64,
    /// u = p + u_c h, with coefficients that tell up to the degree, which is even.
    p: Series,
    h: Series,
    degree: usize,
    /// The Bernstein coefficients of n³ P σ η″ = a + u_c b, and what each leaves out.
    a: (Low, f64),
    b: (Low, f64),
    /// P is nowhere less.
    least: f64,
}

fn largest(series: &Series) -> f64 {
    series.iter().fold(0.0, |largest, c| largest.max(c.abs()))
}

/// The degree up to which the coefficients of a series tell.
fn degree_of(series: &Series) -> usize {
    let least = CONVERGED * largest(series);
    series.iter().rposition(|c| c.abs() > least).unwrap_or(0)
}

impl Cell {
    /// The cell whose centre is the next ahead of an angle, and the one before.
    pub(super) fn about(theta: f64) -> [usize; 2] {
        let place = theta * (CELLS as f64 / TAU);
        let turns = (place / CELLS as f64).floor();
        let before = (place - CELLS as f64 * turns) as usize % CELLS;
        [(before + 1) % CELLS, before]
    }

    /// The slides with the direction `sigma` of slip in the frame of motion. None where P is not known to be positive.
    pub(super) fn new(law: &SlidingLaw, sigma: f64, cell: usize) -> Option<Self> {
        let direction = sincos(cell as f64 * (TAU / CELLS as f64));
        let polynomials = Polynomials::new(law, sigma, direction);
        let [p, h] = polynomials.solutions([0.0, 1.0], [1.0, 0.0]);
        let size = largest(&scaled(p, WIDEST));
        let width = reach(&p, 0, size).min(reach(&h, 0, 1.0)).min(WIDEST);
        let [p, h] = [p, h].map(|series| scaled(series, width));
        let least = least(from_both_sides(polynomials.p(width)));
        if !(least > 0.0 && width > 0.0) {
            return None;
        }
        let signs = |u: &Series, part_of_a: f64| {
            let (low, band) = polynomials.slip_acceleration(u, width, part_of_a);
            (bernstein(from_both_sides(low)), band)
        };
        let (a, b) = (signs(&p, 1.0), signs(&h, 0.0));
        let degree = degree_of(&p).max(degree_of(&h)).next_multiple_of(2);
        Some(Self { direction, width, p, h, degree, a, b, least })
    }

    /// Where a direction is.
    pub(super) fn place(&self, (sin, cos): (f64, f64)) -> f64 {
        let (middle_sin, middle_cos) = self.direction;
        let (turn_sin, turn_cos) = (sin * middle_cos - cos * middle_sin, cos * middle_cos + sin * middle_sin);
        turn_sin / ((1.0 + turn_cos) * self.width)
    }

    /// The step of a slide from a place in the cell to its end. None at other places, where u is not known to stay away from
    /// zero, and where η″ may change its sign twice.
    pub(super) fn step(&self, here: &Waypoint) -> Option<Step> {
        if !(here.z >= -1.0 && here.z <= LATEST) {
            return None;
        }
        let at_place = |series: &Series| value(&series[..=self.degree], here.z);
        let level = (here.u - at_place(&self.p)) / at_place(&self.h);
        // What fails mostly does so by the slope.
        if !Step::is_nearly_even(level, self.p[1] + level * self.h[1], here.z) {
            return None;
        }
        let u: Series = core::array::from_fn(|k| self.p[k] + level * self.h[k]);
        if !Step::is_clear(&u, here.z) {
            return None;
        }
        let (a, b) = (&self.a, &self.b);
        let signs: Low = core::array::from_fn(|k| a.0[k] + level * b.0[k]);
        let band = a.1 + level.abs() * b.1;
        let signs = pattern(&signs, band);
        (signs != Signs::Unknown).then_some(Step {
            width: self.width,
            u,
            degree: self.degree,
            signs,
            doubt: 2.0 * band / self.least,
            direction: self.direction,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::direct::expansion::{Expansion, Signs};
    use crate::engine::piece::Piece;
    use crate::engine::piece::check::is_a_slide;
    use crate::model::hoop::{Body, Hoop};
    use crate::model::mode::Direction;

    /// All cells of a hoop, with their laws and signs.
    fn cells(hoop: &Hoop) -> Vec<(SlidingLaw, f64, usize, Cell)> {
        let Body::Heavy(body) = hoop.body() else { unreachable!("it has mass") };
        let laws = [Direction::Negative, Direction::Positive]
            .map(|direction| (SlidingLaw::of_body(body, hoop.mu_k(), direction), direction.sign()));
        laws.into_iter()
            .flat_map(|(law, sigma)| {
                (0..CELLS)
                    .filter_map(move |number| Some((law, sigma, number, Cell::new(&law, sigma, number)?)))
            })
            .collect()
    }

    fn waypoint(z: f64, u: f64) -> Waypoint {
        Waypoint { z, u, elapsed: 0.0, slip: 0.1, slip_acceleration: 0.0, direction: (0.0, 1.0) }
    }

    #[test]
    fn a_step_through_a_cell_is_a_slide() {
        let hoop = Hoop::figure_2(0.5, 0.4).unwrap();
        let (cells, mut steps) = (cells(&hoop), 0);
        assert_eq!(cells.len(), 2 * CELLS);
        for (law, sigma, number, cell) in &cells {
            for (from, u) in [(-1.0, 3.0), (-0.4, 1.3), (0.7, 0.6), (0.0, 20.0)] {
                let Some(step) = cell.step(&waypoint(from, u)) else { continue };
                steps += 1;
                assert!((step.u(from) - u).abs() < 1e-15 * (4.0 + u), "{number} {from}");
                is_a_slide(&step, law, (from, 1.0));
                // The same slide by its own series, as far as that goes.
                let direction = step.direction(from);
                assert!((cell.place(direction) - from).abs() < 1e-15);
                let expansion = Expansion::new(law, *sigma, direction, u);
                let own = Step::new(&expansion, direction, expansion.reach(0), false).unwrap();
                let turned = step.turned_by(1.0) - step.turned_by(from);
                let t = libm::tan(0.5 * turned) / own.width;
                if t <= 1.0 {
                    let (end, there) = (step.u(1.0), own.u(t));
                    assert!((end - there).abs() < 4e-15 * (1.0 + u), "{number} {from}: {end} {there}");
                    let [time, expected] = [step.time((from, u), (1.0, end)), own.time((0.0, u), (t, there))];
                    let (time, expected) = (time.unwrap(), expected.unwrap());
                    assert!((time - expected).abs() < 4e-15, "{number} {from}: {time} {expected}");
                }
            }
        }
        assert!(steps > 2 * cells.len(), "{steps}");
    }

    /// The sign of η″ is told for a slide as it is at points of the cell.
    #[test]
    fn signs_in_a_cell_are_those_of_the_slip_acceleration() {
        let hoop = Hoop::figure_2(0.5, 0.4).unwrap();
        let (mut same, mut changes) = (0, 0);
        for (law, sigma, number, cell) in cells(&hoop) {
            for u in [0.5, 1.0, 1.5, 2.0, 3.0, 5.0] {
                let Some(step) = cell.step(&waypoint(-1.0, u)) else { continue };
                let at = |t: f64| {
                    let (sin, cos) = step.direction(t);
                    let (alpha, beta) = law.slip_acceleration(sin, cos);
                    sigma * (alpha + beta * step.u(t))
                };
                let seen: Vec<f64> = (0..=40).map(|k| at(-1.0 + 0.05 * f64::from(k))).collect();
                let clear = |value: &&f64| value.abs() > step.doubt;
                let positive = |value: &f64| *value > 0.0;
                let (first, last) = (positive(&seen[0]), positive(&seen[40]));
                match step.signs {
                    Signs::Positive => assert!(seen.iter().all(positive), "{number} {u}"),
                    Signs::Negative => assert!(!seen.iter().any(positive), "{number} {u}"),
                    Signs::Falling | Signs::Rising => {
                        assert_eq!(
                            (first, last),
                            (step.signs == Signs::Falling, step.signs == Signs::Rising)
                        );
                        let clear: Vec<bool> = seen.iter().filter(clear).map(positive).collect();
                        assert_eq!(clear.windows(2).filter(|pair| pair[0] != pair[1]).count(), 1);
                        changes += 1;
                    }
                    Signs::Unknown => continue,
                }
                same += 1;
            }
        }
        assert!(same > 60 && changes > 3, "{same} {changes}");
    }

    #[test]
    fn angles_lie_between_the_centres_about_them() {
        for turns in [-3.0, 0.0, 7.0] {
            for number in 0..CELLS {
                let theta = TAU * (turns + (number as f64 + 0.3) / CELLS as f64);
                assert_eq!(Cell::about(theta), [(number + 1) % CELLS, number]);
            }
        }
        assert_eq!((Cell::about(0.0), Cell::about(-1e-300)), ([1, 0], [1, 0]));
    }
}
