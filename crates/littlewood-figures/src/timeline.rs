//! Motions against time: histories of a quantity, verticals at the transitions, names of phases and transitions.

use littlewood::{Phase, Sample, Trajectory, Transition};
use littlewood_draw::{FAINT, Label, Layer, Mark, PlotAxis, SMALL, SOFT, Scale, Series, Stroke};
use littlewood_style::Dash;
use littlewood_style::width::FINE;

use crate::columns::TIME;
use crate::motion::{bounds, horizon, instants};
use crate::wording::Wording;

/// Room for the name of a transition.
const NAME: f64 = 40.0;
/// Verticals that are closer together than this part of the time are one.
const APART: f64 = 1.0 / 150.0;
/// Distance of panels that share the axis below them.
pub(crate) const CLOSE: f64 = 14.0;

/// A quantity along a motion, a piece for each phase where it is defined.
pub(crate) fn history(
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
            instants(motion, phase, until)
                .iter()
                .filter_map(|sample| Some(vec![sample.state.time, value(phase, sample)?]))
                .collect::<Vec<_>>()
        })
        .filter(|piece| piece.len() > 1)
        .collect();
    Series::new(name, &[TIME, column], pieces)
}

pub(crate) fn range_of(series: &[&Series], also: &[f64]) -> [f64; 2] {
    let values = series.iter().flat_map(|series| series.rows().map(|row| row[1]));
    bounds(values.chain(also.iter().copied()), 0.12)
}

/// Verticals at the transitions; of bounces that are closer together than can be seen only the first.
pub(crate) fn transitions(motion: &Trajectory, axis: &PlotAxis, name: &'static str) -> Layer {
    let until = horizon(motion);
    let apart = APART * (until - motion.start().time);
    let mut last = f64::NEG_INFINITY;
    let pieces = motion
        .transitions()
        .iter()
        .filter(|transition| {
            let is_drawn = !transition.is_bounce() || transition.time() - last > apart;
            if is_drawn {
                last = transition.time();
            }
            is_drawn
        })
        .map(Transition::time)
        .filter(|time| *time < until)
        .map(|time| axis.range.map(|value| vec![time, value]).to_vec())
        .collect();
    Series::new("transition", &[TIME, name], pieces)
        .drawn(Mark::Line(Stroke::solid(FAINT, FINE).dashed(Dash::Dashed)))
}

/// Names over a panel.
pub(crate) struct Names {
    pub(crate) labels: Vec<Label>,
    /// Room that they take beyond one row of transitions.
    pub(crate) height: f64,
    /// Whether there was no room for some.
    are_all: bool,
}

/// Rows of names of transitions above each other, and their distance.
const ROWS: usize = 3;
const ROW: f64 = 13.0;

/// The names of the phases over a panel, and of the transitions above them, in as many rows as it takes.
pub(crate) fn names(motion: &Trajectory, top: f64, width: f64) -> Names {
    let (from, until) = (motion.start().time, horizon(motion));
    let pixels = |time: f64| (time - from) / (until - from) * width;
    let mut labels: Vec<Label> = Vec::new();
    for phase in motion.phases() {
        let (begin, end) = (phase.start().time, f64::min(phase.end_time(), until));
        if pixels(end) - pixels(begin) > 46.0 {
            labels.push(
                Label::new(phase.mode().name(), &[0.5 * (begin + end), top]).shifted(0.0, -11.0).sized(SMALL),
            );
        }
    }
    // Bounces have a name only where there is room beside all others.
    let (bounces, others): (Vec<&Transition>, Vec<&Transition>) =
        motion.transitions().iter().partition(|transition| transition.is_bounce());
    // More than these cannot be told apart in any number of rows.
    let count = motion.transitions().iter().filter(|transition| transition.time() <= until).count();
    let rows = if count as f64 > ROWS as f64 * width / NAME { 1 } else { ROWS };
    let mut taken = vec![Vec::new(); rows];
    let mut are_all = true;
    for transition in others.into_iter().chain(bounces) {
        let at = transition.time();
        let room = if transition.is_bounce() { 1.4 * NAME } else { NAME };
        if at > until {
            continue;
        }
        let is_free = |row: &Vec<f64>| row.iter().all(|place| (pixels(at) - place).abs() > room);
        let Some(row) = taken.iter().position(is_free) else {
            are_all = false;
            continue;
        };
        taken[row].push(pixels(at));
        let label = Label::new(transition.cause.label(), &[at, top]).sized(SMALL).coloured(SOFT);
        let label = label.shifted(0.0, -27.0 - ROW * row as f64);
        labels.push(if width - pixels(at) < 24.0 { label.right() } else { label });
    }
    let rows = taken.iter().filter(|row| !row.is_empty()).count();
    Names { labels, height: ROW * rows.saturating_sub(1) as f64, are_all }
}

impl Names {
    pub(crate) fn in_words(&self) -> &'static str {
        if self.are_all {
            "dashed verticals: transitions"
        } else {
            "dashed verticals: transitions, named where there is room"
        }
    }
}

/// An axis of times without words, for a panel above another.
pub(crate) fn bare(say: Wording, range: [f64; 2]) -> PlotAxis {
    PlotAxis { title: String::new(), scale: Scale::Bare, ..say.clock(range) }
}

/// A horizontal line.
pub(crate) fn level(range: [f64; 2], name: &str, column: &'static str, value: f64, stroke: Stroke) -> Layer {
    Series::of_rows(name, &[TIME, column], range.map(|time| vec![time, value]).to_vec())
        .drawn(Mark::Line(stroke))
}

pub(crate) fn zero(range: [f64; 2], column: &'static str) -> Layer {
    level(range, "zero", column, 0.0, Stroke::solid(FAINT, FINE))
}
