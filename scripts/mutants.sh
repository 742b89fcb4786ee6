#!/usr/bin/env bash
# Mutants of the core: a sample of one in 200, some fifty, about an hour; another one in each run. `scripts/mutants.sh 7` takes the
# seventh sample, `scripts/mutants.sh 7/1000` one in 1000. Survivors are listed in target/mutants.out/missed.txt. Needs cargo-mutants.
set -euo pipefail
cd "$(dirname "$0")/.."
export PROPTEST_RNG_SEED="${PROPTEST_RNG_SEED:-2019}"

sample="${1:-$((RANDOM % 200))}"
case "$sample" in */*) ;; *) sample="$sample/200" ;; esac
shift || true
mkdir -p target
cargo mutants --package littlewood --shard "$sample" --sharding round-robin --output target \
  --cap-lints true --test-workspace false --no-shuffle "$@"
