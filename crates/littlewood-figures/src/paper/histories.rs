//! Forces and energy of a motion against time, with its transitions.

use littlewood::{Dimension, Hoop, Phase, Sample, SampleColumn, Trajectory, Transition};

use crate::axes::{plain, time};
use crate::columns::{ENERGY, FRICTION, MU_K, MU_S, NORMAL, TIME};
use crate::error::FigureError;
use crate::figure::{Figure, Key, Label, Layer, Mark, Panel, PlotAxis, Series, View};
use crate::input::FigureInput;
use crate::motion::{bounds, horizon, instants};
use crate::style::{FAINT, FIRST, FRICTION_FORCE, INK, NORMAL_FORCE, SECOND, SMALL, SOFT, Stroke};
use crate::words::{hoop_in_words, marked, short, start_in_words};
use littlewood_style::width::{CURVE, FINE};
use littlewood_style::{
    Curve, Dash,
    ticks::{self, Tick},
};

/// A quantity along a motion, a piece for each phase where it is defined.
fn history(
    motion: &Trajectory,
    name: &str,
    column: &'static str,
    value: &dyn Fn(&Phase, &Sample) -> Option<f64>,
) -> Series {
    let until = horizon(motion);
    let pieces = motion
        .phases()
        .iter()
        .map(|phase| {
            instants(phase, until)
                .iter()
                .filter_map(|sample| Some(vec![sample.state.time, value(phase, sample)?]))
                .collect::<Vec<_>>()
        })
        .filter(|piece| piece.len() > 1)
        .collect();
    Series::new(name, &[TIME, column], pieces)
}

fn axis_of(column: &'static str, title: &str, series: &[&Series], also: &[f64]) -> PlotAxis {
    let values = series.iter().flat_map(|series| series.rows().map(|row| row[1]));
    let mut axis = plain(column, title, bounds(values.chain(also.iter().copied()), 0.12));
    axis.ticks = ticks::round(axis.range[0], axis.range[1], 5);
    axis
}

/// A quantity over its unit.
fn quotient(column: SampleColumn) -> String {
    let unit = column.dimension().map_or("1", Dimension::scale_sign);
    format!("{}/({})", marked(column.sign()), marked(unit))
}

/// Verticals at the transitions.
fn transitions(motion: &Trajectory, axis: &PlotAxis) -> Layer {
    let until = horizon(motion);
    let pieces = motion
        .transitions()
        .iter()
        .map(Transition::time)
        .filter(|time| *time < until)
        .map(|time| axis.range.map(|value| vec![time, value]).to_vec())
        .collect();
    Series::new("transition", &[TIME, axis.column], pieces)
        .drawn(Mark::Line(Stroke::solid(FAINT, FINE).dashed(Dash::Dashed)))
}

/// The names of the phases over a panel, and of the transitions above them.
fn names(motion: &Trajectory, top: f64, width: f64) -> Vec<Label> {
    let (from, until) = (motion.start().time, horizon(motion));
    let pixels = |time: f64| (time - from) / (until - from) * width;
    let mut labels: Vec<Label> = Vec::new();
    let mut last = f64::NEG_INFINITY;
    for phase in motion.phases() {
        let (begin, end) = (phase.start().time, f64::min(phase.end_time(), until));
        if pixels(end) - pixels(begin) > 46.0 {
            labels.push(
                Label::new(phase.mode().name(), &[0.5 * (begin + end), top]).shifted(0.0, -11.0).sized(SMALL),
            );
        }
    }
    for transition in motion.transitions() {
        let at = transition.time();
        if at <= until && pixels(at) - last > 40.0 {
            last = pixels(at);
            let label = Label::new(transition.cause.label(), &[at, top]).sized(SMALL).coloured(SOFT);
            labels.push(if width - pixels(at) < 24.0 {
                label.shifted(0.0, -27.0).right()
            } else {
                label.shifted(0.0, -27.0)
            });
        }
    }
    labels
}

