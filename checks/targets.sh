#!/usr/bin/env bash
# The program is checked for Windows on ARM, which is neither Unix nor x86-64, where rustup has its standard library. Nothing is
# linked.
set -euo pipefail
cd "$(dirname "$0")/.."

target=aarch64-pc-windows-gnullvm
if ! rustup target add "$target" >/dev/null 2>&1; then
    echo "$target: no standard library here, not checked"
    exit 0
fi
RUSTFLAGS="-D warnings" \
    cargo check --quiet --locked --package mckibben-cli --target "$target" --target-dir "${CARGO_TARGET_DIR:-target}/other"
echo "$target: checked"
