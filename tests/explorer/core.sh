#!/bin/sh
# The core of the explorer in node, where node and what makes WebAssembly are there: core.sh BUILD
set -eu
missing=$(sh scripts/dev/setup.sh --missing core.wasm)
[ -z "$missing" ] || { echo "skipped: there is no ${missing% } (make explorer says what to install)"; exit 0; }
"${MAKE:-make}" --no-print-directory B="$1" "$1/core.wasm" >/dev/null
exec node tests/explorer/core.js "$1/core.wasm" "$1/scallop" "$1/explorer-test"
