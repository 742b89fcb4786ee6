//! Small pictures of motions, all on one scale: the path of the mass centre and the hoop at some
//! instants.

use core::f64::consts::TAU;

use littlewood::{Mode, Sample, Trajectory};
use littlewood_draw::{
    Content, Dash, HATCH, INK, Label, Mark, Panel, Piece, PlotAxis, SMALL, Series, Sheet, Stroke,
};
use littlewood_style::width::{CURVE, FINE};

use crate::columns::{TIME, X, Y};
use crate::motion::{bounds, hoops, horizon};

/// Instants of a path, and of the hoop.
const INSTANTS: usize = 160;
const HOOPS: usize = 4;
/// Turns of a motion that are shown at most.
const TURNS: f64 = 3.0;

/// Up to when a motion is shown whose centre goes so many radii at most.
pub(crate) fn end_of(motion: &Trajectory, farthest: f64) -> f64 {
    let until = horizon(motion);
    let from = motion.start();
    let far = |sample: &Sample| {
        (sample.centre.x - from.x).abs() > farthest
            || (sample.state.theta - from.theta).abs() > TURNS * TAU
    };
    motion
        .sample_evenly(INSTANTS, until)
        .find(far)
        .map_or(until, |sample| sample.state.time)
}

/// Pieces of samples of one mode, each with the first of the next.
pub(crate) fn by_mode(
    samples: &[Sample],
    row: impl Fn(&Sample) -> Vec<f64>,
) -> Vec<(Mode, Vec<Piece>)> {
    let mut found: Vec<(Mode, Vec<Piece>)> = Vec::new();
    let mut begin = 0;
    for chunk in samples.chunk_by(|a, b| a.mode == b.mode) {
        let end = (begin + chunk.len() + 1).min(samples.len());
        let piece: Piece = samples[begin..end].iter().map(&row).collect();
        begin += chunk.len();
        match found.iter_mut().find(|(mode, _)| *mode == chunk[0].mode) {
            Some((_, pieces)) => pieces.push(piece),
            None => found.push((chunk[0].mode, vec![piece])),
        }
    }
    found
}

/// The samples of a motion that are shown.
pub(crate) fn samples(motion: &Trajectory, until: f64) -> Vec<Sample> {
    let finite =
        |sample: &Sample| sample.centre.x.is_finite() && sample.state.theta_rate.is_finite();
    motion
        .sample_evenly(INSTANTS, until)
        .filter(finite)
        .collect()
}

/// The picture of a motion, so many pixels to a radius, with a title.
pub(crate) fn picture(
    motion: &Trajectory,
    frame: [f64; 4],
    unit: f64,
    title: Option<String>,
) -> Panel {
    let [_, _, wide, high] = frame;
    let (wide, high) = (wide / unit, high / unit);
    let until = end_of(motion, wide - 2.4);
    let samples = samples(motion, until);
    let [left, right] = bounds(samples.iter().map(|sample| sample.centre.x), 0.0);
    let middle = 0.5 * (left + right);
    let (x, y) = (
        [middle - 0.5 * wide, middle + 0.5 * wide],
        [-0.3, high - 0.3],
    );
    let mut layers = vec![
        Series::of_rows(
            "ground",
            &[X, Y],
            vec![
                vec![x[0], 0.0],
                vec![x[1], 0.0],
                vec![x[1], y[0]],
                vec![x[0], y[0]],
            ],
        )
        .drawn(Mark::Hatch(HATCH)),
        Series::of_rows("ground", &[X, Y], x.map(|x| vec![x, 0.0]).to_vec())
            .drawn(Stroke::solid(INK, FINE)),
    ];
    let step = (samples.len().saturating_sub(1)).max(1) / HOOPS;
    // Whole hoops only.
    let is_whole = |sample: &&Sample| {
        let centre = sample.centre;
        centre.x - 1.0 >= x[0] && centre.x + 1.0 <= x[1] && centre.y + 1.0 <= y[1]
    };
    let shown: Vec<Sample> = samples
        .iter()
        .step_by(step.max(1))
        .filter(is_whole)
        .copied()
        .collect();
    for mode in Mode::ALL {
        let mut own = shown.iter().filter(|sample| sample.mode == mode).peekable();
        if own.peek().is_some() {
            let rim = Stroke::of_mode(mode).dashed(Dash::Solid).wide(FINE);
            layers.push(hoops(motion.hoop(), own, format!("hoop, {mode}"), rim));
        }
    }
    let row = |sample: &Sample| {
        vec![
            sample.state.time,
            sample.mass_centre.x,
            sample.mass_centre.y,
        ]
    };
    for (mode, pieces) in by_mode(&samples, row) {
        let mark = Mark::Line(Stroke::of_mode(mode).wide(CURVE));
        layers.push(Series::new(format!("mass centre, {mode}"), &[TIME, X, Y], pieces).drawn(mark));
    }
    let label = |text| {
        Label::new(text, &[x[0], y[1]])
            .left()
            .shifted(6.0, 10.0)
            .sized(SMALL)
    };
    let labels = title.into_iter().map(label).collect();
    Sheet::panel(
        frame,
        Content {
            name: "motion",
            x: PlotAxis::silent(X, x),
            y: PlotAxis::silent(Y, y),
            layers,
            labels,
        },
    )
}
