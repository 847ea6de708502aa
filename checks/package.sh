#!/usr/bin/env bash
# Every crate as it would be published holds all that it is built from, its terms and what it is: packed, unpacked in a place
# without the repository, and checked there against each other. Another crate there has the programs of crates/mckibben/examples
# and runs them.
set -euo pipefail
cd "$(dirname "$0")/.."
export CARGO_TARGET_DIR=${CARGO_TARGET_DIR:-$PWD/target}

out=$(mktemp -d)
trap 'rm -rf "$out"' EXIT
cargo package --quiet --workspace --exclude xtask --exclude mckibben-python --exclude mckibben-wasm --no-verify --locked --allow-dirty 2>/dev/null
version=$(cargo pkgid --package mckibben-cli | sed 's/.*[#@]//')
for package in "$CARGO_TARGET_DIR"/package/mckibben*-"$version".crate; do
    tar -xzf "$package" -C "$out"
    for file in README.md LICENSE-MIT LICENSE-APACHE NOTICE; do
        test -s "$out/$(basename "$package" .crate)/$file" || { echo "$package: no $file"; exit 1; }
    done
done
mkdir -p "$out/other/jobs/src" "$out/examples"
touch "$out/other/jobs/src/lib.rs"
cp -r crates/mckibben/examples "$out/other/jobs"
cp examples/bench.toml "$out/examples"
{
    printf '[package]\nname = "jobs"\nedition = "2024"\n[dependencies]\n'
    printf 'mckibben = { version = "%s", features = ["export"] }\n' "$version"
} >"$out/other/jobs/Cargo.toml"
{
    printf '[workspace]\nresolver = "3"\nmembers = ["mckibben*", "other/jobs"]\n[patch.crates-io]\n'
    for folder in "$out"/mckibben*/; do
        name=$(basename "$folder")
        printf '%s = { path = "%s" }\n' "${name%-"$version"}" "$name"
    done
} >"$out/Cargo.toml"
cp Cargo.lock "$out"
# Lints are configured in the repository, which is not there.
env -u RUSTC_WORKSPACE_WRAPPER -u RUSTFLAGS cargo check --quiet --manifest-path "$out/Cargo.toml" --workspace --all-features
for program in "$out"/other/jobs/examples/*.rs; do
    name=$(basename "$program" .rs)
    env -u RUSTC_WORKSPACE_WRAPPER -u RUSTFLAGS cargo run --quiet --manifest-path "$out/Cargo.toml" --package jobs --example "$name" >/dev/null
done
