#!/usr/bin/env bash
# Prints what CHANGELOG.md says of a version: `scripts/notes.sh v0.1.0`. An error if it says nothing, or if the crates have another
# version.
set -euo pipefail
cd "$(dirname "$0")/.."

version="${1#v}"
grep -q "^version = \"$version\"\$" Cargo.toml || { echo "error: the version in Cargo.toml is not $version" >&2; exit 1; }
notes="$(awk -v heading="## $version" 'index($0, "## ") == 1 { on = index($0 " ", heading " ") == 1; next } on' CHANGELOG.md)"
[ -n "$notes" ] || { echo "error: CHANGELOG.md has nothing on $version" >&2; exit 1; }
printf '%s\n' "$notes"
