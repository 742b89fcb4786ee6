//! All slides of a body in one direction about an angle.
//!
//! There every slide is u = p + u_c h, with two series and one number u_c that belongs to the
//! slide. They reach to both sides, twice as far as the series of one slide from where it begins,
//! and serve every slide of a motion that comes there.

use core::f64::consts::TAU;
use std::sync::OnceLock;

use crate::engine::quadrature::{
    MIDDLE_NODE as NODE, MIDDLE_NODES as NODES, MIDDLE_WEIGHT as WEIGHT,
};
use crate::math::trig::sincos;
use crate::mechanics::SlidingLaw;

use super::regular::{RegularSegment, rotated};
use super::segment::{LawAt, SlidePoint};
use super::series::{
    CONVERGENCE, Low, Polynomials, Series, SignPattern, bernstein, from_both_sides, least, reach,
    scaled, sign_pattern, sum_of_sizes, value,
};

/// The number of coarsest tiles in a turn.
pub(super) const INTERVALS: usize = 16;

/// How often a tile may be halved where its series do not reach over it, or u changes too much on
/// it.
pub(super) const HALVINGS: usize = 5;

/// The finest tiles of a turn. Angles at which tiles begin are counted in these.
const EDGE_COUNT: usize = INTERVALS << HALVINGS;

/// A step in a cell is not shorter, in t.
const MIN_STEP: f64 = 1e-9;

/// All slides in one direction about an angle, with the coordinate t = z/width from −1 to 1.
#[derive(Clone, Debug)]
pub(super) struct SlideTable {
    /// sin ϑ and cos ϑ at the centre.
    direction: (f64, f64),
    /// z at the end: twice as far from the centre as the tile, or as far as the series reach.
    width: f64,
    /// u = p + u_c h, truncated at the first of these degrees, which are even, and on the tile at
    /// the second.
    p: Series,
    h: Series,
    degrees: (usize, usize),
    /// The Bernstein coefficients of n³ P σ η″ = a + u_c b, and what each leaves out.
    a: (Low, f64),
    b: (Low, f64),
    /// P is nowhere less.
    least: f64,
    /// t at the end of its tile.
    end: f64,
    /// p and h at the ends of its tile.
    entry: (f64, f64),
    exit: (f64, f64),
    law_at_exit: LawAt,
    /// p, h, and the weight of 1/√u in the time, at the Gauss nodes of its tile.
    nodes: [[f64; NODES]; 3],
    /// Sums of the sizes of the terms of p and h, from the linear ones on, up to the ellipse on
    /// which u has no zero if they are small.
    terms: (f64, f64),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct AngleInterval {
    pub(super) halvings: usize,
    /// Of INTERVALS · 2^halvings, from the top.
    number: usize,
}

impl AngleInterval {
    const fn count(self) -> usize {
        INTERVALS << self.halvings
    }

    pub(super) fn angle(self) -> f64 {
        TAU / self.count() as f64
    }

    /// The tile that begins at an edge, halved so often, if there is one.
    pub(super) const fn at(edge: usize, halvings: usize) -> Option<Self> {
        let shift = HALVINGS - halvings;
        let number = edge >> shift;
        if number << shift == edge {
            Some(Self { halvings, number })
        } else {
            None
        }
    }

    /// The edge at its end.
    pub(super) const fn exit(self) -> usize {
        ((self.number + 1) << (HALVINGS - self.halvings)) % EDGE_COUNT
    }

    /// The tile whose centre is the next ahead of an angle, and the one before.
    pub(super) fn about(theta: f64, halvings: usize) -> [Self; 2] {
        let tile = |number| Self { halvings, number };
        let count = tile(0).count();
        let place = theta * (count as f64 / TAU) - 0.5;
        let turns = (place / count as f64).floor();
        let before = (place - count as f64 * turns) as usize % count;
        [tile((before + 1) % count), tile(before)]
    }
}

/// The angle of an edge, next to another angle.
pub(super) fn edge_angle_near(edge: usize, theta: f64) -> f64 {
    let angle = edge as f64 * (TAU / EDGE_COUNT as f64);
    angle + TAU * ((theta - angle) / TAU + 0.5).floor()
}

type Kept = [OnceLock<Option<Box<SlideTable>>>];

/// The cells of one hoop, made where slides come, and the same whichever slide that is.
#[derive(Clone, Debug, Default)]
pub(in crate::engine) struct SlideTables([[OnceLock<Box<Kept>>; HALVINGS + 1]; 4]);

impl SlideTables {
    /// The cell of a tile for the direction `sigma` of slip in the frame of motion, if there is
    /// one. On a slope the mirrored frame has its own.
    pub(super) fn get(
        &self,
        law: &SlidingLaw,
        sigma: f64,
        tile: AngleInterval,
    ) -> Option<&SlideTable> {
        let which = usize::from(sigma > 0.0) + 2 * usize::from(law.body.tilt > 0.0);
        let cells = &self.0[which][tile.halvings];
        let cells = cells.get_or_init(|| (0..tile.count()).map(|_| OnceLock::new()).collect());
        cells[tile.number]
            .get_or_init(|| SlideTable::new(law, sigma, tile).map(Box::new))
            .as_deref()
    }

