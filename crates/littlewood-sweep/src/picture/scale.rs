//! The scale of colours of numbers.

use littlewood_style::ticks::{self, Tick};
use littlewood_style::{Ink, Rgb, Theme, of_fraction};

use super::cells::Cell;

/// How numbers become fractions of a scale.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Linear,
    Log,
    /// Whole numbers, a step of colour each.
    Counts,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    pub(super) kind: Kind,
    pub(super) low: f64,
    pub(super) high: f64,
    /// Whether there are values below and above it.
    pub(super) beyond: [bool; 2],
}

/// Counts up to which each has a step of its own.
const STEPS: f64 = 12.0;

/// The part of a linear scale below which its values crowd if the median lies there.
const CROWDED: f64 = 0.25;

/// Decades that a logarithmic scale shows at most: what is smaller is hardly ever of interest
/// beside the rest.
const DECADES: f64 = 1e4;

impl Scale {
    /// From the lowest to the highest value, less half a per cent at either end if that is far out.
    /// Positive values that would crowd at the low end of it stand on a logarithmic scale.
    pub(super) fn of(cells: &[Cell]) -> Option<Self> {
        let mut values: Vec<f64> = cells
            .iter()
            .map(|cell| cell.number)
            .filter(|value| value.is_finite())
            .collect();
        values.sort_by(f64::total_cmp);
        let (&first, &last) = (values.first()?, values.last()?);
        let reaches = |bound: f64| cells.iter().any(|cell| cell.number == bound);
        let beyond = |low: f64, high: f64| {
            [
                first < low || reaches(f64::NEG_INFINITY),
                last > high || reaches(f64::INFINITY),
            ]
        };
        let scale = |kind: Kind, low: f64, high: f64| Self {
            kind,
            low,
            high,
            beyond: beyond(low, high),
        };
        let whole = values.iter().all(|value| libm::round(*value) == *value);
        if whole && last - first < STEPS {
            return Some(scale(Kind::Counts, first - 0.5, last + 0.5));
        }
        let cut = values.len() / 200;
        let (mut low, mut high) = (values[cut], values[values.len() - 1 - cut]);
        let near = 0.25 * (high - low);
        if low - first <= near {
            low = first;
        }
        if last - high <= near {
            high = last;
        }
        // What happens at once, at 0, says nothing about how the others are spread.
        let positive = &values[values.partition_point(|&value| value <= 0.0)..];
        if first >= 0.0
            && let (Some(&least), Some(&median)) = (
                positive.get(positive.len() / 200),
                positive.get(positive.len() / 2),
            )
            && (median - low < CROWDED * (high - low) || median - low < CROWDED * (last - low))
        {
            let high = last;
            let low = least.max(high / DECADES).min(0.5 * high);
            let below = positive[0] < low;
            return Some(Self {
                kind: Kind::Log,
                low,
                high,
                beyond: [below, beyond(low, high)[1]],
            });
        }
        if low == high {
            (low, high) = (low - 0.5, high + 0.5);
        }
        Some(scale(Kind::Linear, low, high))
    }

    pub(super) fn fraction(&self, value: f64) -> f64 {
        match self.kind {
            Kind::Linear | Kind::Counts => (value - self.low) / (self.high - self.low),
            Kind::Log => libm::log(value.max(0.0) / self.low) / libm::log(self.high / self.low),
        }
    }

    pub(super) fn colour(&self, value: f64) -> Rgb {
        if value.is_nan() {
            Ink::NoValue.colour(Theme::Light)
        } else if self.has_zero(value) {
            Ink::Faint.colour(Theme::Light)
        } else {
            self.at(self.fraction(value))
        }
    }

    /// Whether a value has no place on a logarithmic scale, but a colour of its own.
    pub(super) fn has_zero(&self, value: f64) -> bool {
        self.kind == Kind::Log && value <= 0.0
    }

    pub(super) fn at(&self, fraction: f64) -> Rgb {
        of_fraction(match self.kind {
            Kind::Linear | Kind::Log => fraction,
            Kind::Counts => {
                let steps = self.high - self.low;
                let step = libm::floor(fraction * steps).clamp(0.0, steps - 1.0);
                if steps > 1.0 {
                    step / (steps - 1.0)
                } else {
                    0.5
                }
            }
        })
    }

    /// Ticks of the bar, in a unit of which one on the scale has this many.
    pub(super) fn ticks(&self, unit: f64, most: usize) -> Vec<Tick> {
        let (low, high) = (unit * self.low, unit * self.high);
        let mut ticks = match self.kind {
            Kind::Linear => ticks::round(low, high, most),
            Kind::Log => ticks::logarithmic(low, high, most),
            Kind::Counts => ticks::round(low, high, STEPS as usize + 1)
                .into_iter()
                .filter(|tick| libm::round(tick.value) == tick.value)
                .map(|tick| Tick {
                    label: format!("{:.0}", tick.value),
                    ..tick
                })
                .collect(),
        };
        for tick in &mut ticks {
            tick.value /= unit;
        }
        ticks
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cells(values: &[f64]) -> Vec<Cell> {
        values
            .iter()
            .map(|&number| Cell { key: 0, number })
            .collect()
    }

    #[test]
    fn what_crowds_at_the_low_end_gets_a_logarithmic_scale() {
        let spread: Vec<f64> = (1..=100).map(f64::from).map(|i| i + 0.5).collect();
        assert_eq!(
            Scale::of(&cells(&spread)).expect("a scale").kind,
            Kind::Linear
        );
        let crowded: Vec<f64> = spread
            .iter()
            .map(|x| libm::exp(0.08 * x))
            .chain([0.0; 60])
            .collect();
        let scale = Scale::of(&cells(&crowded)).expect("a scale");
        assert_eq!(scale.kind, Kind::Log);
        // The median of what is not 0 stands in the middle of it, give or take.
        let median = libm::exp(0.08 * 51.0);
        assert!((0.3..0.7).contains(&scale.fraction(median)), "{scale:?}");
        // 0 has a colour that the scale has nowhere.
        assert_eq!((scale.beyond, scale.has_zero(0.0)), ([false, false], true));
        assert!((0..=100).all(|i| of_fraction(f64::from(i) / 100.0) != scale.colour(0.0)));
    }

    #[test]
    fn few_counts_have_a_step_each() {
        let scale = Scale::of(&cells(&[1.0, 2.0, 2.0, 4.0])).expect("a scale");
        let labels: Vec<String> = scale
            .ticks(1.0, 8)
            .into_iter()
            .map(|tick| tick.label)
            .collect();
        assert_eq!(labels, ["1", "2", "3", "4"]);
        assert_eq!(
            (scale.colour(1.0), scale.colour(4.0)),
            (of_fraction(0.0), of_fraction(1.0))
        );
        assert_eq!(scale.colour(2.0), of_fraction(1.0 / 3.0));
    }

    #[test]
    fn one_value_and_none() {
        assert!(Scale::of(&cells(&[f64::NAN])).is_none());
        let scale = Scale::of(&cells(&[2.5, 2.5])).expect("a scale");
        assert_eq!(scale.fraction(2.5), 0.5);
    }
}
