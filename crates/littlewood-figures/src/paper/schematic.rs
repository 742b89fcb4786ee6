//! Figure 1: the body and its symbols.

use core::f64::consts::PI;

use littlewood_draw::{
    Content, Figure, HATCH, INK, Label, Layer, Mark, PanelFrame, PlotAxis, Point, SOFT, Series,
    Sheet, Stroke, tilted,
};
use littlewood_style::Dash;
use littlewood_style::width::{BOLD, CURVE, FINE};

use crate::columns::{X as X_COLUMN, Y};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::bounds;

const NAME: &str = "figure-1";
const COLUMNS: [&str; 2] = [X_COLUMN, Y];
/// Pixels of a radius on a screen.
const SCALE: f64 = 118.0;
/// Intervals of an arc.
const ARC: u32 = 180;
/// The angle at which the body is shown.
const THETA: f64 = 0.8;
/// Where its centre stands.
const X: f64 = 2.1;
const CENTRE: Point = Point::new(X, 1.0);
const ORIGIN: Point = Point::new(0.0, 0.0);
/// Where the arrow of gravity begins.
const GRAVITY: Point = Point::new(3.45, 2.1);
/// Length of the horizontal at a slope.
const SLOPE: f64 = 1.3;
/// Length of a unit vector, and radius of the arc of θ.
const UNIT: f64 = 0.62;
/// Distance of the lines of ℓ and of h from the radius.
const OF_OFFSET: f64 = 0.4;
const OF_H: f64 = 0.18;

/// What is drawn so far.
struct Drawing {
    layers: Vec<Layer>,
    labels: Vec<Label>,
    /// Ranges of the coordinates along the plane and upright to it.
    x: [f64; 2],
    y: [f64; 2],
}

const fn at(x: f64, y: f64) -> Point {
    Point { x, y }
}

/// A place so far from the centre along the radius of the particle, and so far across it.
fn on_radius(distance: f64, across: f64) -> Point {
    let (sin, cos) = libm::sincos(THETA);
    let [x, y] = [X - distance * sin, 1.0 + distance * cos];
    at(x + across * cos, y + across * sin)
}

/// The arc of a circle about the centre.
fn arc(radius: f64, from: f64, to: f64) -> impl Iterator<Item = Point> {
    (0..=ARC).map(move |i| {
        let (sin, cos) = libm::sincos(from + (to - from) * f64::from(i) / f64::from(ARC));
        at(CENTRE.x - radius * sin, CENTRE.y + radius * cos)
    })
}

/// So far below the place of gravity, as the paper has it.
fn beside_gravity(slope: f64, length: f64) -> Point {
    let along = tilted(-slope, at(0.0, -length));
    at(GRAVITY.x + along.x, GRAVITY.y + along.y)
}

impl Drawing {
    fn line(&mut self, name: &str, from: Point, to: Point, mark: impl Into<Mark>) {
        let series = Series::of_rows(name, &COLUMNS, [from, to]);
        self.layers.push(series.drawn(mark));
    }

    fn arrow(&mut self, name: &str, from: Point, to: Point, width: f64) {
        self.line(name, from, to, Mark::Arrow(Stroke::solid(INK, width)));
    }

    fn point(&mut self, name: &str, at: Point, mark: Mark) {
        self.layers
            .push(Series::of_rows(name, &COLUMNS, [at]).drawn(mark));
    }

    /// A text so far from a place, in pixels.
    fn label(&mut self, text: &str, at: Point, right: f64, down: f64) {
        self.labels
            .push(Label::new(text, &at.row()).shifted(right, down));
    }

