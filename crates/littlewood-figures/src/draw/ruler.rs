//! An axis as the plotting library wants it.

use std::ops::Range;

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

use crate::figure::PlotAxis;
use littlewood_style::ticks::Tick;

/// How far off the sheet places are told apart, in lengths of the axis.
const FAR: f64 = 1e3;

/// A linear scale with given ticks.
#[derive(Clone, Debug)]
pub(crate) struct Ruler {
    range: [f64; 2],
    ticks: Vec<Tick>,
}

impl From<&PlotAxis> for Ruler {
    fn from(axis: &PlotAxis) -> Self {
        Self { range: axis.range, ticks: axis.ticks.clone() }
    }
}

impl Ranged for Ruler {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        let [low, high] = self.range;
        // What lies far off the sheet need not be told from what lies farther off.
        let share = ((value - low) / (high - low)).clamp(-FAR, FAR);
        from + libm::round(f64::from(to - from) * share) as i32
    }

    fn key_points<H: KeyPointHint>(&self, hint: H) -> Vec<f64> {
        if hint.weight().allow_light_points() {
            return Vec::new();
        }
        self.ticks.iter().map(|tick| tick.value).collect()
    }

    fn range(&self) -> Range<f64> {
        self.range[0]..self.range[1]
    }
}

impl ValueFormatter<f64> for Ruler {
    fn format(value: &f64) -> String {
        value.to_string()
    }

    fn format_ext(&self, value: &f64) -> String {
        self.ticks
            .iter()
            .find(|tick| tick.value == *value)
            .map_or_else(|| Self::format(value), |tick| tick.label.clone())
    }
}
