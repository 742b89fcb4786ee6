#!/usr/bin/env bash
# Builds the source distribution, and from it the wheel that is tested, into target/python/dist, and installs the wheel into the
# environment of the tests.
#
# That the wheel is built from the source distribution proves that this builds: unpacked with the time of now (`-m`), because
# Cargo goes by it, and with the profile and the target folder of the tests, whose libraries it takes. Its workspace has fewer members than
# ours, so that its lock file is ours without what they need: `--locked` would refuse that.
set -euo pipefail
cd "$(dirname "$0")"
target="${CARGO_TARGET_DIR:-$(cd .. && pwd)/target}"
work="$target/python"
./environment.sh
rm -rf "$work/dist" "$work/source"
mkdir "$work/source"
"$work/venv/bin/maturin" sdist --out "$work/dist"
tar -xzmf "$work"/dist/littlewood-*.tar.gz -C "$work/source" --strip-components 1
(cd "$work/source" && CARGO_TARGET_DIR="$target" "$work/venv/bin/maturin" build --profile dev --out "$work/dist")
"$work/venv/bin/python" -m pip install --quiet --disable-pip-version-check --no-deps --force-reinstall "$work"/dist/littlewood-*.whl
