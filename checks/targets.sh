#!/usr/bin/env bash
# The program is checked for other systems, where rustup has their standard library. Nothing is linked, so that no C compiler of
# those systems is needed.
set -euo pipefail
cd "$(dirname "$0")/.."

for target in x86_64-pc-windows-gnu aarch64-unknown-linux-gnu; do
    if ! rustup target add "$target" >/dev/null 2>&1; then
        echo "$target: no standard library here"
        continue
    fi
    name=${target//-/_}
    env "CC_$name=true" "AR_$name=true" RUSTFLAGS="-D warnings" \
        cargo check --quiet --locked --package mckibben-cli --target "$target" --target-dir "${CARGO_TARGET_DIR:-target}/other"
    echo "$target: checked"
done
