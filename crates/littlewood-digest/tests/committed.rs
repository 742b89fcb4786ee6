//! This build computes the bits that are committed.

use littlewood_digest::{BLOCKS, Block, COMMITTED, setups};

/// Blocks that are compared: the digests of all of them are compared in a release build, by
/// `./test.sh bits`.
const EACH: usize = 20;

#[test]
fn motions_have_the_committed_bits() {
    assert_eq!(COMMITTED.lines().count(), BLOCKS as usize);
    for (committed, index) in COMMITTED.lines().zip(0..).step_by(EACH) {
        let computed = Block::compute(index).line();
        assert_eq!(
            computed, committed,
            "are results meant to change? `./test.sh bits print` writes them anew"
        );
    }
}

#[test]
fn blocks_differ() {
    let first = |block| {
        setups(block)
            .next()
            .map(|(setup, _)| setup.start.theta.to_bits())
    };
    assert_ne!(first(0), first(1));
}
