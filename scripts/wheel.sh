#!/usr/bin/env bash
# Builds the wheel of this machine into python/dist, with the laboratory in it where web/build.sh has made it. On Linux, zig links it
# for old systems (manylinux 2.17). `scripts/wheel.sh sdist` makes the source distribution too. Needs maturin (on Linux,
# "maturin[zig]").
set -euo pipefail
cd "$(dirname "$0")/../python"

flags=(--release --locked --out dist)
[ "$(uname -s)" != Linux ] || flags+=(--zig --compatibility manylinux2014)
[ "$(uname -s)" != Darwin ] || export MACOSX_DEPLOYMENT_TARGET="${MACOSX_DEPLOYMENT_TARGET:-11.0}"
maturin build "${flags[@]}"
if [ "${1:-}" = sdist ]; then
  page=../crates/littlewood-cli/page
  trap 'rm -rf "$page"' EXIT
  rm -rf "$page"
  [ ! -d ../web/dist ] || cp -r ../web/dist "$page"
  maturin sdist --out dist
fi
