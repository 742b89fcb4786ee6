//! The named cases.

use wasm_bindgen::prelude::wasm_bindgen;

/// The named cases, as `littlewood cases --format json` prints them.
#[wasm_bindgen]
pub fn cases() -> String {
    let mut text = Vec::new();
    // Writing to memory does not fail.
    let _ = littlewood_report::json::cases(&mut text);
    String::from_utf8(text).unwrap_or_default()
}
