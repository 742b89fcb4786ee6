#!/usr/bin/env bash
# Builds the site and tests it: the equations of the theory, the commands and the code of the pages, every link, and the pages
# in Chromium. docs/build.sh says what it needs; CHROMIUM names the browser.
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_TARGET_DIR="${CARGO_TARGET_DIR:-$PWD/target}"
docs/build.sh
if [ -z "${LITTLEWOOD_BIN:-}" ]; then
    export LITTLEWOOD_BIN="$CARGO_TARGET_DIR/debug/littlewood"
    [ -x "$LITTLEWOOD_BIN" ] || LITTLEWOOD_BIN="$CARGO_TARGET_DIR/docs/venv/bin/littlewood"
fi
export LITTLEWOOD_SITE="$CARGO_TARGET_DIR/site"
"$CARGO_TARGET_DIR/docs/venv/bin/python" -P -m pytest -q -p no:cacheprovider docs/site/tests "$@"
cd docs/site
npx playwright test
