//! Curves as points: dense where they bend, cut where they leave the window, every point on the
//! curve itself; and the curves of the (θ, θ′) plane of rolling.

use core::f64::consts::{PI, TAU};

use crate::mechanics::ContactForces;
use crate::mechanics::closed_form::slip_angle;
use crate::mechanics::region::PhasePlane;
use crate::model::{Body, RotationDirection, SlipDirection};

/// A part of a plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Window {
    /// From left to right.
    pub x: [f64; 2],
    /// From below upwards.
    pub y: [f64; 2],
}

type Point = [f64; 2];
type Curve<'a> = &'a dyn Fn(f64) -> Option<Point>;

/// Largest distance of a chord from its curve, in parts of the window.
const FLAT: f64 = 1.5e-4;
const DEPTH: u32 = 12;

impl Window {
    fn holds(&self, [x, y]: Point) -> bool {
        (self.x[0]..=self.x[1]).contains(&x) && (self.y[0]..=self.y[1]).contains(&y)
    }

    /// The pieces of a curve in the window, from samples in `cells` intervals of its parameter:
    /// dense where it bends, cut where it leaves the window. Each point is one of the curve. A
    /// piece that lies between two samples is not seen.
    pub fn pieces(&self, [from, to]: [f64; 2], cells: u32, curve: Curve<'_>) -> Vec<Vec<Point>> {
        let seen = |s: f64| curve(s).filter(|point| self.holds(*point));
        let mut pieces: Vec<Vec<Point>> = Vec::new();
        let mut open = false;
        let mut last = from;
        for i in 0..=cells {
            let s = if i == cells {
                to
            } else {
                from + (to - from) * f64::from(i) / f64::from(cells)
            };
            let here = seen(s);
            if i > 0 {
                match (seen(last), here) {
                    (Some(p), Some(q)) => {
                        self.refine(&mut pieces, &mut open, curve, [last, s], [p, q]);
                    }
                    (Some(p), None) => {
                        let (edge, q) = border(last, s, p, &seen);
                        self.refine(&mut pieces, &mut open, curve, [last, edge], [p, q]);
                        open = false;
                    }
                    (None, Some(q)) => {
                        let (edge, p) = border(s, last, q, &seen);
                        self.refine(&mut pieces, &mut open, curve, [edge, s], [p, q]);
                    }
                    (None, None) => {}
                }
            }
            last = s;
        }
        pieces.iter().map(|piece| self.thinned(piece)).collect()
    }

    /// The same piece without the points that lie on the chords between the others.
    fn thinned(&self, piece: &[Point]) -> Vec<Point> {
        let mut kept: Vec<Point> = piece.first().copied().into_iter().collect();
        let mut from = 0;
        for to in 2..piece.len() {
            if (from + 1..to).any(|i| self.sagitta(piece[from], piece[i], piece[to]) > FLAT) {
                from = to - 1;
                kept.push(piece[from]);
            }
        }
        kept.extend(piece.get(1..).and_then(<[Point]>::last));
        kept
    }

    fn refine(
        &self,
        pieces: &mut Vec<Vec<Point>>,
        open: &mut bool,
        curve: Curve<'_>,
        ends: [f64; 2],
        points: [Point; 2],
    ) {
        if !*open {
            pieces.push(vec![points[0]]);
            *open = true;
        }
        if let Some(piece) = pieces.last_mut() {
            self.halve(piece, curve, ends, points, DEPTH);
        }
    }

    fn halve(
        &self,
        piece: &mut Vec<Point>,
        curve: Curve<'_>,
        [a, b]: [f64; 2],
        [p, q]: [Point; 2],
        depth: u32,
    ) {
        let middle = 0.5 * (a + b);
        match curve(middle).filter(|point| self.holds(*point)) {
            Some(m) if depth > 0 && self.sagitta(p, m, q) > FLAT => {
                self.halve(piece, curve, [a, middle], [p, m], depth - 1);
                self.halve(piece, curve, [middle, b], [m, q], depth - 1);
            }
            _ => piece.push(q),
        }
    }

