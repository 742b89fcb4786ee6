#!/usr/bin/env bash
# Builds the wheel and the source distribution and passes all tests of the package, on a machine that has Rust and Python
# 3.11 or later. PYTHON names the interpreter. The tests compare with the command line: LITTLEWOOD_BIN names it, else it
# is target/debug/littlewood, which is built if it is not there.
set -euo pipefail
cd "$(dirname "$0")"
root="$(cd .. && pwd)"
target="${CARGO_TARGET_DIR:-$root/target}"
work="$target/python"
mkdir -p "$work"

"${PYTHON:-python3}" -m venv --clear "$work/venv"
python="$work/venv/bin/python"
"$python" -m pip install --quiet --disable-pip-version-check -r requirements-test.txt

# The wheel is built from the source distribution, which proves that this builds: unpacked with the time of now (`-m`),
# because Cargo goes by it, and with the profile and the target folder of the tests, whose libraries it takes. Its workspace has
# fewer members than ours, so that its lock file is ours without what they need: `--locked` would refuse that.
rm -rf "$work/dist" "$work/source"
mkdir "$work/source"
"$work/venv/bin/maturin" sdist --out "$work/dist"
tar -xzmf "$work"/dist/littlewood-*.tar.gz -C "$work/source" --strip-components 1
(cd "$work/source" && CARGO_TARGET_DIR="$target" "$work/venv/bin/maturin" build --profile dev --out "$work/dist")
"$python" -m pip install --quiet --disable-pip-version-check --no-deps "$work"/dist/littlewood-*.whl

if [ -z "${LITTLEWOOD_BIN:-}" ]; then
    export LITTLEWOOD_BIN="$target/debug/littlewood"
    [ -x "$LITTLEWOOD_BIN" ] || cargo build --locked -p littlewood-cli --features full
fi

"$work/venv/bin/ruff" check .
"$work/venv/bin/ruff" format --check .
"$work/venv/bin/mypy" --strict --no-incremental littlewood tests/typed_usage.py
# What is tested from here on is the wheel: `-P` and the folder keep the sources off the path.
cd "$work"
"$python" -P -m mypy.stubtest littlewood._core
"$python" -P -m pytest -q -c "$root/python/pyproject.toml" --rootdir "$root/python" "$root/python/tests" "$@"
installed="$("$python" -P -c 'import littlewood, pathlib; print(pathlib.Path(littlewood.__file__).parent)')"
"$python" -P -m pytest -q -p no:cacheprovider --doctest-modules "$installed"
