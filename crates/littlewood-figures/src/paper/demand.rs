//! The friction that rolling demands, |F|/N, along orbits.

use core::f64::consts::{PI, TAU};

use littlewood::{PhasePlane, RollingLaw};

use crate::axes::{angle, plain};
use crate::error::FigureError;
use crate::figure::{Axis, Figure, Key, Label, Mark, Panel, Series, View};
use crate::style::{BLUE, Dash, GREEN, INK, PURPLE, Stroke, VERMILION};
use crate::subject::Subject;
use crate::trace::Window;
use crate::words::{hoop_in_words, short, start_in_words};

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

pub(crate) fn figure(subject: &Subject) -> Result<Figure, FigureError> {
    subject.loaded(NAME)?;
    let hoop = &subject.hoop;
    let (plane, law) = (PhasePlane::new(hoop), RollingLaw::new(hoop));
    let mu_s = hoop.mu_s();
    let turn = if subject.is_massless() { [-PI + 1e-3, PI - 1e-3] } else { [0.0, TAU] };
    let most = f64::max(2.4 * mu_s, 0.1);
    let window = Window { x: turn, y: [0.0, most] };
    let separatrix = law.separatrix_energy();
    let start = law.energy(subject.start.theta, subject.start.theta_rate);
    let (first, second) = if subject.is_massless() {
        (0.5 * separatrix, separatrix + 1.0)
    } else {
        (law.energy(PI, 0.7 * plane.separatrix_rate(PI)), separatrix + hoop.offset())
    };
    let orbits = [
        ("start", start, Stroke::solid(INK, 2.4)),
        ("separatrix", separatrix, Stroke::solid(BLUE, 1.6).dashed(Dash::Dashed)),
        ("libration", first, Stroke::solid(GREEN, 1.6).dashed(Dash::DashDot)),
        ("rotation", second, Stroke::solid(VERMILION, 1.6).dashed(Dash::Short)),
    ];
    let mut layers = Vec::new();
    let mut keys = Vec::new();
    for (i, (name, energy, stroke)) in orbits.into_iter().enumerate() {
        let series = Series::new(name, &["theta", "demand", "energy"], demand_on(&plane, energy, window));
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
    let limit = Series::of_rows("mu_s", &["theta", "demand"], turn.map(|theta| vec![theta, mu_s]).to_vec());
    layers.push(limit.drawn(Mark::Line(Stroke::solid(PURPLE, 1.2))));
    let at = libm::remainder(subject.start.theta, TAU);
    let at = if at < turn[0] { at + TAU } else { at };
    let here = plane.forces(subject.start.theta, subject.start.theta_rate).demand();
    if here <= most {
        let row = vec![at, here, start];
        layers.push(
            Series::of_rows("start", &["theta", "demand", "energy"], vec![row]).drawn(Mark::Ring(INK, 3.6)),
        );
    }
    let label = Label::new("*μ*_{s}", &[turn[1], mu_s]).shifted(-14.0, -11.0).coloured(PURPLE);
    let y = Axis {
        ticks: littlewood_style::ticks::round(0.0, most, 6),
        ..plain("demand", "|*F*|/*N*", [0.0, most])
    };
    Ok(Figure {
        name: NAME,
        title: "Friction that rolling demands".to_owned(),
        caption: format!(
            "The share |*F*|/*N* that rolling demands along four orbits of constant energy *E* (2.12). Where a curve rises \
             above *μ*_{{s}} the hoop slips; a curve that ends goes up to where *N* = 0 or beyond the frame, or the orbit \
             turns there. |*F*|/*N* does not depend on the direction of motion. {}, *μ*_{{s}} = {}; {}.",
            hoop_in_words(hoop),
            short(mu_s),
            start_in_words(&subject.start)
        ),
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
