//! The last step of a figure: ticks as many as there is room for, labels beside each other.

use littlewood_style::ticks::{self, Tick};

use littlewood_style::Rgb;

use crate::chart::room_for_notes;
use crate::figure::{Figure, Label, Layer, Mark, Panel, PanelFrame, PlotAxis, Scale, Series, View};
use crate::letters::width;
use crate::place::place;
use crate::primitives::Range;
use crate::space::length_of;
use crate::stroke::{LETTER, SMALL, Stroke};
use crate::words::{angle, short};

/// Most ticks of an axis, and the least room between their labels in pixels.
const MOST: usize = 9;
const BESIDE: f64 = 12.0;
const ABOVE: f64 = 9.0;
/// Widest label of an axis upwards, and how far one goes beyond the end of an axis to the right.
const UPRIGHT: f64 = 37.0;
const AFTER: f64 = 20.0;
/// How much longer than its axis the title of an axis upwards may be.
const OVER: f64 = 12.0;
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
        let (mut left_out, mut units): (Vec<String>, Vec<String>) = Default::default();
        for panel in &mut self.panels {
            let PanelFrame {
                width: across,
                height: upwards,
                ..
            } = panel.frame;
            let [[left, top], [right, bottom]] = panel.axes_frame();
            match &mut panel.view {
                View::Plane { x, y, .. } => {
                    fit(
                        x,
                        Extent {
                            pixels: right - left,
                            to_the_right: true,
                            each: EACH[0],
                        },
                    );
                    let symbol = y.title.split(UNIT).next().unwrap_or_default().to_owned();
                    fit(
                        y,
                        Extent {
                            pixels: bottom - top,
                            to_the_right: false,
                            each: EACH[1],
                        },
                    );
                    let unit = without_unit(&mut y.title, bottom - top + OVER);
                    units.extend(
                        unit.filter(|unit| !unit.is_empty())
                            .map(|unit| format!("Unit of {symbol}: {unit}.")),
                    );
                }
                View::Space {
                    x,
                    y,
                    z,
                    yaw,
                    pitch,
                } => {
                    let length = length_of(across, upwards);
                    let along = |share: f64, to_the_right| Extent {
                        pixels: length * share.abs(),
                        to_the_right,
                        each: IN_SPACE,
                    };
                    let axes = [
                        (&mut *x, along(libm::cos(*yaw), true)),
                        (&mut *y, along(libm::cos(*pitch), false)),
                        (&mut *z, along(libm::sin(*yaw), true)),
                    ];
                    for (axis, extent) in axes {
                        let title = axis.title.clone();
                        fit(axis, extent);
                        // A title in space is a label.
                        let own = panel.labels.iter_mut().filter(|label| label.text == title);
                        own.for_each(|label| label.text.clone_from(&axis.title));
                    }
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
        self.notes.extend(units);
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
        label.coloured(self.colour).left().shifted(7.0, down).led()
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

/// How long an axis is, which way it runs, and how many pixels a tick takes.
#[derive(Clone, Copy)]
struct Extent {
    pixels: f64,
    to_the_right: bool,
    each: f64,
}

impl Extent {
    /// Most ticks; a low panel may have room for more than one beside its end.
    fn most(self) -> usize {
        let fewest = if self.to_the_right { 2 } else { 4 };
        (libm::floor(self.pixels / self.each) as usize).clamp(fewest, MOST)
    }

    fn are_apart(self, axis: &PlotAxis, a: &Tick, b: &Tick) -> bool {
        let distance = (axis.share(b.value) - axis.share(a.value)) * self.pixels;
        let needed = if self.to_the_right {
            0.5 * (width(&a.label, SMALL) + width(&b.label, SMALL)) + BESIDE
        } else {
            SMALL + ABOVE
        };
        distance.abs() >= needed
    }

    fn fit(self, axis: &PlotAxis, ticks: &[Tick]) -> bool {
        let mut pairs = ticks.windows(2);
        pairs.all(|pair| self.are_apart(axis, &pair[0], &pair[1]))
    }

    /// Whether labels are numbers without powers of ten that stay beside the axis.
    fn are_short(self, axis: &PlotAxis, ticks: &[Tick]) -> bool {
        ticks.iter().all(|tick| {
            let wide = width(&tick.label, SMALL);
            let is_beside = if self.to_the_right {
                axis.share(tick.value) * self.pixels + 0.5 * wide <= self.pixels + AFTER
            } else {
                wide <= UPRIGHT
            };
            is_beside && !tick.label.contains('e')
        })
    }
}

/// As many ticks as an axis has room for.
fn fit(axis: &mut PlotAxis, extent: Extent) {
    let given = axis.clone();
    let counts = || {
        (1..=extent.most())
            .rev()
            .map(|count| choices(&given, count))
            .filter(|ticks| !ticks.is_empty())
    };
    let fits = |ticks: &Vec<Tick>| extent.fit(&given, ticks);
    let short = counts().find(|ticks| fits(ticks) && extent.are_short(&given, ticks));
    let told = || counts().find_map(|ticks| Told::shortest(&given, extent, &ticks));
    let found = short
        .or_else(|| told().map(|told| told.entitle(&mut axis.title)))
        .or_else(|| counts().find(fits));
    let Some(mut found) = found else {
        return;
    };
    if let Scale::Angle(own) = &axis.scale {
        found.retain(|tick| {
            own.iter()
                .all(|other| extent.are_apart(&given, tick, other))
        });
        found.extend(own.iter().cloned());
        found.sort_by(|a, b| a.value.total_cmp(&b.value));
    }
    axis.ticks = found;
}

/// Ticks whose labels are short because the title says the rest: a number that is taken off, and
/// a power of ten.
struct Told {
    ticks: Vec<Tick>,
    /// What is taken off, with its sign.
    base: String,
    power: i32,
}

/// Sizes of numbers that stand as they are.
const PLAIN: Sizes = 1e-3..1e6;
/// From a size to below another.
type Sizes = core::ops::Range<f64>;

impl Told {
    /// In a power of ten, or else from one of them, if that makes them short.
    fn shortest(axis: &PlotAxis, extent: Extent, ticks: &[Tick]) -> Option<Self> {
        // Curved axes have numbers of their own.
        if axis.linear.is_finite() || axis.scale == Scale::Decades {
            return None;
        }
        let middle = ticks.get(ticks.len() / 2)?;
        let is_angle = matches!(axis.scale, Scale::Angle(_));
        let number = if is_angle && middle.label.contains('π') {
            middle.label.trim_start_matches('−').to_owned()
        } else {
            let steps = ticks.iter().map(|tick| tick.value).collect::<Vec<_>>();
            of_decimals(middle.value.abs(), decimals(&steps))
        };
        let sign = if middle.value < 0.0 { "+" } else { "−" };
        let whole = [PLAIN, 0.0..0.0].map(|plain| (0.0, String::new(), plain));
        let less = (middle.value, format!(" {sign} {number}"), PLAIN);
        whole
            .into_iter()
            .chain([less])
            .find_map(|(value, base, plain)| {
                let less: Vec<f64> = ticks.iter().map(|tick| tick.value - value).collect();
                let (labels, power) = scaled(&less, is_angle && !base.is_empty(), plain);
                let labels = ticks.iter().zip(labels);
                let ticks: Vec<Tick> = labels
                    .map(|(tick, label)| Tick {
                        label,
                        ..tick.clone()
                    })
                    .collect();
                let is_good = extent.fit(axis, &ticks) && extent.are_short(axis, &ticks);
                is_good.then_some(Self { ticks, base, power })
            })
    }

    /// Says the rest in a title.
    fn entitle(self, title: &mut String) -> Vec<Tick> {
        let unit = title.find(UNIT).unwrap_or(title.len());
        title.insert_str(unit, &self.base);
        let unit = unit + self.base.len();
        if self.power != 0 {
            let factor = format!("10^{{{}}}", ticks::minus(&self.power.to_string()));
            if unit < title.len() {
                title.insert_str(unit + UNIT.len(), &format!("{factor} "));
            } else {
                title.push_str(&format!("{UNIT}{factor})"));
            }
        }
        self.ticks
    }
}

/// Begins the unit in the title of an axis.
const UNIT: &str = "  (";

/// Takes the unit off a title that is longer than there is room, and then the power of ten; what it
/// has taken off.
fn without_unit(title: &mut String, room: f64) -> Option<String> {
    let unit = title.find(UNIT).filter(|_| width(title, LETTER) > room)?;
    let inner = title.split_off(unit);
    let inner = inner.strip_prefix(UNIT)?.strip_suffix(')')?;
    let factor = inner.split(' ').next().filter(|it| it.starts_with("10^"));
    let with_factor = factor.map(|factor| format!("{title}{UNIT}{factor})"));
    match (factor, with_factor) {
        (Some(factor), Some(shorter)) if width(&shorter, LETTER) <= room => {
            *title = shorter;
            Some(inner[factor.len()..].trim_start().to_owned())
        }
        _ => Some(inner.to_owned()),
    }
}

/// The fewest decimals with which multiples of a step are told apart from others.
fn decimals(values: &[f64]) -> usize {
    let steps = values.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let step = steps.fold(f64::INFINITY, f64::min);
    if !step.is_normal() {
        return 0;
    }
    let first = (-libm::floor(libm::log10(step))).max(0.0) as usize;
    // A step of 2.5 has one more.
    let is_whole = |digits: &usize| {
        let units = step * libm::exp10(*digits as f64);
        (units - libm::round(units)).abs() < 1e-3
    };
    [first, first + 1]
        .into_iter()
        .find(is_whole)
        .unwrap_or(first)
}

fn of_decimals(value: f64, digits: usize) -> String {
    ticks::minus(&format!("{:.digits$}", value + 0.0))
}

/// Labels of numbers, in a power of ten if the largest is not as plain numbers are; of angles, if
/// they are to be, in parts of π.
fn scaled(values: &[f64], are_angles: bool, plain: Sizes) -> (Vec<String>, i32) {
    let most = values.iter().map(|value| value.abs()).fold(0.0, f64::max);
    let own: Vec<String> = values.iter().map(|value| angle(*value)).collect();
    if are_angles && own.iter().any(|label| label.contains('π')) {
        return (own, 0);
    }
    let power = if plain.contains(&most) || most == 0.0 {
        0
    } else {
        libm::floor(libm::log10(most)) as i32
    };
    let unit = libm::exp10(f64::from(power));
    let values: Vec<f64> = values.iter().map(|value| value / unit).collect();
    let digits = decimals(&values);
    let labels = values.iter().map(|value| of_decimals(*value, digits));
    (labels.collect(), power)
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
        label: of_one_digit(value),
    })
    .collect()
}

/// A number of one digit: as a power of ten where it has many places.
fn of_one_digit(value: f64) -> String {
    if value == 0.0 || (1e-3..1e5).contains(&value.abs()) {
        return short(value);
    }
    let power = libm::floor(libm::log10(value.abs()) + 1e-9);
    let factor = libm::round(value / libm::exp10(power));
    let power = ticks::minus(&power.to_string());
    let factor = match factor {
        1.0 => String::new(),
        -1.0 => "−".to_owned(),
        _ => format!("{}×", short(factor)),
    };
    format!("{factor}10^{{{power}}}")
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
