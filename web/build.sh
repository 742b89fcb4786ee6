#!/usr/bin/env bash
# Builds the laboratory into web/dist: a folder for any static host, and what `littlewood lab` has in it when the program
# is built after this; and, as one file, into the Python package, for notebooks. `web/build.sh wasm` builds the core alone, into web/src/wasm.
#
# Needs node 20 and npm, and Rust for WebAssembly: rustup's target wasm32-unknown-unknown, where it is installed. Where it cannot be installed,
# Debian's compiler (packages rustc-web and rust-web-src) builds its own standard library instead; rustup's rust-lld links.
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "$0")/../scripts/common.sh"

wasm=wasm32-unknown-unknown
debian=/usr/bin/rustc
debian_source=/usr/lib/rustlib/src/rust/library/std
[ -d "$debian_source" ] || debian_source="$("$debian" --print sysroot 2>/dev/null || true)/lib/rustlib/src/rust/library/std"

cargo=(cargo)
if [ -d "$(rustc --print sysroot)/lib/rustlib/$wasm" ]; then
  :
elif [ -x "$debian" ] && [ -d "$debian_source" ]; then
  CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER="$(rustc --print sysroot)/lib/rustlib/$(rustc -vV | sed -n 's/^host: //p')/bin/rust-lld"
  cargo=(env "RUSTC=$debian" RUSTC_BOOTSTRAP=1 cargo -Zbuild-std=std,panic_abort)
  export CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_LINKER
else
  cat >&2 <<'MISSING'
error: no compiler here can build for WebAssembly

hint: rustup target add wasm32-unknown-unknown
      or, on Debian, where that cannot be downloaded: apt-get install rustc-web rust-web-src
MISSING
  exit 2
fi
CARGO_TARGET_DIR="$target/bindgen" cargo build --locked --manifest-path web/bindgen/Cargo.toml
rm -rf web/src/wasm
# What the first picture needs, and what is fetched after it: crates/littlewood-web has both as features.
for part in first later; do
  "${cargo[@]}" build --locked --profile web --target "$wasm" -p littlewood-web --no-default-features --features "$part"
  mkdir -p "web/src/wasm/$part"
  "$target/bindgen/debug/bindgen" "$target/$wasm/web/littlewood_web.wasm" "web/src/wasm/$part"
done
ls -l web/src/wasm/*/*.wasm

if [ "${1:-}" != wasm ]; then
  npm_packages
  (cd web && npm run build)
fi
