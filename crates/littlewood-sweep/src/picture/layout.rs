//! Where the parts of a picture lie: title, legend, map. Lengths are in pixels of the drawing.

use littlewood::tables::{Class, PhaseSequence};
use littlewood_style::ticks::{Tick, minus};
use littlewood_style::{Curve, Ink, RANKS, Rgb, Theme, of_class, of_rank};

use super::cells::of_class as key_of_class;
use super::frame::{FINE, Frame};
use super::letters::{Face, lines};
use super::map::Picture;
use super::names::{at_zero, ticks_of, title, without_number};
use super::scale::{Kind, Scale};
use super::shade::Shade;

/// Heights in letters.
const TITLE: f64 = 1.6;
const LINE: f64 = 1.3;
const ROW: f64 = 1.75;
const BAR: f64 = 1.1;
const MARGIN: f64 = 1.0;

/// What stands before a label of the legend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Sign {
    Fill(Rgb),
    Line(Curve),
    /// A note without a sign.
    None,
}

/// An entry of the legend.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) sign: Sign,
    pub(super) label: String,
    pub(super) share: String,
    /// Left end and middle.
    pub(super) at: [i32; 2],
}

impl Entry {
    fn new(sign: Sign, label: impl Into<String>, share: String) -> Self {
        Self { sign, label: label.into(), share, at: [0, 0] }
    }

    /// Width of the sign and the distance to the label, in letters.
    pub(super) const fn indent(&self) -> f64 {
        match self.sign {
            Sign::Fill(_) => 2.0,
            Sign::Line(_) => 2.9,
            Sign::None => 0.0,
        }
    }

    /// Width in letters.
    fn width(&self) -> f64 {
        let share = if self.share.is_empty() { 0.0 } else { 0.5 + Face::SMALL.width(&self.share) };
        self.indent() + Face::PLAIN.width(&self.label) + share
    }
}

/// The parts of a picture.
pub(super) struct Layout {
    pub(super) letter: f64,
    pub(super) frame: Frame,
    pub(super) title: String,
    /// Lines under the title, and their middles.
    pub(super) lines: Vec<(String, i32)>,
    pub(super) entries: Vec<Entry>,
    pub(super) scale: Option<Scale>,
    /// Top and bottom of the bar of colours.
    pub(super) bar: Option<[i32; 2]>,
    pub(super) ticks: [Vec<Tick>; 2],
}

impl Layout {
    pub(super) fn new(picture: &Picture) -> Self {
        let letter = picture.size.letter() * f64::from(FINE);
        let size = picture.size.enlarged(FINE);
        let at = |letters: f64| libm::round(letters * letter) as i32;
        let units = picture.units.as_ref();
        let axes = picture.grid.axes();
        let wide = f64::from(size.width) / letter;

        let ticks = [ticks_of(&axes[0], units, 10), ticks_of(&axes[1], units, 9)];
        let widest =
            |ticks: &[Tick]| ticks.iter().map(|tick| Face::PLAIN.width(&tick.label)).fold(0.0, f64::max);
        let left = MARGIN + 1.6 + widest(&ticks[1]) + 0.8;
        let last = ticks[0].last().map_or(0.0, |tick| 0.5 * Face::PLAIN.width(&tick.label));
        let right = wide - f64::max(MARGIN, last + 0.3);

        let mut y = 0.6 + TITLE;
        let mut texts = Vec::new();
        let subtitles =
            [picture.fixed(), if picture.shade == Shade::Sequence { picture.meanings() } else { Vec::new() }];
        for text in subtitles.iter().flat_map(|parts| lines(parts, ",  ", Face::SMALL, right - left)) {
            texts.push((text, at(y + 0.5 * LINE)));
            y += LINE;
        }
        y += 0.35;
        let scale = match picture.shade {
            Shade::Class | Shade::Sequence => None,
            Shade::EnergyLost | Shade::Column(_) => Scale::of(&picture.cells),
        };
        let bar = scale.map(|_| {
            let bar = [at(y), at(y + BAR)];
            y += BAR + 0.35 + LINE + 0.25;
            bar
        });
        let mut entries = picture.entries(scale.as_ref());
        let mut x = left;
        let mut row = 0.0;
        for entry in &mut entries {
            let width = entry.width();
            if x > left && x + width > right {
                (x, row) = (left, row + 1.0);
            }
            entry.at = [at(x), at(y + (row + 0.5) * ROW)];
            x += width + 1.6;
        }
        if !entries.is_empty() {
            y += (row + 1.0) * ROW;
        }
        let top = at(y + 0.3);
        let bottom = size.height as i32 - at(4.0);
        let frame = Frame {
            left: at(left),
            top,
            width: (at(right) - at(left)).max(1),
            height: (bottom - top).max(1),
        };
        Self {
            letter,
            frame,
            title: title(picture.shade, picture.goes_on(), units),
            lines: texts,
            entries,
            scale,
            bar,
            ticks,
        }
    }
}

