//! The ticks and the names of axes, and units as print has them.

use crate::axis::{Axis, Coordinate};
use littlewood_style::ticks::{self, Tick};

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
    match axis.coordinate() {
        Coordinate::Theta => ticks::angular(low, high, most),
        _ => ticks::round(low, high, most),
    }
}

pub(super) fn axis_name(coordinate: Coordinate) -> String {
    match coordinate {
        Coordinate::ThetaRate | Coordinate::Slip => {
            format!("{}  ({})", coordinate.symbol(), pretty_unit(coordinate.unit()))
        }
        _ => coordinate.symbol().to_owned(),
    }
}

/// A unit as print has it.
pub(super) fn pretty_unit(unit: &str) -> String {
    match unit {
        "sqrt(R/g)" => "√(R/g)".to_owned(),
        "sqrt(g/R)" => "√(g/R)".to_owned(),
        "sqrt(g R)" => "√(gR)".to_owned(),
        "m2 g R" => "m₂gR".to_owned(),
        other => other.to_owned(),
    }
}
