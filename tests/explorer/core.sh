#!/bin/sh
# The core of the explorer in node, where node and what makes WebAssembly are there: core.sh BUILD
set -eu
for tool in clang wasm-ld wasm-opt node; do
  command -v $tool >/dev/null 2>&1 || { echo "skipped: there is no $tool (make explorer says what to install)"; exit 0; }
done
[ -f /usr/lib/wasm32-wasi/libc.a ] || { echo "skipped: there is no wasi-libc (make explorer says what to install)"; exit 0; }
"${MAKE:-make}" --no-print-directory B="$1" "$1/core.wasm" >/dev/null
exec node tests/explorer/core.js "$1/core.wasm" "$1/scallop" "$1/explorer-test"