impl Picture {
    fn share(&self, count: u64) -> String {
        let share = 100.0 * count as f64 / self.grid.len() as f64;
        if share < 0.05 { format!("{count} points") } else { format!("{share:.1} %") }
    }

    fn entries(&self, scale: Option<&Scale>) -> Vec<Entry> {
        let mut entries = match self.shade {
            Shade::Class => self.entries_of_classes(&Class::ALL),
            Shade::Sequence => self.entries_of_sequences(),
            Shade::EnergyLost | Shade::Column(_) => self.entries_of_scale(scale),
        };
        if self.has_curves {
            let curves = self.curves().into_iter().map(|(curve, _)| curve);
            let mut shown: Vec<Curve> = Vec::new();
            for curve in curves {
                if !shown.contains(&curve) {
                    shown.push(curve);
                }
            }
            entries.extend(
                shown.into_iter().map(|curve| Entry::new(Sign::Line(curve), curve.label(), String::new())),
            );
        }
        entries
    }

    fn entries_of_classes(&self, classes: &[Class]) -> Vec<Entry> {
        classes
            .iter()
            .map(|&class| (class, self.count(class)))
            .filter(|(_, count)| *count > 0)
            .map(|(class, count)| {
                Entry::new(Sign::Fill(of_class(class, Theme::Light)), class.label(), self.share(count))
            })
            .collect()
    }

    fn entries_of_sequences(&self) -> Vec<Entry> {
        let count = |key: &u64| self.sequences.get(key).copied().unwrap_or_default();
        let mut entries: Vec<Entry> = self
            .ranking
            .iter()
            .take(RANKS)
            .enumerate()
            .map(|(rank, key)| {
                let text = PhaseSequence::from_bits(*key).to_string();
                let label = if text.is_empty() { "none".to_owned() } else { minus(&text) };
                Entry::new(Sign::Fill(of_rank(rank, Theme::Light)), label, self.share(count(key)))
            })
            .collect();
        let others: Vec<u64> = self.ranking.iter().skip(RANKS).map(count).collect();
        if !others.is_empty() {
            let label = format!("{} others", others.len());
            let share = self.share(others.iter().sum());
            entries.push(Entry::new(Sign::Fill(of_rank(RANKS, Theme::Light)), label, share));
        }
        entries.extend(self.entries_of_classes(&[Class::Invalid, Class::NotComputed]));
        entries
    }

    fn entries_of_scale(&self, scale: Option<&Scale>) -> Vec<Entry> {
        let mut entries = Vec::new();
        let note = |text: &str| Entry::new(Sign::None, text, String::new());
        if let Some(scale) = scale {
            let parts = [
                (scale.kind == Kind::Log, "logarithmic scale"),
                (scale.beyond[0], "smaller values as at the left end"),
                (scale.beyond[1], "larger values as at the right end"),
                (self.has_contours, "lines at the ticks"),
            ];
            let text: Vec<&str> =
                parts.into_iter().filter_map(|(holds, text)| holds.then_some(text)).collect();
            if !text.is_empty() {
                entries.push(note(&text.join("; ")));
            }
        }
        let cells_share = |count: usize| {
            let share = 100.0 * count as f64 / self.cells.len() as f64;
            if share < 0.05 { String::new() } else { format!("{share:.1} %") }
        };
        if let Some(scale) = scale {
            let zeros = self.cells.iter().filter(|cell| scale.has_zero(cell.number)).count();
            if zeros > 0 {
                let colour = Ink::Faint.colour(Theme::Light);
                entries.push(Entry::new(Sign::Fill(colour), at_zero(self.shade), cells_share(zeros)));
            }
        }
        let empty = self.cells.iter().filter(|cell| cell.number.is_nan()).count();
        let missing = key_of_class(Class::NotComputed);
        let not_computed = self.cells.iter().filter(|cell| cell.key == missing).count();
        if empty > not_computed {
            let label = if scale.is_some() { without_number(self.shade) } else { "no value anywhere" };
            let share = if scale.is_some() { cells_share(empty - not_computed) } else { String::new() };
            entries.push(Entry::new(Sign::Fill(Ink::NoValue.colour(Theme::Light)), label, share));
        }
        entries.extend(self.entries_of_classes(&[Class::NotComputed]));
        entries
    }
}
