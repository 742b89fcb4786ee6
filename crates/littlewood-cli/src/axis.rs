//! An axis as it is typed: `theta=-pi:pi:200`, or in SI units `theta_rate_rad_per_s=0:20:200`.

use core::f64::consts::PI;

use littlewood::{Quantity, Units};
use littlewood_sweep::{Axis, AxisError};

use crate::nearest;

/// An axis whose ends may be in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TypedAxis {
    /// With the unit of its ends.
    quantity: Quantity,
    from: f64,
    to: f64,
    count: usize,
}

impl TypedAxis {
    /// An axis without dimension.
    #[cfg(feature = "sweep")]
    pub(crate) const fn plain(quantity: Quantity, from: f64, to: f64, count: usize) -> Self {
        Self { quantity, from, to, count }
    }

    /// What varies along it, dimensionless.
    pub(crate) const fn quantity(&self) -> Quantity {
        self.quantity.dimensionless()
    }

    /// Whether its ends have a unit that has to be taken off.
    pub(crate) const fn is_si(&self) -> bool {
        self.quantity.is_si()
    }

    /// The axis without dimension. Ends that were given so are taken as they are, to the last bit.
    ///
    /// # Errors
    /// As [`Axis::new`].
    pub(crate) fn resolve(&self, units: Option<&Units>) -> Result<Axis, AxisError> {
        let end = |value| match units {
            Some(units) if self.is_si() => units.from_si(self.quantity.dimension(), value),
            Some(_) | None => value,
        };
        Axis::new(self.quantity(), end(self.from), end(self.to), self.count)
    }
}

/// An axis after a flag.
pub(crate) fn parse_axis(text: &str) -> Result<TypedAxis, String> {
    const FORM: &str = "hint: an axis is NAME=FROM:TO:COUNT, such as theta=-pi:pi:200";
    let (name, range) = text.split_once('=').ok_or(FORM)?;
    let plain = name.trim().replace('-', "_");
    let quantity = quantities().find(|quantity| quantity.name() == plain).ok_or_else(|| {
        let known: Vec<&str> = quantities().map(Quantity::name).collect();
        let all = format!("axes are {}", known.join(", "));
        format!("there is no axis '{name}'\n\nhint: {}", nearest::hint(name, known, &all))
    })?;
    let [from, to, count] = range.split(':').map(str::trim).collect::<Vec<_>>()[..] else {
        return Err(FORM.to_owned());
    };
    let end = |text| parse_number(text).ok_or_else(|| format!("'{text}' is not a number\n\n{FORM}"));
    let (from, to) = (end(from)?, end(to)?);
    let count = count.parse().map_err(|_| format!("'{count}' is not a number of points\n\n{FORM}"))?;
    let axis = TypedAxis { quantity, from, to, count };
    Axis::new(axis.quantity(), from, to, count).map_err(|error| format!("{error}\n\n{FORM}"))?;
    Ok(axis)
}

/// Quantities that an axis can vary: those of a motion, then those of them that have a unit, in SI units.
pub(crate) fn quantities() -> impl Iterator<Item = Quantity> {
    Quantity::AXES.into_iter().chain(si_quantities())
}

/// Quantities that an axis in SI units can vary.
pub(crate) fn si_quantities() -> impl Iterator<Item = Quantity> {
    Quantity::AXES.into_iter().filter_map(Quantity::si_twin)
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
    use littlewood::{Quantity, Units};

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
        let axis = parse_axis("theta-rate=-4:4:9").expect("an axis").resolve(None).expect("an axis");
        assert_eq!((axis.from(), axis.to(), axis.count()), (-4.0, 4.0, 9));
        for text in ["theta", "theta=1:2", "theta=1:2:3:4", "theta=1:2:0", "theta=1:2:-3", "theta=a:2:3"] {
            assert!(parse_axis(text).is_err(), "{text}");
        }
    }

    #[test]
    fn units_are_taken_off() {
        // m2 = 2 kg, R = 0.5 m, g = 8 m/s²: √(R/g) = 0.25 s, √(gR) = 2 m/s, m2 R² = 0.5 kg m².
        let units = Units::new(2.0, 0.5, 8.0).expect("units");
        for (text, quantity, to) in [
            ("theta_rate_rad_per_s=0:8:3", Quantity::ThetaRate, 2.0),
            ("slip_m_per_s=0:3:3", Quantity::Slip, 1.5),
            ("disc_mass_kg=0:1:3", Quantity::MassRatio, 0.5),
            ("offset_m=0:0.25:3", Quantity::Offset, 0.5),
            ("inertia_kg_m2=0:0.25:3", Quantity::Inertia, 0.5),
            ("mu_s=0:0.25:3", Quantity::MuS, 0.25),
        ] {
            let axis = parse_axis(text).expect("an axis").resolve(Some(&units)).expect("an axis");
            assert_eq!((axis.quantity(), axis.from(), axis.to()), (quantity, 0.0, to), "{text}");
        }
    }
}
