#!/usr/bin/env bash
# Builds the core for the browser into web/src/wasm.
#
# With rustup's target wasm32-unknown-unknown, where it is installed. Where it cannot be installed, Debian's compiler
# (packages rustc-web and rust-web-src) builds its own standard library instead; rustup's rust-lld links.
set -euo pipefail
cd "$(dirname "$0")"

target=wasm32-unknown-unknown
flags=(build --locked --profile web --target "$target" -p littlewood-web --manifest-path ../Cargo.toml)
folder="${CARGO_TARGET_DIR:-$(cd .. && pwd)/target}"

debian=/usr/bin/rustc
debian_source=/usr/lib/rustlib/src/rust/library/std
[ -d "$debian_source" ] || debian_source="$("$debian" --print sysroot 2>/dev/null || true)/lib/rustlib/src/rust/library/std"

if [ -d "$(rustc --print sysroot)/lib/rustlib/$target" ]; then
  cargo "${flags[@]}"
elif [ -x "$debian" ] && [ -d "$debian_source" ]; then
  linker="$(rustc --print sysroot)/lib/rustlib/$(rustc -vV | sed -n 's/^host: //p')/bin/rust-lld"
  CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER="$linker" RUSTC="$debian" RUSTC_BOOTSTRAP=1 \
    cargo -Zbuild-std=std,panic_abort "${flags[@]}"
else
  cat >&2 <<'MISSING'
error: no compiler here can build for WebAssembly

hint: rustup target add wasm32-unknown-unknown
      or, on Debian, where that cannot be downloaded: apt-get install rustc-web rust-web-src
MISSING
  exit 2
fi

CARGO_TARGET_DIR="$folder/bindgen" cargo build --locked --manifest-path bindgen/Cargo.toml
"$folder/bindgen/debug/bindgen" "$folder/$target/web/littlewood_web.wasm" src/wasm
ls -l src/wasm/*.wasm
