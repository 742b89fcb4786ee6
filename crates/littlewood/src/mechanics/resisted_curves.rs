//! The (θ, θ′) plane of rolling with rolling resistance: the band of rest, and orbits.
//!
//! With v = Dχ u, ς = sign(θ′), a = h sin θ and d = 1 + h cos θ, rolling one way is
//!
//! ```text
//! dv/dθ = 2m (a − ς χ + d tan α) + ς χ ℓ̂ cos θ u,
//! ```
//!
//! which is the energy without resistance. Of all sums in this file the pictures see four digits.

use core::f64::consts::{FRAC_PI_2, PI, TAU};

use crate::math::trig::Angle;
use crate::mechanics::curves::Window;
use crate::mechanics::region::PhasePlane;
use crate::mechanics::{HeldLaw, ResistedRollingLaw};
use crate::model::{Body, RotationDirection};

/// Steps of a turn: the error of one is less than 1e-10 of what v changes.
const STEPS: f64 = 720.0;

/// Intervals in which it is seen.
const CELLS: u32 = 240;

/// Half swings after the one that passes a place, of an orbit.
const SWINGS: u32 = 1;

/// A smaller part of D(0) is the pole of a paradox, which no orbit passes.
const POLE: f64 = 1e-9;

impl ResistedRollingLaw {
    /// Whether Dχ > 0, so that pressing opens the gap, and this is no pole.
    pub(super) fn presses(&self, angle: Angle) -> bool {
        self.denominator_of(angle) > POLE * self.rolling.top
    }
}

/// v = Dχ u at an angle, and its slope.
#[derive(Clone, Copy, Debug)]
struct Node {
    theta: f64,
    v: f64,
    slope: f64,
}

/// Rolling one way: nodes from left to right between two ends, each a turning point or an edge.
struct Course {
    law: ResistedRollingLaw,
    nodes: Vec<Node>,
}

/// v between two nodes, by the cubic of their values and slopes.
fn between(from: Node, to: Node, theta: f64) -> f64 {
    let length = to.theta - from.theta;
    if length == 0.0 {
        return from.v;
    }
    let (s, t) = ((theta - from.theta) / length, (to.theta - theta) / length);
    let ends = t * t * (1.0 + 2.0 * s) * from.v + s * s * (1.0 + 2.0 * t) * to.v;
    ends + length * s * t * (t * from.slope - s * to.slope)
}

/// Where v vanishes after a node with v ≥ 0 and before one with v < 0.
fn turning_point(from: Node, to: Node) -> f64 {
    let (mut inside, mut outside) = (from.theta, to.theta);
    loop {
        let middle = 0.5 * (inside + outside);
        if middle == inside || middle == outside {
            return inside;
        }
        if between(from, to, middle) >= 0.0 {
            inside = middle;
        } else {
            outside = middle;
        }
    }
}

impl Course {
    /// Dχ, where it is no pole.
    fn denominator(&self, theta: f64) -> Option<f64> {
        let angle = Angle::of(theta);
        let is_there = self.law.presses(angle);
        is_there.then(|| self.law.denominator_of(angle))
    }

    /// dv/dθ; none beyond a pole.
    fn slope(&self, theta: f64, v: f64) -> Option<f64> {
        let Angle { cos, sin } = Angle::of(theta);
        let drive = self.law.driving_moment(1.0, cos, sin, 0.0);
        let press = self.law.resistance * self.law.rolling.offset * cos;
        Some(2.0 * drive + press * v / self.denominator(theta)?)
    }

    fn node(&self, theta: f64, v: f64) -> Option<Node> {
        Some(Node {
            theta,
            v,
            slope: self.slope(theta, v)?,
        })
    }

    /// The node a step later, of Runge and Kutta.
    fn step(&self, from: Node, step: f64) -> Option<Node> {
        let middle = from.theta + 0.5 * step;
        let first = self.slope(middle, from.v + 0.5 * step * from.slope)?;
        let second = self.slope(middle, from.v + 0.5 * step * first)?;
        let third = self.slope(from.theta + step, from.v + step * second)?;
        let mean = (from.slope + 2.0 * (first + second) + third) / 6.0;
        self.node(from.theta + step, from.v + step * mean)
    }

