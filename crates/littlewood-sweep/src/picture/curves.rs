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
        let of_plane = [
            Varies::One(Quantity::Theta),
            Varies::One(Quantity::ThetaRate),
        ];
        if !of_plane.iter().all(|axis| varies.contains(axis)) {
            return Err(PictureError::NoCurves {
                reason: "its axes are others",
            });
        }
        if base.start.slip != 0.0 {
            return Err(PictureError::NoCurves {
                reason: "its starts have slip",
            });
        }
        if base.start.gap_rate != 0.0 {
            return Err(PictureError::NoCurves {
                reason: "its starts leave the plane",
            });
        }
        Ok(())
    }

    /// The curves f, n, that of lift-off, those of reverse chatter and the band of rest within the
    /// map.
    pub(super) fn curves(&self) -> Vec<(Curve, Vec<Place>)> {
        let Ok(hoop) = Hoop::new(self.grid.base().hoop) else {
            return Vec::new();
        };
        if !self.has_curves || self.counts.iter().any(|count| *count < 2) {
            return Vec::new();
        }
        let plane = PhasePlane::new(&hoop);
        let axes = self.grid.axes();
        let is_upright = axes[0].varies() == Varies::One(Quantity::Theta);
        let turned = |[x, y]: Place| if is_upright { [x, y] } else { [y, x] };
        let [x, y] = if is_upright { [0, 1] } else { [1, 0] }.map(|k: usize| {
            [
                axes[k].from().min(axes[k].to()),
                axes[k].from().max(axes[k].to()),
            ]
        });
        let window = Window { x, y };
        let place = |point: Place| {
            let point = turned(point);
            [0, 1].map(|k| along(&axes[k], point[k]))
        };
        [
            Curve::SlipLimit,
            Curve::NormalForceZero,
            Curve::LiftOff,
            Curve::ReverseChatter,
            Curve::BandOfRest,
        ]
        .into_iter()
        .flat_map(|curve| {
            curve
                .pieces(&plane, &window)
                .into_iter()
                .map(move |line| (curve, line))
        })
        .map(|(curve, line)| (curve, line.into_iter().map(place).collect()))
        .collect()
    }
}
