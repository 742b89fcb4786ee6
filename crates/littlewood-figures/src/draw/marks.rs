//! The marks: lines, heads of arrows, areas, dots, hoops, in steps of the sheet.

use plotters::element::{Circle, PathElement, Polygon};
use plotters::style::Color as _;

use super::canvas::{Canvas, Ink, PLAIN, steps};
use super::item::Paint;
use super::library::{Area, Failure, line, rgb};
use crate::figure::Mark;
use crate::style::{INK, PAPER, Stroke};
use littlewood_style::{Dash, Rgb};

/// Length and half width of a head of an arrow in pixels.
const HEAD: [f64; 2] = [9.0, 3.4];

/// How far the edge of a diamond reaches.
const EDGE: f64 = 1.4;

/// Draws marks on a sheet.
pub(crate) struct Pen<'a> {
    root: &'a Area,
    canvas: &'a Canvas,
}

/// A place on the sheet in steps.
type Step = (i32, i32);

impl<'a> Pen<'a> {
    pub(crate) const fn new(root: &'a Area, canvas: &'a Canvas) -> Self {
        Self { root, canvas }
    }

    /// Draws pieces of points; `unit` is the number of steps to a unit of the axes.
    pub(crate) fn mark(&self, mark: Mark, pieces: &[Vec<Step>], unit: f64) -> Result<(), Failure> {
        let area = match mark {
            Mark::Region(colour) => Some(Paint::Fill(colour)),
            Mark::HatchedRegion(colour) => Some(Paint::Hatch(colour)),
            _ => None,
        };
        if let Some(paint) = area {
            self.canvas.area(pieces, paint);
            return Ok(());
        }
        for piece in pieces {
            match mark {
                Mark::Line(stroke) => self.path(piece, stroke)?,
                Mark::Arrow(stroke) => {
                    self.path(piece, stroke)?;
                    if let [.., from, to] = piece[..] {
                        self.head(from, to, stroke.colour, false)?;
                    }
                }
                Mark::Head(colour) => {
                    if let [from, to, ..] = piece[..] {
                        self.head(to, from, colour, true)?;
                    }
                }
                Mark::Fill(colour) | Mark::Region(colour) => self.area(piece, colour, false)?,
                Mark::Hatch(colour) | Mark::HatchedRegion(colour) => self.area(piece, colour, true)?,
                Mark::Dot(colour, radius) => {
                    for point in piece {
                        self.dot(*point, colour, radius)?;
                    }
                }
                Mark::Ring(colour, radius) => {
                    for point in piece {
                        self.dot(*point, PAPER, radius)?;
                        let style = line(Stroke::solid(colour, 1.4));
                        self.root.draw(&Circle::new(*point, steps(radius), style))?;
                    }
                }
                Mark::Diamond(colour, radius) => {
                    for (x, y) in piece {
                        for (r, colour) in [(radius + EDGE, PAPER), (radius, colour)] {
                            let r = steps(r);
                            self.area(&[(x - r, *y), (*x, y + r), (x + r, *y), (*x, y - r)], colour, false)?;
                        }
                    }
                }
                Mark::Cross(colour, radius) => {
                    let r = steps(radius);
                    for (x, y) in piece {
                        let stroke = Stroke::solid(colour, 1.6);
                        self.path(&[(x - r, y - r), (x + r, y + r)], stroke)?;
                        self.path(&[(x - r, y + r), (x + r, y - r)], stroke)?;
                    }
                }
                Mark::Hoop { offset, h, radius, rim } => {
                    for point in piece {
                        self.hoop(*point, 0.0, radius * unit, [offset, h], rim)?;
                    }
                }
            }
        }
        Ok(())
    }

    /// A hoop of radius one about its centre, its particle at an angle.
    pub(crate) fn hoop(
        &self,
        centre: Step,
        theta: f64,
        unit: f64,
        [offset, h]: [f64; 2],
        rim: Stroke,
    ) -> Result<(), Failure> {
        let (sin, cos) = libm::sincos(theta);
        let along = |distance: f64| {
            (
                centre.0 - libm::round(distance * sin * unit) as i32,
                centre.1 - libm::round(distance * cos * unit) as i32,
            )
        };
        self.canvas.take(PLAIN);
        self.root.draw(&Circle::new(centre, libm::round(unit) as i32, line(rim)))?;
        self.path(&[centre, along(offset)], Stroke { width: 1.0, ..rim })?;
        self.dot(along(offset), INK, 5.0)?;
        if h < offset {
            self.mark(Mark::Ring(INK, 3.0), &[vec![along(h)]], unit)?;
        }
        self.dot(centre, INK, 1.8)
    }

    fn path(&self, points: &[Step], stroke: Stroke) -> Result<(), Failure> {
        if points.len() < 2 {
            return Ok(());
        }
        self.canvas.take(Ink { dash: stroke.dash, ..PLAIN });
        self.root.draw(&PathElement::new(points.to_vec(), line(stroke)))?;
        self.canvas.take(PLAIN);
        Ok(())
    }

    fn area(&self, points: &[Step], colour: Rgb, hatch: bool) -> Result<(), Failure> {
        self.canvas.take(Ink { hatch, ..PLAIN });
        self.root.draw(&Polygon::new(points.to_vec(), rgb(colour)))?;
        self.canvas.take(PLAIN);
        Ok(())
    }

    fn dot(&self, point: Step, colour: Rgb, radius: f64) -> Result<(), Failure> {
        self.root.draw(&Circle::new(point, steps(radius), rgb(colour).filled()))
    }

    /// A head that points from one point to another: its tip there, or its middle at the second.
    fn head(&self, from: Step, to: Step, colour: Rgb, centred: bool) -> Result<(), Failure> {
        let (dx, dy) = (f64::from(to.0 - from.0), f64::from(to.1 - from.1));
        let length = libm::sqrt(dx * dx + dy * dy);
        if length == 0.0 {
            return Ok(());
        }
        let (ux, uy) = if centred { (-dx / length, -dy / length) } else { (dx / length, dy / length) };
        let [long, wide] = HEAD.map(|size| f64::from(steps(size)));
        let forward = if centred { 0.5 * long } else { 0.0 };
        let corner = |along: f64, across: f64| {
            (
                to.0 + libm::round(along * ux - across * uy) as i32,
                to.1 + libm::round(along * uy + across * ux) as i32,
            )
        };
        let corners = [
            corner(forward, 0.0),
            corner(forward - long, wide),
            corner(forward - 0.75 * long, 0.0),
            corner(forward - long, -wide),
        ];
        self.canvas.take(Ink { dash: Dash::Solid, ..PLAIN });
        self.root.draw(&Polygon::new(corners.to_vec(), rgb(colour)))
    }
}
