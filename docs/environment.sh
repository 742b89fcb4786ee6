#!/usr/bin/env bash
# Makes the Python environment of the documentation, target/docs/venv, and the packages of npm that its tests need, unless
# they are there as their lists say. PYTHON names the interpreter.
set -euo pipefail
cd "$(dirname "$0")/site"
work="${CARGO_TARGET_DIR:-$PWD/../../target}/docs"
wanted="$("${PYTHON:-python3}" -VV; cat requirements.txt)"
if [ "$wanted" != "$(cat "$work/venv/made-of" 2>/dev/null)" ]; then
    mkdir -p "$work"
    "${PYTHON:-python3}" -m venv --clear "$work/venv"
    "$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check -r requirements.txt
    echo "$wanted" > "$work/venv/made-of"
fi
../../web/packages.sh "$PWD"
