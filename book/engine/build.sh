#!/bin/sh
# Rebuild engine.js from src/ and the two packages below, from the npm registry; needs Node 20.
# Afterwards write the new sum of engine.js into vendored.toml.
set -eu
cd "$(dirname "$0")"
packages=$(mktemp -d)
trap 'rm -rf "$packages"' EXIT
npm install --silent --no-audit --no-fund --no-package-lock --ignore-scripts --prefix "$packages" \
  @bjorn3/browser_wasi_shim@0.4.2 esbuild@0.28.2
bundle() { NODE_PATH="$packages/node_modules" "$packages/node_modules/.bin/esbuild" --bundle --format=iife --log-level=warning "$@"; }
bundle --minify src/worker.mjs --outfile="$packages/worker.bundle"
bundle --minify src/engine.mjs --alias:worker.bundle="$packages/worker.bundle" --loader:.bundle=text --loader:.py=text \
  --outfile=engine.js
