//! Digests of 100,000 motions, by which builds of the core are compared: for other processors and
//! systems, in WebAssembly, and in the Python module.
//!
//! The motions are random and the same everywhere. A [`Block`] of a thousand has two digests, of
//! the bits of the simulated motions and of those of the engine's summaries, so that a difference
//! says where it is. [`COMMITTED`] has the lines of all blocks ([`Block::line`]); `./test.sh bits`
//! compares with it natively, in WebAssembly and in Python.

mod block;
mod hash;
mod starts;

pub use block::Block;
pub use starts::{MOTIONS, UNTIL, setups};

/// Number of blocks.
pub const BLOCKS: u32 = 100;

/// The lines of all blocks: `crates/littlewood-digest/digest.txt`.
pub const COMMITTED: &str = include_str!("../digest.txt");
