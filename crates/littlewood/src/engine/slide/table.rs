//! All slides of a body in one direction about an angle.
//!
//! There every slide is u = p + u_c h, with two series and the number u_c that belongs to the
//! slide, u at the centre. The series reach to both sides, twice as far as the series of one slide
//! from where it begins, and serve every slide of a motion that comes there.

use core::f64::consts::TAU;
use std::sync::OnceLock;

use crate::engine::quadrature::{
    MIDDLE_NODE as NODE, MIDDLE_NODES as NODES, MIDDLE_WEIGHT as WEIGHT,
};
use crate::engine::roll::OrbitRange;
use crate::math::trig::Angle;
use crate::mechanics::SlidingLaw;

use super::regular::{KnownTime, RegularSegment, SegmentExit, Span};
use super::segment::{LocalCoefficients, SlidePoint};
use super::series::{
    CONVERGENCE, InitialValue, LinearEquation, LinearForm, Series, SignPattern, Signs,
    SlidePolynomials, SlipSigns, TruncatedPolynomial, bernstein, convergence_radius,
    from_both_sides, min_value, scaled, sign_uncertainty, sum_of_sizes, value,
};

/// The number of coarsest intervals in a turn.
pub(super) const INTERVALS: usize = 16;

/// How often an interval may be halved where its series do not reach over it, or u changes too much
/// on it.
pub(super) const HALVINGS: usize = 5;

/// The finest intervals of a turn. Angles at which intervals begin are counted in these.
const EDGE_COUNT: usize = INTERVALS << HALVINGS;

/// An interval has no table for motions whose u would double within this z; each halving of the
/// interval doubles the slope that is allowed.
const MIN_DOUBLING_DISTANCE: f64 = 0.25;

/// A segment in a table is not shorter, in t.
const MIN_LENGTH: f64 = 1e-9;

/// A number of each slide on a table that is linear in u_c: p + u_c h.
#[derive(Clone, Copy, Debug)]
struct Linear {
    p: f64,
    h: f64,
}

impl Linear {
    #[inline(always)]
    fn at(self, u_centre: f64) -> f64 {
        self.p + u_centre * self.h
    }
}

/// The same at the Gauss nodes of an interval, and the weight of 1/√u in the time.
#[derive(Clone, Debug)]
struct Nodes {
    p: [f64; NODES],
    h: [f64; NODES],
    weight: [f64; NODES],
}

/// All slides in one direction about an angle.
#[derive(Clone, Debug)]
pub(super) struct SlideTable {
    pub(super) solutions: SolutionTable,
    /// n³ P σ η″ = a + u_c b in Bernstein form.
    a: TruncatedPolynomial,
    b: TruncatedPolynomial,
    /// u_c of slides with σ η″ certainly positive everywhere on it, and negative.
    positive: OrbitRange,
    negative: OrbitRange,
    /// P is nowhere less.
    min_p: f64,
    exit_coefficients: LocalCoefficients,
}

/// All solutions of a linear equation about an angle, with the coordinate t = z/width from −1 to 1.
#[derive(Clone, Debug)]
pub(super) struct SolutionTable {
    /// At the centre.
    pub(super) angle: Angle,
    /// z at t = 1: twice as far from the centre as the end of the interval, or as far as the series
    /// converge.
    pub(super) width: f64,
    pub(super) p: Series,
    pub(super) h: Series,
    /// The even degree at which these are truncated, and the one that suffices on the interval.
    degree: usize,
    interval_degree: usize,
    /// t at the end of the interval.
    pub(super) end: f64,
    /// At the end of the interval.
    pub(super) exit_angle: Angle,
    /// u at the ends of the interval.
    entry: Linear,
    exit: Linear,
    nodes: Nodes,
    /// Sum of the sizes of the terms of u, from the linear one on, up to the ellipse on which u has
    /// no zero if they are small.
    terms: Linear,
}

/// An interval of the angle grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct AngleInterval {
    pub(super) halvings: usize,
    /// Of INTERVALS · 2^halvings, from the top.
    number: usize,
}

