//! Motions against time: histories of a quantity, verticals at the transitions, names of phases and
//! transitions.

use littlewood::{Phase, Sample, Transition};
use littlewood_draw::{
    Content, Entries, FAINT, Figure, Label, Layer, Panel, PanelFrame, PlotAxis, ROOM, Range, SMALL,
    SOFT, Scale, Series, Sheet, Stroke, seen, width,
};
use littlewood_style::Dash;
use littlewood_style::width::FINE;

use crate::columns::TIME;
use crate::motion::{Shown, bounds};

/// Room for the name of a transition, and between two names.
const NAME: f64 = 40.0;
const BETWEEN: f64 = 6.0;
/// Verticals that are closer together than this part of the time are one.
const APART: f64 = 1.0 / 150.0;
/// Distance of panels that share the axis below them.
pub(crate) const CLOSE: f64 = 14.0;
/// Rows of names of transitions above each other, and their distance.
const ROWS: usize = 3;
const ROW: f64 = 13.0;

/// Most times that the same name of a transition stands where there is no room for all.
const REPEATED: usize = 3;

/// A line at a time.
pub(crate) const VERTICAL: Stroke = Stroke::solid(FAINT, FINE).dashed(Dash::Dashed);

/// The words and the panels of a figure of a motion against time.
pub(crate) struct Timeline<'a> {
    pub(crate) name: &'static str,
    pub(crate) title: &'static str,
    pub(crate) caption: String,
    pub(crate) keys: Entries,
    /// From top to bottom; the last has the axis of times.
    pub(crate) contents: Vec<Content>,
    /// The height of each, by its place.
    pub(crate) height: &'a dyn Fn(usize) -> f64,
}

impl Shown {
    /// A quantity along the motion, a piece for each phase where it is defined.
    pub(crate) fn history(
        &self,
        name: &str,
        column: &'static str,
        value: impl Fn(&Phase, &Sample) -> Option<f64>,
    ) -> Series {
        let piece = |phase: &Phase| {
            let samples = self.instants(phase);
            let row = |sample: &Sample| Some([sample.state.time, value(phase, sample)?]);
            samples.iter().filter_map(row).collect::<Vec<_>>()
        };
        let pieces = self.phases().iter().map(piece);
        Series::new(
            name,
            &[TIME, column],
            pieces.filter(|piece| piece.len() > 1),
        )
    }

    /// A panel without the axis of times.
    pub(crate) fn panel(
        &self,
        name: &'static str,
        y: PlotAxis,
        layers: Vec<Layer>,
        labels: Vec<Label>,
    ) -> Content {
        Content {
            name,
            x: PlotAxis {
                title: String::new(),
                scale: Scale::Bare,
                ..self.say.clock(self.times().into())
            },
            y,
            layers,
            labels,
        }
    }

    /// A figure of panels below each other, with keys and the names of phases and transitions
    /// above.
    pub(crate) fn figure(&self, sheet: &Sheet, timeline: Timeline<'_>) -> Figure {
        let Timeline {
            name,
            title,
            caption,
            keys,
            mut contents,
            height,
        } = timeline;
        let [left, inner] = sheet.span();
        let keys = seen(keys, &contents, 0.0);
        let beside_keys = if keys.is_empty() { 38.0 } else { 42.0 };
        let (keys, room) = sheet.keys(keys, 6.0);
        let names = self.names(contents[0].y.range.to, inner - ROOM[0]);
        contents[0].labels.splice(0..0, names.labels);
        if let Some(last) = contents.last_mut() {
            last.x = self.say.clock(self.times().into());
        }
        let mut top = room + beside_keys + names.height;
        let mut bottom = top;
        let mut panels: Vec<Panel> = Vec::new();
        for (i, content) in contents.into_iter().enumerate() {
            let high = height(i);
            panels.push(Sheet::panel(
                PanelFrame {
                    left,
                    top,
                    width: inner,
                    height: high,
                },
                content,
            ));
            bottom = top + high;
            top = bottom - ROOM[1] + CLOSE;
        }
        panels[0].keys = keys;
        sheet
            .figure(name, title, caption, bottom + 6.0, panels)
            .noted(names.note)
            .noted(self.finer())
            .noted(self.remark())
    }

    /// Verticals at the transitions; of bounces that are closer together than can be seen only the
    /// first.
    pub(crate) fn verticals(&self, axis: &PlotAxis, column: &'static str) -> Layer {
        let apart = APART * (self.until - self.start().time);
        let mut last = f64::NEG_INFINITY;
        let mut times: Vec<f64> = Vec::new();
        for transition in self.transitions() {
            let time = transition.time();
            if !transition.is_bounce() || time - last > apart {
                last = time;
                times.extend(Some(time).filter(|time| *time < self.until));
            }
        }
        let pieces = times
            .into_iter()
            .map(|time| axis.range.ends().map(|value| [time, value]));
        Series::new("transition", &[TIME, column], pieces).drawn(VERTICAL)
    }

    /// Verticals at the transitions, and a line at zero.
    pub(crate) fn ground(&self, axis: &PlotAxis, column: &'static str) -> Vec<Layer> {
        vec![self.verticals(axis, column), self.zero(column)]
    }

