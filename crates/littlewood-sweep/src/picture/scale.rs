//! The scale of a continuous column.

use super::Cells;
use super::palette::{NOTHING, Rgb, of_fraction};

/// The scale of a continuous column.
pub(super) struct Scale {
    pub(super) low: f64,
    pub(super) high: f64,
    /// Whether there are values below and above it.
    pub(super) beyond: [bool; 2],
}

impl Scale {
    /// From the lowest to the highest value, less half a per cent at either end if that is far out.
    pub(super) fn of(cells: &Cells) -> Option<Self> {
        let Cells::Real(cells) = cells else { return None };
        let mut values: Vec<f64> =
            cells.iter().copied().flatten().filter(|value| value.is_finite()).collect();
        values.sort_by(f64::total_cmp);
        let (&first, &last) = (values.first()?, values.last()?);
        let cut = values.len() / 200;
        let (mut low, mut high) = (values[cut], values[values.len() - 1 - cut]);
        let near = 0.25 * (high - low);
        if low - first <= near {
            low = first;
        }
        if last - high <= near {
            high = last;
        }
        if low == high {
            (low, high) = (low - 0.5, high + 0.5);
        }
        let reaches = |bound: f64| cells.iter().flatten().any(|&value| value == bound);
        let beyond = [first < low || reaches(f64::NEG_INFINITY), last > high || reaches(f64::INFINITY)];
        Some(Self { low, high, beyond })
    }

    pub(super) fn fraction(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }

    pub(super) fn colour(&self, value: f64) -> Rgb {
        if value.is_nan() { NOTHING } else { of_fraction(self.fraction(value)) }
    }
}
