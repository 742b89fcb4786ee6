//! Words as outlines, in the letters of all pictures.

use littlewood_draw::{Point, outlines, skia, width};
use tiny_skia::Path;

use crate::canvas::Place;

/// How words are set.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Style {
    /// Size in pixels.
    pub(crate) size: f64,
    pub(crate) is_bold: bool,
    /// Part of the width that lies left of the given place: 0 for words that begin there, 1 for
    /// words that end there.
    pub(crate) anchor: f64,
}

/// How much larger letters are than their lines: small ones are low in this face.
const LARGER: f64 = 1.18;

/// Width of a line along the outlines of bold letters, in parts of their size.
const BOLD: f64 = 0.035;

impl Style {
    fn letters(self) -> f64 {
        LARGER * self.size
    }

    /// Width of the line along the outlines; zero if letters are not bold.
    pub(crate) fn bold(self) -> f64 {
        if self.is_bold {
            BOLD * self.letters()
        } else {
            0.0
        }
    }

    /// Width of words, with marks, in pixels.
    pub(crate) fn width(self, words: &str) -> f64 {
        width(words, self.letters())
    }

    /// The outline of words, with marks, on a base line; none if nothing is to be seen.
    pub(crate) fn outline(self, words: &str, place: Place) -> Option<Path> {
        let left = place.x - self.anchor * self.width(words);
        let at = |it: Point| Point::new(left + it.x, place.y + it.y);
        let segments = outlines(words, self.letters()).flat_map(|(segments, _)| segments);
        skia(
            &segments
                .map(|segment| segment.placed(at))
                .collect::<Vec<_>>(),
        )
    }
}

#[cfg(test)]
mod tests {
    use littlewood_draw::missing;

    use super::*;

    #[test]
    fn the_face_has_every_letter_that_films_use() {
        let words = "rolling sliding ← → gliding flight τ η′ θ ∞ − × ½ √ μₛ μₖ m₁ m₂ ℓ I R² = ≥ · – 0123456789";
        assert_eq!(missing(words), "");
        assert_eq!(missing("\u{e000}"), "\u{e000}");
    }

    #[test]
    fn words_lie_where_their_anchor_says() {
        for anchor in [0.0, 0.5, 1.0] {
            let style = Style {
                size: 16.0,
                is_bold: false,
                anchor,
            };
            let bounds = style
                .outline("rolling", Place::new(100.0, 50.0))
                .unwrap()
                .bounds();
            let left = 100.0 - anchor * style.width("rolling");
            let [from, to] = [bounds.left(), bounds.right()].map(f64::from);
            assert!((left..left + 2.0).contains(&from), "{bounds:?}");
            assert!(
                (-2.0..0.0).contains(&(to - left - style.width("rolling"))),
                "{bounds:?}"
            );
            // The tail of the letter g hangs below the base line.
            assert!(
                bounds.top() > 30.0 && bounds.bottom() > 50.0 && bounds.bottom() < 56.0,
                "{bounds:?}"
            );
        }
    }
}