    /// The coarsest tile from an edge, halved at least so often, that a slide with this u crosses;
    /// with its cell, u_c, and u at its end.
    pub(super) fn crossing(
        &self,
        (law, sigma): (&SlidingLaw, f64),
        (edge, halvings): (usize, usize),
        u: f64,
    ) -> Option<(AngleInterval, &SlideTable, f64, f64)> {
        (halvings..=HALVINGS).find_map(|halvings| {
            let tile = AngleInterval::at(edge, halvings)?;
            let cell = self.get(law, sigma, tile)?;
            let (level, end) = cell.crossing(u)?;
            Some((tile, cell, level, end))
        })
    }
}

fn largest(series: &Series) -> f64 {
    series.iter().fold(0.0, |largest, c| largest.max(c.abs()))
}

/// The even degree at which two series are truncated up to this t.
fn degree_of(series: [&Series; 2], t: f64) -> usize {
    let degrees = series.map(|series| {
        let terms = scaled(*series, t);
        let least = CONVERGENCE * largest(&terms);
        terms.iter().rposition(|c| c.abs() > least).unwrap_or(0)
    });
    degrees[0].max(degrees[1]).next_multiple_of(2)
}

impl SlideTable {
    /// The slides with the direction `sigma` of slip in the frame of motion. None where P is not
    /// known to be positive, and where the series do not reach over the tile.
    fn new(law: &SlidingLaw, sigma: f64, tile: AngleInterval) -> Option<Self> {
        let angle = tile.angle();
        let direction = sincos((tile.number as f64 + 0.5) * angle);
        let polynomials = Polynomials::new(law, sigma, direction);
        let [p, h] = polynomials.solutions([0.0, 1.0], [1.0, 0.0]);
        // z at the end of the tile; u changes no more than the Gauss sum of the time allows up to
        // twice the angle.
        let [half, widest] = [0.25, 0.5].map(|part| libm::tan(part * angle));
        let size = largest(&scaled(p, widest));
        let width = reach(&p, 0, size).min(reach(&h, 0, 1.0)).min(widest);
        let [p, h] = [p, h].map(|series| scaled(series, width));
        let least = least(from_both_sides(polynomials.p(width)));
        if !(least > 0.0 && width > half) {
            return None;
        }
        let signs = |u: &Series, part_of_a: f64| {
            let (low, band) = polynomials.slip_acceleration(u, width, part_of_a);
            (bernstein(from_both_sides(low)), band)
        };
        let (a, b) = (signs(&p, 1.0), signs(&h, 0.0));
        let at = |t: f64| [&p, &h].map(|series| value(series, t));
        let end = half / width;
        let degrees = (degree_of([&p, &h], 1.0), degree_of([&p, &h], end));
        let [entry, exit] = [at(-end), at(end)];
        let far = RegularSegment::far(-end, end);
        let [p_terms, h_terms] = [&p, &h].map(|series| far * sum_of_sizes(&series[1..], far));
        let nodes = NODE.map(|node| at(end * node));
        let weight = |j: usize| {
            let z = half * NODE[j];
            2.0 * half * WEIGHT[j] / (1.0 + z * z)
        };
        Some(Self {
            direction,
            width,
            degrees,
            least,
            end,
            entry: (entry[0], entry[1]),
            exit: (exit[0], exit[1]),
            law_at_exit: LawAt::new(law, rotated(direction, half)),
            nodes: [
                nodes.map(|node| node[0]),
                nodes.map(|node| node[1]),
                core::array::from_fn(weight),
            ],
            terms: (p_terms, h_terms),
            p,
            h,
            a,
            b,
        })
    }

