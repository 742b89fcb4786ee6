#!/usr/bin/env bash
# Packages every crate that is published, and builds each from its package alone, as `cargo publish` would; and the Python package, from its
# source distribution. Nothing is uploaded. `scripts/package.sh --no-verify` only packages, `scripts/package.sh publish` publishes. The page of the laboratory is in the package of
# the command line where web/build.sh has made it. Tests, examples and benchmarks that need files of the repository stay out of
# packages, and cargo says so; any other warning is an error.
set -euo pipefail
cd "$(dirname "$0")/.."

python3 scripts/metadata.py
log="$(mktemp)"
page=crates/littlewood-cli/page
trap 'rm -rf "$log" "$page"' EXIT
rm -rf "$page"
[ ! -d web/dist ] || cp -r web/dist "$page"

flags=(--dry-run "$@")
if [ "${1:-}" = publish ]; then
  [ -z "$(git status --porcelain)" ] || { echo "error: there are changes that are not committed" >&2; exit 1; }
  flags=("${@:2}")
fi
# The page is no part of the repository, which cargo would complain of.
cargo publish --workspace --locked --allow-dirty "${flags[@]}" 2>&1 | tee "$log"
if grep '^warning' "$log" | grep -vE 'ignoring (test|example|benchmark) .* not included|aborting upload due to dry run'; then
  echo "error: packaging has warnings" >&2
  exit 1
fi

for package in $(cargo metadata --no-deps --format-version 1 --locked |
  python3 -c 'import json, sys; print(*(p["name"] for p in json.load(sys.stdin)["packages"] if p["publish"] is None))'); do
  files="$(cargo package --list --allow-dirty --locked --package "$package")"
  for needed in README.md LICENSE-MIT LICENSE-APACHE; do
    grep -qx "$needed" <<<"$files" || { echo "error: $package has no $needed" >&2; exit 1; }
  done
done

# The workspace of the source distribution has fewer members than ours, so that its lock file is ours without what they need: `--locked`
# would refuse that. Unpacked with the time of now (`-m`), because Cargo goes by it.
target="${CARGO_TARGET_DIR:-$PWD/target}"
source="$target/python/source"
python/environment.sh
maturin="$target/python/venv/bin/maturin"
rm -rf "$source" "$target/python/sdist"
mkdir "$source"
(cd python && "$maturin" sdist --out "$target/python/sdist")
tar -xzmf "$target"/python/sdist/littlewood-*.tar.gz -C "$source" --strip-components 1
if [ "${1:-}" != --no-verify ]; then
  (cd "$source" && CARGO_TARGET_DIR="$target" "$maturin" build --profile dev --out "$target/python/sdist")
fi
