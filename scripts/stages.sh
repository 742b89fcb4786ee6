# The stages of test.sh, for it to source: `./test.sh NAME ARGUMENT…` calls stage_NAME. Each builds what it needs and is not there.
# LITTLEWOOD_THOROUGH=1, which --all sets, adds the thorough tests: more cases, or all that are named, of what the others show.
# shellcheck shell=bash disable=SC2154,SC2164 # variables of common.sh; `set -e` is that of test.sh

# The same random cases every time; another seed explores others.
same_cases() { export PROPTEST_RNG_SEED="${PROPTEST_RNG_SEED:-2019}"; }

stage_environments() { # packages of Python and npm, Chromium
  python_environment
  npm_packages
  browser
}

stage_format() { # of the crates; Python and TypeScript are checked by their own stages
  cargo fmt --all --check
}

stage_first-command() { # the program of the README's first command, which has none of the features
  cargo build --package littlewood-cli --locked
  cp "$target/debug/littlewood" "$target/debug/littlewood-without-features"
}

stage_clippy() { # lints of the crates
  cargo clippy "${everything[@]}" --all-targets -- -D warnings
}

stage_rustdoc() { # the reference of the crates
  RUSTDOCFLAGS="-D warnings" cargo doc "${everything[@]}" --no-deps
}

stage_build() { # the crates and their tests
  cargo test "${everything[@]}" --no-run
}

stage_wheel() { # the Python package, of what `build` has compiled, installed into the environment of its tests
  python_environment
  built
}

stage_rust() { # tests of the crates; those of the core compare with the certified motions. Arguments of cargo test
  same_cases
  local thorough=()
  if [ -n "${LITTLEWOOD_THOROUGH:-}" ]; then
    export LITTLEWOOD_WITHOUT_FEATURES="$target/debug/littlewood-without-features"
    [ -x "$LITTLEWOOD_WITHOUT_FEATURES" ] || stage_first-command
    thorough=(-- --include-ignored)
  fi
  cargo test "${everything[@]}" --no-fail-fast "$@" "${thorough[@]}"
}

stage_python() { # lints, types and tests of the package. Arguments of pytest
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

stage_page() { # lints of TypeScript, and the laboratory in Chromium (CHROMIUM names another). Arguments of Playwright
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

stage_documentation() { # the site: its equations, commands, code, links, and its pages in Chromium. Arguments of pytest
  npm_packages
  browser
  docs/build.sh
  export LITTLEWOOD_SITE="$target/site"
  "$python" -P -m pytest -q -p no:cacheprovider docs/site/tests "$@"
  cd web
  npx playwright test --config site.config.ts
}

stage_core() { # the core as it is without the features of other crates
  cargo check --package littlewood --all-targets --locked
}

stage_evidence() { # claims and pages of the studies, three engines against what they must reach, pages of measured numbers. Arguments of pytest
  built
  local folders=(evidence/engines evidence/reference/tests evidence/studies evidence/truth)
  "$python" -m ruff check --config python/pyproject.toml "${folders[@]}"
  "$python" -m ruff format --check --config python/pyproject.toml "${folders[@]}"
  "$python" -m mypy --strict --cache-dir "$target/mypy" --config-file python/pyproject.toml evidence/studies/*.py
  "$python" -m pytest -q -p no:cacheprovider evidence "$@"
}

stage_bits() { # `native`, `wasm`, `python`: 100,000 motions have the bits of crates/littlewood-digest/digest.txt; `print` writes it anew
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

stage_properties() { # property tests and fuzzers for longer, with another PROPTEST_RNG_SEED each time, which a failure prints
  export PROPTEST_RNG_SEED="${PROPTEST_RNG_SEED:-$(date +%s)}" PROPTEST_CASES="${PROPTEST_CASES:-4096}"
  echo "PROPTEST_RNG_SEED=$PROPTEST_RNG_SEED"
  cargo test --release --package littlewood --package littlewood-sweep --package littlewood-film --locked --no-fail-fast -- --include-ignored
  LITTLEWOOD_FUZZ_SECONDS=900 cargo test --release --package littlewood-cli --features full --locked fuzz:: -- --include-ignored --nocapture
}

stage_coverage() { # of the core by its own tests: target/coverage/html, and at least 97 % of its lines. Needs cargo-llvm-cov and llvm-tools
  same_cases
  cargo llvm-cov --package littlewood --features serde --locked --no-report
  cargo llvm-cov report --package littlewood --html --output-dir "$target/coverage"
  cargo llvm-cov report --package littlewood --summary-only --fail-under-lines 97
}

stage_mutants() { # of the core, one in 200, an hour: sample `7`, or `7/1000`, or another each time; target/mutants.out. Needs cargo-mutants
  same_cases
  local sample="${1:-$((RANDOM % 200))}"
  case "$sample" in */*) ;; *) sample="$sample/200" ;; esac
  mkdir -p "$target"
  cargo mutants --package littlewood --shard "$sample" --sharding round-robin --output "$target" \
    --cap-lints true --test-workspace false --no-shuffle "${@:2}"
}

stage_msrv() { # the core, with the oldest compiler that it promises
  local version
  version="$(sed -n 's/^rust-version = "\(.*\)"/\1/p' crates/littlewood/Cargo.toml)"
  rustup toolchain install --profile minimal --no-self-update "$version"
  cargo "+$version" check --package littlewood --features serde --locked --target-dir "$target/msrv"
}

stage_semver() { # public interfaces have changed as the version says, since the last tag or the revision given. Needs cargo-semver-checks
  local since="${1:-$(git describe --tags --abbrev=0 --match 'v*' 2>/dev/null || true)}"
  [ -n "$since" ] || { echo "there is no release yet to compare with" && return; }
  cargo semver-checks --workspace --baseline-rev "$since"
}

stage_deny() { # licences, sources, duplicates and, unless `offline`, known vulnerabilities of dependencies (deny.toml). Needs cargo-deny
  local checks=(licenses bans sources)
  [ "${1:-}" = offline ] || checks+=(advisories)
  cargo deny --workspace --all-features --locked check "${checks[@]}"
  cargo deny --manifest-path web/bindgen/Cargo.toml --locked check licenses sources
}

stage_workflows() { # workflows and scripts. Needs actionlint and shellcheck
  git ls-files -z '*.sh' .ci/run | xargs -0 shellcheck --external-sources
  actionlint
}

stage_captions() { # LaTeX sets the captions of all figures, of named and of unusual hoops. Needs pdflatex (on Debian texlive-latex-base)
  built
  scripts/captions.sh "$LITTLEWOOD_BIN"
}