    /// The plane and the directions.
    fn directions(&mut self, slope: f64, offset: f64) {
        let [left, right] = self.x;
        let ground = [[left, 0.0], [right, 0.0], [right, -0.09], [left, -0.09]];
        let ground = Series::of_rows("ground", &COLUMNS, ground);
        self.layers.push(ground.drawn(Mark::Hatch(HATCH)));
        let plane = Stroke::solid(INK, 1.4);
        self.line("ground", at(left, 0.0), at(right, 0.0), plane);
        let dotted = Stroke::solid(SOFT, FINE).dashed(Dash::Dashed);
        self.line("normal", at(X, 0.0), at(X, 2.38), dotted);
        let radius = Stroke::solid(INK, CURVE);
        self.line("radius", CENTRE, on_radius(offset, 0.0), radius);
        self.arrow("e2", CENTRE, on_radius(1.55, 0.0), CURVE);
        self.arrow("e1", CENTRE, on_radius(0.0, UNIT), CURVE);
        self.arrow("E1", ORIGIN, at(UNIT, 0.0), CURVE);
        self.arrow("E2", ORIGIN, at(0.0, UNIT), CURVE);
        let theta = Series::of_rows("theta", &COLUMNS, arc(UNIT, 0.0, THETA - 0.04));
        self.layers
            .push(theta.drawn(Mark::Arrow(Stroke::solid(INK, 1.0))));
        self.arrow("gravity", GRAVITY, beside_gravity(slope, 0.6), CURVE);
        self.arrow("x", at(0.0, -0.36), at(X, -0.36), 1.0);
        let thin = Stroke::solid(INK, FINE);
        self.line("x foot", at(X, 0.0), at(X, -0.46), thin);
        self.line("x origin", ORIGIN, at(0.0, -0.46), thin);
        let rim = Series::of_rows("rim", &COLUMNS, arc(1.0, 0.0, 2.0 * PI));
        self.layers.push(rim.drawn(Stroke::solid(SOFT, BOLD)));
    }

    /// A length from the centre along the radius, beside it on the side away from the angle.
    fn length(&mut self, name: &str, to: f64, away: f64) {
        let beside = |distance: f64, away: f64| on_radius(distance, -away);
        // Where there is room for two heads.
        let line = Stroke::solid(INK, 0.8);
        let line = if to > 0.2 {
            Mark::Arrow(line)
        } else {
            Mark::Line(line)
        };
        self.line(name, beside(0.0, away), beside(to, away), line);
        self.line(name, beside(to, away), beside(0.0, away), line);
        let witness = Stroke::solid(SOFT, 0.6);
        for end in [0.0, to] {
            self.line(
                "witness",
                beside(end, 0.06),
                beside(end, away + 0.05),
                witness,
            );
        }
    }

    fn names(&mut self, slope: f64, offset: f64) {
        let rim = Label::new("*m*_{1}, *I*_{zz}", &[X + 0.73, 1.0 + 0.73]);
        self.label("*C*", CENTRE, 13.0, 10.0);
        self.label("*m*_{2}", on_radius(offset, 0.0), -18.0, -2.0);
        self.labels
            .push(rim.shifted(8.0, -6.0).left().coloured(SOFT));
        self.label("*X*_{P}", at(X, 0.0), 14.0, 17.0);
        let middle = arc(UNIT, 0.5 * THETA, 0.5 * THETA).next();
        self.label("*θ*", middle.unwrap_or(CENTRE), -3.0, -11.0);
        self.label("`e`_{2}", on_radius(1.55, 0.0), -4.0, -10.0);
        self.label("`e`_{1}", on_radius(0.0, UNIT), 12.0, -5.0);
        self.label("`E`_{1}", at(UNIT, 0.0), 4.0, -13.0);
        self.label("`E`_{2}", at(0.0, UNIT), 0.0, -12.0);
        self.label("*O*", ORIGIN, -12.0, 12.0);
        self.label("`g`", beside_gravity(slope, 0.3), 11.0, 0.0);
        self.label("*x*", at(0.5 * X, -0.36), 0.0, 0.0);
        self.label("*ℓ*", on_radius(0.5 * offset, -OF_OFFSET), -9.0, 7.0);
        let radius = at(X + 0.5 * libm::sin(2.0), 1.0 + 0.5 * libm::cos(2.0));
        self.label("*R*", radius, 6.0, -10.0);
    }

