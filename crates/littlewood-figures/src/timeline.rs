//! Motions against time: histories of a quantity, verticals at the transitions, names of phases and
//! transitions.

use littlewood::{Phase, Sample, Trajectory, Transition};
use littlewood_draw::{FAINT, Label, Layer, PlotAxis, SMALL, SOFT, Scale, Series, Stroke, width};
use littlewood_style::Dash;
use littlewood_style::width::FINE;

use crate::columns::TIME;
use crate::motion::{bounds, horizon, instants};
use crate::wording::Wording;

/// Room for the name of a transition, and between two names.
const NAME: f64 = 40.0;
const BETWEEN: f64 = 6.0;
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
    let values = series
        .iter()
        .flat_map(|series| series.rows().map(|row| row[1]));
    bounds(values.chain(also.iter().copied()), 0.12)
}

/// A line at a time.
pub(crate) const VERTICAL: Stroke = Stroke::solid(FAINT, FINE).dashed(Dash::Dashed);

/// Verticals at the transitions; of bounces that are closer together than can be seen only the
/// first.
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
    Series::new("transition", &[TIME, name], pieces).drawn(VERTICAL)
}

/// Names over a panel.
pub(crate) struct Names {
    pub(crate) labels: Vec<Label>,
    /// Room that they take beyond one row of transitions.
    pub(crate) height: f64,
    /// Whether all phases have one, and all transitions.
    are_all: [bool; 2],
}

/// Rows of names of transitions above each other, and their distance.
const ROWS: usize = 3;
const ROW: f64 = 13.0;

/// The names of the phases over a panel, and of the transitions above them, in as many rows as it
/// takes.
pub(crate) fn names(motion: &Trajectory, top: f64, wide: f64) -> Names {
    let (from, until) = (motion.start().time, horizon(motion));
    let pixels = |time: f64| (time - from) / (until - from) * wide;
    let name = |text: &str, at: f64| Label::new(text, &[at, top]).sized(SMALL).fixed();
    let mut labels: Vec<Label> = Vec::new();
    let mut are_all = [true; 2];
    for phase in motion.phases() {
        let (begin, end) = (phase.start().time, f64::min(phase.end_time(), until));
        let text = phase.mode().name();
        if pixels(end) - pixels(begin) > width(text, SMALL) + BETWEEN {
            labels.push(name(text, 0.5 * (begin + end)).shifted(0.0, -11.0));
        } else {
            are_all[0] &= begin >= until;
        }
    }
    // Bounces have a name only where there is room beside all others.
    let (bounces, others): (Vec<&Transition>, Vec<&Transition>) = motion
        .transitions()
        .iter()
        .partition(|transition| transition.is_bounce());
    // More than these cannot be told apart in any number of rows.
    let count = motion
        .transitions()
        .iter()
        .filter(|transition| transition.time() <= until)
        .count();
    let rows = if count as f64 > ROWS as f64 * wide / NAME {
        1
    } else {
        ROWS
    };
    let mut taken: Vec<Vec<[f64; 2]>> = vec![Vec::new(); rows];
    for transition in others.into_iter().chain(bounces) {
        let at = transition.time();
        if at > until {
            continue;
        }
        let text = transition.cause.label();
        let room = width(text, SMALL);
        // A name does not reach out of the panel.
        let middle = f64::max(pixels(at).min(wide - 0.5 * room), 0.5 * room);
        let ends = [middle - 0.5 * room - BETWEEN, middle + 0.5 * room + BETWEEN];
        let is_free = |row: &Vec<[f64; 2]>| {
            row.iter()
                .all(|other| ends[1] < other[0] || other[1] < ends[0])
        };
        let Some(row) = taken.iter().position(is_free) else {
            are_all[1] = false;
            continue;
        };
        taken[row].push([middle - 0.5 * room, middle + 0.5 * room]);
        let label = name(text, at).coloured(SOFT);
        labels.push(label.shifted(middle - pixels(at), -27.0 - ROW * row as f64));
    }
    let rows = taken.iter().filter(|row| !row.is_empty()).count();
    Names {
        labels,
        height: ROW * rows.saturating_sub(1) as f64,
        are_all,
    }
}

impl Names {
    /// What a figure notes of phases and transitions without a name.
    pub(crate) fn note(&self) -> Option<String> {
        let which = match self.are_all {
            [true, true] => return None,
            [false, true] => "phases",
            [true, false] => "transitions",
            [false, false] => "phases and transitions",
        };
        Some(format!("There is no room for the names of all {which}."))
    }
}

/// An axis of times without words, for a panel above another.
pub(crate) fn bare(say: Wording, range: [f64; 2]) -> PlotAxis {
    PlotAxis {
        title: String::new(),
        scale: Scale::Bare,
        ..say.clock(range)
    }
}

/// A horizontal line.
pub(crate) fn level(
    range: [f64; 2],
    name: &str,
    column: &'static str,
    value: f64,
    stroke: Stroke,
) -> Layer {
    Series::of_rows(
        name,
        &[TIME, column],
        range.map(|time| vec![time, value]).to_vec(),
    )
    .drawn(stroke)
}

pub(crate) fn zero(range: [f64; 2], column: &'static str) -> Layer {
    level(range, "zero", column, 0.0, Stroke::solid(FAINT, FINE))
}