fn in_words(input: &FigureInput, hoop: &Hoop) -> String {
    format!("{}; {}", hoop_in_words(hoop), start_in_words(hoop, &input.start))
}

const WIDTH: f64 = 640.0;
const LEFT: f64 = 6.0;
const INNER: f64 = WIDTH - LEFT - 20.0;

fn panel(name: &'static str, top: f64, height: f64, x: PlotAxis, y: PlotAxis, layers: Vec<Layer>) -> Panel {
    Panel {
        name,
        frame: [LEFT, top, INNER, height],
        view: View::Plane { x, y, axes: true },
        layers,
        labels: Vec::new(),
        keys: Vec::new(),
    }
}

/// Forces and the share of friction against time.
pub(crate) fn forces(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "forces";
    let motion = input.motion(NAME)?;
    let hoop = motion.hoop();
    let range = [motion.start().time, horizon(&motion)];
    let x = || time(range);
    let bare = || {
        let ticks = x().ticks.into_iter().map(|tick| Tick { label: String::new(), ..tick }).collect();
        PlotAxis { title: String::new(), ticks, ..x() }
    };

    let normal = history(&motion, SampleColumn::Normal.long_name(), NORMAL, &|_, sample| Some(sample.normal));
    let weight = hoop.mass();
    let normal_axis = axis_of(NORMAL, &quotient(SampleColumn::Normal), &[&normal], &[0.0]);
    let friction =
        history(&motion, SampleColumn::Friction.long_name(), FRICTION, &|_, sample| Some(sample.friction));
    let friction_axis = axis_of(FRICTION, &quotient(SampleColumn::Friction), &[&friction], &[0.0]);
    let demand = history(&motion, "friction over normal force", "demand", &|phase, sample| {
        let in_contact = phase.mode().has_normal_force();
        (in_contact && sample.normal > 1e-9).then(|| sample.friction.abs() / sample.normal)
    });
    let (mu_s, mu_k) = (hoop.mu_s(), hoop.mu_k());
    let demand_axis = PlotAxis {
        range: [0.0, 1.25 * bounds(demand.rows().map(|row| row[1]).chain([mu_s]), 0.0)[1]],
        ..axis_of("demand", "|*F*|/*N*", &[&demand], &[0.0, mu_s])
    };
    let demand_axis = PlotAxis { ticks: ticks::round(0.0, demand_axis.range[1], 5), ..demand_axis };
    let level = |name: &str, column: &'static str, value: f64, stroke: Stroke| {
        Series::of_rows(name, &[TIME, column], range.map(|time| vec![time, value]).to_vec())
            .drawn(Mark::Line(stroke))
    };
    let zero = |column| level("zero", column, 0.0, Stroke::solid(FAINT, FINE));

    let mut top = panel(
        SampleColumn::Normal.long_name(),
        38.0,
        190.0,
        bare(),
        normal_axis.clone(),
        vec![
            transitions(&motion, &normal_axis),
            zero(NORMAL),
            level("weight", NORMAL, weight, Stroke::solid(SOFT, 1.0).dashed(Dash::Dotted)),
            normal.drawn(Mark::Line(Stroke::solid(NORMAL_FORCE, 2.0))),
        ],
    );
    top.labels = names(&motion, normal_axis.range[1], INNER - 62.0);
    top.labels.push(
        Label::new("weight", &[range[1], weight]).shifted(-6.0, -9.0).right().sized(SMALL).coloured(SOFT),
    );
    let middle = panel(
        SampleColumn::Friction.long_name(),
        196.0,
        190.0,
        bare(),
        friction_axis.clone(),
        vec![
            transitions(&motion, &friction_axis),
            zero(FRICTION),
            friction.drawn(Mark::Line(Stroke::solid(FRICTION_FORCE, 2.0))),
        ],
    );
    let mut bottom = panel(
        "friction over normal force",
        354.0,
        190.0,
        x(),
        demand_axis.clone(),
        vec![
            transitions(&motion, &demand_axis),
            level(MU_S, "demand", mu_s, Stroke::of_curve(Curve::SlipLimit).wide(1.2)),
            level(MU_K, "demand", mu_k, Stroke::of_curve(Curve::SlipLimit).wide(1.2).dashed(Dash::Dotted)),
            demand.drawn(Mark::Line(Stroke::solid(INK, 2.0))),
        ],
    );
    bottom.labels.push(Label::new("*μ*_{s}", &[range[1], mu_s]).shifted(-14.0, -11.0));
    if mu_k < mu_s {
        bottom.labels.push(Label::new("*μ*_{k}", &[range[1], mu_k]).shifted(-14.0, 11.0));
    }
    Ok(Figure {
        name: NAME,
        title: "Forces of a motion".to_owned(),
        caption: format!(
            "Normal force *N*, friction force *F* (positive along *E*_{{1}}) and |*F*|/*N* against time; dashed verticals: \
             transitions. Rolling ends where |*F*|/*N* reaches *μ*_{{s}}, a slide has |*F*|/*N* = *μ*_{{k}}, and the forces \
             jump where a slide begins or ends. {}.",
            in_words(input, hoop)
        ),
        width: WIDTH,
        height: 550.0,
        panels: vec![top, middle, bottom],
    })
}

