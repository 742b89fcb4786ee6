//! Lines over a map: the curves of the phase plane, and lines of constant value.

use littlewood::tables::Quantity;
use littlewood::theory::{Body, PhasePlane, closed_form};
use littlewood::{Direction, Hoop};
use littlewood_style::Curve;

use super::cells::Cell;
use super::error::PictureError;
use super::map::Picture;
use super::names::{along, is_flipped};
use super::scale::Scale;
use crate::axis::Varies;

/// A point of the map: fractions of the way to the right and upwards.
pub(super) type Point = [f64; 2];

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

    /// The curves f, n and that of lift-off, each in pieces of constant sign of θ′, within the map.
    pub(super) fn curves(&self) -> Vec<(Curve, Vec<Point>)> {
        let Ok(hoop) = Hoop::new(self.grid.base().hoop) else { return Vec::new() };
        let plane = PhasePlane::new(&hoop);
        let theta_first = self.grid.axes()[0].varies() == Varies::One(Quantity::Theta);
        let (theta, rate) = if theta_first { (0, 1) } else { (1, 0) };
        let [theta_axis, rate_axis] = [theta, rate].map(|k| &self.grid.axes()[k]);
        // A sample a pixel and more: the drawing has no finer steps.
        const SAMPLES: usize = 4000;
        let point = |angle: f64, speed: f64| -> Point {
            let mut point = [0.0; 2];
            point[theta] = along(theta_axis, angle);
            point[rate] = along(rate_axis, speed);
            point
        };
        let trace = |curve: Curve, speed: &dyn Fn(f64) -> Option<f64>| {
            let mut pieces: Vec<(Curve, Vec<Point>)> = Vec::new();
            for sign in [1.0, -1.0] {
                let mut piece: Vec<Point> = Vec::new();
                for i in 0..=SAMPLES {
                    let angle = theta_axis.between(i as f64 / SAMPLES as f64);
                    let place = speed(angle).map(|speed| point(angle, sign * speed));
                    match place.filter(|place| place.iter().all(|at| (-1.0..2.0).contains(at))) {
                        Some(place) => piece.push(place),
                        None => pieces.extend(finished(curve, &mut piece)),
                    }
                }
                pieces.extend(finished(curve, &mut piece));
            }
            pieces
        };
        let mut curves: Vec<(Curve, Vec<Point>)> = Vec::new();
        match hoop.body() {
            Body::Heavy(_) => {
                for direction in [Direction::Positive, Direction::Negative] {
                    curves.extend(trace(Curve::SlipLimit, &|angle| plane.slip_rate(angle, direction)));
                }
            }
            Body::Massless(massless) => {
                if let Some(limit) = closed_form::slip_angle(&massless, hoop.mu_s()) {
                    let (low, high) =
                        (theta_axis.from().min(theta_axis.to()), theta_axis.from().max(theta_axis.to()));
                    let turn = core::f64::consts::TAU;
                    let first = libm::floor(low / turn) as i64 - 1;
                    let last = libm::ceil(high / turn) as i64 + 1;
                    for angle in (first..=last)
                        .flat_map(|k| [-limit, limit].map(|angle| angle + turn * k as f64))
                        .filter(|angle| (low..=high).contains(angle))
                    {
                        let top = plane.normal_force_rate(angle).unwrap_or(1.0);
                        let line: Vec<Point> =
                            (0..=64).map(|i| point(angle, top * (f64::from(i) / 32.0 - 1.0))).collect();
                        curves.push((Curve::SlipLimit, line));
                    }
                }
            }
        }
        curves.extend(trace(Curve::NormalForceZero, &|angle| plane.normal_force_rate(angle)));
        curves.extend(trace(Curve::LiftOff, &|angle| plane.lift_off_rate(angle)));
        curves.into_iter().filter(|(_, points)| points.iter().any(is_within)).collect()
    }

    /// Lines along which the number of the shade is that of a tick of the scale.
    pub(super) fn contours(&self, scale: &Scale) -> Vec<[Point; 2]> {
        let [nx, ny] = self.counts;
        if !self.has_contours || nx < 2 || ny < 2 {
            return Vec::new();
        }
        let axes = self.grid.axes();
        let place = |i: usize, j: usize| -> Point {
            let mut point = [i as f64 / (nx - 1) as f64, j as f64 / (ny - 1) as f64];
            for (at, axis) in point.iter_mut().zip(axes) {
                if is_flipped(axis) {
                    *at = 1.0 - *at;
                }
            }
            point
        };
        let mut lines = Vec::new();
        let unit = super::names::unit_of(self.shade, self.units.as_ref());
        let levels: Vec<f64> = scale.ticks(unit, 10).into_iter().map(|tick| tick.value).collect();
        for j in 0..ny - 1 {
            for i in 0..nx - 1 {
                let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                let cells: [Cell; 4] = corners.map(|(i, j)| self.cells[j * nx + i]);
                if !cells.iter().all(|cell| cell.key == cells[0].key && cell.number.is_finite()) {
                    continue;
                }
                let numbers = cells.map(|cell| cell.number);
                let (low, high) =
                    numbers.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &value| {
                        (f64::min(low, value), f64::max(high, value))
                    });
                let crossed: Vec<f64> =
                    levels.iter().copied().filter(|level| (low..high).contains(level)).collect();
                // A jump, along which all lines would run.
                if crossed.len() > MOST_LEVELS {
                    continue;
                }
                for level in crossed {
                    let mut crossings: Vec<Point> = Vec::new();
                    for (a, b) in [(0, 1), (1, 2), (2, 3), (3, 0)] {
                        let (va, vb) = (cells[a].number - level, cells[b].number - level);
                        if (va < 0.0) != (vb < 0.0) {
                            let t = va / (va - vb);
                            let (pa, pb) =
                                (place(corners[a].0, corners[a].1), place(corners[b].0, corners[b].1));
                            crossings.push([0, 1].map(|k| pa[k] + t * (pb[k] - pa[k])));
                        }
                    }
                    lines.extend(crossings.chunks_exact(2).map(|pair| [pair[0], pair[1]]));
                }
            }
        }
        lines
    }
}

/// Lines through a cell, at most.
const MOST_LEVELS: usize = 2;

fn is_within(point: &Point) -> bool {
    point.iter().all(|at| (0.0..=1.0).contains(at))
}

fn finished(curve: Curve, piece: &mut Vec<Point>) -> Option<(Curve, Vec<Point>)> {
    let piece = core::mem::take(piece);
    (piece.len() > 1).then_some((curve, piece))
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
        Picture::new(&grid, Limits::default(), Shade::Class, PictureSize::default()).expect("a picture")
    }

    #[test]
    fn each_curve_is_where_its_equation_holds() {
        let heavy = HoopParameters::thin(1.0).with_friction(0.5, 0.4);
        let massless = HoopParameters::thin(0.0).with_friction(0.5, 0.5);
        for (parameters, theta_first) in [(heavy, true), (heavy, false), (massless, true)] {
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
                        Curve::LiftOff => (1.0 - hoop.h() * libm::cos(theta) * rate * rate, 2),
                        Curve::Separatrix | Curve::Level => (f64::NAN, 0),
                    };
                    // Far up the plane the forces are large, and so are their errors.
                    assert!(miss.abs() < 1e-9 * (1.0 + rate * rate), "{curve:?} at {theta} {rate}: {miss}");
                    seen[number] += 1;
                }
            }
            assert!(seen.iter().all(|count| *count > 10), "{seen:?}");
        }
    }
}
