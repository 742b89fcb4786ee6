#!/usr/bin/env bash
# Passes all tests on a fresh machine that has Rust, Python 3.11 and node 20: format, lints, documentation, tests of the
# crates, of the Python package, of the solvers that are scored, of the studies, of the web page and of the documentation. On Debian, as
# root, it installs Chromium. At its end it counts.
set -euo pipefail
cd "$(dirname "$0")"
export RUSTDOCFLAGS="-D warnings"
# Nothing here is built a second time, so that what a second build would need need not be kept.
export CARGO_INCREMENTAL="${CARGO_INCREMENTAL:-0}"
# The same random cases every time; another seed, or none, explores others.
export PROPTEST_RNG_SEED="${PROPTEST_RNG_SEED:-2019}"
# The fuzzers, for a minute instead of a moment.
export LITTLEWOOD_FUZZ_SECONDS="${LITTLEWOOD_FUZZ_SECONDS:-60}"
# One set of features throughout, so that clippy, rustdoc and the tests share what they build; and the program that the tests
# of Python and of the page compare with is that of the tests of Rust.
everything=(--workspace --all-features --locked)

cargo fmt --all --check
cargo clippy "${everything[@]}" --all-targets -- -D warnings
cargo doc "${everything[@]}" --no-deps
log="$(mktemp)"
trap 'rm -f "$log"' EXIT
# The program of the README's first command has none of the features: it builds, and says what it lacks.
cargo test --package littlewood-cli --locked features:: 2>&1 | tee "$log"
cargo test "${everything[@]}" --no-fail-fast 2>&1 | tee -a "$log"
built="${CARGO_TARGET_DIR:-$PWD/target}/debug"
export LITTLEWOOD_BIN="$built/littlewood" LITTLEWOOD_BITS="$built/examples/bits"
python/test.sh 2>&1 | tee -a "$log"
engines/test.sh
studies/test.sh 2>&1 | tee -a "$log"
web/test.sh 2>&1 | tee -a "$log"
docs/test.sh
echo
echo "Passed:"
awk '/^test result: ok/ { rust += $4 }
     /^[0-9]+ passed.* in / { python += $1 }
     /^ +[0-9]+ passed \(/ { page += $1 }
     END { print "  " rust " tests of the crates, " python " of the Python package, " page " of the page" }' "$log"
