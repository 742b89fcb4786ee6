//! An axis as it is typed: `theta=-pi:pi:200`, `mu=0.01:1:200:log`, or in SI units
//! `theta_rate_rad_per_s=0:20:200`.

use core::f64::consts::PI;

use littlewood::si::Units;
use littlewood::tables::Quantity;
use littlewood_sweep::{Axis, AxisError, Spacing, Varies};

use crate::nearest;

/// An axis whose ends may be in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TypedAxis {
    /// With the unit of its ends.
    varies: Varies,
    from: f64,
    to: f64,
    count: usize,
    spacing: Spacing,
}

impl TypedAxis {
    /// What varies along it, dimensionless.
    pub(crate) const fn varies(&self) -> Varies {
        match self.varies {
            Varies::One(quantity) => Varies::One(quantity.dimensionless()),
            Varies::Friction => Varies::Friction,
        }
    }

    /// The quantities that have its value, dimensionless.
    pub(crate) fn quantities(&self) -> impl Iterator<Item = Quantity> + use<> {
        self.varies().quantities()
    }

    /// Whether its ends have a unit that has to be taken off.
    pub(crate) const fn is_si(&self) -> bool {
        match self.varies {
            Varies::One(quantity) => quantity.is_si(),
            Varies::Friction => false,
        }
    }

    /// The axis without dimension. Ends that were given so are taken as they are, to the last bit.
    pub(crate) fn resolve(&self, units: Option<&Units>) -> Result<Axis, AxisError> {
        let end = |value| match units {
            Some(units) if self.is_si() => units.from_si(self.varies.dimension(), value),
            Some(_) | None => value,
        };
        Axis::new(self.varies(), end(self.from), end(self.to), self.count)?
            .with_spacing(self.spacing)
    }
}

/// An axis after a flag.
pub(crate) fn parse_axis(text: &str) -> Result<TypedAxis, String> {
    const FORM: &str = "hint: an axis is NAME=FROM:TO:COUNT, such as theta=-pi:pi:200, or NAME=FROM:TO:COUNT:log, such as mu=0.01:1:200:log";
    let (name, range) = text.split_once('=').ok_or(FORM)?;
    let plain = name.trim().replace('-', "_");
    let varies = varied()
        .find(|varies| varies.name() == plain)
        .ok_or_else(|| {
            let known: Vec<&str> = varied().map(Varies::name).collect();
            let all = format!("axes are {}", known.join(", "));
            format!(
                "there is no axis '{name}'\n\nhint: {}",
                nearest::hint(name, known, &all)
            )
        })?;
    let parts: Vec<&str> = range.split(':').map(str::trim).collect();
    let (from, to, count, spacing) = match parts[..] {
        [from, to, count] => (from, to, count, Spacing::Even),
        [from, to, count, spacing] => {
            let spacing = [Spacing::Even, Spacing::Log]
                .into_iter()
                .find(|known| known.name() == spacing);
            (from, to, count, spacing.ok_or(FORM)?)
        }
        _ => return Err(FORM.to_owned()),
    };
    let end =
        |text| parse_number(text).ok_or_else(|| format!("'{text}' is not a number\n\n{FORM}"));
    let (from, to) = (end(from)?, end(to)?);
    let count = count
        .parse()
        .map_err(|_| format!("'{count}' is not a number of points\n\n{FORM}"))?;
    let axis = TypedAxis {
        varies,
        from,
        to,
        count,
        spacing,
    };
    Axis::new(axis.varies(), from, to, count)
        .and_then(|axis| axis.with_spacing(spacing))
        .map_err(|error| format!("{error}\n\n{FORM}"))?;
    Ok(axis)
}

/// What an axis can vary: the quantities of a motion, friction as one number, then those of them
/// that have a unit, in SI units.
pub(crate) fn varied() -> impl Iterator<Item = Varies> {
    let of = |quantity| Varies::One(quantity);
    Quantity::AXES
        .into_iter()
        .map(of)
        .chain([Varies::Friction])
        .chain(si_quantities().map(of))
}

pub(crate) fn si_quantities() -> impl Iterator<Item = Quantity> {
    Quantity::AXES.into_iter().filter_map(Quantity::si_twin)
}

/// A number, which may be written with π: `-pi`, `2pi`, `3*pi/4`.
pub(crate) fn parse_number(text: &str) -> Option<f64> {
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
        let axis = parse_axis("theta-rate=-4:4:9")
            .expect("an axis")
            .resolve(None)
            .expect("an axis");
        assert_eq!((axis.from(), axis.to(), axis.count()), (-4.0, 4.0, 9));
        for text in [
            "theta",
            "theta=1:2",
            "theta=1:2:3:4",
            "theta=1:2:0",
            "theta=1:2:-3",
            "theta=a:2:3",
        ] {
            assert!(parse_axis(text).is_err(), "{text}");
        }
    }
}
