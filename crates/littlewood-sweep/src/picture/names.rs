//! The ticks and the names of axes, titles, and what is fixed; texts with marks.

use core::f64::consts::PI;

use littlewood::si::Units;
use littlewood::tables::{
    DerivativeColumn, Dimension, PhaseCode, PhaseSequence, Quantity, SummaryColumn,
};
use littlewood_draw::marked;
use littlewood_style::ticks::{self, Tick, minus};

use super::map::Picture;
use super::shade::Shade;
use crate::axis::{Axis, Spacing, Varies};

/// What one of the dimensionless unit is in the unit that is printed.
fn unit(units: Option<&Units>, dimension: Dimension) -> f64 {
    units.map_or(1.0, |units| units.unit(dimension))
}

/// The sign of a unit: that of (2.9), or in SI; of an angle its unit.
fn unit_sign(units: Option<&Units>, dimension: Dimension) -> String {
    match (units, dimension) {
        (None, Dimension::Angle) | (Some(_), _) => upright(dimension.si_sign()),
        (None, _) => marked(dimension.scale_sign()),
    }
}

fn upright(unit: &str) -> String {
    unit.replace('²', "^{2}")
}

fn with_unit(name: &str, unit: &str) -> String {
    if unit.is_empty() {
        name.to_owned()
    } else {
        format!("{name}  ({unit})")
    }
}

/// A sign as print has it: in SI units the quantity with a dimension.
fn sign(units: Option<&Units>, varies: Varies) -> String {
    marked(match varies {
        Varies::One(quantity) if units.is_some() => quantity.si_twin().unwrap_or(quantity).sign(),
        Varies::One(_) | Varies::Friction => varies.sign(),
    })
}

/// The dimension in which an axis is printed: its own in SI units, else none that (2.9) has taken
/// off.
pub(super) fn axis_name(axis: &Axis, units: Option<&Units>) -> String {
    let varies = axis.varies();
    let unit = match (varies, units) {
        (Varies::One(Quantity::Theta), _) | (Varies::One(_), Some(_)) => {
            upright(varies.dimension().si_sign())
        }
        (Varies::One(quantity), None) => marked(quantity.unit_sign()),
        (Varies::Friction, _) => String::new(),
    };
    with_unit(&sign(units, varies), &unit)
}

/// Where a value lies, from 0 at the left or at the bottom to 1.
pub(super) fn along(axis: &Axis, value: f64) -> f64 {
    if axis.count() < 2 {
        return 0.5;
    }
    let fraction = axis.fraction(value);
    if is_flipped(axis) {
        1.0 - fraction
    } else {
        fraction
    }
}

/// Whether an axis begins with its largest value; a map has that at the far end all the same.
pub(super) fn is_flipped(axis: &Axis) -> bool {
    axis.from() > axis.to()
}

pub(super) fn ticks_of(axis: &Axis, units: Option<&Units>, most: usize) -> Vec<Tick> {
    let dimension = axis.varies().dimension();
    let unit = unit(units, dimension);
    let (low, high) = (
        unit * axis.from().min(axis.to()),
        unit * axis.from().max(axis.to()),
    );
    if axis.count() < 2 {
        return vec![Tick {
            value: axis.from(),
            label: number(dimension, low),
        }];
    }
    let mut ticks = match axis.spacing() {
        Spacing::Log if low > 0.0 => ticks::logarithmic(low, high, most),
        Spacing::Log => ticks::logarithmic(-high, -low, most)
            .into_iter()
            .map(|tick| Tick {
                value: -tick.value,
                label: format!("−{}", tick.label),
            })
            .collect(),
        Spacing::Even if dimension == Dimension::Angle => ticks::angular(low, high, most),
        Spacing::Even => ticks::round(low, high, most),
    };
    for tick in &mut ticks {
        tick.value /= unit;
    }
    ticks
}

