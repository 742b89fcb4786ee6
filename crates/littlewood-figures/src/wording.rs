//! Numbers, units and symbols in the system of units of a figure.

use littlewood::si::{SiSetup, Units};
use littlewood::tables::{Dimension, Group, Quantity, Setup};
use littlewood::{Hoop, Start};
use littlewood_draw::{angle, marked, short};

/// Parameters on which rolling depends.
const ROLLING: [Quantity; 6] = [
    Quantity::MassRatio,
    Quantity::Offset,
    Quantity::Inertia,
    Quantity::Slope,
    Quantity::RollingResistance,
    Quantity::MuS,
];

/// How a figure says numbers: in the units of (2.9), or in SI units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wording {
    pub(crate) units: Option<Units>,
}

/// A symbol and its unit, if it has one.
fn with_unit(symbol: &str, unit: &str) -> String {
    if unit.is_empty() {
        symbol.to_owned()
    } else {
        format!("{symbol}  ({unit})")
    }
}

impl Wording {
    /// The unit of a dimension, with marks; empty for a ratio.
    pub(crate) fn unit(self, dimension: Dimension) -> String {
        match (self.units, dimension) {
            // The sign of the radian is a word.
            (Some(_), _) | (None, Dimension::Angle) => dimension.si_sign().replace('²', "^{2}"),
            (None, _) => marked(dimension.scale_sign()),
        }
    }

    /// Title of an axis: a symbol, with marks, and its unit.
    pub(crate) fn title(self, symbol: &str, dimension: Dimension) -> String {
        with_unit(symbol, &self.unit(dimension))
    }

    /// Symbol of the time, with marks.
    pub(crate) fn time(self) -> String {
        let quantity = Quantity::Time;
        marked(
            self.units
                .and(quantity.si_twin())
                .unwrap_or(quantity)
                .sign(),
        )
    }

    /// A number for print, in the unit of a dimension, without it.
    pub(crate) fn number(self, value: f64, dimension: Dimension) -> String {
        short(
            self.units
                .map_or(value, |units| units.to_si(dimension, value)),
        )
    }

    /// A number as it stands in a picture: with its unit in SI units, the axes tell the others.
    pub(crate) fn value(self, value: f64, dimension: Dimension) -> String {
        if self.units.is_some() {
            self.quantity(value, dimension)
        } else {
            short(value)
        }
    }

    /// A number with its unit.
    pub(crate) fn quantity(self, value: f64, dimension: Dimension) -> String {
        let unit = self.unit(dimension);
        let number = self.number(value, dimension);
        if unit.is_empty() {
            number
        } else {
            format!("{number} {unit}")
        }
    }

    /// The parameters of a hoop; with the law, if it has a coefficient of restitution.
    pub(crate) fn hoop(self, hoop: &Hoop) -> String {
        let law = hoop
            .restitution()
            .map_or_else(String::new, |e| format!(", law: {}", e.law().label()));
        self.parameters(hoop, &Quantity::HOOP) + &law
    }

    /// Those parameters of a hoop on which rolling depends.
    pub(crate) fn rolling(self, hoop: &Hoop) -> String {
        self.parameters(hoop, &ROLLING)
    }

    /// Those parameters of a hoop that do not concern friction in slip.
    pub(crate) fn body(self, hoop: &Hoop) -> String {
        self.parameters(hoop, &ROLLING[..5])
    }

    fn parameters(self, hoop: &Hoop, quantities: &[Quantity]) -> String {
        let setup = Setup::new(hoop.parameters(), Start::default());
        let Some(units) = self.units else {
            let words = quantities.iter().filter_map(|quantity| {
                Some(format!(
                    "{} = {}",
                    marked(quantity.sign()),
                    short(setup.said(*quantity)?)
                ))
            });
            return words.collect::<Vec<_>>().join(", ");
        };
        let si = SiSetup::new(&setup, &units);
        let twins = quantities
            .iter()
            .map(|quantity| quantity.si_twin().unwrap_or(*quantity));
        let of_units = Quantity::SI_HOOP
            .into_iter()
            .filter(|quantity| quantity.group() == Group::Units);
        let words = twins.chain(of_units).filter_map(|quantity| {
            let value = short(si.said(quantity)?);
            let unit = quantity.unit_sign().replace('²', "^{2}");
            Some(
                format!("{} = {value} {unit}", marked(quantity.sign()))
                    .trim_end()
                    .to_owned(),
            )
        });
        words.collect::<Vec<_>>().join(", ")
    }

    /// A start.
    pub(crate) fn start(self, hoop: &Hoop, start: &Start) -> String {
        let setup = Setup::new(hoop.parameters(), *start);
        let words: Vec<String> = Quantity::START
            .into_iter()
            .filter(|quantity| quantity.group() == Group::Start)
            .filter_map(|quantity| {
                let value = setup.said(quantity)?;
                let dimension = quantity.dimension();
                let number = if dimension == Dimension::Angle {
                    angle(value)
                } else {
                    self.value(value, dimension)
                };
                Some(format!("{}(0) = {number}", marked(quantity.sign())))
            })
            .collect();
        words.join(", ")
    }

    /// What a caption has to say of the units.
    pub(crate) fn note(self) -> &'static str {
        if self.units.is_some() {
            " Axes and values in SI units, primes for derivatives with respect to the time *t*; formulas in the units of \
             (2.9), *m*_{2} = *R* = *g* = 1."
        } else {
            ""
        }
    }
}

#[cfg(test)]
mod tests {
    use littlewood::si::SiParameters;

    use super::*;

    #[test]
    fn a_time_is_converted_and_has_its_unit() {
        let units = SiParameters {
            particle_mass_kg: 0.5,
            radius_m: 0.4,
            gravity_m_per_s2: 10.0,
            ..SiParameters::default()
        }
        .units()
        .expect("units");
        let (si, own) = (Wording { units: Some(units) }, Wording { units: None });
        // √(R/g) = 0.2 s.
        assert_eq!(si.quantity(2.0, Dimension::Time), "0.4 s");
        assert_eq!(own.quantity(2.0, Dimension::Time), "2 √(*R*/*g*)");
        assert_eq!(si.title("*N*", Dimension::Force), "*N*  (N)");
        assert_eq!(
            (si.time(), own.time()),
            ("*t*".to_owned(), "*τ*".to_owned())
        );
    }
}
