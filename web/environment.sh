#!/usr/bin/env bash
# Installs what the tests of the laboratory need and is missing: on Debian, as root, Chromium and a compiler for WebAssembly; the
# packages of npm.
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
./packages.sh
