//! Figures in SI units.

use littlewood::si::Units;
use littlewood::tables::Dimension;
use littlewood_draw::{Figure, Mark, Panel, View};

use crate::columns::{LOG_GAP_RATE, dimension, si_name};

/// A figure with its numbers in SI units, and columns named so.
pub(crate) fn converted(mut figure: Figure, units: &Units) -> Figure {
    figure
        .panels
        .iter_mut()
        .for_each(|panel| convert(panel, units));
    figure
}

/// A value of a column in SI units.
fn in_si(units: &Units, column: &str, value: f64) -> f64 {
    if column == LOG_GAP_RATE {
        return value + libm::log10(units.unit(Dimension::Velocity));
    }
    units.to_si(dimension(column), value)
}

fn convert(panel: &mut Panel, units: &Units) {
    let axes = match &mut panel.view {
        View::Plane { x, y, .. } => vec![x, y],
        View::Space { x, y, z, .. } => vec![x, y, z],
    };
    for label in &mut panel.labels {
        for (value, axis) in label.at.iter_mut().zip(&axes) {
            *value = in_si(units, &axis.column, *value);
        }
    }
    let radius = units.unit(Dimension::Length);
    for axis in axes {
        let range = axis.range.ends();
        axis.range = range.map(|value| in_si(units, &axis.column, value)).into();
        axis.linear = in_si(units, &axis.column, axis.linear);
        axis.column = si_name(&axis.column);
    }
    for layer in &mut panel.layers {
        for row in layer.series.pieces.iter_mut().flatten() {
            for (value, column) in row.iter_mut().zip(&layer.series.columns) {
                *value = in_si(units, column, *value);
            }
        }
        for column in &mut layer.series.columns {
            *column = si_name(column);
        }
        if let Mark::Hoop(hoop) = &mut layer.mark {
            hoop.radius *= radius;
        }
    }
}
