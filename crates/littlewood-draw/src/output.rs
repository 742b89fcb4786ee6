//! A figure as a file of each kind, and the texts on it.

use crate::chart::items;
use crate::error::DrawError;
use crate::figure::Figure;
use littlewood_style::Rgb;

use crate::item::{Item, Paint, STEPS, Step};
use crate::markup::plain;
use crate::primitives::{Image, Point};
use crate::raster::{self, check_scale};
use crate::sheet::{POINTS_TO_A_MM, PRINT_POINTS};
use crate::stroke::Stroke;
use crate::svg;

impl Figure {
    /// The figure as SVG, its letters as outlines.
    pub fn svg(&self) -> String {
        svg::document(self, &items(self))
    }

    /// The figure as PDF of one page, its letters as a font.
    #[cfg(feature = "pdf")]
    pub fn pdf(&self) -> Vec<u8> {
        crate::pdf::document(self, &items(self), self.points())
    }

    /// The figure as PNG, with `scale` pixels to 1/96 inch: 2 for a screen, 3.125 for 300 dpi in
    /// print.
    ///
    /// # Errors
    /// A scale out of bounds.
    pub fn png(&self, scale: f64) -> Result<Vec<u8>, DrawError> {
        check_scale(scale)?;
        let scale = scale * self.points() / POINTS;
        let side = |length: f64| libm::ceil(length * scale) as u32;
        let pixels = self.pixels(side(self.width), side(self.height), scale)?;
        let to_a_metre = self
            .print_mm
            .map(|mm| libm::round(scale * self.width / (mm / 1000.0)) as u32);
        Ok(pixels.file(to_a_metre).unwrap_or_default())
    }

    /// The figure in so many pixels to the right and downwards, so many to one of the drawing.
    ///
    /// # Errors
    /// [`DrawError::NoRoom`].
    pub fn pixels(&self, width: u32, height: u32, scale: f64) -> Result<Image, DrawError> {
        raster::pixels(&items(self), width, height, scale)
    }

    /// All texts, with the boxes of their letters: left, top, right and bottom in pixels.
    pub fn texts(&self) -> Vec<(String, [f64; 4])> {
        let texts = items(self).into_iter().filter_map(|item| {
            let Item::Words(words) = item else {
                return None;
            };
            Some((plain(&words.text), words.frame().sides()))
        });
        texts.collect()
    }

    /// Points of print to a pixel.
    fn points(&self) -> f64 {
        let Some(mm) = self.print_mm else {
            return POINTS;
        };
        // A poster is drawn larger than it is printed.
        let own = mm * POINTS_TO_A_MM / self.width;
        if (own - PRINT_POINTS).abs() < 1e-9 {
            PRINT_POINTS
        } else {
            own
        }
    }
}

/// Points to a pixel of a screen: 72 and 96 to the inch.
const POINTS: f64 = 0.75;

/// A shape on a sheet, in pixels to the right and downwards, as all formats draw it.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// Lines, or the circle about a place as a line.
    Line {
        /// From point to point.
        lines: Vec<Vec<[f64; 2]>>,
        /// How they are drawn.
        stroke: Stroke,
    },
    /// An area.
    Area {
        /// Its outlines.
        lines: Vec<Vec<[f64; 2]>>,
        /// Its colour.
        colour: Rgb,
    },
    /// A text.
    Text {
        /// Without marks.
        text: String,
        /// The box of its letters: left, top, right and bottom.
        frame: [f64; 4],
    },
}

/// Corners of what stands for a circle.
const CORNERS: u32 = 24;

fn circle(centre: Step, radius: i32) -> Vec<[f64; 2]> {
    let Point { x, y } = centre.pixels();
    let radius = f64::from(radius) / STEPS;
    let corner = |k: u32| {
        let (sin, cos) = libm::sincos(core::f64::consts::TAU * f64::from(k) / f64::from(CORNERS));
        [x + radius * cos, y + radius * sin]
    };
    (0..=CORNERS).map(corner).collect()
}

impl Figure {
    /// Its shapes, the lowest first; images are left out.
    pub fn shapes(&self) -> Vec<Shape> {
        let pixels = |line: &Vec<Step>| {
            let points = line.iter().map(|step| step.pixels());
            points.map(|Point { x, y }| [x, y]).collect::<Vec<_>>()
        };
        let painted = |lines, paint| match paint {
            Paint::Edge(stroke) => Shape::Line { lines, stroke },
            Paint::Fill(colour) => Shape::Area { lines, colour },
        };
        let shape = |item: Item| match item {
            Item::Path { lines, paint } => Some(painted(lines.iter().map(pixels).collect(), paint)),
            Item::Circle {
                centre,
                radius,
                paint,
            } => Some(painted(vec![circle(centre, radius)], paint)),
            Item::Words(words) => Some(Shape::Text {
                text: plain(&words.text),
                frame: words.frame().sides(),
            }),
            Item::Image { .. } => None,
        };
        items(self).into_iter().filter_map(shape).collect()
    }
}
