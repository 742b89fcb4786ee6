#!/usr/bin/env bash
# Builds the laboratory and tests it in Chromium. On Debian, as root, it installs what is missing.
set -euo pipefail
cd "$(dirname "$0")"

./environment.sh
./build.sh
# What WebAssembly has to agree with, bit for bit.
if [ -n "${LITTLEWOOD_BITS:-}" ]; then
  "$LITTLEWOOD_BITS" > bits.txt
else
  cargo run --quiet --locked --manifest-path ../Cargo.toml -p littlewood-web --example bits > bits.txt
fi
# And the command line, where it has been built.
program="${LITTLEWOOD_BIN:-${CARGO_TARGET_DIR:-../target}/debug/littlewood}"
[ -x "$program" ] && export LITTLEWOOD="$program"
npx playwright test "$@"
