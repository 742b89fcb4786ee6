//! The letters of maps: how wide a text is.

use std::sync::Once;

use plotters::style::{FontDesc, FontStyle, IntoFont as _, register_font};

const FONT: &str = "DejaVu Sans";

/// The letters of a text.
#[derive(Clone, Copy, Debug)]
pub(super) struct Face {
    /// In letters of the picture.
    pub(super) size: f64,
    pub(super) bold: bool,
}

impl Face {
    pub(super) const TITLE: Self = Self { size: 1.25, bold: true };
    pub(super) const NAME: Self = Self { size: 1.15, bold: false };
    pub(super) const PLAIN: Self = Self { size: 1.0, bold: false };
    pub(super) const SMALL: Self = Self { size: 0.9, bold: false };

    /// As the drawing library takes it, for letters of this size in pixels.
    pub(super) fn font(self, letter: f64) -> FontDesc<'static> {
        static ONCE: Once = Once::new();
        ONCE.call_once(|| {
            // A font that the crate ships always parses; should it not, drawing text fails and says so.
            let _ = register_font(FONT, FontStyle::Normal, dejavu::sans::regular());
            let _ = register_font(FONT, FontStyle::Bold, dejavu::sans::bold());
        });
        let weight = if self.bold { FontStyle::Bold } else { FontStyle::Normal };
        (FONT, self.size * letter, weight).into_font()
    }

    /// Width of a text in letters of the picture.
    pub(super) fn width(self, text: &str) -> f64 {
        // Measured large, so that whole pixels do not matter.
        const LETTER: f64 = 100.0;
        let pixels = self.font(LETTER).box_size(text).map_or(0, |(width, _)| width);
        f64::from(pixels) / LETTER
    }
}

/// Parts of a text in lines, none wider than this many letters unless it is one part alone.
pub(super) fn lines(parts: &[String], between: &str, face: Face, width: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for part in parts {
        match lines.last_mut() {
            Some(line) if face.width(&format!("{line}{between}{part}")) <= width => {
                line.push_str(between);
                line.push_str(part);
            }
            _ => lines.push(part.clone()),
        }
    }
    lines
}
