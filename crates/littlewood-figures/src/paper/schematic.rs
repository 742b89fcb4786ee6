//! Figure 1: the body and its symbols.

use core::f64::consts::PI;

use crate::columns::{X as X_COLUMN, Y};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::motion::bounds;
use littlewood_draw::{
    Content, Figure, HATCH, INK, Label, Mark, Piece, PlotAxis, SOFT, Series, Sheet, Stroke, tilted,
};
use littlewood_style::Dash;
use littlewood_style::width::{BOLD, CURVE, FINE};

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
/// Where the arrow of gravity begins.
const GRAVITY: [f64; 2] = [3.45, 2.1];
/// Length of the horizontal at a slope.
const SLOPE: f64 = 1.3;

fn arc(centre: [f64; 2], radius: f64, from: f64, to: f64) -> Piece {
    (0..=ARC)
        .map(|i| {
            let (sin, cos) = libm::sincos(from + (to - from) * f64::from(i) / f64::from(ARC));
            vec![centre[0] - radius * sin, centre[1] + radius * cos]
        })
        .collect()
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let hoop = &input.hoop;
    let (sin, cos) = libm::sincos(THETA);
    let along = |distance: f64| [X - distance * sin, 1.0 + distance * cos];
    let across =
        |base: [f64; 2], distance: f64| [base[0] + distance * cos, base[1] + distance * sin];
    let segment = |name: &str, a: [f64; 2], b: [f64; 2]| {
        Series::of_rows(name, &COLUMNS, vec![a.to_vec(), b.to_vec()])
    };
    let point = |name: &str, a: [f64; 2]| Series::of_rows(name, &COLUMNS, vec![a.to_vec()]);
    let thin = Mark::Line(Stroke::solid(INK, FINE));
    let witness = Mark::Line(Stroke::solid(SOFT, 0.6));
    let axis = Mark::Arrow(Stroke::solid(INK, CURVE));
    let dotted = Mark::Line(Stroke::solid(SOFT, FINE).dashed(Dash::Dashed));

    let slope = hoop.slope();
    let (mut x_range, y_range) = ([-0.45, 3.75], [-0.62, 2.5]);
    // Room for the angle, at the lower end of the plane.
    if slope != 0.0 {
        x_range[usize::from(slope < 0.0)] -= libm::copysign(1.2, slope);
    }
    let centre = [X, 1.0];
    let particle = along(hoop.offset());
    let mass_centre = along(hoop.h());
    let ground = [
        [x_range[0], 0.0],
        [x_range[1], 0.0],
        [x_range[1], -0.09],
        [x_range[0], -0.09],
    ];
    let tip = along(1.55);
    let beside_gravity = |length: f64| {
        let [right, up] = tilted(-slope, [0.0, -length]);
        [GRAVITY[0] + right, GRAVITY[1] + up]
    };
    let mut layers = vec![
        Series::of_rows("ground", &COLUMNS, ground.map(Vec::from).to_vec())
            .drawn(Mark::Hatch(HATCH)),
        segment("ground", [x_range[0], 0.0], [x_range[1], 0.0]).drawn(Stroke::solid(INK, 1.4)),
        segment("normal", [X, 0.0], [X, 2.38]).drawn(dotted),
        segment("radius", centre, particle).drawn(Stroke::solid(INK, CURVE)),
        segment("e2", centre, tip).drawn(axis),
        segment("e1", centre, across(centre, 0.62)).drawn(axis),
        segment("E1", [0.0, 0.0], [0.62, 0.0]).drawn(axis),
        segment("E2", [0.0, 0.0], [0.0, 0.62]).drawn(axis),
        Series::of_rows("theta", &COLUMNS, arc(centre, 0.62, 0.0, THETA - 0.04))
            .drawn(Mark::Arrow(Stroke::solid(INK, 1.0))),
        segment("gravity", GRAVITY, beside_gravity(0.6)).drawn(axis),
        segment("x", [0.0, -0.36], [X, -0.36]).drawn(Mark::Arrow(Stroke::solid(INK, 1.0))),
        segment("x foot", [X, 0.0], [X, -0.46]).drawn(thin),
        segment("x origin", [0.0, 0.0], [0.0, -0.46]).drawn(thin),
    ];
    layers.push(
        Series::of_rows("rim", &COLUMNS, arc(centre, 1.0, 0.0, 2.0 * PI))
            .drawn(Stroke::solid(SOFT, BOLD)),
    );
    // Lengths beside the radius, on the side away from the angle.
    let beside = |distance: f64, away: f64| across(along(distance), -away);
    let length = |name: &str, to: f64, away: f64| {
        let end = away + 0.05;
        // Where there is room for two heads.
        let line = Stroke::solid(INK, 0.8);
        let line = if to > 0.2 {
            Mark::Arrow(line)
        } else {
            Mark::Line(line)
        };
        vec![
            segment(name, beside(0.0, away), beside(to, away)).drawn(line),
            segment(name, beside(to, away), beside(0.0, away)).drawn(line),
            segment("witness", beside(0.0, 0.06), beside(0.0, end)).drawn(witness),
            segment("witness", beside(to, 0.06), beside(to, end)).drawn(witness),
        ]
    };
    let has_two = hoop.h() < hoop.offset();
    layers.extend(length("l", hoop.offset(), 0.4));
    if has_two {
        layers.extend(length("h", hoop.h(), 0.18));
    }
    // The radius R, to the right.
    let rim = [X + libm::sin(2.0), 1.0 + libm::cos(2.0)];
    layers.push(segment("R", centre, rim).drawn(Mark::Arrow(Stroke::solid(INK, 1.0))));
    layers.push(point("C", centre).drawn(Mark::Dot(INK, 2.8)));
    layers.push(point("particle", particle).drawn(Mark::Dot(INK, 6.5)));
    layers.push(point("contact", [X, 0.0]).drawn(Mark::Dot(INK, 2.8)));
    if has_two {
        layers.push(point("mass centre", mass_centre).drawn(Mark::Ring(INK, 3.6)));
    }
    let middle = |to: f64, away: f64| beside(0.5 * to, away);
    let half = arc(centre, 0.62, 0.5 * THETA, 0.5 * THETA);
    let mut labels = vec![
        Label::new("*C*", &centre).shifted(13.0, 10.0),
        Label::new("*m*_{2}", &particle).shifted(-18.0, -2.0),
        Label::new("*m*_{1}, *I*_{zz}", &[X + 0.73, 1.0 + 0.73])
            .shifted(8.0, -6.0)
            .left()
            .coloured(SOFT),
        Label::new("*X*_{P}", &[X, 0.0]).shifted(14.0, 17.0),
        Label::new("*θ*", &half[0]).shifted(-3.0, -11.0),
        Label::new("`e`_{2}", &tip).shifted(-4.0, -10.0),
        Label::new("`e`_{1}", &across(centre, 0.62)).shifted(12.0, -5.0),
        Label::new("`E`_{1}", &[0.62, 0.0]).shifted(4.0, -13.0),
        Label::new("`E`_{2}", &[0.0, 0.62]).shifted(0.0, -12.0),
        Label::new("*O*", &[0.0, 0.0]).shifted(-12.0, 12.0),
        Label::new("`g`", &beside_gravity(0.3)).shifted(11.0, 0.0),
        Label::new("*x*", &[0.5 * X, -0.36]),
        Label::new("*ℓ*", &middle(hoop.offset(), 0.4)).shifted(-9.0, 7.0),
        Label::new(
            "*R*",
            &[X + 0.5 * libm::sin(2.0), 1.0 + 0.5 * libm::cos(2.0)],
        )
        .shifted(6.0, -10.0),
    ];
    if has_two {
        labels.push(Label::new("*X̄*", &mass_centre).shifted(14.0, 2.0));
        labels.push(Label::new("*h*", &middle(hoop.h(), 0.18)).shifted(-7.0, 7.0));
    }
    if slope != 0.0 {
        let apex = x_range[usize::from(slope < 0.0)];
        let reach = f64::min(SLOPE, -y_range[0] / libm::sin(slope).abs());
        let at = |share: f64, angle: f64| {
            let [right, up] = tilted(-angle, [libm::copysign(share * reach, slope), 0.0]);
            [apex + right, up]
        };
        let arc = (0..=ARC)
            .map(|i| at(0.7, slope * f64::from(i) / f64::from(ARC)).to_vec())
            .collect();
        layers.push(segment("horizontal", [apex, 0.0], at(1.0, slope)).drawn(dotted));
        layers.push(Series::of_rows("slope", &COLUMNS, arc).drawn(Stroke::solid(INK, 1.0)));
        labels.push(Label::new("*α*", &at(0.82, 0.5 * slope)));
    }
    // The coordinates of the plane, turned.
    let corners = || {
        x_range
            .into_iter()
            .flat_map(|x| y_range.map(|y| tilted(slope, [x, y])))
    };
    let (x_range, y_range) = (
        bounds(corners().map(|[x, _]| x), 0.0),
        bounds(corners().map(|[_, y]| y), 0.0),
    );
    let sheet = input.sheet(SCALE * (x_range[1] - x_range[0]))?;
    let (width, height) = (
        sheet.width,
        sheet.width * (y_range[1] - y_range[0]) / (x_range[1] - x_range[0]),
    );
    let [x, y] = [
        PlotAxis::silent(X_COLUMN, x_range),
        PlotAxis::silent(Y, y_range),
    ];
    let panel = Sheet::bare(
        [0.0, 0.0, width, height],
        Content {
            name: "body",
            x,
            y,
            layers,
            labels,
        },
        slope,
    );
    Ok(sheet.figure(
        NAME,
        "Figure 1: the body",
        format!(
            "A hoop or disc of mass *m*_{{1}}, radius *R* and moment of inertia *I*_{{zz}} about its centre *C* carries a \
             particle of mass *m*_{{2}} at the distance *ℓ*. The mass centre *X̄* of the whole lies at *h* = \
             *m*_{{2}}*ℓ*/(*m*_{{1}} + *m*_{{2}}) from *C* (2.4). *θ* is the angle of the particle from the {}, \
             counterclockwise; *X*_{{P}} is the point of contact, whose velocity is *η*′ `E`_{{1}} with *η* = \
             *x* + *Rθ* (2.6, 2.7). Drawn to scale for {}.",
            if slope == 0.0 { "upward vertical" } else { "normal of the plane, which rises by *α*" },
            input.wording().body(hoop)
        ),
        height,
        vec![panel],
    ))
}
