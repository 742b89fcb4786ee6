//! The last step of a figure: ticks as many as there is room for, labels beside each other.

use littlewood_style::ticks::{self, Tick};

use littlewood_style::Rgb;

use crate::chart::room_for_notes;
use crate::figure::{Figure, Label, Layer, Mark, Panel, PanelFrame, PlotAxis, Scale, Series, View};
use crate::letters::width;
use crate::place::place;
use crate::primitives::Range;
use crate::space::length_of;
use crate::stroke::{SMALL, Stroke};
use crate::words::short;

/// Most ticks of an axis, and the least room between their labels in pixels.
const MOST: usize = 9;
const BESIDE: f64 = 12.0;
const ABOVE: f64 = 12.0;
/// Widest label of an axis upwards.
const UPRIGHT: f64 = 40.0;
/// Pixels to a tick of an axis to the right, and of one upwards.
const EACH: [f64; 2] = [60.0, 30.0];
/// The same of three axes, which are shorter.
const IN_SPACE: f64 = 36.0;

impl Figure {
    /// Completes a figure: ticks as many as there is room for, marks where data leave their axes,
    /// labels where they hide nothing. What there is no room for, and what else was left out, stands
    /// below the panels and in the caption.
    #[must_use]
    pub fn fitted(mut self) -> Self {
        let mut left_out: Vec<String> = Vec::new();
        for panel in &mut self.panels {
            let PanelFrame {
                width: across,
                height: upwards,
                ..
            } = panel.frame;
            let [[left, top], [right, bottom]] = panel.axes_frame();
            match &mut panel.view {
                View::Plane { x, y, .. } => {
                    fit(x, right - left, true, EACH[0]);
                    fit(y, bottom - top, false, EACH[1]);
                }
                View::Space {
                    x,
                    y,
                    z,
                    yaw,
                    pitch,
                } => {
                    let length = length_of(across, upwards);
                    fit(x, length * libm::cos(*yaw).abs(), true, IN_SPACE);
                    fit(y, length * libm::cos(*pitch).abs(), false, IN_SPACE);
                    fit(z, length * libm::sin(*yaw).abs(), true, IN_SPACE);
                    // Two edges meet in a corner, which has no room for the ticks of both.
                    for (axis, end) in [(x, 0.08), (z, 0.12)] {
                        let own = axis.clone();
                        axis.ticks
                            .retain(|tick| (end..=1.0 - end).contains(&own.share(tick.value)));
                    }
                }
            }
            let beyond = beyond(panel);
            panel.layers.extend(beyond.0);
            // Numbers that were cut come before names.
            panel.labels.splice(0..0, beyond.1);
            left_out.extend(
                place(panel, self.width, self.height)
                    .into_iter()
                    .map(|label| label.text),
            );
        }
        self.notes.extend(no_room(&left_out));
        for note in &self.notes {
            self.caption += " ";
            self.caption += note;
        }
        self.height += room_for_notes(&self);
        self
    }
}

/// Names in a note of those that have no room.
const NAMED: usize = 8;

/// What a figure notes of names without room: how many, and each that is another once.
fn no_room(names: &[String]) -> Option<String> {
    let mut others: Vec<&str> = Vec::new();
    for name in names {
        if !others.contains(&name.as_str()) {
            others.push(name);
        }
    }
    let and_more = if others.len() > NAMED { ", …" } else { "" };
    others.truncate(NAMED);
    let others = others.join(", ");
    match names.len() {
        0 => None,
        1 => Some(format!("There is no room for the name {others}.")),
        count => Some(format!(
            "There is no room for {count} names: {others}{and_more}."
        )),
    }
}

/// Where a curve is farthest out of the axes, on one side: its colour, and its value there.
#[derive(Clone, Copy)]
struct Farthest {
    across: f64,
    value: f64,
    colour: Rgb,
}

impl Farthest {
    /// The value at the edge of the axes that it leaves.
    fn label(self, range: Range) -> Label {
        let (edge, down) = if self.value > range.to {
            (range.to, 9.0)
        } else {
            (range.from, -9.0)
        };
        let text = if self.value.is_infinite() {
            if self.value > 0.0 { "∞" } else { "−∞" }.to_owned()
        } else {
            short(self.value)
        };
        let label = Label::new(text, &[self.across, edge]).sized(SMALL);
        label.coloured(self.colour).left().shifted(7.0, down)
    }
}

