//! Axes of the quantities that figures show.

use core::f64::consts::{PI, TAU};
use std::borrow::Cow;

use littlewood::Hoop;
use littlewood::tables::Quantity;
use littlewood::theory::{PhasePlane, Stability, Window};
use littlewood_draw::{PlotAxis, Scale, marked};
use littlewood_style::ticks::Tick;

use crate::columns::dimension;
use crate::wording::Wording;

impl Wording {
    /// θ.
    pub(crate) fn angle(self, range: [f64; 2]) -> PlotAxis {
        self.angle_with(range, Vec::new())
    }

    /// θ, with ticks of its own.
    pub(crate) fn angle_with(self, range: [f64; 2], own: Vec<Tick>) -> PlotAxis {
        PlotAxis { scale: Scale::Angle(own), ..self.of_quantity(Quantity::Theta, range) }
    }

    /// θ′.
    pub(crate) fn rate(self, range: [f64; 2]) -> PlotAxis {
        self.of_quantity(Quantity::ThetaRate, range)
    }

    /// η′.
    pub(crate) fn slip(self, range: [f64; 2]) -> PlotAxis {
        self.of_quantity(Quantity::Slip, range)
    }

    /// τ.
    pub(crate) fn clock(self, range: [f64; 2]) -> PlotAxis {
        self.axis(Quantity::Time.name(), &self.time(), range)
    }

    fn of_quantity(self, quantity: Quantity, range: [f64; 2]) -> PlotAxis {
        self.axis(quantity.name(), &marked(quantity.sign()), range)
    }

    /// Any column, with its symbol and round ticks.
    pub(crate) fn axis(self, column: &'static str, symbol: &str, range: [f64; 2]) -> PlotAxis {
        let title = self.title(symbol, dimension(column));
        PlotAxis { column: Cow::Borrowed(column), title, range, scale: Scale::Round, ticks: Vec::new() }
    }
}

/// The window of the plane of rolling: a turn about the stable equilibrium, half a quarter more on either side; rates
/// to well above the separatrix and, where that is not far above it, the least rate at which N = 0.
pub(crate) fn plane_window(hoop: &Hoop) -> Window {
    let plane = PhasePlane::new(hoop);
    let stable = plane.equilibria().into_iter().find(|it| matches!(it.stability, Stability::Stable { .. }));
    let separatrix = plane.separatrix_rate(stable.map_or(PI, |it| it.theta.rem_euclid(TAU)));
    let is_level = hoop.slope() == 0.0;
    // On a slope wells are shallow or absent, and rolling downhill goes on to the loss of the normal force.
    let unloading = plane.normal_force_rate(0.0).filter(|rate| !is_level || *rate <= FAR * separatrix);
    // A light hoop is fast at the bottom, and loses the plane long before.
    let most = unloading.map_or(f64::INFINITY, |rate| f64::max(FASTEST, rate));
    let rate = f64::max(f64::min(separatrix, most), unloading.unwrap_or(0.0));
    window_to(if rate > 0.0 { rate } else { plane.lift_off_rate(0.0).unwrap_or(1.0) })
}

/// The same with the least rate at which N = 0 in any case.
pub(crate) fn outcome_window(hoop: &Hoop) -> Window {
    let unloading = PhasePlane::new(hoop).normal_force_rate(0.0);
    let narrow = plane_window(hoop);
    unloading.map(window_to).filter(|wide| wide.y[1] > narrow.y[1]).unwrap_or(narrow)
}

/// How far above the separatrix N = 0 is still shown.
const FAR: f64 = 8.0;
/// Separatrices up to this rate are shown whole.
const FASTEST: f64 = 10.0 / 3.0;

/// Rates to 2.4 times this one, rounded up.
fn window_to(rate: f64) -> Window {
    let needed = 2.4 * rate;
    let step = 0.5 * libm::pow(10.0, libm::floor(libm::log10(needed)));
    let most = step * libm::ceil(needed / step);
    Window { x: [-0.5 * PI, 2.5 * PI], y: [-most, most] }
}
