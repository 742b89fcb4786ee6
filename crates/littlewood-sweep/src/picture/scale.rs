//! The scale of colours of a column of real numbers.

use littlewood_style::{Ink, Rgb, Theme};

use super::cells::Cells;

/// Colour of a fraction from 0 to 1 of a scale: viridis, which grows lighter throughout.
pub(super) fn of_fraction(fraction: f64) -> Rgb {
    Rgb(colorous::VIRIDIS.eval_continuous(fraction.clamp(0.0, 1.0)).into_array())
}

/// The scale of colours of a column of real numbers.
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
        if value.is_nan() { Ink::NoValue.colour(Theme::Light) } else { of_fraction(self.fraction(value)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_scale_grows_lighter() {
        let scale: Vec<f64> = (0..=20).map(|i| of_fraction(f64::from(i) / 20.0).lightness()).collect();
        assert!(scale.windows(2).all(|pair| pair[1] > pair[0]), "{scale:?}");
    }
}
