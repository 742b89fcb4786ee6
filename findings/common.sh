# For the scripts beside it to source.
# `packages NAME==VERSION …` installs them in a temporary folder, which goes when the script ends; `python` is its Python.
# shellcheck shell=bash
set -euo pipefail

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

packages() {
  "${PYTHON:-python3}" -m venv "$folder/venv"
  "$folder/venv/bin/python" -m pip install --quiet --disable-pip-version-check "$@"
}

python() {
  "$folder/venv/bin/python" "$@"
}