/// The rows of a series, by its two columns, that are farthest out of the axes: of each part of it
/// that is out on one side one.
fn out_of(series: &Series, x: &PlotAxis, y: &PlotAxis) -> Vec<[f64; 2]> {
    let (Some(across), Some(up)) = (series.column(&x.column), series.column(&y.column)) else {
        return Vec::new();
    };
    let Range {
        from: low,
        to: high,
    } = y.range;
    let is_out = |row: &[f64]| row[up] < low || row[up] > high;
    let is_seen = |row: &&Vec<f64>| x.range.contains(row[across]);
    let parts = series.pieces.iter().flat_map(|piece| {
        piece.chunk_by(|a, b| is_out(a) && is_out(b) && (a[up] > high) == (b[up] > high))
    });
    let farthest = parts.filter_map(|part| {
        let rows = part.iter().filter(|row| is_out(row)).filter(is_seen);
        rows.max_by(|a, b| a[up].abs().total_cmp(&b[up].abs()))
    });
    farthest.map(|row| [row[across], row[up]]).collect()
}

/// Marks where curves leave the axes of a panel above and below, with the value that is farthest
/// out on either side.
fn beyond(panel: &Panel) -> (Vec<Layer>, Vec<Label>) {
    let View::Plane { x, y, .. } = &panel.view else {
        return Default::default();
    };
    // Below and above.
    let mut farthest: [Option<Farthest>; 2] = [None; 2];
    let mut layers = Vec::new();
    for layer in panel.layers.iter().filter(|layer| layer.is_marked_beyond) {
        let Mark::Line(Stroke { colour, .. }) = layer.mark else {
            continue;
        };
        let rows = out_of(&layer.series, x, y);
        for &[across, value] in &rows {
            let side = &mut farthest[usize::from(value > y.range.to)];
            if side.is_none_or(|side| value.abs() > side.value.abs()) {
                *side = Some(Farthest {
                    across,
                    value,
                    colour,
                });
            }
        }
        if !rows.is_empty() {
            let series = Series {
                name: format!("{} beyond the axis", layer.series.name),
                columns: vec![x.column.clone(), y.column.clone()],
                pieces: vec![rows.into_iter().map(Vec::from).collect()],
            };
            layers.push(series.drawn(Mark::Beyond(colour)));
        }
    }
    let labels = farthest.into_iter().flatten().map(|it| it.label(y.range));
    (layers, labels.collect())
}

/// As many ticks as an axis of so many pixels has room for.
fn fit(axis: &mut PlotAxis, pixels: f64, to_the_right: bool, each: f64) {
    // A low panel may have room for more than one beside its end.
    let fewest = if to_the_right { 2 } else { 4 };
    let most = (libm::floor(pixels / each) as usize).clamp(fewest, MOST);
    let bent = axis.clone();
    let place = |value: f64| bent.share(value);
    let apart = |a: &Tick, b: &Tick| {
        let distance = (place(b.value) - place(a.value)) * pixels;
        let needed = if to_the_right {
            0.5 * (width(&a.label, SMALL) + width(&b.label, SMALL)) + BESIDE
        } else {
            SMALL + ABOVE
        };
        distance.abs() >= needed
    };
    let fits = |ticks: &[Tick]| ticks.windows(2).all(|pair| apart(&pair[0], &pair[1]));
    let candidates: Vec<Vec<Tick>> = (1..=most)
        .rev()
        .map(|count| choices(axis, count))
        .filter(|ticks| fits(ticks))
        .collect();
    let is_short = |ticks: &&Vec<Tick>| {
        to_the_right || ticks.iter().all(|it| width(&it.label, SMALL) <= UPRIGHT)
    };
    let Some(found) = candidates.iter().find(is_short).or(candidates.first()) else {
        return;
    };
    let mut found = found.clone();
    if !is_short(&&found) {
        // Numbers that hardly differ are told from one of them.
        let Tick { value: base, label } = found[found.len() / 2].clone();
        found
            .iter_mut()
            .for_each(|tick| tick.label = short(tick.value - base));
        let sign = if base < 0.0 { "+" } else { "−" };
        // The number of the tick has its digits, and none of rounding.
        let number = label.trim_start_matches('−');
        let number = if number.contains('.') {
            number.trim_end_matches('0').trim_end_matches('.')
        } else {
            number
        };
        let from = format!(" {sign} {number}");
        let at = axis.title.find("  (").unwrap_or(axis.title.len());
        axis.title.insert_str(at, &from);
    }
    if let Scale::Angle(own) = &axis.scale {
        found.retain(|tick| own.iter().all(|other| apart(tick, other)));
        found.extend(own.iter().cloned());
        found.sort_by(|a, b| a.value.total_cmp(&b.value));
    }
    axis.ticks = found;
}

