# The stages of test.sh, for it to source: `./test.sh NAME ARGUMENT…` calls stage_NAME. Each builds what it needs and is not there.
# LITTLEWOOD_THOROUGH=1, which --all sets, adds the thorough tests: more cases, or all that are named, of what the others show.
# shellcheck shell=bash disable=SC2016,SC2154,SC2164 # backquotes in texts; variables of common.sh; `set -e` is that of test.sh

# about NAME PURPOSE: describes the stage that follows, for `./test.sh --list`.
stages=() purposes=()
about() {
  stages+=("$1")
  purposes+=("$2")
}

# The same random cases every time; another seed explores others.
same_cases() { export PROPTEST_RNG_SEED="${PROPTEST_RNG_SEED:-2019}"; }

about environments 'packages of Python and npm, Chromium'
stage_environments() {
  python_environment
  npm_packages
  browser
}

about format 'of the crates; Python and TypeScript are checked by their own stages'
stage_format() {
  cargo fmt --all --check
}

about first-command "the program of the README's first command, which has none of the features"
stage_first-command() {
  cargo build --package littlewood-cli --locked
  cp "$target/debug/littlewood" "$target/debug/littlewood-without-features"
}

about clippy 'lints of the crates'
stage_clippy() {
  cargo clippy "${everything[@]}" --all-targets -- -D warnings
}

about rustdoc 'the reference of the crates'
stage_rustdoc() {
  RUSTDOCFLAGS="-D warnings" cargo doc "${everything[@]}" --no-deps
}

about build 'the crates and their tests'
stage_build() {
  cargo test "${everything[@]}" --no-run
}

about wheel 'the Python package, of what `build` has compiled, installed into the environment of its tests'
stage_wheel() {
  python_environment
  built
}

about rust 'tests of the crates; those of the core compare with the certified motions. Arguments of cargo test'
stage_rust() {
  same_cases
  local thorough=()
  if [ -n "${LITTLEWOOD_THOROUGH:-}" ]; then
    export LITTLEWOOD_WITHOUT_FEATURES="$target/debug/littlewood-without-features"
    [ -x "$LITTLEWOOD_WITHOUT_FEATURES" ] || stage_first-command
    thorough=(-- --include-ignored)
  fi
  cargo test "${everything[@]}" --no-fail-fast "$@" "${thorough[@]}"
}

about python 'lints, types and tests of the package. Arguments of pytest'
stage_python() {
  python_environment
  (
    cd python
    "$python" -m ruff check .
    "$python" -m ruff format --check .
    "$python" -m mypy --strict --cache-dir "$target/mypy" littlewood tests/typed_usage.py
  )
  built
  # What is tested from here on is the wheel: `-P` and the folder keep the sources off the path.
  local chosen=(-m "not thorough")
  [ -z "${LITTLEWOOD_THOROUGH:-}" ] || chosen=()
  cd "$target/python"
  # The stubs leave `__all__` out: their names are compared one by one.
  "$python" -P -m mypy.stubtest --mypy-config-file "$root/python/stubtest.ini" --allowlist <(echo littlewood._core.__all__) littlewood._core
  "$python" -P -m pytest -q -c "$root/python/pyproject.toml" --rootdir "$root/python" "$root/python/tests" "${chosen[@]}" "$@"
  local installed
  installed="$("$python" -P -c 'import littlewood, pathlib; print(pathlib.Path(littlewood.__file__).parent)')"
  "$python" -P -m pytest -q -p no:cacheprovider --doctest-modules "$installed" --ignore "$installed/torch.py"
}

about page 'lints of TypeScript, and the laboratory in Chromium (CHROMIUM names another). Arguments of Playwright'
stage_page() {
  npm_packages
  (cd web && npx biome ci .)
  browser
  built
  web/build.sh
  # What WebAssembly has to agree with, bit for bit.
  "$target/debug/examples/bits" >web/bits.txt
  cd web
  local chosen=(--grep-invert @thorough)
  [ -z "${LITTLEWOOD_THOROUGH:-}" ] || chosen=()
  LITTLEWOOD="$LITTLEWOOD_BIN" npx playwright test "${chosen[@]}" "$@"
}

about documentation 'the tables of DESIGN.md on our own code, and the site: its equations, commands, code, links, and its pages in Chromium. Arguments of pytest'
stage_documentation() {
  npm_packages
  browser
  "$python" scripts/own_code.py --check
  docs/build.sh
  export LITTLEWOOD_SITE="$target/site"
  "$python" -P -m pytest -q -p no:cacheprovider docs/site/tests "$@"
  cd web
  npx playwright test --config site.config.ts
}

about core 'the core as it is without the features of other crates'
stage_core() {
  cargo check --package littlewood --all-targets --locked
}