impl AngleInterval {
    /// The coarsest, of a whole turn.
    pub(super) fn all() -> impl Iterator<Item = Self> {
        (0..INTERVALS).map(|number| Self {
            halvings: 0,
            number,
        })
    }

    const fn count(self) -> usize {
        INTERVALS << self.halvings
    }

    pub(super) fn width(self) -> f64 {
        TAU / self.count() as f64
    }

    /// The interval that begins at an edge, halved so often, if there is one.
    pub(super) const fn at(edge: usize, halvings: usize) -> Option<Self> {
        let shift = HALVINGS - halvings;
        let number = edge >> shift;
        if number << shift == edge {
            Some(Self { halvings, number })
        } else {
            None
        }
    }

    /// The interval that holds an angle of the turn from 0 on.
    pub(super) fn holding(angle: f64, halvings: usize) -> Self {
        let count = INTERVALS << halvings;
        Self {
            halvings,
            number: (angle * (count as f64 / TAU)) as usize % count,
        }
    }

    /// The angle in its middle.
    pub(super) fn centre(self) -> Angle {
        Angle::of((self.number as f64 + 0.5) * self.width())
    }

    /// The angle at its end.
    pub(super) fn end(self) -> f64 {
        (self.number + 1) as f64 * self.width()
    }

    /// The edge at its end.
    pub(super) const fn exit(self) -> usize {
        ((self.number + 1) << (HALVINGS - self.halvings)) % EDGE_COUNT
    }

    /// The interval whose centre is the next ahead of an angle, and the one before.
    pub(super) fn about(theta: f64, halvings: usize) -> [Self; 2] {
        let interval = |number| Self { halvings, number };
        let count = interval(0).count();
        let position = theta * (count as f64 / TAU) - 0.5;
        let turns = (position / count as f64).floor();
        let before = (position - count as f64 * turns) as usize % count;
        [interval((before + 1) % count), interval(before)]
    }
}

/// How often the intervals with a table for a motion must be halved at least, from du/dz; none where
/// there is no table.
#[inline(always)]
pub(super) fn coarsest(slope: f64, u: f64) -> Option<usize> {
    (0..=HALVINGS).find(|k| MIN_DOUBLING_DISTANCE * slope.abs() <= u * (1_u32 << k) as f64)
}

/// The angle of an edge, in the turn of another angle.
pub(super) fn edge_angle_near(edge: usize, theta: f64) -> f64 {
    let angle = edge as f64 * (TAU / EDGE_COUNT as f64);
    angle + TAU * ((theta - angle) / TAU + 0.5).floor()
}

type LazyTables<T> = [OnceLock<Option<Box<T>>>];

/// A table for each interval, made when a motion first needs it, and the same whichever motion that
/// is.
#[derive(Clone, Debug)]
pub(super) struct LazyGrid<T>([OnceLock<Box<LazyTables<T>>>; HALVINGS + 1]);

impl<T> Default for LazyGrid<T> {
    fn default() -> Self {
        Self([const { OnceLock::new() }; HALVINGS + 1])
    }
}

impl<T> LazyGrid<T> {
    /// The table of an interval, if there is one.
    #[inline(always)]
    pub(super) fn get(
        &self,
        interval: AngleInterval,
        make: impl FnOnce() -> Option<T>,
    ) -> Option<&T> {
        let tables = self.0[interval.halvings]
            .get_or_init(|| (0..interval.count()).map(|_| OnceLock::new()).collect());
        tables[interval.number]
            .get_or_init(|| make().map(Box::new))
            .as_deref()
    }
}

/// The tables of the slides of one hoop.
#[derive(Clone, Debug, Default)]
pub(in crate::engine) struct SlideTables([LazyGrid<SlideTable>; 4]);

/// An edge of the grid, and the coarsest interval that a slide may cross from it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) index: usize,
    pub(super) min_halvings: usize,
}

impl Edge {
    /// The intervals that begin there, the coarsest first.
    #[inline(always)]
    pub(super) fn intervals(self) -> impl Iterator<Item = AngleInterval> {
        (self.min_halvings..=HALVINGS)
            .filter_map(move |halvings| AngleInterval::at(self.index, halvings))
    }
}

