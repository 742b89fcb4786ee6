//! The paper against exact: what its equations give as they are printed, beside what holds.

use core::f64::consts::PI;

use littlewood::theory::{Body, Massless, Window};
use littlewood::{Hoop, Mode};
use littlewood_draw::{
    Content, Figure, INK, Label, Layer, Mark, NORMAL_FORCE, PAPER, SOFT, START, Series, Stroke,
    lift_off_condition,
};
use littlewood_style::width::{CURVE, FINE};
use littlewood_style::{Curve, Dash};

use super::gliding::{GLIDING, WINDOW, fastest, line_of};
use crate::axes::portrait_window;
use crate::columns::PLANE;
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::plane::Portrait;

const NAME: &str = "paper";
/// Places in the plane of gliding through which both orbits go.
const PLACES: [[f64; 2]; 4] = [
    [0.3 * PI, 0.8],
    [0.5 * PI, 0.5],
    [0.5 * PI, 1.6],
    [0.75 * PI, 1.0],
];
/// Angles at which the band is looked for.
const CELLS: u32 = 480;
/// The printed lines.
const PRINTED: Stroke = Stroke::solid(SOFT, CURVE).dashed(Dash::Short);

/// The line ½ sin θ θ′² − θ = constant through a place, which (3.18) prints.
fn printed(theta: f64, rate: f64) -> Vec<Vec<[f64; 2]>> {
    let constant = 0.5 * libm::sin(theta) * rate * rate - theta;
    let side = |sign: f64| {
        WINDOW.pieces([1e-6, PI - 1e-6], CELLS, &move |at| {
            let square = 2.0 * (constant + at) / libm::sin(at);
            (square >= 0.0).then(|| [at, sign * square.sqrt()])
        })
    };
    [1.0, -1.0].into_iter().flat_map(side).collect()
}

/// Gliding: the orbits, and the lines of the printed integral through the same places.
fn of_gliding(body: Massless) -> Vec<Layer> {
    let exact = PLACES.into_iter().flat_map(|[theta, rate]| {
        let (sin, cos) = libm::sincos(theta);
        let w = 0.5 * sin * sin * rate * rate + cos;
        let most = fastest(&body, w);
        line_of(&body, w, 1.0, -most, most)
    });
    let exact = exact.map(|piece| piece.into_iter().map(|[theta, rate, _]| [theta, rate]));
    let printed = PLACES
        .into_iter()
        .flat_map(|[theta, rate]| printed(theta, rate));
    vec![
        Series::new("exact", &PLANE, exact).drawn(GLIDING),
        Series::new("printed", &PLANE, printed).drawn(PRINTED),
        Series::of_rows("place", &PLANE, PLACES).drawn(START),
    ]
}

/// Above n and below lift-off, on either side.
fn band(portrait: &Portrait) -> Series {
    let Window {
        x: [from, to],
        y: [_, most],
    } = portrait.window;
    let between = |theta: f64| {
        let low = portrait.plane.normal_force_rate(theta)?;
        let high = portrait
            .plane
            .lift_off_rate(theta)
            .unwrap_or(most)
            .min(most);
        (low < high).then_some([low, high])
    };
    let angles: Vec<f64> = (0..=CELLS)
        .map(|i| from + (to - from) * f64::from(i) / f64::from(CELLS))
        .collect();
    let mut pieces: Vec<Vec<[f64; 2]>> = Vec::new();
    for run in angles.chunk_by(|a, b| between(*a).is_some() == between(*b).is_some()) {
        let edge = |end: usize| {
            run.iter()
                .filter_map(move |theta| Some([*theta, between(*theta)?[end]]))
        };
        let polygon: Vec<[f64; 2]> = edge(0)
            .chain(edge(1).collect::<Vec<_>>().into_iter().rev())
            .collect();
        for sign in [1.0, -1.0] {
            let side = polygon.iter().map(|[theta, rate]| [*theta, sign * rate]);
            pieces.push(side.collect());
        }
    }
    pieces.retain(|piece| piece.len() > 2);
    Series::new("band", &PLANE, pieces)
}

/// The curves of rolling, with the band, filled so.
fn of_lift_off(portrait: &Portrait, fill: Mark) -> (Vec<Layer>, Vec<Label>) {
    let (unloading, lift_off) = (portrait.unloading_locus(), portrait.lift_off_locus());
    let most = portrait.window.y[1];
    let mut labels: Vec<Label> = Vec::new();
    let n = portrait.name_of(&unloading, [0.45 * PI, 0.72 * most], "*n*");
    labels.extend(n.map(|n| n.shifted(10.0, 0.0).coloured(NORMAL_FORCE)));
    labels.push(Label::new("flight", &[0.0, 0.75 * most]).coloured(INK));
    let separatrix = Stroke::of_curve(Curve::Separatrix).wide(FINE);
    let layers = vec![
        band(portrait).drawn(fill),
        portrait.separatrix().drawn(separatrix),
        unloading.drawn(Curve::NormalForceZero),
        lift_off.drawn(Curve::LiftOff),
    ];
    (layers, labels)
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.with_inertia(NAME)?;
    let hoop = &input.hoop;
    let Body::Massless(body) = Hoop::littlewood(hoop.mu_s(), hoop.mu_k())?.body() else {
        return Err(FigureError::NeedsInertia { figure: NAME });
    };
    let portrait = Portrait::new(hoop, portrait_window(hoop));
    let fill = Mark::Fill(Stroke::of_mode(Mode::Sliding).colour.over(PAPER, 0.35));
    let (layers, labels) = of_lift_off(&portrait, fill);
    let say = input.wording();
    let contents = [
        Content {
            name: "gliding",
            x: say.angle([0.0, PI]),
            y: say.rate(WINDOW.y),
            layers: of_gliding(body),
            labels: Vec::new(),
        },
        portrait.content("lift-off", say, layers, labels),
    ];
    let keys = vec![
        (Mark::Line(GLIDING), "orbits of gliding".to_owned()),
        (Mark::Line(PRINTED), "lines of (3.18) as printed".to_owned()),
        (fill, "slides; lifts off in the paper".to_owned()),
        (Curve::LiftOff.into(), lift_off_condition(hoop.slope())),
    ];
    let caption = format!(
        "What the paper prints, beside what holds. First: gliding of the massless hoop through four places (crosses), along lines of \
         constant ½ sin^{{2}}*θ* *θ*′^{{2}} + cos *θ*, and the lines of (3.18) as it is printed, ½ sin *θ* *θ*′^{{2}} − *θ*. Second: \
         beyond *n* rolling would need *N* < 0, and the paper lets the hoop leave the plane; but it slides in the band (shaded) up to {}, \
         beyond which it flies.{} {}.",
        lift_off_condition(hoop.slope()),
        portrait.remark(),
        say.body(hoop)
    );
    let (title, sheet) = ("The paper against exact", input.sheet(860.0)?);
    Ok(sheet.pair(NAME, title, caption, 362.0, contents, keys))
}
