//! Digests of random motions.

use littlewood_digest::Block;
use wasm_bindgen::prelude::wasm_bindgen;

/// The digests of a block of motions as this core computes them: a line of
/// `crates/littlewood-digest/digest.txt`.
#[wasm_bindgen(js_name = digestLine)]
pub fn digest_line(block: u32) -> String {
    Block::compute(block).line()
}