/// A slide across one interval.
#[derive(Clone, Copy, Debug)]
pub(super) struct Crossing<'a> {
    pub(super) interval: AngleInterval,
    pub(super) table: &'a SlideTable,
    pub(super) u_centre: f64,
    pub(super) u_exit: f64,
}

/// Where a solution enters a table, and how far it is followed in it.
pub(super) struct Entrance<S> {
    pub(super) z: f64,
    end: f64,
    u_centre: f64,
    degree: usize,
    signs: S,
    /// Whether it leads to the end of the interval.
    pub(super) is_to_exit: bool,
}

impl SlideTables {
    /// The table of an interval for the direction `sigma` of slip in the frame of motion, if there
    /// is one. On a slope the mirrored frame has its own.
    pub(super) fn get(
        &self,
        law: &SlidingLaw,
        sigma: f64,
        interval: AngleInterval,
    ) -> Option<&SlideTable> {
        let which = usize::from(sigma > 0.0) + 2 * usize::from(law.body.tilt > 0.0);
        self.0[which].get(interval, || SlideTable::new(law, sigma, interval))
    }

    /// The crossing, by a slide with this u, of the coarsest interval from an edge that it crosses.
    pub(super) fn crossing(
        &self,
        law: &SlidingLaw,
        sigma: f64,
        edge: Edge,
        u: f64,
    ) -> Option<Crossing<'_>> {
        edge.intervals().find_map(|interval| {
            let table = self.get(law, sigma, interval)?;
            let u_centre = table.solutions.u_centre_from_entry(u)?;
            Some(Crossing {
                interval,
                table,
                u_centre,
                u_exit: table.solutions.exit(u_centre),
            })
        })
    }
}

fn max_size(series: &Series) -> f64 {
    series.iter().fold(0.0, |max, c| max.max(c.abs()))
}

/// The even degree at which two series may be truncated up to this t.
fn common_degree(p: &Series, h: &Series, t: f64) -> usize {
    let degree = |series: &Series| {
        let terms = scaled(*series, t);
        let min_size = CONVERGENCE * max_size(&terms);
        terms.iter().rposition(|c| c.abs() > min_size).unwrap_or(0)
    };
    degree(p).max(degree(h)).next_multiple_of(2)
}

impl SolutionTable {
    /// About an angle for an interval of the grid around it. None where the series do not reach over
    /// the interval.
    pub(super) fn new(
        equation: &LinearEquation,
        angle: Angle,
        interval: AngleInterval,
    ) -> Option<Self> {
        // p with the drive and p = 0 at the centre, h without it and h = 1.
        let [p, h] = equation.solutions([
            InitialValue { u: 0.0, drive: 1.0 },
            InitialValue { u: 1.0, drive: 0.0 },
        ]);
        // z at the end of the interval; u changes no more than the Gauss sum of the time allows up
        // to twice the angle.
        let [half, max_width] = [0.25, 0.5].map(|part| libm::tan(part * interval.width()));
        let size = max_size(&scaled(p, max_width));
        let width = convergence_radius(&p, 0, size)
            .min(convergence_radius(&h, 0, 1.0))
            .min(max_width);
        if width.is_nan() || width <= half {
            return None;
        }
        let [p, h] = [p, h].map(|series| scaled(series, width));
        let at = |t: f64| Linear {
            p: value(&p, t),
            h: value(&h, t),
        };
        let end = half / width;
        let radius = Span { start: -end, end }.ellipse_radius();
        let terms = |series: &Series| radius * sum_of_sizes(&series[1..], radius);
        let nodes = NODE.map(|node| at(end * node));
        let weight = |j: usize| {
            let z = half * NODE[j];
            2.0 * half * WEIGHT[j] / (1.0 + z * z)
        };
        Some(Self {
            angle,
            width,
            degree: common_degree(&p, &h, 1.0),
            interval_degree: common_degree(&p, &h, end),
            end,
            exit_angle: angle.plus(Angle::of_half_tangent(half)),
            entry: at(-end),
            exit: at(end),
            nodes: Nodes {
                p: nodes.map(|node| node.p),
                h: nodes.map(|node| node.h),
                weight: core::array::from_fn(weight),
            },
            terms: Linear {
                p: terms(&p),
                h: terms(&h),
            },
            p,
            h,
        })
    }