    /// Distance of a point from a chord, in parts of the window.
    fn sagitta(&self, p: Point, m: Point, q: Point) -> f64 {
        let scale = |d: f64, side: [f64; 2]| d / (side[1] - side[0]);
        let (ax, ay) = (scale(q[0] - p[0], self.x), scale(q[1] - p[1], self.y));
        let (bx, by) = (scale(m[0] - p[0], self.x), scale(m[1] - p[1], self.y));
        let length = (ax * ax + ay * ay).sqrt();
        if length == 0.0 {
            (bx * bx + by * by).sqrt()
        } else {
            (ax * by - ay * bx).abs() / length
        }
    }
}

/// The last visible place between a visible one and one that is not.
fn border(
    mut seen_at: f64,
    mut unseen_at: f64,
    mut point: Point,
    seen: &dyn Fn(f64) -> Option<Point>,
) -> (f64, Point) {
    loop {
        let middle = 0.5 * (seen_at + unseen_at);
        if middle == seen_at || middle == unseen_at {
            return (seen_at, point);
        }
        match seen(middle) {
            Some(there) => (seen_at, point) = (middle, there),
            None => unseen_at = middle,
        }
    }
}

const CELLS: u32 = 480;

/// Curves in a window, in pieces.
impl PhasePlane {
    /// The graphs ±rate(θ).
    fn graph(&self, window: &Window, rate: &dyn Fn(f64) -> Option<f64>) -> Vec<Vec<Point>> {
        self.graphs(window, &|theta, _| rate(theta))
    }

    /// The graphs ±rate(θ) of a rate that depends on the direction.
    fn graphs(
        &self,
        window: &Window,
        rate: &dyn Fn(f64, RotationDirection) -> Option<f64>,
    ) -> Vec<Vec<Point>> {
        // Where D = 0, at θ = ±π without inertia, nothing is defined.
        let directions = [RotationDirection::Positive, RotationDirection::Negative];
        let pieces = |rotation| self.graph_of(window, rotation, &|theta| rate(theta, rotation));
        directions.into_iter().flat_map(pieces).collect()
    }

    /// The part of it with one sign of θ′.
    fn graph_of(
        &self,
        window: &Window,
        rotation: RotationDirection,
        rate: &dyn Fn(f64) -> Option<f64>,
    ) -> Vec<Vec<Point>> {
        let inside = |theta: f64| self.law.denominator(theta) > 1e-12;
        let curve = |theta: f64| {
            let rate = rate(theta).filter(|_| inside(theta))?;
            Some([theta, rotation.sign() * rate])
        };
        window.pieces(window.x, CELLS, &curve)
    }

    /// The angles of all turns in a window that are one of these in one turn.
    fn turned(window: &Window, angles: &[f64]) -> Vec<f64> {
        let [from, to] = window.x;
        let turns = (libm::floor(from / TAU) as i32 - 1)..=(libm::ceil(to / TAU) as i32 + 1);
        let mut found: Vec<f64> = turns
            .flat_map(|turn| {
                angles
                    .iter()
                    .map(move |angle| angle + TAU * f64::from(turn))
            })
            .filter(|angle| (from..=to).contains(angle))
            .collect();
        found.sort_by(f64::total_cmp);
        found.dedup_by(|a, b| (*a - *b).abs() < 1e-12);
        found
    }

    /// The angles at which the curve f is a vertical for rolling one way.
    fn slip_angles(&self, rotation: RotationDirection) -> Vec<f64> {
        match self.hoop.body() {
            Body::Heavy(_) if self.hoop.mu_s() == 0.0 && self.is_even() => vec![0.0, PI],
            Body::Heavy(_) => Vec::new(),
            Body::Massless(_) if !self.is_even() => self.resisted_slip_angles(rotation),
            Body::Massless(body) => {
                let limit = slip_angle(&body, self.hoop.mu_s());
                let angles = limit.map(|limit| {
                    // Inside the rim the demand falls again towards the bottom, where it is zero.
                    let again = PI + 2.0 * libm::atan(self.hoop.mu_s()) - limit;
                    if body.offset < 1.0 {
                        vec![-limit, limit, -again, again]
                    } else {
                        vec![-limit, limit]
                    }
                });
                angles.unwrap_or_default()
            }
        }
    }

    /// The rates |θ′| between which rolling one way presses on the plane, N ≥ 0.
    fn pressing(&self, theta: f64, rotation: RotationDirection) -> Option<[f64; 2]> {
        let [constant, slope] = self.line(theta, rotation)?;
        let root = self.normal_force_rate_of(theta, rotation);
        match (constant.normal >= 0.0, root) {
            (true, Some(root)) if slope.normal < 0.0 => Some([0.0, root]),
            (true, _) => Some([0.0, f64::INFINITY]),
            (false, root) => root.map(|root| [root, f64::INFINITY]),
        }
    }

