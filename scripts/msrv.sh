#!/usr/bin/env bash
# Checks the core with the oldest compiler that it promises (`rust-version` in its Cargo.toml).
set -euo pipefail
cd "$(dirname "$0")/.."

version="$(sed -n 's/^rust-version = "\(.*\)"/\1/p' crates/littlewood/Cargo.toml)"
rustup toolchain install --profile minimal --no-self-update "$version"
cargo "+$version" check --package littlewood --features serde --locked --target-dir "${CARGO_TARGET_DIR:-target}/msrv"