    /// A number a + b u on the table, as two parts in Bernstein form.
    pub(super) fn on_table(&self, form: &LinearForm) -> [TruncatedPolynomial; 2] {
        [(&self.p, 1.0), (&self.h, 0.0)].map(|(u, part_of_a)| {
            let sum = form.on(u, self.width, part_of_a);
            TruncatedPolynomial {
                low: bernstein(from_both_sides(sum.low)),
                ..sum
            }
        })
    }

    /// t at an angle.
    fn coordinate(&self, angle: Angle) -> f64 {
        let turned = angle.minus(self.angle);
        turned.sin / ((1.0 + turned.cos) * self.width)
    }

    /// u_c of a solution with this u at an angle on the table.
    pub(super) fn u_centre(&self, angle: Angle, u: f64) -> f64 {
        self.u_centre_at(self.coordinate(angle), self.degree, u)
    }

    /// The same at a coordinate up to which the series have this degree.
    fn u_centre_at(&self, t: f64, degree: usize, u: f64) -> f64 {
        let at = |series: &Series| value(&series[..=degree], t);
        (u - at(&self.p)) / at(&self.h)
    }

    /// u_c of a solution with this u at the beginning of the interval.
    pub(super) fn u_centre_of_entry(&self, u: f64) -> f64 {
        (u - self.entry.p) / self.entry.h
    }

    /// u at the end of the interval.
    pub(super) fn exit(&self, u_centre: f64) -> f64 {
        self.exit.at(u_centre)
    }

    /// u_c from u at the entry. None where u is not known to stay away from zero.
    pub(super) fn u_centre_from_entry(&self, u: f64) -> Option<f64> {
        let u_centre = self.u_centre_of_entry(u);
        self.is_zero_free(u_centre).then_some(u_centre)
    }

    /// Whether u of a solution stays away from zero on the interval by the sizes of its terms.
    fn is_zero_free(&self, u_centre: f64) -> bool {
        u_centre > 0.0 && self.terms.at(u_centre) <= RegularSegment::MAX_TERM_RATIO * u_centre
    }

    /// The time from the beginning of the interval to its end.
    #[inline(always)]
    pub(super) fn time(&self, u_centre: f64) -> f64 {
        let Nodes { p, h, weight } = &self.nodes;
        let mut sum = 0.0;
        for j in 0..NODES {
            sum += weight[j] / (p[j] + u_centre * h[j]).sqrt();
        }
        sum
    }

    /// u of a solution at a coordinate.
    #[cfg(test)]
    pub(super) fn u_at(&self, u_centre: f64, t: f64) -> f64 {
        value(&self.p, t) + u_centre * value(&self.h, t)
    }

    /// u of a solution in powers of t.
    #[inline(always)]
    fn u(&self, u_centre: f64) -> Series {
        core::array::from_fn(|k| self.p[k] + u_centre * self.h[k])
    }

    /// The way from a point to the end of the interval, or half as far, with its signs from u_c.
    /// None if the point lies elsewhere, where u is not known to stay away from zero, and where the
    /// signs are unknown.
    #[inline(always)]
    pub(super) fn enter<S: Signs>(
        &self,
        angle: Angle,
        u: f64,
        signs: impl FnOnce(f64) -> S,
    ) -> Option<Entrance<S>> {
        let z = self.coordinate(angle);
        if !(z >= -1.0 && z < self.end - MIN_LENGTH) {
            return None;
        }
        let is_on_interval = z >= -self.end;
        let degree = if is_on_interval {
            self.interval_degree
        } else {
            self.degree
        };
        let u_centre = self.u_centre_at(z, degree, u);
        let slope = self.p[1] + u_centre * self.h[1];
        let span = |end: f64| Span { start: z, end };
        // Most intervals that fail do so by the slope, which costs one product.
        let may_be_zero_free =
            |end: &f64| RegularSegment::may_be_zero_free(u_centre, slope, span(*end));
        let mut ends = [self.end, 0.5 * (z + self.end)].into_iter();
        ends.clone().find(may_be_zero_free)?;
        let signs = signs(u_centre);
        if signs.are_unknown() {
            return None;
        }
        // The ellipse about a part of the interval lies in the disc of the sizes of its terms.
        let is_known = is_on_interval && self.is_zero_free(u_centre);
        let is_zero_free = |end: &f64| {
            let by_terms = || {
                let u = self.u(u_centre);
                RegularSegment::is_zero_free(&u[..=degree], span(*end))
            };
            may_be_zero_free(end) && (is_known || by_terms())
        };
        let end = ends.find(is_zero_free)?;
        Some(Entrance {
            z,
            end,
            u_centre,
            degree,
            signs,
            is_to_exit: end == self.end,
        })
    }

