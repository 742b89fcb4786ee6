//! The friction that rolling demands, |F|/N, along orbits.

use core::f64::consts::{PI, TAU};

use littlewood::{PhasePlane, RollingLaw};

use crate::axes::{angle, plain};
use crate::columns::{ENERGY, MU_S, THETA};
use crate::error::FigureError;
use crate::figure::{Figure, Key, Label, Mark, Panel, PlotAxis, Series, View};
use crate::input::FigureInput;
use crate::plane::rows;
use crate::style::{FIRST, FRICTION_FORCE, INK, SOFT, Stroke};
use crate::trace::Window;
use crate::words::{rolling_in_words, short, start_in_words};
use littlewood_style::width::{BOLD, CURVE};
use littlewood_style::{Curve, Dash, ticks};

const NAME: &str = "friction-demand";

/// |F|/N on the orbit of an energy, as far as it reaches and N > 0.
fn demand_on(plane: &PhasePlane, energy: f64, window: Window) -> Vec<Vec<Vec<f64>>> {
    window
        .pieces(window.x, 1440, &|theta| {
            let rate = plane.level_rate(theta, energy)?;
            let forces = plane.forces(theta, rate);
            (forces.normal > 0.0).then(|| [theta, forces.friction.abs() / forces.normal])
        })
        .into_iter()
        .map(|piece| piece.into_iter().map(|[theta, demand]| vec![theta, demand, energy]).collect())
        .collect()
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let hoop = &input.hoop;
    let (plane, law) = (PhasePlane::new(hoop), RollingLaw::new(hoop));
    let mu_s = hoop.mu_s();
    let turn = if input.is_massless() { [-PI + 1e-3, PI - 1e-3] } else { [0.0, TAU] };
    let most = f64::max(2.4 * mu_s, 0.1);
    let window = Window { x: turn, y: [0.0, most] };
    let separatrix = law.separatrix_energy();
    let start = law.energy(input.start.theta, input.start.theta_rate);
    let (first, second) = if input.is_massless() {
        (0.5 * separatrix, separatrix + 1.0)
    } else {
        (law.energy(PI, 0.7 * plane.separatrix_rate(PI)), separatrix + hoop.offset())
    };
    let orbits = [
        ("start", start, Stroke::solid(FIRST, BOLD)),
        (Curve::Separatrix.name(), separatrix, Stroke::of_curve(Curve::Separatrix)),
        ("libration", first, Stroke::solid(SOFT, CURVE).dashed(Dash::DashDot)),
        ("rotation", second, Stroke::solid(SOFT, CURVE).dashed(Dash::Short)),
    ];
    let mut layers = Vec::new();
    let mut keys = Vec::new();
    // N and F of a massless hoop vanish together, and their ratio is the same on all orbits.
    let orbits = if input.is_massless() { &orbits[..0] } else { &orbits[..] };
    if input.is_massless() {
        let demand = window.pieces(window.x, 1440, &|theta| Some([theta, plane.forces(theta, 0.0).demand()]));
        let series = Series::new("every orbit", &[THETA, "demand"], rows(demand));
        layers.push(series.drawn(Mark::Line(Stroke::solid(FIRST, BOLD))));
    }
    for (i, (name, energy, stroke)) in orbits.iter().copied().enumerate() {
        let series = Series::new(name, &[THETA, "demand", ENERGY], demand_on(&plane, energy, window));
        layers.push(series.drawn(Mark::Line(stroke)));
        let what = if name == "start" { "orbit of the start" } else { name };
        let text = format!("{what}, *E* = {}", short(libm::round(energy * 100.0) / 100.0));
        keys.push(Key {
            mark: Mark::Line(stroke),
            text,
            at: [70.0 + 260.0 * (i % 2) as f64, 15.0 + 19.0 * (i / 2) as f64],
        });
    }
    layers.reverse();
    let limit = Series::of_rows(MU_S, &[THETA, "demand"], turn.map(|theta| vec![theta, mu_s]).to_vec());
    layers.push(limit.drawn(Mark::Line(Stroke::of_curve(Curve::SlipLimit).wide(CURVE))));
    let at = libm::remainder(input.start.theta, TAU);
    let at = if at < turn[0] { at + TAU } else { at };
    let here_rate = if input.is_massless() { 0.0 } else { input.start.theta_rate };
    let here = plane.forces(input.start.theta, here_rate).demand();
    if here <= most {
        let row = vec![at, here, start];
        layers.push(
            Series::of_rows("start", &[THETA, "demand", ENERGY], vec![row]).drawn(Mark::Ring(INK, 3.6)),
        );
    }
    let label = Label::new("*μ*_{s}", &[turn[1], mu_s]).shifted(-14.0, -11.0).coloured(FRICTION_FORCE);
    let y = PlotAxis { ticks: ticks::round(0.0, most, 6), ..plain("demand", "|*F*|/*N*", [0.0, most]) };
    Ok(Figure {
        name: NAME,
        title: "Friction that rolling demands".to_owned(),
        caption: if input.is_massless() {
            format!(
                "The share |*F*|/*N* that rolling of a massless hoop demands: *F* and *N* vanish together, and their ratio is \
                 the same on all orbits and at all rates (3.9). Where the curve rises above *μ*_{{s}} the hoop slips. {}; {}.",
                rolling_in_words(hoop),
                start_in_words(hoop, &input.start)
            )
        } else {
            format!(
                "The share |*F*|/*N* that rolling demands along four orbits of constant energy *E* (2.12). Where a curve rises \
             above *μ*_{{s}} the hoop slips; a curve that ends goes up to where *N* = 0 or beyond the frame, or the orbit \
             turns there. |*F*|/*N* does not depend on the direction of motion. {}; {}.",
                rolling_in_words(hoop),
                start_in_words(hoop, &input.start)
            )
        },
        width: 620.0,
        height: 430.0,
        panels: vec![Panel {
            name: "demand",
            frame: [6.0, 48.0, 592.0, 376.0],
            view: View::Plane { x: angle(turn), y, axes: true },
            layers,
            labels: vec![label],
            keys,
        }],
    })
}
