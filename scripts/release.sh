#!/usr/bin/env bash
# What a release consists of:
#
#   scripts/release.sh notes v0.1.0            what CHANGELOG.md says of a version; an error if it says nothing, or if the crates have another
#   scripts/release.sh archive                 the archive of this machine (or of the platform that TARGET names), into target/release-archive
#   scripts/release.sh pythons PYTHON…         tries the wheel in python/dist on each Python, without names on all that are there
#   scripts/release.sh package                 packages the crates and the Python package, and builds each from its package alone;
#                                              `--no-verify` only packages, `publish` publishes the crates
#
# The wheel is made by `python/build.sh release`.
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "$0")/common.sh"

# The page of the laboratory is in packages where web/build.sh has made it.
with_page() {
  page=crates/littlewood-cli/page
  trap 'rm -rf "$page"' EXIT
  rm -rf "$page"
  [ ! -d web/dist ] || cp -r web/dist "$page"
}

packages() { cargo metadata --no-deps --format-version 1 --locked; }

release_notes() {
  local version="${1#v}" notes
  grep -q "^version = \"$version\"\$" Cargo.toml || { echo "error: the version in Cargo.toml is not $version" >&2; exit 1; }
  notes="$(awk -v heading="## $version" 'index($0, "## ") == 1 { on = index($0 " ", heading " ") == 1; next } on' CHANGELOG.md)"
  [ -n "$notes" ] || { echo "error: CHANGELOG.md has nothing on $version" >&2; exit 1; }
  printf '%s\n' "$notes"
}

# The program, with the laboratory in it where web/build.sh has made it, completions, manual pages, licences, and a checksum beside them. Folders
# are those of a prefix:
#
#   tar -xzf littlewood-….tar.gz --strip-components 1 -C ~/.local
release_archive() {
  local platform version name out tree ending archive
  platform="${TARGET:-$(rustc -vV | sed -n 's/^host: //p')}"
  version="$(packages |
    python3 -c 'import json, sys; print(next(p["version"] for p in json.load(sys.stdin)["packages"] if p["name"] == "littlewood-cli"))')"
  name="littlewood-$version-$platform"
  out="$target/release-archive"
  tree="$out/$name"
  case "$platform" in *windows*) ending=.exe ;; *) ending= ;; esac
  cargo build --profile dist --locked --target "$platform" --package littlewood-cli --features full
  rm -rf "$tree"
  mkdir -p "$tree/bin" "$tree/share/doc/littlewood"
  cp "$target/$platform/dist/littlewood$ending" "$tree/bin/"
  cargo run --quiet --locked --package littlewood-cli --features full --example manual -- "$tree"
  cp README.md CHANGELOG.md LICENSE-* "$tree/share/doc/littlewood/"
  python3 scripts/third_party.py "$platform" >"$tree/share/doc/littlewood/THIRD-PARTY"

  cd "$out"
  case "$platform" in
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
}

# The wheel with NumPy and nothing else: what everyone does first, the package, and the program that comes with it.
release_pythons() {
  local pythons=("$@") version interpreter installed work wheel=("$root"/python/dist/littlewood-*.whl)
  [ -e "${wheel[0]}" ] || { echo "error: there is no wheel in python/dist: python/build.sh release makes it" >&2; exit 1; }
  if [ "$#" = 0 ]; then
    for version in 3.10 3.11 3.12 3.13 3.14; do
      if "python$version" -c "" 2>/dev/null; then pythons+=("python$version"); else echo "python$version is not here"; fi
    done
  fi
  work="$(mktemp -d)"
  # shellcheck disable=SC2064 # the folder of now
  trap "rm -rf '$work'" EXIT
  for interpreter in "${pythons[@]}"; do
    rm -rf "$work/venv"
    "$interpreter" -m venv "$work/venv"
    installed="$work/venv/bin"
    [ -d "$installed" ] || installed="$work/venv/Scripts"
    "$installed/python" -m pip install --quiet --disable-pip-version-check --only-binary :all: "${wheel[@]}"
    (cd "$work" && "$installed/python" "$root/scripts/installed.py")
  done
}

# As `cargo publish` would, and the Python package from its source distribution. Tests, examples and benchmarks that need files of the repository
# stay out of packages, and cargo says so; any other warning is an error.
release_package() {
  local log flags=(--dry-run "$@") package files needed
  log="$(mktemp)"
  python3 scripts/metadata.py
  with_page
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
  for package in $(packages |
    python3 -c 'import json, sys; print(*(p["name"] for p in json.load(sys.stdin)["packages"] if p["publish"] is None))'); do
    files="$(cargo package --list --allow-dirty --locked --package "$package")"
    for needed in README.md LICENSE-MIT LICENSE-APACHE; do
      grep -qx "$needed" <<<"$files" || { echo "error: $package has no $needed" >&2; exit 1; }
    done
  done

  # The workspace of the source distribution has fewer members than ours, so that its lock file is ours without what they need: `--locked`
  # would refuse that. Unpacked with the time of now (`-m`), because Cargo goes by it.
  local source="$target/python/source" maturin="$target/venv/bin/maturin"
  python_environment
  rm -rf "$source" "$target/python/sdist"
  mkdir -p "$source"
  (cd python && "$maturin" sdist --out "$target/python/sdist")
  tar -xzmf "$target"/python/sdist/littlewood-*.tar.gz -C "$source" --strip-components 1
  if [ "${1:-}" != --no-verify ]; then
    (cd "$source" && CARGO_TARGET_DIR="$target" "$maturin" build --profile dev --out "$target/python/sdist")
  fi
}

case "${1:-}" in
  notes | archive | pythons | package) "release_$1" "${@:2}" ;;
  *) echo "usage: scripts/release.sh notes|archive|pythons|package …" >&2 && exit 2 ;;
esac