    /// The segment behind an entrance, with what is kept for its end.
    #[inline(always)]
    pub(super) fn segment<S>(
        &self,
        entrance: Entrance<S>,
        exit: Option<SegmentExit>,
    ) -> RegularSegment<S> {
        RegularSegment {
            width: self.width,
            u: self.u(entrance.u_centre),
            degree: entrance.degree,
            signs: entrance.signs,
            angle: self.angle,
            end: entrance.end,
            known_time: None,
            exit,
        }
    }

    /// The whole interval, for a solution that crosses it in this time.
    #[inline(always)]
    pub(super) fn whole<S>(
        &self,
        u_centre: f64,
        time: f64,
        signs: S,
        exit: Option<SegmentExit>,
    ) -> RegularSegment<S> {
        RegularSegment {
            width: self.width,
            u: self.u(u_centre),
            degree: self.interval_degree,
            signs,
            angle: self.angle,
            end: self.end,
            known_time: Some(KnownTime {
                from: -self.end,
                time,
            }),
            exit,
        }
    }
}

impl SlideTable {
    /// The slides with the direction `sigma` of slip in the frame of motion. None where P is not
    /// known to be positive, and where the series do not reach over the interval.
    fn new(law: &SlidingLaw, sigma: f64, interval: AngleInterval) -> Option<Self> {
        let angle = interval.centre();
        let polynomials = SlidePolynomials::new(law, sigma, angle);
        let solutions = SolutionTable::new(&polynomials.equation, angle, interval)?;
        let min_p = min_value(from_both_sides(polynomials.p(solutions.width)));
        if min_p.is_nan() || min_p <= 0.0 {
            return None;
        }
        let [a, b] = solutions.on_table(&polynomials.slip_acceleration);
        let scale = a.size().max(b.size());
        let [positive, negative] =
            [1.0, -1.0].map(|sign| TruncatedPolynomial::positive(&a, &b, sign, scale));
        Some(Self {
            a,
            b,
            positive,
            negative,
            min_p,
            exit_coefficients: LocalCoefficients::new(law, solutions.exit_angle),
            solutions,
        })
    }

    pub(super) const fn exit_coefficients(&self) -> &LocalCoefficients {
        &self.exit_coefficients
    }

    /// The whole interval, for a slide that crosses it in this time, with these signs of η″.
    #[inline]
    pub(super) fn whole_interval(
        &self,
        u_centre: f64,
        time: f64,
        signs: SlipSigns,
    ) -> RegularSegment {
        let exit = Some(self.segment_exit(u_centre));
        self.solutions.whole(u_centre, time, signs, exit)
    }

    fn segment_exit(&self, u_centre: f64) -> SegmentExit {
        SegmentExit {
            u: self.solutions.exit(u_centre),
            coefficients: self.exit_coefficients,
        }
    }

    /// The way of a slide from a point to the end of the interval, or half as far. None if the point
    /// lies elsewhere, where u is not known to stay away from zero, and where η″ may change its sign
    /// twice.
    pub(super) fn enter(&self, point: &SlidePoint) -> Option<Entrance<SlipSigns>> {
        let signs = |u_centre| self.signs(u_centre);
        self.solutions.enter(point.angle, point.u, signs)
    }

    /// The segment behind an entrance.
    #[inline]
    pub(super) fn segment(&self, entrance: Entrance<SlipSigns>) -> RegularSegment {
        let is_to_exit = entrance.is_to_exit;
        let exit = is_to_exit.then(|| self.segment_exit(entrance.u_centre));
        self.solutions.segment(entrance, exit)
    }

