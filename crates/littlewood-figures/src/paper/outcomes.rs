//! What becomes of the starts of the plane, by the engine.

use core::f64::consts::PI;

use littlewood::{Direction, Engine, Mode, OutcomeCode, PhaseSequence, Start, Summary};

use crate::axes::{angle, plane_window, rate};
use crate::error::FigureError;
use crate::figure::{Figure, Key, Mark, Panel, Series, View};
use crate::plane::Portrait;
use crate::style::{Colour, Dash, INK, Stroke, WHITE};
use crate::subject::Subject;
use crate::trace::Window;
use crate::words::{hoop_in_words, short};

const NAME: &str = "outcomes";
/// Cells to the right and upwards.
const CELLS: [u32; 2] = [270, 200];

/// What is told apart, with its colour: lightness grows in this order as far as classes meet in one map.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Class {
    LeavesAtOnce,
    LiftsOffLater,
    Rolls,
    Slides,
    AtPlane,
    Limit,
    Paradox,
}

const CLASSES: [(Class, &str, Colour); 7] = [
    (Class::LeavesAtOnce, "leaves the plane at once", Colour(0x22, 0x22, 0x5c)),
    (Class::LiftsOffLater, "lifts off later", Colour(0xd5, 0x5e, 0x00)),
    (Class::Rolls, "rolls for ever", Colour(0xd3, 0xea, 0xf5)),
    (Class::Slides, "slides for ever", Colour(0x2a, 0xa1, 0x98)),
    (Class::AtPlane, "particle comes to the plane", Colour(0xd9, 0x88, 0xb8)),
    (Class::Limit, "in contact at the limit", Colour(0x56, 0xb4, 0xe9)),
    (Class::Paradox, "no unique motion", Colour(0x00, 0x00, 0x00)),
];

fn class_of(summary: &Summary) -> Class {
    match summary.outcome {
        OutcomeCode::Landing => {
            let mut at_once = PhaseSequence::default();
            at_once.push(Mode::Flight, None::<Direction>);
            if summary.sequence == at_once { Class::LeavesAtOnce } else { Class::LiftsOffLater }
        }
        OutcomeCode::RollsForever => Class::Rolls,
        OutcomeCode::SlidesForever => Class::Slides,
        OutcomeCode::ParticleAtPlane | OutcomeCode::ParticleAtBottom | OutcomeCode::ParticleAtTop => {
            Class::AtPlane
        }
        OutcomeCode::TimeLimit | OutcomeCode::TransitionLimit => Class::Limit,
        _ => Class::Paradox,
    }
}

pub(crate) fn figure(subject: &Subject) -> Result<Figure, FigureError> {
    subject.loaded(NAME)?;
    let hoop = &subject.hoop;
    let window =
        if subject.is_massless() { Window { x: [-PI, PI], y: [-2.0, 2.0] } } else { plane_window(hoop) };
    let engine = Engine::new(hoop);
    let side = |range: [f64; 2], cells: u32| (range[1] - range[0]) / f64::from(cells);
    let cell = [side(window.x, CELLS[0]), side(window.y, CELLS[1])];
    let mut rows: [Vec<Vec<f64>>; CLASSES.len()] = Default::default();
    for j in 0..CELLS[1] {
        let theta_rate = window.y[0] + cell[1] * (f64::from(j) + 0.5);
        for i in 0..CELLS[0] {
            let theta = window.x[0] + cell[0] * (f64::from(i) + 0.5);
            let summary = engine.summary(Start::at(theta, theta_rate), subject.limits)?;
            let class = class_of(&summary);
            let place = CLASSES.iter().position(|(known, ..)| *known == class).unwrap_or(0);
            rows[place].push(vec![theta, theta_rate]);
        }
    }
    let total = f64::from(CELLS[0] * CELLS[1]);
    let (mut layers, mut keys) = (Vec::new(), Vec::new());
    for ((_, name, colour), rows) in CLASSES.into_iter().zip(rows) {
        if rows.is_empty() {
            continue;
        }
        let share = libm::round(1000.0 * rows.len() as f64 / total) / 10.0;
        let text = format!("{name}, {}%", short(share));
        let n = keys.len();
        keys.push(Key {
            mark: Mark::Fill(colour),
            text,
            at: [70.0 + 240.0 * (n % 2) as f64, 16.0 + 20.0 * (n / 2) as f64],
        });
        layers.push(Series::of_rows(name, &["theta", "theta_rate"], rows).drawn(Mark::Cell(colour, cell)));
    }
    let portrait = Portrait::new(hoop, window);
    let under = Stroke::solid(WHITE, 3.0);
    let over = [Stroke::solid(INK, 1.2), Stroke::solid(INK, 1.2).dashed(Dash::Dashed)];
    let curves = [portrait.lift_off_locus(), portrait.unloading_locus()];
    if !subject.is_massless() {
        for (series, stroke) in curves.into_iter().zip(over) {
            layers.push(series.clone().drawn(Mark::Line(under)));
            layers.push(series.drawn(Mark::Line(stroke)));
        }
        let n = keys.len();
        for (i, (text, stroke)) in
            ["*h* cos *θ* *θ*′^{2} = 1", "*n*: *N* = 0 in rolling"].into_iter().zip(over).enumerate()
        {
            let n = n + i;
            keys.push(Key {
                mark: Mark::Line(stroke),
                text: text.to_owned(),
                at: [70.0 + 240.0 * (n % 2) as f64, 16.0 + 20.0 * (n / 2) as f64],
            });
        }
    }
    let room = 14.0 + 20.0 * keys.len().div_ceil(2) as f64;
    Ok(Figure {
        name: NAME,
        title: "What becomes of the motion".to_owned(),
        caption: format!(
            "What becomes of a start in the plane of rolling with *η*′ = 0, followed to its end: {} by {} starts. The body \
             leaves the plane at once only beyond *h* cos *θ* *θ*′^{{2}} = 1, not, as the paper has it, beyond *n*: between \
             the two it slides first. {}, *μ*_{{s}} = {}, *μ*_{{k}} = {}.",
            CELLS[0],
            CELLS[1],
            hoop_in_words(hoop),
            short(hoop.mu_s()),
            short(hoop.mu_k())
        ),
        width: 620.0,
        height: 436.0 + room,
        panels: vec![Panel {
            name: "plane",
            frame: [6.0, room, 592.0, 430.0],
            view: View::Plane { x: angle(window.x), y: rate(window.y), axes: true },
            layers,
            labels: Vec::new(),
            keys,
        }],
    })
}
