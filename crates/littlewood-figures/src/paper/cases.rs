//! All named cases on one page, on one scale.

use core::f64::consts::TAU;

use littlewood::cases::{CASES, NamedCase};
use littlewood::{Phase, Sample, Trajectory};
use littlewood_draw::{
    Content, FAINT, Figure, INK, Label, Panel, Piece, PlotAxis, SMALL, SOFT, START, Series, Sheet,
    Stroke, short,
};
use littlewood_style::Curve;
use littlewood_style::width::{CURVE, FINE};

use crate::columns::{DEMAND, ENERGY, MU_S, THETA, THETA_RATE, TIME};
use crate::error::FigureError;
use crate::input::FigureInput;
use crate::miniature::{by_mode, end_of, picture, samples};
use crate::motion::bounds;

const NAME: &str = "cases";
const WIDTH: f64 = 980.0;
/// Height of a row, and what is between two.
const HIGH: f64 = 66.0;
const BETWEEN: f64 = 8.0;
/// The columns: name and path, phase path, friction, energy; in parts of the width.
const SHARES: [f64; 4] = [0.46, 0.22, 0.16, 0.16];
const GAP: f64 = 8.0;
/// Room above for the heads of the columns, and width of the names.
const ABOVE: f64 = 34.0;
const NAMES: f64 = 126.0;
/// Radii of a path upwards, time of the lines.
const RADII: f64 = 3.4;
const TIMES: f64 = 12.0;
const DEMANDS: f64 = 1.0;

/// A line against time, of the phases of which there is a number.
fn line(motion: &Trajectory, value: &dyn Fn(&Phase, &Sample) -> Option<f64>) -> Vec<Piece> {
    let from = motion.start().time;
    let pieces = motion
        .phases()
        .iter()
        .take_while(|phase| phase.start().time < from + TIMES)
        .map(|phase| {
            let duration = phase.duration().min(from + TIMES - phase.start().time);
            let rows = (0..=30).map(|i| phase.sample(duration * f64::from(i) / 30.0));
            rows.filter_map(|sample| Some(vec![sample.state.time - from, value(phase, &sample)?]))
                .filter(|row| row[1].is_finite())
                .collect::<Vec<_>>()
        });
    pieces.filter(|piece| piece.len() > 1).collect()
}