about evidence 'claims and pages of the studies, three engines against what they must reach, pages of measured numbers. Arguments of pytest'
stage_evidence() {
  built
  local folders=(evidence/engines evidence/reference/tests evidence/studies evidence/truth)
  "$python" -m ruff check --config python/pyproject.toml "${folders[@]}"
  # Scripts, the site and programs that are compared keep to 100 columns, too.
  "$python" -m ruff check --config python/pyproject.toml --select E501 evidence docs scripts crates
  "$python" -m ruff format --check --config python/pyproject.toml evidence docs scripts crates
  "$python" -m mypy --strict --cache-dir "$target/mypy" --config-file python/pyproject.toml evidence/studies/*.py
  "$python" -m pytest -q -p no:cacheprovider evidence "$@"
}

about bits '`native`, `wasm`, `python`: 100,000 motions have the bits of crates/littlewood-digest/digest.txt; `print` writes it anew'
stage_bits() {
  local build digest=crates/littlewood-digest/digest
  for build in "$@"; do
    case "$build" in
      native) cargo run --quiet --release --locked -p littlewood-digest -- check ;;
      wasm) node web/digest.mjs ;;
      python) "${PYTHON:-python3}" scripts/bits.py ;;
      print) cargo run --quiet --release --locked -p littlewood-digest -- print >$digest.new && mv $digest.new $digest.txt ;;
      *) echo "usage: ./test.sh bits native|wasm|python|print …" >&2 && return 2 ;;
    esac
  done
}

about instructions 'of motions, counted by valgrind, are those of evidence/bench/instructions.txt to 2 %; `write` writes it anew'
stage_instructions() {
  # Other processors have other instructions.
  [ "$(uname -sm)" = "Linux x86_64" ] || { echo "instructions are compared on Linux on x86-64" && return; }
  if ! command -v valgrind >/dev/null; then
    apt-get update
    DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends valgrind
  fi
  cargo run --quiet --release --locked -p littlewood-digest --example instructions -- "${1:-check}"
}

about properties 'property tests and fuzzers for longer (PROPTEST_CASES, LITTLEWOOD_FUZZ_SECONDS), with another PROPTEST_RNG_SEED each time, which a failure prints'
stage_properties() {
  export PROPTEST_RNG_SEED="${PROPTEST_RNG_SEED:-$(date +%s)}" PROPTEST_CASES="${PROPTEST_CASES:-4096}"
  echo "PROPTEST_RNG_SEED=$PROPTEST_RNG_SEED"
  cargo test --release --package littlewood --package littlewood-sweep --package littlewood-film --locked --no-fail-fast -- --include-ignored
  LITTLEWOOD_FUZZ_SECONDS="${LITTLEWOOD_FUZZ_SECONDS:-900}" cargo test --release --package littlewood-cli --features full --locked fuzz:: -- --include-ignored --nocapture
}

about coverage 'of the core by its own tests: target/coverage/html, and at least 97 % of its lines. Needs cargo-llvm-cov and llvm-tools'
stage_coverage() {
  same_cases
  # It builds no examples, which a test runs, and what counts is slower than what a test bounds: both are left to the stage `rust`.
  cargo llvm-cov --package littlewood --features serde --locked --no-report -- --skip examples:: --skip bounded::
  cargo llvm-cov report --package littlewood --html --output-dir "$target/coverage"
  cargo llvm-cov report --package littlewood --summary-only --fail-under-lines 97
}

about mutants 'of the core, one in 200, an hour: sample `7`, or `7/1000`, or another each time; target/mutants.out. Needs cargo-mutants'
stage_mutants() {
  same_cases
  local sample="${1:-$((RANDOM % 200))}"
  case "$sample" in */*) ;; *) sample="$sample/200" ;; esac
  mkdir -p "$target"
  cargo mutants --package littlewood --shard "$sample" --sharding round-robin --output "$target" \
    --cap-lints true --test-workspace false --no-shuffle "${@:2}"
}

about msrv 'the core, with the oldest compiler that it promises'
stage_msrv() {
  local version
  version="$(sed -n 's/^rust-version = "\(.*\)"/\1/p' crates/littlewood/Cargo.toml)"
  rustup toolchain install --profile minimal --no-self-update "$version"
  cargo "+$version" check --package littlewood --features serde --locked --target-dir "$target/msrv"
}

about semver 'public interfaces have changed as the version says, since the last tag or the revision given. Needs cargo-semver-checks'
stage_semver() {
  local since="${1:-$(git describe --tags --abbrev=0 --match 'v*' 2>/dev/null || true)}"
  [ -n "$since" ] || { echo "there is no release yet to compare with" && return; }
  cargo semver-checks --workspace --baseline-rev "$since"
}

about deny 'licences, sources, duplicates and, unless `offline`, known vulnerabilities of dependencies (deny.toml). Needs cargo-deny'
stage_deny() {
  local checks=(licenses bans sources)
  [ "${1:-}" = offline ] || checks+=(advisories)
  cargo deny --workspace --all-features --locked check "${checks[@]}"
  cargo deny --manifest-path web/bindgen/Cargo.toml --locked check licenses sources
}

about workflows 'workflows and scripts. Needs actionlint and shellcheck'
stage_workflows() {
  git ls-files -z '*.sh' .ci/run | xargs -0 shellcheck --external-sources
  actionlint
}
