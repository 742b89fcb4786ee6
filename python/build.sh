#!/usr/bin/env bash
# Packs the wheel that is tested from the libraries of the tests of Rust, into target/python/dist, and installs it into the environment of the
# tests. It has what scripts/wheel.sh and scripts/package.sh build by maturin alone, but for the profile.
set -euo pipefail
cd "$(dirname "$0")"
target="${CARGO_TARGET_DIR:-$(cd .. && pwd)/target}"
work="$target/python"
./environment.sh
python="$work/venv/bin/python"
# With examples, that is with what tests depend on: else some libraries would be built again.
cargo build --workspace --all-features --locked --lib --examples
rm -rf "$work/dist" "$work/package"
mkdir -p "$work/dist" "$work/package"
"$work/venv/bin/maturin" pep517 write-dist-info --interpreter "$python" --metadata-directory "$work/package"
cp -R littlewood "$work/package/littlewood"
find "$work/package" -name __pycache__ -prune -exec rm -rf {} +
for library in lib_core.so lib_core.dylib; do
  [ ! -f "$target/debug/$library" ] || cp "$target/debug/$library" "$work/package/littlewood/_core.abi3.so"
done
"$python" -m wheel pack --dest-dir "$work/dist" "$work/package"
"$python" -m pip install --quiet --disable-pip-version-check --no-deps --force-reinstall "$work"/dist/littlewood-*.whl
