//! An axis as it is typed: `theta=-pi:pi:200`.

use core::f64::consts::PI;

use littlewood_sweep::{Axis, Coordinate};

/// An axis after a flag.
pub(crate) fn parse_axis(text: &str) -> Result<Axis, String> {
    const FORM: &str = "hint: an axis is NAME=FROM:TO:COUNT, such as theta=-pi:pi:200";
    let (name, range) = text.split_once('=').ok_or(FORM)?;
    let coordinate = Coordinate::find(&name.trim().replace('-', "_")).ok_or_else(|| {
        let known = Coordinate::ALL.map(Coordinate::name).join(", ");
        format!("there is no quantity '{name}'\n\nhint: axes are {known}")
    })?;
    let [from, to, count] = range.split(':').map(str::trim).collect::<Vec<_>>()[..] else {
        return Err(FORM.to_owned());
    };
    let end = |text| parse_number(text).ok_or_else(|| format!("'{text}' is not a number\n\n{FORM}"));
    let (from, to) = (end(from)?, end(to)?);
    let count = count.parse().map_err(|_| format!("'{count}' is not a number of points\n\n{FORM}"))?;
    Axis::new(coordinate, from, to, count).map_err(|error| format!("{error}\n\n{FORM}"))
}

/// A number, which may be written with π: `-pi`, `2pi`, `3*pi/4`.
fn parse_number(text: &str) -> Option<f64> {
    if let Ok(value) = text.parse() {
        return Some(value);
    }
    let (factor, divisor) = text.split_once("pi").or_else(|| text.split_once('π'))?;
    let factor = match factor.strip_suffix('*').unwrap_or(factor) {
        "" | "+" => 1.0,
        "-" => -1.0,
        number => number.parse().ok()?,
    };
    let divisor = match divisor {
        "" => 1.0,
        _ => divisor.strip_prefix('/')?.parse().ok()?,
    };
    Some(factor * PI / divisor)
}

#[cfg(test)]
mod tests {
    use super::{parse_axis, parse_number};
    use core::f64::consts::{FRAC_PI_2, PI};

    #[test]
    fn numbers_may_have_pi_in_them() {
        for (text, value) in [
            ("-pi", -PI),
            ("2pi", 2.0 * PI),
            ("pi/2", FRAC_PI_2),
            ("3*pi/4", 3.0 * PI / 4.0),
            ("-π", -PI),
            ("-.5e1", -5.0),
        ] {
            assert_eq!(parse_number(text), Some(value), "{text}");
        }
        for text in ["", "p", "pipi", "pi2", "*pie", "two"] {
            assert_eq!(parse_number(text), None, "{text}");
        }
    }

    #[test]
    fn axes_have_a_name_two_ends_and_a_count() {
        let axis = parse_axis("theta-rate=-4:4:9").expect("an axis");
        assert_eq!((axis.from(), axis.to(), axis.count()), (-4.0, 4.0, 9));
        for text in ["theta", "theta=1:2", "theta=1:2:3:4", "theta=1:2:0", "theta=1:2:-3", "theta=a:2:3"] {
            assert!(parse_axis(text).is_err(), "{text}");
        }
    }
}
