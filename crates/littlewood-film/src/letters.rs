//! Words as outlines, from a font that comes with the program, so that they look the same everywhere.

use ab_glyph::{Font as _, FontRef, OutlineCurve};
use tiny_skia::{Path, PathBuilder};

use crate::error::FilmError;

/// The fonts.
#[derive(Debug)]
pub(crate) struct Letters {
    regular: FontRef<'static>,
    bold: FontRef<'static>,
}

/// How words are set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Style {
    /// Size of the em square in pixels.
    pub(crate) size: f64,
    pub(crate) is_bold: bool,
    /// Part of the width that lies left of the given place: 0 for words that begin there, 1 for words that end there.
    pub(crate) anchor: f64,
}

impl Letters {
    /// Reads the fonts.
    pub(crate) fn new() -> Result<Self, FilmError> {
        let read = |data| {
            FontRef::try_from_slice(data)
                .map_err(|error| FilmError::Encoding { format: "lettering", message: error.to_string() })
        };
        Ok(Self { regular: read(dejavu::sans::regular())?, bold: read(dejavu::sans::bold())? })
    }

    const fn font(&self, style: Style) -> &FontRef<'static> {
        if style.is_bold { &self.bold } else { &self.regular }
    }

    /// Pixels for a unit of the font.
    fn scale(&self, style: Style) -> f64 {
        style.size / f64::from(self.font(style).units_per_em().unwrap_or(1000.0))
    }

    /// Width of words in pixels.
    pub(crate) fn width(&self, words: &str, style: Style) -> f64 {
        let font = self.font(style);
        let advances = words.chars().map(|letter| f64::from(font.h_advance_unscaled(font.glyph_id(letter))));
        advances.sum::<f64>() * self.scale(style)
    }

    /// The outline of words on a base line; none if nothing is to be seen.
    pub(crate) fn outline(&self, words: &str, (x, y): (f64, f64), style: Style) -> Option<Path> {
        let font = self.font(style);
        let scale = self.scale(style);
        let mut pen = x - style.anchor * self.width(words, style);
        let mut path = PathBuilder::new();
        for letter in words.chars() {
            let glyph = font.glyph_id(letter);
            if let Some(outline) = font.outline(glyph) {
                let place = |point: ab_glyph::Point| {
                    ((pen + scale * f64::from(point.x)) as f32, (y - scale * f64::from(point.y)) as f32)
                };
                trace(&mut path, &outline.curves, place);
            }
            pen += scale * f64::from(font.h_advance_unscaled(glyph));
        }
        path.finish()
    }

    /// Whether the fonts have all letters of these words.
    #[cfg(test)]
    fn has(&self, words: &str) -> bool {
        [&self.regular, &self.bold]
            .iter()
            .all(|font| words.chars().all(|letter| font.glyph_id(letter).0 != 0))
    }
}

fn trace(path: &mut PathBuilder, curves: &[OutlineCurve], place: impl Fn(ab_glyph::Point) -> (f32, f32)) {
    let mut last = None;
    for curve in curves {
        let (from, to) = match curve {
            OutlineCurve::Line(from, to)
            | OutlineCurve::Quad(from, _, to)
            | OutlineCurve::Cubic(from, _, _, to) => (*from, *to),
        };
        if last != Some(from) {
            if last.is_some() {
                path.close();
            }
            let (x, y) = place(from);
            path.move_to(x, y);
        }
        let (x, y) = place(to);
        match curve {
            OutlineCurve::Line(..) => path.line_to(x, y),
            OutlineCurve::Quad(_, bend, _) => {
                let (x1, y1) = place(*bend);
                path.quad_to(x1, y1, x, y);
            }
            OutlineCurve::Cubic(_, first, second, _) => {
                let ((x1, y1), (x2, y2)) = (place(*first), place(*second));
                path.cubic_to(x1, y1, x2, y2, x, y);
            }
        }
        last = Some(to);
    }
    if last.is_some() {
        path.close();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fonts_have_every_letter_that_films_use() {
        let letters = Letters::new().unwrap();
        assert!(
            letters.has(
                "rolling sliding ← → gliding flight τ η′ θ ∞ − × ½ √ μₛ μₖ m₁ m₂ ℓ I R² = ≥ · 0123456789"
            )
        );
        assert!(!letters.has("\u{e000}"));
    }

    #[test]
    fn digits_are_of_one_width() {
        let letters = Letters::new().unwrap();
        for is_bold in [false, true] {
            let style = Style { size: 20.0, is_bold, anchor: 0.0 };
            let width = letters.width("0", style);
            assert!(
                width > 10.0 && ('1'..='9').all(|digit| letters.width(&digit.to_string(), style) == width)
            );
        }
    }

    #[test]
    fn words_lie_where_their_anchor_says() {
        let letters = Letters::new().unwrap();
        for (anchor, from, to) in [(0.0, 100.0, 150.0), (0.5, 70.0, 130.0), (1.0, 50.0, 100.0)] {
            let style = Style { size: 16.0, is_bold: false, anchor };
            let bounds = letters.outline("rolling", (100.0, 50.0), style).unwrap().bounds();
            assert!(bounds.left() > from && bounds.right() < to, "{bounds:?}");
            // The tails of the letters g hang below the base line.
            assert!(bounds.top() > 30.0 && bounds.bottom() > 50.0 && bounds.bottom() < 56.0, "{bounds:?}");
        }
    }
}
