//! Digests of random motions.

use littlewood_digest::Block;
use pyo3::prelude::*;

/// The digests of a block of motions as this core computes them: a line of
/// `crates/littlewood-digest/digest.txt`.
#[pyfunction]
pub(crate) fn digest_line(py: Python<'_>, block: u32) -> String {
    py.detach(|| Block::compute(block).line())
}
