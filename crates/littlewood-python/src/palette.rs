//! The colours, lines and letters of all pictures.

use littlewood::Mode;
use littlewood_draw::{LETTER, SMALL, TICK};
use littlewood_style::{Curve, Dash, Theme, dash_of, swatches, width};
use pyo3::prelude::*;

/// The colours on a light or a dark paper: group, name, colour as `#rrggbb`.
#[pyfunction]
#[pyo3(name = "swatches")]
pub(crate) fn swatches_of(dark: bool) -> Vec<(&'static str, &'static str, String)> {
    let theme = if dark { Theme::Dark } else { Theme::Light };
    swatches(theme)
        .into_iter()
        .map(|swatch| (swatch.group, swatch.name, swatch.colour.hex()))
        .collect()
}

/// All dashes, and those of modes and curves: group, name, lengths of dashes and gaps over the
/// width of the line; none if solid.
#[pyfunction]
pub(crate) fn dashes() -> Vec<(&'static str, &'static str, Vec<f64>)> {
    let modes = Mode::ALL
        .into_iter()
        .map(|mode| ("mode", mode.name(), dash_of(mode)));
    let curves = Curve::ALL
        .into_iter()
        .map(|curve| ("curve", curve.name(), curve.dash()));
    let all = Dash::ALL
        .into_iter()
        .map(|dash| ("dash", dash.name(), dash));
    modes
        .chain(curves)
        .chain(all)
        .map(|(group, name, dash)| (group, name, dash.pattern().to_vec()))
        .collect()
}

/// The curves of the (θ, θ′) plane: name, letter of the paper, width in pixels of 1/96 inch.
#[pyfunction]
pub(crate) fn curves() -> Vec<(&'static str, Option<&'static str>, f64)> {
    Curve::ALL
        .map(|curve| (curve.name(), curve.letter(), curve.width()))
        .to_vec()
}

/// Lengths in pixels of 1/96 inch: widths of lines, a tick, and letters.
#[pyfunction]
pub(crate) fn lengths() -> Vec<(&'static str, f64)> {
    vec![
        ("fine", width::FINE),
        ("curve", width::CURVE),
        ("bold", width::BOLD),
        ("tick", TICK),
        ("letter", LETTER),
        ("small", SMALL),
    ]
}

/// The letters of all pictures as a TrueType font.
#[pyfunction]
pub(crate) fn font() -> std::borrow::Cow<'static, [u8]> {
    littlewood_draw::font().into()
}

/// A symbol or a unit of the tables with marks.
#[pyfunction]
pub(crate) fn marked(sign: &str) -> String {
    littlewood_draw::marked(sign)
}

/// A text with marks in letters of Unicode, italics as mathematical symbols.
#[pyfunction]
pub(crate) fn unicode(text: &str) -> String {
    littlewood_draw::unicode(text)
}
