//! Texts as outlines: which letter stands where, and the curves of each.

use skrifa::instance::{LocationRef, Size};
use skrifa::outline::{DrawSettings, OutlinePen};
use skrifa::{FontRef, GlyphId, MetadataProvider as _};

use super::face::FACES;
use super::markup::{Script, runs};

/// Size of an index or exponent.
pub(crate) const SCRIPT_SIZE: f64 = 0.72;
/// How far an index stands below the line and an exponent above it, in parts of the size.
const DOWN: f64 = 0.22;
const UP: f64 = 0.36;

impl Script {
    /// Size of its letters and how far they stand below the line, of a text of a size.
    pub(crate) fn placed(self, size: f64) -> [f64; 2] {
        match self {
            Self::Line => [size, 0.0],
            Self::Sub => [SCRIPT_SIZE * size, DOWN * size],
            Self::Super => [SCRIPT_SIZE * size, -UP * size],
        }
    }
}

/// A letter of a text.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Glyph {
    /// Which face, and its number there.
    pub(crate) face: usize,
    pub(crate) id: GlyphId,
    /// How far it stands from the beginning of the text, to the right and downwards.
    pub(crate) at: [f64; 2],
    /// Length of a unit of the face.
    pub(crate) unit: f64,
    /// Width of a line along its outline, which makes it bold; zero for others.
    pub(crate) bold: f64,
}

/// The same in parts of the size.
const BOLD: f64 = 0.045;

/// The letters of a text, and its width.
fn set(text: &str, size: f64) -> (Vec<Glyph>, f64) {
    let (mut glyphs, mut across) = (Vec::new(), 0.0);
    for run in runs(text) {
        let face = usize::from(run.italic);
        let Ok(font) = FontRef::new(FACES[face]) else { continue };
        let [scale, down] = run.script.placed(size);
        // In the units of the face, which are whole numbers.
        let metrics = font.glyph_metrics(Size::unscaled(), LocationRef::default());
        let unit = scale / f64::from(font.metrics(Size::unscaled(), LocationRef::default()).units_per_em);
        let map = font.charmap();
        for id in run.text.chars().filter_map(|letter| map.map(letter)) {
            let bold = if run.bold { BOLD * scale } else { 0.0 };
            glyphs.push(Glyph { face, id, at: [across, down], unit, bold });
            across += unit * metrics.advance_width(id).map_or(0.0, f64::from);
        }
    }
    (glyphs, across)
}

/// The letters of a text.
pub(crate) fn glyphs(text: &str, size: f64) -> Vec<Glyph> {
    set(text, size).0
}

/// Width of a text in the unit of its size.
pub(crate) fn width(text: &str, size: f64) -> f64 {
    set(text, size).1
}

/// A piece of an outline, in units of the face, upwards positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Stroke {
    Move([f64; 2]),
    Line([f64; 2]),
    Quad([f64; 2], [f64; 2]),
    Cubic([f64; 2], [f64; 2], [f64; 2]),
    Close,
}

#[derive(Default)]
struct Outline(Vec<Stroke>);

impl OutlinePen for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.push(Stroke::Move([x, y].map(f64::from)));
    }

    fn line_to(&mut self, x: f32, y: f32) {
        self.0.push(Stroke::Line([x, y].map(f64::from)));
    }

    fn quad_to(&mut self, cx: f32, cy: f32, x: f32, y: f32) {
        self.0.push(Stroke::Quad([cx, cy].map(f64::from), [x, y].map(f64::from)));
    }

    fn curve_to(&mut self, ax: f32, ay: f32, bx: f32, by: f32, x: f32, y: f32) {
        let [a, b, to] = [[ax, ay], [bx, by], [x, y]].map(|point| point.map(f64::from));
        self.0.push(Stroke::Cubic(a, b, to));
    }

    fn close(&mut self) {
        self.0.push(Stroke::Close);
    }
}

/// The outline of a letter.
pub(crate) fn outline(face: usize, id: GlyphId) -> Vec<Stroke> {
    let mut outline = Outline::default();
    let settings = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
    if let Ok(font) = FontRef::new(FACES[face])
        && let Some(glyph) = font.outline_glyphs().get(id)
        // A letter that has no outline, like a space, is drawn as none.
        && glyph.draw(settings, &mut outline).is_err()
    {
        return Vec::new();
    }
    outline.0
}

/// Letters of a text that no face has.
#[cfg(test)]
pub(crate) fn missing(text: &str) -> String {
    runs(text)
        .into_iter()
        .flat_map(|run| {
            let map = FontRef::new(FACES[usize::from(run.italic)]).map(|font| font.charmap());
            run.text.chars().filter(move |letter| map.as_ref().is_ok_and(|map| map.map(*letter).is_none()))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_faces_have_the_symbols() {
        assert_eq!(missing("*θηξτμπωℓ*′ 𝓡 𝓝 ± − × √ ° ≤ ½ *N*_{roll}"), "ξ");
        assert!(width("mm", 10.0) > width("m", 10.0));
        assert!((width("*μ*_{s}", 20.0) / width("*μ*_{s}", 10.0) - 2.0).abs() < 1e-12);
    }

    #[test]
    fn letters_stand_one_after_another_and_have_closed_outlines() {
        let found = glyphs("*μ*_{s}*N*", 10.0);
        assert_eq!(found.len(), 3);
        assert!(found.windows(2).all(|pair| pair[0].at[0] < pair[1].at[0]));
        assert_eq!(found[1].at[1], DOWN * 10.0);
        for glyph in found {
            let outline = outline(glyph.face, glyph.id);
            assert!(
                matches!(outline[0], Stroke::Move(_)) && matches!(outline[outline.len() - 1], Stroke::Close)
            );
        }
    }
}
