//! The impulses of a motion beside its forces, on an axis of their own.

use littlewood::impact::Impulse;
use littlewood::tables::Dimension;
use littlewood_draw::{Content, IMPULSE as COLOUR, Label, Layer, Mark, SMALL, Series, Stroke};
use littlewood_style::Dash;
use littlewood_style::width::CURVE;

use crate::columns::{DEMAND, IMPULSE, TIME};
use crate::impacts;
use crate::motion::Shown;
use crate::timeline::range_of;

/// An impulse in time.
pub(crate) const SPIKE: Stroke = Stroke::solid(COLOUR, CURVE).dashed(Dash::Short);

/// The normal or the friction impulse.
struct Part {
    series: &'static str,
    letter: &'static str,
    /// The end of a spike.
    mark: Mark,
    of: fn(&Impulse) -> f64,
}

const PARTS: [Part; 2] = [
    Part {
        series: "normal impulse",
        letter: "*P*",
        mark: Mark::Dot(COLOUR, 2.6),
        of: |impulse| impulse.normal,
    },
    Part {
        series: "friction impulse",
        letter: "*J*",
        mark: Mark::Ring(COLOUR, 3.4),
        of: |impulse| impulse.friction,
    },
];

/// The impulses of a motion.
pub(crate) struct Spikes {
    pub(crate) impulses: Vec<(f64, Impulse)>,
}

impl Spikes {
    pub(crate) fn new(motion: &Shown) -> Self {
        let impulses = impacts::all(motion)
            .map(|(transition, impact)| (transition.time(), impact.impulse))
            .filter(|(time, _)| *time <= motion.until);
        Self {
            impulses: impulses.collect(),
        }
    }

    /// Lines from zero with a mark at the end, against time; none without impacts.
    pub(crate) fn panel(&self, motion: &Shown) -> Option<Content> {
        if self.impulses.is_empty() {
            return None;
        }
        let columns = [TIME, IMPULSE];
        let tips = PARTS.map(|Part { series, of, .. }| {
            let rows = self.impulses.iter();
            Series::of_rows(
                series,
                &columns,
                rows.map(|(time, impulse)| [*time, of(impulse)]),
            )
        });
        let y = motion
            .say
            .axis(IMPULSE, "*P*, *J*", range_of(&tips, &[0.0]));
        let mut layers = motion.ground(&y, IMPULSE);
        let spikes = tips
            .iter()
            .flat_map(Series::rows)
            .map(|row| [[row[0], 0.0], [row[0], row[1]]]);
        layers.push(Series::new("spike", &columns, spikes).drawn(SPIKE));
        let marks = PARTS.map(|part| part.mark);
        layers.extend(tips.into_iter().zip(marks).map(|(it, mark)| it.drawn(mark)));
        let labels = PARTS
            .iter()
            .filter_map(|part| self.label(part, motion))
            .collect();
        Some(motion.panel("impulses", y, layers, labels))
    }

    /// |J|/P of each.
    pub(crate) fn shares(&self) -> impl Iterator<Item = f64> {
        self.impulses
            .iter()
            .map(|(_, impulse)| impulse.friction.abs() / impulse.normal)
    }

    /// The same as dots, which lie where |F|/N would.
    pub(crate) fn demands(&self) -> Option<Layer> {
        let rows = self.impulses.iter().zip(self.shares());
        let rows = rows.map(|((time, _), share)| [*time, share]);
        (!self.impulses.is_empty()).then(|| {
            Series::of_rows("friction over normal impulse", &[TIME, DEMAND], rows)
                .drawn(Mark::Dot(COLOUR, 2.6))
        })
    }

    /// The name and the value of the largest.
    fn label(&self, Part { letter, of, .. }: &Part, motion: &Shown) -> Option<Label> {
        let size = |impulse: &Impulse| of(impulse).abs();
        let (time, largest) = self
            .impulses
            .iter()
            .rev()
            .max_by(|(_, a), (_, b)| size(a).total_cmp(&size(b)))?;
        let value = of(largest);
        let text = motion.say.value(value, Dimension::Impulse);
        let label = Label::new(format!("{letter} = {text}"), &[*time, value]);
        let [from, to] = motion.times();
        let is_late = *time > from + 0.8 * (to - from);
        let label = if is_late {
            label.right().shifted(-8.0, 0.0)
        } else {
            label.left().shifted(8.0, 0.0)
        };
        Some(label.sized(SMALL).coloured(COLOUR))
    }
}
