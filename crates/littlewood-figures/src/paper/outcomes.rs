//! What becomes of the starts of the plane: regions of outcomes, bounded by curves.

use core::f64::consts::PI;

use littlewood::{Class, Dimension, Engine, Limits, Quantity, Setup, Start};
use littlewood_style::{Curve, of_class};
use littlewood_sweep::{Axis, Detail, Grid, Place, Regions, Workers};

use crate::axes::outcome_window;
use crate::catalogue::Watch;
use crate::columns::PLANE;
use crate::effort::Effort;
use crate::error::FigureError;
use crate::figure::{Figure, Mark, Series};
use crate::input::FigureInput;
use crate::plane::Portrait;
use crate::sheet::Content;
use crate::style::{BOUNDARY, PAPER, Stroke, THEME};
use crate::trace::Window;
use crate::words::short;

const NAME: &str = "outcomes";
/// How closely boundaries are located where motions take long.
const WIDTH: f64 = 2e-5;
/// Motions that are followed for a start of the lattice, about.
const FOR_A_START: u64 = 8;
/// Part of the plane that can be seen.
const LEAST: f64 = 1e-7;
/// Pixels by which a curve stands out from what is below it on either side.
const MARGIN: f64 = 1.0;

/// How far and how finely the starts of a hoop are followed.
struct Plan {
    limits: Limits,
    /// Starts to the right and upwards at which regions are looked for.
    starts: [usize; 2],
    detail: Detail,
}

impl Plan {
    fn new(input: &FigureInput) -> Self {
        let engine = Engine::new(&input.hoop);
        let effort = Effort::of(&input.hoop, input.limits, &engine);
        let limits = effort.cut(input.limits, &engine);
        // Boundaries run through so many cells at most, and are located less closely where motions take long: still far closer than
        // is seen.
        let finest = Detail::default();
        let coarser = |most| Detail { most, width: WIDTH, ..finest };
        let (starts, detail) = match effort {
            Effort::Tables => ([137, 101], finest),
            Effort::Direct => ([91, 67], coarser(6_000)),
            Effort::Chains => ([45, 33], coarser(800)),
            Effort::Simulated | Effort::Long => ([45, 33], coarser(1_500)),
            Effort::Slow => ([31, 23], coarser(200)),
        };
        Self { limits, starts, detail }
    }
}

/// The regions of the classes in a window.
fn regions_of(
    input: &FigureInput,
    plan: &Plan,
    window: Window,
    watch: &mut Watch<'_>,
) -> Result<Regions, FigureError> {
    let [columns, rows] = plan.starts;
    let axes = vec![
        Axis::new(Quantity::Theta, window.x[0], window.x[1], columns)?,
        Axis::new(Quantity::ThetaRate, window.y[0], window.y[1], rows)?,
    ];
    let grid = Grid::new(Setup::new(input.hoop.parameters(), Start::at(0.0, 0.0)), axes)?;
    let total = FOR_A_START * grid.len();
    let mut told = |followed: u64| watch(followed.min(total), total);
    Ok(Regions::of_classes(&grid, plan.limits, &plan.detail, &Workers::new(None)?, &mut told)?)
}

/// A window with no lattice on its edges and its axes, where motions may be what they are nowhere else. That it is narrower is
/// not seen.
fn within(window: Window) -> Window {
    let side = |[from, to]: [f64; 2]| [from + 0.37e-5 * (to - from), to - 0.53e-5 * (to - from)];
    Window { x: side(window.x), y: side(window.y) }
}

/// Rows of places of a window.
fn rows_of(window: Window, lines: Vec<Vec<Place>>) -> Vec<Vec<Vec<f64>>> {
    let along = |[from, to]: [f64; 2], fraction: f64| {
        if fraction == 1.0 { to } else { from + (to - from) * fraction }
    };
    let row = |[x, y]: Place| vec![along(window.x, x), along(window.y, y)];
    lines.into_iter().map(|line| line.into_iter().map(row).collect()).collect()
}

/// How long the motions are followed, some of which are `cut` before they end.
fn followed(input: &FigureInput, limits: Limits, cut: bool) -> String {
    let say = input.wording();
    let until = |until| format!("to {} = {}", say.time(), say.value(until, Dimension::Time));
    let end = input.limits.until.map_or_else(|| "to its end".to_owned(), until);
    if cut { format!("{end}, or to {} transitions", limits.transitions) } else { end }
}

pub(crate) fn figure(input: &FigureInput, watch: &mut Watch<'_>) -> Result<Figure, FigureError> {
    input.loaded(NAME)?;
    let hoop = &input.hoop;
    let window =
        if input.is_massless() { Window { x: [-PI, PI], y: [-2.0, 2.0] } } else { outcome_window(hoop) };
    let plan = Plan::new(input);
    let Regions { regions, boundaries } = regions_of(input, &plan, within(window), watch)?;
    let mut layers = Vec::new();
    let mut legend: Vec<(Mark, String)> = Vec::new();
    let cuts = plan.limits.transitions < input.limits.transitions;
    let mut cut = false;
    for region in regions.into_iter().filter(|region| region.area > LEAST) {
        let Some(class) = Class::ALL.into_iter().find(|class| u64::from(class.code()) == region.key) else {
            continue;
        };
        cut |= cuts && class == Class::InContact;
        let mark = Mark::Region(of_class(class, THEME));
        let share = libm::round(1000.0 * region.area) / 10.0;
        legend.push((mark, format!("{}, {}%", class.label(), short(share))));
        layers.push(Series::new(class.name(), &PLANE, rows_of(within(window), region.outlines)).drawn(mark));
    }
    let lines = boundaries.into_iter().map(|boundary| boundary.points).collect();
    layers.push(Series::new("boundary", &PLANE, rows_of(within(window), lines)).drawn(Mark::Line(BOUNDARY)));
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
            "What becomes of a start in the plane of rolling with *η*′ = 0, followed {}. Boundaries are followed as curves, \
             each of their points between two starts that end otherwise.{remark} {}.",
            followed(input, plan.limits, cut),
            say.hoop(hoop)
        ),
        430.0,
        Content { name: "plane", x: say.angle(window.x), y: say.rate(window.y), layers, labels: Vec::new() },
        legend,
    ))
}
