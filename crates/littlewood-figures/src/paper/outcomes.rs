//! What becomes of the starts of the plane, by the engine.

use core::f64::consts::PI;

use littlewood::{Class, Dimension, Engine, Start};
use littlewood_style::{Curve, of_class};

use crate::axes::outcome_window;
use crate::catalogue::Watch;
use crate::columns::PLANE;
use crate::error::FigureError;
use crate::figure::{Figure, Mark, Series};
use crate::input::FigureInput;
use crate::plane::Portrait;
use crate::sheet::Content;
use crate::style::{PAPER, Stroke, THEME};
use crate::trace::Window;
use crate::words::short;

const NAME: &str = "outcomes";
/// Cells to the right and upwards.
const CELLS: [u32; 2] = [270, 200];
/// Transitions within which most motions that bounce have lifted off for the first time.
const FIRST: usize = 16;
/// Pixels by which a curve stands out from what is below it on either side.
const MARGIN: f64 = 1.0;

/// The centres of the cells of each class of outcomes, by its code.
fn cells_by_class(
    input: &FigureInput,
    window: Window,
    cell: [f64; 2],
    watch: &mut Watch<'_>,
) -> Result<[Vec<Vec<f64>>; Class::ALL.len()], FigureError> {
    let engine = Engine::new(&input.hoop);
    let mut cells: [Vec<Vec<f64>>; Class::ALL.len()] = Default::default();
    for j in 0..CELLS[1] {
        let theta_rate = window.y[0] + cell[1] * (f64::from(j) + 0.5);
        for i in 0..CELLS[0] {
            let theta = window.x[0] + cell[0] * (f64::from(i) + 0.5);
            let class = class_of(&engine, input, Start::at(theta, theta_rate))?;
            cells[usize::from(class.code())].push(vec![theta, theta_rate]);
            watch(u64::from(j * CELLS[0] + i + 1), u64::from(CELLS[0] * CELLS[1]));
        }
    }
    Ok(cells)
}

/// The class of a start. It is settled with the first lift-off, so that bounces need not be followed to their end.
fn class_of(engine: &Engine, input: &FigureInput, start: Start) -> Result<Class, FigureError> {
    let limits = input.limits;
    if input.hoop.restitution().is_some() && limits.transitions > FIRST {
        let class = Class::of(&engine.summary(start, limits.with_transitions(FIRST))?);
        if class != Class::InContact {
            return Ok(class);
        }
    }
    Ok(Class::of(&engine.summary(start, limits)?))
}

/// How long the motions are followed.
fn followed(input: &FigureInput) -> String {
    let say = input.wording();
    let until = |until| format!("to {} = {}", say.time(), say.value(until, Dimension::Time));
    input.limits.until.map_or_else(|| "to its end".to_owned(), until)
}

pub(crate) fn figure(input: &FigureInput, watch: &mut Watch<'_>) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let hoop = &input.hoop;
    let window =
        if input.is_massless() { Window { x: [-PI, PI], y: [-2.0, 2.0] } } else { outcome_window(hoop) };
    let side = |range: [f64; 2], cells: u32| (range[1] - range[0]) / f64::from(cells);
    let cell = [side(window.x, CELLS[0]), side(window.y, CELLS[1])];
    let cells = cells_by_class(input, window, cell, watch)?;

    let total = f64::from(CELLS[0] * CELLS[1]);
    let mut layers = Vec::new();
    let mut legend: Vec<(Mark, String)> = Vec::new();
    for (class, rows) in Class::ALL.into_iter().zip(cells).filter(|(_, rows)| !rows.is_empty()) {
        let colour = of_class(class, THEME);
        let share = libm::round(1000.0 * rows.len() as f64 / total) / 10.0;
        legend.push((Mark::Fill(colour), format!("{}, {}%", class.label(), short(share))));
        layers.push(Series::of_rows(class.name(), &PLANE, rows).drawn(Mark::Cell(colour, cell)));
    }
    // A massless hoop does not leave the plane.
    let mut remark = "";
    if !input.is_massless() {
        let portrait = Portrait::new(hoop, window);
        for (curve, series, words) in [
            (Curve::LiftOff, portrait.lift_off_locus(), "*h* cos *θ* *θ*′^{2} = 1: *N* = 0 in sliding"),
            (Curve::NormalForceZero, portrait.unloading_locus(), "*n*: *N* = 0 in rolling"),
        ] {
            let stroke = Stroke::of_curve(curve);
            let under = Stroke::solid(PAPER, stroke.width + 2.0 * MARGIN);
            layers.push(series.clone().drawn(Mark::Line(under)));
            layers.push(series.drawn(Mark::Line(stroke)));
            legend.push((Mark::Line(stroke), words.to_owned()));
        }
        remark = " The body leaves the plane at once only beyond *h* cos *θ* *θ*′^{2} = 1, not, as the paper has it, \
                  beyond *n*: between the two it slides first.";
    }
    let say = input.wording();
    Ok(input.sheet(620.0)?.plot(
        NAME,
        "What becomes of the motion",
        format!(
            "What becomes of a start in the plane of rolling with *η*′ = 0, followed {}: {} by {} starts.{remark} {}.",
            followed(input),
            CELLS[0],
            CELLS[1],
            say.hoop(hoop)
        ),
        430.0,
        Content { name: "plane", x: say.angle(window.x), y: say.rate(window.y), layers, labels: Vec::new() },
        legend,
    ))
}
