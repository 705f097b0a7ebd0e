#!/bin/sh
# The page of the explorer, one file: explorer.sh BUILD. What npm brings stays in BUILD; explorer/package-lock.json says which versions.
set -eu
sources=$1/explorer/sources
mkdir -p "$sources"
cp explorer/*.js explorer/*.css explorer/*.html "$sources"
if ! cmp -s explorer/package-lock.json "$sources/node_modules/.of-lock.json"; then
  cp explorer/package.json explorer/package-lock.json "$sources"
  (cd "$sources" && npm ci --ignore-scripts --no-audit --no-fund --loglevel=error >&2)
  cp explorer/package-lock.json "$sources/node_modules/.of-lock.json"
fi
core=$(cd "$1" && pwd)/core.wasm
node "$sources/build.js" "$core" "$1/explorer/index.html"
