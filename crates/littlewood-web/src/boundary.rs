//! The names whose order both sides of the boundary must agree on.

use littlewood::Mode;
use littlewood::tables::{Class, Quantity, SampleColumn};
use wasm_bindgen::prelude::wasm_bindgen;

use crate::problem::{dimensionless_quantities, si_quantities};

/// The names of everything that crosses the boundary as a number or by its place, in order: the
/// numbers of a problem in either system, the columns of a sample, modes and classes. The page was
/// generated with the same text; a core of another version has another one.
#[wasm_bindgen]
pub fn boundary() -> String {
    let lists: [Vec<&str>; 5] = [
        dimensionless_quantities().map(Quantity::name).collect(),
        si_quantities().map(Quantity::name).collect(),
        SampleColumn::NAMES.to_vec(),
        Mode::NAMES.to_vec(),
        Class::NAMES.to_vec(),
    ];
    lists.map(|names| names.join(" ")).join("; ")
}
