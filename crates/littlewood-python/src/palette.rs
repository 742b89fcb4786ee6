//! The colours and dashes of all pictures.

use littlewood::Mode;
use littlewood_style::{Curve, Theme, dash_of, swatches};
use pyo3::prelude::*;

/// The colours on a light or a dark paper: group, name, colour as `#rrggbb`.
#[pyfunction]
#[pyo3(name = "swatches")]
pub(crate) fn swatches_of(dark: bool) -> Vec<(&'static str, &'static str, String)> {
    let theme = if dark { Theme::Dark } else { Theme::Light };
    swatches(theme).into_iter().map(|swatch| (swatch.group, swatch.name, swatch.colour.hex())).collect()
}

/// The dashes of modes and curves: group, name, lengths of dashes and gaps over the width of the line; none if solid.
#[pyfunction]
pub(crate) fn dashes() -> Vec<(&'static str, &'static str, Vec<f64>)> {
    let modes = Mode::ALL.into_iter().map(|mode| ("mode", mode.name(), dash_of(mode)));
    let curves = Curve::ALL.into_iter().map(|curve| ("curve", curve.name(), curve.dash()));
    modes.chain(curves).map(|(group, name, dash)| (group, name, dash.pattern().to_vec())).collect()
}

/// The curves of the (θ, θ′) plane: name, letter of the paper, width in pixels of 1/96 inch.
#[pyfunction]
pub(crate) fn curves() -> Vec<(&'static str, Option<&'static str>, f64)> {
    Curve::ALL.map(|curve| (curve.name(), curve.letter(), curve.width())).to_vec()
}