    /// n³ P σ η″ of a slide in Bernstein form.
    pub(super) fn slip_acceleration(&self, u_centre: f64) -> TruncatedPolynomial {
        TruncatedPolynomial::of(&self.a, &self.b, u_centre)
    }

    /// The largest |η″| whose sign is not known where a sum leaves out so much.
    pub(super) fn sign_uncertainty(&self, remainder: f64) -> f64 {
        sign_uncertainty(remainder, self.min_p)
    }

    /// The signs of σ η″ of a slide on the table.
    #[inline(always)]
    pub(super) fn signs(&self, u_centre: f64) -> SlipSigns {
        let everywhere = |pattern| SlipSigns {
            pattern,
            sign_uncertainty: self.sign_uncertainty(self.a.remainder + u_centre * self.b.remainder),
        };
        if self.positive.contains(u_centre) {
            everywhere(SignPattern::Positive)
        } else if self.negative.contains(u_centre) {
            everywhere(SignPattern::Negative)
        } else {
            self.slip_acceleration(u_centre).slip_signs(self.min_p)
        }
    }

    /// A lower bound of σ η″ of a slide on the table, at most zero.
    pub(super) fn min_slip_acceleration(&self, u_centre: f64) -> f64 {
        let TruncatedPolynomial { low, remainder } = self.slip_acceleration(u_centre);
        (low.into_iter().fold(0.0, f64::min) - remainder) / self.min_p
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Body, Hoop, HoopParameters, SlipDirection};

    /// All tables of a hoop whose intervals are halved so often, with their laws and signs.
    fn tables(hoop: &Hoop, halvings: usize) -> Vec<(SlidingLaw, f64, AngleInterval, SlideTable)> {
        let Body::Heavy(body) = hoop.body() else {
            unreachable!("it has mass")
        };
        let laws = [SlipDirection::Negative, SlipDirection::Positive].map(|direction| {
            (
                SlidingLaw::of_body(body, hoop.mu_k(), direction),
                direction.sign(),
            )
        });
        laws.into_iter()
            .flat_map(|(law, sigma)| {
                (0..INTERVALS << halvings)
                    .map(move |number| AngleInterval { halvings, number })
                    .filter_map(move |interval| {
                        Some((
                            law,
                            sigma,
                            interval,
                            SlideTable::new(&law, sigma, interval)?,
                        ))
                    })
            })
            .collect()
    }

