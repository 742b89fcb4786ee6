//! Routh's diagram of an impact: the plane of impulses, J along the plane against P upwards, and
//! the way through it.
//!
//! ```text
//! Δη′ = A J + B P,   Δgap′ = B J + C P.
//! ```
//!
//! The way begins at the origin. It goes on with the slope −μk σ to the line of sticking, η′ = 0,
//! and from there along that line or with the slope of the slip that follows; where it crosses the
//! line of greatest compression, gap′ = 0, the gap begins to open.
//!
//! With rolling resistance a couple acts, too, which changes where the rotation does, and these are
//! no straight lines: the picture has the way alone.

use littlewood::impact::{Compliance, Impact, ImpactVertex};
use littlewood::{Cause, Hoop, Transition};
use wasm_bindgen::prelude::wasm_bindgen;

/// A point of the plane of impulses: P and J.
type Point = [f64; 2];

/// Room around the way, as a part of its extent.
const ROOM: f64 = 0.14;

/// The line of sticking is in the picture if the slip would end within so many times the impulse.
const NEAR: f64 = 2.0;

/// Routh's diagram of an impact. Impulses are over m2 √(gR).
#[wasm_bindgen]
#[derive(Clone, Debug)]
pub struct Routh {
    way: Vec<Point>,
    greatest_compression: Option<Point>,
    frame: Frame,
    sticking: Option<Line>,
    compression: Option<Line>,
}

#[wasm_bindgen]
impl Routh {
    /// The way: P and J of its corners, one after the other. The last is the impulse of the whole
    /// impact.
    pub fn way(&self) -> Vec<f64> {
        self.way.concat()
    }

    /// P and J where the way crosses the line of greatest compression.
    #[wasm_bindgen(js_name = greatestCompression)]
    pub fn greatest_compression(&self) -> Vec<f64> {
        self.greatest_compression.map_or_else(Vec::new, Vec::from)
    }

    /// Least and largest P, least and largest J of the picture.
    pub fn frame(&self) -> Vec<f64> {
        let Frame { normal, friction } = self.frame;
        [normal.ends(), friction.ends()].concat()
    }

    /// Both ends of the line of sticking in the picture; empty where it is outside.
    #[wasm_bindgen(js_name = lineOfSticking)]
    pub fn line_of_sticking(&self) -> Vec<f64> {
        self.within_frame(self.sticking)
    }

    /// Both ends of the line of greatest compression in the picture.
    #[wasm_bindgen(js_name = lineOfCompression)]
    pub fn line_of_compression(&self) -> Vec<f64> {
        self.within_frame(self.compression)
    }
}

impl Routh {
    fn within_frame(&self, line: Option<Line>) -> Vec<f64> {
        line.map_or_else(Vec::new, |line| line.within(&self.frame))
    }

    /// Of an impact of this hoop; none for a transition without one, and for bounces that settle,
    /// which are many.
    pub(crate) fn of(hoop: &Hoop, transition: &Transition) -> Option<Self> {
        let impact = transition
            .impact
            .filter(|impact| impact.impulse.normal > 0.0)?;
        if transition.cause == Cause::Settle {
            None
        } else {
            Self::new(hoop, transition.before.theta, &impact)
        }
    }

    fn new(hoop: &Hoop, theta: f64, impact: &Impact) -> Option<Self> {
        let Compliance { a, b, c, .. } = hoop.compliance(theta)?;
        let sticking = Line {
            friction: a,
            normal: b,
            value: -impact.before.slip,
        };
        let compression = Line {
            friction: b,
            normal: c,
            value: -impact.before.gap_rate,
        };
        let resists = hoop.rolling_resistance() > 0.0;
        let [sticking, compression] =
            [sticking, compression].map(|line| Some(line).filter(|_| !resists));
        let course = hoop.impact_course(theta, impact);
        let way: Vec<Point> = course.iter().map(point).collect();
        let in_sight = sticking.and_then(|line| sticking_in_sight(&way, &line));
        let frame = Frame::around(way.iter().copied().chain(in_sight));
        let greatest_compression = crossing(&course);
        Some(Self {
            way,
            greatest_compression,
            frame,
            sticking,
            compression,
        })
    }
}