    fn place(&self, (sin, cos): (f64, f64)) -> f64 {
        let (middle_sin, middle_cos) = self.direction;
        let (turn_sin, turn_cos) = (
            sin * middle_cos - cos * middle_sin,
            cos * middle_cos + sin * middle_sin,
        );
        turn_sin / ((1.0 + turn_cos) * self.width)
    }

    /// Of a slide with this u at the beginning of the tile: u_c, and u at the end of the tile. None
    /// where u is not known to stay away from zero.
    pub(super) fn crossing(&self, u: f64) -> Option<(f64, f64)> {
        let level = (u - self.entry.0) / self.entry.1;
        let is_clear =
            self.terms.0 + level * self.terms.1 <= RegularSegment::MAX_TERM_RATIO * level;
        (level > 0.0 && is_clear).then_some((level, self.exit.0 + level * self.exit.1))
    }

    /// The time from the beginning of the tile to its end.
    pub(super) fn time(&self, level: f64) -> f64 {
        let [p, h, weight] = &self.nodes;
        let mut sum = 0.0;
        for j in 0..NODES {
            sum += weight[j] / (p[j] + level * h[j]).sqrt();
        }
        sum
    }

    pub(super) const fn law_at_exit(&self) -> &LawAt {
        &self.law_at_exit
    }

    /// The step over the whole tile of a slide that crosses it in this time, and its place at the
    /// beginning.
    pub(super) fn whole_step(
        &self,
        here: &SlidePoint,
        level: f64,
        time: f64,
    ) -> Option<(SlidePoint, RegularSegment)> {
        let place = SlidePoint {
            z: -self.end,
            ..*here
        };
        let u = core::array::from_fn(|k| self.p[k] + level * self.h[k]);
        Some((
            place,
            self.step_at(
                (level, u),
                self.degrees.1,
                (self.end, Some((place.z, time))),
            )?,
        ))
    }

    /// The step of a slide with this direction and u to the end of the tile, or half as far, and
    /// its place there. None at other places, where u is not known to stay away from zero, and
    /// where η″ may change its sign twice.
    pub(super) fn step(&self, here: &SlidePoint) -> Option<(SlidePoint, RegularSegment)> {
        let z = self.place(here.direction);
        if !(z >= -1.0 && z < self.end - MIN_STEP) {
            return None;
        }
        let degree = if z >= -self.end {
            self.degrees.1
        } else {
            self.degrees.0
        };
        let at_place = |series: &Series| value(&series[..=degree], z);
        let level = (here.u - at_place(&self.p)) / at_place(&self.h);
        let slope = self.p[1] + level * self.h[1];
        // What fails mostly does so by the slope.
        let nearly_even = |end: &f64| RegularSegment::is_nearly_even(level, slope, (z, *end));
        let u: Series = core::array::from_fn(|k| self.p[k] + level * self.h[k]);
        let clear = |end: &f64| RegularSegment::is_clear(&u[..=degree], (z, *end));
        let end = [self.end, 0.5 * (z + self.end)]
            .into_iter()
            .filter(nearly_even)
            .find(clear)?;
        Some((
            SlidePoint { z, ..*here },
            self.step_at((level, u), degree, (end, None))?,
        ))
    }

    /// The Bernstein coefficients of n³ P σ η″ of a slide, and what they leave out.
    fn coefficients(&self, level: f64) -> (Low, f64) {
        let (a, b) = (&self.a, &self.b);
        (
            core::array::from_fn(|k| a.0[k] + level * b.0[k]),
            a.1 + level.abs() * b.1,
        )
    }

    /// The signs of σ η″ of a slide on the cell, and the largest |η″| where its sign is not known.
    pub(super) fn signs(&self, level: f64) -> (SignPattern, f64) {
        let (coefficients, band) = self.coefficients(level);
        (sign_pattern(&coefficients, band), 2.0 * band / self.least)
    }

    /// A lower bound of σ η″ of a slide on the cell, at most zero.
    pub(super) fn least_slip_acceleration(&self, level: f64) -> f64 {
        let (coefficients, band) = self.coefficients(level);
        (coefficients.into_iter().fold(0.0, f64::min) - band) / self.least
    }

