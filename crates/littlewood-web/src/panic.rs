//! A panic is a defect. The page is told of it, and shows it.

use std::panic;

use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen]
extern "C" {
    /// Shows the message and a button that loads the page anew: after a panic this module is not
    /// used again.
    #[wasm_bindgen(js_name = littlewoodPanicked)]
    fn show(message: &str);
}

/// To be called once, before anything else.
#[wasm_bindgen]
pub fn begin() {
    panic::set_hook(Box::new(|panic| show(&panic.to_string())));
}

/// Panics, so that the page can be tested for what it shows then.
///
/// # Panics
/// Always.
#[cfg(feature = "first")]
#[wasm_bindgen(js_name = provokePanic)]
#[allow(clippy::panic, reason = "this is its purpose")]
pub fn provoke_panic() {
    panic!("asked for");
}
