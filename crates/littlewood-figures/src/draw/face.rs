//! The letters: two faces that every figure carries along.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use skrifa::instance::{LocationRef, Size};
use skrifa::{FontRef, MetadataProvider as _};

use super::markup::{Script, runs};

/// Name of the family.
pub(crate) const FAMILY: &str = "Littlewood";

/// The faces, upright and italic.
pub(crate) const FACES: [&[u8]; 2] = [
    include_bytes!("../../fonts/littlewood-regular.ttf"),
    include_bytes!("../../fonts/littlewood-italic.ttf"),
];

/// Size of an index or exponent.
pub(crate) const SCRIPT_SIZE: f64 = 0.72;

/// Rules that bring the faces into a picture.
pub(crate) fn rules() -> String {
    let mut css = String::new();
    for (bytes, style) in FACES.iter().zip(["normal", "italic"]) {
        css += &format!(
            "@font-face{{font-family:{FAMILY};font-style:{style};src:url(data:font/ttf;base64,{}) format('truetype')}}\n",
            STANDARD.encode(bytes)
        );
    }
    css
}

/// Width of a text in the unit of its size.
pub(crate) fn width(text: &str, size: f64) -> f64 {
    runs(text)
        .into_iter()
        .map(|run| {
            let Ok(font) = FontRef::new(FACES[usize::from(run.italic)]) else { return 0.0 };
            let scale = if run.script == Script::Line { size } else { SCRIPT_SIZE * size };
            // In the units of the font, which are whole numbers.
            let metrics = font.glyph_metrics(Size::unscaled(), LocationRef::default());
            let unit = scale / f64::from(font.metrics(Size::unscaled(), LocationRef::default()).units_per_em);
            let map = font.charmap();
            run.text
                .chars()
                .filter_map(|letter| metrics.advance_width(map.map(letter)?))
                .map(|width| unit * f64::from(width))
                .sum::<f64>()
        })
        .sum()
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
}