/// What a map shows, with its unit.
pub(super) fn title(shade: Shade, goes_on: bool, units: Option<&Units>) -> String {
    match shade {
        Shade::Class if goes_on => "First lift-off, else the outcome".to_owned(),
        Shade::Class => "Outcome".to_owned(),
        Shade::Sequence => "Sequence of phases".to_owned(),
        Shade::EnergyLost => with_unit("Energy lost", &unit_sign(units, Dimension::Energy)),
        Shade::Column(column) => with_unit(
            &capitalised(column.long_name()),
            &unit_sign(units, column.dimension()),
        ),
        Shade::Derivative(DerivativeColumn { number, quantity }) => {
            let [over, under] =
                [number.dimension(), quantity.dimension()].map(|of| unit_sign(units, of));
            let unit = match (over.is_empty(), under.is_empty()) {
                (_, true) => over,
                (true, false) => format!("1/({under})"),
                (false, false) => format!("{over}/({under})"),
            };
            let sign = sign(units, Varies::One(quantity));
            with_unit(
                &format!("Sensitivity of the {} to {sign}", number.long_name()),
                &unit,
            )
        }
    }
}

/// What one on the scale of a shade is in the unit that is printed.
pub(super) fn unit_of(shade: Shade, units: Option<&Units>) -> f64 {
    match shade {
        Shade::Class | Shade::Sequence => 1.0,
        Shade::EnergyLost => unit(units, Dimension::Energy),
        Shade::Column(column) => unit(units, column.dimension()),
        Shade::Derivative(DerivativeColumn { number, quantity }) => {
            unit(units, number.dimension()) / unit(units, quantity.dimension())
        }
    }
}

/// What a point without a number is, in a map of them.
pub(super) const fn without_number(shade: Shade) -> &'static str {
    match shade {
        Shade::Class | Shade::Sequence => "",
        Shade::EnergyLost => "no value",
        Shade::Derivative(_) => "no derivative",
        Shade::Column(column) => match column {
            SummaryColumn::FirstSlipTime
            | SummaryColumn::LiftOffTime
            | SummaryColumn::JumpLength
            | SummaryColumn::JumpHeight
            | SummaryColumn::SettleTime => "does not happen",
            _ => "no value",
        },
    }
}