/// The panels of a case.
fn row_of(
    motion: &Trajectory,
    [energies, rates]: [[f64; 2]; 2],
    frames: [[f64; 4]; 4],
) -> Vec<Panel> {
    let hoop = motion.hoop();
    let start = motion.start();
    let mut panels = vec![picture(motion, frames[0], HIGH / RADII, None)];
    let shown = samples(motion, end_of(motion, f64::INFINITY));
    // From the turn about the start on.
    let turn = TAU * libm::round(start.theta / TAU);
    let mut layers = Vec::new();
    for (mode, pieces) in by_mode(&shown, |sample| {
        vec![sample.state.theta - turn, sample.state.theta_rate]
    }) {
        let mark = Stroke::of_mode(mode).wide(CURVE);
        layers.push(Series::new(mode.name(), &[THETA, THETA_RATE], pieces).drawn(mark));
    }
    layers.push(
        Series::of_rows(
            "start",
            &[THETA, THETA_RATE],
            vec![vec![start.theta - turn, start.theta_rate]],
        )
        .drawn(START),
    );
    // A motion to the left goes to larger angles.
    let goes_up = shown
        .last()
        .is_none_or(|last| last.state.theta >= start.theta);
    let x = if goes_up {
        [-0.6 * TAU, 1.9 * TAU]
    } else {
        [-1.9 * TAU, 0.6 * TAU]
    };
    let mut add = |i: usize, name, [x, y]: [(&'static str, [f64; 2]); 2], layers| {
        let [x, y] = [x, y].map(|(column, range)| PlotAxis::silent(column, range));
        panels.push(Sheet::panel(
            frames[i],
            Content {
                name,
                x,
                y,
                layers,
                labels: Vec::new(),
            },
        ));
    };
    add(1, "phase path", [(THETA, x), (THETA_RATE, rates)], layers);
    let demand = line(motion, &|phase, sample| {
        (phase.mode().has_normal_force() && sample.normal > 1e-9)
            .then(|| sample.friction.abs() / sample.normal)
    });
    let limit = vec![vec![0.0, hoop.mu_s()], vec![TIMES, hoop.mu_s()]];
    let layers = vec![
        Series::of_rows(MU_S, &[TIME, DEMAND], limit)
            .drawn(Stroke::of_curve(Curve::SlipLimit).wide(FINE)),
        Series::new("friction over normal force", &[TIME, DEMAND], demand)
            .drawn(Stroke::solid(INK, CURVE)),
    ];
    let times = (TIME, [0.0, TIMES]);
    add(2, "friction", [times, (DEMAND, [0.0, DEMANDS])], layers);
    let energy = line(motion, &|_, sample| Some(sample.energy));
    let zero = vec![vec![0.0, 0.0], vec![TIMES, 0.0]];
    let layers = vec![
        Series::of_rows("zero", &[TIME, ENERGY], zero).drawn(Stroke::solid(FAINT, FINE)),
        Series::new("energy", &[TIME, ENERGY], energy).drawn(Stroke::solid(INK, CURVE)),
    ];
    add(3, "energy", [times, (ENERGY, energies)], layers);
    panels
}

pub(crate) fn figure(input: &FigureInput) -> Result<Figure, FigureError> {
    let sheet = input.sheet(WIDTH)?;
    let [left, inner] = sheet.span();
    let names = if inner > 2.5 * NAMES + 300.0 {
        NAMES
    } else {
        0.0
    };
    let wide = inner - names - 3.0 * GAP;
    let mut lefts = [left + names; 4];
    for i in 1..4 {
        lefts[i] = lefts[i - 1] + SHARES[i - 1] * wide + GAP;
    }
    // Without room beside it a name stands above its row.
    let above = if names > 0.0 { 0.0 } else { 16.0 };
    let (mut panels, mut labels, mut top) = (Vec::new(), Vec::new(), ABOVE);
    let heads = [
        "path of the mass centre",
        "*θ*, *θ*′",
        "|*F*|/*N*, *μ*_{s}",
        "*E*",
    ];
    for (head, left) in heads.into_iter().zip(lefts) {
        labels.push(
            Label::new(head, &[left, -0.5 * ABOVE])
                .left()
                .sized(SMALL)
                .coloured(SOFT),
        );
    }
    let motions: Vec<Trajectory> = CASES
        .iter()
        .map(NamedCase::simulate)
        .collect::<Result<_, _>>()?;
    let of_energy = |motion| {
        line(motion, &|_, sample| Some(sample.energy))
            .into_iter()
            .flatten()
            .map(|row| row[1])
    };
    let energies = bounds(motions.iter().flat_map(of_energy).chain([0.0]), 0.05);
    // The rate of a massless hoop has no bound.
    let fastest = 1.1
        * motions
            .iter()
            .map(|motion| motion.start().theta_rate.abs())
            .fold(1.0, f64::max);
    for (case, motion) in CASES.iter().zip(&motions) {
        let at = if names > 0.0 {
            [left, -(top + 0.5 * HIGH)]
        } else {
            [left, -(top + 0.5 * above)]
        };
        labels.push(Label::new(case.name, &at).left().sized(SMALL));
        top += above;
        if motion.phases().is_empty() {
            let text = motion.outcome().kind().label();
            let label = Label::new(text, &[lefts[0], -(top + 0.5 * HIGH)])
                .left()
                .shifted(8.0, 0.0);
            labels.push(label.sized(SMALL).coloured(SOFT));
        } else {
            let frames = core::array::from_fn(|i| [lefts[i], top, SHARES[i] * wide, HIGH]);
            panels.extend(row_of(motion, [energies, [-fastest, fastest]], frames));
        }
        top += HIGH + BETWEEN;
    }
    let [x, y] = [
        PlotAxis::silent("right", [0.0, sheet.width]),
        PlotAxis::silent("up", [-top, 0.0]),
    ];
    let content = Content {
        name: "names",
        x,
        y,
        layers: Vec::new(),
        labels,
    };
    panels.push(Sheet::bare([0.0, 0.0, sheet.width, top], content, 0.0));
    let caption = format!(
        "All named cases, each column on one scale. Path of the mass centre, with the hoop at some instants, along the plane; the motion in \
         the plane of *θ* and *θ*′, two turns and a half, rates to ±{} √(*g*/*R*); \
         |*F*|/*N* from 0 to {DEMANDS} with *μ*_{{s}} (dashed), and the energy from about {} to {}, both to *τ* = {TIMES} after the start. \
         The command cases has the titles.",
        short(libm::round(10.0 * fastest) / 10.0),
        short(libm::round(energies[0])),
        short(libm::round(energies[1]))
    );
    Ok(sheet.figure(NAME, "All named cases", caption, top, panels))
}
