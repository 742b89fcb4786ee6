#!/usr/bin/env bash
# Makes the Python environment of the tests, target/python/venv, unless it is there with what requirements-test.txt lists.
# PYTHON names the interpreter.
set -euo pipefail
cd "$(dirname "$0")"
work="${CARGO_TARGET_DIR:-$PWD/../target}/python"
wanted="$("${PYTHON:-python3}" -VV; cat requirements-test.txt)"
[ "$wanted" != "$(cat "$work/venv/made-of" 2>/dev/null)" ] || exit 0
mkdir -p "$work"
"${PYTHON:-python3}" -m venv --clear "$work/venv"
"$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check -r requirements-test.txt
echo "$wanted" > "$work/venv/made-of"
