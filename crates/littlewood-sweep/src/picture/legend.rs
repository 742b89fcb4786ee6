//! What the colours and lines of a map mean.

use littlewood::tables::{Class, PhaseSequence};
use littlewood_draw::{Mark, key_of_curve};
use littlewood_style::ticks::minus;
use littlewood_style::{Curve, Ink, RANKS, Theme, of_class, of_rank};

use super::cells::of_class as key_of_class;
use super::map::Picture;
use super::names::{at_zero, without_number};
use super::scale::{Kind, Scale};
use super::shade::Shade;

/// An entry: how it is drawn, and what it means.
pub(super) type Entry = (Mark, String);

/// The least part of the map that has an entry without a point of the grid.
const SEEN: f64 = 1e-3;

fn with_share(label: &str, share: &str) -> String {
    if share.is_empty() {
        label.to_owned()
    } else {
        format!("{label}, {share}")
    }
}

impl Picture {
    fn share(&self, count: u64) -> String {
        let share = 100.0 * count as f64 / self.grid.len() as f64;
        if share < 0.05 {
            format!("{count} points")
        } else {
            format!("{share:.1} %")
        }
    }

    /// All entries, but for those of the curves.
    pub(super) fn entries(&self, scale: Option<&Scale>) -> Vec<Entry> {
        match self.shade {
            Shade::Class => self.with_mixed(self.entries_of_classes(&Class::ALL)),
            Shade::Sequence => self.with_mixed(self.entries_of_sequences()),
            Shade::EnergyLost | Shade::Column(_) | Shade::Derivative(_) => {
                self.entries_of_scale(scale)
            }
        }
    }

    /// With an entry of what is mixed, whose points others count, too.
    fn with_mixed(&self, mut entries: Vec<Entry>) -> Vec<Entry> {
        let share = self.mixed();
        if share > 0.0 {
            let label = format!(
                "of these mixed more finely than drawn, {:.1} %",
                100.0 * share
            );
            entries.push((Mark::Fill(Ink::Mixed.colour(Theme::Light)), label));
        }
        entries
    }

    fn entries_of_classes(&self, classes: &[Class]) -> Vec<Entry> {
        let counted = classes
            .iter()
            .map(|&class| (class, self.count(class)))
            .filter(|(class, count)| *count > 0 || self.is_seen(*class));
        counted
            .map(|(class, count)| {
                let mark = Mark::Fill(of_class(class, Theme::Light));
                (mark, with_share(class.label(), &self.share(count)))
            })
            .collect()
    }

    /// Whether a class has a region that is large enough to be looked up, between points of others.
    fn is_seen(&self, class: Class) -> bool {
        let key = key_of_class(class);
        let mut regions = self.regions.regions.iter();
        regions.any(|region| region.key == key && region.area > SEEN)
    }

    fn entries_of_sequences(&self) -> Vec<Entry> {
        let count = |key: &u64| self.sequences.get(key).copied().unwrap_or_default();
        let (ranked, others): (Vec<u64>, Vec<u64>) = self
            .ranking
            .iter()
            .partition(|key| self.rank(**key).0 < RANKS);
        let ranked = ranked.iter().map(|key| {
            let text = PhaseSequence::from_bits(*key).to_string();
            let label = if text.is_empty() {
                "none".to_owned()
            } else {
                minus(&text)
            };
            (
                Mark::Fill(self.colour_of(*key)),
                with_share(&label, &self.share(count(key))),
            )
        });
        let mut entries: Vec<Entry> = ranked.collect();
        if !others.is_empty() {
            let label = format!("{} others", others.len());
            let colour = of_rank(RANKS, false, Theme::Light);
            entries.push((
                Mark::Fill(colour),
                with_share(&label, &self.share(others.iter().map(count).sum())),
            ));
        }
        entries.extend(self.entries_of_classes(&[Class::Invalid, Class::NotComputed]));
        entries
    }

    pub(super) fn note_of_scale(&self, scale: &Scale) -> Option<String> {
        let parts = [
            (scale.kind == Kind::Log, "logarithmic scale"),
            (scale.beyond[0], "smaller values as at the left end"),
            (scale.beyond[1], "larger values as at the right end"),
        ];
        let text: Vec<&str> = parts
            .into_iter()
            .filter_map(|(holds, text)| holds.then_some(text))
            .collect();
        (!text.is_empty()).then(|| text.join("; "))
    }

    fn entries_of_scale(&self, scale: Option<&Scale>) -> Vec<Entry> {
        let mut entries = Vec::new();
        let cells_share = |count: usize| {
            let share = 100.0 * count as f64 / self.cells.len() as f64;
            if share < 0.05 {
                String::new()
            } else {
                format!("{share:.1} %")
            }
        };
        let ink = |ink: Ink| Mark::Fill(ink.colour(Theme::Light));
        if let Some(scale) = scale {
            let zeros = self
                .cells
                .iter()
                .filter(|cell| scale.has_zero(cell.number))
                .count();
            if zeros > 0 {
                entries.push((
                    ink(Ink::Faint),
                    with_share(at_zero(self.shade), &cells_share(zeros)),
                ));
            }
        }
        let empty = self
            .cells
            .iter()
            .filter(|cell| cell.number.is_nan())
            .count();
        let missing = key_of_class(Class::NotComputed);
        let not_computed = self.cells.iter().filter(|cell| cell.key == missing).count();
        if empty > not_computed {
            let label = if scale.is_some() {
                without_number(self.shade)
            } else {
                "no value anywhere"
            };
            let share = if scale.is_some() {
                cells_share(empty - not_computed)
            } else {
                String::new()
            };
            entries.push((ink(Ink::NoValue), with_share(label, &share)));
        }
        entries.extend(self.entries_of_classes(&[Class::NotComputed]));
        entries
    }
}

/// The entries of curves, each once.
pub(super) fn of_curves(curves: &[Curve], slope: f64) -> impl Iterator<Item = Entry> + '_ {
    let shown = Curve::ALL
        .into_iter()
        .filter(|curve| curves.contains(curve));
    shown.map(move |curve| key_of_curve(curve, slope))
}