    /// Also of light hoops, and next to zeros of P, where p and h change most.
    #[test]
    fn u_is_positive_where_an_interval_is_crossed() {
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
            for (_, sigma, interval, table) in
                (0..=HALVINGS).flat_map(|halvings| tables(&hoop, halvings))
            {
                for exponent in -24..=24 {
                    let u = libm::pow(10.0, 0.25 * f64::from(exponent));
                    let Some(u_centre) = table.solutions.u_centre_from_entry(u) else {
                        continue;
                    };
                    let Nodes { p, h, .. } = &table.solutions.nodes;
                    let min_u = p
                        .iter()
                        .zip(h)
                        .map(|(p, h)| p + u_centre * h)
                        .fold(table.solutions.exit(u_centre), f64::min);
                    assert!(
                        min_u > 0.0,
                        "{mass_ratio} {inertia}: {sigma} {interval:?} {u}: {min_u}"
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
            let interval = |number| AngleInterval { halvings, number };
            let count = INTERVALS << halvings;
            for turns in [-3.0, 0.0, 7.0] {
                for number in 0..count {
                    let theta = TAU * (turns + (number as f64 + 0.8) / count as f64);
                    assert_eq!(
                        AngleInterval::about(theta, halvings),
                        [interval((number + 1) % count), interval(number)]
                    );
                }
            }
            assert_eq!(
                AngleInterval::about(0.0, halvings),
                [interval(0), interval(count - 1)]
            );
        }
    }

    /// n³ P σ η″ from the equations of motion, at angles all over a table, lies within the bound of
    /// what the sum leaves out. The bound adds sizes of coefficients that partly cancel, and is wider
    /// than it must be by that alone. u_c has either sign, and any size.
    #[test]
    fn slip_accelerations_lie_within_their_band_however_fast_a_slide_is() {
        let hoop = Hoop::equal_masses(0.5, 0.4).unwrap();
        for (law, sigma, interval, table) in tables(&hoop, 0) {
            for u_centre in [1e-3, 1.0, 30.0, 1e4, -1e4] {
                let TruncatedPolynomial { low, remainder } = table.slip_acceleration(u_centre);
                let (mut widest, mut size) = (0.0_f64, 0.0_f64);
                for k in 0..=80 {
                    let t = 0.025 * f64::from(k) - 1.0;
                    let z = table.solutions.width * t;
                    let Angle { sin, cos } = table.solutions.angle.plus(Angle::of_half_tangent(z));
                    let (alpha, beta) = law.slip_acceleration(sin, cos);
                    let u = value(&table.solutions.p, t) + u_centre * value(&table.solutions.h, t);
                    let factor = libm::pow(1.0 + z * z, 3.0) * law.p(sin, law.q(1.0, sin, cos));
                    let exact = factor * sigma * (alpha + beta * u);
                    // The value of a Bernstein form, by repeated means of its coefficients.
                    let (mut means, at) = (low, 0.5 * (1.0 + t));
                    for last in (1..means.len()).rev() {
                        for j in 0..last {
                            means[j] += at * (means[j + 1] - means[j]);
                        }
                    }
                    widest = widest.max((means[0] - exact).abs());
                    size = size.max(factor * (alpha.abs() + (beta * u).abs()));
                }
                let rounding = 64.0 * f64::EPSILON * size;
                assert!(
                    widest <= remainder + rounding && remainder <= 1e4 * (widest + rounding),
                    "{interval:?} {u_centre}: {widest:e} {remainder:e} {rounding:e}"
                );
            }
        }
    }

    /// The sign that two comparisons of u_c give is the one that the coefficients of the slide give.
    #[test]
    fn signs_are_those_of_the_coefficients() {
        let mut told = 0;
        for (mass_ratio, mu) in [(1.0, 0.4), (1.0, 1e-3), (0.2, 1.4)] {
            let hoop = HoopParameters::thin(mass_ratio).with_friction(mu, mu);
            let hoop = Hoop::new(hoop).unwrap();
            for (.., table) in (0..=2).flat_map(|halvings| tables(&hoop, halvings)) {
                for exponent in -60..=60 {
                    let u_centre = libm::pow(10.0, 0.1 * f64::from(exponent));
                    let signs = table.signs(u_centre);
                    let expected = table.slip_acceleration(u_centre).slip_signs(table.min_p);
                    assert_eq!(signs, expected, "{mass_ratio} {mu} {u_centre}");
                    let is_told = |range: OrbitRange| range.contains(u_centre);
                    told += u32::from(is_told(table.positive) || is_told(table.negative));
                }
            }
        }
        assert!(told > 10_000, "{told}");
    }

    /// Where η″ rises through zero it is nowhere less than the bound.
    #[test]
    fn slip_accelerations_are_no_less_than_their_bound() {
        let hoop = Hoop::equal_masses(0.5, 0.4).unwrap();
        let mut falls = 0;
        for (law, sigma, interval, table) in tables(&hoop, 0) {
            for u_centre in [0.5, 1.0, 1.5, 2.0, 3.0, 5.0] {
                let bound = table.min_slip_acceleration(u_centre);
                let values = (-20..=20).map(|k| {
                    let t = 0.05 * f64::from(k);
                    let Angle { sin, cos } = table
                        .solutions
                        .angle
                        .plus(Angle::of_half_tangent(table.solutions.width * t));
                    let (alpha, beta) = law.slip_acceleration(sin, cos);
                    sigma
                        * (alpha
                            + beta
                                * (value(&table.solutions.p, t)
                                    + u_centre * value(&table.solutions.h, t)))
                });
                let lowest = values.fold(0.0, f64::min);
                assert!(lowest >= bound, "{interval:?} {u_centre}: {lowest} {bound}");
                falls += u32::from(lowest < 0.0);
            }
        }
        assert!(falls > 30, "{falls}");
    }
}
