#!/usr/bin/env bash
# Builds the documentation as a site, target/site: a folder for any static host. Warnings are errors.
#
# Needs Rust, Python 3.11 or later (PYTHON names it) and node 20; for the laboratory Rust with WebAssembly. What has been
# built is taken: the page (web/dist), the wheel (LITTLEWOOD_WHEEL, or target/python/dist unless the Python sources are
# newer), and the command line (LITTLEWOOD_BIN, or target/debug/littlewood, or that of the wheel).
set -euo pipefail
cd "$(dirname "$0")/.."
root="$PWD"
target="${CARGO_TARGET_DIR:-$root/target}"
work="$target/docs"
mkdir -p "$work"
export RUSTDOCFLAGS="${RUSTDOCFLAGS:--D warnings}"

docs/environment.sh
python="$work/venv/bin/python"

# The page comes first, because the wheel has it.
[ -f web/dist/index.html ] || web/build.sh

wheel="${LITTLEWOOD_WHEEL:-}"
if [ -z "$wheel" ]; then
    wheel="$(find "$target/python/dist" -name '*.whl' 2>/dev/null | head -1)"
    if [ -z "$wheel" ] || [ -n "$(find python/littlewood -name '*.py*' -newer "$wheel" -not -path '*__pycache__*')" ]; then
        "$python" -m pip install --quiet --disable-pip-version-check "maturin>=1.9,<2"
        rm -rf "$target/python/dist"
        (cd python && "$work/venv/bin/maturin" build --release --locked --out "$target/python/dist")
        wheel="$(find "$target/python/dist" -name '*.whl')"
    fi
fi
"$python" -m pip install --quiet --disable-pip-version-check --no-deps --force-reinstall "$wheel"

# The wheel has the command line, too.
if [ -z "${LITTLEWOOD_BIN:-}" ]; then
    export LITTLEWOOD_BIN="$target/debug/littlewood"
    [ -x "$LITTLEWOOD_BIN" ] || LITTLEWOOD_BIN="$work/venv/bin/littlewood"
fi

# As ./test.sh does, which has built them.
cargo doc --workspace --all-features --locked --no-deps

rm -rf "$target/site"
# `-P` keeps the sources of the package off the path: what is documented is what is installed.
"$python" -P -m sphinx --builder html --fail-on-warning --keep-going --fresh-env --quiet \
    --conf-dir docs/site --doctree-dir "$work/doctrees" . "$target/site"
rm -f "$target/site/.buildinfo"
cp -r "$target/doc" "$target/site/rust"
rm -f "$target/site/rust/.lock"
echo "$target/site/index.html"