/// At most about so many ticks.
fn choices(axis: &PlotAxis, count: usize) -> Vec<Tick> {
    let Range { from, to } = axis.range;
    match &axis.scale {
        Scale::Round if axis.linear.is_finite() => symmetric(axis, count),
        Scale::Round => ticks::round(from, to, count),
        Scale::NotNegative => {
            let mut ticks = ticks::round(from, to, count);
            ticks.retain(|tick| tick.value >= 0.0);
            ticks
        }
        Scale::Whole => ticks::round(from, to, count.min((to - from) as usize).max(1)),
        Scale::Angle(_) => ticks::angular(from, to, count),
        Scale::Decades => decades(from, to, count),
        Scale::Given(ticks) => {
            let each = ticks.len().div_ceil(count);
            ticks.iter().step_by(each.max(1)).cloned().collect()
        }
        Scale::Bare => ticks::round(from, to, count)
            .into_iter()
            .map(|tick| Tick {
                label: String::new(),
                value: tick.value,
            })
            .collect(),
        Scale::Nothing => Vec::new(),
    }
}

/// Zero, and on either side of it as many as there may be of 1, 2 and 5, or 1 and 3, or 1 of each
/// decade, or 1 of some, down to where the axis begins to be linear.
fn symmetric(axis: &PlotAxis, most: usize) -> Vec<Tick> {
    let Range { from, to } = axis.range;
    let least = libm::log10(axis.linear);
    let last = libm::floor(libm::log10(f64::max(from.abs(), to.abs()))) as i32;
    let sides = (most.saturating_sub(1) / 2).max(1);
    let sizes = |first: i32, every: usize, factors: &[f64]| -> Vec<f64> {
        let decades = (first..=last).rev().step_by(every);
        decades
            .flat_map(|power| {
                factors
                    .iter()
                    .map(move |factor| factor * libm::exp10(f64::from(power)))
            })
            .filter(|size| *size <= f64::max(from.abs(), to.abs()))
            .collect()
    };
    let firsts = [libm::floor(least) as i32, libm::ceil(least) as i32];
    let full = firsts.into_iter().flat_map(|first| {
        [&[1.0, 2.0, 5.0][..], &[1.0, 3.0], &[1.0]].map(|factors| sizes(first, 1, factors))
    });
    let found = full
        .filter(|sizes| (1..=sides).contains(&sizes.len()))
        .max_by_key(Vec::len);
    let found = found.unwrap_or_else(|| {
        let every = (last - firsts[1] + 1).max(1) as usize;
        sizes(firsts[1].min(last), every.div_ceil(sides), &[1.0])
    });
    let mut values: Vec<f64> = found
        .into_iter()
        .flat_map(|size| [-size, size])
        .chain([0.0])
        .collect();
    values.sort_by(f64::total_cmp);
    let seen = values
        .into_iter()
        .filter(|value| (from..=to).contains(value));
    seen.map(|value| Tick {
        value,
        label: short(value),
    })
    .collect()
}

/// Powers of ten; within few of them their double and five times as much, too.
fn decades(from: f64, to: f64, most: usize) -> Vec<Tick> {
    let (first, last) = (libm::ceil(from) as i32, libm::floor(to) as i32);
    if last - first < 2 && most > 3 {
        return (first - 1..=last)
            .flat_map(|power| {
                [1.0, 2.0, 5.0].map(|factor| factor * libm::pow(10.0, f64::from(power)))
            })
            .map(|rate| Tick {
                value: libm::log10(rate),
                label: short(rate),
            })
            .filter(|tick| (from..=to).contains(&tick.value))
            .collect();
    }
    let each = (last - first).max(0) as usize / most + 1;
    (first..=last)
        .rev()
        .step_by(each)
        .map(|power| {
            let label = format!("10^{{{}}}", ticks::minus(&power.to_string()));
            Tick {
                value: f64::from(power),
                label,
            }
        })
        .collect()
}
