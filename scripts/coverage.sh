#!/usr/bin/env bash
# Coverage of the core by its own tests: a report as target/coverage/html, and at least 97 % of its lines. Needs cargo-llvm-cov and
# the component llvm-tools.
set -euo pipefail
cd "$(dirname "$0")/.."
export PROPTEST_RNG_SEED="${PROPTEST_RNG_SEED:-2019}"

cargo llvm-cov --package littlewood --features serde --locked --no-report
cargo llvm-cov report --package littlewood --html --output-dir "${CARGO_TARGET_DIR:-target}/coverage"
cargo llvm-cov report --package littlewood --summary-only --fail-under-lines 97
