#!/usr/bin/env bash
# Passes all tests on a fresh machine that has Rust, Python 3.11 and node 20: format, lints, documentation, tests of the
# crates, of the Python package, of the solvers that are scored, of the studies, of the web page and of the documentation. On Debian, as
# root, it installs Chromium. At its end it counts, and says what took how long.
set -euo pipefail
cd "$(dirname "$0")"
export RUSTDOCFLAGS="-D warnings"
# Backtraces with lines would take half a minute of compiling; the place of a panic is named without.
export CARGO_PROFILE_DEV_DEBUG="${CARGO_PROFILE_DEV_DEBUG:-0}"
# Nothing here is built a second time, so that what a second build would need need not be kept.
export CARGO_INCREMENTAL="${CARGO_INCREMENTAL:-0}"
# The same random cases every time; another seed, or none, explores others.
export PROPTEST_RNG_SEED="${PROPTEST_RNG_SEED:-2019}"
# The fuzzers, for a minute together instead of a moment: a sixth of it for the page's links, which are read in microseconds.
export LITTLEWOOD_FUZZ_SECONDS="${LITTLEWOOD_FUZZ_SECONDS:-60}"
# One set of features throughout, so that clippy, rustdoc and the tests share what they build; and the program that the tests
# of Python and of the page compare with is that of the tests of Rust.
everything=(--workspace --all-features --locked)
built="${CARGO_TARGET_DIR:-$PWD/target}/debug"
logs="$(mktemp -d)"
beside=()
trap 'rm -rf "$logs"; [ "${#beside[@]}" = 0 ] || kill "${beside[@]}" 2>/dev/null' EXIT

# stage NAME COMMAND…: runs it, keeps what it prints, and notes the seconds.
stage() {
  local name="$1" begin="$SECONDS"
  shift
  "$@" 2>&1 | tee "$logs/$name.log"
  echo "  $name: $((SECONDS - begin)) s" >> "$logs/seconds"
}

# begin_beside COMMAND: runs it beside what follows, and keeps what it prints until end_beside.
begin_beside() {
  "$@" > "$logs/beside-${#beside[@]}" 2>&1 &
  beside+=("$!")
}
end_beside() {
  local code=0 number
  for number in "${!beside[@]}"; do
    wait "${beside[number]}" || code=$?
    cat "$logs/beside-$number"
  done
  beside=()
  return "$code"
}

# The program of the README's first command has none of the features: it builds, and says what it lacks.
without_features() {
  LITTLEWOOD_WITHOUT_FEATURES="$built/littlewood-without-features" \
    cargo test "${everything[@]}" --test all -- --ignored --exact features::a_program_without_features_names_them
}

# Chromium, and packages of Python and npm.
environments() {
  python/environment.sh
  docs/environment.sh
  web/environment.sh
}

# The wheel, and its tests; it is packed long before the tests of Rust are through.
with_wheel() {
  stage wheel python/build.sh
  LITTLEWOOD_WHEEL="$(wheel)" stage python python/test.sh
  stage engines evidence/engines/test.sh
}

wheel() {
  echo "$built"/../python/dist/littlewood-*.whl
}

begin_beside stage environments environments
stage format cargo fmt --all --check
stage first-command cargo build --package littlewood-cli --locked
cp "$built/littlewood" "$built/littlewood-without-features"
stage clippy cargo clippy "${everything[@]}" --all-targets -- -D warnings
stage rustdoc cargo doc "${everything[@]}" --no-deps
stage build cargo test "${everything[@]}" --no-run
end_beside

export LITTLEWOOD_BIN="$built/littlewood" LITTLEWOOD_BITS="$built/examples/bits"
links=$((LITTLEWOOD_FUZZ_SECONDS / 6))
begin_beside with_wheel
LITTLEWOOD_FUZZ_SECONDS=$((LITTLEWOOD_FUZZ_SECONDS - links)) stage rust cargo test "${everything[@]}" --no-fail-fast
stage without-features without_features
begin_beside stage studies evidence/studies/test.sh
LITTLEWOOD_FUZZ_SECONDS="$links" stage page web/test.sh
LITTLEWOOD_WHEEL="$(wheel)" stage documentation docs/test.sh
end_beside

echo
echo "Seconds, those beside each other on two cores among them, of $SECONDS:"
cat "$logs/seconds"
echo "Passed:"
cat "$logs"/*.log | awk '
     /^test result: ok/ { rust += $4 }
     /^[0-9]+ passed.* in / { python += $1 }
     /^ +[0-9]+ passed \(/ { page += $1 }
     END { print "  " rust " tests of the crates, " python " of Python, " page " of pages" }'