    /// Follows it from its last node to an edge, or to where the hoop turns back.
    fn follow(&mut self, edge: f64) {
        let Some(mut last) = self.nodes.last().copied() else {
            return;
        };
        let count = libm::ceil((edge - last.theta).abs() * STEPS / TAU);
        let step = (edge - last.theta) / count;
        for _ in 0..count as u32 {
            let Some(next) = self.step(last, step) else {
                return;
            };
            if next.v < 0.0 {
                let end = turning_point(last, next);
                self.nodes.extend(self.node(end, 0.0));
                return;
            }
            self.nodes.push(next);
            last = next;
        }
    }

    /// Angles of its ends.
    fn ends(&self) -> [f64; 2] {
        [self.nodes.first(), self.nodes.last()].map(|node| node.map_or(0.0, |node| node.theta))
    }

    /// θ′² at an angle between the ends.
    fn u(&self, theta: f64) -> Option<f64> {
        let at = self.nodes.partition_point(|node| node.theta < theta);
        let to = *self.nodes.get(at)?;
        let from = self.nodes.get(at.wrapping_sub(1)).copied().unwrap_or(to);
        Some(f64::max(between(from, to, theta), 0.0) / self.denominator(theta)?)
    }
}

/// A place in the plane, and the way in which a hoop there turns.
#[derive(Clone, Copy, Debug)]
struct Passing {
    theta: f64,
    theta_rate: f64,
    rotation: RotationDirection,
}

impl PhasePlane {
    /// Rolling one way.
    pub(super) fn resisted_law(&self, rotation: RotationDirection) -> ResistedRollingLaw {
        let resistance = rotation.sign() * self.hoop.rolling_resistance();
        ResistedRollingLaw::of_body(&self.hoop.rigid_body(), resistance)
    }

    /// The angles of a window at which rolling resistance holds a hoop at rest, as intervals.
    pub fn band_of_rest(&self, window: &Window) -> Vec<[f64; 2]> {
        let (slope, resistance) = (self.hoop.slope(), self.hoop.rolling_resistance());
        let (tilt, h) = (libm::tan(slope), self.hoop.h());
        let [from, to] = window.x;
        if resistance == 0.0 || tilt.abs() > self.hoop.mu_s() {
            return Vec::new();
        }
        // |h sin(θ + α) + sin α| ≤ χ cos α.
        let pull = libm::sin(slope);
        let most = resistance * libm::cos(slope);
        let [low, high] = [-most - pull, most - pull];
        if low > h || high < -h {
            return Vec::new();
        }
        let (starts, ends) = (low > -h, high < h);
        let angle = |arm: f64| libm::asin(arm / h);
        // From the first angle on, one interval about the top and one about the bottom, or one.
        let intervals = match (starts, ends) {
            (false, false) => return vec![[from, to]],
            (true, true) => vec![
                [angle(low), angle(high)],
                [PI - angle(high), PI - angle(low)],
            ],
            (true, false) => vec![[angle(low), PI - angle(low)]],
            (false, true) => vec![[PI - angle(high), TAU + angle(high)]],
        };
        let turns = libm::floor((from + slope) / TAU) as i32 - 1
            ..=libm::ceil((to + slope) / TAU) as i32 + 1;
        let turned = turns.flat_map(|turn| {
            let shift = TAU * f64::from(turn) - slope;
            intervals
                .iter()
                .map(move |ends| ends.map(|end| end + shift))
        });
        turned
            .map(|[low, high]| [low.max(from), high.min(to)])
            .filter(|[low, high]| low < high)
            .collect()
    }

    /// Which way a hoop without slip turns, or begins to turn; none where resistance holds it.
    fn way(&self, theta: f64, theta_rate: f64) -> Option<RotationDirection> {
        let pull = -HeldLaw {
            body: self.hoop.rigid_body(),
            friction: 0.0,
        }
        .arm_of_rest(Angle::of(theta));
        let turns = if theta_rate != 0.0 {
            theta_rate
        } else if pull.abs() > self.hoop.rolling_resistance() {
            pull
        } else {
            0.0
        };
        RotationDirection::of_sign(turns)
    }

    /// Rolling one way through a place: from the turning point before, if `is_whole`, to the next.
    fn course(&self, at: Passing, window: &Window, is_whole: bool) -> Option<Course> {
        let rate = at.theta_rate / self.pace;
        let mut course = Course {
            law: self.resisted_law(at.rotation),
            nodes: Vec::new(),
        };
        let v = course.denominator(at.theta)? * rate * rate;
        let first = course.node(at.theta, v)?;
        // It may leave the window and come back.
        let [left, right] = [
            f64::min(window.x[0], at.theta) - TAU,
            f64::max(window.x[1], at.theta) + TAU,
        ];
        let (ahead, behind) = match at.rotation {
            RotationDirection::Positive => (right, left),
            RotationDirection::Negative => (left, right),
        };
        course.nodes.push(first);
        if is_whole {
            course.follow(behind);
            course.nodes.reverse();
        }
        course.follow(ahead);
        if at.rotation == RotationDirection::Negative {
            course.nodes.reverse();
        }
        Some(course)
    }

