//! Types and styles of the plotting library.

use std::convert::Infallible;

use littlewood_style::Rgb;
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind};
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color as _, IntoFont as _, RGBColor, ShapeStyle, TextStyle};

use super::canvas::{Canvas, STEPS, steps};
use super::face::FAMILY;
use crate::error::FigureError;
use crate::style::Stroke;

/// The sheet.
pub(crate) type Area = DrawingArea<Canvas, Shift>;
/// Message of the plotting library.
pub(crate) type Failure = DrawingAreaErrorKind<Infallible>;

impl From<Failure> for FigureError {
    fn from(error: Failure) -> Self {
        Self::Drawing(error.to_string())
    }
}

/// A colour of the library.
pub(crate) const fn rgb(Rgb([r, g, b]): Rgb) -> RGBColor {
    RGBColor(r, g, b)
}

/// A line style of the library.
pub(crate) fn line(stroke: Stroke) -> ShapeStyle {
    rgb(stroke.colour).stroke_width(steps(stroke.width).unsigned_abs())
}

/// A text style of the library.
pub(crate) fn letters(size: f64, colour: Rgb, across: HPos) -> TextStyle<'static> {
    let font = (FAMILY, size * STEPS).into_font();
    let pos = Pos::new(across, VPos::Center);
    TextStyle { font, color: rgb(colour).to_backend_color(), pos }
}
