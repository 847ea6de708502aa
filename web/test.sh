#!/usr/bin/env bash
# The workbench as its users have it: format of the scripts, their types against the schemas, and every page in Chromium.
# web/test.sh [serve|static|all] [core]: behind `mckibben serve` (MCKIBBEN, target/release/mckibben), as web/build.sh makes it (made where it
# is not there), or both. `core` is what changes of any crate can break: the digits of one muscle on every page.
set -euo pipefail
cd "$(dirname "$0")"
export ENGINES=${1:-all}
npm ci --ignore-scripts --no-audit --no-fund --silent
npm run --silent format
npm run --silent types
if [ "$ENGINES" != serve ] && [ ! -e dist/live.wasm ]; then
    ./build.sh
fi
if [ "${2:-}" = core ]; then
    npm run --silent core
else
    npm test --silent
fi