    /// The pieces of a course between two angles that are seen.
    fn pieces_of(&self, course: &Course, ends: [f64; 2], window: &Window) -> Vec<Vec<[f64; 2]>> {
        let [first, last] = ends;
        let (middle, half) = (0.5 * (first + last), 0.5 * (last - first));
        let way = course.law.resistance.signum();
        // The square root of u is smooth at a turning point.
        let curve = |s: f64| {
            let theta = (middle + half * libm::sin(s)).clamp(first, last);
            Some([theta, way * self.pace * course.u(theta)?.sqrt()])
        };
        window.pieces([-FRAC_PI_2, FRAC_PI_2], CELLS, &curve)
    }

    /// The orbit of rolling through a place, with rolling resistance: from the turning point before
    /// to the second one after it, or to rest.
    pub(super) fn resisted_orbit(
        &self,
        theta: f64,
        theta_rate: f64,
        window: &Window,
    ) -> Vec<Vec<[f64; 2]>> {
        let mut pieces = Vec::new();
        let mut at = [theta, theta_rate];
        for swing in 0..=SWINGS {
            let [theta, theta_rate] = at;
            let Some(rotation) = self.way(theta, theta_rate) else {
                break;
            };
            let passing = Passing {
                theta,
                theta_rate,
                rotation,
            };
            let Some(course) = self.course(passing, window, swing == 0) else {
                break;
            };
            pieces.extend(self.pieces_of(&course, course.ends(), window));
            let end = match rotation {
                RotationDirection::Positive => course.nodes.last(),
                RotationDirection::Negative => course.nodes.first(),
            };
            match end {
                Some(node) if node.v == 0.0 && node.theta != theta => at = [node.theta, 0.0],
                _ => break,
            }
        }
        pieces
    }

    /// The orbits that come to the edge of an upper band of rest, from which they would also leave:
    /// one each way about each top.
    pub(super) fn resisted_separatrices(&self, window: &Window) -> Vec<Vec<[f64; 2]>> {
        let (slope, h) = (self.hoop.slope(), self.hoop.h());
        // They may come in from the turns beside the window.
        let [from, to] = [window.x[0] - TAU, window.x[1] + TAU];
        let mut pieces = Vec::new();
        for rotation in RotationDirection::ALL {
            // h sin(θ + α) + sin α = ς χ cos α, where it grows.
            let held = rotation.sign() * self.hoop.rolling_resistance() * libm::cos(slope);
            let arm = (held - libm::sin(slope)) / h;
            if arm.abs() >= 1.0 {
                continue;
            }
            let saddle = libm::asin(arm) - slope;
            let turns =
                libm::floor((from - saddle) / TAU) as i32..=libm::ceil((to - saddle) / TAU) as i32;
            let angles = turns.map(|turn| saddle + TAU * f64::from(turn));
            for theta in angles.filter(|theta| (from..=to).contains(theta)) {
                let passing = Passing {
                    theta,
                    theta_rate: 0.0,
                    rotation,
                };
                if let Some(course) = self.course(passing, window, true) {
                    let [first, last] = course.ends();
                    // It has a corner there.
                    for ends in [[first, theta], [theta, last]] {
                        pieces.extend(self.pieces_of(&course, ends, window));
                    }
                }
            }
        }
        pieces
    }

    /// The angles at which static friction of a massless hoop that rolls one way gives way:
    /// |h sin θ − ς χ| = μs (1 + h cos θ), whatever the rate.
    pub(super) fn resisted_slip_angles(&self, rotation: RotationDirection) -> Vec<f64> {
        let Body::Massless(body) = self.hoop.body() else {
            return Vec::new();
        };
        let (mu_s, law) = (self.hoop.mu_s(), self.resisted_law(rotation));
        let angles = [1.0, -1.0].into_iter().flat_map(|side| {
            let limit = side * libm::atan(mu_s);
            let arm = (law.resistance + side * mu_s) / (body.offset * libm::hypot(1.0, mu_s));
            let first = libm::asin(arm);
            [limit + first, limit + PI - first]
        });
        angles
            .filter(|angle| law.presses(Angle::of(*angle)))
            .collect()
    }
}
