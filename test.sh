#!/usr/bin/env bash
# Tests on a fresh machine that has Rust, Python 3.11 and node 20; on Debian, as root, it installs Chromium.
#
#   ./test.sh                   the product: tests of the crates (the certified motions among them), of the Python package and of the page
#   ./test.sh --all             everything: the thorough tests of each, lints, the documents, and the evidence
#   ./test.sh STAGE ARGUMENT…   one stage; `./test.sh --list` has all of them
#
# At its end it counts, and says what took how long.
set -euo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "$0")/scripts/common.sh"
source scripts/stages.sh

# Backtraces with lines would take half a minute of compiling; the place of a panic is named without.
export CARGO_PROFILE_DEV_DEBUG="${CARGO_PROFILE_DEV_DEBUG:-0}"
# Nothing here is built a second time, so that what a second build would need need not be kept.
export CARGO_INCREMENTAL="${CARGO_INCREMENTAL:-0}"

case "${1:-}" in
  "") ;;
  --all) export LITTLEWOOD_THOROUGH=1 ;;
  --list)
    for number in "${!stages[@]}"; do printf '%-15s %s\n' "${stages[number]}" "${purposes[number]}"; done
    exit
    ;;
  *)
    declare -F "stage_$1" >/dev/null || { echo "error: no stage '$1': there are ${stages[*]}" >&2 && exit 2; }
    "stage_$1" "${@:2}"
    exit
    ;;
esac

logs="$(mktemp -d)"
beside=()
trap 'rm -rf "$logs"; [ "${#beside[@]}" = 0 ] || kill "${beside[@]}" 2>/dev/null' EXIT

# stage NAME: runs it, keeps what it prints, and notes its seconds, and those of processors.
stage() {
  local TIMEFORMAT="  $1: %0R s, %0U + %0S s of processors"
  { time "stage_$1" 2>&1 | tee "$logs/$1.log"; } 2>>"$logs/seconds"
}

# begin_beside STAGE…: runs them, one after the other, beside what follows, and keeps what they print until end_beside.
begin_beside() {
  (for name in "$@"; do stage "$name"; done) >"$logs/beside-${#beside[@]}" 2>&1 &
  beside+=("$!")
}
end_beside() {
  local code=0 number
  for number in "${!beside[@]}"; do
    wait "${beside[number]}" || code=$?
    cat "$logs/beside-$number"
  done
  beside=()
  return "$code"
}

compiled=(build) python_side=(python) others=(rust page)
if [ -n "${LITTLEWOOD_THOROUGH:-}" ]; then
  compiled=(format first-command clippy rustdoc build core) python_side+=(evidence) others+=(documentation instructions)
fi
begin_beside environments
for name in "${compiled[@]}"; do stage "$name"; done
end_beside
stage wheel
export LITTLEWOOD_BUILT=1

begin_beside "${python_side[@]}"
for name in "${others[@]}"; do stage "$name"; done
end_beside

echo
echo "Seconds, those beside each other on two cores among them, of $SECONDS:"
cat "$logs/seconds"
echo "Passed:"
cat "$logs"/*.log | awk '
     /^test result: ok/ { rust += $4 }
     /^[0-9]+ passed.* in / { python += $1 }
     /^ +[0-9]+ passed \(/ { page += $1 }
     END { print "  " rust " tests of the crates, " python " of Python, " page " of pages" }'