    /// The angle by which the plane rises, at its lower end.
    fn slope(&mut self, slope: f64) {
        let apex = self.x[usize::from(slope < 0.0)];
        let reach = f64::min(SLOPE, -self.y[0] / libm::sin(slope).abs());
        let beside = |share: f64, angle: f64| {
            let along = tilted(-angle, at(libm::copysign(share * reach, slope), 0.0));
            at(apex + along.x, along.y)
        };
        let dotted = Stroke::solid(SOFT, FINE).dashed(Dash::Dashed);
        self.line("horizontal", at(apex, 0.0), beside(1.0, slope), dotted);
        let arc = (0..=ARC).map(|i| beside(0.7, slope * f64::from(i) / f64::from(ARC)));
        let arc = Series::of_rows("slope", &COLUMNS, arc);
        self.layers.push(arc.drawn(Stroke::solid(INK, 1.0)));
        self.label("*α*", beside(0.82, 0.5 * slope), 0.0, 0.0);
    }
}

fn caption(input: &FigureInput) -> String {
    format!(
        "A hoop or disc of mass *m*_{{1}}, radius *R* and moment of inertia *I*_{{zz}} about its centre *C* carries a \
         particle of mass *m*_{{2}} at the distance *ℓ*. The mass centre *X̄* of the whole lies at *h* = \
         *m*_{{2}}*ℓ*/(*m*_{{1}} + *m*_{{2}}) from *C* (2.4). *θ* is the angle of the particle from the {}, \
         counterclockwise; *X*_{{P}} is the point of contact, whose velocity is *η*′ `E`_{{1}} with *η* = \
         *x* + *Rθ* (2.6, 2.7). Drawn to scale for {}.",
        if input.hoop.slope() == 0.0 {
            "upward vertical"
        } else {
            "normal of the plane, which rises by *α*"
        },
        input.wording().body(&input.hoop)
    )
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let (offset, h, slope) = (input.hoop.offset(), input.hoop.h(), input.hoop.slope());
    let mut drawing = Drawing {
        layers: Vec::new(),
        labels: Vec::new(),
        x: [-0.45, 3.75],
        y: [-0.62, 2.5],
    };
    // Room for the angle, at the lower end of the plane.
    if slope != 0.0 {
        drawing.x[usize::from(slope < 0.0)] -= libm::copysign(1.2, slope);
    }
    drawing.directions(slope, offset);
    drawing.length("l", offset, OF_OFFSET);
    let has_two = h < offset;
    if has_two {
        drawing.length("h", h, OF_H);
    }
    // The radius R, to the right.
    let rim = at(X + libm::sin(2.0), 1.0 + libm::cos(2.0));
    drawing.arrow("R", CENTRE, rim, 1.0);
    drawing.point("C", CENTRE, Mark::Dot(INK, 2.8));
    drawing.point("particle", on_radius(offset, 0.0), Mark::Dot(INK, 6.5));
    drawing.point("contact", at(X, 0.0), Mark::Dot(INK, 2.8));
    drawing.names(slope, offset);
    if has_two {
        let mass_centre = on_radius(h, 0.0);
        drawing.point("mass centre", mass_centre, Mark::Ring(INK, 3.6));
        drawing.label("*X̄*", mass_centre, 14.0, 2.0);
        drawing.label("*h*", on_radius(0.5 * h, -OF_H), -7.0, 7.0);
    }
    if slope != 0.0 {
        drawing.slope(slope);
    }
    // The coordinates of the plane, turned.
    let corners = || {
        let corner = |x| drawing.y.map(|y| tilted(slope, Point { x, y }));
        drawing.x.into_iter().flat_map(corner)
    };
    let x = bounds(corners().map(|corner| corner.x), 0.0);
    let y = bounds(corners().map(|corner| corner.y), 0.0);
    let sheet = input.sheet(SCALE * (x[1] - x[0]))?;
    let height = sheet.width * (y[1] - y[0]) / (x[1] - x[0]);
    let content = Content {
        name: "body",
        x: PlotAxis::silent(X_COLUMN, x.into()),
        y: PlotAxis::silent(Y, y.into()),
        layers: drawing.layers,
        labels: drawing.labels,
    };
    let panel = Sheet::bare(PanelFrame::from_corner(sheet.width, height), content, slope);
    Ok(sheet.figure(
        NAME,
        "Figure 1: the body",
        caption(input),
        height,
        vec![panel],
    ))
}
