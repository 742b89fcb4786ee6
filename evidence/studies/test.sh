#!/usr/bin/env bash
# Passes the tests of the studies: their claims on random hoops, and that each page has the numbers that its command computes.
# PYTHON names an interpreter that has the package of this repository and what python/requirements-test.txt lists;
# python/test.sh makes one.
set -euo pipefail
cd "$(dirname "$0")/../.."
work="${CARGO_TARGET_DIR:-target}/python"
python="${PYTHON:-$work/venv/bin/python}"
"$python" -m ruff check --config python/pyproject.toml evidence/studies
"$python" -m ruff format --check --config python/pyproject.toml evidence/studies
"$python" -m mypy --strict --cache-dir "$work/mypy" --config-file python/pyproject.toml evidence/studies/*.py
"$python" -m pytest -q -p no:cacheprovider evidence/studies/tests "$@"