    fn step_at(
        &self,
        (level, u): (f64, Series),
        degree: usize,
        (end, known): (f64, Option<(f64, f64)>),
    ) -> Option<RegularSegment> {
        let (signs, doubt) = self.signs(level);
        let is_whole = end == self.end;
        (signs != SignPattern::Unknown).then(|| RegularSegment {
            width: self.width,
            u,
            degree,
            signs,
            doubt,
            direction: self.direction,
            end,
            known,
            exit: is_whole.then_some((self.exit.0 + level * self.exit.1, self.law_at_exit)),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Body, Direction, Hoop, HoopParameters};

    /// All cells of a hoop whose tiles are halved so often, with their laws and signs.
    fn cells(hoop: &Hoop, halvings: usize) -> Vec<(SlidingLaw, f64, AngleInterval, SlideTable)> {
        let Body::Heavy(body) = hoop.body() else {
            unreachable!("it has mass")
        };
        let laws = [Direction::Negative, Direction::Positive].map(|direction| {
            (
                SlidingLaw::of_body(body, hoop.mu_k(), direction),
                direction.sign(),
            )
        });
        laws.into_iter()
            .flat_map(|(law, sigma)| {
                (0..INTERVALS << halvings)
                    .map(move |number| AngleInterval { halvings, number })
                    .filter_map(move |tile| {
                        Some((law, sigma, tile, SlideTable::new(&law, sigma, tile)?))
                    })
            })
            .collect()
    }

    /// Also of light hoops, and next to zeros of P, where p and h change most.
    #[test]
    fn u_is_positive_where_a_tile_is_crossed() {
        let mut crossings = 0;
        for (mass_ratio, inertia, mu) in [
            (1.0, 1.0, 0.4),
            (0.01, 0.01, 0.4),
            (0.0, 3e-4, 0.4),
            (0.2, 0.1, 1.4),
        ] {
            let hoop = HoopParameters::thin(mass_ratio)
                .with_inertia(inertia)
                .with_friction(mu, mu);
            let hoop = Hoop::new(hoop).unwrap();
            for (_, sigma, tile, cell) in (0..=HALVINGS).flat_map(|halvings| cells(&hoop, halvings))
            {
                for exponent in -24..=24 {
                    let u = libm::pow(10.0, 0.25 * f64::from(exponent));
                    let Some((level, end)) = cell.crossing(u) else {
                        continue;
                    };
                    let [p, h, _] = &cell.nodes;
                    let least = p
                        .iter()
                        .zip(h)
                        .map(|(p, h)| p + level * h)
                        .fold(end, f64::min);
                    assert!(
                        least > 0.0,
                        "{mass_ratio} {inertia}: {sigma} {tile:?} {u}: {least}"
                    );
                    crossings += 1;
                }
            }
        }
        assert!(crossings > 1000, "{crossings}");
    }

    #[test]
    fn angles_lie_between_the_centres_about_them() {
        for halvings in 0..=HALVINGS {
            let tile = |number| AngleInterval { halvings, number };
            let count = INTERVALS << halvings;
            for turns in [-3.0, 0.0, 7.0] {
                for number in 0..count {
                    let theta = TAU * (turns + (number as f64 + 0.8) / count as f64);
                    assert_eq!(
                        AngleInterval::about(theta, halvings),
                        [tile((number + 1) % count), tile(number)]
                    );
                }
            }
            assert_eq!(
                AngleInterval::about(0.0, halvings),
                [tile(0), tile(count - 1)]
            );
        }
    }

    /// Where η″ rises through zero it is nowhere less than what is told of it.
    #[test]
    fn slip_accelerations_are_no_less_than_the_least() {
        let hoop = Hoop::figure_2(0.5, 0.4).unwrap();
        let mut falls = 0;
        for (law, sigma, tile, cell) in cells(&hoop, 0) {
            for level in [0.5, 1.0, 1.5, 2.0, 3.0, 5.0] {
                let least = cell.least_slip_acceleration(level);
                let seen = (-20..=20).map(|k| {
                    let t = 0.05 * f64::from(k);
                    let (sin, cos) = rotated(cell.direction, cell.width * t);
                    let (alpha, beta) = law.slip_acceleration(sin, cos);
                    sigma * (alpha + beta * (value(&cell.p, t) + level * value(&cell.h, t)))
                });
                let lowest = seen.fold(0.0, f64::min);
                assert!(lowest >= least, "{tile:?} {level}: {lowest} {least}");
                falls += u32::from(lowest < 0.0);
            }
        }
        assert!(falls > 30, "{falls}");
    }
}
