#!/usr/bin/env bash
# Builds the laboratory into web/dist: a folder for any static host, and what `littlewood lab` has in it when the program
# is built after this; and, as one file, into the Python package, for notebooks. Needs Rust with WebAssembly (see build-wasm.sh), node 20 and npm.
set -euo pipefail
cd "$(dirname "$0")"

./build-wasm.sh
./packages.sh
npm run build