const fn point(vertex: &ImpactVertex) -> Point {
    [vertex.impulse.normal, vertex.impulse.friction]
}

/// Where a way without a bend would come to the line of sticking, if that is not far beyond its
/// end.
fn sticking_in_sight(way: &[Point], sticking: &Line) -> Option<Point> {
    let &[[0.0, 0.0], end] = way else { return None };
    let part = -sticking.excess([0.0, 0.0]) / (sticking.excess(end) - sticking.excess([0.0, 0.0]));
    (part > 1.0 && part <= NEAR).then(|| end.map(|coordinate| coordinate * part))
}

/// Where the gap rate, linear along each part of the way, stops being negative.
fn crossing(course: &[ImpactVertex]) -> Option<Point> {
    course.windows(2).find_map(|ends| {
        let [from, to] = [0, 1].map(|end| ends[end].velocities.gap_rate);
        let part = from / (from - to);
        (from < 0.0 && to >= 0.0).then(|| {
            let [a, b] = [0, 1].map(|end| point(&ends[end]));
            [a[0] + (b[0] - a[0]) * part, a[1] + (b[1] - a[1]) * part]
        })
    })
}

/// The line friction J + normal P = value.
#[derive(Clone, Copy, Debug)]
struct Line {
    friction: f64,
    normal: f64,
    value: f64,
}

impl Line {
    /// By how much a point is beyond it.
    fn excess(&self, [normal, friction]: Point) -> f64 {
        self.friction * friction + self.normal * normal - self.value
    }

    /// Its ends in a frame: P and J of both, or nothing.
    fn within(&self, frame: &Frame) -> Vec<f64> {
        let at_normal = |normal: f64| [normal, (self.value - self.normal * normal) / self.friction];
        let at_friction = |friction: f64| {
            [
                (self.value - self.friction * friction) / self.normal,
                friction,
            ]
        };
        let on_sides = frame
            .normal
            .ends()
            .map(at_normal)
            .into_iter()
            .filter(|point| frame.friction.contains(point[1]));
        let on_ends = frame
            .friction
            .ends()
            .map(at_friction)
            .into_iter()
            .filter(|point| frame.normal.contains(point[0]));
        let mut points: Vec<Point> = on_sides.chain(on_ends).collect();
        points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        match (points.first(), points.last()) {
            (Some(first), Some(last)) if first != last => [*first, *last].concat(),
            _ => Vec::new(),
        }
    }
}

/// Values from one to another, both included.
#[derive(Clone, Copy, Debug)]
struct Interval {
    least: f64,
    most: f64,
}

impl Interval {
    const fn ends(self) -> [f64; 2] {
        [self.least, self.most]
    }

    fn contains(self, value: f64) -> bool {
        self.least <= value && value <= self.most
    }
}

/// What a picture shows.
#[derive(Clone, Copy, Debug)]
struct Frame {
    normal: Interval,
    friction: Interval,
}

impl Frame {
    fn around(points: impl Iterator<Item = Point> + Clone) -> Self {
        let range = |coordinate: usize| {
            let values = points.clone().map(|point| point[coordinate]);
            let (least, most) = values.fold((0.0, 0.0), |(least, most): (f64, f64), value| {
                (least.min(value), most.max(value))
            });
            (least, most)
        };
        let (_, most) = range(0);
        let normal = Interval {
            least: -ROOM * most,
            most: (1.0 + ROOM) * most,
        };
        let (least, most) = range(1);
        // A frictionless impact has a picture, too.
        let extent = (most - least).max(0.2 * normal.most);
        Self {
            normal,
            friction: Interval {
                least: least - ROOM * extent,
                most: most + ROOM * extent,
            },
        }
    }
}
