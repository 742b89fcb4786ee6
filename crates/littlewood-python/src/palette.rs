//! The colours, lines and letters of all pictures.

use littlewood::Mode;
use littlewood_draw::{LETTER, SMALL, TICK};
use littlewood_style::{Curve, Dash, Theme, dash_of, swatches, ticks, width};
use pyo3::prelude::*;

use crate::record::ByName;

/// A colour as `#rrggbb`.
#[derive(IntoPyObject)]
pub(crate) struct ColourDict {
    group: &'static str,
    name: &'static str,
    colour: String,
}

/// The colours on a light or a dark paper.
#[pyfunction]
#[pyo3(name = "swatches")]
pub(crate) fn swatches_of(dark: bool) -> Vec<ColourDict> {
    let theme = if dark { Theme::Dark } else { Theme::Light };
    swatches(theme)
        .into_iter()
        .map(|swatch| ColourDict {
            group: swatch.group,
            name: swatch.name,
            colour: swatch.colour.hex(),
        })
        .collect()
}

/// The lengths of the dashes and gaps of a line over its width; none if it is solid.
#[derive(IntoPyObject)]
pub(crate) struct DashDict {
    group: &'static str,
    name: &'static str,
    pattern: Vec<f64>,
}

impl DashDict {
    fn of(group: &'static str, name: &'static str, dash: Dash) -> Self {
        Self {
            group,
            name,
            pattern: dash.pattern().to_vec(),
        }
    }
}

/// All dashes, and those of modes and curves.
#[pyfunction]
pub(crate) fn dashes() -> Vec<DashDict> {
    let modes = Mode::ALL.map(|mode| DashDict::of("mode", mode.name(), dash_of(mode)));
    let curves = Curve::ALL.map(|curve| DashDict::of("curve", curve.name(), curve.dash()));
    let all = Dash::ALL.map(|dash| DashDict::of("dash", dash.name(), dash));
    modes.into_iter().chain(curves).chain(all).collect()
}

/// A curve of the (θ, θ′) plane: its letter in the paper, and its width in pixels of 1/96 inch.
#[derive(IntoPyObject)]
pub(crate) struct CurveDict {
    name: &'static str,
    letter: Option<&'static str>,
    width: f64,
}

/// The curves of the (θ, θ′) plane.
#[pyfunction]
pub(crate) fn curves() -> Vec<CurveDict> {
    let row = |curve: Curve| CurveDict {
        name: curve.name(),
        letter: curve.letter(),
        width: curve.width(),
    };
    Curve::ALL.map(row).into()
}

/// Lengths in pixels of 1/96 inch: widths of lines, a tick, and letters.
#[pyfunction]
pub(crate) fn lengths() -> ByName<f64> {
    ByName::from([
        ("fine", width::FINE),
        ("curve", width::CURVE),
        ("bold", width::BOLD),
        ("tick", TICK),
        ("letter", LETTER),
        ("small", SMALL),
    ])
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

/// A tick of an axis.
#[derive(IntoPyObject)]
pub(crate) struct TickDict {
    value: f64,
    label: String,
}

/// Ticks of an axis from a to b > a, at most about so many: `round`, `angular` or `logarithmic`;
/// none for another kind.
#[pyfunction]
#[pyo3(name = "ticks")]
pub(crate) fn ticks_of(kind: &str, a: f64, b: f64, most: usize) -> Vec<TickDict> {
    let found = match kind {
        "round" => ticks::round(a, b, most.max(1)),
        "angular" => ticks::angular(a, b, most.max(1)),
        "logarithmic" => ticks::logarithmic(a, b, most.max(1)),
        _ => Vec::new(),
    };
    let row = |ticks::Tick { value, label }| TickDict { value, label };
    found.into_iter().map(row).collect()
}
