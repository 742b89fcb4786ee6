//! The curves of the phase plane over a map.

use littlewood::Hoop;
use littlewood::tables::Quantity;
use littlewood::theory::{PhasePlane, Window};
use littlewood_style::Curve;

use super::error::PictureError;
use super::map::Picture;
use super::names::along;
use crate::axis::Varies;
use crate::regions::Place;

impl Picture {
    /// Why this map has no curves f and n, if it has none.
    pub(super) fn check_curves(&self) -> Result<(), PictureError> {
        let base = self.grid.base();
        let varies = [0, 1].map(|k| self.grid.axes()[k].varies());
        let of_plane = [Varies::One(Quantity::Theta), Varies::One(Quantity::ThetaRate)];
        if !of_plane.iter().all(|axis| varies.contains(axis)) {
            return Err(PictureError::NoCurves { reason: "its axes are others" });
        }
        if base.start.slip != 0.0 {
            return Err(PictureError::NoCurves { reason: "its starts have slip" });
        }
        if base.start.gap_rate != 0.0 {
            return Err(PictureError::NoCurves { reason: "its starts leave the plane" });
        }
        Ok(())
    }

    /// The curves f, n, that of lift-off and those of reverse chatter within the map.
    pub(super) fn curves(&self) -> Vec<(Curve, Vec<Place>)> {
        let Ok(hoop) = Hoop::new(self.grid.base().hoop) else { return Vec::new() };
        if !self.has_curves || self.counts.iter().any(|count| *count < 2) {
            return Vec::new();
        }
        let plane = PhasePlane::new(&hoop);
        let axes = self.grid.axes();
        let is_upright = axes[0].varies() == Varies::One(Quantity::Theta);
        let turned = |[x, y]: Place| if is_upright { [x, y] } else { [y, x] };
        let [x, y] = if is_upright { [0, 1] } else { [1, 0] }
            .map(|k: usize| [axes[k].from().min(axes[k].to()), axes[k].from().max(axes[k].to())]);
        let window = Window { x, y };
        let place = |point: Place| {
            let point = turned(point);
            [0, 1].map(|k| along(&axes[k], point[k]))
        };
        [Curve::SlipLimit, Curve::NormalForceZero, Curve::LiftOff, Curve::ReverseChatter]
            .into_iter()
            .flat_map(|curve| curve.pieces(&plane, &window).into_iter().map(move |line| (curve, line)))
            .map(|(curve, line)| (curve, line.into_iter().map(place).collect()))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use core::f64::consts::PI;

    use littlewood::tables::Setup;
    use littlewood::{HoopParameters, Limits, Start};

    use super::*;
    use crate::axis::Axis;
    use crate::grid::Grid;
    use crate::picture::{PictureSize, Shade};

    fn picture(hoop: HoopParameters, theta_first: bool) -> Picture {
        let theta = Axis::new(Quantity::Theta, -PI, PI, 20).expect("an axis");
        let rate = Axis::new(Quantity::ThetaRate, -4.0, 4.0, 20).expect("an axis");
        let axes = if theta_first { vec![theta, rate] } else { vec![rate, theta] };
        let grid = Grid::new(Setup::new(hoop, Start::at(0.0, 0.0)), axes).expect("a grid");
        let picture = Picture::new(&grid, Limits::default(), Shade::Class, PictureSize::default());
        picture.and_then(Picture::with_curves).expect("a picture")
    }

    #[test]
    fn each_curve_is_where_its_equation_holds() {
        let heavy = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
        let massless = HoopParameters::thin(0.0).with_friction(0.5, 0.5);
        let tilted = heavy.with_slope(0.4);
        let tilted_massless = massless.with_slope(0.3);
        let cases =
            [(heavy, true), (heavy, false), (tilted, true), (massless, true), (tilted_massless, true)];
        for (parameters, theta_first) in cases {
            let hoop = Hoop::new(parameters).expect("a hoop");
            let plane = PhasePlane::new(&hoop);
            let mut seen = [0; 3];
            for (curve, points) in picture(parameters, theta_first).curves() {
                for point in points {
                    let [x, y] = if theta_first { point } else { [point[1], point[0]] };
                    let (theta, rate) = (PI * (2.0 * x - 1.0), 4.0 * (2.0 * y - 1.0));
                    let forces = plane.forces(theta, rate);
                    let (miss, number) = match curve {
                        Curve::SlipLimit if forces.normal.abs() < 1e-9 => (forces.friction, 0),
                        Curve::SlipLimit => (forces.friction.abs() - 0.5 * forces.normal, 0),
                        Curve::NormalForceZero => (forces.normal, 1),
                        Curve::LiftOff => {
                            (libm::cos(hoop.slope()) - hoop.h() * libm::cos(theta) * rate * rate, 2)
                        }
                        Curve::Separatrix | Curve::ReverseChatter | Curve::Level => (f64::NAN, 0),
                    };
                    // Far up the plane the forces are large, and so are their errors.
                    assert!(miss.abs() < 1e-9 * (1.0 + rate * rate), "{curve:?} at {theta} {rate}: {miss}");
                    seen[number] += 1;
                }
            }
            // A massless hoop has verticals and lines, and never lifts off.
            let least = if parameters.mass_ratio > 0.0 { [10, 10, 10] } else { [4, 4, 0] };
            assert!(seen.iter().zip(least).all(|(count, least)| *count >= least), "{seen:?}");
            assert!(parameters.mass_ratio > 0.0 || seen[2] == 0, "{seen:?}");
        }
    }
}
