#!/usr/bin/env bash
# Compares the bits of 100,000 motions with those of crates/littlewood-digest/digest.txt.
#
#   scripts/bits.sh native   a release build
#   scripts/bits.sh wasm     the core of the page, in node; after web/build-wasm.sh
#   scripts/bits.sh python   the Python package that PYTHON (python3) imports
#   scripts/bits.sh print    writes the file anew, where results are meant to change
set -euo pipefail
cd "$(dirname "$0")/.."

for build in "$@"; do
  case "$build" in
    native) cargo run --quiet --release --locked -p littlewood-digest -- check ;;
    wasm) node web/digest.mjs ;;
    python) "${PYTHON:-python3}" scripts/bits.py ;;
    print)
      cargo run --quiet --release --locked -p littlewood-digest -- print >crates/littlewood-digest/digest.new
      mv crates/littlewood-digest/digest.new crates/littlewood-digest/digest.txt
      ;;
    *)
      echo "usage: scripts/bits.sh native|wasm|python|print …" >&2
      exit 2
      ;;
  esac
done
