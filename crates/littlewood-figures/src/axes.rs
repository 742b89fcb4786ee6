//! Axes of the quantities that figures show.

use core::f64::consts::{PI, TAU};
use littlewood::Hoop;
use littlewood::tables::Quantity;
use littlewood::theory::{PhasePlane, Stability, Window};
use littlewood_draw::{PlotAxis, Range, Scale, marked};
use littlewood_style::ticks::Tick;

use crate::columns::dimension;
use crate::wording::Wording;

impl Wording {
    /// θ.
    pub(crate) fn angle(self, range: Range) -> PlotAxis {
        self.angle_with(range, Vec::new())
    }

    /// θ, with ticks of its own.
    pub(crate) fn angle_with(self, range: Range, own: Vec<Tick>) -> PlotAxis {
        PlotAxis {
            scale: Scale::Angle(own),
            ..self.of_quantity(Quantity::Theta, range)
        }
    }

    /// θ′.
    pub(crate) fn rate(self, range: Range) -> PlotAxis {
        self.of_quantity(Quantity::ThetaRate, range)
    }

    /// η′.
    pub(crate) fn slip(self, range: Range) -> PlotAxis {
        self.of_quantity(Quantity::Slip, range)
    }

    /// τ.
    pub(crate) fn clock(self, range: Range) -> PlotAxis {
        self.axis(Quantity::Time.name(), &self.time(), range)
    }

    fn of_quantity(self, quantity: Quantity, range: Range) -> PlotAxis {
        self.axis(quantity.name(), &marked(quantity.sign()), range)
    }

    /// Any column, with its symbol and round ticks.
    pub(crate) fn axis(self, column: &'static str, symbol: &str, range: Range) -> PlotAxis {
        let title = self.title(symbol, dimension(column));
        PlotAxis::new(column, title, range)
    }
}

/// The window of the plane of rolling: a turn about the stable equilibrium, half a quarter more on
/// either side; rates to well above the separatrix and the least rate at which N = 0.
pub(crate) fn plane_window(hoop: &Hoop) -> Window {
    let [separatrix, unloading] = rates(hoop);
    // A light hoop is fast at the bottom, and loses the plane long before.
    let most = if unloading > 0.0 {
        f64::max(FASTEST, unloading)
    } else {
        f64::INFINITY
    };
    let rate = f64::max(f64::min(separatrix, most), unloading);
    window_to(if rate > 0.0 {
        rate
    } else {
        PhasePlane::new(hoop).lift_off_rate(0.0).unwrap_or(1.0)
    })
}

/// Greatest rate that is shown of Littlewood's hoop, whose rate has no bound.
const LITTLEWOOD: f64 = 2.5;

/// The window of a motion of Littlewood's hoop, a turn, by its first rate.
pub(crate) fn littlewood_window(first_rate: f64) -> Window {
    let most = f64::max(LITTLEWOOD, 1.08 * first_rate.abs());
    Window {
        x: [-PI, PI],
        y: [-most, most],
    }
}

/// The same for what shows curves of both rates: where these are far apart, so that the axis of
/// rates is logarithmic, *f* and *n* have more of it.
pub(crate) fn portrait_window(hoop: &Hoop) -> Window {
    let window = plane_window(hoop);
    let more = if linear_to(hoop, window.y[1]).is_finite() {
        5.0
    } else {
        1.0
    };
    Window {
        y: window.y.map(|rate| more * rate),
        ..window
    }
}

/// θ′ of the separatrix at the stable equilibrium, and the least θ′ of rolling with N = 0, without
/// rolling resistance, which hardly changes them; each is 0 if it does not exist.
fn rates(hoop: &Hoop) -> [f64; 2] {
    let free = Hoop::new(hoop.parameters().with_rolling_resistance(0.0));
    let plane = PhasePlane::new(&free.unwrap_or(*hoop));
    let stable = plane
        .equilibria()
        .into_iter()
        .find(|it| matches!(it.stability, Stability::Stable { .. }));
    let separatrix = plane.separatrix_rate(stable.map_or(PI, |it| it.theta.rem_euclid(TAU)));
    [separatrix, plane.normal_force_rate(0.0).unwrap_or(0.0)]
}

/// θ′ of the separatrix at the stable equilibrium, without rolling resistance.
pub(crate) fn separatrix_rate(hoop: &Hoop) -> f64 {
    rates(hoop)[0]
}

/// Where an axis of rates up to this one begins to be logarithmic: at the less of both rates, if
/// that would be small on it.
pub(crate) fn linear_to(hoop: &Hoop, most: f64) -> f64 {
    let [separatrix, unloading] = rates(hoop);
    let least = f64::min(separatrix, unloading);
    // On a slope wells are shallow, and rolling downhill goes on far beyond them.
    if least > 0.0 && most > FAR * least && hoop.slope() == 0.0 {
        least
    } else {
        f64::INFINITY
    }
}

/// How far a linear axis goes beyond a rate that matters.
const FAR: f64 = 20.0;
/// Separatrices up to this rate are shown whole.
const FASTEST: f64 = 10.0 / 3.0;

/// Rates to 2.4 times this one, rounded up.
fn window_to(rate: f64) -> Window {
    let needed = 2.4 * rate;
    let step = 0.5 * libm::pow(10.0, libm::floor(libm::log10(needed)));
    let most = step * libm::ceil(needed / step);
    Window {
        x: [-0.5 * PI, 2.5 * PI],
        y: [-most, most],
    }
}
