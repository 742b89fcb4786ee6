//! The impulses of a motion beside its forces, on an axis of their own.

use littlewood::Trajectory;
use littlewood::impact::Impulse;
use littlewood::tables::Dimension;
use littlewood_draw::{
    Content, IMPULSE as COLOUR, Label, Layer, Mark, Piece, SMALL, Series, Stroke,
};
use littlewood_style::Dash;
use littlewood_style::width::CURVE;

use crate::columns::{DEMAND, IMPULSE, TIME};
use crate::impacts;
use crate::motion::horizon;
use crate::timeline::{bare, range_of, transitions, zero};
use crate::wording::Wording;

/// An impulse in time.
pub(crate) const SPIKE: Stroke = Stroke::solid(COLOUR, CURVE).dashed(Dash::Short);

/// The normal and the friction impulse: name of the series, letter, end of a spike, value.
type Part = (&'static str, &'static str, Mark, fn(&Impulse) -> f64);
const PARTS: [Part; 2] = [
    ("normal impulse", "*P*", Mark::Dot(COLOUR, 2.6), |impulse| {
        impulse.normal
    }),
    (
        "friction impulse",
        "*J*",
        Mark::Ring(COLOUR, 3.4),
        |impulse| impulse.friction,
    ),
];

/// The impulses of a motion.
pub(crate) struct Spikes {
    pub(crate) impulses: Vec<(f64, Impulse)>,
}

impl Spikes {
    pub(crate) fn new(motion: &Trajectory) -> Self {
        let until = horizon(motion);
        let impulses = impacts::all(motion)
            .map(|(transition, impact)| (transition.time(), impact.impulse))
            .filter(|(time, _)| *time <= until);
        Self {
            impulses: impulses.collect(),
        }
    }

    /// Lines from zero with a mark at the end, against time; none without impacts.
    pub(crate) fn panel(
        &self,
        motion: &Trajectory,
        range: [f64; 2],
        say: Wording,
    ) -> Option<Content> {
        if self.impulses.is_empty() {
            return None;
        }
        let columns = [TIME, IMPULSE];
        let tips = PARTS.map(|(name, _, _, part)| {
            let rows = self
                .impulses
                .iter()
                .map(|(time, impulse)| vec![*time, part(impulse)])
                .collect();
            Series::of_rows(name, &columns, rows)
        });
        let axis = say.axis(IMPULSE, "*P*, *J*", range_of(&[&tips[0], &tips[1]], &[0.0]));
        let mut layers = vec![transitions(motion, &axis, IMPULSE), zero(range, IMPULSE)];
        let spikes = tips
            .iter()
            .flat_map(Series::rows)
            .map(|row| vec![vec![row[0], 0.0], row.to_vec()]);
        layers.push(Series::new("spike", &columns, spikes.collect()).drawn(SPIKE));
        layers.extend(
            tips.into_iter()
                .zip(PARTS)
                .map(|(series, (_, _, mark, _))| series.drawn(mark)),
        );
        let labels = PARTS
            .into_iter()
            .filter_map(|part| self.label(part, range, say))
            .collect();
        Some(Content {
            name: "impulses",
            x: bare(say, range),
            y: axis,
            layers,
            labels,
        })
    }

    /// |J|/P of each.
    pub(crate) fn shares(&self) -> impl Iterator<Item = f64> {
        self.impulses
            .iter()
            .map(|(_, impulse)| impulse.friction.abs() / impulse.normal)
    }

    /// The same as dots, which lie where |F|/N would.
    pub(crate) fn demands(&self) -> Option<Layer> {
        let rows: Piece = self
            .impulses
            .iter()
            .zip(self.shares())
            .map(|((time, _), share)| vec![*time, share])
            .collect();
        (!rows.is_empty()).then(|| {
            Series::of_rows("friction over normal impulse", &[TIME, DEMAND], rows)
                .drawn(Mark::Dot(COLOUR, 2.6))
        })
    }

    /// The name and the value of the largest.
    fn label(&self, (_, sign, _, part): Part, range: [f64; 2], say: Wording) -> Option<Label> {
        let size = |impulse: &Impulse| part(impulse).abs();
        let (time, largest) = self
            .impulses
            .iter()
            .rev()
            .max_by(|(_, a), (_, b)| size(a).total_cmp(&size(b)))?;
        let value = part(largest);
        let text = format!("{sign} = {}", say.value(value, Dimension::Impulse));
        let label = Label::new(text, &[*time, value]);
        let is_late = *time > range[0] + 0.8 * (range[1] - range[0]);
        let label = if is_late {
            label.right().shifted(-8.0, 0.0)
        } else {
            label.left().shifted(8.0, 0.0)
        };
        Some(label.sized(SMALL).coloured(COLOUR))
    }
}
