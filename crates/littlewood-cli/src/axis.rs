//! An axis as it is typed: `theta=-pi:pi:200`, or in SI units `theta_rate_rad_per_s=0:20:200`.

use core::f64::consts::PI;

use littlewood::{Quantity, Units};
use littlewood_sweep::{Axis, AxisError, Coordinate};

use crate::values::{dimensionless, si_twin};

/// An axis whose ends may be in SI units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct TypedAxis {
    quantity: Quantity,
    coordinate: Coordinate,
    from: f64,
    to: f64,
    count: usize,
}

impl TypedAxis {
    /// An axis without dimension.
    pub(crate) const fn plain(coordinate: Coordinate, from: f64, to: f64, count: usize) -> Self {
        Self { quantity: coordinate.quantity(), coordinate, from, to, count }
    }

    /// What varies along it.
    pub(crate) const fn coordinate(&self) -> Coordinate {
        self.coordinate
    }

    /// Whether its ends have a unit that has to be taken off.
    pub(crate) fn is_si(&self) -> bool {
        self.quantity != self.coordinate.quantity()
    }

    /// The axis without dimension. Ends that were given so are taken as they are, to the last bit.
    ///
    /// # Errors
    /// As [`Axis::new`].
    pub(crate) fn resolve(&self, units: Option<&Units>) -> Result<Axis, AxisError> {
        let unit = match (self.quantity, units) {
            (Quantity::ThetaRateRadPerS, Some(units)) => 1.0 / units.time_s,
            (Quantity::SlipMPerS, Some(units)) => units.velocity_m_per_s(),
            (Quantity::DiscMassKg, Some(units)) => units.mass_kg,
            (Quantity::OffsetM, Some(units)) => units.length_m,
            (Quantity::InertiaKgM2, Some(units)) => units.inertia_kg_m2(),
            _ => 1.0,
        };
        Axis::new(self.coordinate, self.from / unit, self.to / unit, self.count)
    }
}

/// An axis after a flag.
pub(crate) fn parse_axis(text: &str) -> Result<TypedAxis, String> {
    const FORM: &str = "hint: an axis is NAME=FROM:TO:COUNT, such as theta=-pi:pi:200";
    let (name, range) = text.split_once('=').ok_or(FORM)?;
    let (quantity, coordinate) = find(&name.trim().replace('-', "_")).ok_or_else(|| {
        let known: Vec<&str> = names().map(|(quantity, _)| quantity.name()).collect();
        format!("there is no quantity '{name}'\n\nhint: axes are {}", known.join(", "))
    })?;
    let [from, to, count] = range.split(':').map(str::trim).collect::<Vec<_>>()[..] else {
        return Err(FORM.to_owned());
    };
    let end = |text| parse_number(text).ok_or_else(|| format!("'{text}' is not a number\n\n{FORM}"));
    let (from, to) = (end(from)?, end(to)?);
    let count = count.parse().map_err(|_| format!("'{count}' is not a number of points\n\n{FORM}"))?;
    Axis::new(coordinate, from, to, count).map_err(|error| format!("{error}\n\n{FORM}"))?;
    Ok(TypedAxis { quantity, coordinate, from, to, count })
}

/// What an axis may be of: the coordinates, then those of them that have a unit, in SI units.
fn names() -> impl Iterator<Item = (Quantity, Coordinate)> {
    let plain = Coordinate::ALL.into_iter().map(|coordinate| (coordinate.quantity(), coordinate));
    let si = Coordinate::ALL
        .into_iter()
        .filter_map(|coordinate| si_twin(coordinate.quantity()).map(|quantity| (quantity, coordinate)));
    plain.chain(si)
}

fn find(name: &str) -> Option<(Quantity, Coordinate)> {
    let found = names().find(|(quantity, _)| quantity.name() == name)?;
    debug_assert_eq!(dimensionless(found.0), found.1.quantity());
    Some(found)
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
    use littlewood::Units;
    use littlewood_sweep::Coordinate;

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
        for (text, coordinate, to) in [
            ("theta_rate_rad_per_s=0:8:3", Coordinate::ThetaRate, 2.0),
            ("slip_m_per_s=0:3:3", Coordinate::Slip, 1.5),
            ("disc_mass_kg=0:1:3", Coordinate::MassRatio, 0.5),
            ("offset_m=0:0.25:3", Coordinate::Offset, 0.5),
            ("inertia_kg_m2=0:0.25:3", Coordinate::Inertia, 0.5),
            ("mu_s=0:0.25:3", Coordinate::MuS, 0.25),
        ] {
            let axis = parse_axis(text).expect("an axis").resolve(Some(&units)).expect("an axis");
            assert_eq!((axis.coordinate(), axis.from(), axis.to()), (coordinate, 0.0, to), "{text}");
        }
    }
}
