//! The marks: lines, heads of arrows, areas, dots, hoops, in steps of the sheet.

use littlewood_style::width::{BOLD, CURVE};
use littlewood_style::{Curve, Rgb};

use crate::figure::{HoopShape, Mark};
use crate::hatch;
use crate::item::{Frame, Item, Paint, STEPS, Step, Words, steps};
use crate::primitives::{Anchor, Point};
use crate::stroke::{INK, PAPER, Stroke};
use crate::words::marked;

/// The start of a motion, in all pictures.
pub const START: Mark = Mark::Cross(INK, 4.0);
/// A transition.
pub const TRANSITION: Mark = Mark::Diamond(INK, 4.2);
/// A stable equilibrium.
pub const STABLE: Mark = Mark::Dot(INK, 3.4);
/// An unstable one.
pub const UNSTABLE: Mark = Mark::Ring(INK, 3.4);

/// A curve of the (θ, θ′) plane in a key, and what it means.
pub fn key_of_curve(curve: Curve, slope: f64) -> (Mark, String) {
    let words = match curve {
        Curve::SlipLimit => "*f*: |*F*| = *μ*_{s}*N* in rolling".to_owned(),
        Curve::NormalForceZero => "*n*: *N* = 0 in rolling".to_owned(),
        Curve::LiftOff => format!("{}: *N* = 0 in sliding", lift_off_condition(slope)),
        Curve::Separatrix | Curve::ReverseChatter | Curve::Level | Curve::BandOfRest => {
            curve.label(slope).to_owned()
        }
    };
    (Mark::Line(Stroke::of_curve(curve)), words)
}

/// Where a sliding hoop leaves the plane (2.18), with marks.
pub fn lift_off_condition(slope: f64) -> String {
    marked(Curve::LiftOff.condition(slope))
}

/// Length and half width of a head of an arrow in pixels; of a line that is bolder than those of
/// figures they are larger.
const HEAD: [f64; 2] = [9.0, 3.4];

/// Height and half width of the triangle of a curve that goes on beyond its axes, in pixels.
const BEYOND: [f64; 2] = [7.0, 4.0];

/// Radius of a hoop whose particle has its full size, in pixels.
const LARGE: f64 = 36.0;

/// How far the edge of a diamond reaches.
const EDGE: f64 = 1.4;

/// What is on a sheet, the lowest first.
#[derive(Debug, Default)]
pub(crate) struct Canvas(pub(crate) Vec<Item>);

/// Where the middle of a text stands, on the vertical, from its base line, in parts of its size.
pub(crate) const MIDDLE: f64 = 0.33;

impl Canvas {
    /// Draws pieces of points; `unit` is the number of steps to a unit of the axes.
    pub(crate) fn mark(&mut self, mark: Mark, pieces: &[Vec<Step>], unit: f64) {
        let points = || pieces.iter().flatten().copied();
        match mark {
            Mark::Line(stroke) => pieces.iter().for_each(|piece| self.line(piece, stroke)),
            Mark::Arrow(stroke) => {
                for piece in pieces {
                    self.line(piece, stroke);
                    if let [.., from, to] = piece[..] {
                        self.head(from, to, stroke, false);
                    }
                }
            }
            Mark::Head(colour) => {
                for piece in pieces {
                    if let [from, to, ..] = piece[..] {
                        self.head(to, from, Stroke::solid(colour, 0.0), true);
                    }
                }
            }
            Mark::Fill(colour) => pieces
                .iter()
                .for_each(|piece| self.polygon(piece, Paint::Fill(colour))),
            Mark::Hatch(colour) => {
                pieces
                    .iter()
                    .for_each(|piece| self.hatch(core::slice::from_ref(piece), colour));
            }
            Mark::Region(colour) => self.0.push(Item::path(pieces, Paint::Fill(colour))),
            Mark::HatchedRegion(colour) => self.hatch(pieces, colour),
            Mark::Dot(colour, radius) => points().for_each(|point| self.dot(point, colour, radius)),
            Mark::Ring(colour, radius) => {
                for point in points() {
                    self.dot(point, PAPER, radius);
                    self.circle(point, steps(radius), edge(Stroke::solid(colour, 1.4)));
                }
            }
            Mark::Diamond(colour, radius) => {
                for point in points() {
                    for (r, colour) in [(radius + EDGE, PAPER), (radius, colour)] {
                        let r = steps(r);
                        let corners = [(-r, 0), (0, r), (r, 0), (0, -r)];
                        let corners = corners.map(|(right, down)| point.by(right, down));
                        self.polygon(&corners, Paint::Fill(colour));
                    }
                }
            }
            Mark::Cross(colour, radius) => {
                let (r, stroke) = (steps(radius), Stroke::solid(colour, 1.6));
                for point in points() {
                    self.line(&[point.by(-r, -r), point.by(r, r)], stroke);
                    self.line(&[point.by(-r, r), point.by(r, -r)], stroke);
                }
            }
            Mark::Beyond(colour) => {
                points().for_each(|point| self.beyond(point, colour, true));
            }
            Mark::Hoop(hoop) => points().for_each(|point| self.hoop(point, 0.0, unit, hoop)),
        }
    }

