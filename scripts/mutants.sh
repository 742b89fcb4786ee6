#!/usr/bin/env bash
# Mutants of the core: a sample of one in 50, another one in each run. `scripts/mutants.sh 7` takes the seventh sample,
# `scripts/mutants.sh 7/400` one in 400. Survivors are listed in target/mutants.out/missed.txt. Needs cargo-mutants.
set -euo pipefail
cd "$(dirname "$0")/.."
export PROPTEST_RNG_SEED="${PROPTEST_RNG_SEED:-2019}"

sample="${1:-$((RANDOM % 50))}"
case "$sample" in */*) ;; *) sample="$sample/50" ;; esac
shift || true
mkdir -p target
cargo mutants --package littlewood --shard "$sample" --sharding round-robin --output target \
  --cap-lints true --test-workspace false --no-shuffle "$@"