/// Energies against time.
pub(crate) fn energy(input: &FigureInput) -> Result<Figure, FigureError> {
    const NAME: &str = "energy";
    let motion = input.motion(NAME)?;
    let hoop = motion.hoop();
    let range = [motion.start().time, horizon(&motion)];
    let potential_of =
        |sample: &Sample| hoop.offset() * libm::cos(sample.state.theta) + hoop.mass() * sample.gap;
    let total = history(&motion, "total energy", ENERGY, &|_, sample| Some(sample.energy));
    let kinetic =
        history(&motion, "kinetic energy", ENERGY, &|_, sample| Some(sample.energy - potential_of(sample)));
    let potential = history(&motion, "potential energy", ENERGY, &|_, sample| Some(potential_of(sample)));
    let axis = axis_of(
        ENERGY,
        &format!("energy/({})", marked(Dimension::Energy.scale_sign())),
        &[&total, &kinetic, &potential],
        &[0.0],
    );
    let marks = [
        Mark::Line(Stroke::solid(INK, 2.2)),
        Mark::Line(Stroke::solid(FIRST, CURVE).dashed(Dash::Dashed)),
        Mark::Line(Stroke::solid(SECOND, CURVE).dashed(Dash::DashDot)),
    ];
    let zero = Series::of_rows("zero", &[TIME, ENERGY], range.map(|time| vec![time, 0.0]).to_vec());
    let mut panel = panel(
        "energy",
        62.0,
        340.0,
        time(range),
        axis.clone(),
        vec![
            transitions(&motion, &axis),
            zero.drawn(Mark::Line(Stroke::solid(FAINT, FINE))),
            potential.drawn(marks[2]),
            kinetic.drawn(marks[1]),
            total.drawn(marks[0]),
        ],
    );
    panel.labels = names(&motion, axis.range[1], INNER - 62.0);
    panel.keys = ["total *E*", "kinetic *T*", "potential *U*"]
        .into_iter()
        .zip(marks)
        .enumerate()
        .map(|(i, (text, mark))| Key { mark, text: text.to_owned(), at: [70.0 + 130.0 * i as f64, 15.0] })
        .collect();
    Ok(Figure {
        name: NAME,
        title: "Energy of a motion".to_owned(),
        caption: format!(
            "Kinetic, potential (*U* = 0 with the particle at the height of *C*, in contact) and total energy (2.8) \
             against time; dashed verticals: transitions. Only sliding costs energy: {} in all. {}.",
            short(motion.energy_lost()),
            in_words(input, hoop)
        ),
        width: WIDTH,
        height: 410.0,
        panels: vec![panel],
    })
}
