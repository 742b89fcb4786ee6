#!/usr/bin/env bash
# Builds the release archive of this machine into target/release-archive: the program, with the laboratory in it where web/build.sh has
# made it, completions, manual pages, licences, and checksums beside it. Its folders are those of a prefix:
#
#   tar -xzf littlewood-….tar.gz --strip-components 1 -C ~/.local
#
# TARGET names another platform than this one.
set -euo pipefail
cd "$(dirname "$0")/.."

host="$(rustc -vV | sed -n 's/^host: //p')"
target="${TARGET:-$host}"
folder="${CARGO_TARGET_DIR:-target}"
version="$(cargo metadata --no-deps --format-version 1 --locked |
  python3 -c 'import json, sys; print(next(p["version"] for p in json.load(sys.stdin)["packages"] if p["name"] == "littlewood-cli"))')"
name="littlewood-$version-$target"
out="$folder/release-archive"
tree="$out/$name"

case "$target" in *windows*) ending=.exe ;; *) ending= ;; esac
cargo build --profile dist --locked --target "$target" --package littlewood-cli --features full
rm -rf "$tree"
mkdir -p "$tree/bin" "$tree/share/doc/littlewood"
cp "$folder/$target/dist/littlewood$ending" "$tree/bin/"
cargo run --quiet --locked --package littlewood-manual -- "$tree"
cp README.md CHANGELOG.md LICENSE-* "$tree/share/doc/littlewood/"
python3 scripts/third_party.py "$target" >"$tree/share/doc/littlewood/THIRD-PARTY"

cd "$out"
case "$target" in
  *windows*)
    archive="$name.zip"
    python3 -m zipfile -c "$archive" "$name"
    ;;
  *)
    archive="$name.tar.gz"
    tar --format=ustar -cf - "$name" | gzip -9n >"$archive"
    ;;
esac
python3 - "$archive" <<'CHECKSUM' >"$archive.sha256"
import hashlib, pathlib, sys
print(hashlib.sha256(pathlib.Path(sys.argv[1]).read_bytes()).hexdigest(), "", sys.argv[1])
CHECKSUM
cat "$archive.sha256"
