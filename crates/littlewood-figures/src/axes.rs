//! Axes of the quantities that figures show.

use core::f64::consts::PI;

use littlewood::{Dimension, Hoop, PhasePlane, Quantity};
use littlewood_style::ticks;

use crate::figure::PlotAxis;
use crate::trace::Window;
use crate::words::marked;

/// A quantity of a start along a motion, with its unit.
fn of_quantity(quantity: Quantity, range: [f64; 2]) -> PlotAxis {
    let unit = quantity.unit_sign();
    // The sign of the radian is a word.
    let unit = if quantity.dimension() == Dimension::Angle { unit.to_owned() } else { marked(unit) };
    plain(quantity.name(), &format!("{}  ({unit})", marked(quantity.sign())), range)
}

/// θ.
pub(crate) fn angle([from, to]: [f64; 2]) -> PlotAxis {
    PlotAxis { ticks: ticks::angular(from, to, 7), ..of_quantity(Quantity::Theta, [from, to]) }
}

/// θ′.
pub(crate) fn rate(range: [f64; 2]) -> PlotAxis {
    of_quantity(Quantity::ThetaRate, range)
}

/// η′.
pub(crate) fn slip(range: [f64; 2]) -> PlotAxis {
    of_quantity(Quantity::Slip, range)
}

/// τ.
pub(crate) fn time(range: [f64; 2]) -> PlotAxis {
    of_quantity(Quantity::Time, range)
}

/// Any quantity, with round ticks.
pub(crate) fn plain(column: &'static str, title: &str, [from, to]: [f64; 2]) -> PlotAxis {
    PlotAxis { column, title: title.to_owned(), range: [from, to], ticks: ticks::round(from, to, 7) }
}

/// The window of the plane of rolling: a turn about the stable equilibrium, half a quarter more on either side; rates
/// to well above the separatrix and the least rate at which N = 0.
pub(crate) fn plane_window(hoop: &Hoop) -> Window {
    let plane = PhasePlane::new(hoop);
    let unloading = plane.normal_force_rate(0.0).unwrap_or(0.0);
    let needed = 2.4 * f64::max(plane.separatrix_rate(PI), f64::min(unloading, 4.0));
    let most = (0.5 * libm::ceil(2.0 * needed)).clamp(0.5, 8.0);
    Window { x: [-0.5 * PI, 2.5 * PI], y: [-most, most] }
}