/// What a number of 0 is, where it has no place on the scale.
pub(super) const fn at_zero(shade: Shade) -> &'static str {
    match shade {
        Shade::Column(
            SummaryColumn::FirstSlipTime | SummaryColumn::LiftOffTime | SummaryColumn::SettleTime,
        ) => "at once",
        Shade::Class
        | Shade::Sequence
        | Shade::EnergyLost
        | Shade::Column(_)
        | Shade::Derivative(_) => "0",
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

/// A number as it is read: an angle as a fraction of π where it is one.
fn number(dimension: Dimension, value: f64) -> String {
    if dimension == Dimension::Angle
        && value != 0.0
        && let Some(text) = (1..=12).find_map(|under| {
            let over = value * f64::from(under) / PI;
            let whole = libm::round(over);
            // A few units of the last place: 3π/4 has been rounded.
            ((over - whole).abs() <= 4.0 * f64::EPSILON * over.abs())
                .then(|| ticks::of_pi(whole as i64, i64::from(under)))
        })
    {
        return text;
    }
    let rounded = libm::round(value * 1e6) / 1e6;
    let rounded = if rounded == 0.0 { value } else { rounded };
    minus(&rounded.to_string())
}

impl Picture {
    /// What is fixed, in signs.
    pub(super) fn fixed(&self) -> Vec<String> {
        let units = self.units.as_ref();
        let mut parts: Vec<String> = self
            .grid
            .fixed()
            .map(|(quantity, value)| {
                let dimension = quantity.dimension();
                let value = unit(units, dimension) * value;
                let text = number(dimension, value);
                let exact = text.contains('π') || text.replace('−', "-").parse() == Ok(value);
                let is_angle = dimension == Dimension::Angle;
                let has_unit = if is_angle {
                    value != 0.0 && !text.contains('π')
                } else {
                    units.is_some()
                };
                let unit = if has_unit { dimension.si_sign() } else { "" };
                let space = if unit.is_empty() { "" } else { " " };
                let equals = if exact || units.is_some() { '=' } else { '≈' };
                format!(
                    "{} {equals} {text}{space}{}",
                    sign(units, Varies::One(quantity)),
                    upright(unit)
                )
            })
            .collect();
        if let Some(units) = units {
            let of = |quantity: Quantity, value: f64| {
                let dimension = quantity.dimension();
                let unit = upright(dimension.si_sign());
                format!(
                    "{} = {} {unit}",
                    marked(quantity.sign()),
                    number(dimension, value)
                )
            };
            parts.push(of(Quantity::ParticleMassKg, units.mass_kg));
            parts.push(of(Quantity::RadiusM, units.length_m));
            parts.push(of(Quantity::GravityMPerS2, units.gravity_m_per_s2));
        }
        if let Some(law) = self.grid.base().hoop.restitution_law {
            parts.push(format!("restitution of {}", law.label()));
        }
        if let Some(until) = self.limits.until {
            let value = unit(units, Dimension::Time) * until;
            let text = number(Dimension::Time, value);
            let (sign, unit) = match units {
                None => (Quantity::Until.sign(), String::new()),
                Some(_) => ("t", format!(" {}", Dimension::Time.si_sign())),
            };
            parts.push(format!("followed to {} = {text}{unit}", marked(sign)));
        }
        parts
    }

    /// What the letters of the sequences mean that are named in the legend.
    pub(super) fn meanings(&self) -> Vec<String> {
        if self.shade != Shade::Sequence {
            return Vec::new();
        }
        let shown = self.ranking.iter().take(littlewood_style::RANKS);
        let texts: Vec<String> = shown
            .map(|bits| PhaseSequence::from_bits(*bits).to_string())
            .collect();
        PhaseCode::ALL
            .into_iter()
            .filter(|phase| texts.iter().any(|text| text.contains(phase.name())))
            .map(|phase| format!("{} {}", minus(phase.name()), phase.meaning()))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use littlewood::si::SiParameters;

    use super::*;

    #[test]
    fn axes_and_titles_have_signs_and_units() {
        let axis = |quantity| Axis::new(quantity, 0.0, 1.0, 3).expect("good");
        let name = |quantity| axis_name(&axis(quantity), None);
        assert_eq!(name(Quantity::Theta), "*θ*  (rad)");
        assert_eq!(name(Quantity::ThetaRate), "*θ*′  (√(*g*/*R*))");
        assert_eq!(name(Quantity::Inertia), "*I*_{zz}/(*m*_{2}*R*^{2})");
        assert_eq!(
            axis_name(
                &Axis::new(Varies::Friction, 0.0, 1.0, 3).expect("good"),
                None
            ),
            "*μ*"
        );
        let title = |shade| title(shade, false, None);
        assert_eq!(
            title(Shade::Column(SummaryColumn::JumpHeight)),
            "Height of the first jump  (*R*)"
        );
        assert_eq!(
            title(Shade::Column(SummaryColumn::EndTheta)),
            "Angle at the end  (rad)"
        );
        assert_eq!(title(Shade::EnergyLost), "Energy lost  (*m*_{2}*gR*)");
    }

    #[test]
    fn in_si_units_axes_titles_and_ticks_have_them() {
        // m2 = 2 kg, R = 0.5 m, g = 8 m/s²: √(R/g) = 0.25 s.
        let units = SiParameters {
            particle_mass_kg: 2.0,
            radius_m: 0.5,
            gravity_m_per_s2: 8.0,
            ..SiParameters::default()
        }
        .units()
        .expect("good");
        let axis = Axis::new(Quantity::ThetaRate, 0.0, 2.0, 3).expect("good");
        assert_eq!(axis_name(&axis, Some(&units)), "*dθ*/*dt*  (rad/s)");
        let last = ticks_of(&axis, Some(&units), 5).pop().expect("good");
        assert_eq!((last.value, last.label.as_str()), (2.0, "8"));
        let shade = Shade::Column(SummaryColumn::LiftOffTime);
        assert_eq!(
            (
                title(shade, false, Some(&units)),
                unit_of(shade, Some(&units))
            ),
            ("Time of lift-off  (s)".to_owned(), 0.25)
        );
    }

    #[test]
    fn fractions_of_pi_are_written_so() {
        for (value, text) in [
            (PI / 2.0, "π/2"),
            (-3.0 * PI / 4.0, "−3π/4"),
            (PI, "π"),
            (1.0, "1"),
            (0.0, "0"),
            (1.25, "1.25"),
            (2.0 * PI / 3.0, "2π/3"),
        ] {
            assert_eq!(number(Dimension::Angle, value), text);
        }
        assert_eq!(number(Dimension::Ratio, PI), "3.141593");
    }
}
