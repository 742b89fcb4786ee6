#!/usr/bin/env bash
# Packages every crate that is published, and builds each from its package alone, as `cargo publish` would; nothing is uploaded.
# `scripts/package.sh --no-verify` only packages. Tests, examples and benchmarks that need files of the repository stay out of
# packages, and cargo says so; any other warning is an error.
set -euo pipefail
cd "$(dirname "$0")/.."

python3 scripts/metadata.py
log="$(mktemp)"
trap 'rm -f "$log"' EXIT

cargo publish --workspace --dry-run --locked "$@" 2>&1 | tee "$log"
if grep '^warning' "$log" | grep -vE 'ignoring (test|example|benchmark) .* not included|aborting upload due to dry run'; then
  echo "error: packaging has warnings" >&2
  exit 1
fi

for package in $(cargo metadata --no-deps --format-version 1 --locked |
  python3 -c 'import json, sys; print(*(p["name"] + "-" + p["version"] for p in json.load(sys.stdin)["packages"] if p["publish"] is None))'); do
  files="$(tar -tvzf "${CARGO_TARGET_DIR:-target}/package/$package.crate")"
  for needed in README.md LICENSE-MIT LICENSE-APACHE; do
    grep -q " $package/$needed\$" <<<"$files" || { echo "error: $package has no $needed" >&2; exit 1; }
  done
  if grep '^l' <<<"$files"; then
    echo "error: $package has links" >&2
    exit 1
  fi
done
