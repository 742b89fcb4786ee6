//! The two faces.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;

/// Name of the family.
pub(crate) const FAMILY: &str = "Littlewood";

/// The faces, upright and italic.
pub(crate) const FACES: [&[u8]; 2] = [
    include_bytes!("../../fonts/littlewood-regular.ttf"),
    include_bytes!("../../fonts/littlewood-italic.ttf"),
];

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
