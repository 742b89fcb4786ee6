#!/usr/bin/env bash
# Checks workflows and shell scripts. Needs actionlint and shellcheck.
set -euo pipefail
cd "$(dirname "$0")/.."

mapfile -t scripts < <(git ls-files '*.sh' .ci/run)
shellcheck "${scripts[@]}"
actionlint
