#!/usr/bin/env bash
# Licences, duplicates and sources of all dependencies (deny.toml), and known vulnerabilities, for which it needs a network:
# `scripts/deny.sh offline` leaves these out. Needs cargo-deny.
set -euo pipefail
cd "$(dirname "$0")/.."

checks=(licenses bans sources)
[ "${1:-}" = offline ] || checks+=(advisories)
cargo deny --workspace --all-features --locked check "${checks[@]}"
cargo deny --manifest-path web/bindgen/Cargo.toml --locked check licenses sources
