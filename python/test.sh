#!/usr/bin/env bash
# Builds the wheel, unless LITTLEWOOD_WHEEL names the one that build.sh has built, and passes all tests of the package, on a machine
# that has Rust and Python 3.11 or later. PYTHON names the interpreter. The tests compare with the command line: LITTLEWOOD_BIN
# names it, else it is target/debug/littlewood, which is built if it is not there.
set -euo pipefail
cd "$(dirname "$0")"
root="$(cd .. && pwd)"
target="${CARGO_TARGET_DIR:-$root/target}"
work="$target/python"

./environment.sh
python="$work/venv/bin/python"

"$work/venv/bin/ruff" check .
"$work/venv/bin/ruff" format --check .
"$work/venv/bin/mypy" --strict --cache-dir "$work/mypy" littlewood tests/typed_usage.py

[ -n "${LITTLEWOOD_WHEEL:-}" ] || ./build.sh

if [ -z "${LITTLEWOOD_BIN:-}" ]; then
    export LITTLEWOOD_BIN="$target/debug/littlewood"
    [ -x "$LITTLEWOOD_BIN" ] || cargo build --locked -p littlewood-cli --features full
fi

# What is tested from here on is the wheel: `-P` and the folder keep the sources off the path.
cd "$work"
"$python" -P -m mypy.stubtest --mypy-config-file "$root/python/stubtest.ini" littlewood._core
"$python" -P -m pytest -q -c "$root/python/pyproject.toml" --rootdir "$root/python" "$root/python/tests" "$@"
installed="$("$python" -P -c 'import littlewood, pathlib; print(pathlib.Path(littlewood.__file__).parent)')"
"$python" -P -m pytest -q -p no:cacheprovider --doctest-modules "$installed"