    /// A horizontal line.
    pub(crate) fn level(
        &self,
        name: &str,
        column: &'static str,
        value: f64,
        stroke: Stroke,
    ) -> Layer {
        let rows = self.times().map(|time| [time, value]);
        Series::of_rows(name, &[TIME, column], rows).drawn(stroke)
    }

    pub(crate) fn zero(&self, column: &'static str) -> Layer {
        self.level("zero", column, 0.0, Stroke::solid(FAINT, FINE))
    }

    /// The names of the phases over a panel, and of the transitions above them, in as many rows as
    /// it takes.
    fn names(&self, top: f64, wide: f64) -> Names {
        let [from, until] = self.times();
        let across = Across {
            pixels: &|time: f64| (time - from) / (until - from) * wide,
            top,
            wide,
        };
        let (mut labels, phases) = self.names_of_phases(&across);
        let each = self.names_of_transitions(&across, usize::MAX);
        // Where they have no room, one that repeats itself stands once.
        let (of_transitions, rows, transitions) = if each.2 == 0 {
            each
        } else {
            self.names_of_transitions(&across, REPEATED)
        };
        labels.extend(of_transitions);
        let counted = [(phases, "phase"), (transitions, "transition")];
        let without = counted.into_iter().filter(|(count, _)| *count > 0);
        let without: Vec<String> = without
            .map(|(count, what)| format!("{count} {what}{}", if count == 1 { "" } else { "s" }))
            .collect();
        Names {
            labels,
            height: ROW * rows.saturating_sub(1) as f64,
            note: (!without.is_empty()).then(|| {
                format!(
                    "There is no room for the names of {}.",
                    without.join(" and ")
                )
            }),
        }
    }

    /// And how many have none.
    fn names_of_phases(&self, across: &Across<'_>) -> (Vec<Label>, usize) {
        let (mut labels, mut without) = (Vec::new(), 0);
        for phase in self.phases() {
            let begin = phase.start().time;
            let end = f64::min(phase.end_time(), self.until);
            let text = phase.mode().name();
            let room = (across.pixels)(end) - (across.pixels)(begin);
            if room > width(text, SMALL) + BETWEEN {
                labels.push(across.name(text, 0.5 * (begin + end)).shifted(0.0, -11.0));
            } else {
                without += usize::from(begin < self.until);
            }
        }
        (labels, without)
    }

    /// Of bounces only where there is room beside all others, and of a name that repeats itself more
    /// often than `most` the first, with how many there are; with the number of rows, and how many
    /// have none.
    fn names_of_transitions(&self, across: &Across<'_>, most: usize) -> (Vec<Label>, usize, usize) {
        let Across { pixels, wide, .. } = *across;
        // More than these cannot be told apart in any number of rows.
        let are_many = self.passed().count() as f64 > ROWS as f64 * wide / NAME;
        let mut taken: Vec<Vec<[f64; 2]>> = vec![Vec::new(); if are_many { 1 } else { ROWS }];
        let (bounces, others): (Vec<&Transition>, Vec<&Transition>) =
            self.passed().partition(|transition| transition.is_bounce());
        let (mut labels, mut without) = (Vec::new(), 0);
        let mut counted: Vec<&str> = Vec::new();
        for transition in others.into_iter().chain(bounces) {
            let (at, name) = (transition.time(), transition.cause.label());
            if counted.contains(&name) {
                continue;
            }
            let count = self
                .passed()
                .filter(|other| other.cause.label() == name)
                .count();
            let text = if count > most {
                counted.push(name);
                &format!("{count} × {name}")
            } else {
                name
            };
            let room = width(text, SMALL);
            // A name does not reach out of the panel.
            let middle = f64::max(pixels(at).min(wide - 0.5 * room), 0.5 * room);
            let ends = [middle - 0.5 * room - BETWEEN, middle + 0.5 * room + BETWEEN];
            let is_free = |row: &Vec<[f64; 2]>| {
                row.iter()
                    .all(|other| ends[1] < other[0] || other[1] < ends[0])
            };
            let Some(row) = taken.iter().position(is_free) else {
                without += if count > most { count } else { 1 };
                continue;
            };
            taken[row].push([middle - 0.5 * room, middle + 0.5 * room]);
            let label = across.name(text, at).coloured(SOFT);
            labels.push(label.shifted(middle - pixels(at), -27.0 - ROW * row as f64));
        }
        let rows = taken.iter().filter(|row| !row.is_empty()).count();
        (labels, rows, without)
    }
}

/// Names over a panel.
struct Names {
    labels: Vec<Label>,
    /// Room that they take beyond one row of transitions.
    height: f64,
    /// What a figure notes of phases and transitions without a name.
    note: Option<String>,
}

/// Where names stand over a panel.
struct Across<'a> {
    /// Of a time, from the left end.
    pixels: &'a dyn Fn(f64) -> f64,
    /// The value at the upper end.
    top: f64,
    wide: f64,
}

impl Across<'_> {
    fn name(&self, text: &str, at: f64) -> Label {
        Label::new(text, &[at, self.top]).sized(SMALL).fixed()
    }
}

pub(crate) fn range_of<'a>(series: impl IntoIterator<Item = &'a Series>, also: &[f64]) -> Range {
    let values = series
        .into_iter()
        .flat_map(|series| series.rows().map(|row| row[1]));
    bounds(values.chain(also.iter().copied()), 0.12).into()
}
