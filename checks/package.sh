#!/usr/bin/env bash
# Every crate as it would be published holds all that it is built from: packed, unpacked in a place without the repository,
# and checked there against each other.
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
cargo package --quiet --workspace --exclude xtask --no-verify --locked --allow-dirty 2>/dev/null
version=$(cargo pkgid --package mckibben-cli | sed 's/.*[#@]//')
for package in "$CARGO_TARGET_DIR"/package/mckibben*-"$version".crate; do
    tar -xzf "$package" -C "$out"
done
{
    printf '[workspace]\nresolver = "3"\nmembers = ["*"]\n[patch.crates-io]\n'
    for folder in "$out"/*/; do
        name=$(basename "$folder")
        printf '%s = { path = "%s" }\n' "${name%-"$version"}" "$name"
    done
} >"$out/Cargo.toml"
cp Cargo.lock "$out"
# Lints are configured in the repository, which is not there.
env -u RUSTC_WORKSPACE_WRAPPER -u RUSTFLAGS cargo check --quiet --manifest-path "$out/Cargo.toml" --workspace --all-features