    /// The curve f, |F| = μs N in rolling. Of a massless hoop, and without friction, it has
    /// verticals: the angle alone decides.
    pub fn slip_curve(&self, window: &Window) -> Vec<Vec<Point>> {
        let vertical = |at: f64, ends: [f64; 2]| {
            let ends = [window.y[0].max(ends[0]), window.y[1].min(ends[1])];
            (ends[0] < ends[1]).then(|| ends.map(|rate| [at, rate]).to_vec())
        };
        let directions = [RotationDirection::Positive, RotationDirection::Negative];
        let mut verticals = Vec::new();
        for rotation in directions {
            for at in Self::turned(window, &self.slip_angles(rotation)) {
                let Some([low, high]) = self.pressing(at, rotation) else {
                    continue;
                };
                verticals.extend(match rotation {
                    // One line, where it is the same both ways.
                    RotationDirection::Positive if self.is_even() && low == 0.0 => {
                        vertical(at, [-high, high])
                    }
                    RotationDirection::Negative if self.is_even() && low == 0.0 => None,
                    RotationDirection::Positive => vertical(at, [low, high]),
                    RotationDirection::Negative => vertical(at, [-high, -low]),
                });
            }
        }
        let branches = [SlipDirection::Positive, SlipDirection::Negative].into_iter();
        // Without friction both are one.
        let count = if self.hoop.mu_s() == 0.0 && !self.is_even() {
            1
        } else {
            2
        };
        let branches = branches.take(count).flat_map(|direction| {
            self.graphs(window, &|theta, rotation| {
                self.slip_rate_of(theta, direction, rotation)
            })
        });
        branches.chain(verticals).collect()
    }

    /// The curve n, N = 0 in rolling.
    pub fn normal_force_curve(&self, window: &Window) -> Vec<Vec<Point>> {
        let is_rim = matches!(self.hoop.body(), Body::Massless(body) if body.offset == 1.0)
            && self.hoop.slope() == 0.0;
        // N = cos²(θ/2) (1 − θ′²) (3.8), with rolling resistance over Dχ.
        if is_rim && self.is_even() {
            let lines = [1.0, -1.0]
                .into_iter()
                .filter(|rate| (window.y[0]..=window.y[1]).contains(rate));
            return lines
                .map(|rate| window.x.map(|theta| [theta, rate]).to_vec())
                .collect();
        }
        self.graphs(window, &|theta, rotation| {
            let rate = self.normal_force_rate_of(theta, rotation);
            if is_rim {
                self.line(theta, rotation).map(|_| 1.0)
            } else {
                rate
            }
        })
    }

    /// The curve h cos θ θ′² = cos α beyond which the body leaves the plane; a massless hoop never
    /// does.
    pub fn lift_off_curve(&self, window: &Window) -> Vec<Vec<Point>> {
        match self.hoop.body() {
            Body::Heavy(_) => self.graph(window, &|theta| self.lift_off_rate(theta)),
            Body::Massless(_) => Vec::new(),
        }
    }

    /// The rates between which bounces grow out of rolling; empty on a level plane.
    pub fn reverse_chatter_curve(&self, window: &Window) -> Vec<Vec<Point>> {
        let edge = |end: usize| {
            let part = |rotation| {
                let rates = |theta: f64| self.reverse_chatter_rates(theta, rotation);
                let rate = |theta: f64| rates(theta).map(|rates| rates[end]);
                self.graph_of(window, rotation, &|theta| {
                    rate(theta).filter(|rate| *rate > 0.0)
                })
            };
            let directions = [RotationDirection::Positive, RotationDirection::Negative];
            directions.map(part).concat()
        };
        [edge(0), edge(1)].concat()
    }

    /// The separatrix through the unstable equilibrium; without inertia its stable and unstable
    /// manifold.
    pub fn separatrix_curve(&self, window: &Window) -> Vec<Vec<Point>> {
        if !self.is_even() {
            return self.resisted_separatrices(window);
        }
        if self.hoop.slope() != 0.0 {
            return self.graph(window, &|theta| {
                Some(self.separatrix_rate(theta)).filter(|rate| *rate > 0.0)
            });
        }
        self.level_curve(self.law.separatrix_energy(), window)
    }