    /// A hoop about its centre, its particle at an angle, a unit of the axes so many steps.
    pub(crate) fn hoop(&mut self, centre: Step, theta: f64, unit: f64, hoop: HoopShape) {
        let HoopShape { offset, h, rim, .. } = hoop;
        let unit = hoop.radius * unit;
        let (sin, cos) = libm::sincos(theta);
        let along = |distance: f64| {
            let [right, down] = [sin, cos].map(|part| libm::round(distance * part * unit) as i32);
            centre.by(-right, -down)
        };
        self.circle(centre, libm::round(unit) as i32, edge(rim));
        let spoke = f64::max(1.0, 0.5 * rim.width);
        self.line(&[centre, along(offset)], rim.wide(spoke));
        // In a small picture as small as the hoop; in a bold one as bold as its rim.
        let bold = f64::max(1.0, rim.width / CURVE);
        let size = bold * f64::clamp(unit / STEPS / LARGE, 0.5, 1.0);
        self.dot(along(offset), INK, 5.0 * size);
        if h < offset {
            self.mark(Mark::Ring(INK, 3.0 * size), &[vec![along(h)]], unit);
        }
        self.dot(centre, INK, 1.8 * size);
    }

    /// A triangle whose tip is at a place, and points up or down.
    pub(crate) fn beyond(&mut self, tip: Step, colour: Rgb, upwards: bool) {
        let [high, wide] = BEYOND.map(steps);
        let base = if upwards { high } else { -high };
        let corners = [tip, tip.by(wide, base), tip.by(-wide, base)];
        self.polygon(&corners, Paint::Fill(colour));
    }

    /// A line from point to point.
    pub(crate) fn line(&mut self, points: &[Step], stroke: Stroke) {
        if points.len() > 1 {
            self.polygon(points, edge(stroke));
        }
    }

    /// The colour of the area in which a box lies; the paper, if it is in none or reaches out of
    /// it.
    pub(crate) fn below(&self, frame: Frame) -> Rgb {
        let [left, top, right, bottom] = frame.sides();
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        let area = self.0.iter().rev().find_map(|item| {
            let Item::Path {
                lines,
                paint: Paint::Fill(colour),
            } = item
            else {
                return None;
            };
            let steps = corners.map(|corner| corner.map(|side| side * STEPS));
            let inside = steps.map(|corner| winding(lines, corner, Step::place) != 0);
            inside
                .contains(&true)
                .then(|| if inside == [true; 4] { *colour } else { PAPER })
        });
        area.unwrap_or(PAPER)
    }

    /// Hatches the area that closed lines bound together.
    pub(crate) fn hatch(&mut self, outlines: &[Vec<Step>], colour: Rgb) {
        let lines = hatch::lines(outlines);
        if !lines.is_empty() {
            self.0.push(Item::path(
                &lines,
                edge(Stroke::solid(colour, hatch::WIDTH)),
            ));
        }
    }

    pub(crate) fn polygon(&mut self, points: &[Step], paint: Paint) {
        self.0.push(Item::path(&[points.to_vec()], paint));
    }

    fn circle(&mut self, centre: Step, radius: i32, paint: Paint) {
        self.0.push(Item::Circle {
            centre,
            radius,
            paint,
        });
    }

    fn dot(&mut self, point: Step, colour: Rgb, radius: f64) {
        self.circle(point, steps(radius), Paint::Fill(colour));
    }

    /// A text without a halo, by its middle on the vertical.
    pub(crate) fn text(&mut self, text: &str, place: Step, anchor: Anchor, size: f64, colour: Rgb) {
        let Point { x, y } = place.pixels();
        let at = [x, y + MIDDLE * size];
        self.words(Words {
            text: text.to_owned(),
            at,
            anchor,
            size,
            colour,
            upwards: false,
            ground: None,
        });
    }

    pub(crate) fn words(&mut self, words: Words) {
        if !words.text.is_empty() {
            self.0.push(Item::Words(words));
        }
    }

    /// A head that points from one point to another: its tip there, or its middle at the second.
    fn head(&mut self, from: Step, to: Step, stroke: Stroke, centred: bool) {
        let (dx, dy) = (f64::from(to.x - from.x), f64::from(to.y - from.y));
        let length = libm::sqrt(dx * dx + dy * dy);
        if length == 0.0 {
            return;
        }
        let (ux, uy) = if centred {
            (-dx / length, -dy / length)
        } else {
            (dx / length, dy / length)
        };
        let larger = f64::max(1.0, stroke.width / BOLD);
        let [long, wide] = HEAD.map(|size| f64::from(steps(larger * size)));
        let forward = if centred { 0.5 * long } else { 0.0 };
        let corner = |along: f64, across: f64| {
            to.by(
                libm::round(along * ux - across * uy) as i32,
                libm::round(along * uy + across * ux) as i32,
            )
        };
        let corners = [
            corner(forward, 0.0),
            corner(forward - long, wide),
            corner(forward - 0.75 * long, 0.0),
            corner(forward - long, -wide),
        ];
        self.polygon(&corners, Paint::Fill(stroke.colour));
    }
}

/// How often closed lines, whose points are read so, wind about a place.
pub(crate) fn winding<P: Copy>(
    lines: &[Vec<P>],
    place: [f64; 2],
    read: impl Fn(P) -> [f64; 2],
) -> i32 {
    let [x, y] = place;
    let edges = lines
        .iter()
        .flat_map(|line| line.iter().zip(line.iter().cycle().skip(1)));
    edges
        .map(|(a, b)| {
            let [a, b] = [a, b].map(|it| read(*it));
            let left = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
            i32::from(a[1] <= y && b[1] > y && left > 0.0)
                - i32::from(a[1] > y && b[1] <= y && left < 0.0)
        })
        .sum()
}

/// Narrowest line in pixels.
pub(crate) const HAIR: f64 = 0.6;

/// A line as a shape has it.
pub(crate) fn edge(stroke: Stroke) -> Paint {
    Paint::Edge(stroke.wide(stroke.width.max(HAIR)))
}
