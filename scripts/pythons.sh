#!/usr/bin/env bash
# Installs the wheel in python/dist on each Python given (all from python3.10 to python3.14 that are there), with NumPy and nothing
# else, and tries what everyone does first: the package, and the program that comes with it.
set -euo pipefail
cd "$(dirname "$0")/.."
root="$PWD"

pythons=("$@")
if [ "${#pythons[@]}" = 0 ]; then
  for version in 3.10 3.11 3.12 3.13 3.14; do
    if "python$version" -c "" 2>/dev/null; then pythons+=("python$version"); else echo "python$version is not here"; fi
  done
fi
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
for python in "${pythons[@]}"; do
  rm -rf "$work/venv"
  "$python" -m venv "$work/venv"
  installed="$work/venv/bin"
  [ -d "$installed" ] || installed="$work/venv/Scripts"
  "$installed/python" -m pip install --quiet --disable-pip-version-check --only-binary :all: "$root"/python/dist/littlewood-*.whl
  (cd "$work" && "$installed/python" "$root/scripts/installed.py")
done