    /// The orbits of an energy E, ½ D(θ) θ′² + ℓ̂ cos θ = E.
    pub fn level_curve(&self, energy: f64, window: &Window) -> Vec<Vec<Point>> {
        if !self.is_even() {
            return Vec::new();
        }
        let offset = self.hoop.offset();
        if energy >= offset || self.hoop.slope() != 0.0 {
            return self.graph(window, &|theta| self.level_rate(theta, energy));
        }
        if matches!(self.hoop.body(), Body::Massless(body) if body.offset == 1.0) {
            // It turns once and runs out to θ = ±π: a function of the rate.
            let orbit = |side: f64| {
                window.pieces(window.y, CELLS, &|rate| {
                    let square = rate * rate;
                    let cos = (energy - 0.5 * (1.0 + offset * offset) * square)
                        / (offset * (1.0 + square));
                    (cos.abs() <= 1.0).then(|| [side * libm::acos(cos), rate])
                })
            };
            return [1.0, -1.0].into_iter().flat_map(orbit).collect();
        }
        // Libration: θ = π + a sin s, so that θ′, which vanishes with cos s, is smooth.
        let swing = libm::acos(-energy / offset);
        let first = libm::floor((window.x[0] - swing) / TAU);
        let count = libm::ceil((window.x[1] - window.x[0]) / TAU) as u32 + 2;
        (0..count)
            .flat_map(|turn| {
                let centre = PI + TAU * (first + f64::from(turn));
                window.pieces([-0.5 * PI, 1.5 * PI], CELLS, &|s| {
                    let (sin, cos) = libm::sincos(s);
                    let theta = centre + swing * sin;
                    let rate = self.level_rate(theta, energy).unwrap_or(0.0);
                    Some([theta, if cos < 0.0 { -rate } else { rate }])
                })
            })
            .collect()
    }

    /// The orbit of rolling through a place: of its energy, or, with rolling resistance, from the
    /// turning point before to the second one after it, or to rest.
    pub fn orbit(&self, theta: f64, theta_rate: f64, window: &Window) -> Vec<Vec<Point>> {
        if self.is_even() {
            let energy = self.law.energy(theta, theta_rate / self.pace);
            return self.level_curve(self.pace * self.pace * energy, window);
        }
        self.resisted_orbit(theta, theta_rate, window)
    }

    /// Orbits that fill a window, as pieces of all: those from rest at so many angles of each turn,
    /// and so many that pass a top by equal steps of the rate.
    pub fn orbits(&self, window: &Window, from_rest: u32, over_top: u32) -> Vec<Vec<Point>> {
        let angles = (1..=from_rest).map(|i| PI * f64::from(i) / f64::from(from_rest + 1));
        let rates =
            (1..=over_top).map(|i| window.y[1] * (f64::from(i) - 0.35) / f64::from(over_top));
        if self.is_even() {
            let places = angles
                .map(|theta| [theta, 0.0])
                .chain(rates.map(|rate| [0.0, rate]));
            return places
                .flat_map(|[theta, rate]| self.orbit(theta, rate, window))
                .collect();
        }
        // An orbit may come in from the turns beside the window.
        let [from, to] = [window.x[0] - TAU, window.x[1] + TAU];
        let starts: Vec<f64> = angles.flat_map(|theta| [theta, -theta]).collect();
        let wide = Window {
            x: [from, to],
            ..*window
        };
        let at_rest = Self::turned(&wide, &starts)
            .into_iter()
            .map(|theta| [theta, 0.0]);
        let first = TAU * libm::ceil(window.x[0] / TAU);
        let last = TAU * libm::floor(window.x[1] / TAU);
        let passing = rates.flat_map(|rate| [[first, rate], [last, -rate]]);
        at_rest
            .chain(passing)
            .flat_map(|[theta, rate]| self.resisted_orbit(theta, rate, window))
            .collect()
    }

    /// N and F of a hoop that rolls one way, at the rates 0 and 1.
    fn forces_of(&self, theta: f64, rotation: RotationDirection) -> Option<[ContactForces; 2]> {
        if self.is_even() {
            return Some([self.forces(theta, 0.0), self.forces(theta, 1.0)]);
        }
        let weight = self.pace * self.pace;
        let [constant, slope] = self.line(theta, rotation)?;
        let at = |u: f64| ContactForces {
            normal: weight * constant.normal + u * slope.normal,
            friction: weight * constant.friction + u * slope.friction,
        };
        Some([at(0.0), at(1.0)])
    }

