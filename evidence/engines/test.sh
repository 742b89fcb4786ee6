#!/usr/bin/env bash
# Installs SciPy and pymunk, each into its environment, runs them and the scheme of ours with two steps each, and holds their scores against
# what is expected. PYTHON names an interpreter that has the package of this repository; python/test.sh makes one.
set -euo pipefail
cd "$(dirname "$0")/../.."
python="${PYTHON:-${CARGO_TARGET_DIR:-target}/python/venv/bin/python}"
results="$(mktemp -d)"
trap 'rm -rf "$results"' EXIT
"$python" evidence/engines/run.py scipy moreau pymunk --case figure-3 --case two-coefficients --case lands --case bounces \
    --step 4e-3 --step 1e-3 --out "$results/results.json"
"$python" evidence/engines/expected.py "$results/results.json"
