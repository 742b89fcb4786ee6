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

/// Ticks at round numbers from `a` to `b` > `a`, at most about `most` of them; none where these
/// differ by less than numbers can.
pub fn round(a: f64, b: f64, most: usize) -> Vec<Tick> {
    let least = (b - a) / most as f64;
    if !least.is_normal() || least < 0.0 {
        return Vec::new();
    }
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
                // As many digits as the step has.
                let order = libm::floor(libm::log10(value.abs())) - decade;
                let digits = (order + f64::from(extra)).max(1.0) as usize;
                format!("{value:.digits$e}")
            };
            Tick {
                value,
                label: minus(&label),
            }
        })
        .collect()
}

/// Ticks of a logarithmic axis from `a` to `b` > `a` > 0, at most about `most` of them: at 1, 2 and
/// 5 of each decade, at 1 and 3, at its beginning, or at the beginning of some. Within a decade
/// they are those of [`round`].
pub fn logarithmic(a: f64, b: f64, most: usize) -> Vec<Tick> {
    let slack = 1e-9;
    let (low, high) = (libm::log10(a), libm::log10(b));
    let decades = |every: i32| {
        let (first, last) = (libm::floor(low) as i32, libm::floor(high + slack) as i32);
        (first..=last).filter(move |decade| decade.rem_euclid(every) == 0)
    };
    let within = |value: f64| value >= a * (1.0 - slack) && value <= b * (1.0 + slack);
    let of = |factors: &[f64], every: i32| -> Vec<Tick> {
        decades(every)
            .flat_map(|decade| factors.iter().map(move |factor| (*factor, decade)))
            .filter_map(|(factor, decade)| {
                let value = if decade < 0 {
                    factor / libm::exp10(f64::from(-decade))
                } else {
                    factor * libm::exp10(f64::from(decade))
                };
                within(value).then(|| Tick {
                    value,
                    label: of_decade(factor, decade),
                })
            })
            .collect()
    };
    for factors in [&[1.0, 2.0, 5.0][..], &[1.0, 3.0], &[1.0]] {
        let ticks = of(factors, 1);
        if (3..=most).contains(&ticks.len()) {
            return ticks;
        }
    }
    if high - low < 2.0 {
        return round(a, b, most)
            .into_iter()
            .filter(|tick| tick.value > 0.0)
            .collect();
    }
    (2..)
        .map(|every| of(&[1.0], every))
        .find(|ticks| ticks.len() <= most.max(1))
        .unwrap_or_default()
}

/// Most decades whose numbers of one digit have small ticks.
const FULL: i32 = 8;

/// Small ticks of an axis that is not linear, from which one sees that it is not: at all numbers of
/// one digit in these decades, or at powers of ten where these are many.
pub fn of_one_digit(first: i32, last: i32) -> impl Iterator<Item = f64> {
    let digits = if last - first < FULL { 1..10 } else { 1..2 };
    (first..=last).flat_map(move |decade| {
        digits
            .clone()
            .map(move |digit| f64::from(digit) * libm::exp10(f64::from(decade)))
    })
}

/// A number of one digit and its decade: `0.02`, `500`, `10⁻⁷`, `3·10⁶`.
fn of_decade(factor: f64, decade: i32) -> String {
    match decade {
        -4..0 => {
            let digits = decade.unsigned_abs() as usize;
            format!("{:.digits$}", factor / libm::exp10(f64::from(-decade)))
        }
        0..5 => format!("{}", factor * libm::exp10(f64::from(decade))),
        _ => {
            let raised = |letter: char| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(letter.to_digit(10)? as usize);
            let power: String = decade
                .to_string()
                .chars()
                .map(|letter| raised(letter).unwrap_or('⁻'))
                .collect();
            if factor == 1.0 {
                format!("10{power}")
            } else {
                format!("{factor}·10{power}")
            }
        }
    }
}

/// Ticks at multiples of a fraction of π, for angles.
pub fn angular(a: f64, b: f64, most: usize) -> Vec<Tick> {
    let least = (b - a) / most as f64;
    let Some((over, under)) = [
        (1, 12),
        (1, 6),
        (1, 4),
        (1, 2),
        (1, 1),
        (2, 1),
        (5, 1),
        (10, 1),
        (50, 1),
    ]
    .into_iter()
    .find(|&(over, under)| PI * f64::from(over) / f64::from(under) >= least)
    .filter(|_| least >= PI / 24.0) else {
        return round(a, b, most);
    };
    let step = PI * f64::from(over) / f64::from(under);
    multiples(a, b, step)
        .map(|i| Tick {
            value: i * step,
            label: of_pi(i as i64 * i64::from(over), i64::from(under)),
        })
        .collect()
}

/// The whole numbers i with a ≤ i·step ≤ b, give or take rounding.
fn multiples(a: f64, b: f64, step: f64) -> impl Iterator<Item = f64> {
    let slack = 1e-9;
    let (first, last) = (libm::ceil(a / step - slack), libm::floor(b / step + slack));
    let count = if last >= first {
        (last - first) as usize + 1
    } else {
        0
    };
    // Adding zero makes -0 a 0.
    (0..count).map(move |i| first + i as f64 + 0.0)
}

/// A multiple of a fraction of π, with the minus sign of print.
pub fn of_pi(over: i64, under: i64) -> String {
    let divisor = greatest_divisor(over.unsigned_abs(), under.unsigned_abs()).max(1) as i64;
    let (over, under) = (over / divisor, under / divisor);
    let over = match over {
        0 => return "0".to_owned(),
        1 => "π".to_owned(),
        -1 => "−π".to_owned(),
        _ => minus(&format!("{over}π")),
    };
    if under == 1 {
        over
    } else {
        format!("{over}/{under}")
    }
}

const fn greatest_divisor(mut a: u64, mut b: u64) -> u64 {
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

/// With the minus sign of print.
pub fn minus(text: &str) -> String {
    text.replace('-', "−")
}