    /// The rates |θ′| between which static friction holds a hoop that rolls one way at an angle, at
    /// most `most`.
    fn holding(&self, theta: f64, rotation: RotationDirection, most: f64) -> Option<[f64; 2]> {
        if let Body::Massless(body) = self.hoop.body() {
            if !self.is_even() {
                return self.massless_holding(theta, rotation, most);
            }
            let holds = if body.offset < 1.0 {
                self.forces(theta, 0.0).demand() <= self.hoop.mu_s()
            } else {
                // N and F vanish together, at one rate: the angle alone decides.
                let turned = theta - TAU * libm::round(theta / TAU);
                slip_angle(&body, self.hoop.mu_s()).is_none_or(|limit| turned.abs() <= limit)
            };
            let end = self.normal_force_rate_of(theta, rotation);
            // Inside the rim N may grow with the rate, towards the bottom.
            let end = if body.offset < 1.0 {
                Some(end.unwrap_or(most))
            } else {
                end
            };
            return end.filter(|_| holds).map(|rate| [0.0, rate.min(most)]);
        }
        let [at_rest, at_one] = self.forces_of(theta, rotation)?;
        let (mut low, mut high) = (0.0, most * most);
        // μs N ± F ≥ 0 and N ≥ 0, each linear in θ′².
        for (share, normal) in [
            (1.0, self.hoop.mu_s()),
            (-1.0, self.hoop.mu_s()),
            (0.0, 1.0),
        ] {
            let constant = normal * at_rest.normal + share * at_rest.friction;
            let slope = normal * at_one.normal + share * at_one.friction - constant;
            let root = -constant / slope;
            if slope < 0.0 {
                high = f64::min(high, root);
            } else if slope > 0.0 {
                low = f64::max(low, root);
            } else if constant < 0.0 {
                return None;
            }
        }
        (low <= high).then(|| [low.sqrt(), high.sqrt()])
    }

    /// The same of a massless hoop with rolling resistance, whose F/N does not depend on the rate.
    fn massless_holding(
        &self,
        theta: f64,
        rotation: RotationDirection,
        most: f64,
    ) -> Option<[f64; 2]> {
        let [ContactForces { normal, friction }, _] = self.line(theta, rotation)?;
        let [low, high] = self.pressing(theta, rotation)?;
        let holds = friction.abs() <= self.hoop.mu_s() * normal.abs();
        (holds && low < most).then(|| [low, high.min(most)])
    }

    /// The region 𝓡 of (2.14) as polygons, in a window that reaches as far down as up.
    pub fn rolling_region(&self, window: &Window) -> Vec<Vec<Point>> {
        let most = window.y[1];
        let directions = [RotationDirection::Positive, RotationDirection::Negative];
        // Without resistance one way is the mirror image of the other.
        let count = if self.is_even() { 1 } else { 2 };
        let mut pieces = Vec::new();
        for rotation in directions.into_iter().take(count) {
            let rates = |theta: f64| self.holding(theta, rotation, most);
            let top = |theta: f64| rates(theta).map(|[_, high]| [theta, high]);
            for upper in window.pieces(window.x, CELLS, &top) {
                // The lower edge bends where the upper one may be straight.
                let ends =
                    [upper.first(), upper.last()].map(|end| end.map_or(0.0, |[theta, _]| *theta));
                let bottom = |theta: f64| Some([theta, rates(theta)?[0]]);
                let mut lower = window.pieces(ends, CELLS, &bottom).concat();
                lower.reverse();
                let mirrored =
                    |points: &[Point]| points.iter().map(|[x, y]| [*x, -y]).collect::<Vec<_>>();
                if !self.is_even() {
                    let whole = [upper, lower].concat();
                    pieces.push(match rotation {
                        RotationDirection::Positive => whole,
                        RotationDirection::Negative => mirrored(&whole),
                    });
                } else if lower.iter().all(|[_, low]| *low == 0.0) {
                    let mut below = mirrored(&upper);
                    below.reverse();
                    pieces.push([upper, below].concat());
                } else {
                    let above = [upper, lower].concat();
                    pieces.push(mirrored(&above));
                    pieces.push(above);
                }
            }
        }
        pieces
    }
}
