//! Where an axis of a picture has its ticks, and what they say.

use core::f64::consts::PI;

/// A tick.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Position on the axis.
    pub value: f64,
    /// Label.
    pub label: String,
}

/// Ticks at round numbers from `a` to `b` > `a`, at most about `most` of them.
#[must_use]
pub fn round(a: f64, b: f64, most: usize) -> Vec<Tick> {
    let least = (b - a) / most as f64;
    let decade = libm::floor(libm::log10(least));
    let unit = libm::pow(10.0, decade);
    let (factor, extra) = [(1.0, 0), (2.0, 0), (2.5, 1), (5.0, 0)]
        .into_iter()
        .find(|(factor, _)| factor * unit >= least)
        .unwrap_or((10.0, -1));
    let step = factor * unit;
    let digits = usize::try_from(extra - decade as i32).unwrap_or(0);
    multiples(a, b, step)
        .map(|i| {
            let value = i * step;
            let size = value.abs().max((b - a).abs());
            let label = if (1e-4..1e6).contains(&size) {
                format!("{value:.digits$}")
            } else {
                format!("{value:.1e}")
            };
            Tick { value, label: minus(&label) }
        })
        .collect()
}

/// Ticks at multiples of a fraction of π, for angles.
#[must_use]
pub fn angular(a: f64, b: f64, most: usize) -> Vec<Tick> {
    let least = (b - a) / most as f64;
    if least < PI / 24.0 {
        return round(a, b, most);
    }
    let Some((over, under)) = [(1, 12), (1, 6), (1, 4), (1, 2), (1, 1), (2, 1), (5, 1), (10, 1), (50, 1)]
        .into_iter()
        .find(|&(over, under)| PI * f64::from(over) / f64::from(under) >= least)
    else {
        return round(a, b, most);
    };
    let step = PI * f64::from(over) / f64::from(under);
    multiples(a, b, step)
        .map(|i| Tick {
            value: i * step,
            label: minus(&fraction_of_pi(i as i64 * i64::from(over), i64::from(under))),
        })
        .collect()
}

/// The whole numbers i with a ≤ i·step ≤ b, give or take rounding.
fn multiples(a: f64, b: f64, step: f64) -> impl Iterator<Item = f64> {
    let slack = 1e-9;
    let (first, last) = (libm::ceil(a / step - slack), libm::floor(b / step + slack));
    let count = if last >= first { (last - first) as usize + 1 } else { 0 };
    // Adding zero makes -0 a 0.
    (0..count).map(move |i| first + i as f64 + 0.0)
}

/// A multiple of a fraction of π, with the minus sign of print.
#[must_use]
pub fn of_pi(over: i64, under: i64) -> String {
    minus(&fraction_of_pi(over, under))
}

fn fraction_of_pi(over: i64, under: i64) -> String {
    let divisor = greatest_divisor(over.unsigned_abs(), under.unsigned_abs()).max(1) as i64;
    match (over / divisor, under / divisor) {
        (0, _) => "0".to_owned(),
        (1, 1) => "π".to_owned(),
        (-1, 1) => "-π".to_owned(),
        (over, 1) => format!("{over}π"),
        (1, under) => format!("π/{under}"),
        (-1, under) => format!("-π/{under}"),
        (over, under) => format!("{over}π/{under}"),
    }
}

const fn greatest_divisor(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// With the minus sign of print.
#[must_use]
pub fn minus(text: &str) -> String {
    text.replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: &[Tick]) -> Vec<&str> {
        ticks.iter().map(|tick| tick.label.as_str()).collect()
    }

    #[test]
    fn angles_have_multiples_of_pi() {
        let ticks = angular(-PI, PI, 6);
        assert_eq!(labels(&ticks), ["−π", "−π/2", "0", "π/2", "π"]);
        assert_eq!(ticks[4].value, PI);
        assert_eq!(labels(&angular(0.0, 4.0 * PI, 6)), ["0", "π", "2π", "3π", "4π"]);
        assert_eq!(labels(&angular(0.0, PI, 4)), ["0", "π/4", "π/2", "3π/4", "π"]);
        assert_eq!(labels(&angular(0.0, 0.2, 4)), ["0.00", "0.05", "0.10", "0.15", "0.20"]);
    }

    #[test]
    fn numbers_are_round() {
        assert_eq!(labels(&round(-4.01, 4.01, 6)), ["−4", "−2", "0", "2", "4"]);
        assert_eq!(labels(&round(0.0, 1.0, 5)), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(&round(0.0, 1.0, 4)), ["0.00", "0.25", "0.50", "0.75", "1.00"]);
        assert_eq!(labels(&round(0.0, 3e7, 3)), ["0.0e0", "1.0e7", "2.0e7", "3.0e7"]);
    }
}
