//! The ticks and the names of axes, and titles.

use littlewood::{Dimension, Quantity, SummaryColumn};
use littlewood_style::ticks::{self, Tick};

use super::map::Shade;
use crate::axis::Axis;

/// The lowest and the highest value that a picture shows: half a cell beyond the ends.
fn span(axis: &Axis, cells: usize) -> (f64, f64) {
    let half = if axis.count() > 1 {
        0.5 * (axis.to() - axis.from()).abs() / (cells - 1).max(1) as f64
    } else {
        0.5
    };
    (axis.from().min(axis.to()) - half, axis.from().max(axis.to()) + half)
}

/// Where a value lies, from 0 to 1.
pub(super) fn along(axis: &Axis, cells: usize, value: f64) -> f64 {
    let (low, high) = span(axis, cells);
    (value - low) / (high - low)
}

pub(super) fn ticks_of(axis: &Axis, cells: usize, most: usize) -> Vec<Tick> {
    let (low, high) = if axis.count() > 1 {
        (axis.from().min(axis.to()), axis.from().max(axis.to()))
    } else {
        span(axis, cells)
    };
    let is_angle = axis.quantity().dimension() == Dimension::Angle;
    if is_angle { ticks::angular(low, high, most) } else { ticks::round(low, high, most) }
}

/// The sign of a quantity with its unit.
pub(super) fn axis_name(quantity: Quantity) -> String {
    with_unit(quantity.sign(), quantity.unit_sign())
}

/// What a map shows, with its unit.
pub(super) fn title(shade: Shade) -> String {
    match shade {
        Shade::Class => "What becomes of the motion".to_owned(),
        Shade::Column(column) => with_unit(&capitalised(column.long_name()), unit_sign(column)),
    }
}

fn with_unit(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name}  ({unit})") }
}

/// The unit of a column as it is printed: the scale of (2.9), and of an angle its unit.
fn unit_sign(column: SummaryColumn) -> &'static str {
    match column.dimension() {
        Dimension::Angle => Dimension::Angle.si_sign(),
        dimension => dimension.scale_sign(),
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn axes_and_titles_have_signs_and_units() {
        assert_eq!(axis_name(Quantity::Theta), "θ  (rad)");
        assert_eq!(axis_name(Quantity::ThetaRate), "θ′  (√(g/R))");
        assert_eq!(axis_name(Quantity::Inertia), "Izz/(m₂R²)");
        assert_eq!(title(Shade::Column(SummaryColumn::JumpHeight)), "Height of the first jump  (R)");
        assert_eq!(title(Shade::Column(SummaryColumn::EndTheta)), "Angle at the end  (rad)");
    }
}
