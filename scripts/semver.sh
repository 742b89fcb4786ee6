#!/usr/bin/env bash
# Whether the public interfaces of the published crates have changed as their version says, since a revision: the last tag, or the
# one given. Needs cargo-semver-checks.
set -euo pipefail
cd "$(dirname "$0")/.."

since="${1:-$(git describe --tags --abbrev=0 --match 'v*' 2>/dev/null || true)}"
if [ -z "$since" ]; then
  echo "there is no release yet to compare with"
  exit 0
fi
cargo semver-checks --workspace --baseline-rev "$since"
