#!/usr/bin/env bash
# Passes all tests on a fresh machine that has Rust, Python 3.11 and node 20: format, lints, documentation, tests of the
# crates, of the Python package, of the web page and of the documentation. On Debian, as root, it installs Chromium.
set -euo pipefail
cd "$(dirname "$0")"
export RUSTDOCFLAGS="-D warnings"
# The same random cases every time; another seed, or none, explores others.
export PROPTEST_RNG_SEED="${PROPTEST_RNG_SEED:-2019}"

cargo fmt --all --check
cargo clippy --workspace --all-targets --locked -- -D warnings
cargo doc --workspace --no-deps --locked
cargo test --workspace --locked --no-fail-fast
# The fuzzer, for a minute instead of a moment.
LITTLEWOOD_FUZZ_SECONDS=60 cargo test --package littlewood-cli --test fuzz --locked -- --nocapture
cargo test --package littlewood --features serde --test serde --locked
python/test.sh
LITTLEWOOD_FUZZ_SECONDS=60 web/test.sh
docs/test.sh
