#!/usr/bin/env bash
# Property tests and fuzzers for longer, with random cases of their own: PROPTEST_RNG_SEED, which a failure prints, or the time.
set -euo pipefail
cd "$(dirname "$0")/.."
export PROPTEST_RNG_SEED="${PROPTEST_RNG_SEED:-$(date +%s)}"
export PROPTEST_CASES="${PROPTEST_CASES:-4096}"
export LITTLEWOOD_FUZZ_SECONDS="${LITTLEWOOD_FUZZ_SECONDS:-900}"

echo "PROPTEST_RNG_SEED=$PROPTEST_RNG_SEED"
cargo test --release --package littlewood --package littlewood-sweep --package littlewood-film --locked --no-fail-fast
cargo test --release --package littlewood-cli --features full --locked fuzz:: -- --nocapture
