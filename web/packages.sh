#!/usr/bin/env bash
# Installs what the package-lock.json of a folder lists (of this one, unless another is given), unless it is there.
set -euo pipefail
cd "${1:-$(dirname "$0")}"
installed=node_modules/.installed-from
cmp --silent package-lock.json "$installed" && exit
npm ci --no-fund --no-audit
cp package-lock.json "$installed"
