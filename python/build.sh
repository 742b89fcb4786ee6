#!/usr/bin/env bash
# Packs the wheel that is tested from the libraries of the tests of Rust, into target/python/dist, and installs it into the environment of the
# tests. It has what `python/build.sh release` builds by maturin alone, but for the profile.
#
#   python/build.sh release        the wheel of this machine into python/dist, with the laboratory in it where web/build.sh has made it; on
#                                  Linux, zig links it for old systems (manylinux 2.17). Needs maturin, on Linux "maturin[zig]"
#   python/build.sh release sdist  and the source distribution
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "$0")/../scripts/common.sh"

if [ "${1:-}" = release ]; then
  cd python
  flags=(--release --locked --out dist)
  [ "$(uname -s)" != Linux ] || flags+=(--zig --compatibility manylinux2014)
  [ "$(uname -s)" != Darwin ] || export MACOSX_DEPLOYMENT_TARGET="${MACOSX_DEPLOYMENT_TARGET:-11.0}"
  maturin build "${flags[@]}"
  if [ "${2:-}" = sdist ]; then
    page=../crates/littlewood-cli/page
    trap 'rm -rf "$page"' EXIT
    rm -rf "$page"
    [ ! -d ../web/dist ] || cp -r ../web/dist "$page"
    maturin sdist --out dist
  fi
  exit
fi

python_environment
# With examples, that is with what tests depend on: else some libraries would be built again.
cargo build "${everything[@]}" --lib --bins --examples
work="$target/python"
rm -rf "$work/dist" "$work/package"
mkdir -p "$work/dist" "$work/package"
(cd python && "$target/venv/bin/maturin" pep517 write-dist-info --interpreter "$python" --metadata-directory "$work/package")
cp -R python/littlewood "$work/package/littlewood"
find "$work/package" -name __pycache__ -prune -exec rm -rf {} +
for library in lib_core.so lib_core.dylib; do
  [ ! -f "$target/debug/$library" ] || cp "$target/debug/$library" "$work/package/littlewood/_core.abi3.so"
done
"$python" -m wheel pack --dest-dir "$work/dist" "$work/package"
uv pip install --quiet --python "$python" --no-deps --reinstall "$work"/dist/littlewood-*.whl
