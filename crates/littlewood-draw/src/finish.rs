//! The last step of a figure: ticks as many as there is room for, labels beside each other.

use littlewood_style::ticks::{self, Tick};

use crate::figure::{Figure, Label, Panel, PlotAxis, Scale, View};
use crate::letters::width;
use crate::stroke::SMALL;
use crate::words::short;

/// Most ticks of an axis, and the least room between their labels in pixels.
const MOST: usize = 9;
const BESIDE: f64 = 12.0;
const ABOVE: f64 = 12.0;
/// Pixels to a tick of an axis to the right, and of one upwards.
const EACH: [f64; 2] = [60.0, 30.0];

impl Figure {
    /// Completes a figure: ticks as many as there is room for, labels moved off each other.
    #[must_use]
    pub fn fitted(mut self) -> Self {
        let sheet = [self.width, self.height];
        for panel in &mut self.panels {
            let [_, _, across, upwards] = panel.frame;
            let [[left, top], [right, bottom]] = panel.axes_frame();
            match &mut panel.view {
                View::Plane { x, y, .. } => {
                    fit(x, right - left, true);
                    fit(y, bottom - top, false);
                }
                View::Space { x, y, z, .. } => {
                    fit(x, 0.6 * across, true);
                    fit(y, 0.5 * upwards, false);
                    fit(z, 0.25 * across, true);
                }
            }
            arrange(panel, sheet);
        }
        self
    }
}

/// As many ticks as an axis of so many pixels has room for.
fn fit(axis: &mut PlotAxis, pixels: f64, to_the_right: bool) {
    let [from, to] = axis.range;
    let each = EACH[usize::from(!to_the_right)];
    // A low panel may have room for more than one beside its end.
    let fewest = if to_the_right { 2 } else { 4 };
    let most = (libm::floor(pixels / each) as usize).clamp(fewest, MOST);
    let apart = |a: &Tick, b: &Tick| {
        let distance = (b.value - a.value) / (to - from) * pixels;
        let needed = if to_the_right {
            0.5 * (width(&a.label, SMALL) + width(&b.label, SMALL)) + BESIDE
        } else {
            SMALL + ABOVE
        };
        distance.abs() >= needed
    };
    let fits = |ticks: &[Tick]| ticks.windows(2).all(|pair| apart(&pair[0], &pair[1]));
    let candidates = (1..=most).rev().map(|count| choices(axis, count));
    let Some(mut found) = candidates.into_iter().find(|ticks| fits(ticks)) else { return };
    if let Scale::Angle(own) = &axis.scale {
        found.retain(|tick| own.iter().all(|other| apart(tick, other)));
        found.extend(own.iter().cloned());
        found.sort_by(|a, b| a.value.total_cmp(&b.value));
    }
    axis.ticks = found;
}

/// At most about so many ticks.
fn choices(axis: &PlotAxis, count: usize) -> Vec<Tick> {
    let [from, to] = axis.range;
    match &axis.scale {
        Scale::Round => ticks::round(from, to, count),
        Scale::NotNegative => {
            let mut ticks = ticks::round(from, to, count);
            ticks.retain(|tick| tick.value >= 0.0);
            ticks
        }
        Scale::Whole => ticks::round(from, to, count.min((to - from) as usize).max(1)),
        Scale::Angle(_) => ticks::angular(from, to, count),
        Scale::Decades => decades([from, to], count),
        Scale::Given(ticks) => {
            let each = ticks.len().div_ceil(count);
            ticks.iter().step_by(each.max(1)).cloned().collect()
        }
        Scale::Bare => ticks::round(from, to, count)
            .into_iter()
            .map(|tick| Tick { label: String::new(), value: tick.value })
            .collect(),
        Scale::Nothing => Vec::new(),
    }
}

/// Powers of ten; within few of them their double and five times as much, too.
fn decades([from, to]: [f64; 2], most: usize) -> Vec<Tick> {
    let (first, last) = (libm::ceil(from) as i32, libm::floor(to) as i32);
    if last - first < 2 && most > 3 {
        return (first - 1..=last)
            .flat_map(|power| [1.0, 2.0, 5.0].map(|factor| factor * libm::pow(10.0, f64::from(power))))
            .map(|rate| Tick { value: libm::log10(rate), label: short(rate) })
            .filter(|tick| (from..=to).contains(&tick.value))
            .collect();
    }
    let each = (last - first).max(0) as usize / most + 1;
    (first..=last)
        .rev()
        .step_by(each)
        .map(|power| {
            let label = format!("10^{{{}}}", ticks::minus(&power.to_string()));
            Tick { value: f64::from(power), label }
        })
        .collect()
}

type Frame = [f64; 4];

/// Least distance of a label from the edge of the sheet and from others.
const EDGE: f64 = 3.0;

/// The box of a label whose place is known.
fn frame(label: &Label, [x, y]: [f64; 2]) -> Frame {
    let wide = width(&label.text, label.size);
    let left = x + label.shift[0] - label.anchor.share() * wide;
    let middle = y + label.shift[1];
    [left, middle - 0.45 * label.size, left + wide, middle + 0.45 * label.size]
}

fn overlap(a: Frame, b: Frame) -> bool {
    a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]
}

/// Moves labels of a plane onto the sheet, and up or down where another one stands.
fn arrange(panel: &mut Panel, [sheet, _]: [f64; 2]) {
    let places: Option<Vec<[f64; 2]>> =
        panel.labels.iter().map(|label| panel.place([label.at[0], label.at[1]])).collect();
    let mut taken: Vec<Frame> = Vec::new();
    for (label, at) in panel.labels.iter_mut().zip(places.unwrap_or_default()) {
        let there = frame(label, at);
        label.shift[0] += (EDGE - there[0]).max(0.0) - (there[2] - (sheet - EDGE)).max(0.0);
        let own = label.shift;
        let step = label.size;
        let tries = [0.0, -1.0, 1.0, -2.0, 2.0, -3.0, 3.0].map(|count| own[1] + count * step);
        let free = tries.into_iter().find(|down| {
            let moved = Label { shift: [own[0], *down], ..label.clone() };
            taken.iter().all(|other| !overlap(frame(&moved, at), *other))
        });
        label.shift[1] = free.unwrap_or(own[1]);
        taken.push(frame(label, at));
    }
}
