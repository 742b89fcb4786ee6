#!/usr/bin/env bash
# Builds the laboratory and tests it in Chromium. On Debian, as root, it installs what is missing.
set -euo pipefail
cd "$(dirname "$0")"

missing=()
[ -x "${CHROMIUM:-/usr/bin/chromium}" ] || missing+=(chromium fonts-dejavu-core)
if [ ! -d "$(rustc --print sysroot)/lib/rustlib/wasm32-unknown-unknown" ]; then
  # The standard library for WebAssembly, or the sources that it can be built from.
  timeout 30 rustup target add wasm32-unknown-unknown >/dev/null 2>&1 ||
    { [ -x /usr/bin/rustc ] && [ -d /usr/lib/rustlib/src/rust/library/std ]; } || missing+=(rustc-web rust-web-src)
fi
if [ "${#missing[@]}" -gt 0 ]; then
  apt-get update
  DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
fi

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
