//! A figure as a file of each kind, and the texts on it.

use crate::chart::items;
use crate::error::DrawError;
use crate::figure::Figure;
use crate::item::Item;
use crate::markup::plain;
use crate::primitives::Image;
use crate::raster::{self, check_scale};
use crate::sheet::{POINTS_TO_A_MM, PRINT_POINTS};
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
