//! Small pictures of motions, all on one scale: the path of the mass centre and the hoop at some
//! instants.

use core::f64::consts::TAU;

use littlewood::{Mode, Sample};
use littlewood_draw::{
    Content, Dash, HATCH, INK, Label, Layer, Mark, Panel, PanelFrame, PlotAxis, SMALL, Series,
    Sheet, Stroke,
};
use littlewood_style::width::{CURVE, FINE};

use crate::columns::{TIME, X, Y};
use crate::motion::{Shown, bounds, hoops};

/// Instants of a path, and of the hoop.
const INSTANTS: usize = 160;
const HOOPS: usize = 4;
/// Turns of a motion that are shown at most.
const TURNS: f64 = 3.0;
/// Height of the plane in the picture, in radii.
const GROUND: f64 = 0.3;

/// The samples of a motion that are shown, whose centre goes so many radii at most.
fn samples(motion: &Shown, farthest: f64) -> Vec<Sample> {
    let from = motion.start();
    let far = |sample: &Sample| {
        (sample.centre.x - from.x).abs() > farthest
            || (sample.state.theta - from.theta).abs() > TURNS * TAU
    };
    let until = motion
        .sample_evenly(INSTANTS, motion.until)
        .find(far)
        .map_or(motion.until, |sample| sample.state.time);
    let finite =
        |sample: &Sample| sample.centre.x.is_finite() && sample.state.theta_rate.is_finite();
    motion
        .sample_evenly(INSTANTS, until)
        .filter(finite)
        .collect()
}

/// The path of the mass centre: for each mode the runs of its samples, each with the first of the
/// next.
fn path(samples: &[Sample]) -> Vec<Layer> {
    let mut found: Vec<(Mode, Vec<&[Sample]>)> = Vec::new();
    let mut begin = 0;
    for run in samples.chunk_by(|a, b| a.mode == b.mode) {
        let end = (begin + run.len() + 1).min(samples.len());
        let piece = &samples[begin..end];
        begin += run.len();
        match found.iter_mut().find(|(mode, _)| *mode == run[0].mode) {
            Some((_, pieces)) => pieces.push(piece),
            None => found.push((run[0].mode, vec![piece])),
        }
    }
    let row = |sample: &Sample| {
        let centre = sample.mass_centre;
        [sample.state.time, centre.x, centre.y]
    };
    let layer = |(mode, pieces): (Mode, Vec<&[Sample]>)| {
        let pieces = pieces.into_iter().map(|piece| piece.iter().map(row));
        Series::new(format!("mass centre, {mode}"), &[TIME, X, Y], pieces)
            .drawn(Stroke::of_mode(mode).wide(CURVE))
    };
    found.into_iter().map(layer).collect()
}

/// The picture of a motion in a frame of its panel, so many pixels to a radius, with a title.
pub(crate) fn picture(motion: &Shown, frame: PanelFrame, unit: f64, title: &str) -> Panel {
    let (wide, high) = (frame.width / unit, frame.height / unit);
    let samples = samples(motion, wide - 2.4);
    let [left, right] = bounds(samples.iter().map(|sample| sample.centre.x), 0.0);
    let middle = 0.5 * (left + right);
    let x @ [left, right] = [middle - 0.5 * wide, middle + 0.5 * wide];
    let y @ [low, top] = [-GROUND, high - GROUND];
    let below = [[left, 0.0], [right, 0.0], [right, low], [left, low]];
    let mut layers = vec![
        Series::of_rows("ground", &[X, Y], below).drawn(Mark::Hatch(HATCH)),
        Series::of_rows("ground", &[X, Y], x.map(|x| [x, 0.0])).drawn(Stroke::solid(INK, FINE)),
    ];
    // Whole hoops only.
    let is_whole = |Sample { centre, .. }: &&Sample| {
        centre.x - 1.0 >= left && centre.x + 1.0 <= right && centre.y + 1.0 <= top
    };
    let step = (samples.len().saturating_sub(1)).max(1) / HOOPS;
    let shown = samples.iter().step_by(step.max(1)).filter(is_whole);
    for mode in Mode::ALL {
        let mut own = shown.clone().filter(|it| it.mode == mode).peekable();
        if own.peek().is_some() {
            let rim = Stroke::of_mode(mode).dashed(Dash::Solid).wide(FINE);
            layers.push(hoops(motion.hoop(), own, format!("hoop, {mode}"), rim));
        }
    }
    layers.extend(path(&samples));
    let title = Label::new(title, &[left, top]).left().shifted(6.0, 10.0);
    let content = Content {
        name: "motion",
        x: PlotAxis::silent(X, x),
        y: PlotAxis::silent(Y, y),
        layers,
        labels: vec![title.sized(SMALL)],
    };
    Sheet::panel(frame, content)
}
