#!/usr/bin/env bash
# Builds the documentation as a site, target/site: a folder for any static host. Warnings are errors.
#
# Needs Rust (with WebAssembly, for the laboratory), Python 3.11 or later (PYTHON names it) and node 20.
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "$0")/../scripts/common.sh"
export RUSTDOCFLAGS="${RUSTDOCFLAGS:--D warnings}"

# The page comes first, because the wheel has it.
[ -f web/dist/index.html ] || web/build.sh
npm_packages
built
cargo doc "${everything[@]}" --no-deps

rm -rf "$target/site"
# `-P` keeps the sources of the package off the path: what is documented is what is installed.
"$python" -P -m sphinx --builder html --fail-on-warning --keep-going --fresh-env --quiet \
  --conf-dir docs/site --doctree-dir "$target/docs/doctrees" . "$target/site"
rm -f "$target/site/.buildinfo"
cp -r "$target/doc" "$target/site/rust"
rm -f "$target/site/rust/.lock"
echo "$target/site/index.html"
