//! The impulses of a motion beside its forces.

use littlewood::Trajectory;
use littlewood::impact::Impulse;
use littlewood::tables::Dimension;
use littlewood_draw::{IMPULSE, Label, Layer, Mark, SMALL, Series, Stroke};
use littlewood_style::Dash;
use littlewood_style::width::CURVE;

use crate::columns::{DEMAND, TIME};
use crate::impacts;
use crate::motion::horizon;
use crate::wording::Wording;

/// An impulse beside curves of forces.
pub(crate) const SPIKE: Stroke = Stroke::solid(IMPULSE, CURVE).dashed(Dash::Short);

/// The impulses of a motion, and how long they are drawn on an axis of forces.
pub(crate) struct Spikes {
    pub(crate) impulses: Vec<(f64, Impulse)>,
    /// Length of the impulse m2 √(gR), in units of m2 g.
    pub(crate) scale: f64,
}

impl Spikes {
    /// The scale is one, two or five times a power of ten; the largest impulse is at most as long as a force.
    pub(crate) fn new(motion: &Trajectory, force: f64) -> Self {
        let until = horizon(motion);
        let impulses: Vec<(f64, Impulse)> = impacts::all(motion)
            .map(|(transition, impact)| (transition.time(), impact.impulse))
            .filter(|(time, _)| *time <= until)
            .collect();
        let largest = impulses.iter().map(|(_, impulse)| impulse.normal).fold(0.0, f64::max);
        let ratio = if largest > 0.0 { force / largest } else { 1.0 };
        let decade = libm::pow(10.0, libm::floor(libm::log10(ratio)));
        let factor = [5.0, 2.0].into_iter().find(|factor| factor * decade <= ratio).unwrap_or(1.0);
        Self { impulses, scale: factor * decade }
    }

    pub(crate) fn heights(&self, part: impl Fn(&Impulse) -> f64) -> Vec<f64> {
        self.impulses.iter().map(|(_, impulse)| self.scale * part(impulse)).collect()
    }

    /// Lines from zero, with a dot at the end.
    pub(crate) fn layers(&self, columns: [&'static str; 3], part: impl Fn(&Impulse) -> f64) -> Vec<Layer> {
        if self.impulses.is_empty() {
            return Vec::new();
        }
        let row = |time: f64, value: f64, height: f64| vec![time, height, value];
        let pieces = self
            .impulses
            .iter()
            .map(|(time, impulse)| {
                let value = part(impulse);
                vec![row(*time, value, 0.0), row(*time, value, self.scale * value)]
            })
            .collect();
        let tips = self.impulses.iter().map(|(time, impulse)| {
            let value = part(impulse);
            row(*time, value, self.scale * value)
        });
        vec![
            Series::new("impulse", &columns, pieces).drawn(Mark::Line(SPIKE)),
            Series::of_rows("tip of an impulse", &columns, tips.collect()).drawn(Mark::Dot(IMPULSE, 2.6)),
        ]
    }

    /// |J|/P of each.
    pub(crate) fn shares(&self) -> impl Iterator<Item = f64> {
        self.impulses.iter().map(|(_, impulse)| impulse.friction.abs() / impulse.normal)
    }

    /// The same as dots, which lie where |F|/N would.
    pub(crate) fn demands(&self) -> Option<Layer> {
        let rows: Vec<Vec<f64>> =
            self.impulses.iter().zip(self.shares()).map(|((time, _), share)| vec![*time, share]).collect();
        (!rows.is_empty()).then(|| {
            Series::of_rows("friction over normal impulse", &[TIME, DEMAND], rows)
                .drawn(Mark::Dot(IMPULSE, 2.6))
        })
    }

    /// The name and the value of the largest.
    pub(crate) fn label(
        &self,
        sign: &str,
        end: f64,
        say: Wording,
        part: impl Fn(&Impulse) -> f64,
    ) -> Option<Label> {
        let size = |impulse: &Impulse| part(impulse).abs();
        let (time, largest) =
            self.impulses.iter().rev().max_by(|(_, a), (_, b)| size(a).total_cmp(&size(b)))?;
        let value = part(largest);
        let text = format!("{sign} = {}", say.value(value, Dimension::Impulse));
        let label = Label::new(text, &[*time, self.scale * value]);
        let down = if value < 0.0 { -4.0 } else { 4.0 };
        let is_late = *time > self.impulses[0].0 + 0.8 * (end - self.impulses[0].0);
        let label = if is_late { label.right().shifted(-7.0, down) } else { label.left().shifted(7.0, down) };
        Some(label.sized(SMALL).coloured(IMPULSE))
    }

    /// What they are, without a full stop.
    pub(crate) fn in_words(&self, say: Wording) -> String {
        if self.impulses.is_empty() {
            return String::new();
        }
        format!(
            " Spikes: the impulses (*J*, *P*) of the impacts, in which the velocities jump; {} as long as {}",
            say.quantity(1.0, Dimension::Impulse),
            say.quantity(self.scale, Dimension::Force)
        )
    }
}
