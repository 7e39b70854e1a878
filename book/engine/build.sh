#!/bin/sh
# Rebuild workbook/engine/engine.js from src/ and the packages of vendored.toml; needs Node 20 and npm.
set -eu
cd "$(dirname "$0")"
packages=$(mktemp -d)
trap 'rm -rf "$packages"' EXIT
npm install --silent --no-audit --no-fund --no-package-lock --ignore-scripts --prefix "$packages" \
  @bjorn3/browser_wasi_shim@0.4.2 esbuild@0.28.2
bundle() {
  NODE_PATH="$packages/node_modules" "$packages/node_modules/.bin/esbuild" \
    --bundle --minify --format=iife --log-level=warning "$@"
}
sum=$(cat src/* | sha256sum | cut -c 1-64)
bundle src/worker.mjs --outfile="$packages/worker.bundle"
bundle src/engine.mjs --alias:worker.bundle="$packages/worker.bundle" --loader:.bundle=text \
  --loader:.py=text --outfile=../../workbook/engine/engine.js \
  --banner:js="// Built by build.sh from src/ ($sum) and @bjorn3/browser_wasi_shim 0.4.2 (MIT, licenses/)."
